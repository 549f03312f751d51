// What both directions of the ordered coder share: what a step predicts, and which components have
// streams.
#ifndef CLERS_CODEC_ATTRIBUTES_ORDERED_MODEL_H
#define CLERS_CODEC_ATTRIBUTES_ORDERED_MODEL_H

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <vector>

#include "codec/attributes/hexagon.h"
#include "codec/attributes/residual_streams.h"
#include "codec/base/portable.h"
#include "codec/numbers/lattice.h"

namespace clers::internal {

/// What a step predicts of a component, and more, modulo the word. `rows` begin at it. The value
/// that is added last mostly is the one before, which may just have been computed.
template <class Int>
CLERS_ALWAYS_INLINE std::make_unsigned_t<Int> predicted(const Int* rows, std::size_t components,
                                                        const OrderStep<std::uint32_t>& step,
                                                        std::make_unsigned_t<Int> more = 0) {
  using U = std::make_unsigned_t<Int>;
  const auto at = [&](std::uint32_t v) { return static_cast<U>(rows[v * components]); };
  const Int way = static_cast<Int>(at(step.to) - at(step.origin));
  more += static_cast<U>(way >> step.halving);
  return more + at(step.from);
}

/// Which components have residuals, and the greatest top of all.
struct CodedComponents {
  explicit CodedComponents(std::span<const Axis> axes) {
    for (std::size_t c = 0; c < axes.size(); ++c) {
      if (axes[c].top == 0) continue;
      coded.push_back(c);
      top = std::max(top, axes[c].top);
    }
  }
  std::vector<std::size_t> coded;
  std::uint64_t top = 0;
};

/// Calls use(which) for three components, two or one at a time, as an array.
template <class Use>
void for_each_abreast(std::span<const std::size_t> which, Use use) {
  std::size_t i = 0;
  for (; i + abreast <= which.size(); i += abreast)
    use(std::array<std::size_t, 3>{which[i], which[i + 1], which[i + 2]});
  if (which.size() - i == 2) use(std::array<std::size_t, 2>{which[i], which[i + 1]});
  if (which.size() - i == 1) use(std::array<std::size_t, 1>{which[i]});
}

}  // namespace clers::internal

#endif
