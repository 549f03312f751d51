// Which shares residuals are coded with: those of the encoder's choice. It knows classes and how
// often they occur, no values.
#ifndef CLERS_CODEC_ATTRIBUTES_TWO_SETS_H
#define CLERS_CODEC_ATTRIBUTES_TWO_SETS_H

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "codec/attributes/residual_classes.h"
#include "codec/attributes/residual_streams.h"
#include "codec/entropy/shares.h"

namespace clers::internal {

using ClassCounts = std::array<std::uint64_t, residual_classes>;

/// log2(x) in 1/256, rounded down. x > 0.
inline std::uint64_t log2_of(std::uint64_t x) {
  if (x == 1) return 0;  // as of the many classes that do not occur
  const unsigned whole = static_cast<unsigned>(std::bit_width(x)) - 1;
  std::uint64_t m = whole > 31 ? x >> (whole - 31) : x << (31 - whole), fraction = 0;
  for (unsigned i = 0; i < 8; ++i) {
    m = m * m >> 31;
    fraction = fraction << 1 | m >> 32;
    if (m >> 32 != 0) m >>= 1;
  }
  return whole << 8 | fraction;
}

/// What residuals in these classes take at least, in 1/256 bits.
inline std::uint64_t cost_of(const ClassCounts& counts) {
  std::uint64_t all = 0, cost = 0;
  for (unsigned c = 0; c < residual_classes; ++c) {
    if (counts[c] == 0) continue;
    all += counts[c];
    cost += counts[c] * ((std::uint64_t(raw_bits(c)) << 8) - log2_of(counts[c]));
  }
  return all == 0 ? 0 : cost + all * log2_of(all);
}
/// About what the weights of these classes take.
inline std::uint64_t cost_of_weights(const ClassCounts& counts) {
  std::uint64_t cost = 0;
  for (const std::uint64_t n : counts) cost += n != 0 ? 4 * 256 : 0;
  return cost;
}

/// Weights of the components that are coded; neighbours have the same where that takes least.
inline std::vector<Weights> weights_by_component(const std::vector<ClassCounts>& counts,
                                                 std::span<const std::size_t> coded,
                                                 unsigned significant) {
  std::vector<Weights> weights(counts.size());
  for (std::size_t first = 0, next = 0; first < coded.size(); first = next) {
    ClassCounts together = counts[coded[first]];
    std::uint64_t cost = cost_of(together);
    for (next = first + 1; next < coded.size(); ++next) {
      const ClassCounts& other = counts[coded[next]];
      ClassCounts sum = together;
      for (unsigned c = 0; c < residual_classes; ++c) sum[c] += other[c];
      const std::uint64_t both = cost_of(sum);
      if (both > cost + cost_of(other) + cost_of_weights(other)) break;
      together = sum;
      cost = both;
    }
    const Weights of_all = weights_of(together, significant);
    for (std::size_t i = first; i < next; ++i) weights[coded[i]] = of_all;
  }
  return weights;
}

/// Blocks of rows in two sets, each with shares of its own: those with small residuals and those
/// with great ones, then by what each takes in either (Lloyd's algorithm).
class TwoSets {
 public:
  TwoSets(std::span<const std::uint8_t> classes, std::size_t components)
      : classes_(classes), components_(components) {
    const std::size_t size = rows_in_block * components;
    std::vector<std::uint64_t> sums;
    std::uint64_t all = 0;
    for (std::size_t i = 0; i < classes.size(); i += size) {
      std::uint64_t sum = 0;
      for (const std::uint8_t c : block(i / size)) sum += c;
      sums.push_back(sum);
      all += sum;
    }
    const std::uint64_t mean = all / std::max<std::size_t>(sums.size(), 1);
    for (const std::uint64_t sum : sums) set_of.push_back(sum > mean);
    count();
    for (unsigned round = 0; round < 2; ++round) move();
  }

  /// Whether they take less than one set does, weights and all, by what is worth the time.
  bool pays(const std::vector<ClassCounts>& of_all) const {
    std::uint64_t one = 0, two = 160 * std::uint64_t(set_of.size());
    for (std::size_t c = 0; c < components_; ++c) {
      one += cost_of(of_all[c]) + cost_of_weights(of_all[c]);
      for (const auto& of_set : counts) two += cost_of(of_set[c]) + cost_of_weights(of_set[c]);
    }
    return two < one - one / 256;
  }

  std::vector<std::uint8_t> set_of;                ///< of each block
  std::array<std::vector<ClassCounts>, 2> counts;  ///< of each component

 private:
  std::span<const std::uint8_t> block(std::size_t b) const {
    const std::size_t size = rows_in_block * components_, begin = b * size;
    return classes_.subspan(begin, std::min(size, classes_.size() - begin));
  }
  void count() {
    for (auto& of_set : counts) of_set.assign(components_, ClassCounts{});
    for (std::size_t b = 0; b < set_of.size(); ++b) count(b, 1);
  }
  /// Adds a block to its set, or takes it away: `times` is 1 or -1.
  void count(std::size_t b, int times) {
    const std::span<const std::uint8_t> in = block(b);
    std::vector<ClassCounts>& of_set = counts[set_of[b]];
    for (std::size_t i = 0; i < in.size(); i += components_)
      for (std::size_t c = 0; c < components_; ++c)
        of_set[c][in[i + c]] += static_cast<std::uint64_t>(times);
  }
  /// Each block to the set in which it takes less.
  void move() {
    std::vector<std::array<std::int32_t, residual_classes>> more(components_);
    for (std::size_t c = 0; c < components_; ++c) {
      std::array<std::uint64_t, 2> all{1, 1};
      for (unsigned k = 0; k < residual_classes; ++k)
        for (std::size_t s = 0; s < 2; ++s) all[s] += 2 * counts[s][c][k] + 1;
      for (unsigned k = 0; k < residual_classes; ++k) {
        const auto cost = [&](std::size_t s) {
          return static_cast<std::int32_t>(log2_of(all[s]) - log2_of(2 * counts[s][c][k] + 1));
        };
        more[c][k] = cost(1) - cost(0);
      }
    }
    for (std::size_t b = 0; b < set_of.size(); ++b) {
      const std::span<const std::uint8_t> in = block(b);
      std::int64_t sum = 0;
      for (std::size_t i = 0; i < in.size(); i += components_)
        for (std::size_t c = 0; c < components_; ++c) sum += more[c][in[i + c]];
      if (set_of[b] == (sum < 0)) continue;
      count(b, -1);
      set_of[b] = sum < 0;
      count(b, 1);
    }
  }

  std::span<const std::uint8_t> classes_;
  std::size_t components_;
};

}  // namespace clers::internal

#endif
