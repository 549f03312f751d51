#include "bench/simplifiers.h"

#include "topology/modeling/clusters.h"
#include "topology/modeling/simplify.h"
#include "topology/surface.h"

namespace clers::bench {
namespace {

/// `how(surface, positions)` simplifies.
template <class How>
Simplifier ours(std::string name, How how) {
  return {std::move(name), [how](const Input& input, std::size_t faces) {
            auto surface = Surface::from_faces(input.triangles, input.vertex_count);
            Triangles out;
            if (!surface) return out;
            std::vector<Position3> at = triangles_of(input).points;
            how(*surface, at, static_cast<std::int64_t>(faces));
            std::vector<std::uint32_t> number(surface->vertex_limit());
            for (const Vertex v : surface->vertices()) {
              number[v.index()] = static_cast<std::uint32_t>(out.points.size());
              out.points.push_back(at[v.index()]);
            }
            for (const Face f : surface->faces())
              for (unsigned i = 0; i < 3; ++i)
                out.corners.push_back(number[surface->org(half_edge(f, i)).index()]);
            return out;
          }};
}

Simplifier of_shape(std::string name, double shape) {
  return ours(std::move(name),
              [shape](Surface& surface, std::vector<Position3>& at, std::int64_t faces) {
                SimplifyOptions options;
                options.faces = faces;
                options.shape = shape;
                (void)simplify(surface, at, options);
              });
}

}  // namespace

std::vector<Simplifier> our_simplifiers() {
  return {of_shape("clers", SimplifyOptions{}.shape), of_shape("clers, shape 0.001", 1e-3),
          of_shape("clers, shape 0.004", 4e-3),
          ours("clers, four-face clusters",
               [](Surface& surface, std::vector<Position3>& at, std::int64_t faces) {
                 Creases none;
                 ClusterOptions options;
                 options.faces = faces;
                 (void)simplify_by_clusters(surface, at, none, options);
               })};
}

}  // namespace clers::bench
