// Writes to a stream the answers to what a decoder asks besides symbols.
#ifndef CLERS_CODEC_CONNECTIVITY_EVENT_WRITER_H
#define CLERS_CODEC_CONNECTIVITY_EVENT_WRITER_H

#include <cstddef>
#include <cstdint>
#include <vector>

#include "codec/connectivity/decode_script.h"
#include "codec/connectivity/event_model.h"
#include "codec/entropy/coder.h"
#include "codec/entropy/rans.h"

namespace clers::internal {

/// Writes the answers that a decoder will need, in the order in which it asks.
class EventWriter {
  const Event& event() const { return events_[next_]; }

  template <class Code>
  auto count_special(std::size_t first, Code code) {
    const auto value = code();
    for (std::size_t k = first; k < out_.intervals().size(); ++k)
      special_cost += rans::cost(out_.intervals()[k]);
    return value;
  }

 public:
  static constexpr bool knows_vertices = false;

  EventWriter(const std::vector<Event>& events, rans::Encoder& out)
      : events_(events), coder_(out), out_(out) {}

  /// The next symbol is about to be written.
  void symbol_begins() { symbol_begin_ = out_.intervals().size(); }

  /// All that come after a symbol.
  void write_after(std::uint32_t symbol) {
    while (next_symbol() == symbol) {
      switch (event().kind) {
        case Event::Kind::new_component: new_component(event().two_edges); break;
        case Event::Kind::closed: closed(); break;
        case Event::Kind::special: special(); break;
        case Event::Kind::hole:
        case Event::Kind::split:
        case Event::Kind::join:
          switch (kind(waiting_ > 0)) {
            case SpecialS::hole: hole_length(); break;
            case SpecialS::split: split_distance(event().length); break;
            case SpecialS::join:
              join_curve(waiting_);
              join_position(event().length);
              break;
          }
          break;
      }
    }
  }

  std::uint32_t next_symbol() const {
    return next_ < events_.size() ? event().symbol : 0xffffffffu;
  }

  bool new_component(bool two_edges) {
    return model_.new_component(coder_, two_edges, events_[next_++].value);
  }
  bool closed() {
    const bool value = model_.closed(coder_, events_[next_++].value);
    closed_components += value;
    return value;
  }
  void component_ended() {}
  bool special() { return model_.special(coder_, events_[next_++].value); }
  SpecialS kind(bool any_waiting) {
    return count_special(symbol_begin_, [&] {
      const SpecialS kind = event().kind == Event::Kind::join    ? SpecialS::join
                            : event().kind == Event::Kind::split ? SpecialS::split
                                                                 : SpecialS::hole;
      return model_.kind(coder_, any_waiting, kind);
    });
  }
  std::uint64_t hole_length() {
    return count_special(out_.intervals().size(), [&] {
      ++holes;
      return model_.hole_length(coder_, events_[next_++].distance);
    });
  }
  std::uint64_t split_distance(std::uint64_t n) {
    return count_special(out_.intervals().size(), [&] {
      ++waiting_;
      return model_.split_distance(coder_, n, events_[next_++].distance);
    });
  }
  std::uint32_t join_curve(std::uint32_t waiting) {
    return count_special(out_.intervals().size(),
                         [&] { return model_.join_curve(coder_, waiting, event().recency); });
  }
  std::uint32_t join_position(std::uint32_t n) {
    return count_special(out_.intervals().size(), [&] {
      ++handles;
      --waiting_;
      return model_.join_position(coder_, n, events_[next_++].distance);
    });
  }

  std::uint64_t handles = 0, holes = 0, closed_components = 0;
  std::uint64_t special_cost = 0;  ///< of holes and handles with their symbols, in 1/256 bits

 private:
  const std::vector<Event>& events_;
  std::uint32_t waiting_ = 0;  ///< curves split off for a handle and not joined yet
  EncodeTo coder_;
  rans::Encoder& out_;
  EventModel model_;
  std::size_t next_ = 0;
  std::size_t symbol_begin_ = 0;  ///< where the last symbol begins
};

}  // namespace clers::internal

#endif
