// Plain bits, lowest of a byte first: what is noise needs no model. Written and read as a coder of
// raw bits (coder.h), so that the same code can write to either.
#ifndef CLERS_CODEC_ENTROPY_BITS_H
#define CLERS_CODEC_ENTROPY_BITS_H

#include <cstddef>
#include <cstdint>
#include <span>

#include "codec/base/portable.h"
#include "codec/entropy/bytes.h"

namespace clers::internal {

/// Coder that writes.
class BitsTo {
 public:
  static constexpr bool encodes = true;
  explicit BitsTo(Bytes& out) : out_(&out) {}
  /// The n lowest bits of value, n <= 32.
  std::uint32_t raw(unsigned n, std::uint32_t value) {
    bits_ |= std::uint64_t(value) << count_;
    for (count_ += n; count_ >= 8; count_ -= 8, bits_ >>= 8)
      put_u8(*out_, static_cast<std::uint32_t>(bits_ & 0xff));
    return value;
  }
  void finish() {
    if (count_ > 0) put_u8(*out_, static_cast<std::uint32_t>(bits_));
    count_ = 0;
    bits_ = 0;
  }

 private:
  Bytes* out_;
  std::uint64_t bits_ = 0;
  unsigned count_ = 0;
};

/// Coder that reads. Past the end it reads zeros, and finished() is false.
class BitsFrom {
 public:
  static constexpr bool encodes = false;
  explicit BitsFrom(std::span<const std::byte> bytes)
      : next_(bytes.data()), end_(bytes.data() + bytes.size()) {}
  CLERS_ALWAYS_INLINE std::uint32_t raw(unsigned n, std::uint32_t) {
    if (left_ < 32) refill();
    const auto value = static_cast<std::uint32_t>(bits_ & ((std::uint64_t(1) << n) - 1));
    bits_ >>= n;
    left_ -= static_cast<int>(n);
    return value;
  }

  /// Everything was read, and what is left of the last byte is zero.
  bool finished() const { return next_ == end_ && left_ >= 0 && left_ < 8 && bits_ == 0; }

 private:
  void refill() {
    if (end_ - next_ >= 4) {
      std::uint32_t word = 0;
      for (unsigned i = 0; i < 4; ++i) word |= std::to_integer<std::uint32_t>(next_[i]) << 8 * i;
      bits_ |= std::uint64_t(word) << left_;
      left_ += 32;
      next_ += 4;
    } else {
      slow_refill();
    }
  }
  CLERS_NEVER_INLINE void slow_refill() {
    if (left_ < 0) {  // behind the end already
      left_ = -1;
      return;
    }
    for (; next_ != end_; ++next_, left_ += 8)
      bits_ |= std::to_integer<std::uint64_t>(*next_) << left_;
  }

  const std::byte* next_;
  const std::byte* end_;
  std::uint64_t bits_ = 0;
  int left_ = 0;  ///< bits that are not read yet; below zero behind the end
};

}  // namespace clers::internal

#endif
