// Surfaces of points beside CGAL's: what they find of a mesh whose vertices they are given, and
// time.
//
// usage: reconstruct [--points N] [MESH.obj|.ply|.off|.stl]...
//
// Of each mesh the vertices that its faces use, alone and with normals of its faces; then moved by
// up to 10 % of the median edge in each coordinate, every tenth left out. Recovered is the share of
// the mesh's triangles, or of those whose corners are left, that are there again in any direction;
// `open` the edges with a face on one side alone; `manifold` is found without our surface, by
// counting. Balls have 0.7, 1, 1.4, 2 and 4 median edges as radii. Then spheres with bumps of 10^4
// .. N points, 10^6 if not given. Nanoseconds of processor time a point and as a part of CGAL's:
// all take turns, medians of five rounds, of one from 300,000 points on.
#include "topology/modeling/reconstruct.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <random>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "bench/input.h"
#include "bench/rivals/cgal_front.h"
#include "bench/timing.h"

namespace clers::bench {
namespace {

using Place = std::array<double, 3>;
using Triangle = std::array<std::uint32_t, 3>;

Place difference(const Place& a, const Place& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

/// Corners in order of their numbers, for triangles to be compared.
std::vector<Triangle> sorted(const std::vector<std::uint32_t>& corners) {
  std::vector<Triangle> all(corners.size() / 3);
  for (std::size_t i = 0; i < all.size(); ++i) {
    all[i] = {corners[3 * i], corners[3 * i + 1], corners[3 * i + 2]};
    std::sort(all[i].begin(), all[i].end());
  }
  std::sort(all.begin(), all.end());
  return all;
}

struct Points {
  std::vector<Place> places, normals;
  std::vector<std::uint32_t> triangles;  // that are looked for; none of spheres
  double spacing = 0;
};

struct Way {
  const char* name;
  std::function<std::vector<std::uint32_t>(const Points&)> corners;
};

std::vector<std::uint32_t> ours(const Points& points, bool normals, bool balls) {
  ReconstructionOptions options;
  if (normals) options.normals = points.normals;
  if (balls)
    for (const double r : {0.7, 1., 1.4, 2., 4.}) options.radii.push_back(r * points.spacing);
  const auto made = reconstruct(points.places, options);
  std::vector<std::uint32_t> corners;
  if (!made) return corners;
  for (const Face f : made->surface.faces())
    for (const HalfEdge h : made->surface.star(f)) corners.push_back(made->surface.org(h).index());
  return corners;
}

const std::vector<Way>& ways() {
  static const std::vector<Way> all{
      {"clers", [](const Points& p) { return ours(p, false, false); }},
      {"clers, normals", [](const Points& p) { return ours(p, true, false); }},
      {"clers, balls", [](const Points& p) { return ours(p, false, true); }},
      {"clers, balls, normals", [](const Points& p) { return ours(p, true, true); }},
      {"CGAL", [](const Points& p) { return reconstruct_by_cgal(p.places); }}};
  return all;
}

std::size_t open_edges(const std::vector<Triangle>& triangles) {
  std::vector<std::array<std::uint32_t, 2>> edges;
  for (const auto& [a, b, c] : triangles) edges.insert(edges.end(), {{a, b}, {b, c}, {a, c}});
  std::sort(edges.begin(), edges.end());
  std::size_t open = 0;
  for (std::size_t i = 0, end = 0; i < edges.size(); i = end) {
    for (end = i; end < edges.size() && edges[end] == edges[i];) ++end;
    open += end - i == 1;
  }
  return open;
}

void measure(const Points& points, bool with_normals) {
  const std::vector<Triangle> wanted = sorted(points.triangles);
  std::vector<const Way*> these;
  for (const Way& way : ways())
    if (with_normals || std::string_view(way.name).find("normals") == std::string_view::npos)
      these.push_back(&way);
  std::vector<std::vector<double>> seconds(these.size());
  std::vector<std::vector<std::uint32_t>> made(these.size());
  const int rounds = points.places.size() < 300'000 ? 5 : 1;
  for (int round = 0; round < rounds; ++round)
    for (std::size_t i = 0; i < these.size(); ++i) {
      const double start = thread_seconds();
      made[i] = these[i]->corners(points);
      seconds[i].push_back(thread_seconds() - start);
    }
  const auto median = [&](std::size_t i) {
    std::sort(seconds[i].begin(), seconds[i].end());
    return seconds[i][seconds[i].size() / 2];
  };
  const double n = static_cast<double>(points.places.size()), theirs = median(these.size() - 1);
  for (std::size_t i = 0; i < these.size(); ++i) {
    const std::vector<Triangle> found = sorted(made[i]);
    std::vector<Triangle> both;
    std::set_intersection(found.begin(), found.end(), wanted.begin(), wanted.end(),
                          std::back_inserter(both));
    std::set<std::uint32_t> used(made[i].begin(), made[i].end());
    std::printf("  %-22s", these[i]->name);
    if (wanted.empty())
      std::printf(" %9s  ", "-");
    else
      std::printf(" %9.2f %%",
                  100. * static_cast<double>(both.size()) / static_cast<double>(wanted.size()));
    const bool manifold =
        is_oriented_manifold(static_cast<std::uint32_t>(points.places.size()), made[i]);
    std::printf(" %9zu %7zu %7zu %9s %9.0f %6.2f\n", found.size(),
                points.places.size() - used.size(), open_edges(found), manifold ? "yes" : "NO",
                1e9 * median(i) / n, median(i) / theirs);
  }
}

/// The vertices of a mesh, with the mean normals of their triangles by area.
Points points_of(const Input& mesh) {
  Points points;
  points.triangles = mesh.triangles;
  for (std::size_t v = 0; v < mesh.vertex_count; ++v)
    points.places.push_back(
        {mesh.positions[3 * v], mesh.positions[3 * v + 1], mesh.positions[3 * v + 2]});
  points.normals.resize(points.places.size());
  std::vector<double> edges;
  for (std::size_t i = 0; i < mesh.triangles.size(); i += 3) {
    std::array<Place, 3> p;
    for (std::size_t k = 0; k < 3; ++k) p[k] = points.places[mesh.triangles[i + k]];
    const Place u = difference(p[1], p[0]), v = difference(p[2], p[0]);
    edges.push_back(std::hypot(u[0], u[1], u[2]));
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t axis = 0; axis < 3; ++axis)
        points.normals[mesh.triangles[i + k]][axis] +=
            u[(axis + 1) % 3] * v[(axis + 2) % 3] - u[(axis + 2) % 3] * v[(axis + 1) % 3];
  }
  std::sort(edges.begin(), edges.end());
  points.spacing = edges.empty() ? 1 : edges[edges.size() / 2];
  return points;
}

Points disturbed(const Points& points) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> share(-0.1, 0.1);
  Points left;
  left.spacing = points.spacing;
  constexpr std::uint32_t gone = 0xffffffffu;
  std::vector<std::uint32_t> number(points.places.size(), gone);
  for (std::size_t i = 0; i < points.places.size(); ++i) {
    if (random() % 10 == 0) continue;
    number[i] = static_cast<std::uint32_t>(left.places.size());
    left.places.push_back(points.places[i]);
    for (double& x : left.places.back()) x += share(random) * points.spacing;
    left.normals.push_back(points.normals[i]);
  }
  for (std::size_t i = 0; i < points.triangles.size(); i += 3) {
    std::array<std::uint32_t, 3> t;
    for (std::size_t k = 0; k < 3; ++k) t[k] = number[points.triangles[i + k]];
    if (std::find(t.begin(), t.end(), gone) == t.end())
      left.triangles.insert(left.triangles.end(), t.begin(), t.end());
  }
  return left;
}

/// Points about evenly on a sphere with bumps.
Points bumpy(std::size_t n) {
  Points points;
  std::mt19937 random(2);
  std::uniform_real_distribution<double> share(-0.3, 0.3);
  points.spacing = std::sqrt(4 * 3.14159265 / static_cast<double>(n));
  for (std::size_t i = 0; i < n; ++i) {
    const double z = 1 - (2 * static_cast<double>(i) + 1) / static_cast<double>(n);
    const double r = std::sqrt(1 - z * z), t = static_cast<double>(i) * 2.399963229728653;
    Place p{r * std::cos(t), r * std::sin(t), z};
    const double bump = 1 + 0.1 * std::sin(7 * p[0]) * std::sin(8 * p[1]) * std::sin(9 * p[2]);
    for (double& x : p) x = bump * (x + share(random) * points.spacing);
    points.places.push_back(p);
  }
  return points;
}

void heading(const std::string& of) {
  std::printf("%s\n  %-22s %11s %9s %7s %7s %9s %9s %6s\n", of.c_str(), "", "recovered",
              "triangles", "unused", "open", "manifold", "ns/point", "CGAL's");
}

}  // namespace
}  // namespace clers::bench

int main(int argc, char** argv) {
  using namespace clers::bench;
  double most = 1e6;
  std::vector<std::string> names(argv + 1, argv + argc);
  if (names.size() > 1 && names[0] == "--points") {
    most = std::atof(names[1].c_str());
    names.erase(names.begin(), names.begin() + 2);
  }
  std::printf("CGAL %s\n", cgal_version());
  for (const auto& file : list_files(names)) {
    const Input mesh = read_input(file);
    const Points points = points_of(mesh);
    heading(mesh.name + ": " + std::to_string(points.places.size()) + " points");
    measure(points, true);
    const Points left = disturbed(points);
    heading(mesh.name + ", noise, " + std::to_string(left.places.size()) + " points");
    measure(left, true);
  }
  for (const double n : {1e4, 1e5, 1e6}) {
    if (n > most) break;
    heading("bumps, " + std::to_string(static_cast<int>(n)) + " points");
    measure(bumpy(static_cast<std::size_t>(n)), false);
  }
}
