// What is rare among the symbols: components, holes, handles. format.md, Answers. Each is written
// once, for a Coder of either direction (entropy/coder.h).
#ifndef CLERS_CODEC_CONNECTIVITY_EVENT_MODEL_H
#define CLERS_CODEC_CONNECTIVITY_EVENT_MODEL_H

#include <algorithm>
#include <cstdint>

#include "codec/entropy/coder.h"
#include "codec/symbols/symbol.h"

namespace clers::internal {

/// What is coded at the places in the symbol string where more than a symbol is needed.
class EventModel {
 public:
  /// At an E with no gate pending: is it the first triangle of another component? Depends on
  /// whether the gate's curve has two edges only, and on the last three answers: components that
  /// are copies of each other give the same answers again.
  template <class Coder>
  bool new_component(Coder& c, bool two_edges, bool value) {
    const bool answer = c.bit(new_component_[two_edges][answers_], value);
    answers_ = (answers_ << 1 | answer) & 7;
    return answer;
  }

  /// At the end of a component whose last curve has two edges: are they glued?
  template <class Coder>
  bool closed(Coder& c, bool value) {
    return c.bit(closed_, value);
  }

  /// At an S when a gate is pending: does it glue to something else than that gate?
  template <class Coder>
  bool special(Coder& c, bool value) {
    return c.bit(special_, value);
  }

  /// What a special S does; join is possible only when curves wait to be joined.
  template <class Coder>
  SpecialS kind(Coder& c, bool any_waiting, SpecialS value) {
    if (any_waiting && c.bit(join_, value == SpecialS::join)) return SpecialS::join;
    return c.bit(split_[any_waiting], value == SpecialS::split) ? SpecialS::split : SpecialS::hole;
  }

  /// Edges of the hole, at least 2.
  template <class Coder>
  std::uint64_t hole_length(Coder& c, std::uint64_t value) {
    return 2 + std::uint64_t(hole_.code(c, static_cast<std::uint32_t>(value - 2)));
  }

  /// Distance 2 .. n-3 back along a curve of n edges: the shorter way round and which way.
  template <class Coder>
  std::uint64_t split_distance(Coder& c, std::uint64_t n, std::uint64_t value) {
    const std::uint64_t from_front = value - 2, from_back = n - 3 - value;
    const bool back = c.bit(split_back_, from_back < from_front);
    const std::uint64_t near =
        distance_.code(c, static_cast<std::uint32_t>(std::min(from_front, from_back)));
    return back ? n - 3 - near : 2 + near;
  }

  /// Which of `waiting` curves is joined, 0 the latest.
  template <class Coder>
  std::uint32_t join_curve(Coder& c, std::uint32_t waiting, std::uint32_t value) {
    return waiting > 1 ? recency_.code(c, value) : 0;
  }

  /// Where on a curve of n edges, counted back from where it was split off.
  template <class Coder>
  std::uint32_t join_position(Coder& c, std::uint32_t n, std::uint32_t value) {
    return code_uniform(c, n, value);
  }

 private:
  BitModel new_component_[2][8], closed_, special_, join_, split_[2], split_back_;
  NumberModel hole_, distance_, recency_;
  unsigned answers_ = 0;
};

}  // namespace clers::internal

#endif
