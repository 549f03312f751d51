#include "codec/numbers/directions.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "codec/base/direction.h"
#include "codec/base/portable.h"
#include "codec/numbers/number_format.h"
#include "codec/numbers/octahedral.h"

namespace clers::internal {

bool are_unit_vectors(const AttributeView& a) {
  const DoublePrecision doubles;
  const std::size_t count = value_count(a);
  if (a.components != 3 || !is_float(a.scalar) || count == 0) return false;
  for (std::size_t i = 0; i < count; ++i) {
    const Vector3 v = vector_at(a.scalar, a.value(i));
    // One component shows that a vector is too long, so that no square overflows.
    if (!(std::max({std::fabs(v[0]), std::fabs(v[1]), std::fabs(v[2])}) < 2)) return false;
    if (!(std::fabs(std::sqrt(dot(v, v)) - 1) <= 1e-3)) return false;
  }
  return true;
}

Failure<Error> no_direction(const AttributeView& a, std::size_t value) {
  const Place place = a.domain == Domain::vertex   ? Place::vertex
                      : a.domain == Domain::corner ? Place::corner
                                                   : Place::face;
  return fail(ErrorCode::not_on_grid, place, value,
              "'" + std::string(a.name) + "' is zero or not finite, which is no direction");
}

Expected<QuantisedValues> quantise_directions(const AttributeView& a, unsigned bits) {
  const DoublePrecision doubles;
  const OctahedralGrid grid(bits);
  const std::size_t count = value_count(a);
  QuantisedValues all;
  all.values.resize(count * a.value_size());
  for (std::size_t i = 0; i < count; ++i) {
    Vector3 v = vector_at(a.scalar, a.value(i));
    if (!to_unit_range(v)) return no_direction(a, i);
    std::byte* const to = all.values.data() + i * a.value_size();
    put_vector(a.scalar, OctahedralGrid::direction(grid.nearest(grid.project(v))), to);
    all.plan.error = std::max(all.plan.error, angle_between(a.scalar, a.value(i), to));
  }
  if (count == 0 || all.plan.error == 0) all.values.clear();
  all.plan.systems = octahedral_systems(bits);
  all.plan.measure = ErrorMeasure::angle;
  return all;
}

}  // namespace clers::internal
