// Bits that are written last first and read first to last: what a coder needs that encodes a
// sequence from its end, as asymmetric numeral systems do. Knows no coder.
#ifndef CLERS_CODEC_ENTROPY_REVERSED_BITS_H
#define CLERS_CODEC_ENTROPY_REVERSED_BITS_H

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

#include "codec/base/portable.h"
#include "codec/entropy/bytes.h"

namespace clers::internal {

/// Eight bytes as a number, lowest first.
CLERS_ALWAYS_INLINE std::uint64_t load_eight(const std::byte* p) {
  std::uint64_t v = 0;
  if constexpr (std::endian::native == std::endian::little)
    std::memcpy(&v, p, 8);
  else
    for (unsigned i = 0; i < 8; ++i) v |= std::to_integer<std::uint64_t>(p[i]) << 8 * i;
  return v;
}
CLERS_ALWAYS_INLINE void store_eight(std::byte* p, std::uint64_t v) {
  if constexpr (std::endian::native == std::endian::little)
    std::memcpy(p, &v, 8);
  else
    for (unsigned i = 0; i < 8; ++i) p[i] = static_cast<std::byte>(v >> 8 * i & 0xff);
}

/// The lowest n bits of v, n < 64. To look the mask up is faster than to make it.
CLERS_ALWAYS_INLINE std::uint64_t low_bits(std::uint64_t v, unsigned n) {
  static constexpr std::array<std::uint64_t, 64> masks = [] {
    std::array<std::uint64_t, 64> all{};
    for (unsigned i = 0; i < 64; ++i) all[i] = (std::uint64_t(1) << i) - 1;
    return all;
  }();
  return v & masks[n];
}

/// Writes from the end of memory towards the beginning: each number before those that were put
/// already, the first bits of the stream lowest.
class ReversedBitWriter {
 public:
  ReversedBitWriter() = default;
  explicit ReversedBitWriter(std::span<std::byte> memory)
      : next_(memory.data() + memory.size()), end_(next_) {}
  /// The memory that it takes to write so many bits.
  static std::size_t room(std::uint64_t bits) { return static_cast<std::size_t>(bits / 8 + 16); }

  /// Precondition: value < 2^n, n <= 56.
  CLERS_ALWAYS_INLINE void put(std::uint64_t value, unsigned n) {
    bits_ = bits_ << n | value;
    count_ += n;
    const std::uint64_t highest_first = bits_ << 1 << (63 - count_);
    store_eight(next_ - 8, highest_first);
    next_ -= count_ >> 3;
    count_ &= 7;
  }

  /// All that was put. What the first byte has left holds a one above zeros.
  std::span<const std::byte> finish() {
    const unsigned zeros = 7 - count_;
    put(std::uint64_t(1) << zeros, zeros + 1);
    return {next_, end_};
  }

 private:
  std::byte* next_ = nullptr;
  std::byte* end_ = nullptr;
  std::uint64_t bits_ = 0;
  unsigned count_ = 0;  ///< of bits_ that are not in memory yet, 0 .. 7
};

/// Reads what ReversedBitWriter wrote, and zeros behind it. All that it knows of its place is a
/// number of bits: to go on takes one addition.
class ReversedBitReader {
 public:
  ReversedBitReader() = default;
  explicit ReversedBitReader(std::span<const std::byte> bytes) : bytes_(bytes) {
    const unsigned head = bytes.empty() ? 0 : std::to_integer<unsigned>(bytes[0]);
    place_ = head == 0 ? ~std::uint64_t(0) >> 8  // never the end
                       : static_cast<unsigned>(std::countr_zero(head)) + 1;
  }

  /// The next bits, lowest first: 57 at least.
  std::uint64_t window() const {
    std::uint64_t window = 0;
    for (unsigned i = 0; i < 8 && place_ / 8 + i < bytes_.size(); ++i)
      window |= std::to_integer<std::uint64_t>(bytes_[static_cast<std::size_t>(place_ / 8) + i])
                << 8 * i;
    return window >> (place_ & 7);
  }
  /// The same, where there are as many.
  CLERS_ALWAYS_INLINE std::uint64_t window_within() const {
    return load_eight(bytes_.data() + static_cast<std::size_t>(place_ >> 3)) >> (place_ & 7);
  }
  /// How many bits can be taken such that window_within may be called before each of them.
  std::uint64_t within() const {
    const std::uint64_t bits = 8 * std::uint64_t(bytes_.size());
    return bits > place_ + 64 ? bits - place_ - 64 : 0;
  }
  CLERS_ALWAYS_INLINE void take(unsigned n) { place_ += n; }

  /// Everything was read and nothing behind it.
  bool finished() const { return place_ == 8 * std::uint64_t(bytes_.size()); }

 private:
  std::span<const std::byte> bytes_;
  std::uint64_t place_ = 0;
};

}  // namespace clers::internal

#endif
