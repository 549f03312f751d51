// How likely each of a few hundred symbols is: what static entropy coders are given, and its bytes.
// Knows no coder that uses it.
#ifndef CLERS_CODEC_ENTROPY_SHARES_H
#define CLERS_CODEC_ENTROPY_SHARES_H

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <span>
#include <vector>

#include "codec/entropy/coder.h"

namespace clers::internal {

inline constexpr unsigned most_symbols = 256;

/// Symbols by how often each occurs, roughly: numbers of at most 16 bits, of which only the highest
/// count. Symbols from the last one on that has a weight have none.
using Weights = std::vector<std::uint32_t>;

/// Weights of symbols that occurred so often: `significant` bits of them, below 2^15.
inline Weights weights_of(std::span<const std::uint64_t> counts, unsigned significant) {
  std::uint64_t most = 0;
  std::size_t symbols = 0;
  for (std::size_t s = 0; s < counts.size(); ++s) {
    most = std::max(most, counts[s]);
    if (counts[s] != 0) symbols = s + 1;
  }
  const int scale = std::max(0, static_cast<int>(std::bit_width(most)) - 15);
  Weights weights(symbols);
  for (std::size_t s = 0; s < symbols; ++s) {
    if (counts[s] == 0) continue;
    std::uint32_t w = std::max(1u, static_cast<std::uint32_t>(counts[s] >> scale));
    const int drop = static_cast<int>(std::bit_width(w)) - static_cast<int>(significant);
    if (drop > 0) w = ((w >> (drop - 1)) + 1) >> 1 << drop;
    weights[s] = w;
  }
  return weights;
}

/// Weights <-> decisions. Each length is coded by its distance from those of the two symbols
/// before.
class WeightsModel {
 public:
  /// Precondition: at most most_symbols, of at most 16 bits and so many significant ones, 1 .. 4.
  template <class Coder>
  void code(Coder& coder, unsigned significant, Weights& weights) {
    weights.resize(coder.raw(8, static_cast<std::uint32_t>(weights.size() - 1) & 0xff) + 1);
    unsigned before = 8, last = 8;
    for (std::uint32_t& w : weights) {
      const unsigned from = (before + last + 1) / 2;
      const unsigned length = code_length(coder, from, static_cast<unsigned>(std::bit_width(w)));
      before = last;
      last = length;
      if (length == 0) {
        w = 0;
        continue;
      }
      const unsigned more = std::min(length, significant) - 1, zeros = length - 1 - more;
      w = (1u << more | coder.raw(more, w >> zeros & ((1u << more) - 1))) << zeros;
    }
  }

 private:
  static constexpr unsigned longest = 16;

  template <class Coder>
  unsigned code_length(Coder& coder, unsigned from, unsigned length) {
    Context& c = contexts_[from == 0 ? 0 : from < 4 ? 1 : 2];
    if (!coder.bit(c.differs, length != from)) return from;
    const bool longer = from == 0 || (from < longest && coder.bit(c.longer, length > from));
    const unsigned most = longer ? longest - from : from;
    unsigned distance = 1;
    while (distance < most &&
           coder.bit(c.further, distance < (longer ? length - from : from - length)))
      ++distance;
    return longer ? from + distance : from - distance;
  }

  struct Context {
    BitModel differs, longer, further;
  };
  std::array<Context, 3> contexts_;
};

/// Shares of 2^log, one a symbol: not 0 where its weight is not.
struct Shares {
  unsigned log = 0;
  std::vector<std::uint16_t> of;
};

/// Whether weights can be made shares.
inline bool can_share(const Weights& weights, unsigned log) {
  std::size_t used = 0;
  for (const std::uint32_t w : weights) used += w != 0;
  return used > 0 && used <= std::size_t(1) << log;
}

/// Precondition: can_share. log <= 12.
inline Shares shares_of(const Weights& weights, unsigned log) {
  Shares shares{log, std::vector<std::uint16_t>(weights.size())};
  std::uint64_t all = 0;
  for (const std::uint32_t w : weights) all += w;
  std::int32_t left = std::int32_t(1) << log;
  for (std::size_t s = 0; s < weights.size(); ++s) {
    if (weights[s] == 0) continue;
    const std::uint64_t share = ((std::uint64_t(weights[s]) << log) + all / 2) / all;
    shares.of[s] = static_cast<std::uint16_t>(std::max<std::uint64_t>(share, 1));
    left -= shares.of[s];
  }
  // What rounding left over, the largest take or give: it changes them least.
  for (; left != 0; left -= left > 0 ? 1 : -1) {
    auto largest = std::max_element(shares.of.begin(), shares.of.end());
    *largest = static_cast<std::uint16_t>(left > 0 ? *largest + 1 : *largest - 1);
  }
  return shares;
}

}  // namespace clers::internal

#endif
