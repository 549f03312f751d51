// Decisions and numbers with adaptive probabilities, on rANS.
//
// Each is written once, for a Coder that either encodes the value it is given or ignores it and
// decodes one, so that the two directions cannot drift apart. Knows no mesh.
#ifndef CLERS_CODEC_ENTROPY_CODER_H
#define CLERS_CODEC_ENTROPY_CODER_H

#include <algorithm>
#include <bit>
#include <cstdint>

#include "codec/entropy/rans.h"

namespace clers::internal {

/// Adaptive probability of one decision.
class BitModel {
 public:
  /// Share of rans::scale for `true`, 32 .. scale - 32.
  std::uint32_t share() const { return std::clamp(p_ >> 1, 32u, rans::scale - 32); }
  void update(bool bit) {
    const int rate = int(std::bit_width(seen_ + 2u)) - 1;
    seen_ = static_cast<std::uint16_t>(seen_ + (seen_ < 62));
    if (bit)
      p_ += (65535 - p_) >> rate;
    else
      p_ -= p_ >> rate;
  }

 private:
  std::uint32_t p_ = 1u << 15;
  std::uint16_t seen_ = 0;
};

/// Coder that writes.
class EncodeTo {
 public:
  static constexpr bool encodes = true;
  explicit EncodeTo(rans::Encoder& out) : out_(&out) {}
  [[gnu::always_inline]] bool bit(BitModel& model, bool value) {
    decide(model.share(), value);
    model.update(value);
    return value;
  }
  /// A decision whose answer yes has the given share of rans::scale, neither none nor all of it.
  bool decide(std::uint32_t share, bool value) {
    value ? out_->put(0, share) : out_->put(share, rans::scale - share);
    return value;
  }
  /// One of 2^n equally likely values, n <= 14.
  std::uint32_t raw(unsigned n, std::uint32_t value) {
    if (n) out_->put(value << (rans::scale_bits - n), 1u << (rans::scale_bits - n));
    return value;
  }

 private:
  rans::Encoder* out_;
};

/// Coder that reads; the values given to it are ignored.
class DecodeFrom {
 public:
  static constexpr bool encodes = false;
  explicit DecodeFrom(rans::Decoder& in) : in_(&in) {}
  bool bit(BitModel& model, bool) {
    const bool value = decide(model.share(), false);
    model.update(value);
    return value;
  }
  bool decide(std::uint32_t share, bool) {
    const bool value = in_->slot() < share;
    value ? in_->advance(0, share) : in_->advance(share, rans::scale - share);
    return value;
  }
  std::uint32_t raw(unsigned n, std::uint32_t) {
    if (n == 0) return 0;
    const std::uint32_t value = in_->slot() >> (rans::scale_bits - n);
    in_->advance(value << (rans::scale_bits - n), 1u << (rans::scale_bits - n));
    return value;
  }

 private:
  rans::Decoder* in_;
};

/// Raw bits of any number up to 32.
template <class Coder>
std::uint32_t code_bits(Coder& coder, unsigned n, std::uint32_t value) {
  std::uint32_t result = 0;
  while (n > 0) {
    const unsigned part = std::min(n, 14u);
    n -= part;
    result |= coder.raw(part, value >> n & ((1u << part) - 1)) << n;
  }
  return result;
}

/// Any 32-bit number, small ones cheap: Exp-Golomb with adaptive length and adaptive top bits.
class NumberModel {
 public:
  template <class Coder>
  std::uint32_t code(Coder& coder, std::uint32_t value) {
    const std::uint64_t v = std::uint64_t(value) + 1;
    const unsigned length = static_cast<unsigned>(std::bit_width(v)) - 1;  // v = 1 .. : 0 .. 32
    unsigned l = 0;
    while (l < 32 && coder.bit(longer_[l], l < length)) ++l;
    if (l == 0) return 0;
    // v = 1 b r..r: b in context of the length, the rest raw.
    const bool top = coder.bit(top_[l], (v >> (l - 1)) & 1);
    const unsigned rest = l - 1;
    const std::uint64_t low_mask = (std::uint64_t(1) << rest) - 1;
    const std::uint32_t r = code_bits(coder, rest, static_cast<std::uint32_t>(v & low_mask));
    return static_cast<std::uint32_t>(((std::uint64_t(2) | top) << rest | r) - 1);
  }

 private:
  BitModel longer_[33];
  BitModel top_[33];
};

/// A number by its distance from another, modulo 2^32; near ones on both sides are cheap.
template <class Coder>
std::uint32_t code_from(Coder& coder, NumberModel& model, std::uint32_t from, std::uint32_t value) {
  const std::uint32_t d = value - from;
  const std::uint32_t z = model.code(coder, d << 1 ^ (0u - (d >> 31)));
  return from + (z >> 1 ^ (0u - (z & 1)));
}

/// One of n equally likely values, n >= 1: the top by a division of the scale, the rest raw.
/// Decoding may return a value >= n for streams that no encoder makes.
template <class Coder>
std::uint32_t code_uniform(Coder& coder, std::uint32_t n, std::uint32_t value) {
  // Truncated binary: with 2^b <= n < 2^(b+1), values below 2^(b+1) - n take b bits, others b+1.
  const unsigned b = static_cast<unsigned>(std::bit_width(n)) - 1;
  const std::uint32_t shorter = static_cast<std::uint32_t>((std::uint64_t(2) << b) - n);
  const bool is_short = value < shorter;
  std::uint32_t head = code_bits(coder, b, is_short ? value : (value + shorter) >> 1);
  if (head < shorter) return head;
  return (head << 1 | coder.raw(1, (value + shorter) & 1)) - shorter;
}

}  // namespace clers::internal

#endif
