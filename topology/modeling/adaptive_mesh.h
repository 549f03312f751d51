// Dynamic adaptive meshes: the three functions of the paper (§6), with values sampled where
// vertices are made.
#ifndef CLERS_TOPOLOGY_MODELING_ADAPTIVE_MESH_H
#define CLERS_TOPOLOGY_MODELING_ADAPTIVE_MESH_H

#include <optional>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include <clers/modeling/adapt.h>
#include <clers/modeling/base_mesh.h>
#include <clers/modeling/labels.h>
#include <clers/topology/export.h>

namespace CLERS_VISIBLE clers {

/// A mesh that follows a surface known from elsewhere: parametric, implicit, simulated, or another
/// mesh. The caller gives a base mesh with values, a function that samples the surface where a
/// vertex is put, and tests of where to refine and where to simplify. Values are of any type; the
/// mesh interprets none.
///
///     auto mesh = adaptive_mesh<Value>(sample);           // the constructor
///     mesh.read(surface_of_polygons(..), values, length); // read_off
///     while (do_processing()) {                           // Program 6
///       update(mesh);
///       mesh.adapt(need_refine, need_simplify);
///     }
///
/// `Sample` is either callable with the values of the two ends of the edge that is split,
/// `Value(const Value& a, const Value& b)`, or with the vertex's label (labels.h),
/// `Value(const Label&)`; const, since it may be called to see where a sample would be. Of the
/// first kind the vertex in the middle of a triangle of the base is sampled between a corner and a
/// sample between the other two. The tests are callable with (mesh, HalfEdge) and (mesh, Vertex),
/// mesh being this object; adapt.h says of what.
///
/// Observers: as MultiTriangulation's, called when the new vertex has its value.
///
/// If `Sample` throws, the vertex is there with some other vertex's value. When memory runs out, a
/// split that was not made changes no value; if a copy of a Value throws, `read` must be called
/// again.
template <class Value, class Sample>
class AdaptiveMesh {
 public:
  static constexpr bool by_label = std::is_invocable_v<const Sample&, const Label&>;

  explicit AdaptiveMesh(Sample function) : sample_(std::move(function)) {}

  /// Makes the base mesh: quadrilaterals are blocks, triangles become some by Program 5
  /// (four_eight.h), those with the longest edges in pairs. `values` by vertex; where samples are
  /// by label, those of the vertices that Program 5 makes are sampled in the end.
  ///
  /// `length(const Value&, const Value&)`: a double. Preconditions: a value for each vertex below
  /// the surface's limit; those of make_tri_quad. Cost: O(F log F). On a violation the mesh is
  /// empty.
  template <class Length>
  Result<Done, Violation> read(PolygonSurface base, std::vector<Value> values, Length&& length) {
    mesh_.reset(), labels_.reset();
    values_ = std::move(values);
    std::vector<bool> given(base.surface.vertex_limit());
    for (const Vertex v : base.surface.vertices()) given[v.index()] = true;
    Creases none;
    Base geometry{*this};
    const auto between = [&](const Surface& s, HalfEdge h) {
      return static_cast<double>(
          length(std::as_const(values_[s.org(h).index()]), values_[s.dest(h).index()]));
    };
    const auto ok = make_tri_quad(base.surface, geometry, none, between, base.quads);
    if (!ok) return ok;
    auto made = MultiTriangulation::over(std::move(base.surface));
    if (!made) return Failure{made.error()};
    mesh_ = std::move(*made);
    if constexpr (by_label) {
      labels_.emplace(*mesh_);
      for (const Vertex v : mesh_->surface().vertices())
        if (v.index() >= given.size() || !given[v.index()])
          values_[v.index()] = sample_(labels_->of(*mesh_, v));
    }
    return Done{};
  }

  // Of the mesh, once it is read.
  const MultiTriangulation& mesh() const { return *mesh_; }
  MultiTriangulation& mesh() { return *mesh_; }
  const Surface& surface() const { return mesh_->surface(); }
  unsigned level(HalfEdge h) const { return mesh_->level(left(h)); }
  unsigned level(Vertex v) const { return mesh_->level(v); }
  /// Only where samples are by label.
  Label label(Vertex v) const requires by_label { return labels_->of(*mesh_, v); }

  /// The value of a vertex, which may be changed.
  const Value& operator[](Vertex v) const { return values_[v.index()]; }
  Value& operator[](Vertex v) { return values_[v.index()]; }
  /// By vertex id, those of dead ones too.
  const std::vector<Value>& values() const { return values_; }

  /// What a sample between the ends of a split edge would be: for tests of how far the surface is
  /// from the mesh. Of a half-edge whose edge a split would halve.
  Value sample(HalfEdge h) const requires(!by_label) {
    return sample_((*this)[surface().org(h)], (*this)[surface().dest(h)]);
  }

  template <class Need, class Observer = NoObserver>
  Adapted adapt_refine(Need&& need, const AdaptationLimits& limits = {}, Observer&& observer = {}) {
    const auto test = [&](const MultiTriangulation&, HalfEdge h) {
      return need(std::as_const(*this), h);
    };
    return clers::adapt_refine(*mesh_, test, limits, follow(observer));
  }
  template <class Need, class Observer = NoObserver>
  Adapted adapt_simplify(Need&& need, Observer&& observer = {}) {
    const auto test = [&](const MultiTriangulation&, Vertex v) {
      return need(std::as_const(*this), v);
    };
    return clers::adapt_simplify(*mesh_, test, follow(observer));
  }
  template <class NeedRefine, class NeedSimplify, class Observer = NoObserver>
  Adapted adapt(NeedRefine&& need_refine, NeedSimplify&& need_simplify,
                const AdaptationLimits& limits = {}, Observer&& observer = {}) {
    Adapted done = adapt_refine(need_refine, limits, observer);
    done.simplified = adapt_simplify(need_simplify, observer).simplified;
    return done;
  }

  /// The observer that gives new vertices their values, then calls `next`: for operators called on
  /// mesh() itself, DynamicAdaptation's among them.
  template <class Next>
  class Follow {
    static_assert(internal::hears<Next>);

   public:
    Follow(AdaptiveMesh& mesh, Next& next) : mesh_(mesh), next_(next) {}

    void reserve(const Surface& surface) {
      mesh_.reserve(surface);
      if constexpr (requires { next_.reserve(surface); }) next_.reserve(surface);
    }
    void operator()(const Change& change) requires std::is_invocable_v<Next&, const Change&> {
      next_(change);
    }
    void operator()(const Refined& refined) {
      mesh_.refined(refined);
      if constexpr (std::is_invocable_v<Next&, const Refined&>) next_(refined);
    }
    void operator()(const Simplified& simplified) {
      mesh_.simplified(simplified);
      if constexpr (std::is_invocable_v<Next&, const Simplified&>) next_(simplified);
    }

   private:
    AdaptiveMesh& mesh_;
    Next& next_;
  };
  template <class Next>
  Follow<Next> follow(Next& next) {
    return Follow<Next>(*this, next);
  }

 private:
  /// The Geometry of make_tri_quad: samples at the middle of an edge or of a face.
  struct Base {
    AdaptiveMesh& mesh;
    Value combine(std::span<const Term> mask) const {
      const auto at = [&](std::size_t i) -> const Value& { return mesh[mask[i].vertex]; };
      if constexpr (by_label)
        return at(0);  // until the base is whole
      else if (mask.size() == 2)
        return mesh.sample_(at(0), at(1));
      else
        return mesh.sample_(at(0), mesh.sample_(at(1), at(2)));
    }
    void set(Vertex v, Value value) { mesh.set(v, std::move(value)); }
  };

  void set(Vertex v, Value value) {
    if (v.index() < values_.size())
      values_[v.index()] = std::move(value);
    else
      values_.push_back(std::move(value));  // ids are given in order
  }
  void reserve(const Surface& surface) {
    if (values_.size() <= surface.vertex_limit())
      internal::reserve_more(values_, surface.vertex_limit() + std::size_t{1} - values_.size());
    if constexpr (by_label) labels_->reserve(surface);
  }
  void refined(const Refined& refined) {
    const Vertex v = refined.made;
    if constexpr (by_label) labels_->refined(surface(), refined);
    if (v.index() == values_.size()) values_.push_back(values_[refined.a.index()]);
    if constexpr (by_label)
      values_[v.index()] = sample_(labels_->of(*mesh_, v));
    else
      values_[v.index()] = sample_((*this)[refined.a], (*this)[refined.b]);
  }
  void simplified(const Simplified& simplified) {
    if constexpr (by_label) labels_->simplified(surface(), simplified);
  }

  Sample sample_;
  std::optional<MultiTriangulation> mesh_;
  std::vector<Value> values_;     // by vertex
  std::optional<Labels> labels_;  // where samples are by label
};

/// The mesh with this sampling function; read makes it one.
template <class Value, class Sample>
AdaptiveMesh<Value, Sample> adaptive_mesh(Sample sample) {
  return AdaptiveMesh<Value, Sample>(std::move(sample));
}

}  // namespace clers

#endif
