// Symbols on three rANS states that share one string of words, with raw bits apart: what is coded
// component by component, without one waiting for the other. Knows no model.
//
// As rans.h, but shares are of 2^14 and states begin at `low`.
#ifndef CLERS_CODEC_ENTROPY_LANES_H
#define CLERS_CODEC_ENTROPY_LANES_H

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "codec/base/portable.h"
#include "codec/entropy/bytes.h"
#include "codec/entropy/coder.h"
#include "codec/entropy/distribution.h"
#include "codec/entropy/rans.h"

namespace clers::internal {

inline constexpr unsigned lane_count = 3;

/// Coder that writes; `finish` has the bytes.
class LaneEncoder {
 public:
  static constexpr bool encodes = true;

  /// A symbol in a distribution, which learns it.
  CLERS_ALWAYS_INLINE unsigned symbol(unsigned lane, Distribution& x, unsigned s) {
    put(lane, x.starts(), s);
    x.update(s);
    return s;
  }

  /// A symbol of shares that the caller has.
  CLERS_ALWAYS_INLINE unsigned symbol(unsigned lane, const Starts& starts, unsigned s) {
    put(lane, starts, s);
    return s;
  }

  /// A decision among the symbols of a lane.
  bool flag(unsigned lane, BitModel& model, bool value) {
    const std::uint32_t share = model.share() >> (rans::scale_bits - share_bits);
    value ? put(lane, 0, share) : put(lane, share, shares - share);
    model.update(value);
    return value;
  }

  /// n raw bits, n < 64.
  void bits(unsigned n, std::uint64_t value) {
    for (; n > 32; n -= 32, value >>= 32) bits(32, value & 0xffffffffu);
    buffer_ |= value << held_;
    for (held_ += n; held_ >= 8; held_ -= 8) {
      raw_.push_back(static_cast<std::byte>(buffer_));
      buffer_ >>= 8;
    }
  }

  /// n equally likely bits among the symbols of a lane, n <= 63.
  std::uint64_t even(unsigned lane, unsigned n, std::uint64_t value) {
    for (unsigned done = 0; done < n; done += 12) {
      const unsigned part = std::min(n - done, 12u);
      const std::uint32_t v = static_cast<std::uint32_t>(value >> done) & ((1u << part) - 1);
      put(lane, v << (share_bits - part), 1u << (share_bits - part));
    }
    return value;
  }

  void put(unsigned lane, std::uint32_t start, std::uint32_t size) {
    intervals_.push_back(lane << 28 | size << 14 | start);
  }

  void put(unsigned lane, const Starts& starts, unsigned s) {
    put(lane, starts.at[s], std::uint32_t(starts.at[s + 1]) - starts.at[s]);
  }

  /// Appends the size of the raw bits, the bits, the states, the words.
  void finish(Bytes& out) {
    if (held_ > 0) raw_.push_back(static_cast<std::byte>(buffer_));
    std::array<std::uint32_t, lane_count> state;
    state.fill(low);
    std::vector<std::uint16_t> words;
    words.reserve(intervals_.size() / 4 + 16);
    for (std::size_t i = intervals_.size(); i-- > 0;) {
      const std::uint32_t start = intervals_[i] & (shares - 1),
                          size = intervals_[i] >> 14 & (shares - 1);
      std::uint32_t& x = state[intervals_[i] >> 28];
      if (x >= size << (32 - share_bits)) {
        words.push_back(static_cast<std::uint16_t>(x));
        x >>= 16;
      }
      x = x + start + x / size * (shares - size);
    }
    put_varint(out, raw_.size());
    put_bytes(out, raw_);
    for (const std::uint32_t x : state) put_u32(out, x);
    out.reserve(out.size() + 2 * words.size());
    for (std::size_t i = words.size(); i-- > 0;) {
      out.push_back(static_cast<std::byte>(words[i]));
      out.push_back(static_cast<std::byte>(words[i] >> 8));
    }
  }

 private:
  friend class LaneDecoder;
  static constexpr std::uint32_t low = 1u << 16;

  std::vector<std::uint32_t> intervals_;
  Bytes raw_;
  std::uint64_t buffer_ = 0;
  unsigned held_ = 0;
};

/// Coder that reads; the values given to it are ignored. Where the bytes end too early it goes on
/// with zeros: callers bound their loops and ask finished() once.
class LaneDecoder {
 public:
  static constexpr bool encodes = false;

  /// All that is left in `in`.
  explicit LaneDecoder(ByteReader& in) {
    raw_ = in.take(in.varint());
    for (std::uint32_t& x : state_) x = in.u32();
    words_ = in.take(in.left() & ~std::size_t(1));
    valid_ = in.ok() && in.left() == 0;
    for (const std::uint32_t x : state_) valid_ = valid_ && x >= LaneEncoder::low;
    next_ = words_.data();
    end_ = next_ + words_.size();
  }

  CLERS_ALWAYS_INLINE unsigned symbol(unsigned lane, Distribution& x, unsigned) {
    const unsigned s = symbol(lane, x.starts(), 0);
    x.update(s);
    return s;
  }
  CLERS_ALWAYS_INLINE unsigned symbol(unsigned lane, const Starts& starts, unsigned) {
    const unsigned s = starts.find(state_[lane] & (shares - 1));
    advance(lane, starts.at[s], std::uint32_t(starts.at[s + 1]) - starts.at[s]);
    return s;
  }

  bool flag(unsigned lane, BitModel& model, bool) {
    const std::uint32_t share = model.share() >> (rans::scale_bits - share_bits);
    const bool value = (state_[lane] & (shares - 1)) < share;
    value ? advance(lane, 0, share) : advance(lane, share, shares - share);
    model.update(value);
    return value;
  }

  std::uint64_t even(unsigned lane, unsigned n, std::uint64_t) {
    std::uint64_t value = 0;
    for (unsigned done = 0; done < n; done += 12) {
      const unsigned part = std::min(n - done, 12u);
      const std::uint32_t v = (state_[lane] & (shares - 1)) >> (share_bits - part);
      advance(lane, v << (share_bits - part), 1u << (share_bits - part));
      value |= std::uint64_t(v) << done;
    }
    return value;
  }

  /// Three numbers of raw bits, one after the other.
  CLERS_ALWAYS_INLINE std::array<std::uint64_t, 3> bits(unsigned x, unsigned y, unsigned z) {
    if (x + y + z > 56) [[unlikely]]
      return {long_bits(x), long_bits(y), long_bits(z)};
    const std::uint64_t all = short_bits(x + y + z), rest = all >> x;
    return {all & ((std::uint64_t(1) << x) - 1), rest & ((std::uint64_t(1) << y) - 1), rest >> y};
  }

  /// Everything was read and the states are the encoder's first: then no other bytes decode to the
  /// same.
  bool finished() const {
    bool yes =
        valid_ && !beyond_ && next_ == end_ && buffer_ == 0 && read_ == raw_.size() && held_ < 8;
    for (const std::uint32_t x : state_) yes = yes && x == LaneEncoder::low;
    return yes;
  }

 private:
  CLERS_ALWAYS_INLINE void advance(unsigned lane, std::uint32_t start, std::uint32_t size) {
    std::uint32_t x = state_[lane];
    x = size * (x >> share_bits) + (x & (shares - 1)) - start;
    if (next_ == end_) [[unlikely]] {
      beyond_ |= x < LaneEncoder::low;
      state_[lane] = x < LaneEncoder::low ? x << 16 : x;
      return;
    }
    // Without a branch, which would go either way: a word is loaded, and used or not.
    const std::uint32_t word =
        std::to_integer<std::uint32_t>(next_[0]) | std::to_integer<std::uint32_t>(next_[1]) << 8;
    const std::uint32_t wanted = 0u - (x < LaneEncoder::low);
    state_[lane] = x << (wanted & 16) | (word & wanted);
    next_ += wanted & 2;
  }

  /// n <= 56.
  CLERS_ALWAYS_INLINE std::uint64_t short_bits(unsigned n) {
    if (held_ < n) refill(n);
    const std::uint64_t value = buffer_ & ((std::uint64_t(1) << n) - 1);
    buffer_ >>= n;
    held_ -= n;
    return value;
  }
  /// n < 64.
  std::uint64_t long_bits(unsigned n) {
    std::uint64_t value = 0;
    unsigned done = 0;
    for (; n - done > 32; done += 32) value |= short_bits(32) << done;
    return value | short_bits(n - done) << done;
  }
  /// At least n bits are held then, n <= 56.
  void refill(unsigned n) {
    if (raw_.size() - read_ >= 8) {
      std::uint64_t word = 0;
      for (unsigned i = 0; i < 8; ++i)
        word |= std::to_integer<std::uint64_t>(raw_[read_ + i]) << 8 * i;
      const unsigned bytes = (63 - held_) / 8;
      word &= ~std::uint64_t(0) >> (64 - 8 * bytes);
      buffer_ |= word << held_;
      read_ += bytes;
      held_ += 8 * bytes;
      return;
    }
    for (; held_ <= 56 && read_ < raw_.size(); held_ += 8)
      buffer_ |= std::to_integer<std::uint64_t>(raw_[read_++]) << held_;
    if (held_ < n) {
      beyond_ = true;
      held_ = n;
    }
  }

  std::span<const std::byte> raw_, words_;
  const std::byte* next_;
  const std::byte* end_;
  std::array<std::uint32_t, lane_count> state_{};
  std::uint64_t buffer_ = 0;
  std::size_t read_ = 0;
  unsigned held_ = 0;
  bool valid_, beyond_ = false;
};

}  // namespace clers::internal

#endif
