// Balls that roll over points: where they come to rest there is a triangle, and nowhere else.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "topology/modeling/test/point_sets.h"

namespace clers {
namespace {

using test::grid;
using test::made;
using test::Points;
using test::sphere;
using test::torus;
using test::volume;
using Place = std::array<double, 3>;

ReconstructionOptions balls(std::vector<double> radii) {
  ReconstructionOptions options;
  options.radii = std::move(radii);
  return options;
}

/// Faces that carry no ball of the radius on either side that has no point of the surface inside.
int faces_without_a_ball(const Surface& s, const Points& p, double radius) {
  int count = 0;
  for (const Face f : s.faces()) {
    std::array<Place, 3> c;
    for (unsigned i = 0; i < 3; ++i) c[i] = p[s.org(half_edge(f, i)).index()];
    Place u, v;
    for (unsigned i = 0; i < 3; ++i) u[i] = c[1][i] - c[0][i], v[i] = c[2][i] - c[0][i];
    const auto dot = [](const Place& x, const Place& y) {
      return x[0] * y[0] + x[1] * y[1] + x[2] * y[2];
    };
    // centre = c0 + s u + t v + h n, as far from c1 and c2 as from c0
    const double uu = dot(u, u), vv = dot(v, v), uv = dot(u, v), d = uu * vv - uv * uv;
    const double a = vv * (uu - uv) / (2 * d), b = uu * (vv - uv) / (2 * d);
    Place foot{},
        n{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
    for (unsigned i = 0; i < 3; ++i) foot[i] = a * u[i] + b * v[i];
    const double height = std::sqrt((radius * radius - dot(foot, foot)) / d);
    bool carries = false;
    for (const double side : {height, -height}) {
      bool empty = true;
      for (const Vertex w : s.vertices()) {
        double square = 0;
        for (unsigned i = 0; i < 3; ++i)
          square += std::pow(c[0][i] + foot[i] + side * n[i] - p[w.index()][i], 2);
        empty &= square > radius * radius * (1 - 1e-6);
      }
      carries |= empty;  // false, too, where the circle is wider than the ball: not a number
    }
    count += !carries;
  }
  return count;
}

TEST(Pivoting, SphereAndTorus) {
  const Points p = sphere(1000);
  const Reconstruction r = made(p, balls({0.12}));
  EXPECT_EQ(r.surface.characteristic(), (Characteristic{1000, 2994, 1996, 0, 0, 1}));
  EXPECT_NEAR(volume(r.surface, p), 4.18, 0.05);
  EXPECT_EQ(faces_without_a_ball(r.surface, p, 0.12), 0);
  const Points q = torus(60, 24);
  const Reconstruction s = made(q, balls({0.5}));
  EXPECT_EQ(s.surface.characteristic(), (Characteristic{1440, 4320, 2880, 0, 1, 1}));
  EXPECT_EQ(faces_without_a_ball(s.surface, q, 0.5), 0);
}

TEST(Pivoting, FourPointsOnACircleGiveTwoTriangles) {
  // Everywhere on a grid: a ball rests on four points at once.
  const Reconstruction r = made(grid(20, 0), balls({0.8}));
  EXPECT_EQ(r.surface.characteristic(), (Characteristic{400, 1121, 722, 1, 0, 1}));
  EXPECT_EQ(made(grid(20, 0), balls({0.7})).surface.characteristic().f, 0);  // it falls through
}

TEST(Pivoting, SheetsCloseByStayApart) {
  Points p = grid(15, 0);
  const Points other = grid(15, 2);
  p.insert(p.end(), other.begin(), other.end());
  const Reconstruction r = made(p, balls({0.8}));
  EXPECT_EQ(r.surface.characteristic().s, 2);
  EXPECT_EQ(r.surface.characteristic().b, 2);
  EXPECT_EQ(r.surface.characteristic().f, 4 * 14 * 14);
}

TEST(Pivoting, EachRadiusGoesOnFromTheOneBefore) {
  const Points p = sphere(400);
  std::int64_t before = -1;
  ReconstructionOptions options;
  for (const double radius : {1e-6, 0.105, 0.115, 0.5}) {
    options.radii.insert(options.radii.begin(), radius);  // in any order
    const auto f = made(p, options).surface.characteristic().f;
    EXPECT_GT(f, before);
    before = f;
  }
  EXPECT_EQ(before, 796);
}

TEST(Pivoting, ALargerBallBridgesAHole) {
  Points p;
  for (const Place& q : grid(21, 0))
    if (std::hypot(q[0] - 10, q[1] - 10) > 2.5) p.push_back(q);
  EXPECT_EQ(made(p, balls({0.8})).surface.characteristic().b, 2);
  EXPECT_EQ(made(p, balls({0.8, 4})).surface.characteristic().b, 1);
}

TEST(Pivoting, NormalsSayWhichSideTheBallIsOn) {
  const Points p = sphere(500);
  Points inwards = p;
  for (Place& n : inwards)
    for (double& x : n) x *= -1;
  ReconstructionOptions options = balls({0.15});
  options.normals = inwards;
  Reconstruction r = made(p, options);
  EXPECT_EQ(r.surface.characteristic().f, 996);
  EXPECT_LT(volume(r.surface, p), -4);
  options.normals = p;
  r = made(p, options);
  EXPECT_EQ(r.surface.characteristic().f, 996);
  EXPECT_GT(volume(r.surface, p), 4);
  const Points unsaid(p.size(), {0, 0, 0});
  options.normals = unsaid;
  EXPECT_EQ(made(p, options).surface.characteristic().f, 996);
}

TEST(Pivoting, BothSidesOfAThinPlateTurnOutwards) {
  // A ball wider than the plate is thick would fall through nothing, and knows the sides by
  // normals.
  Points p = grid(12, 0), normals(p.size(), {0, 0, -1});
  for (const Place& q : grid(12, 0.3)) {
    p.push_back(q);
    normals.push_back({0, 0, 1});
  }
  ReconstructionOptions options = balls({0.75});
  options.normals = normals;
  const Reconstruction r = made(p, options);
  for (const Face f : r.surface.faces()) {
    std::array<Place, 3> c;
    std::uint32_t above = 0;
    for (unsigned i = 0; i < 3; ++i) {
      const std::uint32_t v = r.surface.org(half_edge(f, i)).index();
      c[i] = p[v];
      above += v >= 144;
    }
    const double up =
        (c[1][0] - c[0][0]) * (c[2][1] - c[0][1]) - (c[1][1] - c[0][1]) * (c[2][0] - c[0][0]);
    if (above == 0) {
      EXPECT_LT(up, 0);
    }
    if (above == 3) {
      EXPECT_GT(up, 0);
    }
  }
  EXPECT_GE(r.surface.characteristic().f, 4 * 11 * 11);
}

TEST(Pivoting, NoiseAndMissingPoints) {
  std::mt19937 random(13);
  std::uniform_real_distribution<double> share(-1, 1);
  for (const double noise : {0.01, 0.1}) {  // a tenth of the spacing, and all of it
    Points p;
    for (auto q : sphere(1200)) {
      if (share(random) > 0.8) continue;
      for (double& x : q) x += noise * share(random);
      p.push_back(q);
    }
    const Reconstruction r = made(p, balls({0.1, 0.2, 0.4}));
    EXPECT_GT(r.surface.characteristic().f,
              std::int64_t(noise < 0.05 ? 18 : 2) * std::int64_t(p.size()) / 10);
    std::shuffle(p.begin(), p.end(), random);
    EXPECT_EQ(made(p, balls({0.4, 0.1, 0.2})).surface.characteristic(), r.surface.characteristic());
  }
}

TEST(Pivoting, PointsInABlockGiveSomeManifold) {
  std::mt19937 random(17);
  std::uniform_real_distribution<double> share(0, 5);
  std::uniform_int_distribution<int> cell(0, 5);
  Points cloud, lattice;  // of the latter many lie on one sphere
  for (int i = 0; i < 400; ++i) {
    cloud.push_back({share(random), share(random), share(random)});
    lattice.push_back({1. * cell(random), 1. * cell(random), 1. * cell(random)});
  }
  for (const std::vector<double>& radii : {std::vector{0.8}, {0.6, 0.9, 3}, {100.}}) {
    EXPECT_GT(made(cloud, balls(radii)).surface.characteristic().f, 3);
    EXPECT_GT(made(lattice, balls(radii)).surface.characteristic().f, 3);
  }
}

}  // namespace
}  // namespace clers
