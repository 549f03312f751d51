#include "bench/simplifiers.h"

#include "topology/modeling/simplify.h"
#include "topology/surface.h"

namespace clers::bench {
namespace {

Triangles simplified(const Input& input, const SimplifyOptions& options) {
  auto surface = Surface::from_faces(input.triangles, input.vertex_count);
  Triangles out;
  if (!surface) return out;
  std::vector<Position3> at = triangles_of(input).points;
  if (!simplify(*surface, at, options)) return out;
  std::vector<std::uint32_t> number(surface->vertex_limit());
  for (const Vertex v : surface->vertices()) {
    number[v.index()] = static_cast<std::uint32_t>(out.points.size());
    out.points.push_back(at[v.index()]);
  }
  for (const Face f : surface->faces())
    for (unsigned i = 0; i < 3; ++i)
      out.corners.push_back(number[surface->org(half_edge(f, i)).index()]);
  return out;
}

Simplifier ours(std::string name, double shape) {
  return {std::move(name), [shape](const Input& input, std::size_t faces) {
            SimplifyOptions options;
            options.faces = static_cast<std::int64_t>(faces);
            options.shape = shape;
            return simplified(input, options);
          }};
}

}  // namespace

std::vector<Simplifier> our_simplifiers() {
  return {ours("clers", SimplifyOptions{}.shape), ours("clers, shape 0.001", 1e-3),
          ours("clers, shape 0.004", 4e-3)};
}

}  // namespace clers::bench
