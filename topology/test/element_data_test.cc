// Containers that follow a surface, through random edits of every kind.
#include "topology/element_data.h"

#include <gtest/gtest.h>

#include <memory>
#include <random>
#include <utility>

#include "topology/derived.h"
#include "topology/dump.h"
#include "topology/equivalence.h"
#include "topology/stellar.h"
#include "topology/test/meshes.h"
#include "topology/validate.h"

namespace clers {
namespace {

/// The points of a side's ends.
struct Ends {
  Point org, dest;
  friend bool operator==(const Ends&, const Ends&) = default;
};

/// Edits a surface at random, with containers of each kind attached. A point is what the values of
/// a vertex must be like (surface.h keeps it), and every new vertex gets one of its own.
class Edited {
 public:
  explicit Edited(std::uint32_t seed) : random_(seed) {}

  void step(int kind) {
    remember_sides();
    const auto observe = [this](const Change& change) { changed(change); };
    const std::uint32_t faces = static_cast<std::uint32_t>(surface_.characteristic().f);
    if (faces < 4 || (kind < 6 && faces < 60)) {
      const Face f = *surface_.create(next(), next(), next());
      for (const HalfEdge h : surface_.star(f)) name(surface_.org(h));
      root_[f] = ++roots_;
      expected_root_.resize(std::max<std::size_t>(expected_root_.size(), surface_.face_limit()));
      expected_root_[f.index()] = roots_;
    } else if (kind < 30) {
      (void)surface_.glue(any(), any());
    } else if (kind < 36) {
      (void)surface_.unglue(any());
    } else if (kind < 40) {
      ASSERT_TRUE(detach(surface_, any()));
    } else if (kind < 60) {
      const HalfEdge h = any();
      if (const auto done = flip(surface_, h, observe); done) turned_ = {h, surface_.sym(h)};
    } else if (kind < 72) {
      const HalfEdge h = any();
      const std::array<HalfEdge, 2> sides{h, surface_.sym(h)};
      if (const auto v = split(surface_, h, next(), observe); v) {
        cut_ = sides;
        name(*v);
      }
    } else if (kind < 80) {
      if (const auto v = split(surface_, left(any()), next(), observe); v) name(*v);
    } else if (kind < 97) {
      const HalfEdge h = any();
      if (surface_.can_weld(h)) {
        const Change change = Change::of_weld(surface_, h);
        for (const Change::Slot& slot : change.slots())
          if (slot.side) welded_.emplace_back(slot.at, slot.side);
        ASSERT_TRUE(surface_.weld(h));
      }
    } else {
      compress();
    }
    check();
  }

 private:
  HalfEdge any() {
    for (;;) {
      const HalfEdge h(static_cast<std::uint32_t>(random_() % surface_.half_edge_limit()));
      if (surface_.is_live(h)) return h;
    }
  }
  Point next() { return Point(++points_); }
  void name(Vertex v) {
    EXPECT_EQ(point_[v], Point()) << "a new vertex has the initial value";
    point_[v] = surface_.point(v);
  }
  Ends ends(HalfEdge h) const {
    return {surface_.point(surface_.org(h)), surface_.point(surface_.dest(h))};
  }
  void remember_sides() {
    turned_ = {};
    cut_ = {};
    welded_.clear();
    stellar_ = false;
    for (const Face f : surface_.faces())
      for (const HalfEdge h : surface_.star(f)) {
        side_[h] = h;
        was_.resize(std::max<std::size_t>(was_.size(), surface_.half_edge_limit()));
        was_[h.index()] = ends(h);
      }
  }
  /// Of flips and splits.
  void changed(const Change& change) {
    stellar_ = true;
    for (const Change::Part& part : change.parts()) {
      expected_root_.resize(std::max<std::size_t>(expected_root_.size(), part.face.index() + 1));
      expected_root_[part.face.index()] = expected_root_[part.of.index()];
    }
  }

  void compress() {
    const Surface before = surface_;
    const Compressed to = surface_.compress();
    ASSERT_EQ(surface_.face_limit(), surface_.characteristic().f);
    ASSERT_EQ(surface_.vertex_limit(), surface_.characteristic().v);
    ASSERT_EQ(to.faces.size(), before.face_limit());
    ASSERT_EQ(to.vertices.size(), before.vertex_limit());
    std::vector<std::uint32_t> roots(surface_.face_limit());
    std::uint32_t next_face = 0, next_vertex = 0;
    for (std::uint32_t i = 0; i < to.faces.size(); ++i) {
      const Face f(i);
      ASSERT_EQ(bool(to.faces[i]), before.is_live(f));
      if (!to.faces[i]) continue;
      ASSERT_EQ(to.faces[i], Face(next_face++));
      roots[to.faces[i].index()] = expected_root_[i];
      for (const HalfEdge h : before.star(f)) {
        const HalfEdge image = half_edge(to.faces[i], corner(h));
        ASSERT_EQ(surface_.org(image), to.vertices[before.org(h).index()]);
        const HalfEdge twin = before.sym(h);
        ASSERT_EQ(surface_.sym(image),
                  twin ? half_edge(to.faces[left(twin).index()], corner(twin)) : HalfEdge());
        ASSERT_EQ(before.star_half_edge(before.org(h)) == h,
                  surface_.star_half_edge(surface_.org(image)) == image);
        if (!twin) {
          ASSERT_EQ(surface_.curve(image), to.curves[before.curve(h).index()]);
        }
      }
      ASSERT_EQ(surface_.component(to.faces[i]), to.components[before.component(f).index()]);
    }
    for (const Vertex v : before.vertices()) {
      ASSERT_EQ(to.vertices[v.index()], Vertex(next_vertex++));
      ASSERT_EQ(surface_.point(to.vertices[v.index()]), before.point(v));
    }
    for (const Component k : before.components())
      ASSERT_EQ(surface_.characteristic(to.components[k.index()]), before.characteristic(k));
    expected_root_ = roots;
  }

  void check() {
    ASSERT_TRUE(validate(surface_).empty());
    ASSERT_EQ(point_.values().size(), surface_.vertex_limit());
    ASSERT_EQ(root_.values().size(), surface_.face_limit());
    ASSERT_EQ(side_.values().size(), surface_.half_edge_limit());
    for (const Vertex v : surface_.vertices()) ASSERT_EQ(point_[v], surface_.point(v));
    for (const Face f : surface_.faces()) ASSERT_EQ(root_[f], expected_root_[f.index()]);
    check_sides();
  }

  /// Sides have what they had before, which the ends of those that were not touched confirm; what
  /// has the initial value is new.
  void check_sides() {
    if (!stellar_ && welded_.empty()) return;
    std::size_t fresh = 0, halves = 0;
    for (const Face f : surface_.faces())
      for (const HalfEdge h : surface_.star(f)) {
        const HalfEdge kept = side_[h];
        if (h == turned_[0] || h == turned_[1]) {
          ASSERT_EQ(kept, h);
        } else if (!kept) {
          ++fresh;
        } else if (kept == cut_[0] || kept == cut_[1]) {
          ++halves;
        } else if (welded_.empty()) {
          ASSERT_EQ(was_[kept.index()], ends(h)) << "half-edge " << h.index();
        }
      }
    for (const auto& [at, was] : welded_) ASSERT_EQ(side_[at], was);
    if (cut_[0]) {
      ASSERT_EQ(halves, cut_[1] ? 4u : 2u);
      ASSERT_EQ(fresh, cut_[1] ? 4u : 2u);
    }
  }

  std::mt19937 random_;
  Surface surface_;
  VertexData<Point> point_{surface_};
  FaceData<std::uint32_t> root_{surface_};
  HalfEdgeData<HalfEdge> side_{surface_};
  std::vector<Ends> was_;  // by half-edge, before the operator
  std::vector<std::uint32_t> expected_root_;
  std::uint32_t points_ = 0, roots_ = 0;
  std::array<HalfEdge, 2> turned_;
  std::array<HalfEdge, 2> cut_;
  std::vector<std::pair<HalfEdge, HalfEdge>> welded_;
  bool stellar_ = false;
};

TEST(ElementData, FollowsRandomEdits) {
  for (std::uint32_t seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(seed);
    Edited edited(seed);
    std::mt19937 random(1000 + seed);
    for (int i = 0; i < 400 && !testing::Test::HasFailure(); ++i)
      edited.step(static_cast<int>(random() % 100));
  }
}

TEST(ElementData, CopiesOfAVertexHaveItsValueAndMergedOnesThatOfTheFirstEdge) {
  Surface s = test::grid(1, 1);
  VertexData<int> data(s, -1);
  for (const Vertex v : s.vertices()) data[v] = static_cast<int>(v.index());
  HalfEdge diagonal;
  for (const HalfEdge h : s.edges())
    if (!s.is_boundary(h)) diagonal = h;
  const HalfEdge twin = s.sym(diagonal);
  const int org = data[s.org(diagonal)], dest = data[s.dest(diagonal)];
  ASSERT_TRUE(s.unglue(diagonal));
  EXPECT_EQ(data[s.org(diagonal)], org);
  EXPECT_EQ(data[s.dest(twin)], org);
  EXPECT_EQ(data[s.dest(diagonal)], dest);
  data[s.org(diagonal)] = 70;
  data[s.dest(diagonal)] = 80;
  ASSERT_TRUE(s.glue(diagonal, twin));
  EXPECT_EQ(data[s.org(diagonal)], 70);
  EXPECT_EQ(data[s.org(twin)], 80);
  ASSERT_TRUE(s.unglue(diagonal));
  data[s.org(twin)] = 81;
  ASSERT_TRUE(s.glue(twin, diagonal));
  EXPECT_EQ(data[s.org(twin)], 81);
}

TEST(ElementData, AReusedIdHasTheInitialValue) {
  Surface s;
  FaceData<int> data(s, 5);
  VertexData<bool> seen(s, false);
  const Face f = *s.create(Point(0), Point(1), Point(2));
  EXPECT_EQ(data[f], 5);
  data[f] = 6;
  seen[s.org(half_edge(f, 0))] = true;
  ASSERT_TRUE(s.destroy(f));
  ASSERT_EQ(*s.create(Point(0), Point(1), Point(2)), f);
  EXPECT_EQ(data[f], 5);
  for (const Vertex v : s.vertices()) EXPECT_FALSE(seen[v]);
}

TEST(ElementData, StaysWithWhatItFollows) {
  auto s = std::make_unique<Surface>(test::grid(2, 2));
  VertexData<int> data(*s, 1);
  const VertexData<int> copy = data;
  { const VertexData<int> gone(*s, 2); }
  VertexData<int> moved = std::move(data);
  EXPECT_TRUE(moved.attached() && copy.attached());
  EXPECT_FALSE(data.attached());

  Surface other = *s;  // has no containers
  ASSERT_TRUE(other.create(Point(0), Point(1), Point(2)));
  EXPECT_EQ(moved.values().size(), 9u);

  Surface taken = std::move(*s);  // takes them along
  ASSERT_TRUE(taken.create(Point(0), Point(1), Point(2)));
  EXPECT_EQ(moved.values().size(), 12u);
  EXPECT_EQ(copy.values().size(), 12u);
  s.reset();
  EXPECT_TRUE(moved.attached());

  moved = copy;
  EXPECT_TRUE(moved.attached());
  taken = other;  // another surface: what followed the old one does not follow it
  EXPECT_FALSE(moved.attached() || copy.attached());
  EXPECT_EQ(moved.values().size(), 12u);
  ASSERT_TRUE(taken.create(Point(0), Point(1), Point(2)));
  EXPECT_EQ(moved.values().size(), 12u);

  auto brief = std::make_unique<Surface>(test::grid(1, 1));
  FaceData<int> left_over(*brief, 3);
  brief.reset();
  EXPECT_FALSE(left_over.attached());
  EXPECT_EQ(left_over[Face(1)], 3);
}

TEST(Compress, MakesIdsDenseAndKeepsStars) {
  Surface s = test::chain_of_tori(2, 5);
  for (std::uint32_t f = 0; f < 40; f += 3) ASSERT_TRUE(detach(s, Face(f)));
  const Surface before = s;
  const Compressed to = s.compress();
  EXPECT_EQ(s.face_limit(), s.characteristic().f);
  EXPECT_EQ(s.half_edge_limit(), 3 * s.face_limit());
  EXPECT_TRUE(validate(s).empty());
  EXPECT_TRUE(equivalent(before, s));
  EXPECT_FALSE(to.faces[0]);
  // Dense ids stay what they are.
  const std::string once = dump(s);
  const Compressed again = s.compress();
  EXPECT_EQ(dump(s), once);
  for (std::uint32_t i = 0; i < again.faces.size(); ++i) EXPECT_EQ(again.faces[i], Face(i));
  Surface nothing;
  EXPECT_TRUE(nothing.compress().faces.empty());
}

}  // namespace
}  // namespace clers
