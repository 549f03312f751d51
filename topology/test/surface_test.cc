// The surface on examples small enough to draw.
#include "topology/surface.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "topology/derived.h"
#include "topology/dump.h"
#include "topology/equivalence.h"
#include "topology/test/meshes.h"
#include "topology/validate.h"

namespace clers {
namespace {

using test::from_triangles;
using test::grid;
using test::torus;

template <class Range>
std::vector<HalfEdge> list(const Range& range) {
  std::vector<HalfEdge> out;
  for (const HalfEdge h : range) out.push_back(h);
  EXPECT_EQ(out.size(), range.size());
  return out;
}

HalfEdge he(std::uint32_t i) {
  return HalfEdge(i);
}

TEST(Surface, OneTriangle) {
  Surface s;
  const Face f = *s.create(Point(7), Point(8), Point(7));
  EXPECT_EQ(s.characteristic(), (Characteristic{3, 3, 1, 1, 0, 1}));
  EXPECT_EQ(s.point(s.org(half_edge(f, 2))), Point(7));
  EXPECT_NE(s.org(half_edge(f, 2)), s.org(half_edge(f, 0)));
  EXPECT_EQ(s.dest(he(2)), s.org(he(0)));
  EXPECT_EQ(list(s.boundary(he(1))), (std::vector{he(1), he(2), he(0)}));
  EXPECT_EQ(s.boundary_prev(he(0)), he(2));
  EXPECT_EQ(s.degree(s.org(he(0))), 2u);
  EXPECT_EQ(list(s.fan(s.org(he(0)))), std::vector{he(0)});
  EXPECT_EQ(list(s.star(s.org(he(0)))), (std::vector{he(0), he(2)}));
  EXPECT_EQ(list(s.link(s.org(he(0)))), std::vector{he(1)});
  EXPECT_EQ(list(s.star(f)), (std::vector{he(0), he(1), he(2)}));
  EXPECT_TRUE(s.link(f).empty());
  EXPECT_EQ(list(s.star(he(1))), std::vector{he(1)});
  EXPECT_EQ(list(s.link(he(1))), std::vector{he(0)});
  EXPECT_TRUE(s.is_boundary(f));
}

TEST(Surface, IdsAreReusedLastFreedFirst) {
  Surface s;
  for (std::uint32_t i = 0; i < 3; ++i) ASSERT_TRUE(s.create(Point(0), Point(1), Point(2)));
  const Vertex v = s.org(half_edge(Face(1), 1));
  ASSERT_TRUE(s.destroy(Face(0)));
  ASSERT_TRUE(s.destroy(Face(1)));
  EXPECT_FALSE(s.is_live(Face(1)));
  EXPECT_FALSE(s.is_live(v));
  EXPECT_EQ(s.face_limit(), 3u);
  EXPECT_EQ(*s.create(Point(0), Point(1), Point(2)), Face(1));
  EXPECT_EQ(s.org(half_edge(Face(1), 1)), v);
  EXPECT_EQ(*s.create(Point(0), Point(1), Point(2)), Face(0));
}

TEST(Surface, RefusalsNameThePreconditionAndChangeNothing) {
  Surface s = grid(2, 2);
  const std::string before = dump(s);
  const HalfEdge inside = [&] {
    for (const Face f : s.faces())
      for (const HalfEdge h : s.star(f))
        if (!s.is_boundary(h)) return h;
    return HalfEdge();
  }();
  const HalfEdge outside = s.on_curve(*s.curves().begin());
  const HalfEdge dead(10'000);
  const auto refused = [](const auto& result, Precondition p, std::uint32_t element) {
    return !result && result.error() == Violation{p, element};
  };
  EXPECT_TRUE(refused(s.glue(outside, outside), Precondition::two_half_edges, outside.index()));
  EXPECT_TRUE(refused(s.glue(outside, inside), Precondition::boundary_edge, inside.index()));
  EXPECT_TRUE(refused(s.glue(dead, outside), Precondition::live_half_edge, dead.index()));
  EXPECT_TRUE(refused(s.glue(outside, HalfEdge()), Precondition::live_half_edge, ~0u));
  EXPECT_TRUE(refused(s.unglue(outside), Precondition::interior_edge, outside.index()));
  EXPECT_TRUE(refused(s.unglue(dead), Precondition::live_half_edge, dead.index()));
  EXPECT_TRUE(
      refused(s.destroy(left(inside)), Precondition::all_edges_on_boundary, left(inside).index()));
  EXPECT_TRUE(refused(s.destroy(Face(10'000)), Precondition::live_face, 10'000));
  EXPECT_TRUE(refused(attach(s, inside, Point(0)), Precondition::boundary_edge, inside.index()));
  EXPECT_TRUE(refused(detach(s, dead), Precondition::live_half_edge, dead.index()));
  EXPECT_TRUE(refused(detach(s, Face()), Precondition::live_face, ~0u));
  EXPECT_EQ(dump(s), before);
  EXPECT_EQ(describe(Violation{Precondition::boundary_edge, 5}),
            "boundary_edge does not hold at half-edge 5");
}

TEST(Surface, ZipLeavesACurveOfOneEdgeAndTwoOfThoseMakeASphere) {
  // A triangle zipped to itself is a cone: its third edge is a loop.
  Surface s;
  ASSERT_TRUE(s.create(Point(0), Point(1), Point(2)));
  EXPECT_EQ(*s.glue(he(0), he(1)), HandleCase::zip);
  EXPECT_EQ(s.characteristic(), (Characteristic{2, 2, 1, 1, 0, 1}));
  EXPECT_EQ(s.boundary_next(he(2)), he(2));
  EXPECT_EQ(s.org(he(2)), s.dest(he(2)));
  EXPECT_EQ(s.degree(s.org(he(2))), 3u);  // both ends of the loop, and the other edge
  EXPECT_EQ(s.degree(s.org(he(1))), 1u);  // the tip

  ASSERT_TRUE(s.create(Point(0), Point(1), Point(2)));
  EXPECT_EQ(*s.glue(he(3), he(4)), HandleCase::zip);
  EXPECT_EQ(*s.glue(he(2), he(5)), HandleCase::join_components_at_loops);
  EXPECT_EQ(s.characteristic(), (Characteristic{3, 3, 2, 0, 0, 1}));
  EXPECT_TRUE(validate(s).empty());
  EXPECT_EQ(*s.unglue(he(5)), HandleCase::join_components_at_loops);
  EXPECT_EQ(*s.unglue(he(1)), HandleCase::zip);
}

TEST(Surface, TwoTrianglesGluedAlongAllEdges) {
  Surface s;
  ASSERT_TRUE(s.create(Point(0), Point(1), Point(2)));
  ASSERT_TRUE(s.create(Point(1), Point(0), Point(2)));
  EXPECT_EQ(*s.glue(he(0), he(3)), HandleCase::join_components);
  EXPECT_EQ(*s.glue(he(1), he(5)), HandleCase::zip);
  EXPECT_EQ(*s.glue(he(2), he(4)), HandleCase::close);
  EXPECT_EQ(s.characteristic(), (Characteristic{3, 3, 2, 0, 0, 1}));
  EXPECT_TRUE(validate(s).empty());
  EXPECT_EQ(*s.unglue(he(0)), HandleCase::close);
  EXPECT_EQ(s.length(s.curve(he(0))), 2u);
}

TEST(Surface, CutsOfATorus) {
  Surface s = torus(4, 5);
  EXPECT_EQ(s.characteristic(), (Characteristic{20, 60, 40, 0, 1, 1}));
  // Round the torus once: opens one curve, lengthens it, and where the ends meet makes two.
  const Vertex start = s.org(he(0));
  Vertex at = s.dest(he(0));
  EXPECT_EQ(*s.unglue(he(0)), HandleCase::close);
  std::vector<HandleCase> cases;
  while (s.point(at) != s.point(start)) {
    // Straight on from the end of the cut: as many corners on either side.
    HalfEdge ahead;
    std::uint32_t i = 0;
    for (const HalfEdge x : s.fan(at))
      if (i++ == s.corner_count(at) / 2) ahead = x;
    at = s.dest(ahead);
    cases.push_back(*s.unglue(ahead));
    ASSERT_LT(cases.size(), 10u);
  }
  ASSERT_FALSE(cases.empty());
  for (std::size_t i = 0; i + 1 < cases.size(); ++i) EXPECT_EQ(cases[i], HandleCase::zip);
  EXPECT_EQ(cases.back(), HandleCase::join_curves);
  EXPECT_EQ(s.characteristic().g, 0);
  EXPECT_EQ(s.characteristic().b, 2);
  EXPECT_TRUE(validate(s).empty());
}

TEST(Surface, CopiesMadeByACutShareAPoint) {
  Surface s = grid(1, 1);  // two triangles
  HalfEdge diagonal;
  for (const HalfEdge h : s.star(Face(0)))
    if (!s.is_boundary(h)) diagonal = h;
  const HalfEdge twin = s.sym(diagonal);
  const Point p = s.point(s.org(diagonal));
  EXPECT_EQ(*s.unglue(diagonal), HandleCase::join_components);
  EXPECT_NE(s.org(diagonal), s.dest(twin));
  EXPECT_EQ(s.point(s.org(diagonal)), p);
  EXPECT_EQ(s.point(s.dest(twin)), p);
  EXPECT_EQ(s.characteristic(), 2 * effect_of_create);
}

TEST(Surface, GlueKeepsThePointsOfItsFirstEdge) {
  Surface s;
  ASSERT_TRUE(s.create(Point(0), Point(1), Point(2)));
  ASSERT_TRUE(s.create(Point(3), Point(4), Point(5)));
  ASSERT_TRUE(s.glue(he(4), he(0)));
  EXPECT_EQ(s.point(s.org(he(4))), Point(4));
  EXPECT_EQ(s.point(s.org(he(0))), Point(5));
  EXPECT_EQ(s.point(s.org(he(2))), Point(2));
  // Also when the other edge's vertices have more corners, and so keep their ids.
  ASSERT_TRUE(s.create(Point(6), Point(7), Point(8)));
  const Vertex larger = s.org(he(5));
  EXPECT_EQ(s.boundary_next(he(2)), he(5));
  EXPECT_EQ(s.corner_count(s.org(he(5))), 2u);
  ASSERT_TRUE(s.glue(he(6), he(5)));
  EXPECT_EQ(s.dest(he(6)), larger);
  EXPECT_EQ(s.org(he(5)), larger);
  EXPECT_EQ(s.point(s.org(he(6))), Point(6));
  EXPECT_EQ(s.point(s.dest(he(6))), Point(7));
}

TEST(Surface, DetachInTheMiddleAndBack) {
  Surface s = from_triangles({{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}});
  const Surface whole = s;
  EXPECT_EQ(s.characteristic(), (Characteristic{4, 6, 4, 0, 0, 1}));
  const auto done = detach(s, Face(2));
  ASSERT_TRUE(done);
  ASSERT_EQ(done->cuts().size(), 3u);
  EXPECT_EQ(done->cuts()[0].undone, HandleCase::close);
  EXPECT_EQ(done->cuts()[1].undone, HandleCase::zip);
  EXPECT_EQ(done->cuts()[2].undone, HandleCase::join_components);
  EXPECT_EQ(s.characteristic(), (Characteristic{4, 6, 3, 1, 0, 1}));
  ASSERT_EQ(*s.create(done->points()[0], done->points()[1], done->points()[2]), Face(2));
  for (std::size_t i = 3; i-- > 0;) ASSERT_TRUE(s.glue(done->cuts()[i].h, done->cuts()[i].twin));
  EXPECT_TRUE(equivalent(s, whole));
}

TEST(Surface, CirculatorsOnAGrid) {
  const Surface s = grid(3, 3);  // 16 vertices, 18 faces
  EXPECT_EQ(s.characteristic(), (Characteristic{16, 33, 18, 1, 0, 1}));
  for (const Vertex v : s.vertices()) {
    EXPECT_EQ(list(s.star(v)).size(), s.degree(v));
    std::uint32_t inside = 0;
    for (const HalfEdge h : s.fan(v)) {
      EXPECT_EQ(s.org(h), v);
      ++inside;
    }
    EXPECT_EQ(inside + (s.is_boundary(v) ? 1 : 0), s.degree(v));
    HalfEdge last;
    for (const HalfEdge h : s.link(v)) {
      EXPECT_EQ(s.org(lprev(h)), v);
      if (last) {
        EXPECT_EQ(s.dest(last), s.org(h));  // counterclockwise, without gaps
      }
      last = h;
    }
    EXPECT_EQ(s.dest(last) == s.org(*s.link(v).begin()), !s.is_boundary(v));
  }
  for (const Face f : s.faces())
    for (const HalfEdge h : s.star(f)) {
      if (s.is_boundary(h)) continue;
      EXPECT_EQ(list(s.star(h)), (std::vector{h, s.sym(h)}));
      EXPECT_EQ(list(s.link(h)), (std::vector{lprev(h), lprev(s.sym(h))}));
    }
  const Curve rim = *s.curves().begin();
  EXPECT_EQ(s.length(rim), 12u);
  HalfEdge last;
  for (const HalfEdge h : s.boundary(rim)) {
    if (last) {
      EXPECT_EQ(s.boundary_prev(h), last);
    }
    last = h;
  }
  EXPECT_EQ(s.boundary_next(last), s.on_curve(rim));
}

TEST(Surface, AdjacentVerticesAndEdges) {
  const auto adjacent = [](const Surface& s, Vertex v) {
    std::vector<std::uint32_t> out;
    for (const Vertex x : s.adjacent_vertices(v)) out.push_back(x.index());
    EXPECT_EQ(out.size(), s.degree(v));
    return out;
  };
  using Ids = std::vector<std::uint32_t>;
  const Surface s = grid(2, 2);  // vertices 0 1 2, 3 4 5, 6 7 8; diagonals to the upper right
  EXPECT_EQ(adjacent(s, Vertex(4)).size(), 6u);
  EXPECT_EQ(adjacent(s, Vertex(0)), (Ids{1, 4, 3}));  // from the boundary to the boundary
  EXPECT_EQ(adjacent(s, Vertex(1)), (Ids{2, 5, 4, 0}));
  EXPECT_EQ(adjacent(s, Vertex(8)), (Ids{7, 4, 5}));
  std::size_t edges = 0;
  std::vector<bool> met(s.half_edge_limit());
  for (const HalfEdge h : s.edges()) {
    EXPECT_EQ(s.edge(h), h);
    for (const HalfEdge side : s.star(h)) {
      EXPECT_TRUE(s.same_edge(side, h));
      EXPECT_EQ(s.edge(side), h);
      EXPECT_FALSE(met[side.index()]);
      met[side.index()] = true;
    }
    EXPECT_FALSE(s.same_edge(h, lnext(h)));
    ++edges;
  }
  EXPECT_EQ(edges, 16u);
  EXPECT_EQ(std::count(met.begin(), met.end(), true), 24);

  // No simplicial complex: two triangles on all three edges, and a cone, whose rim is a loop.
  Surface pillow = test::from_triangles({{0, 1, 2}, {1, 0, 2}});
  EXPECT_EQ(adjacent(pillow, Vertex(0)), (Ids{1, 2}));
  ASSERT_TRUE(pillow.unglue(he(0)));
  EXPECT_EQ(adjacent(pillow, pillow.org(he(0))).size(), 3u);  // the other end twice
  Surface cone;
  ASSERT_TRUE(cone.create(Point(0), Point(1), Point(2)));
  ASSERT_TRUE(cone.glue(he(0), he(1)));
  const Vertex base = cone.org(he(2)), tip = cone.org(he(1));
  EXPECT_EQ(adjacent(cone, base), (Ids{base.index(), tip.index(), base.index()}));
  EXPECT_EQ(adjacent(cone, tip), (Ids{base.index()}));
}

TEST(Surface, SameBoundaryOnAnAnnulus) {
  Surface s = grid(3, 3);
  HalfEdge middle;
  for (const Face f : s.faces())
    if (!s.is_boundary(s.org(half_edge(f, 0))) && !middle) middle = half_edge(f, 0);
  ASSERT_TRUE(detach(s, middle));
  EXPECT_EQ(s.characteristic().b, 2);
  const Curve a = *s.curves().begin();
  Curve b;
  for (const Curve c : s.curves()) b = c;
  EXPECT_TRUE(s.same_boundary(s.on_curve(a), s.boundary_next(s.on_curve(a))));
  EXPECT_FALSE(s.same_boundary(s.on_curve(a), s.on_curve(b)));
  EXPECT_EQ(*s.glue(s.on_curve(a), s.on_curve(b)), HandleCase::join_curves);
  EXPECT_EQ(s.genus(), 1);
}

TEST(Surface, FromTwinsNamesWhatIsWrong) {
  const Surface s = grid(2, 1);
  const std::vector<Vertex> org(s.origins().begin(), s.origins().end());
  const std::vector<HalfEdge> twin(s.twins().begin(), s.twins().end());
  const auto n = s.vertex_limit();
  const auto wrong = [&](auto change) {
    auto o = org;
    auto t = twin;
    change(o, t);
    const auto result = Surface::from_twins(o, t, n);
    return result ? std::string("accepted") : describe(result.error());
  };
  EXPECT_EQ(wrong([](auto&, auto&) {}), "accepted");
  EXPECT_EQ(wrong([](auto& o, auto&) { o.pop_back(); }), "array_sizes fails at size 11");
  EXPECT_EQ(wrong([](auto&, auto& t) { t.resize(9); }), "array_sizes fails at size 9");
  EXPECT_EQ(wrong([&](auto& o, auto&) { o[4] = Vertex(n); }),
            "origin_is_live fails at half-edge 4");
  EXPECT_EQ(wrong([](auto& o, auto&) { o[4] = Vertex(); }), "origin_is_live fails at half-edge 4");
  EXPECT_EQ(wrong([](auto&, auto& t) { t[3] = he(99); }), "twin_in_range fails at half-edge 3");
  EXPECT_EQ(wrong([](auto&, auto& t) { t[0] = he(0); }), "twin_is_mutual fails at half-edge 0");
  std::uint32_t inside = 0;
  while (!twin[inside]) ++inside;
  EXPECT_EQ(wrong([&](auto&, auto& t) { t[inside] = HalfEdge(); }),
            "twin_is_mutual fails at half-edge " + std::to_string(twin[inside].index()));
  EXPECT_EQ(Surface::from_twins(org, twin, n, std::vector<Point>(2)).error(),
            (Fault{Invariant::array_sizes, 2}));
  // Two triangles that meet in a vertex only.
  const std::vector<Vertex> bow{Vertex(0), Vertex(1), Vertex(2), Vertex(0), Vertex(3), Vertex(4)};
  EXPECT_EQ(Surface::from_twins(bow, std::vector<HalfEdge>(6), 5).error(),
            (Fault{Invariant::one_fan, 0}));
}

TEST(Surface, DumpedCodeKeepsDeadIds) {
  Surface s = grid(2, 2);
  ASSERT_TRUE(detach(s, Face(3)));
  const auto again = Surface::from_twins(s.origins(), s.twins(), s.vertex_limit(), s.points());
  ASSERT_TRUE(again);
  EXPECT_TRUE(validate(*again).empty());
  EXPECT_FALSE(again->is_live(Face(3)));
  EXPECT_TRUE(equivalent(s, *again));
  const std::string code = dump_code(s);
  EXPECT_NE(code.find("const std::vector<Point> points{Point(0), Point("), std::string::npos);
  EXPECT_NE(code.find("HalfEdge()"), std::string::npos);
  EXPECT_NE(code.find("Surface surface = *Surface::from_twins(origins, twins, "),
            std::string::npos);
}

}  // namespace
}  // namespace clers
