// Every array corrupted: validate() says which invariant fails, and always comes back.
#include "topology/validate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "topology/derived.h"
#include "topology/test/meshes.h"

namespace clers {

/// Opens the arrays of a surface.
struct SurfacePeer {
  Surface& s;

  auto& org() { return s.org_; }
  auto& twin() { return s.twin_; }
  auto& nodes() { return s.rings_.nodes_; }
  auto& node() { return s.node_; }
  auto& component() { return s.component_; }
  auto& star() { return s.star_; }
  auto& corners() { return s.corners_; }
  auto& ring() { return s.ring_; }
  auto& counts() { return s.counts_; }
  auto& total() { return s.total_; }
  auto& free_faces() { return s.faces_.free_; }
  auto& free_vertices() { return s.vertices_.free_; }
  auto& free_curves() { return s.curves_.free_; }
  auto& free_components() { return s.components_.free_; }
  auto& free_nodes() { return s.rings_.pool_.free_; }

  std::uint32_t node_of(HalfEdge h) { return s.node(h).index(); }
};

namespace {

/// A component with a handle, a hole and a rim, one triangle, and free ids of every kind.
Surface sample() {
  Surface s = test::chain_of_tori(2, 4);
  EXPECT_TRUE(detach(s, Face(9)));
  EXPECT_TRUE(detach(s, Face(40)));
  for (std::uint32_t i = 0; i < 5; ++i) EXPECT_TRUE(s.create(Point(0), Point(1), Point(2)));
  EXPECT_TRUE(detach(s, Face(9)));
  EXPECT_TRUE(detach(s, Face(40)));
  EXPECT_EQ(s.characteristic().g, 2);
  EXPECT_TRUE(validate(s).empty());
  return s;
}

bool reports(const std::vector<Fault>& faults, Invariant i, std::uint32_t element) {
  return std::find(faults.begin(), faults.end(), Fault{i, element}) != faults.end();
}

/// Changes a fresh sample and expects this fault.
template <class Change>
void expect(Invariant i, std::uint32_t element, Change change) {
  Surface s = sample();
  change(SurfacePeer{s});
  const std::vector<Fault> faults = validate(s, 1000);
  EXPECT_TRUE(reports(faults, i, element)) << "expected " << describe(Fault{i, element}) << ", got "
                                           << (faults.empty() ? "nothing" : describe(faults[0]));
}

TEST(Validate, NamesTheInvariantAndTheElement) {
  const Surface s = sample();
  std::uint32_t inside = 0, rim = 0;
  while (!s.twins()[inside]) ++inside;
  while (!s.is_live(HalfEdge(rim)) || !s.is_boundary(HalfEdge(rim)) ||
         s.length(s.curve(HalfEdge(rim))) < 3)
    ++rim;
  const HalfEdge h(inside), b(rim);
  const std::uint32_t v = s.org(h).index();
  const Curve c = s.curve(b);
  Surface copy = s;
  SurfacePeer peer{copy};
  const std::uint32_t root = peer.node_of(s.on_curve(c)), rim_vertex = s.org(b).index();
  const std::uint32_t leaf = [&] {
    for (const HalfEdge x : s.boundary(c))
      if (x != s.on_curve(c)) return peer.node_of(x);
    return 0u;
  }();
  ASSERT_FALSE(peer.free_nodes().empty());
  const std::uint32_t free_node = peer.free_nodes().front().index();
  const internal::RingNode spare(free_node);
  const Component k = s.component(left(h));

  expect(Invariant::array_sizes, s.half_edge_limit() - 1,
         [](SurfacePeer p) { p.org().pop_back(); });
  expect(Invariant::array_sizes, s.vertex_limit() + 1,
         [](SurfacePeer p) { p.star().emplace_back(); });
  expect(Invariant::face_pool, 9, [](SurfacePeer p) { std::erase(p.free_faces(), Face(9)); });
  expect(Invariant::face_pool, 9, [](SurfacePeer p) { p.free_faces().push_back(Face(9)); });
  expect(Invariant::face_pool, 0, [](SurfacePeer p) { p.free_faces().push_back(Face(0)); });
  expect(Invariant::vertex_pool, v, [&](SurfacePeer p) { p.free_vertices().push_back(Vertex(v)); });
  expect(Invariant::vertex_pool, ~0u, [](SurfacePeer p) { p.free_vertices().emplace_back(); });
  expect(Invariant::curve_pool, c.index(), [&](SurfacePeer p) { p.free_curves().push_back(c); });
  expect(Invariant::component_pool, k.index(),
         [&](SurfacePeer p) { p.free_components().push_back(k); });
  expect(Invariant::origin_is_live, inside, [&](SurfacePeer p) { p.org()[inside] = Vertex(9999); });
  expect(Invariant::origin_is_live, 27, [&](SurfacePeer p) { p.org()[27] = Vertex(v); });
  expect(Invariant::twin_in_range, inside,
         [&](SurfacePeer p) { p.twin()[inside] = HalfEdge(9999); });
  expect(Invariant::twin_in_range, inside, [&](SurfacePeer p) { p.twin()[inside] = HalfEdge(27); });
  expect(Invariant::twin_is_mutual, inside, [&](SurfacePeer p) { p.twin()[inside] = h; });
  expect(Invariant::twin_is_mutual, s.sym(h).index(),
         [&](SurfacePeer p) { p.twin()[inside] = HalfEdge(); });
  expect(Invariant::twin_is_opposite, inside,
         [&](SurfacePeer p) { p.org()[inside] = s.org(lprev(h)); });
  expect(Invariant::star_leaves_vertex, v, [&](SurfacePeer p) { p.star()[v] = lnext(h); });
  expect(Invariant::star_on_boundary, s.org(b).index(),
         [&](SurfacePeer p) { p.star()[s.org(b).index()] = s.sym(lprev(b)); });
  expect(Invariant::corner_count, v, [&](SurfacePeer p) { ++p.corners()[v]; });
  expect(Invariant::one_fan, s.org(b).index(), [&](SurfacePeer p) {
    // Two boundary vertices of a curve under one name.
    const Vertex from = s.org(s.boundary_next(s.boundary_next(b))), to = s.org(b);
    for (Vertex& x : p.org())
      if (x == from) x = to;
    p.corners()[to.index()] += p.corners()[from.index()];
    p.corners()[from.index()] = 0;
    p.star()[from.index()] = HalfEdge();
    p.free_vertices().push_back(from);
  });
  expect(Invariant::node_pool, free_node,
         [&](SurfacePeer p) { std::erase(p.free_nodes(), spare); });
  expect(Invariant::node_pool, free_node, [&](SurfacePeer p) { p.free_nodes().push_back(spare); });
  expect(Invariant::node_pool, leaf, [&](SurfacePeer p) { p.free_nodes().emplace_back(leaf); });
  expect(Invariant::node_pool, free_node, [&](SurfacePeer p) { p.nodes()[free_node].size = 1; });
  expect(Invariant::ring_links, leaf,
         [&](SurfacePeer p) { p.nodes()[leaf].parent = internal::RingNode(9999); });
  expect(Invariant::ring_links, leaf,
         [&](SurfacePeer p) { p.nodes()[leaf].parent = internal::RingNode(leaf); });
  expect(Invariant::ring_links, free_node,
         [&](SurfacePeer p) { p.nodes()[free_node].lower = internal::RingNode(leaf); });
  expect(Invariant::ring_members, v,
         [&](SurfacePeer p) { p.node()[v] = internal::RingNode(leaf); });
  expect(Invariant::ring_members, rim_vertex,
         [&](SurfacePeer p) { p.node()[rim_vertex] = internal::RingNode(); });
  expect(Invariant::ring_members, rim_vertex,
         [&](SurfacePeer p) { p.node()[rim_vertex] = internal::RingNode(9999); });
  // Two vertices on one node, so that another has leaked.
  expect(Invariant::ring_members, rim_vertex, [&](SurfacePeer p) {
    p.node()[rim_vertex] = p.node()[s.org(s.boundary_next(b)).index()];
  });
  expect(Invariant::ring_shape, root, [&](SurfacePeer p) { ++p.nodes()[root].size; });
  expect(Invariant::curve_names, c.index(),
         [&](SurfacePeer p) { p.ring()[c.index()] = internal::RingNode(leaf); });
  expect(Invariant::curve_names, c.index(), [&](SurfacePeer p) { p.nodes()[leaf].curve = c; });
  expect(Invariant::component_labels, left(h).index(),
         [&](SurfacePeer p) { p.component()[left(h).index()] = Component(9999); });
  expect(Invariant::component_labels, left(s.sym(h)).index(), [&](SurfacePeer p) {
    for (const Component other : s.components())
      if (other != k) p.component()[left(h).index()] = other;
  });
  expect(Invariant::component_counts, k.index(), [&](SurfacePeer p) {
    ++p.counts()[k.index()].v;
    ++p.total().v;
  });
  expect(Invariant::euler_poincare, k.index(), [&](SurfacePeer p) {
    ++p.counts()[k.index()].g;
    ++p.total().g;
  });
  expect(Invariant::total_counts, 3, [](SurfacePeer p) { --p.total().b; });
}

TEST(Validate, RingThatRunsTheWrongWay) {
  // The tree of a curve mirrored: links, sizes and priorities stay right, the order does not.
  Surface s = test::grid(3, 3);
  SurfacePeer p{s};
  for (internal::Rings::Node& n : p.nodes()) std::swap(n.lower, n.upper);
  const auto faults = validate(s);
  ASSERT_FALSE(faults.empty());
  EXPECT_EQ(faults[0].invariant, Invariant::ring_order);
}

TEST(Validate, LabelSharedByTwoComponents) {
  Surface s;
  ASSERT_TRUE(s.create(Point(0), Point(1), Point(2)));
  ASSERT_TRUE(s.create(Point(0), Point(1), Point(2)));
  SurfacePeer p{s};
  p.component()[1] = p.component()[0];
  EXPECT_TRUE(reports(validate(s), Invariant::component_connected, 0));
}

/// Anything at all in any array, one place or many: validate() ends without touching what is not
/// there (the sanitizers look), and is silent only when nothing is wrong.
TEST(Validate, AnythingAnywhere) {
  std::mt19937 random(5);
  const Surface good = sample();
  const auto any = [&](std::uint32_t limit) {
    switch (random() % 4) {
      case 0: return Vertex::null_index;
      case 1: return static_cast<std::uint32_t>(random());
      default: return static_cast<std::uint32_t>(random() % (limit + 1));
    }
  };
  const auto put = [&](auto& array, std::uint32_t limit) {
    auto& slot = array[random() % array.size()];
    const auto old = slot;
    slot = std::decay_t<decltype(slot)>(any(limit));
    return slot != old;
  };
  int silent = 0;
  for (int round = 0; round < 20'000; ++round) {
    Surface s = good;
    SurfacePeer p{s};
    const std::uint32_t n = s.half_edge_limit();
    const auto nodes = static_cast<std::uint32_t>(p.nodes().size());
    bool changed = false;
    const int places = round % 2 == 0 ? 1 : 5;
    bool star_only = true;
    for (int i = 0; i < places; ++i) {
      const auto array = random() % 10;
      bool one = false;
      auto& node = p.nodes()[random() % nodes];
      const internal::Rings::Node old = node;
      switch (array) {
        case 0: one = put(p.org(), s.vertex_limit()); break;
        case 1: one = put(p.twin(), n); break;
        case 2: one = put(p.star(), n); break;
        case 3: one = put(p.corners(), 10); break;
        case 4: one = put(p.component(), 8); break;
        case 5: one = put(p.ring(), nodes); break;
        case 6:
          (random() % 2 ? node.lower : node.upper) = internal::RingNode(any(nodes));
          one = node.lower != old.lower || node.upper != old.upper;
          break;
        case 7:
          node.parent = internal::RingNode(any(nodes));
          one = node.parent != old.parent;
          break;
        case 8: one = put(p.node(), nodes); break;
        default:
          node.size = any(20);
          node.curve = Curve(any(8));
          node.vertex = Vertex(any(s.vertex_limit()));
          one = node.size != old.size || node.curve != old.curve || node.vertex != old.vertex;
          break;
      }
      changed = changed || one;
      star_only = star_only && (array == 2 || !one);
    }
    const bool clean = validate(s).empty();
    if (!changed) {
      EXPECT_TRUE(clean);
    }
    // An interior vertex may choose its star; everything else is determined.
    if (clean && changed) {
      EXPECT_TRUE(star_only || places > 1) << "round " << round;
      ++silent;
    }
  }
  EXPECT_LT(silent, 1000);
}

}  // namespace
}  // namespace clers
