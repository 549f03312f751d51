// Points on known surfaces, and what holds of all that is reconstructed.
#ifndef CLERS_TOPOLOGY_MODELING_TEST_POINT_SETS_H
#define CLERS_TOPOLOGY_MODELING_TEST_POINT_SETS_H

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

#include "topology/modeling/reconstruct.h"
#include "topology/validate.h"

namespace clers::test {

using Points = std::vector<std::array<double, 3>>;
constexpr double pi = 3.14159265358979323846;

inline Points sphere(int n) {
  Points p;
  for (int i = 0; i < n; ++i) {
    const double z = 1 - (2 * i + 1.) / n, r = std::sqrt(1 - z * z), t = i * 2.399963229728653;
    p.push_back({r * std::cos(t), r * std::sin(t), z});
  }
  return p;
}

inline Points torus(int around, int across) {
  Points p;
  for (int i = 0; i < around; ++i)
    for (int j = 0; j < across; ++j) {
      const double s = 2 * pi * i / around, t = 2 * pi * (j + 0.5 * (i % 2)) / across;
      const double r = 3 + std::cos(t);
      p.push_back({r * std::cos(s), r * std::sin(s), std::sin(t)});
    }
  return p;
}

inline Points grid(int n, double z) {
  Points p;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) p.push_back({1. * i, 1. * j, z});
  return p;
}

/// Whatever the points are, the result is a manifold on them.
inline Reconstruction made(const Points& points, const ReconstructionOptions& options = {}) {
  auto r = reconstruct(points, options);
  EXPECT_TRUE(r);
  if (!r) return {};
  const Surface& s = r->surface;
  EXPECT_TRUE(validate(s).empty());
  std::set<std::pair<std::uint32_t, std::uint32_t>> sides;
  for (const Face f : s.faces())
    for (const HalfEdge h : s.star(f))
      EXPECT_TRUE(sides.emplace(s.point(s.org(h)).index(), s.point(s.dest(h)).index()).second);
  for (const Vertex v : s.vertices()) EXPECT_EQ(s.point(v).index(), v.index());
  EXPECT_EQ(s.characteristic().v + std::int64_t(r->unused + r->duplicates),
            std::int64_t(points.size()));
  return std::move(*r);
}

inline double volume(const Surface& s, const Points& p) {
  double sum = 0;
  for (const Face f : s.faces()) {
    std::array<std::array<double, 3>, 3> c;
    for (unsigned i = 0; i < 3; ++i) c[i] = p[s.org(half_edge(f, i)).index()];
    sum += c[0][0] * (c[1][1] * c[2][2] - c[1][2] * c[2][1]) +
           c[0][1] * (c[1][2] * c[2][0] - c[1][0] * c[2][2]) +
           c[0][2] * (c[1][0] * c[2][1] - c[1][1] * c[2][0]);
  }
  return sum / 6;
}

}  // namespace clers::test

#endif
