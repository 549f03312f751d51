// What a normal is expected to be, and how far off it may be: by a formula of the geometry, by
// what is known around, and by how much of it the formula explained there.
#ifndef CLERS_CODEC_ATTRIBUTES_NORMAL_EXPECTATION_H
#define CLERS_CODEC_ATTRIBUTES_NORMAL_EXPECTATION_H

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "codec/attributes/known_values.h"
#include "codec/attributes/mixed_contexts.h"
#include "codec/attributes/normal_formula.h"

namespace clers::internal {

/// The size of a magnitude in quarter octaves, 0 for 0.
inline unsigned quarters_of(std::uint64_t n) {
  if (n == 0) return 0;
  const unsigned octave = static_cast<unsigned>(std::bit_width(n)) - 1;
  const std::uint64_t next = octave >= 2 ? n >> (octave - 2) : n << (2 - octave);
  return 4 * octave + static_cast<unsigned>(next & 3) + 1;
}

/// What is the same for both kinds of normals: predictions, and how far off they may be.
class NormalExpectation {
 public:
  NormalExpectation(const FormulaNormals& formula, std::size_t values)
      : formula_(formula), opposite_(values) {}

  /// What value v is expected to be, and which kind of expectation it is: 0 by the formula, or what
  /// a neighbour for which it gives the same is; 1 by the value before.
  template <class Known>
  unsigned expect(std::uint32_t v, const Nearby& nearby, Vector3& normal, const Known& known) {
    away_ = false;
    shape_ = {};
    if (const FormulaNormals::Result* by_formula = formula_.at(v)) {
      normal = by_formula->normal;
      shape_ = by_formula->shape;
      std::uint32_t u = nearby.count > 0 ? nearby.around[0] : nearby.same;
      if (nearby.same != Nearby::none && is_same(nearby.same, normal)) u = nearby.same;
      if (u == Nearby::none) return 0;
      // Faces that were turned for coding have their normals on the other side.
      away_ = opposite_[u];
      if (is_same(u, normal)) {
        const Vector3 there = known(u);
        if (dot(there, there) > 0) normal = there;
      } else if (away_) {
        for (double& x : normal) x = -x;
      }
      return 0;
    }
    normal = {0, 0, 1};
    if (nearby.before != Nearby::none) normal = known(nearby.before);
    return 1;
  }
  /// Learns what value v is.
  void learn(std::uint32_t v, const Vector3& expected, const Vector3& normal) {
    opposite_[v] = (dot(expected, normal) < 0) != away_;
  }
  /// Of the triangles around the value that is expected.
  FormulaNormals::Shape shape() const { return shape_; }

  static std::uint64_t memory(std::uint64_t values) { return values; }

 private:
  /// Whether the formula gives value u this normal: the same face mostly, or the same plane. Then
  /// its value was the same, too.
  bool is_same(std::uint32_t u, const Vector3& normal) const {
    const FormulaNormals::Result* there = formula_.at(u);
    return there != nullptr && std::fabs(there->normal[0] - normal[0]) < 0x1p-40 &&
           std::fabs(there->normal[1] - normal[1]) < 0x1p-40 &&
           std::fabs(there->normal[2] - normal[2]) < 0x1p-40;
  }

  const FormulaNormals& formula_;
  std::vector<std::uint8_t> opposite_;
  FormulaNormals::Shape shape_;
  bool away_ = false;
};

/// Contexts of what a residual may be: how far off what is near it was, how bent and how large the
/// triangles are, where between two integers the prediction is, and the components before.
struct NormalContexts {
  static constexpr unsigned components = 3, sizes = 16, areas = 64, bends = 10, parts = 17,
                            others = 12, sides = 20;
  static constexpr std::array<std::uint32_t, MixedContexts::tables> counts = {
      components * areas * bends, components* parts* sizes, components * 2 * others* parts,
      components* sides* sides};

  unsigned component = 0;
  unsigned expected = 0;                  ///< size, in quarter octaves
  std::array<unsigned, 2> near = {0, 0};  ///< what the ends of the gate were off
  FormulaNormals::Shape shape;
  unsigned part = 0;
  unsigned before = 0;  ///< size of the component before this
  bool before_negative = false;

  std::array<std::uint32_t, MixedContexts::tables> of_tables() const {
    const unsigned size = std::min(expected / 2, sizes - 1),
                   other = std::min(before > 5 ? 5 + (before - 5) / 2 : before, others - 1);
    return {
        component * areas * bends + triangles(), (component * parts + part) * sizes + size,
        ((component * 2 + before_negative) * others + other) * parts + part,
        (component * sides + std::min(near[0], sides - 1)) * sides + std::min(near[1], sides - 1)};
  }
  /// How large the triangles around are, and how bent.
  unsigned triangles() const {
    const auto area = static_cast<unsigned>(std::clamp(shape.size - 40, 0, int(areas) - 1));
    return area * bends + std::min(static_cast<unsigned>(std::bit_width(shape.bent)), bends - 1);
  }
  /// Where a number is beside the integer that is nearest, in eighths.
  static unsigned part_of(double off) {
    // The double is not negative, so that it is cut downward.
    return static_cast<unsigned>(std::clamp(off * 8 + 8.5, 0., 16.));
  }
};

/// The mean of what was off around, or what the one before was.
template <class Size>
unsigned expected_size(const Nearby& nearby, const std::vector<Size>& sizes, unsigned none) {
  if (nearby.count == 0) return nearby.before == Nearby::none ? none : sizes[nearby.before];
  unsigned sum = 0;
  for (std::size_t i = 0; i < nearby.count; ++i) sum += sizes[nearby.around[i]];
  return (sum + static_cast<unsigned>(nearby.count) / 2) / static_cast<unsigned>(nearby.count);
}

}  // namespace clers::internal

#endif
