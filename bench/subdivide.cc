// What subdivision costs for each triangle it makes, beside OpenMesh.
//
// usage: subdivide [MESH.obj|.ply|.off|.stl]...    without meshes: a torus and a grid, irregular
//
// Nanoseconds of processor time for each triangle that a step leaves, all steps together; of
// several rounds, ours and the peer's by turns, the medians. The peer's step alone is timed, and so
// is ours: the surface is made.
#include <time.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>

#include "bench/input.h"
#include "corpus/generate.h"
#include "topology/modeling/four_eight.h"
#include "topology/modeling/loop.h"
#include "topology/modeling/sqrt3.h"
#include "topology/modeling/test/meshes.h"

namespace clers {
namespace {

using test::Position;
using test::Shape;

double now() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

using Step = std::function<void(Shape&, unsigned)>;

/// Steps, as many as give this many triangles at least.
void measure(const char* scheme, const Shape& control, std::int64_t target, double factor,
             const Step& step, const test::PeerScheme* peer) {
  unsigned times = 0;
  for (double f = static_cast<double>(control.surface.characteristic().f);
       f < static_cast<double>(target); f *= factor)
    ++times;
  if (times == 0) return;
  const test::Plain plain = plain_of(control);
  std::vector<double> ours, theirs;
  double triangles = 0;
  for (int round = 0; round < 5; ++round) {
    Shape shape = control;
    const double start = now();
    double sum = 0;  // of all steps
    for (unsigned i = 0; i < times; ++i) {
      step(shape, i);
      triangles = static_cast<double>(shape.surface.characteristic().f);
      sum += triangles;
    }
    ours.push_back(1e9 * (now() - start) / sum);
    if (peer == nullptr) continue;
    double seconds = 0;
    test::subdivide_by_openmesh(plain, *peer, times, &seconds);
    theirs.push_back(1e9 * seconds / sum);
  }
  std::printf("  %-6s x%-2u %9.0f triangles  %6.0f ns each", scheme, times, triangles,
              median(ours));
  if (peer != nullptr)
    std::printf("   OpenMesh %6.0f   ratio %.2f", median(theirs), median(ours) / median(theirs));
  std::printf("\n");
}

/// After two steps of either scheme, against the peer's mesh.
void check(const Shape& control) {
  double low[3], high[3];
  for (std::size_t k = 0; k < 3; ++k) low[k] = 1e300, high[k] = -1e300;
  for (const Vertex v : control.surface.vertices())
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], control.positions[v][k]);
      high[k] = std::max(high[k], control.positions[v][k]);
    }
  const double size = std::hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]);
  const Characteristic& before = control.surface.characteristic();
  std::printf("  %lld boundary curves, genus %lld, %lld components\n",
              static_cast<long long>(before.b), static_cast<long long>(before.g),
              static_cast<long long>(before.s));
  for (const bool loop : {true, false}) {
    Shape shape = control;
    Creases none;
    for (unsigned i = 0; i < 2; ++i) {
      if (loop)
        (void)subdivide_loop(shape.surface, shape.positions, none);
      else
        (void)subdivide_sqrt3(shape.surface, shape.positions, none,
                              i == 0 ? Sqrt3Step::first : Sqrt3Step::second);
    }
    const Characteristic& after = shape.surface.characteristic();
    const bool counts = after.f == before.f * (loop ? 16 : 9) && after.b == before.b &&
                        after.g == before.g && after.s == before.s;
    const auto found =
        agree(plain_of(shape),
              subdivide_by_openmesh(plain_of(control),
                                    loop ? test::PeerScheme::loop : test::PeerScheme::sqrt3, 2),
              1e-9 * size);  // real meshes have vertices closer than 1e-6
    std::printf("  %-6s x2  counts %s, %s %.2g of the mesh's size from OpenMesh's\n",
                loop ? "loop" : "sqrt3", counts ? "exact" : "WRONG",
                found.wrong.empty() ? "vertices at most" : found.wrong.c_str(),
                found.distance / size);
  }
}

void measure(const Shape& control) {
  static const test::PeerScheme loop_peer = test::PeerScheme::loop,
                                sqrt3_peer = test::PeerScheme::sqrt3;
  Creases none;
  for (const std::int64_t target : {10'000, 100'000, 1'000'000}) {
    if (2 * control.surface.characteristic().f > target) continue;
    measure(
        "loop", control, target, 4,
        [&](Shape& s, unsigned) { (void)subdivide_loop(s.surface, s.positions, none); },
        &loop_peer);
    measure(
        "sqrt3", control, target, 3,
        [&](Shape& s, unsigned i) {
          (void)subdivide_sqrt3(s.surface, s.positions, none,
                                i % 2 == 0 ? Sqrt3Step::first : Sqrt3Step::second);
        },
        &sqrt3_peer);
    Shape tri_quad = control;
    (void)make_tri_quad(
        tri_quad.surface, tri_quad.positions, none, [&](const Surface& s, HalfEdge h) {
          return test::distance(tri_quad.positions[s.org(h)], tri_quad.positions[s.dest(h)]);
        });
    measure(
        "4-8", tri_quad, target, 2,
        [&](Shape& s, unsigned) { (void)subdivide_4_8(s.surface, s.positions, none); }, nullptr);
  }
}

}  // namespace
}  // namespace clers

int main(int argc, char** argv) {
  using namespace clers;
  if (argc < 2) {
    std::printf("a torus of 1200 triangles, 300 edges flipped\n");
    measure(test::shape_of(corpus::flip_edges(corpus::torus(30, 20), 300, 1)));
    std::printf("a grid of 1250 triangles, 300 edges flipped\n");
    measure(test::shape_of(corpus::flip_edges(corpus::grid(25, 25), 300, 1)));
  }
  for (int i = 1; i < argc; ++i) {
    const bench::Input input = bench::read_input(argv[i]);
    std::printf("%s: %zu triangles%s\n", input.name.c_str(), input.triangle_count(),
                input.manifold ? "" : ", no manifold");
    if (!input.manifold) continue;
    const Shape control = test::shape_of(input.mesh);
    check(control);
    measure(control);
  }
}
