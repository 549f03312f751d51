// Surfaces with positions, to be simplified.
#ifndef CLERS_TOPOLOGY_MODELING_TEST_SOLIDS_H
#define CLERS_TOPOLOGY_MODELING_TEST_SOLIDS_H

#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "topology/modeling/simplify.h"
#include "topology/test/meshes.h"

namespace clers::test {

struct Solid {
  Surface surface;
  std::vector<Position3> at;
};

/// A torus around the z axis: radii 2 and 1.
inline Solid round_torus(std::uint32_t columns, std::uint32_t rows) {
  Solid s{torus(columns, rows), {}};
  s.at.resize(s.surface.vertex_limit());
  for (std::uint32_t i = 0; i < s.at.size(); ++i) {
    const double a = 2 * M_PI * (i % columns) / columns, b = 2 * M_PI * (i / columns) / rows;
    s.at[i] = {(2 + std::cos(b)) * std::cos(a), (2 + std::cos(b)) * std::sin(a), std::sin(b)};
  }
  return s;
}

/// The square 0 .. n, height by a function.
template <class Height>
Solid field(std::uint32_t n, Height&& height) {
  Solid s{grid(n, n), {}};
  for (std::uint32_t i = 0; i < (n + 1) * (n + 1); ++i) {
    const double x = i % (n + 1), y = i / (n + 1);
    s.at.push_back({x, y, height(x, y)});
  }
  return s;
}

/// One closed and smooth, one with a boundary, one of genus 3 whose vertices lie anywhere.
inline std::vector<Solid> solids_of_each_kind() {
  std::vector<Solid> solids;
  solids.push_back(round_torus(30, 20));
  solids.push_back(field(20, [](double x, double y) { return std::sin(x) * std::cos(y); }));
  solids.push_back({chain_of_tori(3, 6), {}});
  std::mt19937 random(1);
  solids.back().at.resize(solids.back().surface.vertex_limit());
  for (Position3& p : solids.back().at)
    for (double& x : p) x = static_cast<double>(random() % 1000);
  return solids;
}

}  // namespace clers::test

#endif
