// Memory that runs out: whichever allocation fails, the operator has changed nothing.
#include <gtest/gtest.h>

#include <new>

#include "topology/derived.h"
#include "topology/dump.h"
#include "topology/element_data.h"
#include "topology/stellar.h"
#include "topology/test/meshes.h"
#include "topology/test/scarce_memory.h"
#include "topology/validate.h"

namespace clers {
namespace {

/// Runs the operator on a copy (whose arrays have no room to spare) with ever more memory until it
/// succeeds; how many allocations it took.
template <class Operator>
int starve(const Surface& surface, Operator run) {
  const std::string before = dump(surface);
  for (int allocations = 0;; ++allocations) {
    Surface s = surface;
    bool failed = false;
    test::memory::remaining = allocations;
    try {
      run(s);
    } catch (const std::bad_alloc&) {
      failed = true;
    }
    test::memory::remaining = -1;
    EXPECT_TRUE(validate(s).empty());
    if (!failed) return allocations;
    EXPECT_EQ(dump(s), before);
    if (testing::Test::HasFailure()) return allocations;
  }
}

TEST(Memory, OperatorsFailWithoutAChange) {
  Surface s = test::chain_of_tori(2, 4);
  for (int i = 0; i < 4; ++i) ASSERT_TRUE(s.create(Point(0), Point(1), Point(2)));
  const Face f(s.face_limit() - 1);
  const HalfEdge e = half_edge(f, 0);
  EXPECT_GT(starve(s, [](Surface& x) { (void)x.create(Point(0), Point(1), Point(2)); }), 5);
  EXPECT_GT(starve(s, [&](Surface& x) { (void)x.destroy(f); }), 0);
  EXPECT_GT(starve(s, [&](Surface& x) { (void)x.glue(e, lnext(e)); }), 0);
  EXPECT_GT(starve(s, [&](Surface& x) { (void)x.unglue(half_edge(Face(9), 1)); }), 0);
  // A cut round the first torus, to its last edge.
  for (std::uint32_t column = 0; column < 3; ++column)
    ASSERT_TRUE(s.unglue(half_edge(Face(2 * (4 + column)), 0)));
  EXPECT_GT(starve(s,
                   [&](Surface& x) {
                     EXPECT_EQ(*x.unglue(half_edge(Face(2 * (4 + 3)), 0)), HandleCase::join_curves);
                   }),
            0);
}

TEST(Memory, StellarOperatorsFailWithoutAChange) {
  Surface s = test::grid(4, 4);
  const HalfEdge inside = half_edge(Face(9), 1), rim = s.on_curve(*s.curves().begin());
  ASSERT_FALSE(s.is_boundary(inside));
  EXPECT_EQ(starve(s, [&](Surface& x) { EXPECT_TRUE(x.flip(inside)); }), 0);
  EXPECT_EQ(starve(s, [&](Surface& x) { EXPECT_TRUE(x.turn(Face(9))); }), 0);
  EXPECT_GT(starve(s, [&](Surface& x) { EXPECT_TRUE(x.split(inside, Point(7))); }), 5);
  EXPECT_GT(starve(s, [&](Surface& x) { EXPECT_TRUE(x.split(rim, Point(7))); }), 5);
  EXPECT_GT(starve(s, [&](Surface& x) { EXPECT_TRUE(x.split(Face(3), Point(7))); }), 5);
  const HalfEdge edge = half_edge(Face(20), 0);
  const Vertex centre = *s.split(Face(3), Point(7)), middle = *s.split(edge, Point(8));
  const Vertex side = *s.split(s.on_curve(*s.curves().begin()), Point(9));
  for (const Vertex v : {centre, middle, side})
    EXPECT_GT(starve(s, [&](Surface& x) { EXPECT_TRUE(x.weld(v)); }), 0);
  // What is composed of them, too: flips, and then what needs memory.
  Vertex hub;
  for (const Vertex v : s.vertices())
    if (!s.is_boundary(v) && s.degree(v) > 5) hub = v;
  ASSERT_TRUE(hub);
  const HalfEdge from = s.star_half_edge(hub), to = s.sym(lprev(s.sym(lprev(from))));
  EXPECT_GT(starve(s, [&](Surface& x) { EXPECT_TRUE(remove(x, hub, 3)); }), 0);
  EXPECT_GT(starve(s, [&](Surface& x) { EXPECT_TRUE(collapse(x, from)); }), 0);
  EXPECT_GT(starve(s, [&](Surface& x) { EXPECT_TRUE(split_vertex(x, from, to, Point(1))); }), 5);
}

TEST(Memory, OperatorsFailWithoutAChangeWhereContainersFollow) {
  Surface s = test::grid(4, 4);
  const HalfEdge inside = half_edge(Face(9), 1);
  const auto with_data = [&](auto edit) {
    return starve(s, [&](Surface& x) {
      VertexData<int> on_vertices(x, 1);
      FaceData<double> on_faces(x, 2);
      HalfEdgeData<bool> on_sides(x, true);
      edit(x);
      EXPECT_EQ(on_vertices.values().size(), x.vertex_limit());
      EXPECT_EQ(on_faces.values().size(), x.face_limit());
      EXPECT_EQ(on_sides.values().size(), x.half_edge_limit());
    });
  };
  const int attach_only = with_data([](Surface&) {});
  EXPECT_GT(attach_only, 5);
  EXPECT_GT(with_data([](Surface& x) { (void)x.create(Point(0), Point(1), Point(2)); }),
            attach_only + 8);
  EXPECT_GT(with_data([&](Surface& x) { (void)x.unglue(inside); }), attach_only + 1);
  EXPECT_GT(with_data([&](Surface& x) { EXPECT_TRUE(x.split(inside, Point(7))); }),
            attach_only + 8);
  EXPECT_EQ(with_data([&](Surface& x) { EXPECT_TRUE(x.flip(inside)); }), attach_only);
  // One container that exists before, and whose growth fails: its values stay, too.
  for (int allocations = 0; allocations < 40; ++allocations) {
    Surface x = s;
    VertexData<int> data(x, 1);
    data[Vertex(3)] = 4;
    test::memory::remaining = allocations;
    bool failed = false;
    try {
      (void)x.split(inside, Point(7));
    } catch (const std::bad_alloc&) {
      failed = true;
    }
    test::memory::remaining = -1;
    EXPECT_EQ(data[Vertex(3)], 4);
    EXPECT_EQ(data.values().size(), failed ? s.vertex_limit() : s.vertex_limit() + 1);
    EXPECT_EQ(data.values().size(), x.vertex_limit());
  }
}

TEST(Memory, NodesOfCurvesAreThereForTheBoundaryAlone) {
  for (const Surface& s : {test::torus(40, 40), test::grid(40, 40)}) {
    const Characteristic& c = s.characteristic();
    const std::int64_t boundary_edges = 2 * c.e - 3 * c.f;
    const std::size_t before = test::memory::bytes;
    const Surface copy = s;
    // As surface.h says, and some for a curve and a component.
    EXPECT_LE(test::memory::bytes - before,
              static_cast<std::size_t>(28 * c.f + 16 * c.v + 24 * boundary_edges + 200));
    EXPECT_EQ(copy.face_limit(), s.face_limit());
  }
}

TEST(Memory, CompressFailsWithoutAChange) {
  Surface s = test::torus(5, 4);
  for (std::uint32_t f = 0; f < 20; f += 2) ASSERT_TRUE(detach(s, Face(f)));
  EXPECT_GT(starve(s,
                   [](Surface& x) {
                     VertexData<int> on_vertices(x, 1);
                     HalfEdgeData<int> on_sides(x, 1);
                     x.compress();
                   }),
            15);
}

TEST(Memory, QueriesAndRepeatedOperatorsAllocateNothing) {
  Surface s = test::torus(6, 6);
  const VertexData<int> on_vertices(s, 0);
  const HalfEdgeData<int> on_sides(s, 0);
  // Half-edge 1 of both its faces, so that split and weld bring it back.
  const HalfEdge h = s.weld(*s.split(half_edge(Face(20), 0), Point(3)))->at;
  const Vertex far = s.org(half_edge(Face(60), 1));
  const auto round = [&] {
    const HalfEdge t = s.sym(h);
    (void)s.unglue(h);
    (void)s.glue(h, t);
    const Face f = *s.create(Point(0), Point(1), Point(2));
    (void)s.destroy(f);
    for (int i = 0; i < 4; ++i) EXPECT_TRUE(s.flip(h));
    const auto on_edge = s.split(h, Point(3));
    EXPECT_TRUE(on_edge && s.weld(*on_edge));
    const auto in_face = s.split(Face(9), Point(3));
    EXPECT_TRUE(in_face && s.weld(*in_face));
    const HalfEdge corner = s.star_half_edge(far);
    const auto edge = split_vertex(s, corner, s.sym(lprev(s.sym(lprev(corner)))), Point(3));
    EXPECT_TRUE(edge && collapse(s, *edge));
    std::uint32_t sum = 0;
    for (const Vertex v : s.vertices())
      for (const HalfEdge x : s.star(v)) sum += s.dest(x).index();
    for (const Vertex v : s.vertices())
      for (const Vertex x : s.adjacent_vertices(v)) sum += x.index();
    for (const HalfEdge x : s.edges()) sum += x.index();
    return sum;
  };
  for (int i = 0; i < 4; ++i) round();  // a collapse may give back another vertex than was split
  const long before = test::memory::made;
  const std::uint32_t first = round();
  for (int i = 0; i < 3; ++i) round();
  EXPECT_EQ(test::memory::made, before);
  EXPECT_NE(first, 0u);
}

}  // namespace
}  // namespace clers
