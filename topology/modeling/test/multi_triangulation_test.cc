// Random calls of refine and simplify beside an oracle that keeps the hierarchy.
#include "topology/modeling/multi_triangulation.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cstdint>
#include <cstdlib>
#include <random>
#include <string>
#include <vector>

#include "topology/dump.h"
#include "topology/modeling/test/bases.h"
#include "topology/modeling/test/tracked_mesh.h"
#include "topology/validate.h"

namespace clers {
namespace {

using test::Base;
using test::bases;
using test::TrackedMesh;

/// CLERS_LONG multiplies the number of cases.
unsigned factor() {
  const char* text = std::getenv("CLERS_LONG");
  return text ? static_cast<unsigned>(std::max(1, std::atoi(text))) : 1;
}

/// The same cases in every run, unless RC_PARAMS says otherwise.
const bool params_set = [] {
  setenv("RC_PARAMS", ("seed=2004 max_success=" + std::to_string(60 * factor())).c_str(), 0);
  return true;
}();

struct Op {
  std::uint8_t kind = 0;
  std::uint16_t choice = 0;
};

struct Done {
  std::uint64_t refined = 0, simplified = 0, refused = 0;
};

/// A random call, or one with a bad argument; empty, or what is wrong. Refines more than it
/// simplifies where there are few faces.
std::string step(TrackedMesh& tracked, const Op& op, std::int64_t target, unsigned deepest,
                 Done& done) {
  const Surface& s = tracked.surface();
  MultiTriangulation& mesh = tracked.mesh();
  if (op.kind % 16 == 0) {
    ++done.refused;
    const HalfEdge h(s.half_edge_limit() - 3 + op.choice % 6);
    if (!s.is_live(h)) return tracked.refuse_refine(h, Precondition::live_half_edge);
    const Vertex v(s.vertex_limit() - 3 + op.choice % 6);
    if (!s.is_live(v)) return tracked.refuse_simplify(v, Precondition::live_vertex);
    if (mesh.level(v) == 0) return tracked.refuse_simplify(v, Precondition::refined_vertex);
  }
  const bool crowded = s.characteristic().f > target;
  if (op.kind % 8 < (crowded ? 2 : 6)) {
    for (std::uint32_t i = 0; i < s.half_edge_limit(); ++i) {
      const HalfEdge h((op.choice + i) % s.half_edge_limit());
      if (!s.is_live(h) || mesh.level(left(h)) > deepest) continue;
      ++done.refined;
      return tracked.refine(h);
    }
  }
  for (std::uint32_t i = 0; i < s.vertex_limit(); ++i) {
    const Vertex v((op.choice + i) % s.vertex_limit());
    if (!s.is_live(v) || mesh.level(v) == 0) continue;
    ++done.simplified;
    return tracked.simplify(v);
  }
  return "";
}

void showValue(const Op& op, std::ostream& os) {
  os << '{' << int(op.kind) << ", " << op.choice << '}';
}

}  // namespace
}  // namespace clers

namespace rc {
template <>
struct Arbitrary<clers::Op> {
  static Gen<clers::Op> arbitrary() {
    return gen::build<clers::Op>(gen::set(&clers::Op::kind), gen::set(&clers::Op::choice));
  }
};
}  // namespace rc

namespace clers {
namespace {

std::vector<Op> sequence(int length) {
  return *rc::gen::resize(
      length, rc::gen::container<std::vector<Op>>(rc::gen::resize(200, rc::gen::arbitrary<Op>())));
}

/// Every call is checked; in the end all that was refined is taken away.
void run(TrackedMesh& tracked, const std::vector<Op>& ops, std::int64_t target, Done& done) {
  const auto fail = [&](std::size_t i, const std::string& wrong) {
    RC_FAIL(wrong + " (step " + std::to_string(i) + ")\n" + dump(tracked.surface()));
  };
  for (std::size_t i = 0; i < ops.size(); ++i) {
    if (const auto wrong = step(tracked, ops[i], target, 20, done); !wrong.empty()) fail(i, wrong);
    if (const auto wrong = tracked.check(); !wrong.empty()) fail(i, wrong);
  }
  if (const auto wrong = tracked.simplify_all(1); !wrong.empty()) fail(ops.size(), wrong);
  if (const auto wrong = tracked.check(); !wrong.empty()) fail(ops.size(), wrong);
}

TEST(MultiTriangulation, EveryCallOnKnownBases) {
  const std::vector<Base> all = bases();
  Done done;
  EXPECT_TRUE(rc::check([&] {
    const std::size_t which = *rc::gen::inRange<std::size_t>(0, all.size());
    RC_LOG() << all[which].name << '\n';
    TrackedMesh tracked(all[which].surface);
    run(tracked, sequence(80), 150, done);
  }));
  EXPECT_GT(done.refused, 100u);
  EXPECT_GT(done.refined, 1000u);
  EXPECT_GT(done.simplified, 500u);
}

TEST(MultiTriangulation, EveryCallOnAnyBase) {
  Done done;
  EXPECT_TRUE(rc::check([&] {
    const auto base = *rc::gen::container<std::vector<std::uint16_t>>(
        rc::gen::resize(200, rc::gen::arbitrary<std::uint16_t>()));
    TrackedMesh tracked(test::random_base(base));
    if (const auto wrong = tracked.check(); !wrong.empty()) RC_FAIL(wrong);
    run(tracked, sequence(60), 60, done);
  }));
  EXPECT_GT(done.refined, 1000u);
}

TEST(MultiTriangulation, BasesAreTheSameAgain) {
  for (const Base& base : bases()) {
    SCOPED_TRACE(base.name);
    ASSERT_TRUE(validate(base.surface).empty());
    TrackedMesh tracked(base.surface);
    ASSERT_EQ(tracked.check(), "");
    std::mt19937 random(7);
    for (int i = 0; i < 60; ++i) {
      const HalfEdge h(static_cast<std::uint32_t>(random()) % tracked.surface().half_edge_limit());
      if (tracked.surface().is_live(h)) {
        ASSERT_EQ(tracked.refine(h), "");
      }
    }
    ASSERT_EQ(tracked.check(), "");
    ASSERT_EQ(tracked.simplify_all(3), "");
    ASSERT_EQ(tracked.check(), "");
  }
}

TEST(MultiTriangulation, AMillionCalls) {
#if defined(__SANITIZE_ADDRESS__)
  const std::uint64_t calls = 60'000u * factor();
#else
  const std::uint64_t calls = 1'000'000u * factor();
#endif
  const std::vector<Base> all = bases();
  std::mt19937 random(2004);
  Done done;
  const std::uint64_t each = calls / all.size() + 1;
  for (const Base& base : all) {
    SCOPED_TRACE(base.name);
    TrackedMesh tracked(base.surface);
    const unsigned deepest = random() % 4 == 0 ? 20 : 8;
    const std::int64_t target = std::int64_t{200} << random() % 3;
    const std::uint64_t before = done.refined + done.simplified;
    for (std::uint64_t i = 0; done.refined + done.simplified < before + each; ++i) {
      const Op op{static_cast<std::uint8_t>(1 + random() % 15),
                  static_cast<std::uint16_t>(random())};
      ASSERT_EQ(step(tracked, op, target, deepest, done), "") << "call " << i;
      if (i % 20'000 == 0) {
        ASSERT_EQ(tracked.check(), "") << "call " << i;
      }
    }
    ASSERT_EQ(tracked.simplify_all(5), "");
  }
  EXPECT_GE(done.refined + done.simplified, calls);
}

TEST(MultiTriangulation, NeedsATriQuadMesh) {
  Surface s = test::random_base({});
  ASSERT_TRUE(s.split(half_edge(Face(0), 0), Point()));
  auto mesh = MultiTriangulation::over(s);
  ASSERT_TRUE(mesh);
  EXPECT_EQ(dump(std::move(*mesh).release()), dump(s));
  s = test::glued(2, std::vector<std::pair<std::uint32_t, std::uint32_t>>{{0, 4}});
  const auto refused = MultiTriangulation::over(s);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error(), (Violation{Precondition::tri_quad, 4}));
}

}  // namespace
}  // namespace clers
