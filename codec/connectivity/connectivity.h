// The connectivity of one surface, as triangles, <-> bytes. codec/format.md describes the bytes.
#ifndef CLERS_CODEC_CONNECTIVITY_CONNECTIVITY_H
#define CLERS_CODEC_CONNECTIVITY_CONNECTIVITY_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "codec/connectivity/coded_surface.h"
#include "codec/connectivity/edgebreaker.h"
#include "codec/error.h"
#include "codec/symbols/symbol_model.h"
#include "topology/ids.h"

namespace clers::internal {

/// Counts that come with decoding or encoding.
struct ConnectivityCounts {
  std::array<std::uint64_t, 5> symbols = {};  ///< indexed by Clers
  std::uint64_t components = 0;
  std::uint64_t boundary_curves = 0;
  std::uint64_t coded_holes = 0;  ///< boundary curves less the first of each open component
  std::uint64_t handles = 0;      ///< genus
};

/// Counts indexed by Clers in the order of the word: C, L, E, R, S.
constexpr std::array<std::uint64_t, 5> in_word_order(const std::array<std::uint64_t, 5>& symbols) {
  const auto of = [&](Clers c) { return symbols[static_cast<unsigned>(c)]; };
  return {of(Clers::C), of(Clers::L), of(Clers::E), of(Clers::R), of(Clers::S)};
}

/// What encoding keeps of a surface for what is coded along it.
enum class Kept { nothing, corners, corners_and_twins };

struct EncodedConnectivity {
  std::vector<std::byte> bytes;
  std::vector<HalfEdge> gates;  ///< for each face in coded order: its half-edge that comes first
  std::vector<std::uint32_t> vertices;  ///< vertices[new] = old
  std::vector<std::uint32_t> corners;   ///< of the triangles in coded order, if they are kept: as
  std::vector<std::uint32_t> parts_of;  ///< Traversal says
  std::vector<HalfEdge> twins;          ///< of the triangles in coded order, if they are kept
  ConnectivityCounts counts;
  /// What holes and handles cost, the symbol S of each and all flags included, in 1/256 bits.
  std::uint64_t special_cost = 0;
};

/// Encodes a surface; its twins are consumed. Errors: nonmanifold_vertex (without saying which: to
/// look beforehand would cost every mesh a fifth of its time), out_of_memory. Cost: linear, and
/// O(log n) amortised for each handle.
Expected<EncodedConnectivity> encode_connectivity(SurfaceArrays surface, int level,
                                                  Kept kept = Kept::nothing);

/// The same bytes, with every operator run on a full surface too and the surface validated; `trace`
/// receives the operators of the unbuilding as the surface found them (OperatorTrace). Of polygons
/// these are the operators on their triangles, which must be unbuilt in the same way. Slow. Errors:
/// as above, and internal if the two do not agree.
Expected<EncodedConnectivity> encode_connectivity_on_surface(SurfaceArrays surface, int level,
                                                             std::vector<std::uint8_t>& trace);

/// What a decoder will find of a surface with so many vertices. Takes corners and twins, which must
/// be kept, out of `coded`. Cost: linear.
CodedArrays coded_surface(std::uint32_t vertex_count, EncodedConnectivity& coded);

/// Sizes at the front of encoded connectivity.
struct ConnectivityHeader {
  std::uint32_t faces = 0;
  std::uint32_t vertices = 0;  ///< all of them used by faces
  std::uint32_t merges = 0;    ///< room for vertices that S merges into others
  SymbolModel model;
  std::size_t symbol_bytes = 0;  ///< that a prefix code takes, before the stream
  std::size_t bytes = 0;         ///< that the header takes
};

/// What the header's byte says of the number of merges: 0, 1 .. 7, then steps of an eighth.
constexpr std::uint64_t room_for_merges(std::uint32_t code) {
  return code < 8 ? code : std::uint64_t(8 + code % 8) << (code / 8 - 1);
}

/// Reads and checks the sizes against the bytes, so that memory can be had for them.
/// `at` is the offset of `bytes` in the file, for errors. Errors: truncated, invalid.
Expected<ConnectivityHeader> read_connectivity_header(std::span<const std::byte> bytes,
                                                      std::uint64_t at);

/// Bytes that decoding takes at most, without the memory of the caller.
std::uint64_t connectivity_memory(const ConnectivityHeader& header, bool twins);

/// Decodes into memory of the caller: `corners` takes 3 indices a face, each below header.vertices.
/// `twins`, when not empty, takes the opposite half-edge of each, null on a boundary;
/// `introduced_by`, when not empty, header.vertices faces: those that introduce them. All three are
/// what CodedSurface says of a surface without copies. Unspecified after an error.
/// Errors: invalid, truncated, limit. Throws std::bad_alloc only.
Expected<ConnectivityCounts> decode_connectivity(std::span<const std::byte> bytes, std::uint64_t at,
                                                 const ConnectivityHeader& header,
                                                 std::span<std::uint32_t> corners,
                                                 std::span<HalfEdge> twins = {},
                                                 std::span<std::uint32_t> introduced_by = {});

}  // namespace clers::internal

#endif
