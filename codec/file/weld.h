// Which vertices of a mesh are at one place, bit for bit: what seams had split. Knows positions as
// bytes, and no surface.
#ifndef CLERS_CODEC_FILE_WELD_H
#define CLERS_CODEC_FILE_WELD_H

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <utility>
#include <vector>

#include "codec/mesh_view.h"

namespace clers::internal {

/// Vertices that are one.
struct Weld {
  std::vector<std::uint32_t> vertex_of;  ///< of each vertex: that which it becomes
  std::uint32_t count = 0;               ///< how many there are then
};

/// A hash of a position (the finaliser of splitmix64; Steele, Lea and Flood 2014).
inline std::uint64_t hash_of(const std::byte* value, std::size_t size) {
  std::uint64_t h = 0;
  for (std::size_t at = 0; at < size; at += sizeof h) {
    std::uint64_t word = 0;
    std::memcpy(&word, value + at, std::min(sizeof word, size - at));
    h = (h ^ word) + 0x9e3779b97f4a7c15u;
    h = (h ^ (h >> 30)) * 0xbf58476d1ce4e5b9u;
    h = (h ^ (h >> 27)) * 0x94d049bb133111ebu;
    h ^= h >> 31;
  }
  return h;
}

/// Welds the vertices that faces use, and numbers them in the order of the first of each. None: no
/// two are at one place. Cost: n log n.
inline std::optional<Weld> find_weld(const MeshView& mesh) {
  const auto position = mesh.position();
  if (!position) return std::nullopt;
  const std::size_t size = position->value_size();
  std::vector<bool> used(mesh.vertex_count);
  for (const std::uint32_t v : mesh.corners) used[v] = true;
  std::vector<std::pair<std::uint64_t, std::uint32_t>> sorted;
  sorted.reserve(mesh.vertex_count);
  for (std::uint32_t v = 0; v < mesh.vertex_count; ++v)
    if (used[v]) sorted.push_back({hash_of(position->value(v), size), v});
  std::sort(sorted.begin(), sorted.end());
  Weld weld;
  weld.vertex_of.resize(mesh.vertex_count);
  for (std::uint32_t v = 0; v < mesh.vertex_count; ++v) weld.vertex_of[v] = v;
  // The first of its equals; equal hashes of other positions part them, which is no harm.
  bool any = false;
  for (std::size_t i = 1; i < sorted.size(); ++i) {
    const std::uint32_t u = sorted[i - 1].second, v = sorted[i].second;
    if (sorted[i - 1].first != sorted[i].first ||
        std::memcmp(position->value(u), position->value(v), size) != 0)
      continue;
    weld.vertex_of[v] = weld.vertex_of[u];
    any = true;
  }
  if (!any) return std::nullopt;
  for (std::uint32_t v = 0; v < mesh.vertex_count; ++v)
    weld.vertex_of[v] = weld.vertex_of[v] == v ? weld.count++ : weld.vertex_of[weld.vertex_of[v]];
  return weld;
}

}  // namespace clers::internal

#endif
