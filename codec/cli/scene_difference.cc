// Bytes are compared; vertices of arrays become values of meshes, which others compare.
#include "codec/cli/scene_difference.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <utility>

namespace clers::cli {
namespace {

/// Two different words for each number (Steele, Lea and Flood 2014: SplitMix).
std::uint64_t mixed(std::uint64_t x, std::uint64_t stream) {
  x = (x + 1) * 0x9e3779b97f4a7c15u + stream;
  x = (x ^ x >> 30) * 0xbf58476d1ce4e5b9u;
  x = (x ^ x >> 27) * 0x94d049bb133111ebu;
  return x ^ x >> 31;
}

/// Whether no component is further off. Precondition: they have as many of one type.
bool near(const Array& a, const Array& b, double error) {
  return with_type(a.scalar, [&](auto type) {
    using T = decltype(type);
    for (std::size_t at = 0; at < a.data.size(); at += sizeof(T)) {
      T x, y;
      std::memcpy(&x, a.data.data() + at, sizeof x);
      std::memcpy(&y, b.data.data() + at, sizeof y);
      const bool same = std::memcmp(&x, &y, sizeof x) == 0;
      if (!same && !(std::fabs(static_cast<double>(x) - static_cast<double>(y)) <= error))
        return false;
    }
    return true;
  });
}

}  // namespace

std::string scene_difference(const Scene& expected, const Scene& found,
                             std::span<const ArrayInfo> stated) {
  if (expected.document != found.document) return "the document is another one";
  if (expected.arrays.size() != found.arrays.size())
    return fmt::format("{} arrays, the original has {}", found.arrays.size(),
                       expected.arrays.size());
  for (std::size_t i = 0; i < found.arrays.size(); ++i) {
    const Array &a = expected.arrays[i], &b = found.arrays[i];
    const bool alike = a.name == b.name && a.scalar == b.scalar && a.components == b.components &&
                       a.vertices_of == b.vertices_of && a.data.size() == b.data.size() &&
                       (a.vertices_of || a.data == b.data || near(a, b, stated[i].error));
    if (!alike) return fmt::format("array {}, '{}'", i, a.name);
  }
  if (expected.blobs.size() != found.blobs.size())
    return fmt::format("{} blobs, the original has {}", found.blobs.size(), expected.blobs.size());
  for (std::size_t i = 0; i < found.blobs.size(); ++i) {
    const Blob &a = expected.blobs[i], &b = found.blobs[i];
    if (a.name != b.name || a.bytes != b.bytes) return fmt::format("blob {}, '{}'", i, a.name);
  }
  return "";
}

std::vector<Mesh> with_uses(const Scene& scene) {
  std::vector<Mesh> meshes = scene.meshes;
  for (std::size_t i = 0; i < scene.arrays.size(); ++i) {
    const Array& array = scene.arrays[i];
    if (!array.vertices_of || *array.vertices_of >= meshes.size()) continue;
    Mesh& mesh = meshes[*array.vertices_of];
    std::vector<std::uint64_t> uses(2 * std::size_t(mesh.vertex_count));
    for (std::size_t k = 0; k < array.value_count(); ++k) {
      std::uint32_t v = 0;
      std::memcpy(&v, array.data.data() + k * sizeof v, sizeof v);
      for (std::uint64_t s = 0; s < 2; ++s) uses[2 * std::size_t(v) + s] += mixed(k, s << 62);
    }
    Attribute a{fmt::format("array {}", i), Domain::vertex, Scalar::uint64, 2, {}};
    a.data.resize(uses.size() * sizeof(std::uint64_t));
    std::memcpy(a.data.data(), uses.data(), a.data.size());
    mesh.attributes.push_back(std::move(a));
  }
  return meshes;
}

}  // namespace clers::cli
