// The experiment of Fig. 19 and Table 1 of Topological mesh operators: what it costs that a mesh
// follows a surface, and what its meshes cost in the codec.
//
// usage: deforming_sphere [--frames DIR]    DIR: gets the five frames of Fig. 19 as PLY
//
// For every iteration: faces, milliseconds of processor time to deform and to adapt, and to make a
// mesh of the same surface from the base instead; the polyhedron's volume over the sphere's, which
// the flow keeps; the longest edge over what its curvature asks for.
#include "topology/figures/deforming_sphere.h"

#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>

#include "bench/timing.h"
#include "codec/encode.h"
#include "codec/io/io.h"
#include "codec/surface.h"
#include "corpus/generate.h"
#include "topology/validate.h"

namespace clers::bench {
namespace {

using figures::DeformingSphere;

constexpr unsigned last = 63;
constexpr unsigned shown[] = {0, 20, 30, 35, last};

Mesh mesh_of(const DeformingSphere& sphere) {
  const Surface& surface = sphere.mesh().surface();
  std::vector<float> at(3 * std::size_t{surface.vertex_limit()});
  for (const Vertex v : surface.vertices())
    for (std::size_t k = 0; k < 3; ++k) at[3 * v.index() + k] = static_cast<float>(sphere[v][k]);
  const AttributeView position{
      "position", Domain::vertex, Scalar::float32, 3, std::as_bytes(std::span(at)), 0};
  return std::move(to_mesh(surface, std::vector{position})->mesh);
}

void write(const Mesh& mesh, const std::filesystem::path& file) {
  const auto written = io::write({&mesh, 1}, io::Format::ply);
  std::ofstream out(file, std::ios::binary);
  out.write(reinterpret_cast<const char*>(written->bytes.data()),
            static_cast<std::streamsize>(written->bytes.size()));
  out.close();
  if (!out) std::fprintf(stderr, "deforming_sphere: cannot write %s\n", file.c_str());
}

/// Bits a triangle at level 5, connectivity alone and with positions of 14 bits.
std::string bits(const Mesh& mesh) {
  Mesh bare = mesh;
  bare.attributes.clear();
  EncodeOptions quantised;
  quantised.precisions = {{"position", Precision::of_bits(14)}};
  const double f = static_cast<double>(mesh.face_count());
  char text[99];
  std::snprintf(text, sizeof text, "%zu triangles, connectivity %.3f, all with q14 %.2f bits each",
                mesh.face_count(),
                8. * static_cast<double>(encode(MeshView(bare))->bytes.size()) / f,
                8. * static_cast<double>(encode(MeshView(mesh), quantised)->bytes.size()) / f);
  return text;
}

/// Seconds that so many samples take: that part of adapting is the surface's, not the mesh's.
double sampling_time(const DeformingSphere& sphere, std::uint64_t samples) {
  const double start = thread_seconds();
  double sum = 0;
  while (samples != 0)
    for (const HalfEdge h : sphere.mesh().surface().edges()) {
      sum += sphere.mesh().sample(h).now[0];
      if (--samples == 0) break;
    }
  // The sum is used, so that the compiler must make it.
  return sum == -1 ? 0 : thread_seconds() - start;
}

int run(const std::filesystem::path& frames) {
  const DeformingSphere::Criterion criterion;
  const double begin = thread_seconds();
  DeformingSphere sphere(criterion);
  const double init = thread_seconds() - begin;
  double deform = 0, adapt = 0, rebuild = 0, sampling = 0;
  const double exact =
      4. / 3 * 3.14159265358979323846 * sphere.radius * sphere.radius * sphere.radius;
  std::printf("%4s %8s %8s %8s %9s %9s %9s %8s %8s\n", "", "faces", "made", "welded", "deform",
              "adapt", "rebuild", "volume", "edges");
  std::vector<std::string> coded;
  for (unsigned i = 0; i <= last; ++i) {
    const double start = thread_seconds();
    if (i != 0) sphere.deform();
    const double deformed = thread_seconds();
    const Adapted done = i != 0 ? sphere.adapt() : Adapted();
    const double adapted = thread_seconds();
    sampling += sampling_time(sphere, done.refined);
    const double sampled = thread_seconds();
    const DeformingSphere fresh(criterion, i);
    const double rebuilt = thread_seconds();
    if (i != 0)
      deform += deformed - start, adapt += adapted - deformed, rebuild += rebuilt - sampled;
    std::printf("%4u %8lld %8llu %8llu %9.2f %9.2f %9.2f %8.4f %8.2f\n", i,
                static_cast<long long>(sphere.mesh().surface().characteristic().f),
                static_cast<unsigned long long>(done.refined),
                static_cast<unsigned long long>(done.simplified), 1e3 * (deformed - start),
                1e3 * (adapted - deformed), 1e3 * (rebuilt - sampled), sphere.volume() / exact,
                sphere.worst_edge());
    if (std::find(std::begin(shown), std::end(shown), i) != std::end(shown)) {
      const Mesh mesh = mesh_of(sphere);
      coded.push_back("iteration " + std::to_string(i) + ": " + bits(mesh));
      if (!frames.empty()) write(mesh, frames / ("sphere-" + std::to_string(i) + ".ply"));
    }
  }
  if (!validate(sphere.mesh().surface()).empty()) return std::printf("NOT VALID\n"), 1;
  const double total = deform + adapt;
  std::printf("\nTable 1, ms, means over %u iterations\n", last);
  std::printf("  init %.2f   deform %.2f   adapt %.2f   total %.2f   adapt's share %.0f %%\n",
              1e3 * init, 1e3 * deform / last, 1e3 * adapt / last, 1e3 * total / last,
              100 * adapt / total);
  std::printf("  of adapt, sampling the flow from its beginning: %.2f; rebuilding instead: %.2f\n",
              1e3 * sampling / last, 1e3 * rebuild / last);
  std::printf("\nThe meshes in the codec, level 5\n");
  for (const std::string& line : coded) std::printf("  %s\n", line.c_str());
  Mesh random = corpus::icosphere(6);
  random = corpus::flip_edges(std::move(random), 4 * random.face_count(), 1);
  std::printf("  flipped at random: %s\n", bits(random).c_str());
  return 0;
}

}  // namespace
}  // namespace clers::bench

int main(int argc, char** argv) {
  if (argc == 1) return clers::bench::run({});
  if (argc == 3 && std::strcmp(argv[1], "--frames") == 0) {
    std::error_code error;
    std::filesystem::create_directories(argv[2], error);
    return clers::bench::run(argv[2]);
  }
  std::fprintf(stderr, "usage: deforming_sphere [--frames DIR]\n");
  return 2;
}
