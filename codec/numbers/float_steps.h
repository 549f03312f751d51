// Steps as programs compute them that work in floats: fl(fl(N * length) + origin). What Draco and
// others quantised is made floats so, and then nothing is left open.
#ifndef CLERS_CODEC_NUMBERS_FLOAT_STEPS_H
#define CLERS_CODEC_NUMBERS_FLOAT_STEPS_H

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "codec/numbers/number_maps.h"

namespace clers::internal {

/// Looks for a length near to one, from the least of all numbers on, which mostly is the origin.
///
/// Each number v leaves an interval of lengths: N * length is v - origin but for half an ulp of
/// each of the two results. From near numbers to far ones, so that N is sure, intervals become
/// narrower, until few floats are left; the one that most numbers are of is taken, if nearly all
/// are. Preconditions: numbers are finite. Cost: linear but for a sort.
inline std::optional<NumberSystem> float_steps(std::vector<float> numbers, float origin,
                                               double length) {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  constexpr int most_candidates = 64;
  const auto ulp = [](float v) {
    return double(std::nextafter(std::fabs(v), infinity)) - double(std::fabs(v));
  };
  std::sort(numbers.begin(), numbers.end());
  double low = length * (1 - 1e-3), high = length * (1 + 1e-3);
  for (const float v : numbers) {
    const double far = double(v) - double(origin);
    const double n = std::floor(far / length + .5);
    if (n < 1) continue;
    const double noise = (ulp(v) + ulp(static_cast<float>(far))) * .5000001;
    // A number of another kind is not listened to.
    const double l = (far - noise) / n, h = (far + noise) / n;
    if (l > high || h < low) continue;
    low = std::max(low, l);
    high = std::min(high, h);
    length = low + (high - low) / 2;
  }
  NumberSystem s;
  s.map = NumberMap::affine;
  s.single = true;
  s.origin = double(origin);
  std::optional<NumberSystem> best;
  std::size_t most = numbers.size() - numbers.size() / 50;
  float candidate = static_cast<float>(low);
  for (int i = 0; i < most_candidates && double(candidate) <= high;
       ++i, candidate = std::nextafter(candidate, infinity)) {
    s.length = double(candidate);
    if (!(s.length > 0)) continue;
    const AffineMap<float> map(s, Scalar::float32);
    const auto is_of = [&](float v) {
      const auto word = std::bit_cast<std::uint32_t>(v);
      const NumberPlace at = map.locate(word);
      return std::abs(at.n) < most_exact && map.word(at.n, 0) == word;
    };
    const auto count =
        static_cast<std::size_t>(std::count_if(numbers.begin(), numbers.end(), is_of));
    if (count < most || (best && count == most)) continue;
    most = count;
    best = s;
  }
  return best;
}

}  // namespace clers::internal

#endif
