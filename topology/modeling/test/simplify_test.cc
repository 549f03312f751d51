// Fewer faces: the same topology, near the same surface, creases and boundaries where they were.
#include "topology/modeling/simplify.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>

#include "topology/dump.h"
#include "topology/modeling/placement.h"
#include "topology/modeling/test/solids.h"
#include "topology/test/meshes.h"
#include "topology/validate.h"

namespace clers::test {
namespace {

double off_torus(const Position3& p) {
  return std::fabs(std::hypot(std::hypot(p[0], p[1]) - 2, p[2]) - 1);
}
double off_torus(const Solid& s) {
  double most = 0;
  for (const Face f : s.surface.faces()) {
    Position3 middle{};
    for (const HalfEdge h : s.surface.star(f)) {
      const Position3& p = s.at[s.surface.org(h).index()];
      most = std::max(most, off_torus(p));
      for (std::size_t i = 0; i < 3; ++i) middle[i] += p[i] / 3;
    }
    most = std::max(most, off_torus(middle));
  }
  return most;
}

void expect_topology(const Surface& surface, const Characteristic& before) {
  EXPECT_TRUE(validate(surface).empty());
  EXPECT_EQ(surface.characteristic().g, before.g);
  EXPECT_EQ(surface.characteristic().b, before.b);
  EXPECT_EQ(surface.characteristic().s, before.s);
}

TEST(Simplify, KeepsTopologyAtAnySize) {
  for (const Solid& whole : solids_of_each_kind()) {
    const Characteristic before = whole.surface.characteristic();
    for (const std::int64_t percent : {50, 10, 1, 0}) {
      Solid s = whole;
      const auto done = simplify(s.surface, s.at, {.faces = before.f * percent / 100});
      ASSERT_TRUE(done);
      expect_topology(s.surface, before);
      EXPECT_EQ(done->contracted,
                static_cast<std::uint64_t>(before.v - s.surface.characteristic().v));
      if (done->ended == SimplifyEnd::faces) {
        EXPECT_LE(s.surface.characteristic().f, before.f * percent / 100);
      } else {
        EXPECT_EQ(done->ended, SimplifyEnd::smallest);
      }
      for (const Vertex v : s.surface.vertices())
        for (const double x : s.at[v.index()]) EXPECT_TRUE(std::isfinite(x));
    }
  }
}

TEST(Simplify, GoesDownToATetrahedron) {
  // A sphere, which can be as small as no other closed surface.
  Solid s{
      from_triangles(
          {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}),
      {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}};
  const auto done = simplify(s.surface, s.at, {});
  ASSERT_TRUE(done);
  EXPECT_EQ(done->ended, SimplifyEnd::smallest);
  EXPECT_EQ(s.surface.characteristic().f, 4);
}

TEST(Simplify, StaysNearTheSurface) {
  const Solid whole = round_torus(60, 40);
  const double chord = off_torus(whole);
  for (const double error : {0.02, 0.1, 0.3}) {
    Solid s = whole;
    const auto done = simplify(s.surface, s.at, {.error = error});
    ASSERT_TRUE(done);
    EXPECT_EQ(done->ended, SimplifyEnd::error);
    EXPECT_LE(done->error, error);
    EXPECT_GT(done->error, 0.5 * error);
    EXPECT_LE(off_torus(s), chord + error);
    EXPECT_LT(s.surface.characteristic().f, whole.surface.characteristic().f);
  }
}

TEST(Simplify, KeepsTheVolume) {
  const auto volume = [](const Solid& s) {
    double six = 0;
    for (const Face f : s.surface.faces()) {
      std::array<Position3, 3> p;
      for (unsigned i = 0; i < 3; ++i) p[i] = s.at[s.surface.org(half_edge(f, i)).index()];
      six += p[0][0] * (p[1][1] * p[2][2] - p[1][2] * p[2][1]) -
             p[0][1] * (p[1][0] * p[2][2] - p[1][2] * p[2][0]) +
             p[0][2] * (p[1][0] * p[2][1] - p[1][1] * p[2][0]);
    }
    return six / 6;
  };
  Solid s = round_torus(60, 40);
  const double before = volume(s);
  ASSERT_TRUE(simplify(s.surface, s.at, {.faces = 480}));
  EXPECT_NEAR(volume(s), before, 1e-6 * std::fabs(before));
}

TEST(Simplify, AFlatSquareKeepsItsCorners) {
  Solid s = field(12, [](double, double) { return 3.; });
  Creases corners;
  // Edges that end in the corners make these stay.
  for (const HalfEdge h : edges_of(s.surface)) {
    const Vertex a = s.surface.org(h), b = s.surface.dest(h);
    for (const std::uint32_t corner : {0u, 12u, 12u * 13, 13u * 13 - 1})
      if (!s.surface.is_boundary(h) && (a.index() == corner || b.index() == corner))
        corners.mark(s.surface, h);
  }
  const auto done = simplify(s.surface, s.at, corners, {.error = 1e-9});
  ASSERT_TRUE(done);
  EXPECT_LE(done->error, 1e-9);
  EXPECT_LE(s.surface.characteristic().f, 40);
  double area = 0;
  for (const Face f : s.surface.faces()) {
    const Position3 &a = s.at[s.surface.org(half_edge(f, 0)).index()],
                    &b = s.at[s.surface.org(half_edge(f, 1)).index()],
                    &c = s.at[s.surface.org(half_edge(f, 2)).index()];
    const double twice = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    EXPECT_GT(twice, 0);
    area += twice / 2;
  }
  EXPECT_NEAR(area, 144, 1e-8);
}

TEST(Simplify, CreasesStayCurves) {
  // A roof whose ridge is a crease.
  Solid s = field(16, [](double x, double) { return 8 - std::fabs(x - 8); });
  Creases ridge;
  for (const HalfEdge h : edges_of(s.surface))
    if (s.at[s.surface.org(h).index()][0] == 8 && s.at[s.surface.dest(h).index()][0] == 8)
      ridge.mark(s.surface, h);
  const Characteristic before = s.surface.characteristic();
  ASSERT_TRUE(simplify(s.surface, s.at, ridge, {.faces = 60}));
  expect_topology(s.surface, before);
  std::size_t sharp = 0, ends = 0;
  double length = 0;
  for (const HalfEdge h : s.surface.edges()) {
    if (s.surface.is_boundary(h) || !ridge.is_sharp(s.surface, h)) continue;
    ++sharp;
    const Position3 &a = s.at[s.surface.org(h).index()], &b = s.at[s.surface.dest(h).index()];
    for (const Position3& p : {a, b}) {
      EXPECT_NEAR(p[0], 8, 1e-2);
      EXPECT_NEAR(p[2], 8, 1e-2);
      if (p[1] == 0 || p[1] == 16) ++ends;
    }
    length += std::fabs(a[1] - b[1]);
  }
  EXPECT_LT(sharp, 16u);
  EXPECT_EQ(ends, 2u);
  EXPECT_NEAR(length, 16, 1e-9);
}

TEST(Simplify, TellsWhatBecomesOfValues) {
  // x is linear along edges, so a value that is x stays so but for what leaves the edge.
  Solid s = field(16, [](double, double) { return 0.; });
  std::vector<double> value;
  for (const Position3& p : s.at) value.push_back(p[1]);
  Creases none;
  std::size_t welds = 0, told = 0;
  ASSERT_TRUE(simplify(
      s.surface, s.at, none, {.faces = 100},
      [&](const Contraction& c) {
        ++told;
        EXPECT_TRUE(s.surface.is_live(c.gone));
        EXPECT_GE(c.weight, 0);
        EXPECT_LE(c.weight, 1);
        double& kept = value[c.kept.index()];
        kept += c.weight * (value[c.gone.index()] - kept);
      },
      [&](const Change& change) {
        if (change.gone()) ++welds;
      }));
  EXPECT_EQ(told, welds);
  double off = 0;
  for (const Vertex v : s.surface.vertices())
    off = std::max(off, std::fabs(value[v.index()] - s.at[v.index()][1]));
  EXPECT_LT(off, 2);
}

TEST(Simplify, IsTheSameEachTimeAndAnywhere) {
  Solid a = round_torus(30, 20), b = a;
  ASSERT_TRUE(simplify(a.surface, a.at, {.faces = 200}));
  ASSERT_TRUE(simplify(b.surface, b.at, {.faces = 200}));
  EXPECT_EQ(dump(a.surface), dump(b.surface));
  EXPECT_EQ(a.at, b.at);

  // As large as a galaxy, and as small as an atom.
  for (const double size : {0x1p90, 0x1p-90}) {
    Solid c = round_torus(30, 20);
    for (Position3& p : c.at)
      for (double& x : p) x *= size;
    ASSERT_TRUE(simplify(c.surface, c.at, {.faces = 200}));
    EXPECT_EQ(dump(a.surface), dump(c.surface));
  }
}

TEST(Simplify, TheOrderOfVerticesHardlyMatters) {
  const Solid whole = round_torus(40, 30);
  std::mt19937 random(7);
  double least = 1e9, most = 0;
  for (int i = 0; i < 5; ++i) {
    std::vector<std::uint32_t> id(whole.at.size());
    std::iota(id.begin(), id.end(), 0u);
    std::shuffle(id.begin(), id.end(), random);
    Triangles faces;
    for (const Face f : whole.surface.faces()) {
      auto& face = faces.emplace_back();
      for (unsigned k = 0; k < 3; ++k) face[k] = id[whole.surface.org(half_edge(f, k)).index()];
    }
    std::shuffle(faces.begin(), faces.end(), random);
    Solid s{from_triangles(faces), std::vector<Position3>(id.size())};
    for (std::size_t v = 0; v < id.size(); ++v) s.at[id[v]] = whole.at[v];
    ASSERT_TRUE(simplify(s.surface, s.at, {.faces = 400}));
    least = std::min(least, off_torus(s)), most = std::max(most, off_torus(s));
  }
  EXPECT_LT(most, 2 * least);
}

TEST(Simplify, FacesWithoutAreaGo) {
  Solid s = field(8, [](double, double) { return 0.; });
  for (Position3& p : s.at) p = {1, 2, 3};
  const Characteristic before = s.surface.characteristic();
  const auto done = simplify(s.surface, s.at, {.faces = 10});
  ASSERT_TRUE(done);
  EXPECT_EQ(done->ended, SimplifyEnd::faces);
  EXPECT_EQ(done->error, 0);
  expect_topology(s.surface, before);
}

TEST(Simplify, RefusesWhatItCannotUse) {
  Solid s = round_torus(5, 4);
  const std::string before = dump(s.surface);
  const auto rule = [&](const SimplifyOptions& options) {
    const auto done = simplify(s.surface, s.at, options);
    return done ? std::optional<SimplifyRule>() : done.error().rule;
  };
  EXPECT_EQ(rule({.faces = -1}), SimplifyRule::option);
  EXPECT_EQ(rule({.error = -1}), SimplifyRule::option);
  EXPECT_EQ(rule({.error = std::nan("")}), SimplifyRule::option);
  EXPECT_EQ(rule({.shape = -1}), SimplifyRule::option);
  s.at[7][1] = std::nan("");
  EXPECT_EQ(rule({}), SimplifyRule::position_in_range);
  const auto done = simplify(s.surface, s.at, {});
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().vertex, 7u);
  s.at.pop_back();
  EXPECT_EQ(rule({}), SimplifyRule::position_count);
  EXPECT_EQ(dump(s.surface), before);
}

TEST(Simplify, NothingIsSimple) {
  Surface none;
  std::vector<Position3> at;
  const auto done = simplify(none, at, {.faces = 0});
  ASSERT_TRUE(done);
  EXPECT_EQ(done->contracted, 0u);
}

/// From a place to the nearest of all faces: by the normal equations of each, else along its edges.
double distance(const Position3& place, const Solid& s) {
  using internal::Vector3;
  double nearest = std::numeric_limits<double>::infinity();
  for (const Face f : s.surface.faces()) {
    Vector3 x[3];
    for (unsigned i = 0; i < 3; ++i)
      x[i] = Vector3(s.at[s.surface.org(half_edge(f, i)).index()]) - Vector3(place);
    const Vector3 u = x[1] - x[0], v = x[2] - x[0];
    const double uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), det = uu * vv - uv * uv;
    const double a = (uv * dot(x[0], v) - vv * dot(x[0], u)) / det;
    const double b = (uv * dot(x[0], u) - uu * dot(x[0], v)) / det;
    if (a >= 0 && b >= 0 && a + b <= 1) nearest = std::min(nearest, squared(x[0] + a * u + b * v));
    for (unsigned i = 0; i < 3; ++i) {
      const Vector3 along = x[(i + 1) % 3] - x[i];
      const double t = std::clamp(-dot(x[i], along) / squared(along), 0., 1.);
      nearest = std::min(nearest, squared(x[i] + t * along));
    }
  }
  return std::sqrt(nearest);
}

TEST(Simplify, NoVertexWasFartherThanTheError) {
  std::mt19937 random(3);
  std::vector<Solid> solids;
  solids.push_back(field(8, [](double x, double y) { return x == 4 && y == 4 ? 10. : 0.; }));
  solids.push_back(field(14, [&](double, double) { return static_cast<double>(random() % 3); }));
  Solid strip{grid(150, 1), {}};  // whose ends no plane holds
  for (std::uint32_t i = 0; i < 302; ++i)
    strip.at.push_back({double(i % 151), double(i / 151), std::sin(0.2 * (i % 151))});
  solids.push_back(std::move(strip));
  for (const Solid& whole : solids)
    for (const double error : {0.1, 1., 4.}) {
      Solid s = whole;
      const auto done = simplify(s.surface, s.at, {.error = error});
      ASSERT_TRUE(done);
      EXPECT_LE(done->error, error);
      for (const Vertex v : whole.surface.vertices())
        EXPECT_LE(distance(whole.at[v.index()], s), done->error * (1 + 1e-9) + 1e-12) << error;
    }
}

TEST(Simplify, NoVertexOfAPlaneTakesAllOfIt) {
  Solid s = field(60, [](double, double) { return 0.; });
  Creases creases;
  Simplification simplification(s.surface, s.at, creases, {.error = 1e-7});
  std::size_t most = 0;
  while (const auto c = simplification.next()) {
    contract(s.surface, creases, *c);
    simplification.contracted(*c);
    most = std::max<std::size_t>(most, s.surface.corner_count(c->kept));
  }
  EXPECT_LT(s.surface.characteristic().f, 40);
  EXPECT_LT(most, 40u);
}

}  // namespace
}  // namespace clers::test
