// Symbols and events -> the bytes that follow the header of connectivity. Knows the script, no
// surface.
#ifndef CLERS_CODEC_CONNECTIVITY_SYMBOL_ENCODER_H
#define CLERS_CODEC_CONNECTIVITY_SYMBOL_ENCODER_H

#include <cstddef>
#include <cstdint>

#include "codec/connectivity/decode_script.h"
#include "codec/entropy/bytes.h"
#include "codec/symbols/symbol_model.h"

namespace clers::internal {

struct CodedSymbols {
  SymbolModel model;
  Bytes bytes;
  std::uint64_t handles = 0, holes = 0, closed_components = 0;
  std::uint64_t special_cost = 0;  ///< as in EncodedConnectivity
};

/// Encodes with the model of a level, or of a lower one where that takes fewer bytes: the more a
/// model has to learn, the less it pays where there is little to learn from, or little to say. So
/// no level is larger than those below. To look costs half as much again, and is done where it may
/// matter. `ids`: vertices that a decoder makes. Throws std::bad_alloc.
CodedSymbols encode_briefly(const DecodeScript& script, int level, std::size_t ids);

}  // namespace clers::internal

#endif
