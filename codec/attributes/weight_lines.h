// Weights as numbers, and whose weight a component is: what the model of weights computes with.
#ifndef CLERS_CODEC_ATTRIBUTES_WEIGHT_LINES_H
#define CLERS_CODEC_ATTRIBUTES_WEIGHT_LINES_H

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <optional>
#include <vector>

#include "codec/attributes/residual_sizes.h"
#include "codec/mesh.h"
#include "codec/numbers/number_line.h"
#include "codec/numbers/number_system.h"

namespace clers::internal {

/// The weights of one component, by integers or, with a palette, ranks.
class WeightLine {
 public:
  WeightLine(const NumberSystem& system, const Axis& axis, Scalar scalar)
      : axis_(axis), line_(number_line(system, axis, scalar)) {
    const std::uint64_t near = nearest(0);
    if (weight(near) == 0) zero_ = near;
  }
  std::uint64_t top() const { return axis_.palette.empty() ? axis_.top : axis_.palette.size() - 1; }
  double weight(std::uint64_t k) const {
    return line_->value(axis_.palette.empty() ? k : axis_.palette[static_cast<std::size_t>(k)]);
  }
  std::uint64_t nearest(double weight) const {
    const std::uint64_t k = line_->nearest(weight);
    const auto& p = axis_.palette;
    if (p.empty()) return k;
    const auto at = std::lower_bound(p.begin(), p.end(), k) - p.begin();
    return std::min(static_cast<std::uint64_t>(at), top());
  }
  /// What stands for the weight 0, if there is one.
  std::optional<std::uint64_t> zero() const { return zero_; }
  /// The size of a step, beside those of other components.
  unsigned step_size() const { return size_of(std::uint64_t(axis_.scale) << 8); }

 private:
  const Axis& axis_;
  std::unique_ptr<NumberLine> line_;
  std::optional<std::uint64_t> zero_;
};
using WeightLines = std::vector<WeightLine>;

inline WeightLines weight_lines(const Numbers& numbers) {
  WeightLines lines;
  for (std::size_t c = 0; c < numbers.axes.size(); ++c)
    lines.emplace_back(numbers.systems[c], numbers.axes[c], numbers.scalar);
  return lines;
}

/// Whose weight a component is: that of a joint, where these are known; else a component is the
/// same everywhere.
class WeightOwners {
 public:
  /// nullptr, or what fits.
  explicit WeightOwners(const Attribute* joints)
      : data_(joints == nullptr ? nullptr : joints->data.data()),
        wide_(joints != nullptr && joints->scalar == Scalar::uint16),
        width_(joints == nullptr ? 0 : joints->components) {}

  bool known() const { return data_ != nullptr; }
  bool equal(std::size_t v, std::size_t c, std::size_t u, std::size_t d) const {
    return known() ? joint(v, c) == joint(u, d) : c == d;
  }

 private:
  std::uint32_t joint(std::size_t v, std::size_t c) const {
    const std::size_t i = v * width_ + c;
    if (!wide_) return std::to_integer<std::uint32_t>(data_[i]);
    std::uint16_t word;
    std::memcpy(&word, data_ + 2 * i, 2);
    return word;
  }

  const std::byte* data_;
  bool wide_;
  std::size_t width_;
};

}  // namespace clers::internal

#endif
