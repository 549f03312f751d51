// Which values are equal, bit for bit, and values in another order.
#ifndef CLERS_CODEC_ATTRIBUTES_DISTINCT_VALUES_H
#define CLERS_CODEC_ATTRIBUTES_DISTINCT_VALUES_H

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <numeric>
#include <span>
#include <vector>

#include "codec/base/no_index.h"
#include "codec/mesh.h"

namespace clers::internal {

/// A number for each value, the same for equal ones, in the order in which they are first met.
/// Cost: n log n; 8 bytes a value, of which 4 are the result.
inline std::vector<std::uint32_t> distinct_values(std::span<const std::byte> values,
                                                  std::size_t stride) {
  const std::size_t count = values.size() / stride;
  std::vector<std::uint32_t> sorted(count), result(count);
  std::iota(sorted.begin(), sorted.end(), 0u);
  const auto order = [&](std::uint32_t i, std::uint32_t j) {
    return std::memcmp(values.data() + i * stride, values.data() + j * stride, stride);
  };
  std::sort(sorted.begin(), sorted.end(), [&](std::uint32_t i, std::uint32_t j) {
    const int o = order(i, j);
    return o != 0 ? o < 0 : i < j;
  });
  // The first of its equals, then numbers in the order of these.
  for (std::size_t k = 0; k < count; ++k)
    result[sorted[k]] =
        k > 0 && order(sorted[k - 1], sorted[k]) == 0 ? result[sorted[k - 1]] : sorted[k];
  std::uint32_t next = 0;
  for (std::uint32_t i = 0; i < count; ++i) result[i] = result[i] == i ? next++ : result[result[i]];
  return result;
}

/// Numbers the values of an attribute by index in the order of their first use, those that no
/// element has behind them as they were; then, if there are any, with `numbers` for these. Cost:
/// linear; as many bytes as its values take again, and 4 for each.
inline void number_by_first_use(Attribute& a, std::span<const std::uint32_t> numbers) {
  const std::size_t stride = a.stride(), count = a.value_count();
  std::vector<std::uint32_t> now(count, no_index);
  std::uint32_t next = 0;
  const auto number = [&](std::uint32_t n) { return numbers.empty() ? n : numbers[n]; };
  for (std::uint32_t& i : a.indices) {
    if (i == no_value) continue;
    if (now[i] == no_index) now[i] = number(next++);
    i = now[i];
  }
  std::vector<std::byte> data(a.data.size());
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t to = now[i] == no_index ? number(next++) : now[i];
    std::memcpy(data.data() + to * stride, a.data.data() + i * stride, stride);
  }
  a.data = std::move(data);
}

}  // namespace clers::internal

#endif
