// Operators undone and applied again: the same surface to the last id, and the same bits.
#include "topology/modeling/level_of_detail.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <string>

#include "topology/dump.h"
#include "topology/element_data.h"
#include "topology/modeling/test/solids.h"
#include "topology/test/meshes.h"
#include "topology/validate.h"

namespace clers::test {
namespace {

/// Random flips and welds, some of a degenerate kind, recorded; a text for each place.
TEST(OperatorLog, TakesAnySurfaceBackAndForth) {
  std::mt19937 random(3);
  std::map<StellarCase, int> welds;
  for (int round = 0; round < 60; ++round) {
    Surface s = round % 3 == 0 ? torus(3, 4) : round % 3 == 1 ? grid(4, 3) : chain_of_tori(2, 3);
    // Vertices that can be welded, in faces whose corners are any.
    for (std::uint32_t i = 0; i < 6; ++i) {
      const HalfEdge h(static_cast<std::uint32_t>(random() % s.half_edge_limit()));
      (void)(random() % 2 == 0 ? s.split(h, Point(100 + i)) : s.split(left(h), Point(100 + i)));
      const Face f(static_cast<std::uint32_t>(random() % s.face_limit()));
      (void)s.turn(f);
    }
    OperatorLog log;
    std::vector<std::string> texts{dump(s)};
    for (int i = 0; i < 150; ++i) {
      const HalfEdge h(static_cast<std::uint32_t>(random() % s.half_edge_limit()));
      if (s.can_weld(h) && random() % 2 == 0)
        ++welds[weld(s, h, log)->undone];
      else if (!flip(s, h, log))
        continue;
      ASSERT_EQ(log.place(), texts.size());
      texts.push_back(dump(s));
    }
    for (int i = 0; i < 300; ++i) {
      const bool back = i < 2 * static_cast<int>(log.size()) ? i < static_cast<int>(log.size())
                                                             : random() % 2 == 0;
      if (back ? log.place() == 0 : log.place() == log.size()) continue;
      back ? log.undo(s) : log.redo(s);
      ASSERT_EQ(dump(s), texts[log.place()]);
    }
    while (log.place() != 0) log.undo(s);
    EXPECT_TRUE(validate(s).empty());
    EXPECT_EQ(dump(s), texts[0]);
  }
  for (const auto kind :
       {StellarCase::face, StellarCase::interior_edge, StellarCase::boundary_edge})
    EXPECT_GT(welds[kind], 30) << name(kind);
}

TEST(OperatorLog, ForgetsWhatWasUndone) {
  Surface s = torus(4, 4);
  OperatorLog log;
  const std::string first = dump(s);
  ASSERT_TRUE(flip(s, HalfEdge(1), log));
  ASSERT_TRUE(flip(s, HalfEdge(30), log));
  log.undo(s);
  ASSERT_TRUE(flip(s, HalfEdge(7), log));
  EXPECT_EQ(log.size(), 2u);
  const std::string last = dump(s);
  log.undo(s), log.undo(s);
  EXPECT_EQ(dump(s), first);
  log.redo(s), log.redo(s);
  EXPECT_EQ(dump(s), last);
}

TEST(OperatorLog, ObserversFollow) {
  // Values of sides whose edges stay come back, whoever carries them.
  Surface s = grid(5, 4);
  const Vertex v = *s.split(half_edge(Face(13), 1), Point(99));
  OperatorLog log;
  std::vector<std::uint32_t> observed(s.half_edge_limit());
  HalfEdgeData<std::uint32_t> attached(s, 0);
  for (std::uint32_t i = 0; i < observed.size(); ++i) attached[HalfEdge(i)] = observed[i] = i;
  const auto follow = [&](const Change& change) {
    std::vector<std::uint32_t> values;
    for (const Change::Slot& slot : change.slots())
      values.push_back(slot.side ? observed[slot.side.index()] : 0);
    for (std::size_t i = 0; i < values.size(); ++i)
      observed[change.slots()[i].at.index()] = values[i];
  };
  const auto before = observed;
  ASSERT_TRUE(weld(s, s.star_half_edge(v), [&](const Change& c) { log(c), follow(c); }));
  log.undo(s, follow);
  for (const HalfEdge h : s.edges())
    for (const HalfEdge side : s.star(h)) {
      if (s.org(side) == v || s.dest(side) == v) continue;
      EXPECT_EQ(observed[side.index()], before[side.index()]);
      EXPECT_EQ(attached[side], before[side.index()]);
    }
}

/// Values of which positions are a part.
struct Marked {
  Position3 at{};
  std::string name;
  friend bool operator==(const Marked&, const Marked&) = default;
};

std::vector<Solid> solids() {
  std::vector<Solid> solids;
  solids.push_back(round_torus(12, 10));
  solids.push_back(field(10, [](double x, double y) { return std::sin(x) * std::cos(y); }));
  solids.push_back({chain_of_tori(3, 5), {}});
  std::mt19937 random(1);
  solids.back().at.resize(solids.back().surface.vertex_limit());
  for (Position3& p : solids.back().at)
    for (double& x : p) x = static_cast<double>(random() % 1000);
  return solids;
}

TEST(LevelOfDetail, AThousandTimesBackAndForth) {
  for (const Solid& whole : solids()) {
    LevelOfDetail<> levels(whole.surface, whole.at);
    // The levels as simplify() makes them, one by one.
    std::vector<std::string> texts{dump(whole.surface)};
    std::vector<std::vector<Position3>> at{whole.at};
    Creases none;
    Solid s = whole;
    Simplification simplification(s.surface, s.at, none, {});
    while (const auto c = simplification.next()) {
      contract(s.surface, none, *c);
      simplification.contracted(*c);
      texts.push_back(dump(s.surface)), at.push_back(s.at);
    }
    const auto done = simplify(levels, none, {});
    ASSERT_TRUE(done);
    ASSERT_EQ(levels.coarsest(), texts.size() - 1);
    EXPECT_EQ(done->contracted, levels.coarsest());
    EXPECT_EQ(levels.level(), levels.coarsest());
    std::mt19937 random(5);
    for (int i = 0; i < 1000; ++i) {
      const std::size_t to = random() % texts.size();
      levels.to_level(to);
      ASSERT_EQ(levels.level(), to);
      ASSERT_EQ(levels.faces(to), levels.surface().characteristic().f);
      if (i % 10 != 0) continue;
      ASSERT_EQ(dump(levels.surface()), texts[to]);
      ASSERT_TRUE(std::ranges::equal(levels.values(), at[to]));
      ASSERT_TRUE(validate(levels.surface()).empty());
    }
    levels.to_level(0);
    EXPECT_EQ(dump(levels.surface()), texts[0]);
    EXPECT_TRUE(std::ranges::equal(levels.values(), at[0]));
  }
}

TEST(LevelOfDetail, GivesTheFinestLevelOfSoManyFaces) {
  for (const Solid& whole : solids()) {
    LevelOfDetail<> levels(whole.surface, whole.at);
    Creases none;
    ASSERT_TRUE(simplify(levels, none, {.faces = 30}));
    for (std::int64_t f = whole.surface.characteristic().f + 1; f >= 0; --f) {
      levels.to_faces(f);
      std::size_t finest = 0;
      while (finest < levels.coarsest() && levels.faces(finest) > f) ++finest;
      ASSERT_EQ(levels.level(), finest) << f;
    }
    levels.to_faces(1'000'000);
    EXPECT_EQ(levels.level(), 0u);
    levels.to_level(1'000'000);
    EXPECT_EQ(levels.level(), levels.coarsest());
  }
}

TEST(LevelOfDetail, CostsWhatChanges) {
  Solid whole = round_torus(40, 30);
  LevelOfDetail<> levels(whole.surface, whole.at);
  Creases none;
  ASSERT_TRUE(simplify(levels, none, {.faces = 100}));
  std::mt19937 random(9);
  for (int i = 0; i < 200; ++i) {
    const std::size_t from = levels.level(), to = random() % (levels.coarsest() + 1);
    std::size_t operators = 0;
    levels.to_level(to, [&](const Change&) { ++operators; });
    // A contraction is a weld and the flips of a vertex of few edges; back, each takes three and
    // the weld up to nine.
    EXPECT_LE(operators, 30 * (std::max(from, to) - std::min(from, to)));
    EXPECT_GE(operators, std::max(from, to) - std::min(from, to));
  }
}

TEST(LevelOfDetail, CarriesAnyValuesAndGoesOnFromAnyLevel) {
  const Solid whole = round_torus(8, 6);
  std::vector<Marked> marked;
  for (std::size_t i = 0; i < whole.at.size(); ++i)
    marked.push_back({whole.at[i], "a name too long to be kept in place " + std::to_string(i)});
  LevelOfDetail<Marked> levels(whole.surface, marked);
  Creases none;
  const auto carry = [](const Contraction& c, const Marked& kept, const Marked& gone) {
    return Marked{c.place, kept.name + gone.name};
  };
  ASSERT_TRUE(simplify(levels, whole.at, none, {.faces = 40}, carry));
  const std::size_t far = levels.coarsest();
  levels.to_level(10);
  const std::string middle = dump(levels.surface());
  // Other levels than there were.
  std::vector<Position3> at;
  for (const Marked& m : levels.values()) at.push_back(m.at);
  ASSERT_TRUE(simplify(levels, at, none, {.faces = 60, .shape = 1}, carry));
  EXPECT_LT(levels.coarsest(), far);
  levels.to_level(10);
  EXPECT_EQ(dump(levels.surface()), middle);
  levels.to_level(0);
  EXPECT_EQ(dump(levels.surface()), dump(whole.surface));
  EXPECT_TRUE(std::ranges::equal(levels.values(), marked));
}

TEST(LevelOfDetail, RefusesWhatSimplifyRefuses) {
  const Solid whole = round_torus(5, 4);
  LevelOfDetail<> levels(whole.surface, whole.at);
  Creases none;
  const auto done = simplify(levels, none, {.faces = -1});
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().rule, SimplifyRule::option);
  EXPECT_EQ(levels.coarsest(), 0u);
  EXPECT_EQ(dump(levels.surface()), dump(whole.surface));
}

}  // namespace
}  // namespace clers::test
