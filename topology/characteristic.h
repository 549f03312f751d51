// The six counts of a surface, what each operator adds to them, and the change of basis between
// counts and operators (Topological mesh operators, §2.2 and §5.1.3).
#ifndef CLERS_TOPOLOGY_CHARACTERISTIC_H
#define CLERS_TOPOLOGY_CHARACTERISTIC_H

#include <array>
#include <cstdint>
#include <optional>

#include <clers/topology/export.h>
#include <clers/topology/handle_case.h>
#include <clers/topology/stellar_case.h>

namespace CLERS_VISIBLE clers {

/// Vertices, edges, faces, boundary curves, genus and components: a point of the paper's space E^6.
struct Characteristic {
  std::int64_t v = 0;
  std::int64_t e = 0;
  std::int64_t f = 0;
  std::int64_t b = 0;
  std::int64_t g = 0;
  std::int64_t s = 0;

  friend constexpr bool operator==(const Characteristic&, const Characteristic&) = default;

  constexpr Characteristic& operator+=(const Characteristic& o) {
    v += o.v, e += o.e, f += o.f, b += o.b, g += o.g, s += o.s;
    return *this;
  }
  constexpr Characteristic& operator-=(const Characteristic& o) {
    v -= o.v, e -= o.e, f -= o.f, b -= o.b, g -= o.g, s -= o.s;
    return *this;
  }
  friend constexpr Characteristic operator+(Characteristic x, const Characteristic& y) {
    return x += y;
  }
  friend constexpr Characteristic operator-(Characteristic x, const Characteristic& y) {
    return x -= y;
  }
  friend constexpr Characteristic operator*(std::int64_t k, const Characteristic& x) {
    return {k * x.v, k * x.e, k * x.f, k * x.b, k * x.g, k * x.s};
  }

  /// v - e + f.
  constexpr std::int64_t euler() const { return v - e + f; }

  /// The Euler-Poincaré formula, v - e + f = 2(s - g) - b, with no count negative: necessary for
  /// the counts to be those of a surface, not sufficient.
  constexpr bool is_valid() const {
    return euler() == 2 * (s - g) - b && v >= 0 && e >= 0 && f >= 0 && b >= 0 && g >= 0 && s >= 0;
  }
};

inline constexpr unsigned handle_case_count = 7;
inline constexpr unsigned stellar_case_count = 3;

/// The case's name, as in the enumeration.
const char* name(HandleCase kind);
const char* name(StellarCase kind);

/// What create adds to the six counts; destroy subtracts it.
inline constexpr Characteristic effect_of_create{3, 3, 1, 1, 0, 1};

/// What a glue of this case adds to the six counts; the unglue that undoes it subtracts the same.
constexpr Characteristic effect(HandleCase kind) {
  constexpr Characteristic table[handle_case_count] = {
      {-2, -1, 0, -1, 0, -1}, {-2, -1, 0, 1, 0, 0},   {-2, -1, 0, -1, 1, 0}, {0, -1, 0, -1, 0, 0},
      {-1, -1, 0, 0, 0, 0},   {-1, -1, 0, -2, 0, -1}, {-1, -1, 0, -2, 1, 0},
  };
  return table[static_cast<unsigned>(kind)];
}

/// What a split of this case adds to the six counts; the weld that undoes it subtracts the same. A
/// flip adds nothing, and no stellar operator changes b, g and s: the topology stays.
constexpr Characteristic effect(StellarCase kind) {
  return kind == StellarCase::boundary_edge ? Characteristic{1, 2, 1, 0, 0, 0}
                                            : Characteristic{1, 3, 2, 0, 0, 0};
}

/// How many operators of each kind build (+1 each) or unbuild (-1 each) something: coordinates in
/// the paper's basis H, with zip as a seventh. The seven are not independent (2 zip = 1b + 2).
///
/// The cases of curves of one edge need no coordinate of their own: each counts as the glue of type
/// 1 that joins the curves, plus a close, minus a zip.
struct OperatorCounts {
  std::int64_t create = 0;           ///< type 0
  std::int64_t join_components = 0;  ///< type 1a
  std::int64_t split_curve = 0;      ///< type 1b
  std::int64_t join_curves = 0;      ///< type 1c
  std::int64_t close = 0;            ///< type 2
  std::int64_t perpendicular = 0;    ///< along the normal of the hyperplane; 0 for every surface
  std::int64_t zip = 0;

  friend constexpr bool operator==(const OperatorCounts&, const OperatorCounts&) = default;

  /// Counts `times` glues of this case (negative: unglues).
  constexpr void add(HandleCase kind, std::int64_t times = 1) {
    switch (kind) {
      case HandleCase::join_components: join_components += times; break;
      case HandleCase::split_curve: split_curve += times; break;
      case HandleCase::join_curves: join_curves += times; break;
      case HandleCase::close: close += times; break;
      case HandleCase::zip: zip += times; break;
      case HandleCase::join_components_at_loops:
        join_components += times, close += times, zip -= times;
        break;
      case HandleCase::join_curves_at_loops:
        join_curves += times, close += times, zip -= times;
        break;
    }
  }
};

/// The paper's Λ, rows v e f b g s, with the column of zip appended.
inline constexpr std::array<std::array<std::int64_t, 7>, 6> lambda_matrix{{
    {3, -2, -2, -2, 0, 1, -1},
    {3, -1, -1, -1, -1, -1, -1},
    {1, 0, 0, 0, 0, 1, 0},
    {1, -1, 1, -1, -1, 1, 0},
    {0, 0, 0, 1, 0, 2, 0},
    {1, -1, 0, 0, 0, -2, 0},
}};

/// Twelve times the paper's Λ⁻¹, rows type 0, 1a, 1b, 1c, 2, perpendicular.
inline constexpr std::array<std::array<std::int64_t, 6>, 6> lambda_inverse_matrix_12{{
    {-1, 1, 11, -1, -2, 2},
    {-3, 3, 9, -3, -6, -6},
    {-2, -4, 10, 4, -4, 4},
    {-2, 2, -2, -2, 8, 4},
    {3, -9, 15, -3, -6, 6},
    {1, -1, 1, 1, 2, -2},
}};

/// Λ: the counts these operators make of nothing.
Characteristic lambda(const OperatorCounts& counts);

/// Λ⁻¹: the operators that build these counts when exactly `zips` of them are zips. Nothing if
/// these are no whole numbers: a zip is half a 1b and half a 2, so `zips` must have the right
/// parity.
std::optional<OperatorCounts> lambda_inverse(const Characteristic& counts, std::int64_t zips = 0);

}  // namespace clers

#endif
