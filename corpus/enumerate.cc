// Any two simple triangulations of the sphere with equally many vertices are connected by flips
// (Wagner 1936; Theorem 7 of the operators paper uses it), so closing one of them under flips finds
// all.
#include "corpus/enumerate.h"

#include <algorithm>
#include <set>
#include <vector>

#include "corpus/build.h"

namespace clers::corpus {
namespace {

// Corners of a triangulation. As the code of a rooted one: numbered from the root, so that equal
// codes mean isomorphic.
using Corners = std::vector<std::uint32_t>;

// The code of the triangulation rooted at `root`: faces in the order a breadth-first walk meets
// them, each from the edge it was entered by; vertices in the order of first use.
Corners code_of(const Corners& corners, const std::vector<std::uint32_t>& twin,
                std::uint32_t root) {
  Corners code;
  std::vector<std::uint32_t> label(corners.size(), no_twin);  // by vertex
  std::vector<bool> met(corners.size() / 3, false);
  std::vector<std::uint32_t> entries{root};
  std::uint32_t labels = 0;
  met[root / 3] = true;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    std::uint32_t h = entries[i];
    for (int k = 0; k < 3; ++k, h = next_corner(h)) {
      std::uint32_t& name = label[corners[h]];
      if (name == no_twin) name = labels++;
      code.push_back(name);
      if (!met[twin[h] / 3]) {
        met[twin[h] / 3] = true;
        entries.push_back(twin[h]);
      }
    }
  }
  return code;
}

std::set<Corners> all_rootings(const Corners& corners, std::uint32_t n) {
  const std::vector<std::uint32_t> twin = twins_of(corners, n);
  std::set<Corners> codes;
  for (std::uint32_t h = 0; h < corners.size(); ++h) codes.insert(code_of(corners, twin, h));
  return codes;
}

bool adjacent(const Corners& corners, std::uint32_t a, std::uint32_t b) {
  for (std::uint32_t h = 0; h < corners.size(); ++h)
    if (corners[h] == a && corners[next_corner(h)] == b) return true;
  return false;
}

// The simple triangulations one flip away.
std::vector<Corners> flips_of(const Corners& corners, std::uint32_t n) {
  const std::vector<std::uint32_t> twin = twins_of(corners, n);
  std::vector<Corners> out;
  for (std::uint32_t h = 0; h < corners.size(); ++h) {
    const std::uint32_t t = twin[h];
    const std::uint32_t c = corners[prev_corner(h)], d = corners[prev_corner(t)];
    if (h > t || adjacent(corners, c, d)) continue;
    // (a b c), (b a d) becomes (a d c), (b c d).
    Corners flipped = corners;
    flipped[next_corner(h)] = d;
    flipped[next_corner(t)] = c;
    out.push_back(std::move(flipped));
  }
  return out;
}

// A tetrahedron with vertices put into face 0 until there are n.
Corners stacked(std::uint32_t n) {
  Corners corners = {0, 1, 2, 0, 2, 3, 0, 3, 1, 1, 3, 2};
  for (std::uint32_t v = 4; v < n; ++v) {
    const std::uint32_t a = corners[0], b = corners[1], c = corners[2];
    corners[2] = v;
    corners.insert(corners.end(), {b, c, v, c, a, v});
  }
  return corners;
}

}  // namespace

void for_each_sphere_triangulation(std::uint32_t n, const std::function<void(const Mesh&)>& visit) {
  // Unrooted triangulations are known by the least of their codes.
  std::set<Corners> rooted, unrooted;
  std::vector<Corners> pending{stacked(n)};
  while (!pending.empty()) {
    const Corners corners = std::move(pending.back());
    pending.pop_back();
    const std::set<Corners> rootings = all_rootings(corners, n);
    if (!unrooted.insert(*rootings.begin()).second) continue;
    rooted.insert(rootings.begin(), rootings.end());
    for (Corners& flipped : flips_of(corners, n)) pending.push_back(std::move(flipped));
  }

  Points points(n);
  for (std::uint32_t v = 0; v < n; ++v) points.add(v, v * v, v * v * v);
  for (const Corners& code : rooted) visit(make_mesh(points, code));
}

}  // namespace clers::corpus
