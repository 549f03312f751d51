// Theorems 2 and 5 of the CAGD paper, on every surface of a few triangles and on some larger ones.
// (Others stand beside what they are about: 7 in stellar_test, 11 in gluings_test, 13 wherever
// validate() is called after operators.)
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <utility>
#include <vector>

#include "topology/derived.h"
#include "topology/equivalence.h"
#include "topology/handlebody.h"
#include "topology/test/matchings.h"
#include "topology/test/meshes.h"
#include "topology/test/oracle.h"

namespace clers {
namespace {

using test::Matching;
using test::Oracle;

Surface triangles(std::uint32_t count, Oracle& oracle) {
  Surface s;
  for (std::uint32_t f = 0; f < count; ++f) {
    EXPECT_TRUE(s.create(Point(3 * f), Point(3 * f + 1), Point(3 * f + 2)));
    oracle.create(f);
  }
  return s;
}

/// A sphere with `genus` handles and `holes` disks removed.
Surface standard(std::uint32_t genus, std::uint32_t holes) {
  Surface s =
      genus == 0 ? test::from_triangles({{0, 1, 2}, {1, 0, 2}}) : test::chain_of_tori(genus, 4);
  for (std::uint32_t i = 0; i < holes; ++i) {
    // Triangles inside triangles, so that holes do not touch.
    const Face f = *s.faces().begin();
    for (int depth = 0; depth < 2; ++depth) EXPECT_TRUE(s.split(f, Point()));
    const Vertex centre = *s.split(f, Point());
    const HalfEdge spoke = s.star_half_edge(centre);
    const HalfEdge ring = lnext(spoke);
    EXPECT_EQ(*s.unglue(ring), HandleCase::close);
  }
  EXPECT_EQ(s.genus(), genus);
  EXPECT_EQ(s.characteristic().b, holes);
  return s;
}

/// Adds the other's components.
Surface united(const Surface& a, const Surface& b) {
  std::vector<Vertex> org(a.origins().begin(), a.origins().end());
  std::vector<HalfEdge> twin(a.twins().begin(), a.twins().end());
  for (const Vertex v : b.origins()) org.push_back(v ? Vertex(v.index() + a.vertex_limit()) : v);
  for (const HalfEdge h : b.twins())
    twin.push_back(h ? HalfEdge(h.index() + a.half_edge_limit()) : h);
  return *Surface::from_twins(org, twin, a.vertex_limit() + b.vertex_limit());
}

TEST(Theorem2, OnEveryGluingOfUpToThreeTriangles) {
  // The oracle's classes, each with the first surface of it.
  std::map<std::vector<std::pair<std::int64_t, std::int64_t>>, Surface> classes;
  for (std::uint32_t faces = 1; faces <= 3; ++faces)
    test::for_each_matching(faces, [&](const Matching& matching) {
      if (testing::Test::HasFailure()) return;
      Oracle oracle;
      Surface s = triangles(faces, oracle);
      for (const auto& [a, b] : matching) {
        ASSERT_TRUE(s.glue(HalfEdge(a), HalfEdge(b)));
        oracle.glue(a, b);
      }
      std::vector<std::pair<std::int64_t, std::int64_t>> of;
      for (const Characteristic& c : oracle.recount().components)
        of.emplace_back((2 - c.b - c.euler()) / 2, c.b);
      std::sort(of.begin(), of.end());
      classes.emplace(of, s);
      for (const auto& [others, other] : classes) ASSERT_EQ(homeomorphic(s, other), of == others);
    });
  // Disk, annulus, sphere, torus with and without a hole; a disk beside a disk, two, or one of the
  // annulus, the sphere and the torus.
  EXPECT_EQ(classes.size(), 10u);
}

TEST(Theorem2, TellsApartWhatTheCountsOfTheWholeDoNot) {
  const Surface sphere = standard(0, 0), torus = test::torus(4, 5), two = standard(2, 0);
  EXPECT_EQ(united(torus, torus).characteristic().g, united(sphere, two).characteristic().g);
  EXPECT_FALSE(homeomorphic(united(torus, torus), united(sphere, two)));
  EXPECT_TRUE(homeomorphic(united(two, sphere), united(sphere, two)));
  EXPECT_TRUE(homeomorphic(torus, test::torus(3, 9)));
  EXPECT_FALSE(equivalent(torus, test::torus(3, 9)));
  EXPECT_TRUE(homeomorphic(Surface(), Surface()));
  EXPECT_FALSE(homeomorphic(Surface(), sphere));
  // One Euler characteristic, four surfaces.
  EXPECT_EQ(standard(1, 1).characteristic().euler(), standard(0, 3).characteristic().euler());
  EXPECT_FALSE(homeomorphic(standard(1, 1), standard(0, 3)));
}

TEST(Theorem2, NoTwoStandardSurfacesAreHomeomorphic) {
  std::vector<Surface> all;
  for (std::uint32_t genus = 0; genus < 4; ++genus)
    for (std::uint32_t holes = 0; holes < 4; ++holes) all.push_back(standard(genus, holes));
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t j = 0; j < all.size(); ++j) EXPECT_EQ(homeomorphic(all[i], all[j]), i == j);
}

TEST(Theorem2, StellarOperatorsKeepTheClassAndHandlesChangeIt) {
  std::mt19937 random(5);
  for (const Surface& start : {test::grid(5, 4), test::torus(4, 4), standard(2, 3)}) {
    Surface s = start;
    for (int i = 0; i < 300; ++i) {
      const HalfEdge h(static_cast<std::uint32_t>(random() % s.half_edge_limit()));
      switch (random() % 4) {
        case 0: (void)s.flip(h); break;
        case 1: (void)s.split(h, Point()); break;
        case 2: (void)s.split(left(h), Point()); break;
        default: (void)s.weld(h); break;
      }
      ASSERT_TRUE(homeomorphic(s, start));
      if (!s.is_live(h) || s.is_boundary(h)) continue;
      Surface cut = s;
      const HandleCase undone = *cut.unglue(h);
      ASSERT_EQ(homeomorphic(cut, start), undone == HandleCase::zip);
    }
  }
}

/// The handles that a glue attaches (§4.1), by index. A zip is none: half of one each.
struct Handles {
  std::int64_t of[3] = {};
  void add(HandleCase kind) {
    switch (kind) {
      case HandleCase::join_components:
      case HandleCase::split_curve:
      case HandleCase::join_curves: ++of[1]; break;
      case HandleCase::close: ++of[2]; break;
      case HandleCase::zip: break;
      case HandleCase::join_components_at_loops:
      case HandleCase::join_curves_at_loops: ++of[1], ++of[2]; break;
    }
  }
};

/// chi(S + H) = chi(S) + (-1)^lambda, counted on the surface, not by effect().
TEST(Theorem5, OnEveryGluingOfUpToThreeTriangles) {
  for (std::uint32_t faces = 1; faces <= 3; ++faces)
    test::for_each_matching(faces, [&](const Matching& matching) {
      if (testing::Test::HasFailure()) return;
      Oracle oracle;
      Surface s = triangles(faces, oracle);
      Handles all;
      all.of[0] = faces;
      std::int64_t chi = oracle.recount().total.euler();
      ASSERT_EQ(chi, faces);  // a 0-handle each
      for (const auto& [a, b] : matching) {
        Handles one;
        const HandleCase kind = *s.glue(HalfEdge(a), HalfEdge(b));
        one.add(kind), all.add(kind);
        oracle.glue(a, b);
        const std::int64_t now = oracle.recount().total.euler();
        ASSERT_EQ(now, chi - one.of[1] + one.of[2]) << name(kind);
        chi = now;
      }
      ASSERT_EQ(chi, all.of[0] - all.of[1] + all.of[2]);
    });
}

/// And as its consequence says of a whole decomposition; Fig. 2's torus among them.
TEST(Theorem5, OfHandlebodies) {
  for (const Surface& whole :
       {test::torus(3, 3), test::torus(7, 5), test::chain_of_tori(3, 4), test::grid(4, 3),
        standard(2, 3), united(standard(0, 2), standard(1, 0))}) {
    Surface s = whole;
    const Handlebody body = unbuild(s);
    Handles all;
    all.of[0] = static_cast<std::int64_t>(body.triangles.size());
    for (const Handlebody::Gluing& g : body.gluings) all.add(g.kind);
    std::int64_t vertices = 0, edges = 0, faces = 0;
    for ([[maybe_unused]] const Vertex v : whole.vertices()) ++vertices;
    for ([[maybe_unused]] const HalfEdge h : whole.edges()) ++edges;
    for ([[maybe_unused]] const Face f : whole.faces()) ++faces;
    EXPECT_EQ(vertices - edges + faces, all.of[0] - all.of[1] + all.of[2]);
  }
}

}  // namespace
}  // namespace clers
