// Values as colours, and what keeps a mesh from being compared.
#include "codec/comparison/compared_mesh.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>
#include <tuple>
#include <utility>

#include "codec/base/by_element.h"
#include "codec/base/check.h"

namespace clers::internal {
namespace {

auto key(const Attribute& a) {
  return std::tie(a.domain, a.name, a.scalar, a.components);
}

std::string title(const Attribute& a) {
  return std::string(name(a.domain)) + " attribute '" + a.name + "' (" +
         std::to_string(a.components) + " " + name(a.scalar) + ")";
}

/// The colours of the elements that have a value of the attribute.
std::vector<Colour>& colours_of(ComparedMesh& mesh, const Attribute& a) {
  std::vector<Colour>& colours = a.domain == Domain::vertex   ? mesh.colour
                                 : a.domain == Domain::corner ? mesh.corner_values
                                                              : mesh.face_values;
  colours.resize(a.indices.empty() ? a.value_count() : a.indices.size());
  return colours;
}

/// How many elements have each value.
std::vector<std::uint32_t> uses(const Attribute& a) {
  std::vector<std::uint32_t> count(a.value_count());
  for (const std::uint32_t i : a.indices)
    if (i != no_value) ++count[i];
  return count;
}

/// Combines the colour of each element with the bits of its value of attribute k, and where it is
/// `shared` with how many elements have it.
void add_bits(const Attribute& a, std::size_t k, bool shared, std::vector<Colour>& colours) {
  const std::size_t stride = a.stride();
  const std::vector<std::uint32_t> count = shared ? uses(a) : std::vector<std::uint32_t>();
  for (std::size_t i = 0; i < colours.size(); ++i) {
    Colour h = combine(colours[i], k);
    const std::size_t v = a.indices.empty() ? i : a.indices[i];
    if (v == no_value) {
      colours[i] = mix(h);
      continue;
    }
    for (std::size_t at = 0; at < stride; at += sizeof(Colour)) {
      Colour word = 0;
      std::memcpy(&word, a.data.data() + v * stride + at, std::min(sizeof word, stride - at));
      h = combine(h, word);
    }
    colours[i] = shared ? combine(h, count[v]) : h;
  }
}

/// Values scaled to length 1, as doubles; what has no direction becomes NaN.
Attribute unit_vectors(const Attribute& a) {
  Attribute unit = {a.name, a.domain, Scalar::float64, 3, {}, {}};
  const std::size_t count = a.data.size() / a.stride();
  unit.data.resize(count * unit.stride());
  for (std::size_t i = 0; i < count; ++i) {
    Vector3 v = vector_at(a.scalar, a.data.data() + i * a.stride());
    if (to_unit_range(v)) {
      const double length = std::sqrt(dot(v, v));
      for (double& x : v) x /= length;
    } else {
      v.fill(std::numeric_limits<double>::quiet_NaN());
    }
    put_vector(Scalar::float64, v, unit.data.data() + i * unit.stride());
  }
  return unit;
}

void add_near(const Attribute& x, const Attribute& y, double tolerance, ErrorMeasure measure,
              Nearness nearness, std::vector<Colour>& colours_x, std::vector<Colour>& colours_y) {
  if (measure == ErrorMeasure::angle) {
    // Components of unit vectors are no further apart than the vectors, and these no further than
    // the arc; what rounding adds is less than a thousandth of a millionth.
    return add_near(unit_vectors(x), unit_vectors(y), tolerance * 0.01746 + 1e-9,
                    ErrorMeasure::difference, nearness, colours_x, colours_y);
  }
  for (std::size_t c = 0; c < x.components; ++c)
    add_near_values(x, y, c, tolerance, nearness, colours_x, colours_y);
}

/// Tells elements that have no value from those that have.
void add_missing(const Attribute& a, std::vector<Colour>& colours) {
  for (std::size_t i = 0; i < a.indices.size(); ++i)
    if (a.indices[i] == no_value) colours[i] = mix(colours[i]);
}

void colour_domain(ComparedMesh& a, ComparedMesh& b, Domain domain, Nearness nearness) {
  const auto [begin, end] = a.of_domain[static_cast<std::size_t>(domain)];
  for (std::size_t k = begin; k < end; ++k) {
    const Attribute &x = *a.attributes[k], &y = *b.attributes[k];
    if (!a.tolerance[k]) {
      add_bits(x, k, a.shared[k], colours_of(a, x));
      add_bits(y, k, b.shared[k], colours_of(b, y));
      continue;
    }
    std::vector<Colour>&of_a = colours_of(a, x), &of_b = colours_of(b, y);
    if (x.indices.empty() && y.indices.empty()) {
      add_near(x, y, *a.tolerance[k], a.measure[k], nearness, of_a, of_b);
      continue;
    }
    add_near(x.indices.empty() ? x : by_element(x), y.indices.empty() ? y : by_element(y),
             *a.tolerance[k], a.measure[k], nearness, of_a, of_b);
    add_missing(x, of_a);
    add_missing(y, of_b);
  }
}

/// The values that no element has, in their order.
std::vector<const std::byte*> unused(const Attribute& a) {
  std::vector<const std::byte*> result;
  const std::vector<std::uint32_t> count = uses(a);
  for (std::size_t i = 0; i < count.size(); ++i)
    if (count[i] == 0) result.push_back(a.data.data() + i * a.stride());
  return result;
}

}  // namespace

ComparedMesh::ComparedMesh(const Mesh& mesh, std::span<const Tolerance> tolerances)
    : faces(mesh.corners, mesh.face_sizes), colour(mesh.vertex_count) {
  for (const Attribute& a : mesh.attributes) attributes.push_back(&a);
  std::stable_sort(attributes.begin(), attributes.end(),
                   [](const Attribute* a, const Attribute* b) { return key(*a) < key(*b); });
  for (std::size_t k = 0; k < attributes.size(); ++k) {
    const Attribute& a = *attributes[k];
    auto& [begin, end] = of_domain[static_cast<std::size_t>(a.domain)];
    if (begin == end) begin = k;
    end = k + 1;
    const auto given = std::find_if(tolerances.begin(), tolerances.end(), [&](const auto& t) {
      return t.name == a.name && (!t.domain || t.domain == a.domain);
    });
    tolerance.push_back(given != tolerances.end() ? std::optional(given->error) : std::nullopt);
    const bool by_angle = given != tolerances.end() && a.components == 3;
    measure.push_back(by_angle ? given->measure : ErrorMeasure::difference);
    shared.push_back(false);
  }
}

std::optional<Error> why_not_comparable(const Mesh& mesh) {
  const auto wrong = [](std::string what) {
    return Error{ErrorCode::inconsistent_mesh, Place::nowhere, 0, std::move(what)};
  };
  constexpr std::size_t most = std::numeric_limits<std::uint32_t>::max() - 1;
  if (mesh.corners.size() > most || mesh.face_count() > most)
    return Error{ErrorCode::too_large, Place::nowhere, 0,
                 "has more than " + std::to_string(most) + " corners or faces"};
  if (mesh.triangles_only() ? mesh.corners.size() % 3 != 0
                            : std::accumulate(mesh.face_sizes.begin(), mesh.face_sizes.end(),
                                              std::uint64_t{0}) != mesh.corners.size())
    return wrong("has face sizes that do not add up to its corners");
  for (const std::uint32_t v : mesh.corners)
    if (v >= mesh.vertex_count)
      return wrong("uses vertex " + std::to_string(v) + ", expected one below " +
                   std::to_string(mesh.vertex_count));
  for (const Attribute& a : mesh.attributes) {
    if (const std::string defect = kind_defect(a); !defect.empty())
      return wrong("has an attribute '" + a.name + "' of " + defect);
    if (!a.indices.empty()) {
      if (auto ok = check_attribute(a, mesh.value_count(a.domain)); !ok)
        return wrong("is wrong: " + ok.error().what);
      continue;
    }
    if (a.data.size() != mesh.value_count(a.domain) * a.stride())
      return wrong("has " + std::to_string(a.data.size()) + " bytes of values of '" + a.name +
                   "', expected " + std::to_string(mesh.value_count(a.domain)) + " times " +
                   std::to_string(a.stride()));
  }
  return std::nullopt;
}

std::optional<std::string> attributes_differ(const ComparedMesh& a, const ComparedMesh& b) {
  for (std::size_t k = 0; k < std::max(a.attributes.size(), b.attributes.size()); ++k) {
    const Attribute* x = k < a.attributes.size() ? a.attributes[k] : nullptr;
    const Attribute* y = k < b.attributes.size() ? b.attributes[k] : nullptr;
    if (x != nullptr && y != nullptr && key(*x) == key(*y)) continue;
    const bool in_first = y == nullptr || (x != nullptr && key(*x) < key(*y));
    return title(in_first ? *x : *y) + " is only in the " + (in_first ? "first" : "second") +
           " mesh";
  }
  return std::nullopt;
}

std::optional<std::string> compare_sharing(ComparedMesh& a, ComparedMesh& b) {
  for (std::size_t k = 0; k < a.attributes.size(); ++k) {
    const Attribute &x = *a.attributes[k], &y = *b.attributes[k];
    if (x.indices.empty() || y.indices.empty()) continue;
    a.shared[k] = b.shared[k] = true;
    auto first = unused(x), second = unused(y);
    const auto less = [&](const std::byte* p, const std::byte* q) {
      return std::memcmp(p, q, x.stride()) < 0;
    };
    if (!a.tolerance[k]) {
      std::sort(first.begin(), first.end(), less);
      std::sort(second.begin(), second.end(), less);
    }
    const auto agree = [&](const std::byte* p, const std::byte* q) {
      return a.tolerance[k] ? difference(x.scalar, p, q, x.components) <= *a.tolerance[k]
                            : std::memcmp(p, q, x.stride()) == 0;
    };
    if (!std::equal(first.begin(), first.end(), second.begin(), second.end(), agree))
      return title(x) + " has other values that no " + name(x.domain) + " uses";
  }
  return std::nullopt;
}

void colour_values(ComparedMesh& a, ComparedMesh& b) {
  for (const Domain domain : {Domain::vertex, Domain::corner, Domain::face})
    colour_domain(a, b, domain, Nearness::linked);
}

void colour_vertices(ComparedMesh& a, ComparedMesh& b, Nearness nearness) {
  std::fill(a.colour.begin(), a.colour.end(), 0);
  std::fill(b.colour.begin(), b.colour.end(), 0);
  colour_domain(a, b, Domain::vertex, nearness);
}

}  // namespace clers::internal
