// Whether a decoded surface is the one that was encoded: every half-edge names the one it came
// from, and twins must go with twins.
#ifndef CLERS_CODEC_TEST_CORRESPONDENCE_H
#define CLERS_CODEC_TEST_CORRESPONDENCE_H

#include <cstddef>
#include <cstdint>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "codec/connectivity/connectivity.h"
#include "topology/ids.h"

namespace clers::internal {

/// Half-edge of the input that a decoded half-edge came from.
inline HalfEdge origin_of(const EncodedConnectivity& coded, std::size_t h) {
  HalfEdge g = coded.gates[h / 3];
  for (std::size_t i = 0; i < h % 3; ++i) g = lnext(g);
  return g;
}

/// What is not the same, or nothing. `org` and `twins` are the input.
inline std::string difference_of(std::span<const std::uint32_t> org,
                                 std::span<const HalfEdge> twins, const EncodedConnectivity& coded,
                                 std::span<const std::uint32_t> out_org,
                                 std::span<const HalfEdge> out_twins) {
  if (out_org.size() != org.size()) return "half-edges: " + std::to_string(out_org.size());
  std::vector<bool> seen(org.size());
  for (std::size_t h = 0; h < org.size(); ++h) {
    const HalfEdge g = origin_of(coded, h);
    if (seen[g.index()]) return "twice: " + std::to_string(g.index());
    seen[g.index()] = true;
    if (out_org[h] >= coded.vertices.size() || coded.vertices[out_org[h]] != org[g.index()])
      return "vertex of half-edge " + std::to_string(h);
    const HalfEdge t = out_twins[h], expected = twins[g.index()];
    if (bool(t) != bool(expected) || (t && origin_of(coded, t.index()) != expected))
      return "twin of half-edge " + std::to_string(h);
  }
  if (std::set<std::uint32_t>(coded.vertices.begin(), coded.vertices.end()).size() !=
      coded.vertices.size())
    return "a vertex has two numbers";
  return {};
}

}  // namespace clers::internal

#endif
