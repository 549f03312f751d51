// Λ and its inverse (CAGD 2010, §5.1.3), and names.
#include "topology/characteristic.h"

namespace CLERS_VISIBLE clers {

const char* name(HandleCase kind) {
  constexpr const char* names[handle_case_count] = {
      "join_components",          "split_curve",          "join_curves", "close", "zip",
      "join_components_at_loops", "join_curves_at_loops",
  };
  return names[static_cast<unsigned>(kind)];
}

const char* name(StellarCase kind) {
  constexpr const char* names[stellar_case_count] = {"interior_edge", "boundary_edge", "face"};
  return names[static_cast<unsigned>(kind)];
}

Characteristic lambda(const OperatorCounts& c) {
  const std::int64_t in[7] = {c.create, c.join_components, c.split_curve, c.join_curves,
                              c.close,  c.perpendicular,   c.zip};
  std::int64_t out[6] = {};
  for (unsigned row = 0; row < 6; ++row)
    for (unsigned column = 0; column < 7; ++column)
      out[row] += lambda_matrix[row][column] * in[column];
  return {out[0], out[1], out[2], out[3], out[4], out[5]};
}

std::optional<OperatorCounts> lambda_inverse(const Characteristic& counts, std::int64_t zips) {
  const Characteristic rest = counts - zips * effect(HandleCase::zip);
  const std::int64_t in[6] = {rest.v, rest.e, rest.f, rest.b, rest.g, rest.s};
  std::int64_t out[6] = {};
  for (unsigned row = 0; row < 6; ++row) {
    for (unsigned column = 0; column < 6; ++column)
      out[row] += lambda_inverse_matrix_12[row][column] * in[column];
    if (out[row] % 12 != 0) return std::nullopt;
    out[row] /= 12;
  }
  return OperatorCounts{out[0], out[1], out[2], out[3], out[4], out[5], zips};
}

}  // namespace clers
