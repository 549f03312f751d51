// How much the blocks of an adaptive mesh want to be split.
#ifndef CLERS_CODEC_CLI_CRITERIA_H
#define CLERS_CODEC_CLI_CRITERIA_H

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include "codec/cli/adapt.h"
#include "codec/cli/shape.h"
#include "topology/modeling/adaptive_mesh.h"

namespace clers::cli {

/// The sampling function of an adaptive mesh.
struct Projection {
  const Shape* shape;
  Sample operator()(const Sample& a, const Sample& b, bool boundary) const {
    return shape->between(a, b, boundary);
  }
};
using Followed = AdaptiveMesh<Sample, Projection>;

/// What is asked for, in numbers; infinity: not asked.
struct Wanted {
  double error = std::numeric_limits<double>::infinity();
  double edge_length = std::numeric_limits<double>::infinity();
  unsigned level = 0;
  std::span<const Brush> near;  ///< where that level is; empty: everywhere
};

/// The priority by which a mesh is adapted, and its observer. A priority above 1 asks for a split;
/// each split about halves it, whichever criterion it comes from, so that of several the one that
/// is farthest from its aim goes first.
///
/// Keeps for every half-edge how far the shape is from the middle of its edge: all edges of a block
/// count, since a side can only be split after the block is. Where a split would put no vertex on
/// the shape, errors ask for none.
class Criteria {
 public:
  explicit Criteria(const Followed& mesh) : mesh_(mesh) {
    off_.resize(surface().half_edge_limit());
    for (const HalfEdge h : surface().edges()) measure(h);
  }

  void set(const Wanted& wanted) { wanted_ = wanted; }

  /// How far the shape is from the middle of the edge; negative if a split does not help.
  double off(HalfEdge h) const { return off_[h.index()]; }

  /// Of a split edge.
  double priority(HalfEdge h) const {
    Block block;
    block.level = mesh_.level(h);
    for (const HalfEdge side : surface().star(h)) {
      if (corner(side) != 1) continue;  // the face there is coarser: h is not its split edge yet
      const Face f = left(side);
      for (const HalfEdge of_f : surface().star(f)) {
        block.error = std::max(block.error, off(of_f));
        block.add_edge(place(surface().org(of_f)), place(surface().dest(of_f)));
      }
      block.faces[block.count++] = {place(surface().org(half_edge(f, 0))),
                                    place(surface().org(half_edge(f, 1))),
                                    place(surface().org(half_edge(f, 2)))};
    }
    return priority(block);
  }
  /// Of the block that the weld of a vertex would bring back.
  double priority(Vertex v) const {
    Block block;
    block.level = mesh_.level(v) - 1;
    std::array<Vec3, 4> around;  // a, d, b, c as of Surface::split; on the boundary a, c, b
    std::size_t count = 0;
    for (const Vertex u : surface().adjacent_vertices(v)) around[count++] = place(u);
    const Vec3 &a = around[0], &b = around[2];
    for (const HalfEdge h : surface().fan(v)) block.error = std::max(block.error, off(lnext(h)));
    block.error = std::max(block.error, off_of(mesh_[v]));
    block.add_edge(a, b);
    for (std::size_t i = 1; i < count; i += 2) {
      block.add_edge(a, around[i]);
      block.add_edge(around[i], b);
      block.faces[block.count++] = {a, around[i], b};
    }
    return priority(block);
  }

  void operator()(const Refined& refined) {
    off_.resize(std::max<std::size_t>(off_.size(), surface().half_edge_limit()));
    for (const HalfEdge h : surface().star(refined.made)) measure(h);
    const auto changed = [&](Face f) { return mesh_.mesh().weld_vertex(f) == refined.made; };
    for (const HalfEdge h : surface().fan(refined.made)) take_over(lnext(h), changed);
  }
  void operator()(const Simplified& simplified) {
    const HalfEdge edge = simplified.edge;
    const auto changed = [&](Face f) {
      return f == left(edge) || (surface().sym(edge) && f == left(surface().sym(edge)));
    };
    for (const HalfEdge side : surface().star(edge)) {
      take_over(lnext(side), changed);
      take_over(lprev(side), changed);
    }
    set_off(edge, off_of(mesh_[simplified.gone]));
  }

 private:
  struct Block {
    unsigned level = 0;
    double error = 0, longest2 = 0;
    std::array<Triangle, 2> faces{};
    std::size_t count = 0;

    void add_edge(const Vec3& a, const Vec3& b) { longest2 = std::max(longest2, squared(b - a)); }
  };

  const Surface& surface() const { return mesh_.surface(); }
  const Vec3& place(Vertex v) const { return mesh_[v].at; }

  double priority(const Block& block) const {
    double most = block.error / wanted_.error;
    most = std::max(most, block.longest2 / (wanted_.edge_length * wanted_.edge_length));
    // Half a level below the aim or above it, never at 1 itself.
    const int levels = static_cast<int>(is_near(block) ? wanted_.level : 0);
    return std::max(most, std::exp2(levels - static_cast<int>(block.level) - 0.5));
  }
  /// The surface is about as far from the faces as from the middles of their edges.
  bool is_near(const Block& block) const {
    if (wanted_.near.empty()) return true;
    for (const Brush& brush : wanted_.near)
      for (std::size_t i = 0; i < block.count; ++i)
        if (std::sqrt(nearest_of(block.faces[i], brush.centre).distance2) <=
            brush.radius + block.error)
          return true;
    return false;
  }

  static double off_of(const Sample& s) { return s.on_shape ? s.distance : -s.distance; }
  void set_off(HalfEdge h, double off) {
    for (const HalfEdge side : surface().star(h)) off_[side.index()] = off;
  }
  void measure(HalfEdge h) { set_off(h, off_of(mesh_.sample(h))); }
  /// A side of what was changed, which has another id now: the side beyond knows what it was. Not
  /// on the boundary, nor where the block is glued to itself (`changed` says of which faces).
  template <class Changed>
  void take_over(HalfEdge h, Changed changed) {
    const HalfEdge beyond = surface().sym(h);
    if (beyond && !changed(left(beyond)))
      off_[h.index()] = off_[beyond.index()];
    else
      measure(h);
  }

  const Followed& mesh_;
  Wanted wanted_;
  std::vector<double> off_;  // by half-edge
};

/// As DynamicAdaptation takes it.
struct PriorityOf {
  const Criteria* criteria;
  double operator()(const MultiTriangulation&, HalfEdge h) const { return criteria->priority(h); }
  double operator()(const MultiTriangulation&, Vertex v) const { return criteria->priority(v); }
};

}  // namespace clers::cli

#endif
