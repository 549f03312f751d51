// The regular binary multi-triangulation: a tri-quad mesh refined and simplified where one likes,
// with no hierarchy stored (Dynamic adaptive meshes, §3 to §5; Topological mesh operators, §7.5).
#ifndef CLERS_TOPOLOGY_MODELING_MULTI_TRIANGULATION_H
#define CLERS_TOPOLOGY_MODELING_MULTI_TRIANGULATION_H

#include <array>
#include <cstdint>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

#include <clers/modeling/four_eight.h>
#include <clers/topology/element_data.h>
#include <clers/topology/export.h>
#include <clers/topology/follow.h>
#include <clers/topology/surface.h>

namespace CLERS_VISIBLE clers {

/// A block was split: vertex `made`, between `a` and `b`, is corner 0 of every face at it.
struct Refined {
  Vertex made, a, b;
};
/// A vertex was welded away: `edge` is the split edge of the block that is back.
struct Simplified {
  Vertex gone;
  HalfEdge edge;
};

namespace internal {
/// Is it NoObserver, or callable with something of what refine and simplify tell?
template <class Observer>
inline constexpr bool hears =
    !observes<Observer> || std::is_invocable_v<Observer&, const Change&> ||
    std::is_invocable_v<Observer&, const Refined&> ||
    std::is_invocable_v<Observer&, const Simplified&>;
}  // namespace internal

/// A surface whose faces come in blocks of two, each with a split edge between them (four_eight.h):
///
///          c                       c           refine: the split edge gets a vertex v, one level
///         / \                     /|\          finer than the two faces. The sides of the block
///        /   \       refine      / | \         are the split edges of the four new faces: they
///       a --s-- b   ---------\  a--v--b        are blocks with the faces beyond once those are as
///        \   /      /---------   \ | /         fine ("interleaved refinement", Fig. 5).
///         \ /       simplify      \|/
///          d                       d           simplify: back.
///
/// The mesh conforms at all times, and neighbouring faces differ by at most one level: refine
/// splits first what is too coarse around the block, simplify welds first what is too fine around
/// the vertex. The hierarchy is in the numbering: the split edge of a face is its half-edge 1, the
/// weld vertex, which is opposite, its corner 0, and the star half-edge of a vertex says which edge
/// its weld restores. Besides the surface a byte is kept for each vertex, its level. Vertices of
/// the base mesh have level 0 and are never welded.
///
/// Observers. refine and simplify take an observer last, which may be callable with any of
/// `const Refined&`, `const Simplified&` and `const Change&` (follow.h), and is called after every
/// split and weld, those of neighbours too; Change comes first. One that is callable with none is
/// refused by the compiler; NoObserver costs nothing. If an observer throws, the operator that it
/// was called for has been applied. One that keeps values by element may have `reserve(const
/// Surface&)`, too, called before each split, which makes two faces and a vertex at most: if that
/// throws, nothing has been applied.
///
/// When memory runs out, refine and simplify throw std::bad_alloc: the mesh is valid, some of the
/// neighbours that had to go first may be split or welded.
class MultiTriangulation {
 public:
  static constexpr unsigned max_level = 60;

  /// Of a tri-quad mesh, which becomes the base: make_tri_quad and tri_quad_of (base_mesh.h) make
  /// some. Violation: `tri_quad`. Cost: O(F).
  static Result<MultiTriangulation, Violation> over(Surface base);

  const Surface& surface() const { return surface_; }
  /// Ends the hierarchy: what is left is a surface.
  Surface release() && { return std::move(surface_); }

  /// A container of values by element that follows all changes (element_data.h): VertexData,
  /// FaceData, HalfEdgeData.
  template <class Data, class... Initial>
  Data attach(Initial&&... initial) {
    return Data(surface_, std::forward<Initial>(initial)...);
  }

  // Preconditions of queries: live elements. O(1) unless said.

  unsigned level(Vertex v) const { return level_[v.index()]; }
  /// That of its weld vertex, the newest of the three.
  unsigned level(Face f) const { return level(surface_.org(half_edge(f, 0))); }

  static HalfEdge split_edge(Face f) { return half_edge(f, 1); }
  Vertex weld_vertex(Face f) const { return surface_.org(half_edge(f, 0)); }
  /// Is the edge the split edge of all its faces? Then refine splits it and nothing else.
  bool is_block(HalfEdge h) const { return is_split_edge(surface_, h); }
  /// Does simplify weld the vertex and nothing else? Then all corners at it are corner 0.
  bool can_weld(Vertex v) const {
    return level(v) != 0 && surface_.corner_count(v) == (surface_.is_boundary(v) ? 2u : 4u);
  }
  /// How many splits refine(h) needs, its own among them, and how many faces they make. O(level).
  struct Growth {
    unsigned splits = 0, faces = 0;
  };
  Growth growth(HalfEdge h) const;
  unsigned splits(HalfEdge h) const { return growth(h).splits; }
  /// Would refine(h) make more faces than this? O(1) but where few are left.
  bool makes_more_faces(HalfEdge h, std::int64_t left) const {
    constexpr std::int64_t most = 2 * (2 * (max_level + 1) + 1);
    return left < most && left < growth(h).faces;
  }

  /// Puts a vertex on an edge (Program 1): splits first, from the coarsest on, what keeps the edge
  /// from being the split edge of its faces. Returns the vertex.
  ///
  /// Preconditions: `live_half_edge`; `ids_left`; `levels_left`. Cost: O(1) for every split, of
  /// which there are at most two for each level above h, besides O(log n) on a boundary. Ids: all
  /// stay valid but that half-edges of the faces split have other ids (Surface::split).
  template <class Observer = NoObserver>
  Result<Vertex, Violation> refine(HalfEdge h, Observer&& observer = {});

  /// Takes a vertex out (Program 2): welds first, from the finest on, the vertices around it that
  /// are finer. Returns the split edge of the block that is back.
  ///
  /// Preconditions: `live_vertex`; `refined_vertex`. Cost: O(1) for every weld. Ids: those of
  /// vertices welded, and of two faces (one on a boundary) each, are freed; half-edges as
  /// Surface::weld.
  template <class Observer = NoObserver>
  Result<HalfEdge, Violation> simplify(Vertex v, Observer&& observer = {});

 private:
  explicit MultiTriangulation(Surface base);

  /// The split edge of a face of h that is another than h's edge, or null.
  HalfEdge split_before(HalfEdge h) const {
    if (corner(h) != 1) return half_edge(left(h), 1);
    const HalfEdge t = surface_.sym(h);
    return t && corner(t) != 1 ? half_edge(left(t), 1) : HalfEdge();
  }
  std::optional<Violation> refuse_refine(HalfEdge h) const;
  std::optional<Violation> refuse_simplify(Vertex v) const;
  /// A neighbour of the greatest level, if that is above v's; or null.
  Vertex finer_neighbour(Vertex v) const;
  template <class Observer>
  Vertex split(HalfEdge h, Observer&& observer);

  Surface surface_;
  std::vector<std::uint8_t> level_;  // by vertex
};

template <class Observer>
Vertex MultiTriangulation::split(HalfEdge h, Observer&& observer) {
  const Vertex a = surface_.org(h), b = surface_.dest(h);
  const std::uint8_t finer = static_cast<std::uint8_t>(level(left(h)) + 1);
  if (level_.size() <= surface_.vertex_limit())
    level_.resize(level_.size() + level_.size() / 2 + 1);
  if constexpr (requires { observer.reserve(surface_); }) observer.reserve(std::as_const(surface_));
  Vertex v;
  if constexpr (std::is_invocable_v<Observer&, const Change&>)
    v = *clers::split(surface_, h, Point(), [&](const Change& change) {
      level_[change.made().index()] = finer;
      observer(change);
    });
  else
    v = *surface_.split(h, Point());
  level_[v.index()] = finer;
  if constexpr (std::is_invocable_v<Observer&, const Refined&>) observer(Refined{v, a, b});
  return v;
}

template <class Observer>
Result<Vertex, Violation> MultiTriangulation::refine(HalfEdge h, Observer&& observer) {
  static_assert(internal::hears<Observer>);
  if (const auto why = refuse_refine(h)) return Failure{*why};
  // Edges that wait for the next; the faces between them are a level coarser each time.
  std::array<HalfEdge, max_level + 2> waiting;
  std::size_t count = 0;
  waiting[count++] = h;
  for (;;) {
    const HalfEdge edge = waiting[count - 1];
    if (const HalfEdge first = split_before(edge)) {
      waiting[count++] = first;
      continue;
    }
    const Face f = left(edge), g = surface_.sym(edge) ? left(surface_.sym(edge)) : f;
    const Vertex v = split(edge, observer);
    if (--count == 0) return v;
    // Sides of the block, which wait for it, are half-edge 1 of its parts now (Surface::split).
    for (std::size_t i = 0; i < count; ++i) {
      const Face of = left(waiting[i]);
      if (of != f && of != g) continue;
      const Face part = corner(waiting[i]) == 0 ? of : left(surface_.sym(half_edge(of, 0)));
      waiting[i] = half_edge(part, 1);
    }
  }
}

template <class Observer>
Result<HalfEdge, Violation> MultiTriangulation::simplify(Vertex v, Observer&& observer) {
  static_assert(internal::hears<Observer>);
  if (const auto why = refuse_simplify(v)) return Failure{*why};
  std::array<Vertex, max_level + 1> waiting;
  std::size_t count = 0;
  waiting[count++] = v;
  for (;;) {
    const Vertex u = waiting[count - 1];
    if (!can_weld(u)) {
      waiting[count++] = finer_neighbour(u);
      continue;
    }
    HalfEdge edge;
    if constexpr (std::is_invocable_v<Observer&, const Change&>)
      edge = clers::weld(surface_, surface_.star_half_edge(u), observer)->at;
    else
      edge = surface_.weld(surface_.star_half_edge(u))->at;
    if constexpr (std::is_invocable_v<Observer&, const Simplified&>) observer(Simplified{u, edge});
    if (--count == 0) return edge;
  }
}

}  // namespace clers

#endif
