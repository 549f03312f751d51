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

/// What a state says: what its symbol stands for, to which raw bits are added; how many bits the
/// next state takes in and what they are added to; how many bits that and the raw bits take
/// together.
template <class Value>
struct Entry {
  Value least;
  std::uint16_t base;
  std::uint8_t bits;
  std::uint8_t with_raw;
};

/// sizeof(Entry) << log bytes.
template <class Value>
class DecodeTable {
 public:
  /// least[symbol] is what a symbol stands for, raw(symbol) how many raw bits follow it.
  template <class Least, class Raw>
  DecodeTable(const Shares& shares, const Least& least, Raw raw)
      : entries_(std::size_t(1) << shares.log) {
    const std::vector<std::uint8_t> symbols = spread(shares);
    std::array<std::uint16_t, most_symbols> next{};
    for (std::size_t s = 0; s < shares.of.size(); ++s) next[s] = shares.of[s];
    for (std::size_t state = 0; state < symbols.size(); ++state) {
      const unsigned symbol = symbols[state], x = next[symbol]++;
      const unsigned bits = shares.log + 1 - static_cast<unsigned>(std::bit_width(x));
      entries_[state] = {
          least[symbol], static_cast<std::uint16_t>((x << bits) - (1u << shares.log)),
          static_cast<std::uint8_t>(bits), static_cast<std::uint8_t>(bits + raw(symbol))};
    }
  }
  const Entry<Value>* entries() const { return entries_.data(); }

 private:
  std::vector<Entry<Value>> entries_;
};

/// What must be written of a symbol in a state, and how to go on from there.
template <class Value>
struct Step {
  std::uint32_t bits;  ///< added to a state gives how many bits it loses, above 16 bits
  std::int32_t begin;  ///< added to what is left of it gives the place of the next one
  Value least;
  std::uint32_t raw;
};

template <class Value>
class EncodeTable {
 public:
  template <class Least, class Raw>
  EncodeTable(const Shares& shares, const Least& least, Raw raw)
      : steps_(shares.of.size()), next_(std::size_t(1) << shares.log) {
    const std::vector<std::uint8_t> symbols = spread(shares);
    std::array<std::uint16_t, most_symbols> place{};
    unsigned begin = 0;
    for (std::size_t s = 0; s < shares.of.size(); ++s) {
      const unsigned share = shares.of[s];
      if (share == 0) continue;
      // States of at least share << most lose `most` bits, the others one less.
      const unsigned most = share == 1
                                ? shares.log
                                : shares.log - static_cast<unsigned>(std::bit_width(share - 1)) + 1;
      steps_[s] = {(most << 16) - (share << most),
                   static_cast<std::int32_t>(begin) - static_cast<std::int32_t>(share), least[s],
                   raw(static_cast<unsigned>(s))};
      place[s] = static_cast<std::uint16_t>(begin);
      begin += share;
    }
    for (std::size_t state = 0; state < symbols.size(); ++state)
      next_[place[symbols[state]]++] =
          static_cast<std::uint16_t>((std::size_t(1) << shares.log) + state);
  }
  const Step<Value>* steps() const { return steps_.data(); }
  /// States in the order of their symbols, counted from 2^log.
  const std::uint16_t* next() const { return next_.data(); }

 private:
  std::vector<Step<Value>> steps_;
  std::vector<std::uint16_t> next_;
};

}  // namespace clers::internal::tans

#endif
