// Range asymmetric numeral systems: the entropy coder under all symbols (Duda, arXiv 1311.2540).
//
// State of 32 bits, 16-bit words, probabilities of 15 bits. Decoding reads what encoding wrote in
// opposite order, so the encoder collects intervals and writes them last first.
#ifndef CLERS_CODEC_RANS_H
#define CLERS_CODEC_RANS_H

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace clers::rans {

inline constexpr unsigned scale_bits = 15;
inline constexpr std::uint32_t scale = 1u << scale_bits;
inline constexpr std::uint32_t low = 1u << 16;  ///< state of an empty coder; never below

/// The share [start, start + size) of `scale` that stands for what is coded. 0 < size < scale.
struct Interval {
  std::uint16_t start;
  std::uint16_t size;
};

/// Collects intervals in the order in which they will be decoded.
class Encoder {
 public:
  void reserve(std::size_t n) { intervals_.reserve(n); }
  void put(Interval interval) { intervals_.push_back(interval); }
  void put(std::uint32_t start, std::uint32_t size) {
    put({static_cast<std::uint16_t>(start), static_cast<std::uint16_t>(size)});
  }

  const std::vector<Interval>& intervals() const { return intervals_; }

  /// Appends the stream: the state, then the words. Cost: one division an interval.
  void finish(std::vector<std::byte>& out) const {
    std::vector<std::uint16_t> words;
    words.reserve(intervals_.size() / 8 + 16);
    std::uint32_t state = low;
    for (std::size_t i = intervals_.size(); i-- > 0;) {
      const Interval s = intervals_[i];
      if (state >= std::uint32_t(s.size) << (32 - scale_bits)) {
        words.push_back(static_cast<std::uint16_t>(state));
        state >>= 16;
      }
      const std::uint32_t quotient = state / s.size;
      state = (quotient << scale_bits) + (state - quotient * s.size) + s.start;
    }
    const std::size_t old = out.size();
    out.resize(old + 4 + 2 * words.size());
    std::byte* p = out.data() + old;
    for (unsigned shift = 0; shift < 32; shift += 8) *p++ = static_cast<std::byte>(state >> shift);
    for (std::size_t i = words.size(); i-- > 0;) {
      *p++ = static_cast<std::byte>(words[i]);
      *p++ = static_cast<std::byte>(words[i] >> 8);
    }
  }

 private:
  std::vector<Interval> intervals_;
};

/// Reads a stream of known length. Past its end it reads zeros and remembers: callers bound their
/// own loops and ask finished() once.
class Decoder {
 public:
  explicit Decoder(std::span<const std::byte> bytes)
      : next_(bytes.data()), end_(bytes.data() + bytes.size()) {
    if (bytes.size() < 4 || bytes.size() % 2 != 0) {
      next_ = end_;
      overrun_ = 1;
      return;
    }
    state_ = word() | std::uint32_t(word()) << 16;
  }

  /// Where in [0, scale) the next interval lies.
  std::uint32_t slot() const { return state_ & (scale - 1); }

  /// Goes past the interval that slot() lies in.
  void advance(std::uint32_t start, std::uint32_t size) {
    state_ = size * (state_ >> scale_bits) + slot() - start;
    if (state_ < low) state_ = state_ << 16 | word();
  }

  /// Everything was read and the state is the encoder's first: a wrong stream passes by chance
  /// only.
  bool finished() const { return next_ == end_ && overrun_ == 0 && state_ == low; }
  bool overrun() const { return overrun_ != 0; }

 private:
  std::uint32_t word() {
    if (next_ == end_) {
      overrun_ = 1;
      return 0;
    }
    const std::uint32_t w =
        std::to_integer<std::uint32_t>(next_[0]) | std::to_integer<std::uint32_t>(next_[1]) << 8;
    next_ += 2;
    return w;
  }

  const std::byte* next_;
  const std::byte* end_;
  std::uint32_t state_ = low;
  std::uint32_t overrun_ = 0;
};

}  // namespace clers::rans

#endif
