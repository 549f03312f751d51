// Whole meshes adapted to tests: whatever the order, to a level; and where limits end it.
#include "topology/modeling/adapt.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <random>
#include <vector>

#include "topology/dump.h"
#include "topology/equivalence.h"
#include "topology/modeling/dynamic_adaptation.h"
#include "topology/modeling/labels.h"
#include "topology/modeling/test/bases.h"
#include "topology/validate.h"

namespace clers {
namespace {

using test::Base;
using test::bases;

MultiTriangulation over(const Surface& base) {
  return *MultiTriangulation::over(base);
}
MultiTriangulation cube() {
  return over(test::tri_quad_of(test::cube_sizes, test::cube_corners, 8));
}

const auto below = [](unsigned level) {
  return
      [level](const MultiTriangulation& mesh, HalfEdge h) { return mesh.level(left(h)) < level; };
};
const auto above = [](unsigned level) {
  return [level](const MultiTriangulation& mesh, Vertex v) { return mesh.level(v) > level; };
};
const auto always = [](const MultiTriangulation&, auto) { return true; };

/// Half a level, so that edges of level k - 1 are split for level k, and vertices above are welded.
struct ByLevel {
  unsigned level;
  double operator()(const MultiTriangulation& mesh, HalfEdge h) const {
    return double(level) - double(mesh.level(left(h))) - 0.5;
  }
  double operator()(const MultiTriangulation& mesh, Vertex v) const {
    return double(level) - double(mesh.level(v)) + 0.5;
  }
};

/// Refines and simplifies what comes next in a random order, until all is of the level.
void adapt_at_random(MultiTriangulation& mesh, unsigned level, std::mt19937& random) {
  const Surface& s = mesh.surface();
  for (bool changed = true; changed;) {
    changed = false;
    std::vector<std::uint32_t> order(s.half_edge_limit());
    std::iota(order.begin(), order.end(), 0u);
    std::shuffle(order.begin(), order.end(), random);
    for (const std::uint32_t i : order) {
      const HalfEdge h(i);
      const Vertex v(i);
      if (s.is_live(h) && corner(h) == 1 && below(level)(mesh, h))
        changed = bool(mesh.refine(h));
      else if (s.is_live(v) && above(level)(mesh, v))
        changed = bool(mesh.simplify(v));
    }
  }
}

void refine_at_random(MultiTriangulation& mesh, int calls, std::mt19937& random) {
  for (int i = 0; i < calls; ++i) {
    const HalfEdge h(static_cast<std::uint32_t>(random()) % mesh.surface().half_edge_limit());
    if (mesh.surface().is_live(h) && mesh.level(left(h)) < 9) (void)mesh.refine(h);
  }
}

struct NoGeometry {
  struct Value {};
  Value combine(std::span<const Term>) const { return {}; }
  void set(Vertex, Value) {}
};

TEST(Adapt, LeadsToTheUniformMeshOfALevelUpAndDown) {
  for (const Base& base : bases()) {
    SCOPED_TRACE(base.name);
    if (base.surface.characteristic().f > 100) continue;
    std::vector<Surface> uniform{base.surface};
    NoGeometry none;
    Creases smooth;
    const unsigned most = base.surface.characteristic().f > 12 ? 4 : 8;
    for (unsigned level = 0; level < most; ++level) {
      uniform.push_back(uniform.back());
      ASSERT_TRUE(subdivide_4_8(uniform.back(), none, smooth));
    }
    MultiTriangulation mesh = over(base.surface);
    std::vector<unsigned> levels(most + 1);
    std::iota(levels.begin(), levels.end(), 0u);
    levels.insert(levels.end(), {most / 2, most, 1, 0, 3, 2, most, 0});
    for (const unsigned level : levels) {
      const Adapted done = adapt(mesh, below(level), above(level));
      EXPECT_TRUE(done.complete());
      ASSERT_TRUE(validate(mesh.surface()).empty());
      const Characteristic &a = mesh.surface().characteristic(),
                           &b = uniform[level].characteristic();
      ASSERT_EQ(std::tie(a.v, a.e, a.f, a.b), std::tie(b.v, b.e, b.f, b.b));
      EXPECT_TRUE(equivalent(mesh.surface(), uniform[level]));
      const Adapted again = adapt(mesh, below(level), above(level));
      EXPECT_EQ(again.refined + again.simplified, 0u);
    }
    EXPECT_EQ(dump(mesh.surface()), dump(base.surface));
  }
}

TEST(Adapt, EveryOrderLeadsToTheSameMesh) {
  std::mt19937 random(11);
  for (const Base& base : bases()) {
    SCOPED_TRACE(base.name);
    if (base.surface.characteristic().f > 100) continue;
    const unsigned level = base.surface.characteristic().f > 12 ? 3 : 5;
    MultiTriangulation start = over(base.surface);
    refine_at_random(start, 30, random);
    std::vector<MultiTriangulation> ends(5, start);
    (void)adapt(ends[0], below(level), above(level));
    (void)adapt_simplify(ends[1], above(level));
    (void)adapt_refine(ends[1], below(level));
    adapt_at_random(ends[2], level, random);
    for (const AdaptationOrder order :
         {AdaptationOrder::simplify_first, AdaptationOrder::refine_first}) {
      MultiTriangulation& mesh = ends[order == AdaptationOrder::simplify_first ? 3 : 4];
      DynamicAdaptation dynamic(mesh, ByLevel{level}, Thresholds{0, 0});
      EXPECT_TRUE(dynamic.adapt({}, NoObserver(), order).complete());
      EXPECT_EQ(dynamic.adapt({}, NoObserver(), order).refined, 0u);
    }
    for (std::size_t i = 1; i < ends.size(); ++i)
      EXPECT_TRUE(equivalent(ends[0].surface(), ends[i].surface())) << i;
    EXPECT_TRUE(validate(ends[4].surface()).empty());
  }
}

TEST(Adapt, TestsThatNeverEndDoAtTheLimits) {
  MultiTriangulation mesh = cube();
  AdaptationLimits limits;
  limits.level = 6;
  Adapted done = adapt_refine(mesh, always, limits);
  EXPECT_TRUE(done.level_limit);
  EXPECT_FALSE(done.face_limit);
  EXPECT_EQ(mesh.surface().characteristic().f, 12 << 6);
  for (const std::uint32_t faces : {0u, 800u, 1001u, 2000u, 2001u}) {
    limits = {MultiTriangulation::max_level, faces};
    done = adapt_refine(mesh, always, limits);
    EXPECT_TRUE(done.face_limit);
    EXPECT_LE(mesh.surface().characteristic().f, std::max<std::int64_t>(faces, 12 << 6));
    EXPECT_GE(mesh.surface().characteristic().f + 1, faces);  // a split makes two: none fits
    EXPECT_TRUE(validate(mesh.surface()).empty());
  }
  // With a boundary, where a split makes one, to the face.
  MultiTriangulation half = over(test::random_base({}));
  for (std::uint32_t faces = 1; faces < 60; ++faces) {
    limits = {4, faces};
    done = adapt_refine(half, always, limits);
    ASSERT_LE(half.surface().characteristic().f, faces);
    // All that is left needs more than there is.
    for (const Face f : half.surface().faces()) {
      if (half.level(f) < 4) {
        ASSERT_GT(half.surface().characteristic().f + half.growth(half_edge(f, 1)).faces, faces);
      }
    }
    EXPECT_EQ(done.face_limit, faces < 16);
  }
  EXPECT_EQ(half.surface().characteristic().f, 16);
}

TEST(Adapt, PropagationNeverExceedsTheLimit) {
  std::mt19937 random(3);
  int stopped = 0;
  for (int round = 0; round < 60; ++round) {
    MultiTriangulation mesh = over(bases()[static_cast<std::size_t>(round) % 12].surface);
    const auto start = mesh.surface().characteristic().f;
    const AdaptationLimits limits{12, static_cast<std::uint32_t>(start + round * 3)};
    DynamicAdaptation dynamic(
        mesh, [&](const MultiTriangulation&, auto) { return static_cast<double>(random() % 1000); },
        Thresholds{300, -1});
    for (int call = 0; call < 3; ++call) {
      const Adapted done = dynamic.adapt(limits);
      ASSERT_LE(mesh.surface().characteristic().f, limits.faces);
      stopped += done.face_limit;
      dynamic.all_changed();
    }
  }
  EXPECT_GT(stopped, 100);
}

TEST(Adapt, SixtyLevelsAtAPoint) {
  for (const unsigned where : {0u, 1u, 2u}) {
    for (const auto& make : {cube, +[] { return over(test::random_base({})); }}) {
      MultiTriangulation mesh = make();
      Labels labels(mesh);
      const std::string base = dump(mesh.surface());
      const auto follow = [&](const auto& change) {
        if constexpr (std::is_same_v<decltype(change), const Refined&>)
          labels.refined(mesh.surface(), change);
        else if constexpr (std::is_same_v<decltype(change), const Simplified&>)
          labels.simplified(mesh.surface(), change);
      };
      // The faces at one corner, the finest first, until the finest refuse.
      const Vertex corner_vertex = mesh.surface().org(half_edge(Face(0), where));
      for (unsigned level = 0; level < MultiTriangulation::max_level; ++level) {
        const HalfEdge at = mesh.surface().star_half_edge(corner_vertex);
        ASSERT_TRUE(mesh.refine(half_edge(left(at), 1), follow)) << level;
      }
      ASSERT_TRUE(validate(mesh.surface()).empty());
      unsigned finest = 0;
      HalfEdge last;
      std::vector<Label> all;
      for (const Vertex v : mesh.surface().vertices()) {
        all.push_back(labels.of(mesh, v));
        finest = std::max(finest, mesh.level(v));
        EXPECT_EQ(all.back().level, mesh.level(v));
        const std::uint32_t lattice = std::uint32_t{1} << ((mesh.level(v) + 1) / 2);
        EXPECT_LE(std::max(all.back().i, all.back().j), lattice);
        if (mesh.level(v) > 0) {
          EXPECT_EQ((all.back().i | all.back().j) & 1u, 1u);  // a place of no coarser lattice
        }
      }
      std::sort(all.begin(), all.end());
      EXPECT_EQ(std::adjacent_find(all.begin(), all.end()), all.end());
      EXPECT_EQ(finest, MultiTriangulation::max_level);
      for (const Face f : mesh.surface().faces())
        if (mesh.level(f) == finest) last = half_edge(f, 1);
      const std::string before = dump(mesh.surface());
      for (const HalfEdge h : {last, lnext(last), lprev(last)}) {
        const auto refused = mesh.refine(h);
        ASSERT_FALSE(refused);
        EXPECT_EQ(refused.error(), (Violation{Precondition::levels_left, h.index()}));
      }
      EXPECT_EQ(dump(mesh.surface()), before);
      // Vertices of level 1 take all others with them.
      for (std::uint32_t i = 0; i < mesh.surface().vertex_limit(); ++i)
        if (const Vertex v(i); mesh.surface().is_live(v) && mesh.level(v) == 1) {
          ASSERT_TRUE(mesh.simplify(v, follow));
        }
      EXPECT_EQ(dump(mesh.surface()), base);
    }
  }
}

}  // namespace
}  // namespace clers
