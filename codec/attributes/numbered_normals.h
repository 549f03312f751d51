// Normals that are three numbers. They are coded from the least that is predicted to the largest;
// of unit vectors the last follows from the others, but for a rounding.
#ifndef CLERS_CODEC_ATTRIBUTES_NUMBERED_NORMALS_H
#define CLERS_CODEC_ATTRIBUTES_NUMBERED_NORMALS_H

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "codec/attributes/known_values.h"
#include "codec/attributes/mixed_contexts.h"
#include "codec/attributes/normal_expectation.h"
#include "codec/attributes/normal_formula.h"
#include "codec/numbers/number_line.h"

namespace clers::internal {

/// Codes three numbers a normal.
template <class Int, class Coder>
class NumberedNormals {
 public:
  NumberedNormals(Coder& coder, const Numbers& numbers, bool unit_vectors,
                  const FormulaNormals& formula, std::span<Int> rows)
      : coder_(coder),
        numbers_(numbers),
        unit_vectors_(unit_vectors),
        lines_(number_lines(numbers)),
        expectation_(formula, rows.size() / 3),
        rows_(rows),
        sizes_(rows.size() / 3),
        contexts_(NormalContexts::counts, 6) {}

  /// False if an integer that is decoded is not in 0 .. top.
  bool code(std::uint32_t v, const Nearby& nearby) {
    Vector3 normal;
    const unsigned kind =
        expectation_.expect(v, nearby, normal, [&](std::uint32_t u) { return vector(u); });
    std::array<unsigned, 3> axis = {0, 1, 2};
    for (unsigned i = 0; i < 3; ++i)
      for (unsigned j = i; j > 0 && std::fabs(normal[axis[j]]) < std::fabs(normal[axis[j - 1]]);
           --j)
        std::swap(axis[j], axis[j - 1]);
    NormalContexts context;
    const unsigned around = expected_size(nearby, sizes_, 4 * 200);
    context.shape = expectation_.shape();
    Vector3 actual = {};
    unsigned largest = 0, off = 0;
    for (unsigned i = 0; i < 3; ++i) {
      const unsigned c = axis[i];
      double x = normal[c];
      if (i == 2 && unit_vectors_ && largest > 9) {
        const double square =
            1 - actual[axis[0]] * actual[axis[0]] - actual[axis[1]] * actual[axis[1]];
        if (square > 0) x = x < 0 ? -std::sqrt(square) : std::sqrt(square);
      }
      const NumberLine& line = *lines_[c];
      const std::uint64_t top = numbers_.axes[c].top, k = line.nearest(x);
      const double here = line.value(k), step = k < top ? line.value(k + 1) - here
                                                : k > 0 ? here - line.value(k - 1)
                                                        : 0;
      const unsigned length = size_of(step);
      const auto in_steps = [&](unsigned size) { return size > length ? size - length : 0; };
      context.component = i;
      context.expected = in_steps(around);
      for (std::size_t j = 0; j < 2; ++j)
        context.near[j] =
            nearby.count > j ? std::min(in_steps(sizes_[nearby.around[j]]) / 2, 18u) : 19;
      context.part = step > 0 ? NormalContexts::part_of((x - here) / step) : 8;
      contexts_.set(context.of_tables(), 3 * kind + i);
      const auto predicted = static_cast<std::int64_t>(k);
      const std::int64_t r = contexts_.code(
          coder_, Coder::encodes ? static_cast<std::int64_t>(row(v, c)) - predicted : 0);
      if (r < -predicted || r > static_cast<std::int64_t>(top) - predicted) return false;
      row(v, c) = static_cast<Int>(predicted + r);
      actual[c] = line.value(static_cast<std::uint64_t>(predicted + r));
      context.before = quarters_of(static_cast<std::uint64_t>(r < 0 ? -r : r));
      context.before_negative = r < 0;
      largest = std::max(largest, context.before);
      off = std::max(off, size_of(actual[c] - x));
    }
    sizes_[v] = static_cast<std::uint16_t>(off);
    expectation_.learn(v, normal, actual);
    return true;
  }

  static std::uint64_t memory(std::uint64_t values) {
    return 2 * values + NormalExpectation::memory(values) +
           MixedContexts::memory(NormalContexts::counts, 6);
  }

 private:
  /// Of a length, in quarter octaves from 2^-200 on.
  static unsigned size_of(double x) {
    x = std::fabs(NumberLine::tame(x));
    if (x == 0) return 0;
    const int e = std::ilogb(x);
    const auto next = static_cast<unsigned>(std::scalbn(x, 2 - e));  // 4 .. 7
    return static_cast<unsigned>(4 * (e + 200)) + next - 4;
  }
  Int& row(std::size_t v, std::size_t c) { return rows_[3 * v + c]; }
  Vector3 vector(std::size_t v) const {
    Vector3 x;
    for (std::size_t c = 0; c < 3; ++c)
      x[c] = lines_[c]->value(static_cast<std::uint64_t>(rows_[3 * v + c]));
    return x;
  }

  Coder& coder_;
  const Numbers& numbers_;
  const bool unit_vectors_;
  const NumberLines lines_;
  NormalExpectation expectation_;
  const std::span<Int> rows_;
  std::vector<std::uint16_t> sizes_;  // of what was off, in quarter octaves
  MixedContexts contexts_;
};

}  // namespace clers::internal

#endif
