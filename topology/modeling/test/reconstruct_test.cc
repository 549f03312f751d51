// Surfaces through points: always manifolds, and where the points say enough the right ones.
#include "topology/modeling/reconstruct.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include "topology/modeling/advancing_front.h"
#include "topology/modeling/test/point_sets.h"
#include "topology/validate.h"

namespace clers {
namespace {

using test::grid;
using test::made;
using test::pi;
using test::Points;
using test::sphere;
using test::torus;
using test::volume;

/// Triangles by the places of their corners, each from its least corner.
std::set<Points> triangles(const Surface& s, const Points& p) {
  std::set<Points> all;
  for (const Face f : s.faces()) {
    Points t;
    for (const HalfEdge h : s.star(f)) t.push_back(p[s.org(h).index()]);
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    all.insert(t);
  }
  return all;
}

TEST(Reconstruct, Sphere) {
  const Points p = sphere(1000);
  const Reconstruction r = made(p);
  EXPECT_EQ(r.surface.characteristic(), (Characteristic{1000, 2994, 1996, 0, 0, 1}));
  EXPECT_NEAR(volume(r.surface, p), 4 * pi / 3, 0.05);
}

TEST(Reconstruct, TorusHasAHandle) {
  const Reconstruction r = made(torus(60, 24));
  EXPECT_EQ(r.surface.characteristic(), (Characteristic{1440, 4320, 2880, 0, 1, 1}));
}

TEST(Reconstruct, GridStaysOpen) {
  const Reconstruction r = made(grid(20, 0));
  EXPECT_EQ(r.surface.characteristic().f, 2 * 19 * 19);
  EXPECT_EQ(r.surface.characteristic().b, 1);
  EXPECT_EQ(r.unused, 0u);
}

TEST(Reconstruct, NormalsOrient) {
  const Points p = sphere(300);
  Points inwards = p;
  for (auto& n : inwards)
    for (double& x : n) x *= -2;
  ReconstructionOptions options;
  options.normals = inwards;
  const Reconstruction r = made(p, options);
  EXPECT_EQ(r.surface.characteristic().f, 596);
  EXPECT_LT(volume(r.surface, p), -4);
}

TEST(Reconstruct, ResultDoesNotDependOnTheOrder) {
  std::mt19937 random(5);
  Points p = torus(40, 16);
  const auto before = triangles(made(p).surface, p);
  for (int i = 0; i < 5; ++i) {
    std::shuffle(p.begin(), p.end(), random);
    EXPECT_EQ(triangles(made(p).surface, p), before);
  }
}

TEST(Reconstruct, NoiseMissingPointsAndDuplicates) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> share(-1, 1);
  for (int i = 0; i < 8; ++i) {
    Points p;
    const double noise = i < 4 ? 0.01 : 0.1;  // a tenth of the spacing, and all of it
    for (auto q : sphere(1200)) {
      if (share(random) > 0.8) continue;
      for (double& x : q) x += noise * share(random);
      p.push_back(q);
    }
    const std::size_t distinct = p.size();
    for (std::size_t k = 0; k < distinct; k += 10) p.push_back(p[k]);
    const Reconstruction r = made(p);
    EXPECT_EQ(r.duplicates, p.size() - distinct);
    if (i < 4) {
      EXPECT_GT(r.surface.characteristic().f, std::int64_t(19 * distinct / 10));
    }
  }
}

TEST(Reconstruct, PointsInABlockGiveSomeManifold) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> share(0, 1);
  std::uniform_int_distribution<int> cell(0, 5);
  Points cloud, lattice;
  for (int i = 0; i < 600; ++i) {
    cloud.push_back({share(random), share(random), share(random)});
    lattice.push_back({1. * cell(random), 1. * cell(random), 1. * cell(random)});
  }
  EXPECT_GT(made(cloud).surface.characteristic().f, 100);
  EXPECT_GT(made(lattice).surface.characteristic().f, 20);
}

TEST(Reconstruct, NothingToSpan) {
  EXPECT_EQ(made({}).surface.characteristic().f, 0);
  EXPECT_EQ(made({{1, 2, 3}}).unused, 1u);
  EXPECT_EQ(made({{1, 2, 3}, {2, 2, 3}}).unused, 2u);
  EXPECT_EQ(made(Points(50, {4, 5, 6})).duplicates, 49u);
  Points line;
  for (int i = 0; i < 100; ++i) line.push_back({0.1 * i, 0.2 * i, -0.3 * i});
  EXPECT_EQ(made(line).unused, 100u);
  EXPECT_EQ(made({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}).surface.characteristic().f, 1);
  EXPECT_EQ(made({{-9e99, 0, 0}, {9e99, 0, 0}, {0, 1e-300, 0}}).surface.characteristic().f, 0);
}

TEST(Reconstruct, Refuses) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto error = [](const Points& p, std::vector<double> radii, const Points& normals) {
    ReconstructionOptions options;
    options.radii = std::move(radii);
    options.normals = normals;
    const auto r = reconstruct(p, options);
    EXPECT_FALSE(r);
    return r ? ReconstructionError::too_many_points : r.error();
  };
  const Points p = sphere(10);
  EXPECT_EQ(error({{0, nan, 0}}, {}, {}), ReconstructionError::bad_point);
  EXPECT_EQ(error({{0, 1e100, 0}}, {}, {}), ReconstructionError::bad_point);
  for (const double r : {0., -1., nan, 1e100})
    EXPECT_EQ(error(p, {1, r}, {}), ReconstructionError::bad_radius);
  EXPECT_EQ(error(p, {}, {{0, 0, 1}}), ReconstructionError::bad_normals);
  EXPECT_EQ(error(p, {}, Points(10, {nan, 0, 0})), ReconstructionError::bad_normals);
}

TEST(Reconstruct, ProgressStops) {
  const Points p = sphere(6000);
  ReconstructionOptions options;
  std::vector<double> shares;
  options.progress = [&](double share) {
    shares.push_back(share);
    return shares.size() < 2;
  };
  const Reconstruction r = made(p, options);
  EXPECT_TRUE(r.stopped);
  EXPECT_EQ(shares.size(), 2u);
  EXPECT_LT(shares[0], shares[1]);
  EXPECT_GE(r.surface.characteristic().f + std::int64_t(r.removed), 2 * 4096);
}

TEST(AdvancingFront, StaysValidWhateverIsAttached) {
  std::mt19937 random(3);
  for (std::uint32_t n : {4u, 7u, 12u, 40u}) {
    AdvancingFront front(n);
    std::uniform_int_distribution<std::uint32_t> point(0, n - 1);
    int refused = 0;
    for (int step = 0; step < 600; ++step) {
      const Surface& s = front.surface();
      const Point c(point(random));
      if (s.characteristic().f == 0 || step % 40 == 0)
        (void)front.new_front(c, Point(point(random)), Point(point(random)));
      if (s.characteristic().f == 0) continue;
      const HalfEdge h(
          std::uniform_int_distribution<std::uint32_t>(0, s.half_edge_limit() - 1)(random));
      const bool fits = front.is_candidate(h) && front.fit(h, c);
      const bool attached = front.attach(h, c).has_value();
      ASSERT_EQ(attached, fits);
      refused += !attached;
      ASSERT_TRUE(validate(s).empty());
      std::set<std::pair<std::uint32_t, std::uint32_t>> sides;
      for (const Face f : s.faces())
        for (const HalfEdge g : s.star(f)) {
          ASSERT_TRUE(sides.emplace(front.origin(g).index(), front.destination(g).index()).second);
          // Two triangles over one edge are glued there.
          if (sides.contains({front.destination(g).index(), front.origin(g).index()})) {
            ASSERT_FALSE(s.is_boundary(g));
          }
        }
    }
    EXPECT_GT(refused, 0);
    const auto before = front.surface().characteristic().f;
    const std::size_t removed = front.part_fans();
    EXPECT_EQ(front.surface().characteristic().f + std::int64_t(removed), before);
    ASSERT_TRUE(validate(front.surface()).empty());
    std::set<Point> met;
    for (const Vertex v : front.surface().vertices())
      EXPECT_TRUE(met.insert(front.surface().point(v)).second);
    for (std::uint32_t p = 0; p < n; ++p)
      EXPECT_EQ(front.is_used(Point(p)), met.contains(Point(p)));
  }
}

}  // namespace
}  // namespace clers
