#include "codec/file/recomputed_normals.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <numeric>
#include <string>
#include <vector>

#include "codec/attributes/normal_formula.h"
#include "codec/base/direction.h"
#include "codec/base/faces.h"
#include "codec/base/portable.h"
#include "codec/numbers/directions.h"
#include "codec/numbers/number_format.h"
#include "codec/numbers/octahedral.h"

namespace clers::internal {
namespace {

/// What the values of an attribute lie on: triangles whose corners have values.
struct Ground {
  std::vector<std::uint32_t> value_of;   ///< of each element: its value, or no_value
  std::vector<std::size_t> element_of;   ///< of each value, its first element or data
  std::vector<std::uint32_t> corners;    ///< values, 3 a triangle
  std::vector<std::uint32_t> vertex_at;  ///< of each corner
  std::vector<std::uint32_t> vertex_of;  ///< of each value
};

/// Which value each element has. Values by index are those of the attribute; corners without
/// indices share a value where they share vertex and bits.
void find_values(const MeshView& mesh, const AttributeView& a, Ground& ground) {
  const std::size_t count = value_count(a);
  if (!a.indices.empty() || a.domain != Domain::corner) {
    ground.value_of.resize(a.indices.empty() ? count : a.indices.size());
    if (a.indices.empty())
      std::iota(ground.value_of.begin(), ground.value_of.end(), 0u);
    else
      std::copy(a.indices.begin(), a.indices.end(), ground.value_of.begin());
    ground.element_of.resize(count);
    std::iota(ground.element_of.begin(), ground.element_of.end(), std::size_t(0));
    return;
  }
  std::vector<std::uint32_t> order(count);
  std::iota(order.begin(), order.end(), 0u);
  const auto compare = [&](std::uint32_t c, std::uint32_t d) {
    if (mesh.corners[c] != mesh.corners[d]) return mesh.corners[c] < mesh.corners[d] ? -1 : 1;
    return std::memcmp(a.value(c), a.value(d), a.value_size());
  };
  std::sort(order.begin(), order.end(), [&](std::uint32_t c, std::uint32_t d) {
    const int less = compare(c, d);
    return less != 0 ? less < 0 : c < d;
  });
  ground.value_of.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    if (i == 0 || compare(order[i - 1], order[i]) != 0) ground.element_of.push_back(order[i]);
    ground.value_of[order[i]] = static_cast<std::uint32_t>(ground.element_of.size() - 1);
  }
}

Ground ground_of(const MeshView& mesh, const AttributeView& a) {
  Ground ground;
  find_values(mesh, a, ground);
  ground.vertex_of.resize(ground.element_of.size(), 0);
  const Faces faces(mesh.corners, mesh.face_sizes);
  for (std::uint32_t f = 0; f < faces.count(); ++f) {
    const std::uint32_t begin = faces.begin(f), size = faces.size(f);
    const auto value = [&](std::uint32_t corner) {
      return ground.value_of[a.domain == Domain::vertex   ? mesh.corners[corner]
                             : a.domain == Domain::corner ? corner
                                                          : f];
    };
    for (std::uint32_t i = 2; i < size; ++i) {
      const std::array<std::uint32_t, 3> triangle = {begin, begin + i - 1, begin + i};
      if (std::any_of(triangle.begin(), triangle.end(),
                      [&](std::uint32_t c) { return value(c) == no_value; }))
        continue;
      for (const std::uint32_t corner : triangle) {
        ground.corners.push_back(value(corner));
        ground.vertex_at.push_back(mesh.corners[corner]);
        ground.vertex_of[value(corner)] = mesh.corners[corner];
      }
    }
  }
  return ground;
}

/// The fewest bits whose grid is so fine that nothing is further from a point than a quarter of so
/// many degrees: points are at most 100 / S degrees away.
unsigned bits_within(double degrees) {
  unsigned bits = min_direction_bits;
  while (bits < max_direction_bits && 400. / OctahedralGrid(bits).size() > degrees) ++bits;
  return bits;
}

class Recomputing {
 public:
  Recomputing(const MeshView& mesh, const AttributeView& a, const Attribute& position,
              double degrees)
      : a_(a), degrees_(degrees), grid_(bits_within(degrees)), ground_(ground_of(mesh, a)) {
    along_.surface.corners = ground_.corners;
    along_.vertex_of = ground_.vertex_of;
    along_.vertex_at = ground_.vertex_at;
    along_.position = &position;
  }

  Expected<QuantisedValues> run() {
    for (const std::size_t element : ground_.element_of) {
      Vector3 v = vector_at(a_.scalar, a_.value(element));
      if (!to_unit_range(v)) return no_direction(a_, element);
      vectors_.push_back(v);
    }
    find_formula();
    QuantisedValues all;
    const std::size_t count = value_count(a_);
    all.values.resize(count * a_.value_size());
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t value = a_.indices.empty() ? ground_.value_of[i] : i;
      std::byte* const to = all.values.data() + i * a_.value_size();
      std::memcpy(to, best_.data() + value * a_.value_size(), a_.value_size());
      all.plan.error = std::max(all.plan.error, angle_between(a_.scalar, a_.value(i), to));
    }
    if (all.plan.error > degrees_) return QuantisedValues{};
    if (all.plan.error == 0) all.values.clear();
    all.plan.systems = octahedral_systems(bits_within(degrees_));
    all.plan.measure = ErrorMeasure::angle;
    return all;
  }

 private:
  void find_formula() {
    std::size_t most = 0;
    for (std::uint32_t number = 0; number < normal_sums * normal_weights; ++number) {
      const NormalFormula formula = normal_formula(number);
      const FormulaNormals normals(along_, vectors_.size(), formula);
      std::vector<std::byte> values(vectors_.size() * a_.value_size());
      std::size_t near = 0;
      for (std::uint32_t v = 0; v < vectors_.size(); ++v) {
        std::byte* const to = values.data() + v * a_.value_size();
        near += recomputed(normals, v, to);
      }
      if (number > 0 && near <= most) continue;
      most = near;
      best_ = std::move(values);
    }
  }

  /// Stores what value v becomes: that of the formula, on its side, or the nearest.
  bool recomputed(const FormulaNormals& normals, std::uint32_t v, std::byte* to) const {
    Vector3 normal;
    if (normals.at(v, normal)) {
      if (dot(normal, vectors_[v]) < 0)
        for (double& x : normal) x = -x;
      store(normal, to);
      if (angle_between(a_.scalar, a_.value(ground_.element_of[v]), to) <= degrees_) return true;
    }
    store(vectors_[v], to);
    return false;
  }
  void store(const Vector3& v, std::byte* to) const {
    put_vector(a_.scalar, OctahedralGrid::direction(grid_.nearest(grid_.project(v))), to);
  }

  const AttributeView& a_;
  const double degrees_;
  const OctahedralGrid grid_;
  const Ground ground_;
  ValueSurface along_;
  std::vector<Vector3> vectors_;
  std::vector<std::byte> best_;
};

}  // namespace

Expected<QuantisedValues> recompute_normals(const MeshView& mesh, const AttributeView& a,
                                            double degrees) {
  const DoublePrecision doubles;
  const auto refused = [&](const std::string& what) {
    return fail(ErrorCode::bad_option, "'" + std::string(a.name) + "' " + what);
  };
  if (a.components != 3 || !is_float(a.scalar))
    return refused("has " + std::to_string(a.components) + " " + name(a.scalar) +
                   " a value, and directions have 3 floats");
  if (a.domain == Domain::vertex && a.name == position_name)
    return refused("is what normals are computed from");
  for (const AttributeView other : mesh.attributes) {
    if (other.domain != Domain::vertex || other.name != position_name || other.components != 3)
      continue;
    Attribute position = {position_name, Domain::vertex, other.scalar, 3, {}, {}};
    position.data.resize(mesh.vertex_count * position.stride());
    for (std::uint32_t v = 0; v < mesh.vertex_count; ++v)
      std::memcpy(position.data.data() + v * position.stride(), other.value(v), position.stride());
    return Recomputing(mesh, a, position, degrees).run();
  }
  return refused("cannot be recomputed without positions of three components");
}

}  // namespace clers::internal
