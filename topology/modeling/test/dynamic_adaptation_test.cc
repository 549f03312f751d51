// Adaptation by queues beside scans of the whole mesh, and what it costs in calls of the priority.
#include "topology/modeling/dynamic_adaptation.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <limits>
#include <random>
#include <string>
#include <type_traits>
#include <vector>

#include "topology/dump.h"
#include "topology/modeling/labels.h"
#include "topology/modeling/test/bases.h"
#include "topology/validate.h"

namespace clers {
namespace {

using test::bases;

/// Values by vertex, and priorities that follow from those at the corners of a block: of the block
/// that is split or would be restored. Random and by no means smaller on finer blocks.
struct Field {
  std::vector<double> values;  // by vertex, for life
  std::uint64_t calls = 0;
  unsigned deepest = 9;

  double value(Vertex v) const { return v.index() < values.size() ? values[v.index()] : 0.4; }
  double block(std::array<Vertex, 2> ends, unsigned level) const {
    if (level >= deepest) return 0.5;
    return (value(ends[0]) + value(ends[1])) / 2;
  }
  double operator()(const MultiTriangulation& mesh, HalfEdge h) {
    ++calls;
    const Surface& s = mesh.surface();
    EXPECT_TRUE(s.is_live(h) && corner(h) == 1);
    EXPECT_TRUE(!mesh.is_block(h) || s.edge(h) == h);
    return block({s.org(h), s.dest(h)}, mesh.level(left(h)));
  }
  double operator()(const MultiTriangulation& mesh, Vertex v) {
    ++calls;
    const Surface& s = mesh.surface();
    EXPECT_TRUE(s.is_live(v) && mesh.can_weld(v));
    // The ends of the edge that a weld restores: those opposite each other, from the star on.
    std::array<Vertex, 2> ends;
    std::size_t i = 0;
    for (const Vertex u : s.adjacent_vertices(v)) {
      if (i == 0) ends[0] = u;
      if (i == 2) ends[1] = u;
      ++i;
    }
    return block(ends, mesh.level(v) - 1);
  }
};
/// By reference, so that the test sees the calls.
struct ByField {
  Field* field;
  template <class Id>
  double operator()(const MultiTriangulation& mesh, Id id) const {
    return (*field)(mesh, id);
  }
};

constexpr Thresholds thresholds{0.7, 0.3};

/// What adapt promises, by a scan of all.
void expect_adapted(const MultiTriangulation& mesh, Field field, Thresholds at) {
  const Surface& s = mesh.surface();
  ASSERT_TRUE(validate(s).empty());
  for (const Face f : s.faces()) {
    HalfEdge h = half_edge(f, 1);
    if (mesh.is_block(h)) h = s.edge(h);
    ASSERT_FALSE(field(mesh, h) > at.refine);
  }
  for (const Vertex v : s.vertices()) {
    if (mesh.can_weld(v)) {
      ASSERT_FALSE(field(mesh, v) < at.simplify);
    }
  }
}

TEST(DynamicAdaptation, KeepsItsPromiseWhateverChanges) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> value(0, 1);
  std::uint64_t refined = 0, simplified = 0;
  for (const test::Base& base : bases()) {
    SCOPED_TRACE(base.name);
    MultiTriangulation mesh = *MultiTriangulation::over(base.surface);
    Field field, other_field;
    for (int i = 0; i < 20'000; ++i) field.values.push_back(value(random));
    MultiTriangulation other = mesh;
    other_field = field;
    DynamicAdaptation dynamic(mesh, ByField{&field}, thresholds);
    DynamicAdaptation forgetful(other, ByField{&other_field}, thresholds);
    for (int step = 0; step < 12; ++step) {
      const auto order =
          step % 3 == 0 ? AdaptationOrder::refine_first : AdaptationOrder::simplify_first;
      const Adapted done = dynamic.adapt({}, NoObserver(), order);
      refined += done.refined, simplified += done.simplified;
      expect_adapted(mesh, field, thresholds);
      if (testing::Test::HasFatalFailure()) return;

      // That nothing else changed costs nothing and changes nothing.
      const std::uint64_t calls = field.calls;
      const Adapted again = dynamic.adapt({}, NoObserver(), order);
      EXPECT_EQ(again.refined + again.simplified, 0u);
      EXPECT_EQ(field.calls, calls);

      // One that looks at everything does the same.
      (void)forgetful.adapt({}, NoObserver(), order);
      ASSERT_EQ(dump(other.surface()), dump(mesh.surface())) << step;
      forgetful.all_changed();

      const std::uint32_t limit = mesh.surface().vertex_limit();
      const bool down = step % 2 == 1;
      for (std::uint32_t i = 0; i < 1 + limit / (down ? 1 : 20); ++i) {
        const Vertex v(static_cast<std::uint32_t>(random()) % limit);
        const double now = down ? value(random) * 0.4 : value(random);
        field.values[v.index()] = other_field.values[v.index()] = now;
        if (mesh.surface().is_live(v)) dynamic.changed(v);
      }
    }
  }
  EXPECT_GT(refined, 2000u);
  EXPECT_GT(simplified, 1000u);
}

/// The edge between two quadrilaterals is to be split, one of them to be welded. Whichever that is
/// takes the edge's other side away, then is split again since the edge needs it.
TEST(DynamicAdaptation, AnEdgeWaitsOnWhenItsOtherSideIsWelded) {
  for (const std::uint32_t welded : {0u, 1u}) {
    MultiTriangulation mesh = *MultiTriangulation::over(bases()[13].surface);
    const std::array<Vertex, 2> made{*mesh.refine(half_edge(Face(0), 1)),
                                     *mesh.refine(half_edge(Face(2), 1))};
    const auto priority = [&](const MultiTriangulation& m, auto id) {
      if constexpr (std::is_same_v<decltype(id), Vertex>)
        return id == made[welded] ? 0. : 0.5;
      else
        return m.level(left(id)) == 1 && !m.surface().is_boundary(id) ? 1. : 0.5;
    };
    DynamicAdaptation dynamic(mesh, priority, thresholds);
    const Adapted done = dynamic.adapt();
    EXPECT_EQ(done.simplified, 1u);
    EXPECT_EQ(done.refined, 2u);
  }
}

TEST(DynamicAdaptation, TremblingWithinTheBandChangesNothing) {
  MultiTriangulation mesh = *MultiTriangulation::over(bases()[12].surface);
  Field field;
  std::mt19937 random(6);
  std::uniform_real_distribution<double> value(0, 1), band(0.31, 0.69);
  field.values.resize(50'000);
  for (double& x : field.values) x = value(random);
  DynamicAdaptation dynamic(mesh, ByField{&field}, thresholds);
  (void)dynamic.adapt();
  ASSERT_GT(mesh.surface().characteristic().f, 200);
  for (double& x : field.values) x = band(random);
  for (int i = 0; i < 5; ++i) {
    dynamic.all_changed();
    const Adapted done = dynamic.adapt();
    EXPECT_EQ(done.refined + done.simplified, 0u);
    for (double& x : field.values) x = band(random);
  }
  // Another band is another matter.
  dynamic.set_thresholds({0.5, 0.45});
  EXPECT_EQ(dynamic.thresholds().refine, 0.5);
  EXPECT_GT(dynamic.adapt().refined, 0u);
  expect_adapted(mesh, field, dynamic.thresholds());
}

TEST(DynamicAdaptation, NaNIsNeitherSplitNorWelded) {
  MultiTriangulation mesh = *MultiTriangulation::over(bases()[12].surface);
  Field field;
  field.values.assign(50'000, 1);
  field.deepest = 4;
  DynamicAdaptation dynamic(mesh, ByField{&field}, thresholds);
  EXPECT_EQ(dynamic.adapt().refined, 90u);
  for (const double all : {std::numeric_limits<double>::quiet_NaN(), 1., 0.}) {
    field.values.assign(50'000, all);
    field.deepest = 9;
    dynamic.all_changed();
    const Adapted done = dynamic.adapt();
    EXPECT_EQ(done.refined, all == 1 ? 6u * 511 - 90 : 0u);
    EXPECT_EQ(done.simplified, all == 0 ? 6u * 511 : 0u);
  }
  field.values[3] = std::numeric_limits<double>::infinity();
  dynamic.all_changed();
  EXPECT_GT(dynamic.adapt().refined, 0u);
}

/// The same priorities everywhere: what is done first is decided by ids alone.
TEST(DynamicAdaptation, EqualPrioritiesAreDoneInOneOrder) {
  std::vector<std::string> dumps;
  for (int run = 0; run < 2; ++run) {
    MultiTriangulation mesh = *MultiTriangulation::over(bases()[12].surface);
    Field field;
    field.values.assign(50'000, 1);
    DynamicAdaptation dynamic(mesh, ByField{&field}, thresholds);
    AdaptationLimits limits;
    limits.faces = 301;  // stops it among equals
    const Adapted done = dynamic.adapt(limits);
    EXPECT_TRUE(done.face_limit);
    dumps.push_back(dump(mesh.surface()));
    // The limit raised, it goes on; without being asked anything that it was asked before.
    limits.faces = 1000;
    const std::uint64_t calls = field.calls;
    const Adapted more = dynamic.adapt(limits);
    EXPECT_GT(more.refined, 300u);
    EXPECT_LT(field.calls - calls, 8 * more.refined);
    const std::uint64_t before = field.calls;
    EXPECT_TRUE(dynamic.adapt(limits).face_limit);
    EXPECT_EQ(field.calls, before);
    const Adapted rest = dynamic.adapt();
    EXPECT_TRUE(rest.complete());
    expect_adapted(mesh, field, thresholds);
    EXPECT_EQ(mesh.surface().characteristic().f, 12 << 9);
  }
  EXPECT_EQ(dumps[0], dumps[1]);
}

/// Not the whole mesh: what was reported, and what was done.
TEST(DynamicAdaptation, CallsArePerChangeNotPerFace) {
  for (const unsigned level : {6u, 9u, 12u}) {
    MultiTriangulation mesh = *MultiTriangulation::over(bases()[12].surface);
    Field field;
    field.values.assign(300'000, 0.5);
    for (std::size_t i = 0; i < 8; ++i) field.values[i] = 1;
    field.deepest = 20;
    (void)adapt_refine(
        mesh, [&](const MultiTriangulation& m, HalfEdge h) { return m.level(left(h)) < level; });
    DynamicAdaptation dynamic(mesh, ByField{&field}, Thresholds{0.6, 0.4});
    (void)dynamic.adapt();
    std::mt19937 random(8);
    for (int step = 0; step < 20; ++step) {
      std::vector<Vertex> up;
      for (int i = 0; i < 10; ++i)
        up.emplace_back(static_cast<std::uint32_t>(random()) % mesh.surface().vertex_limit());
      for (const double now : {1., 0., 0.5}) {
        for (const Vertex v : up) {
          field.values[v.index()] = now;
          if (mesh.surface().is_live(v)) dynamic.changed(v);
        }
        const std::uint64_t before = field.calls;
        const Adapted done = dynamic.adapt();
        EXPECT_LE(field.calls - before, 25 * up.size() + 14 * (done.refined + done.simplified))
            << level;
      }
    }
  }
}

TEST(DynamicAdaptation, AnExceptionMakesEverythingChanged) {
  MultiTriangulation mesh = *MultiTriangulation::over(bases()[12].surface);
  Field field;
  std::mt19937 random(9);
  std::uniform_real_distribution<double> value(0, 1);
  field.values.resize(50'000);
  for (double& x : field.values) x = value(random);
  DynamicAdaptation dynamic(mesh, ByField{&field}, thresholds);
  for (int after = 1; after < 40; ++after) {
    int left = after;
    const auto observer = [&](const auto& change) {
      if constexpr (std::is_same_v<decltype(change), const Refined&>)
        if (--left == 0) throw change.made;
      if constexpr (std::is_same_v<decltype(change), const Simplified&>)
        if (--left == 0) throw change.gone;
    };
    for (double& x : field.values) x = value(random);
    dynamic.all_changed();
    EXPECT_THROW((void)dynamic.adapt({}, observer), Vertex);
    (void)dynamic.adapt();
    expect_adapted(mesh, field, thresholds);
  }
}

}  // namespace
}  // namespace clers
