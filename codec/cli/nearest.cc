// The tree is Boost's. It is asked for the nearest boxes, a few and then more, until one of them is
// farther than the best point: then all others are. (Its iterators that go on from box to box visit
// a large part of the tree.)
#include "codec/cli/nearest.h"

#include <algorithm>
#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <iterator>
#include <utility>

namespace clers::cli {
namespace {

namespace index = boost::geometry::index;
using Corner = boost::geometry::model::point<double, 3, boost::geometry::cs::cartesian>;
using Box = boost::geometry::model::box<Corner>;
using Entry = std::pair<Box, std::uint32_t>;

Corner corner(const Vec3& p) {
  return {p.x, p.y, p.z};
}

Box box_of(const Triangle& t) {
  Vec3 low = t[0], high = t[0];
  for (const Vec3& p : t) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  return {corner(low), corner(high)};
}

PointOfTriangle point(const Triangle& t, const std::array<double, 3>& weights, const Vec3& p) {
  PointOfTriangle found{weights, weights[0] * t[0] + weights[1] * t[1] + weights[2] * t[2], 0};
  for (unsigned i = 0; i < 3; ++i)
    if (weights[i] == 1) found.at = t[i];  // exactly
  found.distance2 = squared(found.at - p);
  return found;
}

/// How far along a-b, 0..1, p is.
double along(const Vec3& a, const Vec3& b, const Vec3& p) {
  const double whole = squared(b - a);
  return whole > 0 ? std::clamp(dot(p - a, b - a) / whole, 0., 1.) : 0;
}

PointOfTriangle nearest_of_side(const Triangle& t, unsigned side, const Vec3& p) {
  const unsigned next = (side + 1) % 3;
  std::array<double, 3> weights{};
  weights[next] = along(t[side], t[next], p);
  weights[side] = 1 - weights[next];
  return point(t, weights, p);
}

}  // namespace

PointOfTriangle nearest_of(const Triangle& t, const Vec3& p) {
  // Inside, if p is above the triangle: on the inner side of all three sides.
  const Vec3 normal = cross(t[1] - t[0], t[2] - t[0]);
  const double all = squared(normal);
  std::array<double, 3> inside{};
  bool above = all > 0;
  for (unsigned i = 0; i < 3 && above; ++i) {
    const Vec3 &a = t[(i + 1) % 3], &b = t[(i + 2) % 3];
    inside[i] = dot(cross(b - a, p - a), normal) / all;
    above = inside[i] >= 0;
  }
  if (above) {
    const double sum = inside[0] + inside[1] + inside[2];
    for (double& w : inside) w /= sum;
    return point(t, inside, p);
  }
  PointOfTriangle best;
  for (unsigned side = 0; side < 3; ++side)
    if (const auto found = nearest_of_side(t, side, p); found.distance2 < best.distance2)
      best = found;
  return best;
}

std::optional<PointOfTriangle> nearest_in_plane(const Triangle& t, const Vec3& p,
                                                const Vec3& normal) {
  // What the plane cuts out is a segment: its ends are on two sides.
  std::array<double, 3> height{};
  for (unsigned i = 0; i < 3; ++i) height[i] = dot(t[i] - p, normal);
  std::array<std::array<double, 3>, 3> ends{};
  Triangle segment{};
  unsigned count = 0;
  for (unsigned i = 0; i < 3; ++i) {
    const unsigned next = (i + 1) % 3;
    if ((height[i] < 0) == (height[next] < 0)) continue;
    const double share = height[i] / (height[i] - height[next]);
    ends[count][i] = 1 - share;
    ends[count][next] = share;
    segment[count] = point(t, ends[count], p).at;
    ++count;
  }
  if (count < 2) return std::nullopt;
  const double share = along(segment[0], segment[1], p);
  std::array<double, 3> weights{};
  for (unsigned i = 0; i < 3; ++i) weights[i] = (1 - share) * ends[0][i] + share * ends[1][i];
  return point(t, weights, p);
}

struct Nearest::Tree {
  index::rtree<Entry, index::rstar<8>> boxes;
};

Nearest::Nearest(std::span<const Triangle> triangles)
    : triangles_(triangles.begin(), triangles.end()) {
  std::vector<Entry> entries;
  entries.reserve(triangles_.size());
  for (const Triangle& t : triangles_)
    entries.emplace_back(box_of(t), static_cast<std::uint32_t>(entries.size()));
  tree_ = std::make_unique<Tree>(Tree{{entries.begin(), entries.end()}});  // packed
}
Nearest::Nearest(Nearest&&) noexcept = default;
Nearest::~Nearest() = default;

std::optional<Nearest::Found> Nearest::operator()(const Query& query) const {
  const bool any_side = squared(query.facing) == 0, anywhere = squared(query.plane) == 0;
  const auto candidate = [&](const Entry& entry) {
    const Triangle& t = triangles_[entry.second];
    return any_side || dot(cross(t[1] - t[0], t[2] - t[0]), query.facing) > 0;
  };
  const Corner at = corner(query.p);
  const auto distance = [&](const Entry& entry) {
    return boost::geometry::comparable_distance(at, entry.first);
  };
  std::optional<Found> best;
  std::vector<Entry> near;
  for (std::size_t count = 4;; count *= 4) {
    near.clear();
    tree_->boxes.query(
        index::nearest(at, static_cast<unsigned>(std::min(count, triangles_.size() + 1))) &&
            index::satisfies(candidate),
        std::back_inserter(near));
    double farthest = 0;
    for (const Entry& entry : near) {
      farthest = std::max(farthest, distance(entry));
      const std::uint32_t i = entry.second;
      const auto found = anywhere ? nearest_of(triangles_[i], query.p)
                                  : nearest_in_plane(triangles_[i], query.p, query.plane);
      if (!found) continue;
      if (!best || found->distance2 < best->distance2 ||
          (found->distance2 == best->distance2 && i < best->triangle))
        best = Found{*found, i};
    }
    if (near.size() < count || (best && farthest > best->distance2)) return best;
  }
}

}  // namespace clers::cli
