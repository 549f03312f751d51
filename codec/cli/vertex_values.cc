#include "codec/cli/vertex_values.h"

#include <cmath>
#include <cstring>
#include <limits>
#include <type_traits>

namespace clers::cli {

double load(Scalar scalar, const std::byte* at) {
  return with_type(scalar, [&](auto value) {
    std::memcpy(&value, at, sizeof value);
    return static_cast<double>(value);
  });
}

std::array<double, 3> load_three(const Attribute& a, std::size_t i) {
  const std::size_t size = size_of(a.scalar);
  const std::byte* p = a.data.data() + i * a.stride();
  return {load(a.scalar, p), load(a.scalar, p + size), load(a.scalar, p + 2 * size)};
}

void store(Scalar scalar, double x, std::byte* at) {
  with_type(scalar, [&](auto value) {
    using T = decltype(value);
    if constexpr (std::is_integral_v<T>) {
      using Limits = std::numeric_limits<T>;
      const double whole = std::round(x);
      value = whole <= static_cast<double>(Limits::min())   ? Limits::min()
              : whole >= static_cast<double>(Limits::max()) ? Limits::max()
                                                            : static_cast<T>(whole);
    } else {
      value = static_cast<T>(x);
    }
    std::memcpy(at, &value, sizeof value);
  });
}

}  // namespace clers::cli
