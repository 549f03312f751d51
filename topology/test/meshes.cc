#include "topology/test/meshes.h"

#include <algorithm>
#include <tuple>

#include "topology/derived.h"

namespace clers::test {

Surface from_triangles(const Triangles& triangles) {
  // Sides sorted by their ends, the two of an edge come together.
  struct Side {
    std::uint32_t low, high;
    HalfEdge h;
  };
  std::vector<Side> sides;
  std::vector<Vertex> org;
  std::uint32_t vertices = 0;
  for (const auto& t : triangles)
    for (unsigned i = 0; i < 3; ++i) {
      const auto [low, high] = std::minmax(t[i], t[(i + 1) % 3]);
      sides.push_back({low, high, HalfEdge(static_cast<std::uint32_t>(org.size()))});
      org.emplace_back(t[i]);
      vertices = std::max(vertices, t[i] + 1);
    }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    return std::tie(a.low, a.high, a.h) < std::tie(b.low, b.high, b.h);
  });
  std::vector<HalfEdge> twin(org.size());
  for (std::size_t i = 1; i < sides.size(); ++i) {
    const Side &a = sides[i - 1], &b = sides[i];
    if (a.low != b.low || a.high != b.high) continue;
    twin[a.h.index()] = b.h;
    twin[b.h.index()] = a.h;
  }
  return *Surface::from_twins(org, twin, vertices);
}

Surface grid(std::uint32_t columns, std::uint32_t rows) {
  Triangles t;
  const std::uint32_t w = columns + 1;
  for (std::uint32_t y = 0; y < rows; ++y)
    for (std::uint32_t x = 0; x < columns; ++x) {
      const std::uint32_t a = y * w + x;
      t.push_back({a, a + 1, a + w + 1});
      t.push_back({a, a + w + 1, a + w});
    }
  return from_triangles(t);
}

Surface torus(std::uint32_t columns, std::uint32_t rows) {
  Triangles t;
  const auto at = [&](std::uint32_t x, std::uint32_t y) {
    return y % rows * columns + x % columns;
  };
  for (std::uint32_t y = 0; y < rows; ++y)
    for (std::uint32_t x = 0; x < columns; ++x) {
      t.push_back({at(x, y), at(x + 1, y), at(x + 1, y + 1)});
      t.push_back({at(x, y), at(x + 1, y + 1), at(x, y + 1)});
    }
  return from_triangles(t);
}

Surface chain_of_tori(std::uint32_t tori, std::uint32_t side) {
  // The arrays of one torus, repeated; then holes, and seams between them.
  const Surface one = torus(side, side);
  const std::uint32_t n = one.half_edge_limit(), v = one.vertex_limit();
  std::vector<Vertex> org;
  std::vector<HalfEdge> twin;
  for (std::uint32_t i = 0; i < tori; ++i)
    for (std::uint32_t h = 0; h < n; ++h) {
      org.emplace_back(one.origins()[h].index() + i * v);
      twin.emplace_back(one.twins()[h].index() + i * n);
    }
  Surface s = *Surface::from_twins(org, twin, tori * v);
  const auto hole = [&](std::uint32_t torus_index, std::uint32_t face) {
    const Face f(torus_index * n / 3 + face);
    const HalfEdge rim = s.sym(half_edge(f, 0));
    (void)detach(s, f);
    return rim;
  };
  for (std::uint32_t i = 0; i + 1 < tori; ++i) {
    HalfEdge a = hole(i, n / 6), b = hole(i + 1, 0);
    for (int edge = 0; edge < 3; ++edge) {
      const HalfEdge next_a = s.boundary_next(a), next_b = s.boundary_prev(b);
      (void)s.glue(a, b);
      a = next_a, b = next_b;
    }
  }
  return s;
}

}  // namespace clers::test
