// Answers the questions of SpiraleReversi from a stream.
#ifndef CLERS_CODEC_STREAM_SOURCE_H
#define CLERS_CODEC_STREAM_SOURCE_H

#include <cstddef>
#include <cstdint>
#include <span>

#include "codec/clers.h"
#include "codec/connectivity.h"
#include "codec/event_model.h"
#include "codec/rans.h"
#include "codec/symbol_model.h"

namespace clers {

/// The decoder's side of codec/format.md, "Symbols" and "Events".
class StreamSource {
 public:
  static constexpr bool resolves = false;

  StreamSource(std::span<const std::byte> stream, unsigned history)
      : in_(stream), symbols_(history) {}

  bool ok() const { return symbols_.ok(); }
  void first() {
    ++counts.components;
    ++counts.letters[static_cast<unsigned>(Clers::E)];
  }
  template <class Then>
  [[gnu::always_inline]] auto symbol(std::uint32_t kx, Then then) {
    return symbols_.decode(
        in_, kx, [&](auto letter) __attribute__((always_inline)) {
          ++counts.letters[static_cast<unsigned>(letter())];
          return then(letter);
        });
  }
  bool overrun() const { return in_.overrun(); }
  bool finished() const { return in_.finished(); }

  bool new_component() {
    DecodeFrom coder(in_);
    const bool value = events_.new_component(coder, false);
    counts.components += value;
    return value;
  }
  bool closed() {
    DecodeFrom coder(in_);
    const bool value = events_.closed(coder, false);
    closed_components += value;
    return value;
  }
  void component_ended() {}
  bool special() {
    DecodeFrom coder(in_);
    return events_.special(coder, false);
  }
  template <class Front, class Gate>
  SpecialS kind(const Front&, const Gate&, std::span<const std::uint32_t> waiting) {
    DecodeFrom coder(in_);
    const SpecialS kind = events_.kind(coder, !waiting.empty(), SpecialS::hole);
    counts.coded_holes += kind == SpecialS::hole;
    counts.handles += kind == SpecialS::join;
    return kind;
  }
  std::uint64_t hole_length() {
    DecodeFrom coder(in_);
    return events_.hole_length(coder, 2);
  }
  std::uint64_t split_distance(std::uint64_t n) {
    DecodeFrom coder(in_);
    return events_.split_distance(coder, n, 2);
  }
  std::uint32_t join_curve(std::uint32_t waiting) {
    DecodeFrom coder(in_);
    return events_.join_curve(coder, waiting, 0);
  }
  std::uint32_t join_position(std::uint32_t n) {
    DecodeFrom coder(in_);
    return events_.join_position(coder, n, 0);
  }

  ConnectivityCounts counts;
  std::uint64_t closed_components = 0;

 private:
  rans::Decoder in_;
  SymbolModel symbols_;
  EventModel events_;
};

}  // namespace clers

#endif
