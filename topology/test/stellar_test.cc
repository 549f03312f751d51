// The stellar operators on examples small enough to draw, and what the paper proves of them.
#include "topology/stellar.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <deque>
#include <map>
#include <set>

#include "corpus/enumerate.h"
#include "topology/dump.h"
#include "topology/equivalence.h"
#include "topology/test/meshes.h"
#include "topology/validate.h"

namespace clers {
namespace {

using test::from_triangles;
using test::grid;

HalfEdge he(std::uint32_t i) {
  return HalfEdge(i);
}

/// The origins of a face's corners.
std::array<std::uint32_t, 3> corners(const Surface& s, Face f) {
  return {s.org(half_edge(f, 0)).index(), s.org(half_edge(f, 1)).index(),
          s.org(half_edge(f, 2)).index()};
}
using Corners = std::array<std::uint32_t, 3>;

HalfEdge between(const Surface& s, std::uint32_t a, std::uint32_t b) {
  for (const Face f : s.faces())
    for (const HalfEdge h : s.star(f))
      if (s.org(h) == Vertex(a) && s.dest(h) == Vertex(b)) return h;
  return HalfEdge();
}

// a = 0, b = 1, c = 2, d = 3, as the figures of surface.h; h is half-edge 1 of either face.
Surface two_triangles() {
  return from_triangles({{2, 0, 1}, {3, 1, 0}});
}

TEST(Stellar, FlipAsDrawn) {
  Surface s = two_triangles();
  ASSERT_TRUE(s.flip(he(1)));
  EXPECT_EQ(corners(s, Face(0)), (Corners{0, 3, 2}));
  EXPECT_EQ(corners(s, Face(1)), (Corners{1, 2, 3}));
  EXPECT_EQ(s.org(he(1)), Vertex(3));
  EXPECT_EQ(s.sym(he(1)), he(4));
  EXPECT_TRUE(validate(s).empty());
}

TEST(Stellar, SplitEdgeAsDrawn) {
  Surface s = two_triangles();
  const Vertex v = *s.split(he(1), Point(9));
  EXPECT_EQ(v, Vertex(4));
  EXPECT_EQ(corners(s, Face(0)), (Corners{4, 2, 0}));
  EXPECT_EQ(corners(s, Face(2)), (Corners{4, 1, 2}));
  EXPECT_EQ(corners(s, Face(1)), (Corners{4, 3, 1}));
  EXPECT_EQ(corners(s, Face(3)), (Corners{4, 0, 3}));
  EXPECT_EQ(s.dest(s.star_half_edge(v)), Vertex(0));
  EXPECT_EQ(s.characteristic(), (Characteristic{5, 8, 4, 1, 0, 1}));
  // The other way through: the other diagonal.
  Surface other = s;
  const auto welded = other.weld(between(s, 4, 2));
  ASSERT_TRUE(welded);
  EXPECT_EQ(other.org(welded->at), Vertex(2));
  EXPECT_EQ(other.dest(welded->at), Vertex(3));
  EXPECT_EQ(s.weld(v)->point, Point(9));
  EXPECT_EQ(dump(s), dump(two_triangles()));
}

TEST(Stellar, SplitBoundaryEdgeAsDrawn) {
  Surface s = from_triangles({{2, 0, 1}});
  const Vertex v = *s.split(he(1), Point(9));
  EXPECT_EQ(corners(s, Face(0)), (Corners{3, 2, 0}));
  EXPECT_EQ(corners(s, Face(1)), (Corners{3, 1, 2}));
  EXPECT_EQ(s.characteristic(), (Characteristic{4, 5, 2, 1, 0, 1}));
  EXPECT_EQ(s.length(*s.curves().begin()), 4u);
  EXPECT_EQ(s.boundary_next(he(2)), he(3));
  EXPECT_EQ(s.weld(v)->undone, StellarCase::boundary_edge);
  EXPECT_EQ(corners(s, Face(0)), (Corners{2, 0, 1}));
}

TEST(Stellar, SplitFaceAsDrawn) {
  Surface s = from_triangles({{0, 1, 2}});
  const Vertex v = *s.split(Face(0), Point(9));
  EXPECT_EQ(corners(s, Face(0)), (Corners{3, 0, 1}));
  EXPECT_EQ(corners(s, Face(1)), (Corners{3, 1, 2}));
  EXPECT_EQ(corners(s, Face(2)), (Corners{3, 2, 0}));
  EXPECT_EQ(s.characteristic(), (Characteristic{4, 6, 3, 1, 0, 1}));
  EXPECT_EQ(s.weld(v)->undone, StellarCase::face);
  EXPECT_EQ(dump(s), dump(from_triangles({{0, 1, 2}})));
}

TEST(Stellar, IdsComeBackLastFreedFirst) {
  Surface s = grid(3, 3);
  const std::uint32_t faces = s.face_limit(), vertices = s.vertex_limit();
  for (std::uint32_t i = 0; i < 20; ++i) {
    const Vertex v = i % 2 == 0 ? *s.split(Face(i % 18), Point(i))
                                : *s.split(half_edge(Face(i % 18), i % 3), Point(i));
    ASSERT_TRUE(s.weld(v));
  }
  EXPECT_LE(s.face_limit(), faces + 2);
  EXPECT_EQ(s.vertex_limit(), vertices + 1);
  EXPECT_TRUE(validate(s).empty());
  EXPECT_TRUE(equivalent(s, grid(3, 3)));
}

// The numbering of Dynamic adaptive meshes, §5: the new vertex is corner 0, its face's split edge
// is half-edge 1, and the star half-edge leads to where the welded edge begins.
TEST(Stellar, NumberingCarriesTheHierarchy) {
  Surface s = two_triangles();
  const std::string coarse = dump(s);
  std::vector<Vertex> made;
  // Split edges, whole levels of them: each is half-edge 1 on both sides.
  for (int level = 0; level < 6; ++level) {
    const std::uint32_t faces = s.face_limit(), vertices = s.vertex_limit();
    for (std::uint32_t f = 0; f < faces; ++f) {
      const HalfEdge h = half_edge(Face(f), 1);
      if (s.org(lprev(h)).index() >= vertices) continue;  // from across, on this level
      if (s.sym(h)) {
        ASSERT_EQ(corner(s.sym(h)), 1u);
      }
      made.push_back(*s.split(h, Point(0)));
    }
    EXPECT_EQ(s.characteristic().f, 2 << (level + 1));
  }
  EXPECT_GT(made.size(), 20u);
  while (!made.empty()) {
    ASSERT_TRUE(s.weld(made.back()));
    made.pop_back();
  }
  EXPECT_EQ(dump(s), coarse);
}

TEST(Stellar, RefusalsNameThePreconditionAndChangeNothing) {
  Surface s = grid(2, 2);
  const std::string before = dump(s);
  const auto refused = [](const auto& result, Precondition p, std::uint32_t element) {
    return !result && result.error() == Violation{p, element};
  };
  const HalfEdge rim = s.on_curve(*s.curves().begin()), dead(999);
  Vertex centre, ear;
  for (const Vertex v : s.vertices()) {
    if (!s.is_boundary(v)) centre = v;
    if (s.degree(v) == 2) ear = v;
  }
  const HalfEdge inside = s.star_half_edge(centre);
  EXPECT_TRUE(refused(s.flip(rim), Precondition::interior_edge, rim.index()));
  EXPECT_TRUE(refused(s.flip(dead), Precondition::live_half_edge, 999));
  EXPECT_TRUE(refused(s.split(dead, Point(0)), Precondition::live_half_edge, 999));
  EXPECT_TRUE(refused(s.split(Face(99), Point(0)), Precondition::live_face, 99));
  EXPECT_TRUE(refused(s.weld(Vertex(99)), Precondition::live_vertex, 99));
  EXPECT_TRUE(refused(s.weld(dead), Precondition::live_half_edge, 999));
  EXPECT_TRUE(refused(s.weld(centre), Precondition::weld_degree, centre.index()));
  EXPECT_TRUE(refused(s.weld(ear), Precondition::weld_degree, ear.index()));
  EXPECT_TRUE(refused(remove(s, Vertex(99), 3), Precondition::live_vertex, 99));
  EXPECT_TRUE(refused(remove(s, centre, 5), Precondition::weld_degree, centre.index()));
  EXPECT_TRUE(refused(remove(s, ear, 3), Precondition::weld_degree, ear.index()));
  EXPECT_TRUE(refused(collapse(s, dead), Precondition::live_half_edge, 999));
  EXPECT_TRUE(refused(split_vertex(s, dead, inside, Point(0)), Precondition::live_half_edge, 999));
  EXPECT_TRUE(refused(split_vertex(s, inside, inside, Point(0)), Precondition::two_half_edges,
                      inside.index()));
  EXPECT_TRUE(
      refused(split_vertex(s, inside, rim, Point(0)), Precondition::leave_one_vertex, rim.index()));
  EXPECT_TRUE(refused(split_vertex(s, inside, HalfEdge(), Point(0)), Precondition::leave_one_vertex,
                      inside.index()));
  EXPECT_EQ(dump(s), before);
  EXPECT_EQ(describe(Violation{Precondition::weld_degree, 5}),
            "weld_degree does not hold at vertex 5");

  // A triangle glued to itself round its tip: the edge has one face on both sides.
  Surface cone;
  ASSERT_TRUE(cone.create(Point(0), Point(1), Point(2)));
  ASSERT_TRUE(cone.glue(he(0), he(1)));
  EXPECT_TRUE(refused(cone.flip(he(0)), Precondition::two_faces, 0));
  EXPECT_TRUE(refused(cone.split(he(1), Point(0)), Precondition::two_faces, 1));
  const Vertex rim_vertex = cone.org(he(2));
  ASSERT_EQ(cone.degree(rim_vertex), 3u);
  EXPECT_TRUE(refused(cone.weld(rim_vertex), Precondition::simple_star, rim_vertex.index()));
  EXPECT_TRUE(cone.split(Face(0), Point(0)));
  EXPECT_TRUE(validate(cone).empty());
}

TEST(Stellar, TheLinkCondition) {
  // A tetrahedron is the least sphere: no edge of it collapses.
  Surface tetrahedron = from_triangles({{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}});
  for (std::uint32_t h = 0; h < 12; ++h) EXPECT_FALSE(link_condition(tetrahedron, he(h)));
  // A chord of a disk, a triangle of edges that is no face, an ear, a triangle alone.
  Surface strip = from_triangles({{0, 1, 2}, {1, 3, 2}, {1, 4, 3}});
  EXPECT_FALSE(link_condition(strip, between(strip, 1, 2)));
  EXPECT_TRUE(link_condition(strip, between(strip, 0, 1)));
  EXPECT_TRUE(link_condition(strip, between(strip, 3, 2)));
  EXPECT_EQ(*collapse(strip, between(strip, 0, 1)), Vertex(1));
  EXPECT_EQ(strip.characteristic(), (Characteristic{4, 5, 2, 1, 0, 1}));
  Surface alone = from_triangles({{0, 1, 2}});
  EXPECT_FALSE(link_condition(alone, he(0)));
  Surface stacked = tetrahedron;
  const Vertex v = *stacked.split(Face(0), Point(4));
  EXPECT_FALSE(link_condition(stacked, between(stacked, 0, 1)));  // 2, 3 and the vertex inside
  EXPECT_EQ(*collapse(stacked, stacked.star_half_edge(v)), Vertex(0));
  EXPECT_TRUE(equivalent(stacked, tetrahedron));
  // From the boundary inwards: the vertex on the boundary stays.
  Surface disk = grid(2, 2);
  for (const Vertex w : disk.vertices()) {
    if (disk.is_boundary(w)) continue;
    const HalfEdge out = disk.star_half_edge(w);
    const Vertex rim = disk.dest(out);
    EXPECT_EQ(*collapse(disk, disk.sym(out)), rim);
    break;
  }
  EXPECT_EQ(disk.characteristic(), (Characteristic{8, 13, 6, 1, 0, 1}));
}

// Attributes --------------------------------------------------------------------------------------

/// Values by corner, side and vertex that follow; what a user of follow.h would write.
struct Values {
  std::vector<double> corner, vertex;
  std::vector<int> side, face;

  void operator()(const Change& c) {
    std::array<double, 12> corners;
    std::array<int, 12> sides;
    std::size_t i = 0;
    for (const Change::Slot& slot : c.slots()) {
      double sum = 0;
      for (const HalfEdge h : slot.corners()) sum += corner[h.index()];
      corners[i] = sum / slot.count;
      sides[i++] = slot.side ? side[slot.side.index()] : -1;
    }
    i = 0;
    for (const Change::Slot& slot : c.slots()) {
      if (slot.at.index() >= corner.size()) {
        corner.resize(slot.at.index() + 1);
        side.resize(slot.at.index() + 1);
      }
      corner[slot.at.index()] = corners[i];
      side[slot.at.index()] = sides[i++];
    }
    for (const auto& [part, of] : c.parts()) {
      if (part.index() >= face.size()) face.resize(part.index() + 1);
      face[part.index()] = face[of.index()];
    }
    if (c.made()) {
      double sum = 0;
      for (const Vertex v : c.between()) sum += vertex[v.index()];
      if (c.made().index() >= vertex.size()) vertex.resize(c.made().index() + 1);
      vertex[c.made().index()] = sum / static_cast<double>(c.between().size());
    }
  }
};

// Corner values that equal the vertex's must go on doing so, sides keep what they are sides of.
TEST(Stellar, AttributesFollow) {
  Surface s = test::chain_of_tori(2, 4);
  (void)s.unglue(half_edge(Face(12), 1));
  Values values;
  for (std::uint32_t v = 0; v < s.vertex_limit(); ++v) values.vertex.push_back(v * v + 1);
  for (std::uint32_t h = 0; h < s.half_edge_limit(); ++h) {
    const bool live = s.is_live(he(h));
    values.corner.push_back(live ? values.vertex[s.org(he(h)).index()] : 0);
    values.side.push_back(live && s.sym(he(h)) ? int(std::min(h, s.sym(he(h)).index())) : int(h));
  }
  for (std::uint32_t f = 0; f < s.face_limit(); ++f) values.face.push_back(int(f));

  std::uint64_t seed = 1;
  const auto random = [&](std::uint32_t n) {
    seed = seed * 6364136223846793005u + 1442695040888963407u;
    return static_cast<std::uint32_t>((seed >> 33) % n);
  };
  std::size_t done = 0;
  for (int step = 0; step < 4000; ++step) {
    const HalfEdge h = he(random(s.half_edge_limit()));
    if (!s.is_live(h)) continue;
    const bool crowded = s.characteristic().f > 300;
    const Vertex v = s.org(h);
    switch (random(7)) {
      case 0: done += flip(s, h, values).ok(); break;
      case 1: done += !crowded && split(s, h, Point(0), values).ok(); break;
      case 2: done += !crowded && split(s, left(h), Point(0), values).ok(); break;
      case 3: done += weld(s, h, values).ok(); break;
      case 4: done += remove(s, v, 3, doubles_an_edge, values).ok(); break;
      case 5: {
        // Every corner but that of the vertex merged keeps its vertex.
        const auto kept = collapse(s, h, values);
        if (!kept) break;
        ++done;
        for (const HalfEdge x : s.fan(*kept))
          values.corner[x.index()] = values.vertex[kept->index()];
        break;
      }
      default: {
        if (crowded) break;
        HalfEdge to = s.sym(lprev(h));
        if (to) to = s.sym(lprev(to));
        const auto edge = split_vertex(s, h, to, Point(0), values);
        if (!edge) break;
        ++done;
      }
    }
    for (const Face f : s.faces())
      for (const HalfEdge x : s.star(f)) {
        ASSERT_DOUBLE_EQ(values.corner[x.index()], values.vertex[s.org(x).index()]) << step;
        if (s.sym(x)) {
          ASSERT_EQ(values.side[x.index()], values.side[s.sym(x).index()]) << step;
        }
      }
  }
  EXPECT_GT(done, 1500u);
}

// Theorem 7, Propositions 9 and 10 ----------------------------------------------------------------

Surface surface_of(const Mesh& mesh) {
  test::Triangles t;
  for (std::size_t i = 0; i < mesh.corners.size(); i += 3)
    t.push_back({mesh.corners[i], mesh.corners[i + 1], mesh.corners[i + 2]});
  return from_triangles(t);
}

/// Equal for equivalent surfaces of one component, and only for those: the least code of a walk.
std::vector<std::uint32_t> code(const Surface& s) {
  std::vector<std::uint32_t> least;
  for (std::uint32_t root = 0; root < s.half_edge_limit(); ++root) {
    if (!s.is_live(he(root))) continue;
    std::vector<std::uint32_t> c;
    std::map<Vertex, std::uint32_t> label;
    std::set<Face> met{left(he(root))};
    std::deque<HalfEdge> entries{he(root)};
    while (!entries.empty()) {
      HalfEdge h = entries.front();
      entries.pop_front();
      for (int k = 0; k < 3; ++k, h = lnext(h)) {
        c.push_back(
            label.emplace(s.org(h), static_cast<std::uint32_t>(label.size())).first->second);
        if (met.insert(left(s.sym(h))).second) entries.push_back(s.sym(h));
      }
    }
    if (least.empty() || c < least) least = std::move(c);
  }
  return least;
}

bool is_complex(const Surface& s) {
  std::set<std::pair<Vertex, Vertex>> edges;
  for (const Face f : s.faces())
    for (const HalfEdge h : s.star(f))
      if (s.org(h) == s.dest(h) || !edges.insert({s.org(h), s.dest(h)}).second) return false;
  return true;
}

using Codes = std::set<std::vector<std::uint32_t>>;

/// All triangulations of the sphere with n vertices, up to renumbering.
std::map<std::vector<std::uint32_t>, Surface> spheres(std::uint32_t n) {
  std::map<std::vector<std::uint32_t>, Surface> all;
  corpus::for_each_sphere_triangulation(n, [&](const Mesh& mesh) {
    Surface s = surface_of(mesh);
    std::vector<std::uint32_t> c = code(s);
    all.emplace(std::move(c), std::move(s));
  });
  return all;
}

// So many, mirror images apart; that all rooted ones are there is for enumerate_test to say.
TEST(Theorem7, FlipsConnectTheSpheresOfEqualSize) {
  const std::size_t expected[] = {1, 1, 2, 6};
  for (std::uint32_t n = 4; n <= 7; ++n) {
    const auto all = spheres(n);
    EXPECT_EQ(all.size(), expected[n - 4]);
    // From every one, every other.
    for (const auto& [start, unused] : all) {
      Codes met{start};
      std::deque<std::vector<std::uint32_t>> queue{start};
      while (!queue.empty()) {
        const Surface& s = all.at(queue.front());
        queue.pop_front();
        for (std::uint32_t h = 0; h < s.half_edge_limit(); ++h) {
          Surface flipped = s;
          ASSERT_TRUE(flipped.flip(he(h)));
          if (!is_complex(flipped)) continue;
          auto c = code(flipped);
          ASSERT_EQ(all.count(c), 1u);
          if (met.insert(c).second) queue.push_back(std::move(c));
        }
      }
      EXPECT_EQ(met.size(), all.size()) << n;
    }
  }
}

// With unequal sizes: by splits and welds of edges alone, flips being both (Proposition 9).
TEST(Theorem7, MovesOnEdgesConnectTheSpheresOfAllSizes) {
  std::map<std::vector<std::uint32_t>, Surface> all;
  for (std::uint32_t n = 4; n <= 7; ++n) all.merge(spheres(n));
  for (const auto& [start, unused] : all) {
    Codes met{start};
    std::deque<Surface> queue{all.at(start)};
    std::size_t found = 1;
    const auto meet = [&](Surface s) {
      if (!is_complex(s)) return;
      auto c = code(s);
      found += all.count(c) != 0 && met.count(c) == 0;
      // One vertex more than the largest is enough to get everywhere.
      if (met.insert(std::move(c)).second) queue.push_back(std::move(s));
    };
    while (!queue.empty() && found < all.size()) {
      const Surface s = queue.front();
      queue.pop_front();
      for (std::uint32_t h = 0; h < s.half_edge_limit(); ++h) {
        if (!s.is_live(he(h))) continue;
        if (s.characteristic().v <= 7 && he(h) < s.sym(he(h))) {
          Surface split = s;
          ASSERT_TRUE(split.split(he(h), Point(0)));
          meet(std::move(split));
        }
        if (s.degree(s.org(he(h))) == 4) {
          Surface welded = s;
          if (welded.weld(he(h))) meet(std::move(welded));
        }
      }
    }
    EXPECT_EQ(found, all.size());
  }
}

// Proposition 9 (Fig. 6): every flip is a split of its edge and a weld through the other two.
TEST(Proposition9, AFlipIsASubdivisionAndAWeld) {
  std::size_t moves = 0;
  for (std::uint32_t n = 4; n <= 7; ++n)
    for (const auto& [c, s] : spheres(n))
      for (std::uint32_t h = 0; h < s.half_edge_limit(); ++h) {
        Surface flipped = s, moved = s;
        ASSERT_TRUE(flipped.flip(he(h)));
        const Vertex c_apex = s.org(lprev(he(h))), d_apex = s.org(lprev(s.sym(he(h))));
        const Vertex v = *moved.split(he(h), Point(0));
        for (const HalfEdge out : moved.fan(v)) {
          if (moved.dest(out) != d_apex) continue;
          const auto welded = moved.weld(out);
          ASSERT_TRUE(welded);
          EXPECT_EQ(moved.org(welded->at), d_apex);
          EXPECT_EQ(moved.dest(welded->at), c_apex);
          break;
        }
        EXPECT_EQ(code(flipped), code(moved));
        ++moves;
      }
  EXPECT_EQ(moves, (12u + 18u + 2 * 24u + 6 * 30u));
}

// Proposition 10: the split of a face is a split of an edge of it, a split of another of the new
// edges, and a weld: operations on edges alone.
TEST(Proposition10, AFaceSplitIsMadeOfMovesOnEdges) {
  std::size_t faces = 0;
  for (std::uint32_t n = 4; n <= 7; ++n)
    for (const auto& [c, s] : spheres(n))
      for (const Face f : s.faces()) {
        Surface direct = s, moved = s;
        ASSERT_TRUE(direct.split(f, Point(0)));
        // The corners a b c; v on a-b; w on v-c, inside what was f; then v away, through a and b.
        const Vertex a = s.org(half_edge(f, 0)), b = s.org(half_edge(f, 1)),
                     apex = s.org(half_edge(f, 2));
        const auto leads = [&](Vertex from, Vertex to) {
          for (const HalfEdge h : moved.fan(from))
            if (moved.dest(h) == to) return h;
          return HalfEdge();
        };
        const Vertex v = *moved.split(half_edge(f, 0), Point(0));
        const Vertex w = *moved.split(leads(v, apex), Point(1));
        ASSERT_EQ(moved.degree(v), 4u);
        ASSERT_TRUE(moved.weld(leads(v, a)));
        EXPECT_TRUE(moved.is_live(w));
        for (const Vertex x : {a, b, apex}) EXPECT_TRUE(leads(w, x));
        EXPECT_EQ(moved.degree(w), 3u);
        EXPECT_EQ(code(direct), code(moved));
        ++faces;
      }
  EXPECT_EQ(faces, (4u + 6u + 2 * 8u + 6 * 10u));
}

}  // namespace
}  // namespace clers
