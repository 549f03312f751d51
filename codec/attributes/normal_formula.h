// The normals of a surface's geometry: what whoever stored normals mostly computed them by.
//
// A normal is the sum of those of the triangles around, in a way that a byte says. Doubles, each
// operation rounded correctly (DoublePrecision, portable.h), so that all machines have the same.
#ifndef CLERS_CODEC_ATTRIBUTES_NORMAL_FORMULA_H
#define CLERS_CODEC_ATTRIBUTES_NORMAL_FORMULA_H

#include <cstddef>
#include <cstdint>
#include <vector>

#include "codec/attributes/value_surface.h"
#include "codec/base/direction.h"

namespace clers::internal {

/// How much a triangle counts at a corner; the numbers are the format's.
enum class NormalWeight : std::uint8_t {
  uniform,  ///< the same
  angle,    ///< its angle there (Thuermer and Wuethrich 1998)
  area,     ///< its area
};
inline constexpr std::uint32_t normal_weights = 3;

/// Around what triangles are; the numbers are the format's.
enum class NormalSum : std::uint8_t {
  value,   ///< that have the value: on one side of seams
  vertex,  ///< that have its vertex
  place,   ///< that have a vertex where that one is
};
inline constexpr std::uint32_t normal_sums = 3;

struct NormalFormula {
  NormalWeight weight = NormalWeight::uniform;
  NormalSum around = NormalSum::value;
  bool inward = false;  ///< the opposite
  bool unit = true;     ///< scaled to length 1, and not the sum itself

  /// Areas depend on the size of all: their sum is not used as it is.
  bool is_one() const { return unit || weight != NormalWeight::area; }
  friend bool operator==(const NormalFormula&, const NormalFormula&) = default;
};
inline constexpr std::uint32_t normal_formulas = 4 * normal_sums * normal_weights;

/// As the byte that the format has for it, below normal_formulas; and back.
inline std::uint32_t number_of(const NormalFormula& f) {
  return ((f.unit ? 0u : 2u) + (f.inward ? 1u : 0u)) * normal_sums * normal_weights +
         static_cast<std::uint32_t>(f.around) * normal_weights +
         static_cast<std::uint32_t>(f.weight);
}
inline NormalFormula normal_formula(std::uint32_t number) {
  const std::uint32_t signs = number / (normal_sums * normal_weights);
  return {static_cast<NormalWeight>(number % normal_weights),
          static_cast<NormalSum>(number / normal_weights % normal_sums), (signs & 1) != 0,
          (signs & 2) == 0};
}

/// The normal of each value by a formula.
class FormulaNormals {
 public:
  /// Precondition: along.position has three components, and values of all vertices. Cost: linear;
  /// around places a sort.
  FormulaNormals(const ValueSurface& along, std::size_t values, const NormalFormula& formula);

  /// How much the sum of the triangles around a value is shorter than the sum of their lengths:
  /// 0 where they lie in a plane, in 1 / 256, and how large they are: the exponent of their area.
  struct Shape {
    unsigned bent = 0;
    int size = 0;
  };

  /// False if the value has none: it is in no triangle, those around it have no area, or cancel.
  bool at(std::uint32_t value, Vector3& normal) const {
    const Result* result = at(value);
    if (result != nullptr) normal = result->normal;
    return result != nullptr;
  }
  /// A normal, and the shape around it.
  struct Result {
    Vector3 normal;
    Shape shape;
  };
  /// The same; nullptr if the value has none.
  const Result* at(std::uint32_t value) const {
    const std::uint32_t g = group(value);
    return g < results_.size() && results_[g].shape.size != no_normal ? &results_[g] : nullptr;
  }

  /// Whether several vertices are at one place. Cost: a sort.
  static bool has_places(const Attribute& position);

  /// The bytes that one takes, at most.
  static std::uint64_t memory(std::uint64_t values, std::uint64_t vertices);

 private:
  /// The size of what has no normal; no exponent is as great.
  static constexpr int no_normal = 2048;

  /// Of the triangles around something.
  struct Sum {
    Vector3 normal = {};
    double weight = 0, area = 0;
  };
  std::uint32_t group(std::uint32_t value) const {
    if (formula_.around == NormalSum::value) return value;
    const std::uint32_t vertex = along_.vertex(value);
    return formula_.around == NormalSum::vertex ? vertex : first_at_[vertex];
  }
  void add_triangles(std::vector<Sum>& sums) const;
  Result result_of(const Sum& sum) const;

  const ValueSurface& along_;
  const NormalFormula formula_;
  std::vector<Vector3> places_;          // of vertices, whole numbers below 2^50
  std::vector<std::uint32_t> first_at_;  // of each vertex, the first one at its place
  std::vector<Result> results_;
};

}  // namespace clers::internal

#endif
