// How wide the numbers of a text file must be kept.
#include "codec/io/numbers.h"

#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

namespace clers::io {

namespace {

// The text's value as both widths. Going through float64 rounds twice, which is wrong only if the
// first rounding ends in the middle between two float32: then the text is read again.
struct Decimal {
  double wide;
  float narrow;
};

constexpr bool between_two_float32(double value) {
  return (std::bit_cast<std::uint64_t>(value) & 0x1fffffff) == 0x10000000;
}

float nearest_float32(double wide, std::string_view text) {
  // Below the smallest normal float32 the middle is elsewhere; above the largest there is none.
  const double size = std::fabs(wide);
  if (size >= 0x1p-126 && size <= 0x1.fffffep127 && !between_two_float32(wide))
    return static_cast<float>(wide);
  if (wide == 0 || std::isnan(wide)) return static_cast<float>(wide);
  constexpr float infinity = std::numeric_limits<float>::infinity();
  float narrow = 0;
  if (!Text(text).number(narrow)) return std::signbit(wide) ? -infinity : infinity;
  return narrow;
}

// Half of 10 to the power of the place of the last digit.
double half_unit_of_last_digit(std::string_view text) {
  int exponent = 0, places = 0;
  bool point = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '.') {
      point = true;
    } else if (text[i] == 'e' || text[i] == 'E') {
      i += text.substr(i + 1).starts_with('+') ? 2u : 1u;
      std::from_chars(text.data() + i, text.data() + text.size(), exponent);
      break;
    } else {
      places += point;
    }
  }
  exponent -= places;
  constexpr double powers[] = {1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12};
  return exponent <= 0 && exponent > -static_cast<int>(std::size(powers))
             ? 0.5 / powers[-exponent]
             : 0.5 * std::pow(10.0, exponent);
}

// Half of the distance to the next float64, at most: how far a text is from its float64.
double half_step(double value) {
  constexpr std::uint64_t exponent = std::uint64_t{0x7ff} << 52;
  return std::bit_cast<double>(std::bit_cast<std::uint64_t>(value) & exponent) * 0x1p-53;
}

// Without sign, point, exponent and leading zeros.
std::string digits_that_count(std::string_view text) {
  std::string digits;
  for (const char c : text.substr(0, text.find_first_of("eE")))
    if (c >= '0' && c <= '9' && (c != '0' || !digits.empty())) digits += c;
  return digits;
}

bool is_decimal_of(const Decimal& value, std::string_view text) {
  if (value.wide == static_cast<double>(value.narrow) || std::isnan(value.wide)) return true;
  if (std::isinf(value.narrow)) return false;
  const double off = std::fabs(value.wide - static_cast<double>(value.narrow));
  if (off <= half_unit_of_last_digit(text) + half_step(value.wide)) return true;
  // Below a power of two float32 are denser, so that its shortest text may be off by more.
  char shortest[64];
  const char* end = std::to_chars(shortest, shortest + sizeof shortest, value.narrow,
                                  std::chars_format::scientific)
                        .ptr;
  return digits_that_count(text) ==
         digits_that_count({shortest, static_cast<std::size_t>(end - shortest)});
}

template <class T>
T value_at(const Attribute& attribute, std::size_t index) {
  T value;
  std::memcpy(&value, attribute.data.data() + index * sizeof value, sizeof value);
  return value;
}

void print_untyped(Output& out, double value) {
  char text[64];
  const char* end = std::to_chars(text, text + sizeof text, value).ptr;
  const std::string_view shortest(text, static_cast<std::size_t>(end - text));
  const Decimal as_read{value, nearest_float32(value, shortest)};
  if (value == static_cast<double>(as_read.narrow) || !is_decimal_of(as_read, shortest)) {
    out << shortest;
    return;
  }
  end = std::to_chars(text, text + sizeof text, value, std::chars_format::scientific, 16).ptr;
  out << std::string_view(text, static_cast<std::size_t>(end - text));
}

}  // namespace

bool Numbers::read(Text& text) {
  double wide = 0;
  text.skip_blanks();
  const char* from = text.at();
  if (!text.number(wide)) return false;
  wide_.push_back(wide);
  if (!all_narrow_) return true;
  const std::string_view token(from, static_cast<std::size_t>(text.at() - from));
  const Decimal value{wide, nearest_float32(wide, token)};
  all_narrow_ = is_decimal_of(value, token);
  if (all_narrow_)
    narrow_.push_back(value.narrow);
  else
    narrow_ = {};
  return true;
}

void Numbers::push_zero() {
  wide_.push_back(0);
  if (all_narrow_) narrow_.push_back(0);
}

Attribute Numbers::take(std::string name, Domain domain, unsigned components) {
  Attribute attribute{std::move(name),
                      domain,
                      all_narrow_ ? Scalar::float32 : Scalar::float64,
                      static_cast<std::uint8_t>(components),
                      {}};
  const auto* from = all_narrow_ ? reinterpret_cast<const std::byte*>(narrow_.data())
                                 : reinterpret_cast<const std::byte*>(wide_.data());
  attribute.data.assign(from, from + size() * size_of(attribute.scalar));
  *this = {};
  return attribute;
}

void print(Output& out, const Attribute& attribute, std::size_t index) {
  switch (attribute.scalar) {
    case Scalar::int8: return out.number<int>(value_at<std::int8_t>(attribute, index));
    case Scalar::uint8: return out.number<int>(value_at<std::uint8_t>(attribute, index));
    case Scalar::int16: return out.number<int>(value_at<std::int16_t>(attribute, index));
    case Scalar::uint16: return out.number<int>(value_at<std::uint16_t>(attribute, index));
    case Scalar::int32: return out.number(value_at<std::int32_t>(attribute, index));
    case Scalar::uint32: return out.number(value_at<std::uint32_t>(attribute, index));
    case Scalar::int64: return out.number(value_at<std::int64_t>(attribute, index));
    case Scalar::uint64: return out.number(value_at<std::uint64_t>(attribute, index));
    case Scalar::float32: return out.number(value_at<float>(attribute, index));
    case Scalar::float64: return out.number(value_at<double>(attribute, index));
  }
}

void print_untyped(Output& out, const Attribute& attribute, std::size_t index) {
  if (attribute.scalar == Scalar::float64)
    print_untyped(out, value_at<double>(attribute, index));
  else
    print(out, attribute, index);
}

Attribute of_255ths(Attribute colors) {
  if (colors.scalar != Scalar::float32) return colors;
  Attribute bytes{colors.name, colors.domain, Scalar::uint8, colors.components, {}};
  bytes.data.reserve(colors.data.size() / sizeof(float));
  for (std::size_t i = 0; i < colors.data.size() / sizeof(float); ++i) {
    const auto value = value_at<float>(colors, i);
    if (!(value >= 0 && value <= 1)) return colors;
    const auto k = static_cast<unsigned>(value * 255 + 0.5f);
    if (std::bit_cast<std::uint32_t>(static_cast<float>(k) / 255) !=
        std::bit_cast<std::uint32_t>(value))
      return colors;
    bytes.data.push_back(static_cast<std::byte>(k));
  }
  return bytes;
}

Attribute as_255ths(const Attribute& bytes) {
  Attribute colors{bytes.name, bytes.domain, Scalar::float32, bytes.components, {}};
  colors.data.resize(bytes.data.size() * sizeof(float));
  for (std::size_t i = 0; i < bytes.data.size(); ++i) {
    const float value = static_cast<float>(std::to_integer<unsigned>(bytes.data[i])) / 255;
    std::memcpy(colors.data.data() + i * sizeof value, &value, sizeof value);
  }
  return colors;
}

std::size_t count_lost_nans(const Attribute& attribute) {
  std::size_t lost = 0;
  const auto count = [&]<class Float, class Bits>(Float quiet, Bits sign) {
    for (std::size_t i = 0; i < attribute.data.size() / sizeof quiet; ++i) {
      const auto value = value_at<Float>(attribute, i);
      if (std::isnan(value) &&
          (std::bit_cast<Bits>(value) | sign) != (std::bit_cast<Bits>(quiet) | sign))
        ++lost;
    }
  };
  if (attribute.scalar == Scalar::float32)
    count(std::numeric_limits<float>::quiet_NaN(), std::uint32_t{1} << 31);
  if (attribute.scalar == Scalar::float64)
    count(std::numeric_limits<double>::quiet_NaN(), std::uint64_t{1} << 63);
  return lost;
}

}  // namespace clers::io
