// Positions coded by a mix of experts: the smallest files, the slowest.
#ifndef CLERS_CODEC_ATTRIBUTES_MIXED_CODER_H
#define CLERS_CODEC_ATTRIBUTES_MIXED_CODER_H

#include <cstdint>
#include <span>

#include "codec/connectivity/coded_surface.h"
#include "codec/entropy/bytes.h"
#include "codec/error.h"
#include "codec/numbers/lattice.h"

namespace clers::internal {

/// The integers of a lattice with three axes. Precondition: they are what its axes allow.
template <class Int>
Bytes encode_mixed(const CodedSurface& surface, const Lattice<Int>& lattice);

/// Those integers again, into the rows of the lattice, from bytes at offset `at` in a file. Errors:
/// truncated, invalid.
template <class Int>
Expected<Done> decode_mixed(std::span<const std::byte> bytes, std::uint64_t at,
                            const CodedSurface& surface, const Lattice<Int>& lattice);

/// Bytes that decoding allocates beside what it is given.
std::uint64_t mixed_memory(std::uint64_t values, std::uint64_t triangles);

extern template Bytes encode_mixed(const CodedSurface&, const Lattice<std::int32_t>&);
extern template Bytes encode_mixed(const CodedSurface&, const Lattice<std::int64_t>&);
extern template Expected<Done> decode_mixed(std::span<const std::byte>, std::uint64_t,
                                            const CodedSurface&, const Lattice<std::int32_t>&);
extern template Expected<Done> decode_mixed(std::span<const std::byte>, std::uint64_t,
                                            const CodedSurface&, const Lattice<std::int64_t>&);

}  // namespace clers::internal

#endif
