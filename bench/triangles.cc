#include "bench/triangles.h"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <random>
#include <utility>

namespace clers::bench {
namespace {

using Point = std::array<double, 3>;

Point minus(const Point& a, const Point& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
double length(const Point& a) {
  return std::hypot(a[0], a[1], a[2]);
}
double area(const Point& a, const Point& b, const Point& c) {
  const Point u = minus(b, a), v = minus(c, a);
  return length({u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]}) /
         2;
}
const Point& corner(const Triangles& mesh, std::size_t t, std::size_t i) {
  return mesh.points[mesh.corners[3 * t + i]];
}
double area(const Triangles& mesh, std::size_t t) {
  return area(corner(mesh, t, 0), corner(mesh, t, 1), corner(mesh, t, 2));
}

class Sets {
 public:
  explicit Sets(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0u); }
  std::uint32_t find(std::uint32_t v) {
    while (parent_[v] != v) v = parent_[v] = parent_[parent_[v]];
    return v;
  }
  void unite(std::uint32_t a, std::uint32_t b) { parent_[find(a)] = find(b); }

 private:
  std::vector<std::uint32_t> parent_;
};

}  // namespace

Triangles triangles_of(const Input& input) {
  Triangles out{{}, input.triangles};
  for (std::size_t v = 0; v < input.vertex_count; ++v)
    out.points.push_back(
        {input.positions[3 * v], input.positions[3 * v + 1], input.positions[3 * v + 2]});
  return out;
}

std::vector<double> radius_ratios(const Triangles& mesh) {
  std::vector<double> ratios;
  for (std::size_t t = 0; t < mesh.count(); ++t) {
    const Point &a = corner(mesh, t, 0), &b = corner(mesh, t, 1), &c = corner(mesh, t, 2);
    const double u = length(minus(a, b)), v = length(minus(b, c)), w = length(minus(c, a));
    const double s = (u + v + w) / 2, all = area(mesh, t), product = u * v * w;
    const double around = product / (4 * all), within = all / s;
    ratios.push_back(all > 0 ? 2 * within / around : 0);
  }
  std::sort(ratios.begin(), ratios.end());
  return ratios;
}

Joined joined(const Triangles& mesh, const std::vector<std::uint32_t>& twins) {
  Joined found;
  found.manifold = true;
  const auto next = [](std::uint32_t h) { return h % 3 == 2 ? h - 2 : h + 1; };
  Sets sets(mesh.points.size());
  std::vector<bool> used(mesh.points.size()), walked(mesh.corners.size());
  std::int64_t boundary = 0;
  for (std::uint32_t h = 0; h < mesh.corners.size(); ++h) {
    used[mesh.corners[h]] = true;
    sets.unite(mesh.corners[h], mesh.corners[next(h)]);
    if (twins[h] != no_twin) continue;
    ++boundary;
    if (walked[h]) continue;
    ++found.curves;
    for (std::uint32_t side = h; !walked[side];) {
      walked[side] = true;
      for (side = next(side); twins[side] != no_twin;) side = next(twins[side]);
    }
  }
  std::int64_t corners = 0;
  for (std::uint32_t v = 0; v < mesh.points.size(); ++v) {
    if (!used[v]) continue;
    ++corners;
    found.components += sets.find(v) == v ? 1 : 0;
  }
  const auto faces = static_cast<std::int64_t>(mesh.count()), edges = (3 * faces + boundary) / 2;
  found.genus = (2 * found.components - found.curves - (corners - edges + faces)) / 2;
  return found;
}

Joined joined(const Triangles& mesh) {
  if (!is_oriented_manifold(static_cast<std::uint32_t>(mesh.points.size()), mesh.corners))
    return {};
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> sides;  // as they run
  std::vector<std::uint32_t> twins(mesh.corners.size(), no_twin);
  for (std::uint32_t h = 0; h < mesh.corners.size(); ++h) {
    const std::uint32_t a = mesh.corners[h], b = mesh.corners[h % 3 == 2 ? h - 2 : h + 1];
    sides[{a, b}] = h;
    if (const auto twin = sides.find({b, a}); twin != sides.end())
      twins[h] = twin->second, twins[twin->second] = h;
  }
  return joined(mesh, twins);
}

double diagonal(const Triangles& mesh) {
  constexpr double far = std::numeric_limits<double>::infinity();
  Point low{far, far, far}, high{-far, -far, -far};
  for (const Point& p : mesh.points)
    for (std::size_t i = 0; i < 3; ++i)
      low[i] = std::min(low[i], p[i]), high[i] = std::max(high[i], p[i]);
  return length(minus(high, low));
}

struct Target::Tree {
  using Kernel = CGAL::Simple_cartesian<double>;
  using Place = std::vector<Kernel::Triangle_3>::const_iterator;
  std::vector<Kernel::Triangle_3> triangles;
  CGAL::AABB_tree<CGAL::AABB_traits<Kernel, CGAL::AABB_triangle_primitive<Kernel, Place>>> tree;
};

Target::Target(const Triangles& mesh) : tree_(std::make_unique<Tree>()) {
  const auto point = [](const Point& p) { return Tree::Kernel::Point_3(p[0], p[1], p[2]); };
  for (std::size_t t = 0; t < mesh.count(); ++t)
    if (area(mesh, t) > 0)
      tree_->triangles.emplace_back(point(corner(mesh, t, 0)), point(corner(mesh, t, 1)),
                                    point(corner(mesh, t, 2)));
  tree_->tree.insert(tree_->triangles.cbegin(), tree_->triangles.cend());
  tree_->tree.build();
  tree_->tree.accelerate_distance_queries();
}
Target::~Target() = default;

Target::Distance Target::from(const Triangles& other, std::size_t samples) const {
  Distance found;
  if (tree_->triangles.empty() || other.count() == 0) return found;
  std::vector<double> sums;
  double sum = 0;
  for (std::size_t t = 0; t < other.count(); ++t) sums.push_back(sum += area(other, t));
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> share(0, 1);
  double squares = 0;
  for (std::size_t i = 0; i < samples; ++i) {
    const auto t = std::min(
        static_cast<std::size_t>(std::lower_bound(sums.begin(), sums.end(), share(random) * sum) -
                                 sums.begin()),
        other.count() - 1);
    double u = share(random), v = share(random);
    if (u + v > 1) u = 1 - u, v = 1 - v;
    const Point &a = corner(other, t, 0), &b = corner(other, t, 1), &c = corner(other, t, 2);
    const auto place = [&](std::size_t k) { return (1 - u - v) * a[k] + u * b[k] + v * c[k]; };
    const double square =
        tree_->tree.squared_distance(Tree::Kernel::Point_3(place(0), place(1), place(2)));
    squares += square;
    found.greatest = std::max(found.greatest, std::sqrt(square));
  }
  found.rms = std::sqrt(squares / static_cast<double>(samples));
  return found;
}

}  // namespace clers::bench
