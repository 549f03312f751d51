#include "topology/equivalence.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

#include "topology/derived.h"
#include "topology/handlebody.h"
#include "topology/test/meshes.h"
#include "topology/validate.h"

namespace clers {
namespace {

/// The same surface with faces, corners and vertices in another order.
Surface shuffled(const Surface& s, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::vector<std::uint32_t> face(s.face_limit()), vertex(s.vertex_limit()), turn(s.face_limit());
  std::iota(face.begin(), face.end(), 0u);
  std::iota(vertex.begin(), vertex.end(), 0u);
  std::shuffle(face.begin(), face.end(), random);
  std::shuffle(vertex.begin(), vertex.end(), random);
  for (auto& t : turn) t = static_cast<std::uint32_t>(random() % 3);
  const auto image = [&](HalfEdge h) {
    const std::uint32_t f = left(h).index();
    return HalfEdge(3 * face[f] + (corner(h) + turn[f]) % 3);
  };
  std::vector<Vertex> org(s.half_edge_limit());
  std::vector<HalfEdge> twin(s.half_edge_limit());
  for (const Face f : s.faces())
    for (const HalfEdge h : s.star(f)) {
      org[image(h).index()] = Vertex(vertex[s.org(h).index()]);
      if (s.sym(h)) twin[image(h).index()] = image(s.sym(h));
    }
  return *Surface::from_twins(org, twin, s.vertex_limit());
}

void expect_correspondence(const Surface& a, const Surface& b, const Correspondence& map) {
  std::vector<bool> hit(b.half_edge_limit());
  for (const Face f : a.faces())
    for (const HalfEdge h : a.star(f)) {
      const HalfEdge image = map.half_edges[h.index()];
      ASSERT_TRUE(b.is_live(image));
      EXPECT_FALSE(hit[image.index()]);
      hit[image.index()] = true;
      EXPECT_EQ(map.half_edges[lnext(h).index()], lnext(image));
      EXPECT_EQ(map.vertices[a.org(h).index()], b.org(image));
      EXPECT_EQ(a.is_boundary(h), b.is_boundary(image));
      if (!a.is_boundary(h)) {
        EXPECT_EQ(map.half_edges[a.sym(h).index()], b.sym(image));
      }
    }
}

TEST(Equivalence, OfShuffledSurfaces) {
  std::vector<Surface> samples{test::grid(5, 3), test::torus(5, 4), test::chain_of_tori(3, 4),
                               Surface()};
  samples.push_back(test::grid(6, 6));
  ASSERT_TRUE(detach(samples.back(), Face(30)));
  ASSERT_TRUE(detach(samples.back(), Face(3)));
  for (int i = 0; i < 7; ++i) {
    const auto f = samples.back().create(Point(0), Point(1), Point(2));
    if (i % 2) {
      ASSERT_TRUE(attach(samples.back(), half_edge(*f, 1), Point(3)));
    }
  }
  for (const Surface& s : samples)
    for (std::uint32_t seed = 0; seed < 5; ++seed) {
      const Surface other = shuffled(s, seed);
      const auto map = equivalent(s, other);
      ASSERT_TRUE(map);
      expect_correspondence(s, other, *map);
    }
}

TEST(Equivalence, TellsApartWhatCountsDoNot) {
  EXPECT_FALSE(equivalent(test::torus(3, 8), test::torus(4, 6)));
  EXPECT_FALSE(equivalent(test::grid(2, 6), test::grid(3, 4)));
  // A disk and its mirror image: a fan of three with an ear on the first edge, or on the last.
  const Surface left_ear = test::from_triangles({{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {1, 5, 2}});
  const Surface right_ear = test::from_triangles({{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {3, 5, 4}});
  EXPECT_EQ(left_ear.characteristic(), right_ear.characteristic());
  EXPECT_FALSE(equivalent(left_ear, right_ear));
  // One component in two, however the faces are shared out.
  Surface a = test::grid(1, 1), b = test::grid(1, 1);
  ASSERT_TRUE(attach(a, *a.boundary(*a.curves().begin()).begin(), Point(9)));
  ASSERT_TRUE(b.create(Point(0), Point(1), Point(2)));
  EXPECT_FALSE(equivalent(a, b));
}

TEST(Handlebody, OfAChainOfTori) {
  Surface s = test::chain_of_tori(4, 6);
  const Surface whole = s;
  const Characteristic counted = s.characteristic();
  EXPECT_EQ(counted.g, 4);
  EXPECT_EQ(counted.s, 1);
  const Handlebody h = unbuild(s);
  EXPECT_EQ(s.characteristic(), Characteristic{});
  EXPECT_EQ(h.triangles.size(), static_cast<std::size_t>(counted.f));
  EXPECT_EQ(lambda(h.counts()), counted);
  EXPECT_EQ(h.counts().join_curves, 4);
  const auto again = build(h);
  ASSERT_TRUE(again);
  EXPECT_TRUE(equivalent(*again, whole));
  EXPECT_TRUE(validate(*again).empty());
  for (const Face f : again->faces())
    for (const HalfEdge e : again->star(f)) EXPECT_TRUE(again->point(again->org(e)));
}

TEST(Handlebody, RefusesWhatIsNone) {
  Handlebody h;
  h.triangles.push_back({Face(0), {Point(0), Point(1), Point(2)}});
  h.gluings.push_back({HandleCase::zip, HalfEdge(0), HalfEdge(7)});
  EXPECT_EQ(build(h).error(), (Violation{Precondition::live_half_edge, 7}));
  h.gluings[0].h1 = HalfEdge(0);
  EXPECT_EQ(build(h).error().precondition, Precondition::two_half_edges);
}

}  // namespace
}  // namespace clers
