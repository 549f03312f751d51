#include "corpus/test/recount.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <vector>

namespace clers::corpus {
namespace {

class Classes {
 public:
  explicit Classes(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0u); }

  std::uint32_t of(std::uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void unite(std::uint32_t i, std::uint32_t j) { parent_[of(i)] = of(j); }

 private:
  std::vector<std::uint32_t> parent_;
};

// One side of a triangle: the ends in order, and the two corners (3f+i) in the order of the ends.
struct Side {
  std::uint32_t low, high;
  std::uint32_t at_low, at_high;
  bool upward;

  bool same_edge(const Side& other) const { return low == other.low && high == other.high; }
};

}  // namespace

Figures recount(const Mesh& mesh) {
  Figures n;
  n.vertices = mesh.vertex_count;
  n.faces = static_cast<std::int64_t>(mesh.corners.size() / 3);

  std::vector<Side> sides;
  sides.reserve(mesh.corners.size());
  std::vector<std::array<std::uint32_t, 3>> triples;
  triples.reserve(mesh.corners.size() / 3);
  for (std::uint32_t f = 0; f < mesh.corners.size(); f += 3) {
    std::array<std::uint32_t, 3> t{mesh.corners[f], mesh.corners[f + 1], mesh.corners[f + 2]};
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t c = f + k, d = f + (k + 1) % 3;
      const bool upward = mesh.corners[c] <= mesh.corners[d];
      if (upward)
        sides.push_back({mesh.corners[c], mesh.corners[d], c, d, true});
      else
        sides.push_back({mesh.corners[d], mesh.corners[c], d, c, false});
    }
    std::sort(t.begin(), t.end());
    n.degenerate_faces += t[0] == t[1] || t[1] == t[2];
    triples.push_back(t);
  }
  std::sort(triples.begin(), triples.end());
  for (std::size_t f = 1; f < triples.size(); ++f) n.equal_faces += triples[f] == triples[f - 1];
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    return a.low != b.low     ? a.low < b.low
           : a.high != b.high ? a.high < b.high
                              : a.at_low < b.at_low;
  });

  Classes component(mesh.vertex_count), curve(mesh.vertex_count), fan(mesh.corners.size());
  std::vector<bool> on_boundary(mesh.vertex_count, false), used(mesh.vertex_count, false);
  for (std::size_t i = 0, end; i < sides.size(); i = end) {
    end = i + 1;
    while (end < sides.size() && sides[end].same_edge(sides[i])) ++end;
    const Side& a = sides[i];
    ++n.edges;
    component.unite(a.low, a.high);
    used[a.low] = used[a.high] = true;
    if (end - i == 1) {
      on_boundary[a.low] = on_boundary[a.high] = true;
      curve.unite(a.low, a.high);
    }
    if (end - i == 2) n.misoriented_edges += a.upward == sides[i + 1].upward;
    if (end - i > 2) ++n.crowded_edges;
    for (std::size_t j = i + 1; j < end; ++j) {
      fan.unite(a.at_low, sides[j].at_low);
      fan.unite(a.at_high, sides[j].at_high);
    }
  }

  for (std::uint32_t v = 0; v < mesh.vertex_count; ++v) {
    n.isolated_vertices += !used[v];
    n.components += used[v] && component.of(v) == v;
    n.boundary_curves += on_boundary[v] && curve.of(v) == v;
  }
  std::vector<std::uint8_t> fans(mesh.vertex_count, 0);
  for (std::uint32_t c = 0; c < mesh.corners.size(); ++c)
    if (fan.of(c) == c && fans[mesh.corners[c]]++ == 1) ++n.pinched_vertices;
  const std::int64_t euler = n.vertices - n.isolated_vertices - n.edges + n.faces;
  n.genus = (2 * n.components - n.boundary_curves - euler) / 2;
  return n;
}

}  // namespace clers::corpus
