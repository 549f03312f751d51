// How long steps are, and number systems in words.
#include "codec/numbers/number_system.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "codec/numbers/number_maps.h"

namespace clers::internal {

double spacing(const NumberSystem& s) {
  double length = 0;
  switch (s.map) {
    case NumberMap::word:
    case NumberMap::octahedral: break;
    case NumberMap::quotient:
    case NumberMap::printed: length = 1 / double(s.divisor); break;
    case NumberMap::affine: length = s.length; break;
    case NumberMap::digits: length = times_ten_to(1, s.exponent); break;
    case NumberMap::binary: length = std::ldexp(1., s.exponent); break;
  }
  // Of the greatest numbers there are it may overflow.
  return std::min(length * double(s.step) * std::ldexp(1., s.low_bits),
                  std::numeric_limits<double>::max());
}

void set_scales(Numbers& numbers) {
  std::vector<double> lengths;
  for (const NumberSystem& s : numbers.systems) {
    // Integers are words of which all steps are the same; floats as words are no lengths.
    const bool words = s.map == NumberMap::word;
    lengths.push_back(!words                     ? spacing(s)
                      : is_float(numbers.scalar) ? 0
                                                 : double(s.step) * std::ldexp(1., s.low_bits));
  }
  double least = 0, most = 0;
  for (const double l : lengths) {
    if (l > 0) least = least == 0 ? l : std::min(least, l);
    most = std::max(most, l);
  }
  for (std::size_t c = 0; c < lengths.size(); ++c) numbers.axes[c].scale = 1;
  if (least == most) return;
  // Multiples of the least if they are near to that, else as exact as can be.
  double unit = least;
  for (const double l : lengths)
    if (l > 0 && std::fabs(l / unit - std::floor(l / unit + .5)) > .01 * (l / unit)) unit = 0;
  if (unit == 0 || most / unit > 65535) unit = most / 65535;
  for (std::size_t c = 0; c < lengths.size(); ++c)
    if (lengths[c] > 0)
      numbers.axes[c].scale =
          static_cast<std::uint32_t>(std::clamp(std::floor(lengths[c] / unit + .5), 1., 65535.));
}

namespace {

std::string short_number(double v) {
  char text[40];
  std::snprintf(text, sizeof text, "%.9g", v);
  return text;
}

}  // namespace

std::string describe(const Numbers& numbers, std::size_t component) {
  const NumberSystem& s = numbers.systems[component];
  const Axis& axis = numbers.axes[component];
  std::string text;
  // Whether a divisor is a power of ten, and then of which exponent.
  int decimals = -1;
  for (unsigned e = 0; e <= most_integer_tens; ++e)
    if (s.divisor == integer_tens[e]) decimals = static_cast<int>(e);
  const auto counted = [](unsigned n, const char* what) {
    return std::to_string(n) + " " + what + (n == 1 ? "" : "s");
  };
  switch (s.map) {
    case NumberMap::word:
      text = axis.top == 0 ? "constant" : is_float(numbers.scalar) ? "words" : "integers";
      if (s.step > 1) text = "steps of " + std::to_string(s.step);
      break;
    case NumberMap::quotient:
      if (s.step == 1 && decimals >= 0)
        text = decimals == 0 ? "integers" : counted(static_cast<unsigned>(decimals), "decimal");
      else if (s.step == 1)
        text = "steps of 1/" + std::to_string(s.divisor);
      else
        text = "steps of " + short_number(spacing(s));
      break;
    case NumberMap::affine:
      text = "steps of " + short_number(spacing(s)) + (s.single ? " in floats" : "");
      break;
    case NumberMap::octahedral:
      return "directions of " + counted(s.precision, "bit") + (s.single ? " in floats" : "");
    case NumberMap::digits: text = counted(s.precision, "digit"); break;
    case NumberMap::binary: text = "float, " + counted(s.precision, "bit"); break;
    case NumberMap::printed:
      text = "steps of " +
             (s.step == 1 ? "1/" + std::to_string(s.divisor) : short_number(spacing(s))) + " in " +
             counted(s.precision, s.decimals ? "decimal" : "digit");
      break;
  }
  if (s.ulps > 0) text += " +- " + counted(s.ulps, "ulp");
  if (!axis.palette.empty())
    text = "palette of " + std::to_string(axis.palette.size()) + ", " + text;
  return text;
}

}  // namespace clers::internal
