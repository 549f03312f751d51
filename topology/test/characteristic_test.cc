#include "topology/characteristic.h"

#include <gtest/gtest.h>

#include "topology/derived.h"

namespace clers {
namespace {

TEST(Characteristic, LambdaTimesItsInverseIsTheIdentity) {
  for (unsigned row = 0; row < 6; ++row)
    for (unsigned column = 0; column < 6; ++column) {
      std::int64_t sum = 0;
      for (unsigned k = 0; k < 6; ++k)
        sum += lambda_matrix[row][k] * lambda_inverse_matrix_12[k][column];
      EXPECT_EQ(sum, row == column ? 12 : 0) << row << ", " << column;
    }
}

TEST(Characteristic, ColumnsOfLambdaAreTheEffects) {
  EXPECT_EQ(lambda({.create = 1}), effect_of_create);
  for (unsigned i = 0; i < handle_case_count; ++i) {
    OperatorCounts one;
    one.add(HandleCase(i));
    EXPECT_EQ(lambda(one), effect(HandleCase(i))) << name(HandleCase(i));
    EXPECT_EQ(effect(HandleCase(i)).euler(),
              2 * (effect(HandleCase(i)).s - effect(HandleCase(i)).g) - effect(HandleCase(i)).b);
  }
  EXPECT_EQ(lambda({.perpendicular = 1}), (Characteristic{1, -1, 1, 1, 2, -2}));
}

TEST(Characteristic, ExamplesOfThePaper) {
  EXPECT_EQ(lambda({2, 1, 0, 0, 0, 0, 0}), (Characteristic{4, 5, 2, 1, 0, 1}));
  const Characteristic tetrahedron{4, 6, 4, 0, 0, 1};
  EXPECT_EQ(lambda_inverse(tetrahedron), (OperatorCounts{4, 3, 1, 0, 2, 0, 0}));
  // Two zips are a 1b and a 2 (Fig. 11).
  EXPECT_EQ(lambda_inverse({-2, -2, 0, 0, 0, 0}), (OperatorCounts{0, 0, 1, 0, 1, 0, 0}));
  EXPECT_EQ(lambda_inverse(tetrahedron, 2), (OperatorCounts{4, 3, 0, 0, 1, 0, 2}));
}

TEST(Characteristic, SevenVertexTorusNeedsZips) {
  const Characteristic torus{7, 21, 14, 0, 1, 1};
  ASSERT_TRUE(torus.is_valid());
  EXPECT_FALSE(lambda_inverse(torus));  // (14, 13, 7/2, 1, 7/2, 0)
  for (std::int64_t zips = 0; zips < 8; ++zips) {
    const auto counts = lambda_inverse(torus, zips);
    EXPECT_EQ(counts.has_value(), zips % 2 == 1);
    if (counts) {
      EXPECT_EQ(lambda(*counts), torus);
    }
  }
  // As Edgebreaker builds it: V - 2 zips, one 1b for the handle, one 2 to close.
  EXPECT_EQ(lambda_inverse(torus, 5), (OperatorCounts{14, 13, 1, 1, 1, 0, 5}));
}

TEST(Characteristic, OffTheHyperplane) {
  EXPECT_FALSE((Characteristic{4, 6, 4, 1, 0, 1}).is_valid());
  EXPECT_FALSE((Characteristic{1, 0, 0, 1, 1, 1}).is_valid());
  const auto counts = lambda_inverse({1, -1, 1, 1, 2, -2});
  ASSERT_TRUE(counts);
  EXPECT_EQ(counts->perpendicular, 1);
}

}  // namespace
}  // namespace clers
