// 4-8 subdivision: counts, the numbering that carries it, and its positions beside those of the
// box spline that it generalises.
#include "topology/modeling/four_eight.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "corpus/generate.h"
#include "topology/dump.h"
#include "topology/modeling/test/meshes.h"
#include "topology/test/meshes.h"
#include "topology/validate.h"

namespace clers {
namespace {

using test::distance;
using test::Position;
using test::Positions;
using test::Shape;
using test::shape_of;

auto length_in(const Positions& positions) {
  return [&positions](const Surface& s, HalfEdge h) {
    return distance(positions[s.org(h)], positions[s.dest(h)]);
  };
}

TEST(FourEight, CountsAreExactAndTheTopologyStays) {
  for (const Mesh& mesh : {corpus::tetrahedron(), corpus::flip_edges(corpus::icosphere(2), 300, 7),
                           corpus::flip_edges(corpus::torus(9, 7), 100, 8), corpus::cylinder(8, 3),
                           corpus::flip_edges(corpus::grid(6, 5), 40, 9), corpus::single_triangle(),
                           corpus::glued_pair(), corpus::gyroid(1, 1, 1, 8, corpus::Ends::open)}) {
    Shape shape = shape_of(mesh);
    Creases none;
    const Characteristic start = shape.surface.characteristic();
    ASSERT_TRUE(make_tri_quad(shape.surface, shape.positions, none, length_in(shape.positions)));
    EXPECT_TRUE(check_tri_quad(shape.surface));
    Characteristic before = shape.surface.characteristic();
    // 3F - 2p faces: from at most half as many pairs as faces.
    EXPECT_EQ((3 * start.f - before.f) % 2, 0);
    EXPECT_GE(before.f, 2 * start.f);
    EXPECT_LE(before.f, 3 * start.f);
    const std::string coarse = dump(shape.surface);
    for (int step = 0; step < 5; ++step) {
      ASSERT_TRUE(subdivide_4_8(shape.surface, shape.positions, none));
      const Characteristic& after = shape.surface.characteristic();
      EXPECT_EQ(after.f, 2 * before.f);
      EXPECT_EQ(std::tie(after.b, after.g, after.s), std::tie(start.b, start.g, start.s));
      EXPECT_TRUE(check_tri_quad(shape.surface));
      before = after;
    }
    EXPECT_TRUE(validate(shape.surface).empty());

    // And back by numbering alone: weld all that is at corner 0, level by level, last made first.
    for (int step = 0; step < 5; ++step) {
      std::vector<Vertex> weldable;
      for (const Face f : shape.surface.faces())
        weldable.push_back(shape.surface.org(half_edge(f, 0)));
      std::sort(weldable.begin(), weldable.end());
      weldable.erase(std::unique(weldable.begin(), weldable.end()), weldable.end());
      for (; !weldable.empty(); weldable.pop_back())
        ASSERT_TRUE(shape.surface.weld(weldable.back()));
    }
    EXPECT_EQ(dump(shape.surface), coarse);
  }
}

TEST(FourEight, NeedsATriQuadMesh) {
  Shape shape = shape_of(corpus::grid(3, 3));
  Creases none;
  const std::string before = dump(shape.surface);
  const auto refused = subdivide_4_8(shape.surface, shape.positions, none);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().precondition, Precondition::tri_quad);
  EXPECT_EQ(dump(shape.surface), before);
}

// On a square lattice a step of the scheme is the upsampling of values by (1 + x)^2 (1 + y)^2 / 8
// in the coordinates of the finer, turned lattice (Velho and Zorin): here with sums of whole
// arrays.
TEST(FourEight, IsTheBoxSplineOnALattice) {
  constexpr int n = 6;
  // Squares of an n by n torus with their centres: each a tri-quad of four faces, half-edge 1
  // outside.
  std::vector<Position> at(2 * n * n);
  const auto corner_at = [](int x, int y) {
    return static_cast<std::uint32_t>((y + n) % n * n + (x + n) % n);
  };
  test::Triangles triangles;
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < n; ++x) {
      const std::uint32_t c = n * n + corner_at(x, y);
      const std::uint32_t around[] = {corner_at(x, y), corner_at(x + 1, y), corner_at(x + 1, y + 1),
                                      corner_at(x, y + 1)};
      for (int i = 0; i < 4; ++i) triangles.push_back({c, around[i], around[(i + 1) % 4]});
      for (const std::uint32_t v : {corner_at(x, y), c})
        at[v] = {std::sin(v * 1.7), std::cos(v * 0.9), v % 5 * 0.3};
    }
  Shape shape{test::from_triangles(triangles), Positions(at)};
  // The lattice of all vertices, in steps of half a square: (2x, 2y), (2x+1, 2y+1).
  constexpr int m = 2 * n;
  std::vector<Position> lattice(m * m);
  const auto cell = [&](int x, int y) -> Position& {
    return lattice[static_cast<std::size_t>((y + m) % m * m + (x + m) % m)];
  };
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < n; ++x) {
      cell(2 * x, 2 * y) = at[corner_at(x, y)];
      cell(2 * x + 1, 2 * y + 1) = at[n * n + corner_at(x, y)];
    }
  // Zeros between them, then twice the mean of neighbours along x, twice along y, times two.
  for (const auto& [dx, dy] :
       {std::pair(1, 0), std::pair(-1, 0), std::pair(0, 1), std::pair(0, -1)}) {
    std::vector<Position> next(lattice.size());
    for (int y = 0; y < m; ++y)
      for (int x = 0; x < m; ++x) {
        Position sum = cell(x, y);
        sum += cell(x + dx, y + dy);
        next[static_cast<std::size_t>(y * m + x)] = 0.5 * sum;
      }
    lattice = next;
  }
  Creases none;
  const std::uint32_t old = shape.surface.vertex_limit();
  ASSERT_TRUE(subdivide_4_8(shape.surface, shape.positions, none));
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < n; ++x) {
      EXPECT_LT(distance(shape.positions[Vertex(corner_at(x, y))], 2. * cell(2 * x, 2 * y)), 1e-12);
      EXPECT_LT(distance(shape.positions[Vertex(n * n + corner_at(x, y))],
                         2. * cell(2 * x + 1, 2 * y + 1)),
                1e-12);
    }
  // A new vertex, on a side of a square: between the two corners whose edge was split.
  std::size_t found = 0;
  for (std::uint32_t v = old; v < shape.surface.vertex_limit(); ++v) {
    const HalfEdge star = shape.surface.star_half_edge(Vertex(v));
    const HalfEdge across = shape.surface.sym(lprev(shape.surface.sym(lprev(star))));
    const std::uint32_t a = shape.surface.dest(star).index();
    const std::uint32_t b = shape.surface.dest(across).index();
    const auto step = [](std::uint32_t p, std::uint32_t q) {
      const int d = static_cast<int>(q) - static_cast<int>(p);
      return d == n - 1 ? -1 : d == 1 - n ? 1 : d;
    };
    const int ax = static_cast<int>(a % n), ay = static_cast<int>(a / n);
    const int x = 2 * ax + step(a % n, b % n), y = 2 * ay + step(a / n, b / n);
    EXPECT_LT(distance(shape.positions[Vertex(v)], 2. * cell(x, y)), 1e-12);
    ++found;
  }
  EXPECT_EQ(found, 2u * n * n);
}

// Two steps halve the edges of a boundary or crease by the rule of cubic splines, and feel nothing
// of what is beside.
TEST(FourEight, SharpCurvesAreCubicSplines) {
  for (const bool crease : {false, true}) {
    Shape shape = crease ? Shape{test::torus(6, 6), Positions()} : shape_of(corpus::cylinder(6, 4));
    if (crease)
      for (const Vertex v : shape.surface.vertices())
        shape.positions.set(v, {std::sin(v.index()), std::cos(2. * v.index()), v.index() * 0.1});
    Creases creases;
    std::vector<Vertex> curve;
    if (crease) {
      for (const HalfEdge h : edges_of(shape.surface))
        if (shape.surface.org(h).index() / 6 == 2 && shape.surface.dest(h).index() / 6 == 2)
          creases.mark(shape.surface, h);
      for (std::uint32_t x = 0; x < 6; ++x) curve.emplace_back(12 + x);
    } else {
      for (const HalfEdge h : shape.surface.boundary(*shape.surface.curves().begin()))
        curve.push_back(shape.surface.org(h));
    }
    std::vector<Position> spline;
    for (const Vertex v : curve) spline.push_back(shape.positions[v]);
    ASSERT_TRUE(make_tri_quad(shape.surface, shape.positions, creases, length_in(shape.positions)));
    for (int pair = 0; pair < 3; ++pair) {
      for (int step = 0; step < 2; ++step)
        ASSERT_TRUE(subdivide_4_8(shape.surface, shape.positions, creases));
      std::vector<Position> finer;
      const std::size_t n = spline.size();
      for (std::size_t i = 0; i < n; ++i) {
        const Position &before = spline[(i + n - 1) % n], &here = spline[i],
                       &after = spline[(i + 1) % n];
        Position old = 0.75 * here, middle = 0.5 * here;
        old += 0.125 * before;
        old += 0.125 * after;
        middle += 0.5 * after;
        finer.push_back(old);
        finer.push_back(middle);
      }
      spline = finer;
    }
    std::size_t met = 0;
    for (const Vertex v : shape.surface.vertices()) {
      if (!sharp_edges(shape.surface, creases, v).curve()) continue;
      const bool on = std::any_of(spline.begin(), spline.end(), [&](const Position& p) {
        return distance(p, shape.positions[v]) < 1e-12;
      });
      met += on;
    }
    EXPECT_EQ(met, spline.size());
  }
}

}  // namespace
}  // namespace clers
