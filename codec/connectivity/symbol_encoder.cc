// Symbols and events by a model of symbols/.
#include "codec/connectivity/symbol_encoder.h"

#include <algorithm>
#include <vector>

#include "codec/connectivity/event_writer.h"
#include "codec/connectivity/spirale_reversi.h"
#include "codec/entropy/rans.h"
#include "codec/symbols/choose_model.h"
#include "codec/symbols/context_models.h"
#include "codec/symbols/mixing_model.h"
#include "codec/symbols/prefix_code.h"

namespace clers::internal {
namespace {

/// Writes symbols and events while the surface is built once more, with all that the decoder will
/// know of it.
class EncodingSource : public EventWriter {
 public:
  EncodingSource(const DecodeScript& script, std::size_t ids, rans::Encoder& out)
      : EventWriter(script.events, out),
        contexts_(script.contexts),
        coder_(out),
        model_(contexts_.size(), ids) {}

  void first() { ++next_; }
  template <class Front, class Gate, class Then>
  auto symbol(const Front& front, const Gate& gate, std::size_t pending, Then then) {
    symbol_begins();
    const Clers symbol = static_cast<Clers>(contexts_[next_++] & 7);
    model_.code(coder_, front, gate, pending, symbol);
    return with_symbol(symbol, then);
  }

 private:
  const std::vector<std::uint8_t>& contexts_;
  std::size_t next_ = 0;
  EncodeTo coder_;
  MixingModel model_;
};

/// Encodes the symbols and events with a model.
CodedSymbols encode_symbols(SymbolModel model, const DecodeScript& script, std::size_t ids) {
  CodedSymbols coded;
  coded.model = model;
  rans::Encoder stream;
  const auto finish = [&](const EventWriter& events) {
    coded.handles = events.handles;
    coded.holes = events.holes;
    coded.closed_components = events.closed_components;
    coded.special_cost = events.special_cost;
    stream.finish(coded.bytes);
  };
  const std::uint32_t faces = static_cast<std::uint32_t>(script.contexts.size());
  if (model.kind == SymbolModel::Kind::mixing) {
    std::vector<std::uint32_t> corners(3 * faces);
    std::vector<FrontLink> links(ids);
    Building building;
    building.corners = corners;
    building.links = links;
    NoPairing none;
    EncodingSource source(script, ids, stream);
    SpiraleReversi<NoPairing, EncodingSource>(building, none, source).run();
    finish(source);
    return coded;
  }
  EventWriter events(script.events, stream);
  // put(symbol, valence) for each, and the events where they are asked for.
  const auto put_all = [&](auto put) {
    const std::uint8_t* const contexts = script.contexts.data();
    const auto put_at = [&](std::uint32_t i) {
      if (i > 0) put(static_cast<Clers>(contexts[i] & 7), contexts[i] >> 3);
    };
    for (std::uint32_t i = 0;; ++i) {
      for (const std::uint32_t next = std::min(events.next_symbol(), faces); i < next; ++i)
        put_at(i);
      if (i == faces) break;
      events.symbol_begins();
      put_at(i);
      events.write_after(i);
    }
  };
  const auto encode_with = [&](auto symbols) {
    if (!symbols.ok()) throw std::bad_alloc();
    stream.reserve(faces + 4 * script.events.size());
    put_all([&](Clers symbol, std::uint32_t kx) { stream.put(symbols.encode(symbol, kx)); });
  };
  switch (model.kind) {
    case SymbolModel::Kind::single: encode_with(SingleModel(model.history)); break;
    case SymbolModel::Kind::code: {
      SymbolWriter symbols(faces);
      put_all([&](Clers symbol, std::uint32_t) { symbols.put(symbol); });
      const Bytes code = symbols.finish();
      put_varint(coded.bytes, code.size());
      put_bytes(coded.bytes, code);
      break;
    }
    default:
      encode_with(PairModel(model.history, model.kind == SymbolModel::Kind::quick_pair));
      break;
  }
  finish(events);
  if (model.kind == SymbolModel::Kind::code)  // the symbols S, 4 bits each
    coded.special_cost += 4 * 256 * (coded.holes + 2 * coded.handles);
  return coded;
}

}  // namespace

CodedSymbols encode_briefly(const DecodeScript& script, int level, std::size_t ids) {
  using Kind = SymbolModel::Kind;
  const SymbolModel model = choose_model(script.contexts, level);
  CodedSymbols coded = encode_symbols(model, script, ids);
  const std::size_t size = coded.bytes.size();
  const bool little =
      size > 96 && size < std::min<std::size_t>(512, script.contexts.size() * 3 / 64);
  if (model.kind == Kind::mixing || (level >= 5 && little)) {
    CodedSymbols simpler = encode_briefly(script, model.kind == Kind::mixing ? 5 : 3, ids);
    if (simpler.bytes.size() < coded.bytes.size()) return simpler;
  }
  return coded;
}

}  // namespace clers::internal
