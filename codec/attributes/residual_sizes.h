// Residuals in contexts of how large they are expected to be. It knows no surface and no geometry.
#ifndef CLERS_CODEC_ATTRIBUTES_RESIDUAL_SIZES_H
#define CLERS_CODEC_ATTRIBUTES_RESIDUAL_SIZES_H

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <vector>

#include "codec/base/portable.h"
#include "codec/entropy/distribution.h"

namespace clers::internal {

/// The size of a number below 2^62 in quarter octaves: 0 for 0, near 4 log2(x / 4 + 1). At most
/// 240.
CLERS_ALWAYS_INLINE unsigned size_of(std::uint64_t x) {
  x += 4;
  const unsigned w = static_cast<unsigned>(std::bit_width(x | 4)) - 3;
  return 4 * w + static_cast<unsigned>(x >> w) - 4;
}

/// How a residual of an expected size is coded: sizes by octaves, and how wide the bins are.
struct ResidualContext {
  static constexpr unsigned octaves = 62;
  /// 15 bins of the widest are more than there are integers.
  static constexpr unsigned most_width = 58;

  unsigned kind;  ///< 0 in the plane of parallelograms, 1 across it, 2 without any,
                  ///< 3 near an image, 4 near a copy
  unsigned octave, width;

  CLERS_ALWAYS_INLINE ResidualContext(unsigned k, unsigned size)
      : kind(k), octave(std::min(size >> 2, octaves - 1)) {
    const int wider = static_cast<int>(octave) - (kind == 1 || kind == 4 ? 2 : 3);
    width = std::min(static_cast<unsigned>(wider & ~(wider >> 31)), most_width);
  }
};

/// Where in its bin a residual is.
CLERS_ALWAYS_INLINE std::uint64_t place_in_bin(std::int64_t r, unsigned width) {
  const std::uint64_t size = std::uint64_t(1) << width;
  return (static_cast<std::uint64_t>(r) + (size >> 1)) & (size - 1);
}

/// Codes a bin beyond -7 .. 7 by its length in bits, in a distribution, and the bits. False if no
/// residual is as large as what was decoded.
template <class Coder>
bool code_far_bin(Coder& coder, unsigned lane, Distribution& lengths, unsigned width,
                  std::int64_t& bin) {
  const bool negative = bin < 0;
  const std::uint64_t beyond = static_cast<std::uint64_t>(negative ? -bin : bin) - 7;
  unsigned length = static_cast<unsigned>(std::bit_width(beyond)) - 1;
  const unsigned s = coder.symbol(lane, lengths, std::min(length, 15u));
  length = s < 15 ? s : 15 + static_cast<unsigned>(coder.even(lane, 6, length - 15));
  if (length + width > 60) return false;
  const std::uint64_t one = std::uint64_t(1) << length;
  const std::uint64_t far = coder.even(lane, length, beyond & (one - 1)) + one + 7;
  const bool minus = coder.even(lane, 1, negative) != 0;
  bin = minus ? -static_cast<std::int64_t>(far) : static_cast<std::int64_t>(far);
  return true;
}

/// Adaptive coding of residuals, expected ones cheap. A residual is a bin around 0, -7 .. 7, and
/// the place in it:
///
///     | -1 |  0 |  1 |  2 |      0 is in the middle of its bin
///
/// Sixteenth symbol: a bin further out, which follows. Contexts are octaves of the size expected
/// and what else is near.
class ResidualModel {
 public:
  static constexpr unsigned kinds = 5;
  static constexpr unsigned nears = 9;  ///< what else is near: contexts that callers number

  ResidualModel() {
    for (unsigned octave = 0; octave < few; ++octave)
      by_near_.insert(by_near_.end(), kinds * nears, prior(octave));
    beyond_.assign(kinds, prior(1));
  }

  /// Codes the bin of r; r becomes what is at the place `low` in it. False if no residual is as
  /// large as what was decoded.
  template <class Coder>
  CLERS_ALWAYS_INLINE bool code(Coder& coder, unsigned lane, ResidualContext context, unsigned near,
                                std::uint64_t low, std::int64_t& r) {
    const std::int64_t half = static_cast<std::int64_t>((std::uint64_t(1) << context.width) >> 1);
    std::int64_t bin = 0;
    unsigned symbol = 0;
    if constexpr (Coder::encodes) {
      bin = (r + half) >> context.width;
      symbol = bin < -7 || bin > 7 ? 15 : static_cast<unsigned>(bin + 7);
    }
    const unsigned octave = std::min(context.octave, few - 1);
    symbol = coder.symbol(lane, by_near_[(octave * kinds + context.kind) * nears + near], symbol);
    if (symbol == 15) [[unlikely]] {
      if (!code_beyond(coder, lane, context, bin)) return false;
    } else {
      bin = static_cast<std::int64_t>(symbol) - 7;
    }
    r = static_cast<std::int64_t>(static_cast<std::uint64_t>(bin) << context.width | low) - half;
    return true;
  }

  /// Shares that fall from the middle on, the faster the smaller residuals are.
  static Distribution prior(unsigned octave) {
    const std::uint32_t falls = octave == 0 ? 100 : octave == 1 ? 150 : 180;  // of 256
    std::array<std::uint32_t, 8> weight{};
    std::uint32_t all = 0, w = 1u << 16;
    for (unsigned i = 0; i < 8; ++i) {
      weight[i] = w;
      all += i == 0 ? w : 2 * w;
      w = w * falls >> 8;
    }
    std::array<std::uint16_t, 16> share{};
    share[15] = 64;
    std::uint32_t rest = shares - 64;
    for (unsigned i = 7; i > 0; --i) {
      const std::uint32_t part = 16 + weight[i] / (all >> 12) * 15 / 4;
      share[7 - i] = share[7 + i] = static_cast<std::uint16_t>(part);
      rest -= 2 * part;
    }
    share[7] = static_cast<std::uint16_t>(rest);
    return Distribution(share);
  }

 private:
  static constexpr unsigned few = 8;  ///< octaves with contexts of their own

  template <class Coder>
  CLERS_NEVER_INLINE bool code_beyond(Coder& coder, unsigned lane, ResidualContext context,
                                      std::int64_t& bin) {
    return code_far_bin(coder, lane, beyond_[context.kind], context.width, bin);
  }

  std::vector<Distribution> by_near_, beyond_;
};

}  // namespace clers::internal

#endif
