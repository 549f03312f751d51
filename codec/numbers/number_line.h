// A component's integers as real numbers, for who predicts values by arithmetic on them.
#ifndef CLERS_CODEC_NUMBERS_NUMBER_LINE_H
#define CLERS_CODEC_NUMBERS_NUMBER_LINE_H

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

#include "codec/numbers/floating_maps.h"
#include "codec/numbers/number_format.h"

namespace clers::internal {

/// Both directions are the same on every machine, while there is a DoublePrecision (portable.h).
class NumberLine {
 public:
  virtual ~NumberLine() = default;

  /// The number that integer k stands for, or the first of several. What is not a number, or so
  /// small or large that it or its square is no normal double, is 0 or +-2^100.
  virtual double value(std::uint64_t k) const = 0;
  /// The integer, in 0 .. top, of a number near to one.
  virtual std::uint64_t nearest(double x) const = 0;

  static double tame(double x) {
    if (!(std::fabs(x) >= 0x1p-200)) return 0;  // NaN, too
    return std::clamp(x, -0x1p100, 0x1p100);
  }
};

/// The line of one component; of integers, 32 bits at most. They are parts of the greatest the
/// type, as normalized ones are in glTF.
inline std::unique_ptr<NumberLine> number_line(const NumberSystem& system, const Axis& axis,
                                               Scalar scalar) {
  return with_number_type(scalar, [&](auto type) -> std::unique_ptr<NumberLine> {
    using T = decltype(type);
    return with_map<T>(system, scalar, [&](const auto& map) -> std::unique_ptr<NumberLine> {
      using Map = std::decay_t<decltype(map)>;
      struct Line final : NumberLine {
        Line(const NumberSystem& s, std::uint64_t t, Scalar sc, const Map& m)
            : system(s),
              top(t),
              mask(key_mask(sc)),
              unit(static_cast<double>((~std::uint64_t(0) >> (64 - 8 * size_of(sc))) ^ mask)),
              map(m) {}
        double value(std::uint64_t k) const override {
          const WordOf<T> word = map.word(integer_of(system, k, 0), 0);
          if constexpr (std::is_floating_point_v<T>) {
            return tame(static_cast<double>(std::bit_cast<T>(word)));
          } else {
            return tame(word < mask ? -static_cast<double>(mask - word) / unit
                                    : static_cast<double>(word - mask) / unit);
          }
        }
        std::uint64_t nearest(double x) const override {
          WordOf<T> word;
          if constexpr (std::is_floating_point_v<T>) {
            word = std::bit_cast<WordOf<T>>(static_cast<T>(x));
          } else {
            const double steps = std::floor(std::clamp(x, -1., 1.) * unit + .5);
            word = steps < 0 ? mask - std::min(mask, static_cast<std::uint64_t>(-steps))
                             : mask + static_cast<std::uint64_t>(steps);
          }
          const std::int64_t n = map.locate(word).n;
          const bool before =
              system.map == NumberMap::word
                  ? static_cast<std::uint64_t>(n) < static_cast<std::uint64_t>(system.first)
                  : n < system.first;
          if (before) return 0;
          const std::uint64_t away =
              static_cast<std::uint64_t>(n) - static_cast<std::uint64_t>(system.first);
          const std::uint64_t rest = away % system.step;
          const std::uint64_t k = away / system.step + (rest > system.step / 2);
          return std::min(k >> system.low_bits, top);
        }

        const NumberSystem system;
        const std::uint64_t top, mask;
        const double unit;
        const Map map;
      };
      return std::make_unique<Line>(system, axis.top, scalar, map);
    });
  });
}

using NumberLines = std::vector<std::unique_ptr<NumberLine>>;

/// Those of all components.
inline NumberLines number_lines(const Numbers& numbers) {
  NumberLines lines;
  for (std::size_t c = 0; c < numbers.systems.size(); ++c)
    lines.push_back(number_line(numbers.systems[c], numbers.axes[c], numbers.scalar));
  return lines;
}

}  // namespace clers::internal

#endif
