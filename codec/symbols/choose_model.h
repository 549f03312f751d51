// Which model suits the symbols of a mesh, by trying. Knows symbols with their contexts, and no
// surface.
#ifndef CLERS_CODEC_SYMBOLS_CHOOSE_MODEL_H
#define CLERS_CODEC_SYMBOLS_CHOOSE_MODEL_H

#include <cstdint>
#include <vector>

#include "codec/symbols/symbol_model.h"

namespace clers::internal {

/// The model of a level that codes these symbols (DecodeScript::contexts) in the fewest bits, as
/// far as a sample shows. Throws std::bad_alloc only. Cost: at most 2^15 symbols, three times.
SymbolModel choose_model(const std::vector<std::uint8_t>& contexts, int level);

}  // namespace clers::internal

#endif
