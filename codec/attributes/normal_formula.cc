#include "codec/attributes/normal_formula.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

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

std::uint64_t hash_of(const Vector3& place) {
  std::uint64_t hash = 0;
  for (const double x : place)
    hash = (hash ^ static_cast<std::uint64_t>(static_cast<std::int64_t>(x))) * 0x9e3779b97f4a7c15u;
  return hash ^ hash >> 32;
}

/// Of each vertex, the first one at its place. They are compared in buckets, of which none may be
/// slow, whatever the places are.
std::vector<std::uint32_t> first_at_places(const std::vector<Vector3>& places) {
  const auto count = static_cast<std::uint32_t>(places.size());
  const std::size_t buckets = std::bit_ceil(places.size() + 1);
  std::vector<std::uint32_t> first(count), order(count), end(buckets);
  for (std::uint32_t v = 0; v < count; ++v)
    ++end[first[v] = static_cast<std::uint32_t>(hash_of(places[v]) & (buckets - 1))];
  std::uint32_t sum = 0;
  for (std::uint32_t& e : end) e = std::exchange(sum, sum + e);
  for (std::uint32_t v = 0; v < count; ++v) order[end[first[v]]++] = v;
  constexpr std::uint32_t few = 16;
  for (std::uint32_t b = 0, begin = 0; b < buckets; begin = end[b++]) {
    const bool many = end[b] - begin > few;
    if (many)
      std::sort(order.begin() + begin, order.begin() + end[b],
                [&](std::uint32_t u, std::uint32_t v) {
                  return places[u] != places[v] ? places[u] < places[v] : u < v;
                });
    for (std::uint32_t i = begin; i < end[b]; ++i) {
      const std::uint32_t v = order[i];
      std::uint32_t j = many && i > begin ? i - 1 : begin;
      while (j < i && places[order[j]] != places[v]) ++j;
      first[v] = j < i ? first[order[j]] : v;
    }
  }
  return first;
}

}  // namespace

FormulaNormals::FormulaNormals(const ValueSurface& along, std::size_t values,
                               const NormalFormula& formula)
    : along_(along), formula_(formula), places_(whole_places(*along.position)) {
  if (formula.around == NormalSum::place) first_at_ = first_at_places(places_);
  std::vector<Sum> sums(formula.around == NormalSum::value ? values : places_.size());
  add_triangles(sums);
  results_.reserve(sums.size());
  for (const Sum& sum : sums) results_.push_back(result_of(sum));
}

void FormulaNormals::add_triangles(std::vector<Sum>& sums) const {
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
      Sum& sum = sums[group(corners[h + i])];
      double weight = 1;
      if (formula_.weight == NormalWeight::angle)
        weight = angle_of(-dot(sides[i], sides[(i + 2) % 3]), area);
      for (std::size_t c = 0; c < 3; ++c) sum.normal[c] += weight * normal[c];
      sum.weight += formula_.weight == NormalWeight::area ? area : weight;
      sum.area += area;
    }
  }
}

FormulaNormals::Result FormulaNormals::result_of(const Sum& sum) const {
  const double length = std::sqrt(dot(sum.normal, sum.normal));
  // What is left of normals that cancel is rounding.
  if (!(length > sum.weight * 0x1p-40)) return {{}, {0, no_normal}};
  double scale = 1;
  if (formula_.unit) scale = length;
  if (formula_.inward) scale = -scale;
  const double left = 1 - length / sum.weight;
  return {{sum.normal[0] / scale, sum.normal[1] / scale, sum.normal[2] / scale},
          {left > 0 ? static_cast<unsigned>(left * 256) : 0,
           static_cast<int>(std::bit_cast<std::uint64_t>(sum.area) >> 52 & 2047) - 1023}};
}

bool FormulaNormals::has_places(const Attribute& position) {
  const std::vector<std::uint32_t> first = first_at_places(whole_places(position));
  for (std::size_t v = 0; v < first.size(); ++v)
    if (first[v] != v) return true;
  return false;
}

std::uint64_t FormulaNormals::memory(std::uint64_t values, std::uint64_t vertices) {
  return (sizeof(Vector3) + 4 * sizeof(std::uint32_t)) * vertices +
         (sizeof(Sum) + sizeof(Result)) * std::max(values, vertices);
}

}  // namespace clers::internal
