// What integers leave open of numbers, and numbers that have no integer <-> streams.
//
// Refinements mostly are noise: they are plain bits, or uniform choices. Ulps and signs of zero are
// not, nor are numbers that occur again: then so does what belongs to the same integer.
#ifndef CLERS_CODEC_NUMBERS_REFINEMENTS_H
#define CLERS_CODEC_NUMBERS_REFINEMENTS_H

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <string>
#include <type_traits>
#include <vector>

#include "codec/entropy/bits.h"
#include "codec/entropy/coder.h"
#include "codec/numbers/number_format.h"

namespace clers::internal {

/// Raw bits of any number up to 64, the high ones first.
template <class Coder>
std::uint64_t code_many_bits(Coder& coder, unsigned n, std::uint64_t value) {
  std::uint64_t result = 0;
  while (n > 0) {
    const unsigned part = std::min(n, 14u);
    n -= part;
    const auto bits = static_cast<std::uint32_t>(value >> n & ((1u << part) - 1));
    result |= std::uint64_t(coder.raw(part, bits)) << n;
  }
  return result;
}

/// One of `count` equally likely values, count >= 1, as code_uniform in coder.h.
template <class Coder>
std::uint64_t code_choice(Coder& coder, std::uint64_t count, std::uint64_t value) {
  const unsigned b = static_cast<unsigned>(std::bit_width(count)) - 1;
  const std::uint64_t shorter = (std::uint64_t(2) << b) - count;
  const std::uint64_t head =
      code_many_bits(coder, b, value < shorter ? value : (value + shorter) >> 1);
  const bool longer = head >= shorter;
  const auto last = coder.raw(longer, static_cast<std::uint32_t>((value + shorter) & longer));
  return longer ? (head << 1 | last) - shorter : head;
}

/// A number of up to 64 bits whose length is adaptive.
template <class Coder>
std::uint64_t code_long(Coder& coder, NumberModel& lengths, std::uint64_t value) {
  const auto length =
      std::min(lengths.code(coder, static_cast<std::uint32_t>(std::bit_width(value))), 64u);
  if (length < 2) return length;
  const std::uint64_t top = std::uint64_t(1) << (length - 1);
  return top | code_many_bits(coder, length - 1, value & (top - 1));
}

/// What an integer leaves open.
struct Refinement {
  std::uint64_t low = 0;     ///< its low bits
  std::uint64_t choice = 0;  ///< of the map; or ulps, as 0, -1, 1, -2 ..; or whether zero is -0.0
};

/// How many choices N has.
template <class Map>
Choices choices_of(const NumberSystem& s, const Map& map, std::int64_t n) {
  if constexpr (Map::has_choices) return map.choices(n);
  if (s.ulps > 0) return {2 * std::uint64_t(s.ulps) + 1, false};
  const bool zero = s.signed_zero && magnitude(map.word(n, 0)) == 0;
  return {zero ? 2u : 1u, false};
}

/// The number of an integer N and a choice.
template <class T, class Map>
WordOf<T> refined_word(const NumberSystem& s, const Map& map, std::int64_t n,
                       std::uint64_t choice) {
  using U = WordOf<T>;
  const U word = map.word(n, choice);
  if constexpr (Map::has_choices) return word;
  if (choice == 0) return word;
  if (s.ulps == 0) return static_cast<U>(word ^ U(1) << (std::numeric_limits<U>::digits - 1));
  return of_key<T>(static_cast<U>(key_of<T>(word) + static_cast<U>(unzigzag(choice))));
}

/// Codes the refinements of one component, with either coder of bits or of rANS, which must be that
/// of `coding`.
template <class Map>
class RefinementCoder {
 public:
  RefinementCoder(const NumberSystem& system, const Map& map, RefinementCoding coding,
                  std::size_t count)
      : system_(system), map_(map) {
    if (coding == RefinementCoding::repeating)
      seen_.resize(std::min(std::bit_ceil(count), most_seen), {nowhere, {}, 0});
  }

  template <class Coder>
  Refinement code(Coder& coder, std::uint64_t k, Refinement known) {
    constexpr bool adaptive = !std::is_same_v<Coder, BitsTo> && !std::is_same_v<Coder, BitsFrom>;
    if (system_.low_bits == 0 && choices_at(k, 0).count == 1) return {};
    Seen* seen = nullptr;
    if constexpr (adaptive) {
      if (!seen_.empty()) {
        seen = &seen_[(k * 0x9e3779b97f4a7c15u >> 32) & (seen_.size() - 1)];
        if (seen->k == k) {
          const bool same = known.low == seen->known.low && known.choice == seen->known.choice;
          if (coder.bit(same_[seen->times], same)) {
            seen->times = static_cast<std::uint8_t>(std::min(seen->times + 1, 3));
            return seen->known;
          }
        }
      }
    }
    Refinement r;
    r.low = code_many_bits(coder, system_.low_bits, known.low);
    const Choices choices = choices_at(k, r.low);
    if (choices.count > 1) {
      bool zero = false;
      if (choices.wide) zero = code_bit(coder, zero_, known.choice == 0);
      if constexpr (adaptive && !Map::has_choices) {
        const auto most = static_cast<std::uint32_t>(choices.count - 1);
        r.choice = std::min(choice_.code(coder, static_cast<std::uint32_t>(known.choice)), most);
      } else if (!choices.wide) {
        r.choice = code_choice(coder, choices.count, known.choice);
      } else if (!zero) {
        r.choice = code_choice(coder, choices.count - 1, known.choice - 1) + 1;
      }
    }
    if (seen != nullptr) *seen = {k, r, 0};
    return r;
  }

  /// The memory of one.
  static std::uint64_t memory() { return most_seen * sizeof(Seen); }

 private:
  struct Seen {
    std::uint64_t k;
    Refinement known;
    std::uint8_t times;  ///< how often it came again
  };
  static constexpr std::size_t most_seen = std::size_t(1) << 15;
  static constexpr std::uint64_t nowhere = ~std::uint64_t(0);

  Choices choices_at(std::uint64_t k, std::uint64_t low) const {
    return choices_of(system_, map_, integer_of(system_, k, low));
  }
  template <class Coder>
  static bool code_bit(Coder& coder, BitModel& model, bool value) {
    if constexpr (std::is_same_v<Coder, BitsTo> || std::is_same_v<Coder, BitsFrom>)
      return coder.raw(1, value) != 0;
    else
      return coder.bit(model, value);
  }

  const NumberSystem& system_;
  const Map& map_;
  std::vector<Seen> seen_;
  BitModel same_[4], zero_;
  NumberModel choice_;
};

/// Codes strays: calls stray(i, word) for each of `count`, in ascending order, which gives both to
/// an encoder, and takes both from a decoder and returns whether there is such an i.
template <class U>
class StrayCoder {
 public:
  /// A stray's index, from that of the stray before it, and its word.
  template <class Coder>
  void code(Coder& coder, std::uint64_t& index, U& word) {
    index = next_ + gap_.code(coder, static_cast<std::uint32_t>(index - next_));
    next_ = index + 1;
    if (!coder.bit(same_, word == last_))
      last_ = static_cast<U>(code_many_bits(coder, 8 * sizeof(U), word));
    word = last_;
  }

 private:
  NumberModel gap_;
  BitModel same_;
  std::uint64_t next_ = 0;
  U last_ = 0;
};

/// Codes the entries of a palette, whose number is known: returns what is wrong with them.
template <class Coder>
std::string code_palette(Coder& coder, std::vector<std::uint64_t>& palette, std::uint64_t top) {
  NumberModel lengths;
  std::uint64_t next = 0;  // the least that the entry can be
  for (std::uint64_t& entry : palette) {
    const std::uint64_t gap = code_long(coder, lengths, entry - next);
    if (next > top || gap > top - next)
      return "an entry of the palette beyond the greatest integer";
    entry = next + gap;
    next = entry + 1;
  }
  return "";
}

}  // namespace clers::internal

#endif
