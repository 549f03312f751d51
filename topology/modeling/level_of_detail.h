// A mesh at any number of faces: the flips and welds of a simplification, back and forth (§7.4).
#ifndef CLERS_TOPOLOGY_MODELING_LEVEL_OF_DETAIL_H
#define CLERS_TOPOLOGY_MODELING_LEVEL_OF_DETAIL_H

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include <clers/modeling/operator_log.h>
#include <clers/modeling/simplify.h>
#include <clers/topology/export.h>
#include <clers/topology/surface.h>

namespace CLERS_VISIBLE clers {

/// A surface with values by vertex, and what simplifying it did to them. Level 0 is the surface it
/// was made with, level i has i vertices less. Whatever the way to it, a level is always the same:
/// ids, corners, star half-edges and the bits of all values; those of dead vertices, too.
///
/// `Value` is copied and moved; a position, or a struct with normals and the like beside it.
///
///     LevelOfDetail<> levels(std::move(surface), positions);
///     const auto done = simplify(levels, positions, creases, {});
///     levels.to_faces(10'000);  // draw levels.surface(), levels.values()
///
/// Memory: besides surface and values some 50 bytes, a value and 12 bytes more for each vertex that
/// is gone.
template <class Value = Position3>
class LevelOfDetail {
 public:
  /// Values by vertex, for ids below surface.vertex_limit(). One level, 0.
  LevelOfDetail(Surface surface, std::vector<Value> values)
      : surface_(std::move(surface)), values_(std::move(values)) {
    values_.resize(surface_.vertex_limit());
    faces_ = surface_.characteristic().f;
  }

  const Surface& surface() const { return surface_; }
  std::span<const Value> values() const { return values_; }

  /// Where the surface is, and how many levels there are besides 0.
  std::size_t level() const { return level_; }
  std::size_t coarsest() const { return steps_.size(); }
  /// Of a level, without going there.
  std::int64_t faces(std::size_t level) const {
    return level == 0 ? faces_ : steps_[level - 1].faces;
  }

  /// Contracts an edge, which makes the next level; those that were coarser are forgotten. The
  /// vertex that is kept gets the value. Throws std::bad_alloc, having changed nothing. Cost: that
  /// of clers::contract.
  void contract(Creases& creases, const Contraction& c, Value value) {
    internal::reserve_more(steps_, 1);
    // A flip for each edge of the vertex that goes, one for an ear, and a weld.
    log_.reserve(surface_.degree(c.gone) + 2);
    steps_.resize(level_);
    clers::contract(surface_, creases, c, log_);
    std::swap(values_[c.kept.index()], value);
    steps_.push_back({log_.place(), surface_.characteristic().f, c.kept, std::move(value)});
    ++level_;
  }

  /// Goes to a level, or to the coarsest if that is finer. `observer` is called for each operator
  /// this takes (follow.h), before values are changed. Cost: O(1) for each operator between.
  template <class Observer = NoObserver>
  void to_level(std::size_t level, Observer&& observer = {}) {
    level = std::min(level, coarsest());
    for (; level_ < level; ++level_) {
      Step& step = steps_[level_];
      while (log_.place() < step.end) log_.redo(surface_, observer);
      std::swap(values_[step.kept.index()], step.value);
    }
    while (level_ > level) {
      Step& step = steps_[--level_];
      std::swap(values_[step.kept.index()], step.value);
      const std::size_t begin = level_ == 0 ? 0 : steps_[level_ - 1].end;
      while (log_.place() > begin) log_.undo(surface_, observer);
    }
  }
  /// Goes to the finest level of at most so many faces, or to the coarsest. Cost: O(log levels),
  /// and that of to_level.
  template <class Observer = NoObserver>
  void to_faces(std::int64_t most, Observer&& observer = {}) {
    const auto first = std::partition_point(steps_.begin(), steps_.end(),
                                            [&](const Step& step) { return step.faces > most; });
    to_level(faces_ <= most ? 0 : static_cast<std::size_t>(first - steps_.begin()) + 1, observer);
  }

 private:
  /// From a level to the next.
  struct Step {
    std::size_t end;     // in the log
    std::int64_t faces;  // afterwards
    Vertex kept;
    Value value;  // what it had before, while this is done; else what it will have
  };

  Surface surface_;
  std::vector<Value> values_;
  std::int64_t faces_ = 0;
  OperatorLog log_;
  std::vector<Step> steps_;
  std::size_t level_ = 0;
};

/// simplify(), recorded from the level at which `levels` is. `positions` are those of its vertices;
/// `carry(c, kept, gone)` makes of the values of two vertices, as they are, that of the vertex that
/// stays. Errors and what is thrown: as of simplify().
template <class Value, class Carry>
Result<SimplifyResult, SimplifyFault> simplify(LevelOfDetail<Value>& levels,
                                               std::vector<Position3> positions, Creases& creases,
                                               const SimplifyOptions& options, Carry&& carry) {
  if (const auto why = Simplification::refuse(levels.surface(), positions, options))
    return Failure{*why};
  Simplification simplification(levels.surface(), positions, creases, options);
  while (const auto c = simplification.next()) {
    levels.contract(creases, *c,
                    carry(*c, levels.values()[c->kept.index()], levels.values()[c->gone.index()]));
    simplification.contracted(*c);
  }
  return simplification.result();
}
/// With positions as values.
inline Result<SimplifyResult, SimplifyFault> simplify(LevelOfDetail<Position3>& levels,
                                                      Creases& creases,
                                                      const SimplifyOptions& options) {
  const std::span<const Position3> at = levels.values();
  return simplify(levels, {at.begin(), at.end()}, creases, options,
                  [](const Contraction& c, const Position3&, const Position3&) { return c.place; });
}

}  // namespace clers

#endif
