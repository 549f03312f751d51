// The front beside a full surface: random moves on which they agree, and faults that must show.
#include "topology/mirror.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "topology/front.h"

namespace clers::internal {
namespace {

using test_front = Front<BuildingMirror>;

/// Spirale Reversi with dice for a stream.
class RandomBuilding {
 public:
  explicit RandomBuilding(std::uint32_t seed)
      : random_(seed), links_(most), mirror_(most), front_(links_.data(), mirror_) {
    gate_ = front_.create(next_face(), 0, corners_);
    made_ = 3;
    keep();
  }
  RandomBuilding(const RandomBuilding& o)
      : random_(o.random_),
        links_(o.links_),
        mirror_(o.mirror_),
        front_(links_.data(), mirror_),
        gate_(o.gate_),
        pending_(o.pending_),
        waiting_(o.waiting_),
        holes_(o.holes_),
        faces_(o.faces_),
        merged_(o.merged_),
        made_(o.made_) {}

  const BuildingMirror& mirror() const { return mirror_; }
  std::vector<FrontLink>& links() { return links_; }
  bool full() const { return made_ + 3 > most; }

  void step() {
    switch (random(18)) {
      case 0:
      case 1:
      case 2:
      case 3:
      case 4: return c();
      case 5:
      case 6:
      case 7: return l();
      case 8:
      case 9: return r();
      case 10: return e();
      case 11:
      case 12: return s();
      case 13: return split(true);
      case 14: return split(false);
      default: return join();
    }
  }
  void c() {
    if (front_.prev(gate_.x) == gate_.y) return l();
    gate_ = front_.attach_zip(gate_, next_face(), corners_);
    keep();
  }
  void l() {
    gate_ = front_.attach_keep_left(gate_, next_face(), made_++, corners_);
    keep();
  }
  void r() {
    gate_ = front_.attach_keep_right(gate_, next_face(), made_++, corners_);
    keep();
  }
  void e() {
    pending_.push_back(gate_);
    gate_ = front_.create(next_face(), made_, corners_);
    made_ += 3;
    keep();
  }
  void s() {
    if (pending_.empty()) return l();
    const test_front::Gate to = pending_.back();
    pending_.pop_back();
    glue(to.x, to.kx, to.y, to.ky, to.edge, HandleCase::join_components);
  }
  void split(bool hole) {
    const std::vector<std::uint32_t> curve = gate_curve();
    if (curve.size() < 5) return l();
    const std::size_t d = 2 + random(static_cast<std::uint32_t>(curve.size()) - 4);
    const std::uint32_t q = curve[d];
    glue_at(q, HandleCase::split_curve);
    (hole ? holes_ : waiting_).push_back(q);
  }
  void join() {
    if (waiting_.empty()) return c();
    const std::size_t which = random(static_cast<std::uint32_t>(waiting_.size()));
    std::uint32_t q = waiting_[which];
    for (std::uint32_t turns = random(7); turns > 0; --turns) q = front_.prev(q);
    waiting_.erase(waiting_.begin() + static_cast<std::ptrdiff_t>(which));
    glue_at(q, HandleCase::join_curves);
  }
  void end(bool close) {
    while (!pending_.empty()) s();
    while (!waiting_.empty()) join();
    while (close && front_.prev(gate_.x) != gate_.y) c();
    finish();
    if (close) front_.close(gate_);
  }
  void finish() { front_.end_component(gate_, holes_); }

  /// The front's vertices on the gate's curve, from x back to y.
  std::vector<std::uint32_t> gate_curve() const {
    std::vector<std::uint32_t> curve{gate_.x};
    while (curve.back() != gate_.y) curve.push_back(front_.prev(curve.back()));
    return curve;
  }
  const std::vector<std::uint32_t>& holes() const { return holes_; }

  /// By corner, those of the last face first: the vertex it is now.
  std::vector<std::uint32_t> vertices() const {
    std::vector<std::uint32_t> out;
    for (std::size_t f = faces_.size(); f-- > 0;)
      for (const std::uint32_t v : {faces_[f].a, faces_[f].b, faces_[f].v}) out.push_back(now(v));
    return out;
  }

 private:
  static constexpr std::uint32_t most = 400;

  std::uint32_t random(std::uint32_t n) { return static_cast<std::uint32_t>(random_() % n); }
  Face next_face() const { return Face(static_cast<std::uint32_t>(faces_.size())); }
  void keep() { faces_.push_back(corners_); }
  std::uint32_t now(std::uint32_t v) const {
    for (std::size_t i = 0; i < merged_.size(); ++i)
      if (merged_[i].first == v) v = merged_[i].second;
    return v;
  }
  void glue_at(std::uint32_t q, HandleCase as) {
    const std::uint32_t p = front_.prev(q);
    glue(p, links_[p].valence, q, links_[q].valence, front_.edge_into(q), as);
  }
  void glue(std::uint32_t p, std::uint32_t kp, std::uint32_t q, std::uint32_t kq, HalfEdge pq,
            HandleCase as) {
    const std::uint32_t x = gate_.x;
    gate_ = front_.attach_glue(gate_, next_face(), p, kp, q, kq, pq, as, corners_);
    merged_.emplace_back(x, q);
    keep();
  }

  std::mt19937 random_;
  std::vector<FrontLink> links_;
  BuildingMirror mirror_;
  test_front front_;
  test_front::Gate gate_;
  test_front::Corners corners_{};
  std::vector<test_front::Gate> pending_;
  std::vector<std::uint32_t> waiting_, holes_;
  std::vector<test_front::Corners> faces_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> merged_;
  std::uint32_t made_ = 0;
};

TEST(Mirror, AgreesWithRandomBuildings) {
  std::int64_t handles = 0, holes = 0, closed = 0;
  for (std::uint32_t seed = 0; seed < 400; ++seed) {
    SCOPED_TRACE(seed);
    RandomBuilding building(seed);
    for (std::uint32_t i = 0; i < 10 + seed % 90; ++i) {
      building.step();
      ASSERT_TRUE(building.mirror().agrees) << "step " << i;
    }
    building.end(seed % 2 == 0);
    ASSERT_TRUE(building.mirror().agrees);
    const Surface& surface = building.mirror().surface;
    EXPECT_EQ(surface.characteristic().s, 1);
    EXPECT_TRUE(validate(surface).empty());
    std::vector<std::uint32_t> vertices = building.vertices();
    EXPECT_TRUE(building.mirror().same_vertices(vertices));
    for (std::uint32_t f = 0; f < surface.characteristic().f; ++f)
      for (std::uint32_t i = 0; i < 3; ++i)
        EXPECT_EQ(surface.point(surface.org(half_edge(Face(f), i))),
                  Point(vertices[vertices.size() - 3 * (f + std::size_t{1}) + i]));
    vertices[vertices.size() / 2] = 999;
    EXPECT_FALSE(building.mirror().same_vertices(vertices));
    EXPECT_EQ(lambda(count_operators(building.mirror().trace)), surface.characteristic());
    handles += surface.genus();
    holes += static_cast<std::int64_t>(building.holes().size());
    closed += surface.characteristic().b == 0;
  }
  EXPECT_GT(handles, 300);
  EXPECT_GT(holes, 300);
  EXPECT_GT(closed, 50);
}

TEST(Mirror, FindsAWrongLinkAtOnce) {
  std::size_t tried = 0;
  for (std::uint32_t seed = 0; seed < 40; ++seed) {
    RandomBuilding building(seed);
    for (int i = 0; i < 25; ++i) building.step();
    ASSERT_TRUE(building.mirror().agrees);
    const std::vector<std::uint32_t> curve = building.gate_curve();
    for (std::size_t at = 0; at + 1 < curve.size(); ++at)  // y's own link is not in use
      for (const std::uint32_t wrong : {curve[0], curve[at], curve.back(), 0u, 397u}) {
        if (wrong == building.links()[curve[at]].prev) continue;
        for (const bool zip : {false, true}) {
          if (zip && curve.size() < 3) continue;
          if (zip && at == 0 && wrong == curve.back()) continue;  // no legal C any more
          RandomBuilding other = building;
          other.links()[curve[at]].prev = wrong;
          zip ? other.c() : other.l();
          ASSERT_FALSE(other.mirror().agrees)
              << "seed " << seed << " link " << at << " of " << curve.size() << " to " << wrong;
          ++tried;
        }
      }
  }
  EXPECT_GT(tried, 1000u);
}

TEST(Mirror, FindsAWrongLinkOfAHoleWhereTheComponentEnds) {
  RandomBuilding building(1);
  for (int i = 0; i < 12; ++i) building.l();
  building.split(true);
  building.l();
  ASSERT_TRUE(building.mirror().agrees);
  ASSERT_EQ(building.holes().size(), 1u);
  RandomBuilding right = building;
  right.finish();
  EXPECT_TRUE(right.mirror().agrees);
  const std::uint32_t hole = building.holes()[0];
  std::uint32_t v = hole;
  do {
    RandomBuilding wrong = building;
    wrong.links()[v].prev = building.links()[building.links()[v].prev].prev;
    wrong.l();
    EXPECT_TRUE(wrong.mirror().agrees) << "not on the gate's curve";
    wrong.finish();
    EXPECT_FALSE(wrong.mirror().agrees);
    v = building.links()[v].prev;
  } while (v != hole);
}

/// A glue that is said to be another case; and one at another vertex than is said.
TEST(Mirror, FindsWrongCasesAndWrongVertices) {
  std::vector<FrontLink> links(20);
  test_front::Corners c;
  const auto curve_of_four = [&](BuildingMirror& mirror, test_front& front) {
    auto gate = front.create(Face(0), 0, c);
    gate = front.attach_keep_left(gate, Face(1), 3, c);
    gate = front.attach_keep_left(gate, Face(2), 4, c);
    EXPECT_TRUE(mirror.agrees);
    return gate;
  };
  for (const HandleCase as :
       {HandleCase::join_components, HandleCase::split_curve, HandleCase::join_curves}) {
    BuildingMirror mirror(20);
    test_front front(links.data(), mirror);
    auto gate = curve_of_four(mirror, front);  // 4, 3, 0, 2, 1 from x back to y
    ASSERT_EQ(front.prev(4), 3u);
    ASSERT_EQ(front.prev(3), 0u);
    ASSERT_EQ(front.prev(0), 2u);
    gate = front.attach_glue(gate, Face(3), 2, 1, 0, 1, front.edge_into(0), as, c);
    EXPECT_EQ(mirror.agrees, as == HandleCase::split_curve) << name(as);
  }
  BuildingMirror mirror(20);
  test_front front(links.data(), mirror);
  auto gate = curve_of_four(mirror, front);
  (void)front.attach_glue(gate, Face(3), 3, 1, 0, 1, front.edge_into(0), HandleCase::split_curve,
                          c);  // 3 does not come before 0
  EXPECT_FALSE(mirror.agrees);
}

TEST(Mirror, AHandleMayJoinACurveOfAPartThatIsPending) {
  RandomBuilding building(2);
  for (int i = 0; i < 8; ++i) building.l();
  building.split(false);  // a curve waits
  building.e();           // in another component, so far
  for (int i = 0; i < 4; ++i) building.l();
  building.join();
  EXPECT_TRUE(building.mirror().agrees);
  EXPECT_EQ(building.mirror().trace.back(), static_cast<std::uint8_t>(HandleCase::join_components));
  RandomBuilding too_early = building;
  too_early.finish();  // an S is to come
  EXPECT_FALSE(too_early.mirror().agrees);
  building.s();
  EXPECT_TRUE(building.mirror().agrees);
  EXPECT_EQ(building.mirror().trace.back(), static_cast<std::uint8_t>(HandleCase::join_curves));
  building.end(true);
  EXPECT_TRUE(building.mirror().agrees);
  EXPECT_EQ(building.mirror().surface.genus(), 1);
}

}  // namespace
}  // namespace clers::internal
