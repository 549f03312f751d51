// The R-tree beside a search of all triangles, and the point of one triangle beside many of its
// points.
#include "codec/cli/nearest.h"

#include <gtest/gtest.h>

#include <random>

namespace clers::cli {
namespace {

class Random {
 public:
  double number() { return number_(engine_); }
  Vec3 vector() { return {number(), number(), number()}; }
  Triangle triangle(double size) {
    const Vec3 at = vector();
    return {at, at + size * vector(), at + size * vector()};
  }

 private:
  std::mt19937 engine_{7};
  std::uniform_real_distribution<double> number_{-1, 1};
};

bool faces(const Triangle& t, const Vec3& direction) {
  return dot(cross(t[1] - t[0], t[2] - t[0]), direction) > 0;
}

TEST(Nearest, PointOfATriangleIsNoFartherThanAnyOther) {
  Random random;
  for (int n = 0; n < 300; ++n) {
    Triangle t = random.triangle(1);
    if (n % 7 == 0) t[2] = t[1];
    if (n % 21 == 0) t[0] = t[1];
    const Vec3 p = random.vector();
    const PointOfTriangle found = nearest_of(t, p);
    EXPECT_NEAR(found.weights[0] + found.weights[1] + found.weights[2], 1, 1e-12);
    const Vec3 at = found.weights[0] * t[0] + found.weights[1] * t[1] + found.weights[2] * t[2];
    EXPECT_NEAR(squared(at - found.at), 0, 1e-24);
    EXPECT_EQ(found.distance2, squared(found.at - p));
    for (int i = 0; i <= 10; ++i)
      for (int j = 0; i + j <= 10; ++j) {
        const Vec3 other = 0.1 * (i * t[0] + j * t[1] + (10 - i - j) * t[2]);
        EXPECT_LE(found.distance2, squared(other - p) + 1e-12);
      }
  }
}

TEST(Nearest, PointInAPlaneIsInIt) {
  Random random;
  int met = 0;
  for (int n = 0; n < 300; ++n) {
    const Triangle t = random.triangle(1);
    const Vec3 p = random.vector(), normal = random.vector();
    const auto found = nearest_in_plane(t, p, normal);
    bool below = false, above = false;
    for (const Vec3& corner : t) (dot(corner - p, normal) < 0 ? below : above) = true;
    ASSERT_EQ(found.has_value(), below && above);
    if (!found) continue;
    ++met;
    EXPECT_NEAR(dot(found->at - p, normal), 0, 1e-12);
    EXPECT_GE(found->distance2 + 1e-12, nearest_of(t, p).distance2);
    for (const double w : found->weights) EXPECT_GE(w, -1e-12);
  }
  EXPECT_GT(met, 30);
}

TEST(Nearest, FindsWhatASearchOfAllFinds) {
  Random random;
  std::vector<Triangle> triangles;
  for (std::uint32_t i = 0; i < 600; ++i) {
    triangles.push_back(random.triangle(i % 50 == 0 ? 1 : 0.1));
    if (i % 9 == 0) triangles.back() = triangles[i / 2];  // equal ones: the lowest is found
  }
  const Nearest nearest(triangles);
  for (std::uint32_t n = 0; n < 400; ++n) {
    Nearest::Query query;
    query.p = (n % 3 == 0 ? 3 : 1) * random.vector();
    if (n % 2 == 1) query.facing = random.vector();
    if (n % 4 >= 2) query.plane = random.vector();

    std::optional<Nearest::Found> best;
    for (std::uint32_t i = 0; i < triangles.size(); ++i) {
      if (n % 2 == 1 && !faces(triangles[i], query.facing)) continue;
      const auto one = n % 4 >= 2 ? nearest_in_plane(triangles[i], query.p, query.plane)
                                  : nearest_of(triangles[i], query.p);
      if (one && (!best || one->distance2 < best->distance2)) best = Nearest::Found{*one, i};
    }
    const auto found = nearest(query);
    ASSERT_EQ(found.has_value(), best.has_value());
    if (!best) continue;
    EXPECT_EQ(found->triangle, best->triangle);
    EXPECT_EQ(found->distance2, best->distance2);
  }
}

TEST(Nearest, FindsNothingWhereNothingIs) {
  const Nearest none({});
  EXPECT_FALSE(none({}).has_value());
  const std::vector<Triangle> one{{Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{0, 1, 0}}};
  const Nearest nearest(one);
  Nearest::Query query;
  query.facing = {0, 0, -1};
  EXPECT_FALSE(nearest(query).has_value());
  query.facing = {0, 0, 1};
  EXPECT_TRUE(nearest(query).has_value());
}

}  // namespace
}  // namespace clers::cli
