// Values of any type, and what lies between them.
#ifndef CLERS_CODEC_CLI_MIXED_VALUES_H
#define CLERS_CODEC_CLI_MIXED_VALUES_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "codec/mesh.h"

namespace clers::cli {

/// Values as they were, and mixtures of them: floats and bytes are mixed, but what other integers
/// name is one of them. A vector of three called normal keeps its length.
class MixedValues {
 public:
  explicit MixedValues(const Attribute& of);

  /// The number of the sum of weighted values; or, where values are not mixed or one is none, the
  /// one of most weight. Weights sum up to 1.
  std::uint32_t mix(const std::array<std::uint32_t, 3>& of, const std::array<double, 3>& weights);
  bool same(std::uint32_t a, std::uint32_t b) const;
  /// An order in which values that are the same are neighbours.
  bool less(std::uint32_t a, std::uint32_t b) const;
  void write(std::uint32_t value, std::byte* to) const;

 private:
  double number(std::uint32_t value, std::size_t k) const;

  const Attribute& of_;
  std::size_t given_;
  bool mixed_, direction_;
  std::vector<double> mixtures_;  // numbered on from the given ones
};

}  // namespace clers::cli

#endif
