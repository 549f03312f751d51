// How near triangles are to equilateral ones.
#ifndef CLERS_CODEC_CLI_TRIANGLE_SHAPE_H
#define CLERS_CODEC_CLI_TRIANGLE_SHAPE_H

#include <algorithm>
#include <cstddef>
#include <vector>

namespace clers::cli {

/// The radius ratio of a triangle with sides of these lengths: twice the radius of the circle
/// inside by that of the one around, 1 if equilateral, 0 of one without area.
inline double radius_ratio(double a, double b, double c) {
  const double product = a * b * c;
  return product > 0 ? std::max(0., (b + c - a) * (c + a - b) * (a + b - c) / product) : 0;
}

/// What 5 % of the ratios do not reach; 0 of none.
inline double low_ratio(std::vector<double>& ratios) {
  if (ratios.empty()) return 0;
  const auto low = ratios.begin() + static_cast<std::ptrdiff_t>(ratios.size() / 20);
  std::nth_element(ratios.begin(), low, ratios.end());
  return *low;
}

}  // namespace clers::cli

#endif
