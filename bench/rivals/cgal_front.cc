#include "bench/rivals/cgal_front.h"

#include <CGAL/Advancing_front_surface_reconstruction.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/version.h>

#include <iterator>

namespace clers::bench {

std::vector<std::uint32_t> reconstruct_by_cgal(const std::vector<std::array<double, 3>>& points) {
  using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
  std::vector<Point> places;
  places.reserve(points.size());
  for (const auto& p : points) places.emplace_back(p[0], p[1], p[2]);
  std::vector<std::array<std::size_t, 3>> faces;
  CGAL::advancing_front_surface_reconstruction(places.begin(), places.end(),
                                               std::back_inserter(faces));
  std::vector<std::uint32_t> corners;
  corners.reserve(3 * faces.size());
  for (const auto& face : faces)
    for (const std::size_t p : face) corners.push_back(static_cast<std::uint32_t>(p));
  return corners;
}

const char* cgal_version() {
  return CGAL_VERSION_STR;
}

}  // namespace clers::bench
