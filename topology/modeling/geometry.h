// What subdivision asks of geometry: values of new vertices from values of old ones.
#ifndef CLERS_TOPOLOGY_MODELING_GEOMETRY_H
#define CLERS_TOPOLOGY_MODELING_GEOMETRY_H

#include <span>
#include <utility>
#include <vector>

#include "topology/ids.h"

namespace clers {

/// A vertex and its weight; the weights of a mask add up to 1.
struct Term {
  Vertex vertex;
  double weight = 0;
};

/// A Geometry, which the functions of this directory take, has
///
///     using Value = ...;
///     Value combine(std::span<const Term> mask) const;  // of the values that vertices have now
///     void set(Vertex v, Value value);                  // v may be new
///
/// combine may average, as Averaging does, or sample a surface near the average. Nothing is set
/// before all that depends on the old values is combined.
///
/// Averaging is the Geometry of values that are added and multiplied by numbers, and start from
/// Value{}: positions, and whatever else lies beside them in a Value.
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
  void set(Vertex v, Value value) {
    if (v.index() >= values_.size()) values_.resize(v.index() + std::size_t{1});
    values_[v.index()] = std::move(value);
  }

 private:
  std::vector<Value> values_;
};

/// Values that have been combined and wait until they may be set.
template <class Geometry>
class Moves {
 public:
  void reserve(std::size_t n) { waiting_.reserve(n); }
  void add(Vertex v, const Geometry& g, std::span<const Term> mask) {
    waiting_.emplace_back(v, g.combine(mask));
  }
  void set(Geometry& g) {
    for (auto& [v, value] : waiting_) g.set(v, std::move(value));
  }

 private:
  std::vector<std::pair<Vertex, typename Geometry::Value>> waiting_;
};

}  // namespace clers

#endif
