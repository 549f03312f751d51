// Points made distinct and of a common size, the front, and a surface on the caller's numbers.
#include "topology/modeling/reconstruct.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "topology/modeling/advancing_front.h"
#include "topology/modeling/front_points.h"
#include "topology/modeling/greedy_policy.h"
#include "topology/modeling/pivoting_policy.h"

namespace CLERS_VISIBLE clers {
namespace {

using namespace internal;

bool are_numbers(std::span<const Place> values) {
  for (const Place& p : values)
    for (const double x : p)
      if (!(std::abs(x) < 1e100)) return false;
  return true;
}

/// The points in the order of their places, each place once, within a cube of side 1.
struct Distinct {
  std::vector<std::uint32_t> number;  // the lowest of the input's at that place
  std::vector<Place> places, normals;
  double unit = 1;  // length of 1 in the input

  Distinct(std::span<const Place> points, std::span<const Place> normals_of) {
    number.resize(points.size());
    std::iota(number.begin(), number.end(), 0u);
    std::sort(number.begin(), number.end(), [&](std::uint32_t a, std::uint32_t b) {
      return points[a] != points[b] ? points[a] < points[b] : a < b;
    });
    const auto same = [&](std::uint32_t a, std::uint32_t b) { return points[a] == points[b]; };
    number.erase(std::unique(number.begin(), number.end(), same), number.end());
    if (number.empty()) return;
    Place low = points[0], high = low;
    for (const Place& p : points)
      for (unsigned i = 0; i < 3; ++i) {
        low[i] = std::min(low[i], p[i]);
        high[i] = std::max(high[i], p[i]);
      }
    const double size = std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2]});
    if (size > 0) unit = size;
    places.reserve(number.size());
    for (const std::uint32_t p : number) {
      Place& q = places.emplace_back();
      for (unsigned i = 0; i < 3; ++i) q[i] = (points[p][i] - low[i]) / unit;
      if (!normals_of.empty()) normals.push_back(normals_of[p]);
    }
  }
};

/// Six times the volume of the cone over each component, from its first corner.
std::vector<double> volumes(const Surface& surface, std::span<const Place> places) {
  std::vector<double> volume;
  std::vector<Place> apex;
  std::vector<bool> known;
  for (const Face f : surface.faces()) {
    const std::uint32_t k = surface.component(f).index();
    if (k >= volume.size()) volume.resize(k + 1), apex.resize(k + 1), known.resize(k + 1);
    std::array<Place, 3> p;
    for (unsigned i = 0; i < 3; ++i)
      p[i] = places[surface.point(surface.org(half_edge(f, i))).index()];
    if (!known[k]) apex[k] = p[0], known[k] = true;
    volume[k] += dot(p[0] - apex[k], cross(p[1] - apex[k], p[2] - apex[k]));
  }
  return volume;
}

}  // namespace

const char* describe(ReconstructionError error) {
  switch (error) {
    case ReconstructionError::bad_point: return "a coordinate is no number below 1e100";
    case ReconstructionError::bad_radius: return "a radius is no number above 0 and below 1e100";
    case ReconstructionError::bad_normals:
      return "a normal is no number below 1e100, or there are not as many as points";
    case ReconstructionError::too_many_points: return "there are too many points";
  }
  return "";
}

Result<Reconstruction, ReconstructionError> reconstruct(
    std::span<const std::array<double, 3>> points, const ReconstructionOptions& options) {
  if (points.size() > max_faces / 2) return Failure{ReconstructionError::too_many_points};
  if (!are_numbers(points)) return Failure{ReconstructionError::bad_point};
  if (!options.normals.empty() &&
      (options.normals.size() != points.size() || !are_numbers(options.normals)))
    return Failure{ReconstructionError::bad_normals};
  for (const double r : options.radii)
    if (!(r > 0 && r < 1e100)) return Failure{ReconstructionError::bad_radius};

  const Distinct distinct(points, options.normals);
  std::vector<double> radii = options.radii;
  for (double& r : radii) r /= distinct.unit;
  AdvancingFront front(static_cast<std::uint32_t>(distinct.places.size()));
  FrontPoints known(distinct.places, distinct.normals, options.progress);
  if (radii.empty()) {
    GreedyPolicy policy(known);
    advance(front, policy);
  } else {
    PivotingPolicy policy(known, std::move(radii));
    advance(front, policy);
  }

  Reconstruction made;
  made.removed = front.part_fans();
  made.stopped = known.stopped();
  const Surface grown = std::move(front).take();
  const std::vector<double> volume =
      options.normals.empty() ? volumes(grown, distinct.places) : std::vector<double>();
  std::vector<std::uint32_t> corners;
  corners.reserve(3 * static_cast<std::size_t>(grown.characteristic().f));
  for (const Face f : grown.faces()) {
    std::array<std::uint32_t, 3> v;
    for (unsigned i = 0; i < 3; ++i)
      v[i] = distinct.number[grown.point(grown.org(half_edge(f, i))).index()];
    if (!volume.empty() && volume[grown.component(f).index()] < 0) std::swap(v[1], v[2]);
    corners.insert(corners.end(), v.begin(), v.end());
  }
  // A manifold over points, so this cannot fail.
  made.surface = *Surface::from_faces(corners, static_cast<std::uint32_t>(points.size()));
  made.duplicates = points.size() - distinct.number.size();
  made.unused = distinct.number.size() - static_cast<std::size_t>(made.surface.characteristic().v);
  return made;
}

}  // namespace clers
