// What subdivision asks of geometry: values of new vertices from values of old ones.
#ifndef CLERS_TOPOLOGY_MODELING_GEOMETRY_H
#define CLERS_TOPOLOGY_MODELING_GEOMETRY_H

#include <span>
#include <utility>
#include <vector>

#include <clers/topology/export.h>
#include <clers/topology/surface.h>

namespace CLERS_VISIBLE clers {

/// A vertex and its weight; the weights of a mask add up to 1.
struct Term {
  Vertex vertex;
  double weight = 0;
};

/// The mask of a vertex put into a face: the mean of its corners.
inline void face_mask(const Surface& surface, Face f, std::vector<Term>& mask) {
  mask.clear();
  for (const HalfEdge h : surface.star(f)) mask.push_back({surface.org(h), 1. / 3});
}

/// A Geometry, which the functions of this directory take, has
///
///     using Value = ...;
///     Value combine(std::span<const Term> mask) const;  // of the values that vertices have now
///     void set(Vertex v, Value value);                  // v may be new
///
/// combine may average, as Averaging does, or sample a surface near the average. Everything that
/// depends on old values is combined before anything is set. If it has
///
///     void reserve(std::size_t vertices);
///
/// that is called before many are set.
///
/// Averaging is the Geometry of values that are added and multiplied by numbers, and start from
/// Value{}: positions, and whatever else a Value has besides.
template <class V>
class Averaging {
 public:
  using Value = V;

  Averaging() = default;
  /// By vertex.
  explicit Averaging(std::vector<Value> values) : values_(std::move(values)) {}

  const std::vector<Value>& values() const { return values_; }
  const Value& operator[](Vertex v) const { return values_[v.index()]; }

  Value combine(std::span<const Term> mask) const {
    Value sum{};
    for (const Term& t : mask) sum += t.weight * values_[t.vertex.index()];
    return sum;
  }
  void reserve(std::size_t vertices) { values_.reserve(vertices); }
  void set(Vertex v, Value value) {
    if (v.index() >= values_.size()) values_.resize(v.index() + std::size_t{1});
    values_[v.index()] = std::move(value);
  }

 private:
  std::vector<Value> values_;
};

template <class Geometry>
void reserve_values(Geometry& geometry, std::size_t vertices) {
  if constexpr (requires { geometry.reserve(vertices); }) geometry.reserve(vertices);
}

/// New values of old vertices, combined from the old values of all and set afterwards.
template <class Geometry>
class Moves {
 public:
  /// `mask_of(v, mask)` writes the mask of v.
  template <class MaskOf>
  Moves(std::span<const Vertex> vertices, const Geometry& geometry, MaskOf&& mask_of) {
    waiting_.reserve(vertices.size());
    std::vector<Term> mask;
    for (const Vertex v : vertices) {
      mask_of(v, mask);
      waiting_.emplace_back(v, geometry.combine(mask));
    }
  }
  void set(Geometry& geometry) {
    for (auto& [v, value] : waiting_) geometry.set(v, std::move(value));
  }

 private:
  std::vector<std::pair<Vertex, typename Geometry::Value>> waiting_;
};

}  // namespace clers

#endif
