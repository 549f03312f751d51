// What normals on an octahedral grid are off <-> decisions or symbols: by mixing contexts, which
// takes least, or by two of them, which is fast.
#ifndef CLERS_CODEC_ATTRIBUTES_NORMAL_RESIDUALS_H
#define CLERS_CODEC_ATTRIBUTES_NORMAL_RESIDUALS_H

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include "codec/attributes/mixed_contexts.h"
#include "codec/attributes/normal_expectation.h"
#include "codec/attributes/residual_sizes.h"
#include "codec/base/portable.h"
#include "codec/entropy/distribution.h"

namespace clers::internal {

/// By mixing four contexts.
class MixedNormalResiduals {
 public:
  /// Component context.component, by what it is off, where the expectation is of this kind.
  template <class Coder>
  std::int64_t code(Coder& coder, const NormalContexts& context, unsigned kind, std::int64_t r) {
    contexts_.set(context.of_tables(), 2 * kind + context.component);
    return contexts_.code(coder, r);
  }
  static std::uint64_t memory() { return MixedContexts::memory(NormalContexts::counts, sets); }

 private:
  static constexpr unsigned sets = 4;
  MixedContexts contexts_{NormalContexts::counts, sets};
};

/// By the mean of two distributions of symbols: one by the size expected and where between two
/// integers the prediction is, one by the triangles around. So that mirror images have one context,
/// signs are those beside a prediction that is above its integer.
class QuickNormalResiduals {
 public:
  QuickNormalResiduals() {
    for (unsigned size = 0; size < sizes; ++size)
      by_size_.insert(by_size_.end(), parts * 2 * signs, ResidualModel::prior(size / 3));
    by_shape_.assign(areas * NormalContexts::bends * 2, ResidualModel::prior(1));
  }

  /// As above; 2^62 if there is no such residual.
  template <class Coder>
  CLERS_ALWAYS_INLINE std::int64_t code(Coder& coder, const NormalContexts& context, unsigned,
                                        std::int64_t r) {
    const unsigned i = context.component;
    const int part = static_cast<int>(context.part) - 8;
    const std::int64_t below = -static_cast<std::int64_t>(part < 0);
    const auto size = std::min(context.expected / 2, sizes - 1);
    const unsigned sign = context.before == 0 ? 0 : context.before_negative == (part < 0) ? 1 : 2;
    Distribution& by_size =
        by_size_[((size * parts + static_cast<unsigned>(std::abs(part))) * 2 + i) * signs + sign];
    Distribution& by_shape = by_shape_[context.triangles() * 2 + i];
    const auto width =
        static_cast<unsigned>(std::max(static_cast<int>(context.expected + 3) / 4 - 4, 0));
    const std::int64_t half = static_cast<std::int64_t>((std::uint64_t(1) << width) >> 1);
    std::int64_t bin = 0;
    std::uint64_t low = 0;
    unsigned symbol = 0;
    if constexpr (Coder::encodes) {
      r = (r ^ below) - below;
      low = place_in_bin(r, width);
      coder.bits(width, low);
      bin = (r + half) >> width;
      symbol = bin < -7 || bin > 7 ? 15 : static_cast<unsigned>(bin + 7);
    } else {
      low = coder.bits(width, 0, 0)[0];
    }
    symbol = coder.symbol(i, mean_of(by_size.starts(), by_shape.starts()), symbol);
    by_size.update(symbol);
    by_shape.update(symbol);
    if (symbol == 15) [[unlikely]] {
      if (!code_far_bin(coder, i, far_, width, bin)) return std::int64_t(1) << 62;
    } else {
      bin = static_cast<std::int64_t>(symbol) - 7;
    }
    r = static_cast<std::int64_t>(static_cast<std::uint64_t>(bin) << width | low) - half;
    return (r ^ below) - below;
  }

  static constexpr std::uint64_t memory() {
    return (sizes * parts * 2 * signs + areas * NormalContexts::bends * 2) * sizeof(Distribution);
  }

 private:
  static constexpr unsigned sizes = 16, parts = 9, signs = 3, areas = NormalContexts::areas;

  std::vector<Distribution> by_size_, by_shape_;
  Distribution far_ = ResidualModel::prior(1);
};

}  // namespace clers::internal

#endif
