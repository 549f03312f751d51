// Normals, or other directions, along a surface: each is predicted by a formula of the positions
// around it, and what it is off is coded, the same by who encodes and who decodes.
#ifndef CLERS_CODEC_ATTRIBUTES_NORMAL_VALUES_H
#define CLERS_CODEC_ATTRIBUTES_NORMAL_VALUES_H

#include <cstddef>
#include <cstdint>
#include <span>

#include "codec/attributes/known_values.h"
#include "codec/attributes/normal_formula.h"
#include "codec/attributes/normal_residuals.h"
#include "codec/attributes/numbered_normals.h"
#include "codec/attributes/octahedral_normals.h"
#include "codec/numbers/octahedral.h"

namespace clers::internal {

/// What a stream of normals says first.
struct NormalModel {
  NormalFormula formula;
  bool unit_vectors = false;  ///< the last of three numbers follows from the others
  bool quick = false;         ///< points of a grid are coded in two contexts

  /// Whether it is one for values with these numbers: points of a grid are directions alone.
  bool fits(const Numbers& numbers) const {
    const bool points = numbers.octahedral_bits() > 0;
    return formula.is_one() && (points ? formula.unit && !unit_vectors : !quick);
  }
};
inline constexpr std::uint32_t normal_models = 3 * normal_formulas;
inline std::uint32_t number_of(const NormalModel& m) {
  return number_of(m.formula) + (m.quick          ? 2 * normal_formulas
                                 : m.unit_vectors ? normal_formulas
                                                  : 0);
}
inline NormalModel normal_model(std::uint32_t number) {
  return {normal_formula(number % normal_formulas), number / normal_formulas == 1,
          number / normal_formulas == 2};
}

/// Codes the first `most` normals that for_each_with_nearby visits, with Coder, one that encodes
/// what is in the rows or one that fills them: one of decisions, or of symbols if the model is a
/// quick one. False if what is decoded is none.
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
    return code_all(
        OctahedralNormals<Int, Coder, MixedNormalResiduals>(coder, bits, formula, rows));
  return code_all(NumberedNormals<Int, Coder>(coder, numbers, model.unit_vectors, formula, rows));
}
template <class Int, class Coder>
bool code_normals_quickly(Coder& coder, const Numbers& numbers, const FormulaNormals& formula,
                          const ValueSurface& along, std::span<Int> rows) {
  OctahedralNormals<Int, Coder, QuickNormalResiduals> normals(coder, numbers.octahedral_bits(),
                                                              formula, rows);
  return for_each_with_gate(along, rows.size() / 2, [&](std::uint32_t v, const Nearby& nearby) {
    return normals.code(v, nearby);
  });
}

}  // namespace clers::internal

#endif
