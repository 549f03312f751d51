#include "corpus/random_gluing.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <numeric>
#include <set>
#include <vector>

namespace clers::corpus {
namespace {

constexpr std::uint32_t boundary = 0xffffffffu;

std::uint32_t next(std::uint32_t h) {
  return h / 3 * 3 + (h + 1) % 3;
}
std::uint32_t prev(std::uint32_t h) {
  return h / 3 * 3 + (h + 2) % 3;
}

struct Count {
  std::int64_t components = 0, boundary_edges = 0, boundary_curves = 0, genus = 0;
  bool loops = false, double_edges = false;
};

// Counts by walking, and checks that it is a surface.
Count count(const Gluing& g) {
  Count n;
  const auto size = static_cast<std::uint32_t>(g.org.size());
  EXPECT_EQ(g.twin.size(), size);
  std::int64_t edges = 0;
  std::set<std::pair<std::uint32_t, std::uint32_t>> ends;
  for (std::uint32_t h = 0; h < size; ++h) {
    const std::uint32_t t = g.twin[h], from = g.org[h], to = g.org[next(h)];
    EXPECT_LT(from, g.vertex_count);
    if (from == to) n.loops = true;
    if (t == boundary) {
      ++n.boundary_edges;
    } else {
      EXPECT_NE(t, h);
      EXPECT_EQ(g.twin[t], h);
      EXPECT_EQ(g.org[t], to);
      EXPECT_EQ(g.org[next(t)], from);
      if (t < h) continue;
    }
    ++edges;
    if (!ends.insert({std::min(from, to), std::max(from, to)}).second) n.double_edges = true;
  }
  // Every vertex is one fan: as many fans as vertices, none empty.
  std::vector<bool> seen(size, false);
  std::vector<unsigned> fans(g.vertex_count, 0);
  for (std::uint32_t h = 0; h < size; ++h) {
    if (seen[h]) continue;
    ++fans[g.org[h]];
    std::uint32_t c = h;  // turn one way to the end, then the other way through all
    while (g.twin[c] != boundary && next(g.twin[c]) != h) c = next(g.twin[c]);
    while (!seen[c]) {
      seen[c] = true;
      if (g.twin[prev(c)] != boundary) c = g.twin[prev(c)];
    }
  }
  for (std::uint32_t v = 0; v < g.vertex_count; ++v) EXPECT_EQ(fans[v], 1u) << "vertex " << v;

  std::vector<bool> walked(size, false);
  for (std::uint32_t h = 0; h < size; ++h) {
    if (g.twin[h] != boundary || walked[h]) continue;
    ++n.boundary_curves;
    for (std::uint32_t b = h; !walked[b];) {
      walked[b] = true;
      for (b = next(b); g.twin[b] != boundary;) b = next(g.twin[b]);
    }
  }
  std::vector<bool> met(size / 3, false);
  for (std::uint32_t f = 0; f < size / 3; ++f) {
    if (met[f]) continue;
    ++n.components;
    std::vector<std::uint32_t> pending{f};
    met[f] = true;
    while (!pending.empty()) {
      const std::uint32_t face = pending.back();
      pending.pop_back();
      for (std::uint32_t h = 3 * face; h < 3 * face + 3; ++h)
        if (g.twin[h] != boundary && !met[g.twin[h] / 3]) {
          met[g.twin[h] / 3] = true;
          pending.push_back(g.twin[h] / 3);
        }
    }
  }
  const std::int64_t euler = std::int64_t{g.vertex_count} - edges + size / 3;
  EXPECT_EQ((n.boundary_curves + euler) % 2, 0);
  n.genus = n.components - (n.boundary_curves + euler) / 2;
  EXPECT_GE(n.genus, 0);
  return n;
}

TEST(RandomGluing, IsASurfaceWhateverTheOptions) {
  bool loops = false, double_edges = false;
  for (std::uint64_t seed = 0; seed < 40; ++seed)
    for (std::uint32_t triangles : {0u, 1u, 2u, 3u, 10u, 101u})
      for (unsigned apart : {0u, 5u, 100u})
        for (unsigned zips : {0u, 50u, 100u})
          for (unsigned open : {0u, 5u, 100u}) {
            const Count n = count(random_gluing(triangles, seed, {apart, zips, open, true}));
            if (zips == 100) {
              EXPECT_EQ(n.genus, 0);
            }
            if (open == 0) {
              EXPECT_LE(n.boundary_edges, zips == 100 ? triangles : (triangles % 2));
            }
            loops = loops || n.loops;
            double_edges = double_edges || n.double_edges;
            const Count simpler = count(random_gluing(triangles, seed, {apart, zips, open, false}));
            EXPECT_FALSE(simpler.loops);
          }
  EXPECT_TRUE(loops);
  EXPECT_TRUE(double_edges);
}

TEST(RandomGluing, GenusFollowsTheShareOfZips) {
  std::int64_t last = 1 << 20;
  for (unsigned zips : {0u, 50u, 90u, 99u, 100u}) {
    const Count n = count(random_gluing(2000, 1, {0, zips, 0, true}));
    EXPECT_LT(n.genus, last);
    last = n.genus;
    EXPECT_EQ(n.components, 1);
  }
  EXPECT_EQ(last, 0);
}

TEST(RandomGluing, LeavesTheBoundaryAskedFor) {
  for (unsigned open : {1u, 10u, 30u}) {
    const Count n = count(random_gluing(1000, 3, {0, 50, open, true}));
    EXPECT_GE(n.boundary_edges, 30 * open);
    EXPECT_LE(n.boundary_edges, 30 * open + 1);
    EXPECT_GT(n.boundary_curves, 1);
  }
  EXPECT_GT(count(random_gluing(1000, 3, {30, 100, 10, true})).components, 10);
}

TEST(RandomGluing, IsTheSameEverywhere) {
  std::uint64_t hash = 0xcbf29ce484222325u;  // FNV-1a by words
  const Gluing g = random_gluing(300, 7, {5, 60, 5, false});
  for (const std::uint32_t v : g.org) hash = (hash ^ v) * 0x100000001b3u;
  for (const std::uint32_t h : g.twin) hash = (hash ^ h) * 0x100000001b3u;
  EXPECT_EQ(hash, 625646836004064243u);
}

}  // namespace
}  // namespace clers::corpus
