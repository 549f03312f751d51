// Chooses a formula by what coding with it would take.
#include "codec/attributes/normal_values_encoder.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <vector>

#include "codec/attributes/normal_values.h"
#include "codec/base/portable.h"
#include "codec/entropy/lanes.h"
#include "codec/entropy/measure.h"
#include "codec/entropy/stream.h"

namespace clers::internal {
namespace {

// Values that formulas are tried on.
constexpr std::size_t sample = 8192;

/// The directions that integers stand for.
template <class Int>
std::vector<Vector3> vectors_of(std::span<const Int> rows, const Numbers& numbers) {
  std::vector<Vector3> all;
  const std::size_t components = numbers.axes.size();
  all.reserve(rows.size() / components);
  const auto at = [&](std::size_t i) { return static_cast<std::int64_t>(rows[i]); };
  if (const unsigned bits = numbers.octahedral_bits()) {
    const OctahedralGrid grid(bits);
    for (std::size_t i = 0; i < rows.size(); i += 2)
      all.push_back(OctahedralGrid::direction(grid.point(at(i), at(i + 1))));
    return all;
  }
  const NumberLines lines = number_lines(numbers);
  for (std::size_t i = 0; i < rows.size(); i += 3) {
    Vector3 v;
    for (std::size_t c = 0; c < 3; ++c)
      v[c] = lines[c]->value(static_cast<std::uint64_t>(at(i + c)));
    all.push_back(v);
  }
  return all;
}

/// Whether most vectors are so near to unit length that rounding explains the rest.
bool are_unit_vectors(const std::vector<Vector3>& vectors) {
  std::size_t near = 0;
  for (const Vector3& v : vectors) near += std::fabs(dot(v, v) - 1) < 2e-3;
  return 16 * near >= 15 * vectors.size();
}

/// How many vectors are beside what a formula gives, by less than 25 degrees, on the same side and
/// on the other.
struct Sides {
  std::size_t outward = 0, inward = 0;
};
Sides sides_of(const std::vector<Vector3>& vectors, const FormulaNormals& formula) {
  Sides sides;
  for (std::uint32_t v = 0; v < vectors.size(); ++v) {
    Vector3 normal;
    if (!formula.at(v, normal)) continue;
    const double along = dot(normal, vectors[v]);
    if (along * along < dot(vectors[v], vectors[v]) * .82) continue;
    if (along != 0) ++(along < 0 ? sides.inward : sides.outward);
  }
  return sides;
}

template <class Int>
class ModelChoice {
 public:
  ModelChoice(std::span<const Int> rows, const Numbers& numbers, const ValueSurface& along,
              int level)
      : rows_(rows.begin(), rows.end()),
        numbers_(numbers),
        along_(along),
        vectors_(vectors_of(rows, numbers)) {
    model_.quick = level < 7 && numbers.octahedral_bits() > 0;
    model_.unit_vectors = numbers.octahedral_bits() == 0 && are_unit_vectors(vectors_);
    const Sides sides = sides_of(vectors_, FormulaNormals(along, vectors_.size(), {}));
    model_.formula.inward = sides.inward > sides.outward;
  }

  /// What takes least.
  NormalModel run() {
    for (const NormalSum around : {NormalSum::value, NormalSum::vertex, NormalSum::place}) {
      if (around == NormalSum::vertex && along_.vertex_of.empty()) continue;
      if (around == NormalSum::place && !FormulaNormals::has_places(*along_.position)) continue;
      for (const NormalWeight weight :
           {NormalWeight::uniform, NormalWeight::angle, NormalWeight::area})
        try_one(weight, around, true);
    }
    if (numbers_.octahedral_bits() == 0 && !model_.unit_vectors) {
      const NormalFormula best = best_.formula;
      for (const NormalWeight weight : {NormalWeight::uniform, NormalWeight::angle})
        try_one(weight, best.around, false);
    }
    return best_;
  }

 private:
  void try_one(NormalWeight weight, NormalSum around, bool unit) {
    NormalModel model = model_;
    model.formula.weight = weight;
    model.formula.around = around;
    model.formula.unit = unit;
    const FormulaNormals formula(along_, vectors_.size(), model.formula);
    const std::uint64_t cost = model.quick ? distance(formula) : this->cost(model, formula);
    if (cost >= least_) return;
    least_ = cost;
    best_ = model;
  }

  std::uint64_t cost(const NormalModel& model, const FormulaNormals& formula) {
    Measure coder;
    code_normals(coder, model, numbers_, formula, along_, std::span<Int>(rows_), sample);
    return coder.cost();
  }
  /// About the bits of what a formula is off, on whichever side.
  std::uint64_t distance(const FormulaNormals& formula) const {
    const OctahedralGrid grid(numbers_.octahedral_bits());
    std::uint64_t bits = 0;
    const std::size_t step = vectors_.size() / sample + 1;
    for (std::size_t v = 0; v < vectors_.size(); v += step) {
      Vector3 normal;
      if (!formula.at(static_cast<std::uint32_t>(v), normal)) {
        bits += 32;
        continue;
      }
      if (dot(normal, vectors_[v]) < 0)
        for (double& x : normal) x = -x;
      const OctahedralPoint p = grid.nearest(grid.project(normal)),
                            q = grid.point(static_cast<std::int64_t>(rows_[2 * v]),
                                           static_cast<std::int64_t>(rows_[2 * v + 1]));
      for (std::size_t c = 0; c < 3; ++c)
        bits += static_cast<unsigned>(std::bit_width(static_cast<unsigned>(std::abs(p[c] - q[c]))));
    }
    return bits;
  }

  std::vector<Int> rows_;
  const Numbers& numbers_;
  const ValueSurface& along_;
  const std::vector<Vector3> vectors_;
  NormalModel model_, best_;
  std::uint64_t least_ = ~std::uint64_t(0);
};

}  // namespace

template <class Int>
Bytes encode_normals(std::span<const Int> rows, const Numbers& numbers, const ValueSurface& along,
                     int level) {
  const DoublePrecision doubles;
  Bytes bytes;
  if (rows.empty()) return bytes;
  const NormalModel model = ModelChoice<Int>(rows, numbers, along, level).run();
  put_u8(bytes, number_of(model));
  std::vector<Int> coded(rows.begin(), rows.end());
  const std::size_t values = rows.size() / numbers.axes.size();
  const FormulaNormals formula(along, values, model.formula);
  if (model.quick) {
    LaneEncoder coder;
    code_normals_quickly(coder, numbers, formula, along, std::span<Int>(coded));
    coder.finish(bytes);
    return bytes;
  }
  put_bytes(bytes, encode_stream([&](EncodeTo& coder) {
              code_normals(coder, model, numbers, formula, along, std::span<Int>(coded), values);
            }));
  return bytes;
}

template <class Int>
bool look_like_normals(std::span<const Int> rows, const Numbers& numbers,
                       const ValueSurface& along) {
  const DoublePrecision doubles;
  const std::vector<Vector3> vectors = vectors_of(rows, numbers);
  const Sides sides = sides_of(vectors, FormulaNormals(along, vectors.size(), {}));
  return 4 * (sides.inward + sides.outward) >= vectors.size();
}

template bool look_like_normals(std::span<const std::int32_t>, const Numbers&, const ValueSurface&);
template bool look_like_normals(std::span<const std::int64_t>, const Numbers&, const ValueSurface&);
template Bytes encode_normals(std::span<const std::int32_t>, const Numbers&, const ValueSurface&,
                              int);
template Bytes encode_normals(std::span<const std::int64_t>, const Numbers&, const ValueSurface&,
                              int);

}  // namespace clers::internal
