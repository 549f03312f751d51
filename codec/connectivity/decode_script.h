// What the stream says, symbols and events, for a decoder to build a surface that Edgebreaker has
// unbuilt.
#ifndef CLERS_CODEC_CONNECTIVITY_DECODE_SCRIPT_H
#define CLERS_CODEC_CONNECTIVITY_DECODE_SCRIPT_H

#include <array>
#include <cstdint>
#include <vector>

#include "codec/connectivity/edgebreaker.h"

namespace clers::internal {

/// What the stream carries besides symbols, in the order of decoding.
struct Event {
  enum class Kind : std::uint8_t { new_component, closed, special, hole, split, join };
  std::uint32_t symbol;  ///< comes after this one, counted in the order of decoding
  Kind kind;
  bool value = false;      ///< new_component, closed, special
  bool two_edges = false;  ///< new_component
  /// hole: its edges. split: edges back from the gate. join: edges back from the vertex of the
  /// split.
  std::uint32_t distance = 0;
  std::uint32_t length = 0;   ///< split, join: edges of the curve that distance is counted on
  std::uint32_t recency = 0;  ///< join: how many curves wait that were split off later
  bool operator==(const Event&) const = default;
};

/// What the stream carries, and what a decoder will know then.
struct DecodeScript {
  std::vector<std::uint8_t> contexts;  ///< valence << 3 | symbol, in the order of decoding
  std::vector<Event> events;
  std::array<std::uint64_t, 5> symbols = {};  ///< how many, by Clers
  std::vector<std::uint32_t> vertices;        ///< vertices[new] = old
};

/// The script of a traversal with its handles placed (place_handles.h), whose contexts and vertices
/// move into it. Cost: linear.
DecodeScript script_of(Traversal& traversal);

}  // namespace clers::internal

#endif
