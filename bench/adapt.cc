// What adapting a mesh costs for each element that changes, and for each that does not.
//
// usage: adapt
//
// A torus of 4 x 4 quadrilaterals, sampled by labels and refined evenly to 10^3 .. 10^6 faces;
// around a point it is finer, the nearer the more. The point moves a little at a time and the mesh
// with it (Algorithm 6), always in a place of the same size: nanoseconds of processor time for each
// vertex made or welded, then those of a call when nothing has changed, and what asking everything
// costs an edge or vertex. Medians of the moves. Then refine and simplify alone, without queues,
// and bytes a face beside those of Fig. 8 of Dynamic adaptive meshes.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <vector>

#include "bench/heap.h"
#include "bench/timing.h"
#include "topology/modeling/adaptive_mesh.h"
#include "topology/modeling/dynamic_adaptation.h"
#include "topology/validate.h"

namespace clers::bench {
namespace {

constexpr std::uint32_t side = 4;

using Place = std::array<double, 2>;  // of the unit square, whose sides are glued
struct Sample {
  Place operator()(const Label& l) const {
    return {(l.block % side + l.u()) / side, (l.block / side + l.v()) / side};
  }
};
using Torus = AdaptiveMesh<Place, Sample>;

double distance(const Place& a, const Place& b) {
  double square = 0;
  for (std::size_t k = 0; k < 2; ++k) {
    const double d = std::fabs(a[k] - b[k]), around = std::fmin(d, 1 - d);
    square += around * around;
  }
  return std::sqrt(square);
}

/// The levels that the place wants beyond what it has.
struct Wanted {
  const Torus* mesh;
  const Place* brush;
  unsigned even;  // level everywhere
  double radius;  // within it, `finer` levels more, then one less at every 1.4 radii
  unsigned finer = 9;

  double level(Vertex v) const {
    const double far = std::log2(std::fmax(distance((*mesh)[v], *brush) / radius, 1)) * 2;
    return even + std::fmax(0, finer - far);
  }
  double operator()(const MultiTriangulation& m, HalfEdge h) const {
    return std::fmax(level(m.surface().org(h)), level(m.surface().dest(h))) - m.level(left(h));
  }
  double operator()(const MultiTriangulation& m, Vertex v) const {
    // The ends of the edge that a weld restores.
    const Surface& s = m.surface();
    const HalfEdge h = s.star_half_edge(v), across = s.sym(lprev(s.sym(lprev(h))));
    return std::fmax(level(v), std::fmax(level(s.dest(h)), level(s.dest(across)))) - m.level(v) + 1;
  }
};

/// The vertices whose priority a move of the brush can change: those within `radius`, found from
/// one of them.
std::vector<Vertex> near(const Torus& mesh, Vertex from, const Place& centre, double radius,
                         std::vector<std::uint32_t>& mark, std::uint32_t turn) {
  std::vector<Vertex> found{from};
  mark.resize(std::max<std::size_t>(mark.size(), mesh.surface().vertex_limit()));
  mark[from.index()] = turn;
  for (std::size_t i = 0; i < found.size(); ++i)
    for (const Vertex v : mesh.surface().adjacent_vertices(found[i]))
      if (mark[v.index()] != turn && distance(mesh[v], centre) < radius) {
        mark[v.index()] = turn;
        found.push_back(v);
      }
  return found;
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

Torus torus() {
  std::vector<std::uint32_t> corners;
  const auto at = [](std::uint32_t x, std::uint32_t y) { return y % side * side + x % side; };
  for (std::uint32_t y = 0; y < side; ++y)
    for (std::uint32_t x = 0; x < side; ++x)
      corners.insert(corners.end(), {at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)});
  std::vector<Place> places;
  for (std::uint32_t v = 0; v < side * side; ++v)
    places.push_back({double(v % side) / side, double(v / side) / side});
  Torus mesh(Sample{});
  const std::vector<std::uint32_t> sizes(side * side, 4);
  (void)mesh.read(*surface_of_polygons(sizes, corners, side * side, [](auto...) { return false; }),
                  places, distance);
  return mesh;
}

void measure(unsigned even) {
  Torus mesh = torus();
  const double faces = 32. * std::pow(2, even);
  const double begin = thread_seconds();
  const Adapted made =
      mesh.adapt_refine([&](const Torus& m, HalfEdge h) { return m.level(h) < even; });
  const double refine = thread_seconds() - begin;

  // As large a place in every mesh: so many of its triangles across.
  Place brush{0.3, 0.4};
  const double triangle = std::sqrt(1 / faces);
  const Wanted wanted{&mesh, &brush, even, 0.5 * triangle};
  const double reach = wanted.radius * std::pow(2, wanted.finer / 2.) + 2 * triangle;
  DynamicAdaptation follow(mesh.mesh(), wanted, Thresholds{0.5, 0.4});
  NoObserver none;
  follow.adapt({}, mesh.follow(none));

  std::vector<double> changing, still, all;
  std::vector<std::uint32_t> mark;
  Vertex nearest(0);
  std::uint64_t changes = 0;
  constexpr std::uint32_t moves = 200;
  for (std::uint32_t i = 1; i <= moves; ++i) {
    if (nearest == Vertex(0))
      for (const Vertex v : mesh.surface().vertices())
        if (distance(mesh[v], brush) < distance(mesh[nearest], brush)) nearest = v;
    brush[0] += 0.3 * wanted.radius, brush[1] += 0.2 * wanted.radius;
    const std::vector<Vertex> there = near(mesh, nearest, brush, reach, mark, i);
    for (const Vertex v : there) {
      follow.changed(v);
      if (distance(mesh[v], brush) < distance(mesh[nearest], brush)) nearest = v;
    }
    const double start = thread_seconds();
    const Adapted done = follow.adapt({}, mesh.follow(none));
    const double moved = thread_seconds();
    const std::uint64_t count = done.refined + done.simplified;
    if (count != 0) changing.push_back(1e9 * (moved - start) / static_cast<double>(count));
    changes += count;
    if (!mesh.surface().is_live(nearest)) nearest = Vertex(0);
    follow.adapt({}, mesh.follow(none));  // what was made last time is asked once
    const double quiet = thread_seconds();
    follow.adapt({}, mesh.follow(none));
    still.push_back(1e9 * (thread_seconds() - quiet));
  }
  const double elements = static_cast<double>(mesh.surface().characteristic().f) / 2 +
                          static_cast<double>(mesh.surface().characteristic().v);
  for (int i = 0; i < 5; ++i) {
    follow.all_changed();
    const double start = thread_seconds();
    follow.adapt({}, mesh.follow(none));
    all.push_back(1e9 * (thread_seconds() - start) / elements);
  }
  const double end = thread_seconds();
  const std::int64_t before = mesh.surface().characteristic().v;
  (void)mesh.adapt_simplify([](const Torus&, Vertex) { return true; });
  const double welds = static_cast<double>(before - mesh.surface().characteristic().v);
  const double simplify = thread_seconds() - end;
  if (!validate(mesh.surface()).empty()) std::printf("NOT VALID\n");
  std::printf("%9.0f %9.1f %9.0f %11.0f %9.1f %9.0f %9.0f\n", faces,
              static_cast<double>(changes) / moves, median(changing), median(still), median(all),
              1e9 * refine / static_cast<double>(made.refined), 1e9 * simplify / welds);
}

/// Bytes of heap that a mesh without values holds.
void memory() {
  Torus mesh = torus();
  (void)mesh.adapt_refine([](const Torus& m, HalfEdge h) { return m.level(h) < 14; });
  start_counting_heap();
  const MultiTriangulation copy = mesh.mesh();
  const double bytes = static_cast<double>(stop_counting_heap());
  const double f = static_cast<double>(copy.surface().characteristic().f);
  // Pointers of 8 bytes: a face has 1, an edge two half-edges of 4, a vertex 1 and an int; and a
  // pointer to each of them in its container.
  const double paper = (8 + 8) + 1.5 * (2 * 32 + 8) + 0.5 * (16 + 8);
  std::printf("bytes a face: %.1f; Fig. 8's structure: %.0f\n", bytes / f, paper);
}

}  // namespace
}  // namespace clers::bench

int main() {
  using namespace clers::bench;
  keep_heap_warm();
  std::printf("%9s %9s %9s %11s %9s %9s %9s\n", "faces", "a move", "ns each", "ns no move",
              "ns asked", "refine", "simplify");
  for (const unsigned even : {5u, 8u, 12u, 15u}) measure(even);
  memory();
}
