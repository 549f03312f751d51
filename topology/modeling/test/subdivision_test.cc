// Loop and square root of 3: exact counts, the same topology, and the same positions as another
// implementation gives.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstring>
#include <set>

#include "corpus/generate.h"
#include "topology/derived.h"
#include "topology/modeling/loop.h"
#include "topology/modeling/sqrt3.h"
#include "topology/modeling/test/meshes.h"
#include "topology/test/meshes.h"
#include "topology/validate.h"

namespace clers {
namespace {

using test::agree;
using test::distance;
using test::PeerScheme;
using test::Plain;
using test::plain_of;
using test::Position;
using test::Positions;
using test::Shape;
using test::shape_of;

/// And uneven, so that no two vertices come to one place.
Mesh moved(Mesh mesh, double by) {
  for (Attribute& a : mesh.attributes)
    for (std::size_t i = 0; i < a.data.size(); i += sizeof(float)) {
      float x;
      std::memcpy(&x, a.data.data() + i, sizeof x);
      x += static_cast<float>(by + 0.1 * std::sin(static_cast<double>(i)));
      std::memcpy(a.data.data() + i, &x, sizeof x);
    }
  return mesh;
}

/// Closed, bounded, of genus, of several components, irregular, of high degree.
std::vector<Mesh> meshes() {
  const Mesh parts[] = {corpus::icosphere(0), moved(corpus::cylinder(5, 3), 7),
                        moved(corpus::torus(5, 4), 17)};
  return {
      corpus::tetrahedron(),
      corpus::flip_edges(corpus::icosphere(2), 300, 7),
      corpus::flip_edges(corpus::torus(9, 7), 100, 8),
      moved(corpus::flip_edges(corpus::grid(6, 5), 40, 9), 0),
      corpus::cylinder(8, 3),
      corpus::single_triangle(),
      corpus::fan(30),
      corpus::punch_holes(corpus::flip_edges(corpus::torus(12, 12), 100, 3), 6, 4),
      corpus::gyroid(1, 1, 1, 8, corpus::Ends::open),
      corpus::disjoint_union(parts),
  };
}

Characteristic multiplied(const Characteristic& c, std::int64_t faces, std::int64_t vertices) {
  Characteristic out = c;
  out.f = faces;
  out.v = vertices;
  out.e = out.v + out.f - (2 * (c.s - c.g) - c.b);
  return out;
}

std::int64_t boundary_edges(const Surface& s) {
  std::int64_t n = 0;
  for (const Curve c : s.curves()) n += s.length(c);
  return n;
}

void loop(Shape& shape, unsigned times, Creases& creases) {
  for (unsigned i = 0; i < times; ++i)
    ASSERT_TRUE(subdivide_loop(shape.surface, shape.positions, creases));
}
void sqrt3(Shape& shape, unsigned times, Creases& creases) {
  for (unsigned i = 0; i < times; ++i)
    ASSERT_TRUE(subdivide_sqrt3(shape.surface, shape.positions, creases,
                                i % 2 == 0 ? Sqrt3Step::first : Sqrt3Step::second));
}
using Scheme = void (*)(Shape&, unsigned, Creases&);

TEST(Subdivision, CountsAreExactAndTheTopologyStays) {
  for (const Mesh& mesh : meshes()) {
    Shape l = shape_of(mesh), k = l;
    Creases none;
    for (int step = 0; step < 3; ++step) {
      const Characteristic before = l.surface.characteristic();
      ASSERT_TRUE(subdivide_loop(l.surface, l.positions, none));
      EXPECT_EQ(l.surface.characteristic(), multiplied(before, 4 * before.f, before.v + before.e));
    }
    EXPECT_TRUE(validate(l.surface).empty());
    for (int step = 0; step < 4; ++step) {
      const Characteristic before = k.surface.characteristic();
      const std::int64_t rim = boundary_edges(k.surface);
      sqrt3(k, 0, none);
      ASSERT_TRUE(subdivide_sqrt3(k.surface, k.positions, none,
                                  step % 2 == 0 ? Sqrt3Step::first : Sqrt3Step::second));
      // A face on the boundary gets two vertices in the second step, any other one.
      const std::int64_t made = before.f + (step % 2 == 0 ? 0 : rim);
      EXPECT_EQ(k.surface.characteristic(), multiplied(before, 3 * before.f, before.v + made));
      EXPECT_EQ(boundary_edges(k.surface), step % 2 == 0 ? rim : 3 * rim);
    }
    EXPECT_TRUE(validate(k.surface).empty());
  }
}

// Not only simplicial complexes, and not only surfaces without free ids.
TEST(Subdivision, OfSurfacesThatAreNoComplexes) {
  Surface pair;
  ASSERT_TRUE(pair.create(Point(0), Point(1), Point(2)));
  ASSERT_TRUE(pair.create(Point(1), Point(0), Point(2)));
  ASSERT_TRUE(pair.glue(HalfEdge(0), HalfEdge(3)));
  ASSERT_TRUE(pair.glue(HalfEdge(1), HalfEdge(5)));
  Surface closed = pair;
  ASSERT_TRUE(closed.glue(HalfEdge(2), HalfEdge(4)));
  Surface holes = test::torus(5, 5);
  for (const std::uint32_t f : {3u, 17u, 30u}) ASSERT_TRUE(detach(holes, Face(f)).ok());
  for (const Surface& s : {pair, closed, holes}) {
    for (const Scheme scheme : {loop, sqrt3}) {
      Shape shape{s, Positions(std::vector<Position>(s.vertex_limit(), {1, 2, 3}))};
      Creases none;
      scheme(shape, 4, none);
      EXPECT_TRUE(validate(shape.surface).empty());
      const Characteristic &a = s.characteristic(), &b = shape.surface.characteristic();
      EXPECT_EQ(std::tie(a.b, a.g, a.s), std::tie(b.b, b.g, b.s));
      EXPECT_EQ(b.f, a.f * (scheme == Scheme(loop) ? 256 : 81));
      // The weights of every mask add up to one.
      for (const Vertex v : shape.surface.vertices())
        ASSERT_LT(distance(shape.positions[v], Position(1, 2, 3)), 1e-12);
    }
  }
  // A cone: its edge has one face on both sides. The first steps of sqrt3 take it, Loop does not.
  Surface cone;
  ASSERT_TRUE(cone.create(Point(0), Point(1), Point(2)));
  ASSERT_TRUE(cone.glue(HalfEdge(0), HalfEdge(1)));
  Shape shape{cone, Positions(std::vector<Position>(3))};
  Creases none;
  EXPECT_EQ(subdivide_loop(shape.surface, shape.positions, none).error().precondition,
            Precondition::two_faces);
  ASSERT_TRUE(subdivide_sqrt3(shape.surface, shape.positions, none, Sqrt3Step::first));
  EXPECT_TRUE(validate(shape.surface).empty());
  // A second step needs a first one.
  Shape alone = shape_of(corpus::single_triangle());
  EXPECT_EQ(subdivide_sqrt3(alone.surface, alone.positions, none, Sqrt3Step::second).error(),
            (Violation{Precondition::one_sharp_edge, 0}));
}

TEST(Subdivision, AgreesWithOpenMesh) {
  double worst = 0;
  std::size_t triangles = 0;
  for (const Mesh& mesh : meshes()) {
    const Plain control = plain_of(shape_of(mesh));
    for (unsigned times = 1; times <= 4; ++times) {
      for (const Scheme scheme : {loop, sqrt3}) {
        // Enough of every mesh for three steps, or two pairs, of the small ones.
        const double faces = static_cast<double>(control.triangles.size()) *
                             std::pow(scheme == Scheme(loop) ? 4 : 3, times);
        if (times > 2 && faces > 20'000) continue;
        Shape ours = shape_of(mesh);
        Creases none;
        scheme(ours, times, none);
        const Plain theirs = test::subdivide_by_openmesh(
            control, scheme == Scheme(loop) ? PeerScheme::loop : PeerScheme::sqrt3, times);
        const auto found = agree(plain_of(ours), theirs, 1e-6);
        EXPECT_EQ(found.wrong, "") << mesh.corners.size() / 3 << " triangles, times " << times
                                   << (scheme == Scheme(loop) ? " loop" : " sqrt3");
        worst = std::max(worst, found.distance);
        triangles += theirs.triangles.size();
      }
    }
  }
  std::printf("largest distance %.3g, of %zu triangles\n", worst, triangles);
  EXPECT_LT(worst, 1e-12);
}

// What the masks say of the limit from the control mesh, they must say from OpenMesh's refinement
// of it; and the refinement must tend there.
TEST(Subdivision, LimitsAreThoseOfThePeersMeshes) {
  double worst = 0;
  for (const Mesh& mesh : meshes()) {
    for (const bool is_loop : {true, false}) {
      const Shape control = shape_of(mesh);
      const auto limit_mask = is_loop ? loop_limit_mask : sqrt3_limit_mask;
      Creases none;
      std::vector<Term> mask;
      std::vector<Position> limits;
      for (const Vertex v : control.surface.vertices()) {
        limit_mask(control.surface, none, v, mask);
        limits.push_back(control.positions.combine(mask));
      }
      // The peer keeps the old vertices first, in their order.
      for (const unsigned times : {2u, 4u}) {
        if (times > 2 && limits.size() > 60) continue;
        const Plain fine = test::subdivide_by_openmesh(
            plain_of(control), is_loop ? PeerScheme::loop : PeerScheme::sqrt3, times);
        const Surface surface = test::from_triangles(fine.triangles);
        std::vector<Position> positions;
        for (const auto& p : fine.points) positions.emplace_back(p[0], p[1], p[2]);
        const Positions there(std::move(positions));
        for (std::uint32_t v = 0; v < limits.size(); ++v) {
          limit_mask(surface, none, Vertex(v), mask);
          worst = std::max(worst, distance(there.combine(mask), limits[v]));
        }
      }
    }
  }
  std::printf("largest distance %.3g\n", worst);
  EXPECT_LT(worst, 1e-6);
}

/// Marks closed curves of a torus: along the second direction at two places.
std::vector<HalfEdge> rings(const Surface& s, std::uint32_t side) {
  std::vector<HalfEdge> out;
  for (const std::uint32_t x : {0u, side / 2})
    for (const Face f : s.faces())
      for (const HalfEdge h : s.star(f))
        if (s.org(h).index() % side == x && s.dest(h).index() % side == x && h < s.sym(h))
          out.push_back(h);
  return out;
}

// Beside a crease nothing is felt of the other side: as if the surface were cut there.
TEST(Subdivision, CreasesAreAsBoundaries) {
  constexpr std::uint32_t side = 6;
  Surface torus = test::torus(side, side);
  std::vector<Position> at;
  for (std::uint32_t v = 0; v < torus.vertex_limit(); ++v)
    at.emplace_back(std::sin(7. * v), std::sin(5. * v), std::sin(3. * v));
  for (const Scheme scheme : {loop, sqrt3}) {
    Shape creased{torus, Positions(at)};
    Creases creases;
    const auto curves = rings(torus, side);
    ASSERT_EQ(curves.size(), 2 * side);
    for (const HalfEdge h : curves) creases.mark(torus, h);

    Shape cut = creased;
    for (const HalfEdge h : curves) ASSERT_TRUE(cut.surface.unglue(h));
    for (const Vertex v : cut.surface.vertices())
      cut.positions.set(v, at[cut.surface.point(v).index()]);
    ASSERT_EQ(cut.surface.characteristic().s, 2);

    Creases none;
    scheme(creased, scheme == Scheme(loop) ? 3 : 4, creases);
    scheme(cut, scheme == Scheme(loop) ? 3 : 4, none);
    EXPECT_TRUE(validate(creased.surface).empty());
    EXPECT_EQ(creased.surface.characteristic().g, 1);
    // Every triangle is where it is without the other side.
    const auto soup = [](const Shape& shape) {
      std::multiset<std::array<std::int64_t, 9>> out;
      for (const Face f : shape.surface.faces()) {
        std::array<std::array<std::int64_t, 3>, 3> t;
        for (unsigned i = 0; i < 3; ++i)
          for (unsigned k = 0; k < 3; ++k)
            t[i][k] = std::llround(shape.positions[shape.surface.org(half_edge(f, i))][k] * 1e7);
        std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
        out.insert(
            {t[0][0], t[0][1], t[0][2], t[1][0], t[1][1], t[1][2], t[2][0], t[2][1], t[2][2]});
      }
      return out;
    };
    EXPECT_EQ(soup(creased), soup(cut));
  }
}

TEST(Subdivision, CornersStayAndDartsAreSmooth) {
  // All edges of an octahedron but one, which leaves corners of three creases and four.
  const std::vector<Position> at{{1, 0, 0},  {-1, 0, 0}, {0, 1, 0},
                                 {0, -1, 0}, {0, 0, 1},  {0, 0, -1}};
  const test::Triangles triangles{{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                                  {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  for (const Scheme scheme : {loop, sqrt3}) {
    Shape shape{test::from_triangles(triangles), Positions(at)};
    Creases creases;
    for (const HalfEdge h : edges_of(shape.surface))
      if (shape.surface.org(h) != Vertex(0) || shape.surface.dest(h) != Vertex(2))
        creases.mark(shape.surface, h);
    scheme(shape, 4, creases);
    EXPECT_TRUE(validate(shape.surface).empty());
    for (std::uint32_t v = 0; v < 6; ++v) EXPECT_EQ(shape.positions[Vertex(v)], at[v]);

    // One crease edge: its ends are darts, and move as if it were none; what is on it does not.
    Shape dart{test::from_triangles(triangles), Positions(at)}, smooth = dart;
    Creases one, none;
    one.mark(dart.surface, HalfEdge(0));
    scheme(dart, 1, one);
    scheme(smooth, 1, none);
    for (std::uint32_t v = 0; v < 6; ++v)
      EXPECT_EQ(dart.positions[Vertex(v)], smooth.positions[Vertex(v)]);
  }
}

/// Values that are sampled, not averaged: of the unit sphere.
struct Sphere {
  using Value = Position;
  Positions positions;
  Value combine(std::span<const Term> mask) const {
    const Value mean = positions.combine(mask);
    return 1 / distance(mean, Position()) * mean;
  }
  void set(Vertex v, Value value) { positions.set(v, value); }
};

TEST(Subdivision, SamplesWhatTheCallerSays) {
  Shape shape = shape_of(corpus::icosphere(0));
  Sphere sphere{shape.positions};
  Creases none;
  ASSERT_TRUE(subdivide_loop(shape.surface, sphere, none));
  ASSERT_TRUE(subdivide_sqrt3(shape.surface, sphere, none, Sqrt3Step::first));
  EXPECT_EQ(shape.surface.characteristic().f, 240);
  for (const Vertex v : shape.surface.vertices())
    EXPECT_NEAR(distance(sphere.positions[v], Position()), 1, 1e-12);
}

}  // namespace
}  // namespace clers
