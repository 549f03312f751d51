// CGAL's advancing front surface reconstruction (Cohen-Steiner, Da 2004).
#ifndef CLERS_BENCH_RIVALS_CGAL_FRONT_H
#define CLERS_BENCH_RIVALS_CGAL_FRONT_H

#include <array>
#include <cstdint>
#include <vector>

namespace clers::bench {

/// Triangles over points, three numbers each. With what CGAL sets by default.
std::vector<std::uint32_t> reconstruct_by_cgal(const std::vector<std::array<double, 3>>& points);
/// "5.5.1".
const char* cgal_version();

}  // namespace clers::bench

#endif
