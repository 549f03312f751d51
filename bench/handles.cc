// What handles and holes cost, for recipes of corpus/recipe.h and mesh files: bits of the S
// symbols, flags, lengths and positions that tell of them.
#include <cstdio>

#include "bench/input.h"
#include "codec/connectivity/connectivity.h"
#include "codec/encode.h"
#include "codec/soup/adjacency.h"
#include "corpus/recipe.h"

int main(int argc, char** argv) {
  using namespace clers;
  using namespace clers::internal;
  std::printf("%-44s %9s %8s %7s %10s %10s %8s\n", "mesh", "faces", "handles", "holes", "bits",
              "per event", "bits/tri");
  for (int i = 1; i < argc; ++i) {
    std::optional<Mesh> mesh = corpus::cook(argv[i]);
    if (!mesh) mesh = bench::read_input(argv[i]).mesh;
    auto twins = find_twins({mesh->corners, mesh->face_sizes}, mesh->vertex_count);
    if (!twins)
      return std::fprintf(stderr, "%s: %s\n", argv[i], describe(twins.error()).c_str()), 1;
    auto coded = encode_connectivity({mesh->corners, *twins, mesh->vertex_count}, default_level);
    if (!coded)
      return std::fprintf(stderr, "%s: %s\n", argv[i], describe(coded.error()).c_str()), 1;
    // The first curve of an open component is where it starts, and costs nothing.
    const ConnectivityCounts& c = coded->counts;
    const std::uint64_t events = c.handles + c.coded_holes;
    const double bits = static_cast<double>(coded->special_cost) / 256;
    std::printf(
        "%-44s %9zu %8llu %7llu %10.0f %10.1f %8.3f\n", argv[i], mesh->face_count(),
        static_cast<unsigned long long>(c.handles), static_cast<unsigned long long>(c.coded_holes),
        bits, events ? bits / static_cast<double>(events) : 0.0,
        8.0 * static_cast<double>(coded->bytes.size()) / static_cast<double>(mesh->face_count()));
  }
}
