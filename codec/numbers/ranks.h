// Integers of a palette <-> their ranks in it, for coders that know no palettes.
#ifndef CLERS_CODEC_NUMBERS_RANKS_H
#define CLERS_CODEC_NUMBERS_RANKS_H

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "codec/numbers/lattice.h"

namespace clers::internal {

/// What the axes are once ranks stand for the integers of palettes.
inline std::vector<Axis> with_ranks(std::span<const Axis> axes) {
  std::vector<Axis> result;
  result.reserve(axes.size());
  for (const Axis& a : axes)
    result.push_back(a.palette.empty() ? Axis{a.top, a.scale, {}}
                                       : Axis{a.palette.size() - 1, 1, {}});
  return result;
}

/// Cost: a binary search an integer of a palette. Precondition: the palette has it.
template <class Int>
void integers_to_ranks(const Lattice<Int>& lattice) {
  const auto [rows, axes] = lattice;
  for (std::size_t c = 0; c < axes.size(); ++c) {
    const auto& palette = axes[c].palette;
    if (palette.empty()) continue;
    for (std::size_t i = c; i < rows.size(); i += axes.size())
      rows[i] = static_cast<Int>(
          std::lower_bound(palette.begin(), palette.end(), static_cast<std::uint64_t>(rows[i])) -
          palette.begin());
  }
}
/// Precondition: ranks are below the palettes' sizes.
template <class Int>
void ranks_to_integers(const Lattice<Int>& lattice) {
  const auto [rows, axes] = lattice;
  for (std::size_t c = 0; c < axes.size(); ++c) {
    const auto& palette = axes[c].palette;
    if (palette.empty()) continue;
    for (std::size_t i = c; i < rows.size(); i += axes.size())
      rows[i] = static_cast<Int>(palette[static_cast<std::size_t>(rows[i])]);
  }
}

}  // namespace clers::internal

#endif
