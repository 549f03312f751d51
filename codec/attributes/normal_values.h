// Normals, or other directions, along a surface: each is predicted by a formula of the positions
// around it, and what it is off is coded, the same by who encodes and who decodes.
//
// Where normals are points of an octahedral grid, it is in the square as it unfolds around the
// axis that the prediction is nearest to, and with the signs that it has: so no residual crosses a
// border.
//
//      +-----------+        p: the point predicted, in the frame where 0 <= x <= y <= z
//      |  /  |  \  |        n: the normal. The residual is n - p along x, and along y.
//      |/    |p n\ |        A tip of the diamond is far from p: S / 2 and more.
//      +-----+-----+ x
//      | \   |   / |
//      +-----------+
//
// Else they are three numbers. They are coded from the least that is predicted to the largest; of
// unit vectors the last follows from the others, but for a rounding.
#ifndef CLERS_CODEC_ATTRIBUTES_NORMAL_VALUES_H
#define CLERS_CODEC_ATTRIBUTES_NORMAL_VALUES_H

#include <algorithm>
#include <array>
#include <bit>
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
#include "codec/numbers/octahedral.h"

namespace clers::internal {

/// What a stream of normals says first.
struct NormalModel {
  NormalFormula formula;
  bool unit_vectors = false;  ///< the last of three numbers follows from the others

  /// Whether it is one for values with these numbers: points of a grid are directions alone.
  bool fits(const Numbers& numbers) const {
    return formula.is_one() && (numbers.octahedral_bits() == 0 || (formula.unit && !unit_vectors));
  }
};
inline constexpr std::uint32_t normal_models = 2 * normal_formulas;
inline std::uint32_t number_of(const NormalModel& m) {
  return number_of(m.formula) + (m.unit_vectors ? normal_formulas : 0);
}
inline NormalModel normal_model(std::uint32_t number) {
  return {normal_formula(number % normal_formulas), number >= normal_formulas};
}

/// Codes points of an octahedral grid, two integers each.
template <class Int, class Coder>
class OctahedralNormals {
 public:
  OctahedralNormals(Coder& coder, unsigned bits, const FormulaNormals& formula, std::span<Int> rows)
      : coder_(coder),
        grid_(bits),
        expectation_(formula, rows.size() / 2),
        rows_(rows),
        sizes_(rows.size() / 2),
        contexts_(NormalContexts::counts, 4) {}

  /// False if what is decoded is no point.
  bool code(std::uint32_t v, const Nearby& nearby) {
    Vector3 normal;
    const unsigned kind = expectation_.expect(
        v, nearby, normal, [&](std::uint32_t u) { return OctahedralGrid::direction(point(u)); });
    const Vector3 on = grid_.project(normal);
    const OctahedralPoint p = grid_.nearest(on);
    const Frame frame(p, on);
    const OctahedralPoint expected = frame.from(p);
    std::array<std::int32_t, 2> given = {};
    if constexpr (Coder::encodes) given = grid_.unfold(frame.from(point(v)));
    NormalContexts context;
    context.expected = expected_size(nearby, sizes_, 20);
    for (std::size_t i = 0; i < 2; ++i)
      context.near[i] = nearby.count > i ? std::min<unsigned>(sizes_[nearby.around[i]], 18) : 19;
    context.shape = expectation_.shape();
    const std::array<unsigned, 2> parts = {part(frame, on, p, 0), part(frame, on, p, 1)};
    std::array<std::int32_t, 2> place;
    std::uint64_t off = 0;
    for (unsigned i = 0; i < 2; ++i) {
      context.component = i;
      context.part = parts[i];
      contexts_.set(context.of_tables(), 2 * kind + i);
      const std::int64_t r = contexts_.code(coder_, given[i] - expected[i]);
      if (r < -grid_.size() - expected[i] || r > grid_.size() - expected[i]) return false;
      place[i] = static_cast<std::int32_t>(expected[i] + r);
      context.before = quarters_of(static_cast<std::uint64_t>(r < 0 ? -r : r));
      context.before_negative = r < 0;
      off += static_cast<std::uint64_t>(r < 0 ? -r : r);
    }
    const OctahedralPoint folded = grid_.fold(place[0], place[1]);
    if (grid_.unfold(folded) != place) return false;
    const OctahedralPoint actual = frame.to(folded);
    const auto integers = grid_.integers(actual);
    for (std::size_t i = 0; i < 2; ++i)
      rows_[2 * std::size_t(v) + i] = static_cast<Int>(integers[i]);
    sizes_[v] = static_cast<std::uint8_t>(quarters_of(off));
    expectation_.learn(v, normal, {double(actual[0]), double(actual[1]), double(actual[2])});
    return true;
  }

  static std::uint64_t memory(std::uint64_t values) {
    return values + NormalExpectation::memory(values) +
           MixedContexts::memory(NormalContexts::counts, 4);
  }

 private:
  /// Axes in the order of a point's magnitudes, with its signs.
  class Frame {
   public:
    Frame(const OctahedralPoint& p, const Vector3& on) {
      for (unsigned i = 0; i < 3; ++i)
        for (unsigned j = i; j > 0 && std::abs(p[axis_[j]]) < std::abs(p[axis_[j - 1]]); --j)
          std::swap(axis_[j], axis_[j - 1]);
      for (unsigned i = 0; i < 3; ++i) sign_[i] = on[axis_[i]] < 0 ? -1 : 1;
    }
    OctahedralPoint from(const OctahedralPoint& p) const {
      return {{sign_[0] * p[axis_[0]], sign_[1] * p[axis_[1]], sign_[2] * p[axis_[2]]}};
    }
    OctahedralPoint to(const OctahedralPoint& p) const {
      OctahedralPoint q;
      for (unsigned i = 0; i < 3; ++i) q[axis_[i]] = sign_[i] * p[i];
      return q;
    }
    double from(const Vector3& on, unsigned i) const { return sign_[i] * on[axis_[i]]; }

   private:
    std::array<unsigned, 3> axis_ = {0, 1, 2};
    std::array<std::int32_t, 3> sign_;
  };

  static unsigned part(const Frame& frame, const Vector3& on, const OctahedralPoint& p,
                       unsigned i) {
    return NormalContexts::part_of(frame.from(on, i) - frame.from(p)[i]);
  }
  OctahedralPoint point(std::size_t v) const {
    return grid_.point(static_cast<std::int64_t>(rows_[2 * v]),
                       static_cast<std::int64_t>(rows_[2 * v + 1]));
  }

  Coder& coder_;
  const OctahedralGrid grid_;
  NormalExpectation expectation_;
  const std::span<Int> rows_;
  std::vector<std::uint8_t> sizes_;  // of what was off, in quarter octaves
  MixedContexts contexts_;
};

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

/// Codes the first `most` normals that for_each_with_nearby visits, with Coder, one that encodes
/// what is in the rows or one that fills them. False if what is decoded is none.
template <class Int, class Coder>
bool code_normals(Coder& coder, const NormalModel& model, const Numbers& numbers,
                  const FormulaNormals& formula, const ValueSurface& along, std::span<Int> rows,
                  std::size_t most) {
  const auto code_all = [&](auto&& normals) {
    return for_each_with_nearby(
        along, rows.size() / numbers.axes.size(), most,
        [&](std::uint32_t v, const Nearby& nearby) { return normals.code(v, nearby); });
  };
  if (const unsigned bits = numbers.octahedral_bits())
    return code_all(OctahedralNormals<Int, Coder>(coder, bits, formula, rows));
  return code_all(NumberedNormals<Int, Coder>(coder, numbers, model.unit_vectors, formula, rows));
}

}  // namespace clers::internal

#endif
