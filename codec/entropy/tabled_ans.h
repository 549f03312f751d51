// Asymmetric numeral systems by tables: static shares, and neither multiplication nor division a
// symbol (Duda, arXiv 1311.2540, "tANS"; Collet's Finite State Entropy).
//
// Each symbol may be followed by raw bits, whose number the symbol determines: a magnitude class
// and its mantissa. A table says both numbers of bits, so that one look-up is all that the place of
// the next symbol waits for. Knows no model.
#ifndef CLERS_CODEC_ENTROPY_TABLED_ANS_H
#define CLERS_CODEC_ENTROPY_TABLED_ANS_H

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "codec/base/portable.h"
#include "codec/entropy/shares.h"

namespace clers::internal::tans {

inline constexpr unsigned most_log = 12;

/// The symbol of each state, spread evenly. Precondition: shares add up to 2^log.
inline std::vector<std::uint8_t> spread(const Shares& shares) {
  const std::size_t states = std::size_t(1) << shares.log, mask = states - 1;
  const std::size_t step = ((states >> 1) + (states >> 3) + 3) | 1;  // odd: reaches all
  std::vector<std::uint8_t> symbols(states);
  std::size_t at = 0;
  for (std::size_t s = 0; s < shares.of.size(); ++s)
    for (unsigned i = 0; i < shares.of[s]; ++i, at = (at + step) & mask)
      symbols[at] = static_cast<std::uint8_t>(s);
  return symbols;
}

/// What a state says, in a word: the symbol; how many bits the next state takes in and what they
/// are added to; how many bits that and the raw bits take together.
class Entry {
 public:
  Entry() = default;
  Entry(unsigned symbol, unsigned base, unsigned bits, unsigned raw)
      : word_(base | bits << 12 | symbol << 16 | (bits + raw) << 24) {}
  unsigned base() const { return word_ & 0xfff; }
  unsigned bits() const { return word_ >> 12 & 15; }
  unsigned symbol() const { return word_ >> 16 & 0xff; }
  unsigned with_raw() const { return word_ >> 24; }

 private:
  std::uint32_t word_ = 0;
};

/// 4 << log bytes.
class DecodeTable {
 public:
  /// raw(symbol): how many raw bits follow it.
  template <class Raw>
  DecodeTable(const Shares& shares, Raw raw) : entries_(std::size_t(1) << shares.log) {
    const std::vector<std::uint8_t> symbols = spread(shares);
    std::array<std::uint16_t, most_symbols> next{};
    for (std::size_t s = 0; s < shares.of.size(); ++s) next[s] = shares.of[s];
    for (std::size_t state = 0; state < symbols.size(); ++state) {
      const unsigned symbol = symbols[state], x = next[symbol]++;
      const unsigned bits = shares.log + 1 - static_cast<unsigned>(std::bit_width(x));
      entries_[state] =
          Entry(symbol, (x << bits) - (1u << shares.log), bits, static_cast<unsigned>(raw(symbol)));
    }
  }
  const Entry* entries() const { return entries_.data(); }

 private:
  std::vector<Entry> entries_;
};

class EncodeTable {
 public:
  explicit EncodeTable(const Shares& shares) : log_(shares.log), next_(std::size_t(1) << log_) {
    const std::vector<std::uint8_t> symbols = spread(shares);
    std::array<std::uint16_t, most_symbols> place{};
    unsigned begin = 0;
    for (std::size_t s = 0; s < shares.of.size(); ++s) {
      const unsigned share = shares.of[s];
      if (share == 0) continue;
      // States of at least share << most take in `most` bits, the others one less.
      const unsigned most =
          share == 1 ? log_ : log_ - static_cast<unsigned>(std::bit_width(share - 1)) + 1;
      of_[s] = {(most << 16) - (share << most),
                static_cast<std::int32_t>(begin) - static_cast<std::int32_t>(share)};
      place[s] = static_cast<std::uint16_t>(begin);
      begin += share;
    }
    for (std::size_t state = 0; state < symbols.size(); ++state)
      next_[place[symbols[state]]++] = static_cast<std::uint16_t>((std::size_t(1) << log_) + state);
  }

  /// The state of the decoder before it reads the symbol, from that behind it; states are counted
  /// from 2^log here. The lowest `bits` of the state behind are what it must read.
  CLERS_ALWAYS_INLINE std::uint32_t back(std::uint32_t state, unsigned symbol,
                                         unsigned& bits) const {
    const Step step = of_[symbol];
    bits = (state + step.bits) >> 16;
    return next_[static_cast<std::size_t>(static_cast<std::int32_t>(state >> bits) + step.begin)];
  }
  unsigned log() const { return log_; }

 private:
  struct Step {
    std::uint32_t bits;
    std::int32_t begin;
  };
  unsigned log_;
  std::array<Step, most_symbols> of_{};
  std::vector<std::uint16_t> next_;
};

}  // namespace clers::internal::tans

#endif
