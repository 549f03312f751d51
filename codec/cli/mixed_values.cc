#include "codec/cli/mixed_values.h"

#include <cmath>
#include <cstring>

#include "codec/cli/vertex_values.h"

namespace clers::cli {

MixedValues::MixedValues(const Attribute& of)
    : of_(of),
      given_(of.value_count()),
      mixed_(of.scalar == Scalar::float32 || of.scalar == Scalar::float64 ||
             size_of(of.scalar) == 1),
      direction_(of.name == "normal" && of.components == 3 && size_of(of.scalar) > 1) {}

double MixedValues::number(std::uint32_t value, std::size_t k) const {
  return value < given_
             ? load(of_.scalar, of_.data.data() + value * of_.stride() + k * size_of(of_.scalar))
             : mixtures_[(value - given_) * of_.components + k];
}

std::uint32_t MixedValues::mix(const std::array<std::uint32_t, 3>& of,
                               const std::array<double, 3>& weights) {
  std::size_t most = 0;
  bool mixable = mixed_;
  for (std::size_t i = 0; i < 3; ++i) {
    if (weights[i] > weights[most]) most = i;
    if (weights[i] > 0 && of[i] == no_value) mixable = false;
  }
  bool alike = true;
  for (std::size_t i = 0; i < 3; ++i) alike = alike && (weights[i] == 0 || of[i] == of[most]);
  if (!mixable || alike) return of[most];

  const std::size_t first = mixtures_.size(), n = of_.components;
  double wanted = 0, found = 0;  // lengths
  for (std::size_t i = 0; i < 3; ++i) {
    double squares = 0;
    for (std::size_t k = 0; k < n && direction_ && weights[i] > 0; ++k)
      squares += number(of[i], k) * number(of[i], k);
    wanted += weights[i] * std::sqrt(squares);
  }
  for (std::size_t k = 0; k < n; ++k) {
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i)
      if (weights[i] > 0) sum += weights[i] * number(of[i], k);
    found += sum * sum;
    mixtures_.push_back(sum);
  }
  if (direction_ && found > 0 && std::isfinite(found) && std::isfinite(wanted))
    for (std::size_t k = 0; k < n; ++k) mixtures_[first + k] *= wanted / std::sqrt(found);
  return static_cast<std::uint32_t>(given_ + first / n);
}

bool MixedValues::same(std::uint32_t a, std::uint32_t b) const {
  if (a == b) return true;
  if (a >= given_ || b >= given_) return false;
  const std::byte* data = of_.data.data();
  return std::memcmp(data + a * of_.stride(), data + b * of_.stride(), of_.stride()) == 0;
}

bool MixedValues::less(std::uint32_t a, std::uint32_t b) const {
  if (a >= given_ || b >= given_) return a < b;
  const std::byte* data = of_.data.data();
  return std::memcmp(data + a * of_.stride(), data + b * of_.stride(), of_.stride()) < 0;
}

void MixedValues::write(std::uint32_t value, std::byte* to) const {
  if (value < given_) {
    std::memcpy(to, of_.data.data() + value * of_.stride(), of_.stride());
    return;
  }
  for (std::size_t k = 0; k < of_.components; ++k)
    store(of_.scalar, number(value, k), to + k * size_of(of_.scalar));
}

}  // namespace clers::cli
