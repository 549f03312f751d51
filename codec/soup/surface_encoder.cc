// Cut only where the faces are no manifold; cut again where closed fans turn out to touch.
#include "codec/soup/surface_encoder.h"

#include <utility>

#include "codec/soup/adjacency.h"
#include "codec/soup/cut.h"
#include "codec/soup/distinct_faces.h"
#include "codec/soup/polygon_sizes.h"
#include "codec/soup/repeated_faces.h"
#include "codec/soup/reversed_faces.h"
#include "codec/soup/stitching.h"

namespace clers::internal {
namespace {

/// A surface by its faces, as it is or as it was cut.
struct SurfaceFaces {
  const Faces& faces;
  std::span<const std::uint32_t> sizes;  ///< empty: triangles
  std::span<HalfEdge> twins;
  std::uint32_t vertex_count;
  const CutSurface* cut = nullptr;
};

Expected<EncodedSurface> encode_faces(const SurfaceFaces& surface, int level, Wanted wanted) {
  EncodedSurface out;
  const Faces& faces = surface.faces;
  const SurfaceArrays arrays{faces.org, surface.twins, surface.vertex_count, surface.sizes};
  const bool copies = surface.cut && !surface.cut->copied.empty();
  const bool no_surface = wanted == Wanted::nothing && !copies;
  auto coded = encode_connectivity(arrays, level,
                                   no_surface                             ? Kept::nothing
                                   : wanted == Wanted::surface_with_twins ? Kept::corners_and_twins
                                                                          : Kept::corners);
  if (!coded) return Failure{coded.error()};

  std::vector<std::uint32_t>& order = out.order.faces;
  std::vector<std::uint32_t>& first_corners = out.order.first_corners;
  order.resize(faces.count());
  first_corners.resize(faces.count());
  if (faces.triangles()) {
    for (std::uint32_t i = 0; i < order.size(); ++i) {
      order[i] = left(coded->gates[i]).index();
      first_corners[i] = corner(coded->gates[i]);
    }
  } else {
    std::vector<std::uint32_t> sizes(order.size());
    for (std::uint32_t i = 0; i < order.size(); ++i) {
      const std::uint32_t gate = coded->gates[i].index(), f = faces.face(gate);
      order[i] = f;
      first_corners[i] = gate - faces.begin(f);
      sizes[i] = faces.size(f);
    }
    out.polygons = encode_sizes(sizes);
  }
  if (surface.cut && !surface.cut->reversed.empty()) {
    out.reversed_runs = reversed_runs(faces, surface.cut->reversed, out.order);
    out.reversed = encode_reversed(out.reversed_runs, order.size());
  }

  if (!no_surface) out.surface = coded_surface(surface.vertex_count, *coded);
  out.order.vertices = std::move(coded->vertices);
  if (copies) {
    const std::vector<std::uint32_t>& copied = surface.cut->copied;
    const auto inputs = surface.vertex_count - static_cast<std::uint32_t>(copied.size());
    for (std::uint32_t& v : out.order.vertices)
      if (v >= inputs) v = copied[v - inputs];
    out.copies = encode_copies(inputs, out.surface, out.order.vertices);
    out.copied_vertices = copied.size();
  }
  out.connectivity = std::move(coded->bytes);
  out.counts = coded->counts;
  return out;
}

/// Encodes faces that repeat none. At which vertices closed fans touch shows while the surface is
/// unbuilt, and costs nothing till then; if it shows, or is likely to, all vertices are looked at.
Expected<EncodedSurface> encode_distinct(const Faces& faces, std::span<const std::uint32_t> sizes,
                                         Adjacency adjacency, std::uint32_t vertex_count, int level,
                                         Wanted wanted) {
  const auto encode_cut = [&](Adjacency edges, Fans fans) {
    CutSurface surface = cut(faces, vertex_count, std::move(edges), fans);
    return encode_faces(
        {Faces(surface.corners, sizes), sizes, surface.twins,
         vertex_count + static_cast<std::uint32_t>(surface.copied.size()), &surface},
        level, wanted);
  };
  const bool likely = adjacency.sides.size() > faces.count() / 64;
  auto coded = adjacency.edges() == 0
                   ? encode_faces({faces, sizes, adjacency.twins, vertex_count}, level, wanted)
                   : encode_cut(std::move(adjacency), likely ? Fans::all : Fans::at_defects);
  if (coded || coded.error().code != ErrorCode::nonmanifold_vertex) return coded;
  return encode_cut(match_edges(faces, vertex_count), Fans::all);
}

}  // namespace

Expected<EncodedSurface> encode_surface(std::span<const std::uint32_t> corners,
                                        std::span<const std::uint32_t> sizes,
                                        std::uint32_t vertex_count, int level, Wanted wanted,
                                        const std::function<bool()>& give_up) {
  const Faces all(corners, sizes);
  Adjacency adjacency = match_edges(all, vertex_count);
  const std::vector<Repeat> repeats = find_repeats(all, adjacency);
  const auto shall_give_up = [&](const Adjacency& edges) {
    std::size_t crowded = 0;
    for (std::uint32_t e = 0; e < edges.edges(); ++e)
      if (const std::size_t sides = edges.edge(e).size(); sides > 2) crowded += sides;
    return crowded > edges.twins.size() / 2 && give_up();
  };
  EncodedSurface nothing;
  nothing.given_up = true;
  if (repeats.empty()) {
    if (shall_give_up(adjacency)) return nothing;
    return encode_distinct(all, sizes, std::move(adjacency), vertex_count, level, wanted);
  }
  const DistinctFaces distinct(all, repeats);
  const Faces faces(distinct.corners, distinct.sizes);
  adjacency = distinct.adjacency(all, std::move(adjacency));
  if (shall_give_up(adjacency)) return nothing;
  auto coded =
      encode_distinct(faces, distinct.sizes, std::move(adjacency), vertex_count, level, wanted);
  if (!coded) return coded;
  for (std::uint32_t& f : coded->order.faces) f = distinct.faces[f];
  coded->repeats = encode_repeats(all, repeats, coded->reversed_runs, coded->order);
  coded->repeated_faces = repeats.size();
  return coded;
}

}  // namespace clers::internal
