// Random sequences of operators, judged by the oracle.
//
// Short sequences: after every operator the oracle recounts everything, validate() is clean, what a
// refused operator left is what was there, and the operator's inverse gives back an equivalent
// surface. Handle and stellar operators are mixed. What is composed of stellar ones is also judged
// by what it should do to the triangles as triples of vertices. Long sequences: the oracle and
// validate() every so often, the Euler-Poincaré formula always.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "topology/dump.h"
#include "topology/test/pair.h"

namespace rc {
template <>
struct Arbitrary<clers::test::Op> {
  static Gen<clers::test::Op> arbitrary() {
    return gen::build<clers::test::Op>(
        gen::set(&clers::test::Op::kind), gen::set(&clers::test::Op::choice),
        gen::set(&clers::test::Op::a), gen::set(&clers::test::Op::b));
  }
};
}  // namespace rc

namespace clers {
namespace {

using test::Op;
using test::Pair;

/// The same cases in every run, unless RC_PARAMS says otherwise; CLERS_LONG multiplies their
/// number.
const bool params_set = [] {
  const char* factor = std::getenv("CLERS_LONG");
  const int cases = 100 * (factor ? std::max(1, std::atoi(factor)) : 1);
  setenv("RC_PARAMS", ("seed=2010 max_success=" + std::to_string(cases)).c_str(), 0);
  return true;
}();

/// Runs the steps and checks after every `stride`-th, and at the end.
void run(Pair& pair, const std::vector<Op>& ops, std::uint32_t target_faces, std::size_t stride) {
  const auto fail = [&](std::size_t i, const std::string& wrong) {
    RC_FAIL(wrong + " (step " + std::to_string(i) + ")\n" + dump(pair.surface()) +
            dump_code(pair.surface()));
  };
  for (std::size_t i = 0; i < ops.size(); ++i) {
    if (const std::string wrong = pair.step(ops[i], target_faces); !wrong.empty()) fail(i, wrong);
    if (!pair.surface().characteristic().is_valid()) fail(i, "the formula does not hold");
    if ((i + 1) % stride == 0 || i + 1 == ops.size())
      if (const std::string wrong = pair.check(); !wrong.empty()) fail(i, wrong);
  }
}

/// Up to `length` steps; failing sequences shrink by leaving steps out.
std::vector<Op> sequence(int length) {
  return *rc::gen::resize(
      length, rc::gen::container<std::vector<Op>>(rc::gen::resize(200, rc::gen::arbitrary<Op>())));
}

/// What all the cases of a property did together.
struct Tally {
  std::uint64_t done = 0, refused = 0, kinds[handle_case_count] = {};
  std::uint64_t splits[stellar_case_count] = {}, welds[stellar_case_count] = {}, composed[4] = {};

  void add(const Pair& pair) {
    done += pair.done();
    refused += pair.refused();
    for (unsigned i = 0; i < handle_case_count; ++i) kinds[i] += pair.glued(HandleCase(i));
    for (unsigned i = 0; i < stellar_case_count; ++i) {
      splits[i] += pair.split(StellarCase(i));
      welds[i] += pair.welded(StellarCase(i));
    }
    for (unsigned i = 0; i < 4; ++i) composed[i] += pair.composed(i);
  }

  void expect_all_cases() const {
    const auto expect = [](const std::string& what, std::uint64_t count) {
      std::printf("%-26s %llu\n", what.c_str(), static_cast<unsigned long long>(count));
      EXPECT_GT(count, 0u) << what << " never happened";
    };
    for (unsigned i = 0; i < handle_case_count; ++i) expect(name(HandleCase(i)), kinds[i]);
    for (unsigned i = 0; i < stellar_case_count; ++i) {
      expect(std::string("split ") + name(StellarCase(i)), splits[i]);
      expect(std::string("weld ") + name(StellarCase(i)), welds[i]);
    }
    expect("collapse", composed[0]);
    expect("split_vertex", composed[1]);
    expect("remove", composed[2]);
    expect("flip", composed[3]);
    std::printf("operators done %llu, refused %llu\n", static_cast<unsigned long long>(done),
                static_cast<unsigned long long>(refused));
    EXPECT_GT(refused, 0u);
  }
};

/// Many steps on surfaces that stay small: every one is checked and undone.
void thorough(std::uint32_t target_faces, int length) {
  Tally tally;
  EXPECT_TRUE(rc::check([&] {
    const auto ops = sequence(length);
    Pair pair(true);
    run(pair, ops, target_faces, 1);
    tally.add(pair);
  }));
  tally.expect_all_cases();
}

TEST(Operators, EveryStepOnUpTo4Faces) {
  thorough(4, 300);
}
TEST(Operators, EveryStepOnUpTo12Faces) {
  thorough(12, 400);
}
TEST(Operators, EveryStepOnUpTo40Faces) {
  thorough(40, 200);
}

TEST(Operators, AMillionSteps) {
  Tally tally;
  EXPECT_TRUE(rc::check([&] {
    const auto target = *rc::gen::element<std::uint32_t>(20, 60, 200, 1000, 4000);
    const auto ops = sequence(30'000);
    Pair pair(false);
    run(pair, ops, target, 1000);
    tally.add(pair);
  }));
  tally.expect_all_cases();
  EXPECT_GE(tally.done, 1'000'000u);
}

}  // namespace
}  // namespace clers
