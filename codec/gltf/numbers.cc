// A double as others write it.
#include <rapidjson/internal/dtoa.h>

#include <charconv>
#include <cmath>

#include "codec/gltf/bounds.h"

namespace clers::gltf {
namespace {

/// value = 0.d1 d2 d3 .. * 10^point
struct Digits {
  std::string digits;
  int point = 0;
};

/// The fewest that give it back, without its sign. Precondition: not 0, finite.
template <class Float>
Digits digits_of(Float value) {
  char text[64];
  const auto end =
      std::to_chars(text, text + sizeof text, std::fabs(value), std::chars_format::scientific).ptr;
  Digits result;
  const char* at = text;
  for (; at < end && *at != 'e'; ++at)
    if (*at != '.') result.digits += *at;
  int exponent = 0;
  at += at[1] == '+' ? 2 : 1;
  std::from_chars(at, end, exponent);
  result.point = exponent + 1;
  return result;
}

/// `low` < point <= `high`: without an exponent, which has so many digits at least.
std::string laid_out(const Digits& d, int low, int high, std::size_t exponent_digits,
                     const char* of_integers) {
  const int n = static_cast<int>(d.digits.size());
  if (d.point > low && d.point <= high) {
    if (d.point <= 0) return "0." + std::string(static_cast<std::size_t>(-d.point), '0') + d.digits;
    if (n <= d.point)
      return d.digits + std::string(static_cast<std::size_t>(d.point - n), '0') + of_integers;
    const auto point = static_cast<std::size_t>(d.point);
    return d.digits.substr(0, point) + "." + d.digits.substr(point);
  }
  std::string exponent = std::to_string(std::abs(d.point - 1));
  if (exponent.size() < exponent_digits) exponent.insert(0, exponent_digits - exponent.size(), '0');
  return d.digits.substr(0, 1) + (n > 1 ? "." + d.digits.substr(1) : "") +
         (d.point > 0 ? "e+" : "e-") + exponent;
}

}  // namespace

std::string text_of(double value, Style style) {
  if (style == Style::rapidjson) {
    char text[64];
    return {text, rapidjson::internal::dtoa(value, text)};
  }
  const bool script = style == Style::script || style == Style::script_float;
  const bool as_float = style == Style::script_float || style == Style::python_float;
  if (value == 0) return script ? "0" : std::signbit(value) ? "-0.0" : "0.0";
  const Digits digits = as_float ? digits_of(static_cast<float>(value)) : digits_of(value);
  // As Number::toString of ECMAScript and repr() of Python part them.
  return (value < 0 ? "-" : "") +
         (script ? laid_out(digits, -6, 21, 1, "") : laid_out(digits, -4, 16, 2, ".0"));
}

}  // namespace clers::gltf
