// Where the least rotation of a cycle begins: cycles have no first element, and this chooses one.
#ifndef CLERS_CODEC_BASE_LEAST_ROTATION_H
#define CLERS_CODEC_BASE_LEAST_ROTATION_H

#include <algorithm>
#include <cstdint>

namespace clers::internal {

/// The first of the rotations of 0 .. n - 1 that make the least sequence. compare(x, y) says how
/// elements x and y compare: negative, zero or positive. Cost: linear; two candidates race, and the
/// loser skips what it shared (Shiloach, Fast canonization of circular strings, 1981).
template <class Compare>
std::uint32_t least_rotation(std::uint32_t n, Compare compare) {
  const auto element = [n](std::uint32_t j) { return j >= n ? j - n : j; };
  std::uint32_t i = 0, j = 1, k = 0;  // rotations i and j agree in k places
  while (i < n && j < n && k < n) {
    const int order = compare(element(i + k), element(j + k));
    if (order == 0) {
      ++k;
      continue;
    }
    (order > 0 ? i : j) += k + 1;
    if (i == j) ++j;
    k = 0;
  }
  return n == 0 ? 0 : std::min(i, j);
}

}  // namespace clers::internal

#endif
