// Range asymmetric numeral systems: the entropy coder under all symbols (Duda, arXiv 1311.2540).
//
// State of 32 bits, 16-bit words, probabilities of 15 bits. Decoding reads what encoding wrote in
// opposite order, so the encoder collects intervals and writes them last first. Knows no model.
#ifndef CLERS_CODEC_ENTROPY_RANS_H
#define CLERS_CODEC_ENTROPY_RANS_H

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "codec/base/portable.h"

namespace clers::internal::rans {

inline constexpr unsigned scale_bits = 15;
inline constexpr std::uint32_t scale = 1u << scale_bits;
inline constexpr std::uint32_t low = 1u << 16;  ///< below it the state takes in a word, if any
inline constexpr std::uint32_t first_state = 1u << 8;  ///< of the encoder, and the decoder's last

/// The size of what a decision is given at most (coder.h); to divide by a constant is faster.
inline constexpr std::uint32_t most_certain = scale - 32;

/// The share [start, start + size) of `scale` that stands for what is coded. 0 < size < scale.
struct Interval {
  std::uint16_t start;
  std::uint16_t size;
};

/// What an interval costs, log2(scale / size), in 1/256 bits. A linear mantissa is near enough to
/// compare models by.
inline std::uint32_t cost(Interval interval) {
  const unsigned exponent = static_cast<unsigned>(std::bit_width(interval.size)) - 1;
  const std::uint32_t mantissa = (std::uint32_t(interval.size) << (15 - exponent)) - scale;
  return (15 - exponent) * 256 - (mantissa >> 7);
}

/// Collects intervals in the order in which they will be decoded.
class Encoder {
 public:
  void reserve(std::size_t n) { intervals_.reserve(n); }
  void put(Interval interval) { intervals_.push_back(interval); }
  void put(std::uint32_t start, std::uint32_t size) {
    put({static_cast<std::uint16_t>(start), static_cast<std::uint16_t>(size)});
  }

  const std::vector<Interval>& intervals() const { return intervals_; }

  /// Appends the stream: the state in as few bytes as it needs, lowest first, then the words. Cost:
  /// one division an interval.
  void finish(std::vector<std::byte>& out) const {
    std::vector<std::uint16_t> words;
    words.reserve(intervals_.size() / 8 + 16);
    std::uint32_t state = first_state;
    for (std::size_t i = intervals_.size(); i-- > 0;) {
      const Interval s = intervals_[i];
      if (state >= std::uint32_t(s.size) << (32 - scale_bits)) {
        words.push_back(static_cast<std::uint16_t>(state));
        state >>= 16;
      }
      // quotient * scale + remainder + start, with the least to do after the division
      const std::uint32_t quotient = s.size == most_certain ? state / most_certain : state / s.size;
      state = state + s.start + quotient * (scale - s.size);
    }
    out.reserve(out.size() + 4 + 2 * words.size());
    for (; state != 0; state >>= 8) out.push_back(static_cast<std::byte>(state));
    for (std::size_t i = words.size(); i-- > 0;) {
      out.push_back(static_cast<std::byte>(words[i]));
      out.push_back(static_cast<std::byte>(words[i] >> 8));
    }
  }

 private:
  std::vector<Interval> intervals_;
};

/// Reads a stream of known length. With no word left the state sinks below `low`: what is read of a
/// stream that ends too early is wrong, so callers bound their own loops and ask finished() once.
class Decoder {
 public:
  explicit Decoder(std::span<const std::byte> bytes)
      : next_(bytes.data()), end_(bytes.data() + bytes.size()) {
    // Where there are words the state is at least `low`: three bytes of it, or four.
    const std::size_t n = bytes.size();
    const std::size_t size = n <= 4 ? n : n % 2 != 0 ? 3 : 4;
    for (unsigned i = 0; i < size; ++i) state_ |= std::to_integer<std::uint32_t>(*next_++) << 8 * i;
    canonical_ = size > 0 && state_ >> 8 * (size - 1) != 0;
  }

  /// A place in [0, scale) within the next interval.
  std::uint32_t slot() const { return state_ & (scale - 1); }

  /// Goes past the interval that slot() is in.
  CLERS_ALWAYS_INLINE void advance(std::uint32_t start, std::uint32_t size) {
    state_ = size * (state_ >> scale_bits) + slot() - start;
    if (state_ < low && next_ != end_) state_ = state_ << 16 | word();
  }

  /// Everything was read and the state is the encoder's first: then no other stream decodes to the
  /// same.
  bool finished() const { return next_ == end_ && state_ == first_state && canonical_; }

 private:
  std::uint32_t word() {
    const std::uint32_t w =
        std::to_integer<std::uint32_t>(next_[0]) | std::to_integer<std::uint32_t>(next_[1]) << 8;
    next_ += 2;
    return w;
  }

  const std::byte* next_;
  const std::byte* end_;
  std::uint32_t state_ = 0;
  bool canonical_;
};

}  // namespace clers::internal::rans

#endif
