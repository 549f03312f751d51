// Answers the questions of SpiraleReversi from a stream.
#ifndef CLERS_CODEC_CONNECTIVITY_STREAM_SOURCE_H
#define CLERS_CODEC_CONNECTIVITY_STREAM_SOURCE_H

#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

#include "codec/base/portable.h"
#include "codec/connectivity/connectivity.h"
#include "codec/connectivity/event_model.h"
#include "codec/entropy/coder.h"
#include "codec/entropy/rans.h"
#include "codec/symbols/context_models.h"
#include "codec/symbols/mixing_model.h"
#include "codec/symbols/prefix_code.h"
#include "codec/symbols/symbol.h"
#include "codec/symbols/symbol_model.h"

namespace clers::internal {

/// The decoder's side of codec/format.md, "Symbols" and "Answers".
template <class Model>
class StreamSource {
 public:
  static constexpr bool knows_vertices = false;

  /// `symbols` is what the model is made from.
  template <class... Symbols>
  explicit StreamSource(std::span<const std::byte> stream, Symbols... symbols)
      : in_(stream), symbols_(symbols...) {}

  bool ok() const { return symbols_.ok(); }
  void first() {
    ++counts.components;
    ++counts.symbols[static_cast<unsigned>(Clers::E)];
  }
  template <class Front, class Gate, class Then>
  CLERS_ALWAYS_INLINE auto symbol(const Front& front, const Gate& gate, std::size_t pending,
                                  Then then) {
    return symbols_.decode(in_, front, gate, pending, [&](auto symbol) CLERS_INLINE_LAMBDA {
      ++counts.symbols[static_cast<unsigned>(symbol())];
      return then(symbol);
    });
  }
  bool finished() const {
    if constexpr (std::is_same_v<Model, PrefixCode>)
      return symbols_.finished() && in_.finished();
    else
      return in_.finished();
  }

  bool new_component(bool two_edges) {
    DecodeFrom coder(in_);
    const bool value = events_.new_component(coder, two_edges, false);
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
  SpecialS kind(bool any_waiting) {
    DecodeFrom coder(in_);
    const SpecialS kind = events_.kind(coder, any_waiting, SpecialS::hole);
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
  Model symbols_;
  EventModel events_;
};

/// use(source) with the source that the header of connectivity asks for; `bytes` are all of it.
template <class Use>
auto with_stream_source(const ConnectivityHeader& header, std::span<const std::byte> bytes,
                        Use use) {
  const auto stream = bytes.subspan(header.bytes);
  const SymbolModel model = header.model;
  switch (model.kind) {
    case SymbolModel::Kind::single: {
      StreamSource<SingleModel> source(stream, model.history);
      return use(source);
    }
    case SymbolModel::Kind::pair:
    case SymbolModel::Kind::quick_pair: {
      StreamSource<PairModel> source(stream, model.history,
                                     model.kind == SymbolModel::Kind::quick_pair);
      return use(source);
    }
    case SymbolModel::Kind::mixing: {
      StreamSource<MixingModel> source(stream, std::size_t(header.faces),
                                       std::size_t(header.vertices) + header.merges);
      return use(source);
    }
    default: {
      StreamSource<PrefixCode> source(stream.subspan(header.symbol_bytes),
                                      stream.first(header.symbol_bytes));
      return use(source);
    }
  }
}

}  // namespace clers::internal

#endif
