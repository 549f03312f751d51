// Which model codes the symbols of a surface: one byte of its header. Knows the models by name.
#ifndef CLERS_CODEC_SYMBOLS_SYMBOL_MODEL_H
#define CLERS_CODEC_SYMBOLS_SYMBOL_MODEL_H

#include <cstdint>
#include <optional>

#include "codec/symbols/context_models.h"

namespace clers::internal {

struct SymbolModel {
  enum class Kind : std::uint8_t {
    code = 0,        ///< PrefixCode: a few bits a symbol
    single = 1,      ///< SingleModel
    pair = 2,        ///< PairModel
    quick_pair = 3,  ///< PairModel, quick
    mixing = 4,      ///< MixingModel
  };
  Kind kind = Kind::code;
  unsigned history = 0;  ///< symbols that the context of the tabular ones holds, 1 .. 8; else 0

  constexpr bool has_history() const {
    return kind == Kind::single || kind == Kind::pair || kind == Kind::quick_pair;
  }
  constexpr std::uint8_t byte() const {
    return static_cast<std::uint8_t>(static_cast<unsigned>(kind) << 4 | history);
  }
  static constexpr std::optional<SymbolModel> of(std::uint32_t byte) {
    if (byte >> 4 > static_cast<unsigned>(Kind::mixing)) return std::nullopt;
    const SymbolModel m{static_cast<Kind>(byte >> 4), byte & 15};
    const bool good = m.has_history() ? m.history >= 1 && m.history <= ContextTables::max_history
                                      : m.history == 0;
    return good ? std::optional(m) : std::nullopt;
  }
};

}  // namespace clers::internal

#endif
