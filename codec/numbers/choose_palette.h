// Which integers occur, where they are few enough to be coded by their ranks. Knows integers alone.
#ifndef CLERS_CODEC_NUMBERS_CHOOSE_PALETTE_H
#define CLERS_CODEC_NUMBERS_CHOOSE_PALETTE_H

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "codec/numbers/transform.h"

namespace clers::internal {

/// Integers that are so many apart in memory, none below 0.
template <class Int>
struct Strided {
  std::span<const Int> all;
  std::size_t stride;

  std::size_t size() const { return (all.size() + stride - 1) / stride; }
  std::uint64_t operator[](std::size_t i) const {
    return static_cast<std::uint64_t>(all[i * stride]);
  }
};

/// Which of 0 .. top occur, and how many before each.
class OccurringSmall {
 public:
  /// Gives up when there are more than `most`.
  template <class Ks>
  OccurringSmall(const Ks& ks, std::uint64_t top, std::size_t most)
      : bits_(static_cast<std::size_t>(top / 64) + 1) {
    for (std::size_t i = 0; i < ks.size() && count_ <= most; ++i) {
      const std::uint64_t k = ks[i];
      std::uint64_t& word = bits_[static_cast<std::size_t>(k / 64)];
      count_ += (word >> k % 64 & 1) ^ 1;
      word |= std::uint64_t(1) << k % 64;
    }
    if (count_ > most) count_ = 0;
  }
  std::size_t count() const { return count_; }  ///< 0: there are too many

  std::vector<std::uint64_t> all() {
    std::vector<std::uint64_t> result;
    result.reserve(count_);
    before_.resize(bits_.size());
    for (std::size_t i = 0; i < bits_.size(); ++i) {
      before_[i] = result.size();
      for (std::uint64_t word = bits_[i]; word != 0; word &= word - 1)
        result.push_back(64 * i + static_cast<unsigned>(std::countr_zero(word)));
    }
    return result;
  }
  /// Precondition: all() was called, and k occurs.
  std::uint64_t rank(std::uint64_t k) const {
    const std::size_t i = static_cast<std::size_t>(k / 64);
    const std::uint64_t below = bits_[i] & ((std::uint64_t(1) << k % 64) - 1);
    return before_[i] + static_cast<unsigned>(std::popcount(below));
  }

 private:
  std::vector<std::uint64_t> bits_, before_;
  std::size_t count_ = 0;
};

/// The same for a `top` that is not small; also none where a sample says that they are not so few.
template <class Ks>
std::vector<std::uint64_t> occurring(const Ks& ks, std::size_t most) {
  std::vector<std::uint64_t> all;
  // A hash table that is given up when it has too many.
  const auto collect = [&](std::size_t every, std::size_t limit) {
    std::vector<std::uint64_t> table(std::bit_ceil(2 * limit + 2), ~std::uint64_t(0));
    all.clear();
    for (std::size_t i = 0; i < ks.size(); i += every) {
      const std::uint64_t k = ks[i];
      std::size_t at = (k * 0x9e3779b97f4a7c15u >> 20) & (table.size() - 1);
      while (table[at] != k && table[at] != ~std::uint64_t(0)) at = (at + 1) & (table.size() - 1);
      if (table[at] == k) continue;
      if (all.size() == limit) return false;
      table[at] = k;
      all.push_back(k);
    }
    return true;
  };
  // Of s numbers drawn from at most `most`, about s * s / (2 * most) have occurred before.
  constexpr std::size_t every = 15;
  const std::size_t sampled = (ks.size() + every - 1) / every,
                    again = sampled * sampled / (8 * std::max(sampled, most));
  if (!collect(every, sampled - again) || !collect(1, most)) return {};
  std::sort(all.begin(), all.end());
  return all;
}

/// How many bits differences to the value before have, in all: what orders of magnitude cost.
struct StepBits {
  std::uint64_t bits = 0, before = 0;

  void add(std::uint64_t k) {
    bits += static_cast<unsigned>(std::bit_width(zigzag(k - before)));
    before = k;
  }
};

/// Whether ranks among the integers that occur are so much shorter that it pays to say which do.
template <class Ks, class Rank>
bool palette_pays(const Ks& ks, std::uint64_t top, std::size_t entries, const Rank& rank) {
  StepBits plain, ranked;
  for (std::size_t i = 0; i < ks.size(); ++i) {
    plain.add(ks[i]);
    ranked.add(rank(ks[i]));
  }
  const std::uint64_t entry = 4 + std::uint64_t(std::bit_width(top / entries));
  return ranked.bits + entry * entries + plain.bits / 32 < plain.bits;
}

/// The integers that occur, if they are few and their ranks much shorter; else none. Every
/// `stride`-th is looked at, the first included; they are in 0 .. top.
template <class Int>
std::vector<std::uint64_t> choose_palette(std::span<const Int> all, std::size_t stride,
                                          std::uint64_t top) {
  const Strided<Int> ks{all, stride};
  if (ks.size() < 6 || top < 8) return {};
  const auto most = static_cast<std::size_t>(std::min<std::uint64_t>(ks.size() / 3, top / 2));
  if (top / 64 < ks.size()) {
    OccurringSmall small(ks, top, most);
    if (small.count() == 0) return {};
    std::vector<std::uint64_t> palette = small.all();
    const auto rank = [&](std::uint64_t k) { return small.rank(k); };
    return palette_pays(ks, top, palette.size(), rank) ? palette : std::vector<std::uint64_t>();
  }
  std::vector<std::uint64_t> palette = occurring(ks, most);
  if (palette.empty()) return {};
  const auto rank = [&](std::uint64_t k) {
    return static_cast<std::uint64_t>(std::lower_bound(palette.begin(), palette.end(), k) -
                                      palette.begin());
  };
  return palette_pays(ks, top, palette.size(), rank) ? palette : std::vector<std::uint64_t>();
}

}  // namespace clers::internal

#endif
