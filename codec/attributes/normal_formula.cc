#include "codec/attributes/normal_formula.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>

#include "codec/scalar.h"

namespace clers::internal {
namespace {

/// Places as whole numbers of a unit that is 2^-50 of a power of two above all coordinates: so
/// differences are exact, and no product is too small or too large to be rounded like the others.
/// What is not finite is at 0.
std::vector<Vector3> whole_places(const Attribute& position) {
  std::vector<Vector3> places(position.value_count());
  double most = 0;
  for (std::size_t v = 0; v < places.size(); ++v) {
    places[v] = vector_at(position.scalar, position.data.data() + v * position.stride());
    for (double& x : places[v]) {
      if (!(std::fabs(x) <= std::numeric_limits<double>::max())) x = 0;
      most = std::max(most, std::fabs(x));
    }
  }
  if (most == 0) return places;
  const int e = 49 - std::ilogb(most);
  // Where the power is a number, a product is as good.
  const double power = e <= 1000 ? std::scalbn(1., e) : 0;
  for (Vector3& place : places)
    for (double& x : place) x = std::trunc(power > 0 ? x * power : std::scalbn(x, e));
  return places;
}

/// Of each vertex, the first one at its place.
std::vector<std::uint32_t> first_at_places(const std::vector<Vector3>& places) {
  std::vector<std::uint32_t> order(places.size()), first(places.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return places[a] != places[b] ? places[a] < places[b] : a < b;
  });
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool again = i > 0 && places[order[i]] == places[order[i - 1]];
    first[order[i]] = again ? first[order[i - 1]] : order[i];
  }
  return first;
}

}  // namespace

FormulaNormals::FormulaNormals(const ValueSurface& along, std::size_t values,
                               const NormalFormula& formula)
    : along_(along), formula_(formula), places_(whole_places(*along.position)) {
  if (formula.around == NormalSum::place) first_at_ = first_at_places(places_);
  sums_.resize(formula.around == NormalSum::value ? values : places_.size());
  add_triangles();
}

void FormulaNormals::add_triangles() {
  const auto& corners = along_.surface.corners;
  for (std::size_t h = 0; h < corners.size(); h += 3) {
    std::array<Vector3, 3> sides;  // from each corner to the next
    for (std::size_t i = 0; i < 3; ++i) {
      const Vector3 &from = places_[along_.vertex_of_corner(h + i)],
                    &to = places_[along_.vertex_of_corner(h + (i + 1) % 3)];
      for (std::size_t c = 0; c < 3; ++c) sides[i][c] = to[c] - from[c];
    }
    Vector3 normal = cross(sides[0], sides[1]);
    const double area = std::sqrt(dot(normal, normal));  // twice
    if (area == 0) continue;
    if (formula_.weight != NormalWeight::area)
      for (double& x : normal) x /= area;
    for (std::size_t i = 0; i < 3; ++i) {
      Sum& sum = sums_[group(corners[h + i])];
      double weight = 1;
      if (formula_.weight == NormalWeight::angle)
        weight = angle_of(-dot(sides[i], sides[(i + 2) % 3]), area);
      for (std::size_t c = 0; c < 3; ++c) sum.normal[c] += weight * normal[c];
      sum.weight += formula_.weight == NormalWeight::area ? area : weight;
      sum.area += area;
    }
  }
}

bool FormulaNormals::at(std::uint32_t value, Vector3& normal, Shape& shape) const {
  const std::uint32_t g = group(value);
  if (g >= sums_.size()) return false;
  const Sum& sum = sums_[g];
  const double length = std::sqrt(dot(sum.normal, sum.normal));
  // What is left of normals that cancel is rounding.
  if (!(length > sum.weight * 0x1p-40)) return false;
  double scale = 1;
  if (formula_.unit) scale = length;
  if (formula_.inward) scale = -scale;
  for (std::size_t c = 0; c < 3; ++c) normal[c] = sum.normal[c] / scale;
  shape.bent = static_cast<unsigned>(std::max(0., (1 - length / sum.weight) * 256));
  shape.size = static_cast<int>(std::bit_cast<std::uint64_t>(sum.area) >> 52 & 2047) - 1023;
  return true;
}

bool FormulaNormals::has_places(const Attribute& position) {
  const std::vector<std::uint32_t> first = first_at_places(whole_places(position));
  for (std::size_t v = 0; v < first.size(); ++v)
    if (first[v] != v) return true;
  return false;
}

std::uint64_t FormulaNormals::memory(std::uint64_t values, std::uint64_t vertices) {
  return (sizeof(Vector3) + 2 * sizeof(std::uint32_t)) * vertices +
         sizeof(Sum) * std::max(values, vertices);
}

}  // namespace clers::internal
