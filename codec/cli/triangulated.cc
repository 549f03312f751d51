#include "codec/cli/triangulated.h"

#include <cstddef>
#include <cstdint>

namespace clers::cli {
namespace {

/// An attribute that has for element i what `a` has for element from[i].
Attribute gathered(const Attribute& a, const std::vector<std::uint32_t>& from) {
  Attribute out{a.name, a.domain, a.scalar, a.components, {}};
  if (!a.indices.empty()) {
    out.data = a.data;
    out.indices.reserve(from.size());
    for (const std::uint32_t i : from) out.indices.push_back(a.indices[i]);
    return out;
  }
  const auto stride = static_cast<std::ptrdiff_t>(a.stride());
  out.data.reserve(from.size() * a.stride());
  for (const std::uint32_t i : from) {
    const auto value = a.data.begin() + static_cast<std::ptrdiff_t>(i) * stride;
    out.data.insert(out.data.end(), value, value + stride);
  }
  return out;
}

}  // namespace

Mesh triangulated(const Mesh& mesh, const std::vector<Vec3>& at) {
  std::vector<std::uint32_t> corners, faces;  // of the mesh
  std::uint32_t first = 0;
  for (std::uint32_t f = 0; f < mesh.face_sizes.size(); ++f) {
    const std::uint32_t size = mesh.face_sizes[f];
    const auto place = [&](std::uint32_t i) { return at[mesh.corners[first + i % size]]; };
    const std::uint32_t from =
        size == 4 && squared(place(3) - place(1)) < squared(place(2) - place(0)) ? 1 : 0;
    for (std::uint32_t i = 2; i < size; ++i) {
      for (const std::uint32_t k : {from, from + i - 1, from + i})
        corners.push_back(first + k % size);
      faces.push_back(f);
    }
    first += size;
  }
  Mesh out;
  out.vertex_count = mesh.vertex_count;
  out.name = mesh.name;
  out.metadata = mesh.metadata;
  out.corners.reserve(corners.size());
  for (const std::uint32_t c : corners) out.corners.push_back(mesh.corners[c]);
  for (const Attribute& a : mesh.attributes)
    out.attributes.push_back(a.domain == Domain::vertex ? a
                             : a.domain == Domain::face ? gathered(a, faces)
                                                        : gathered(a, corners));
  return out;
}

}  // namespace clers::cli
