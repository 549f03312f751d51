#include "codec/soup/surface_encoder.h"

#include <algorithm>
#include <utility>

#include "codec/file/mesh_features.h"
#include "codec/soup/adjacency.h"
#include "codec/soup/cut.h"
#include "codec/soup/polygons.h"
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

/// Corner j of a face of `size` corners is what in the face turned back?
std::uint32_t turned_back(std::uint32_t j, std::uint32_t size) {
  return (size - j) % size;
}

/// Reversed faces, which a decoder turns back, in the new order.
void put_reversed(const Faces& faces, std::span<const std::uint32_t> reversed,
                  EncodedSurface& out) {
  if (reversed.empty()) return;
  std::vector<bool> turned(faces.count());
  for (const std::uint32_t f : reversed) turned[f] = true;
  for (std::uint32_t i = 0; i < out.order.faces.size(); ++i) {
    const std::uint32_t f = out.order.faces[i];
    if (turned[f])
      out.order.first_corners[i] = turned_back(out.order.first_corners[i], faces.size(f));
  }
  rans::Encoder stream;
  EncodeTo coder(stream);
  ReversedModel model;
  std::uint32_t end = 0;
  for (std::uint32_t i = 0; i < out.order.faces.size(); ++i) {
    if (!turned[out.order.faces[i]]) continue;
    const std::uint32_t first = i;
    while (i < out.order.faces.size() && turned[out.order.faces[i]]) ++i;
    out.runs.push_back({first, i - first});
    model.code(coder, out.runs.back(), end);
    end = i;
    out.turned_faces += i - first;
  }
  out.features |= feature::reversed;
  stream.finish(out.turned);
}

void put_sizes(const Faces& faces, EncodedSurface& out) {
  rans::Encoder stream;
  stream.reserve(3 * out.order.faces.size());
  EncodeTo coder(stream);
  SizeModel model;
  bool polygons = false;
  for (const std::uint32_t f : out.order.faces) {
    const std::uint32_t size = faces.size(f);
    model.code(coder, size);
    polygons |= size > 3;
  }
  if (!polygons) return;
  out.features |= feature::polygons;
  stream.finish(out.polygons);
}

/// Makes one vertex again of those that are copies of each other. `vertices` are those of the
/// surface in the coded order.
void put_stitches(const SurfaceFaces& surface, std::span<const std::uint32_t> vertices,
                  EncodedSurface& out) {
  const CutSurface& cut = *surface.cut;
  const std::uint32_t count = static_cast<std::uint32_t>(vertices.size());
  const std::uint32_t inputs = surface.vertex_count - static_cast<std::uint32_t>(cut.copied.size());
  const auto point = [&](std::uint32_t v) { return v < inputs ? v : cut.copied[v - inputs]; };
  out.copies = cut.copied.size();
  out.features |= feature::copies;
  std::vector<std::uint32_t> classes(count), first(inputs, Vertex::null_index);
  for (std::uint32_t v = 0; v < count; ++v) {
    std::uint32_t& c = first[point(vertices[v])];
    if (c == Vertex::null_index) c = v;
    classes[v] = c;
  }
  rans::Encoder stream;
  EncodeTo coder(stream);
  Stitching(out.surface.corners, count, static_cast<std::uint32_t>(out.copies))
      .code(coder, classes);
  stream.finish(out.stitches);
  const std::uint32_t points = number_classes(classes);
  out.order.vertices.resize(points);
  for (std::uint32_t n = count; n-- > 0;) out.order.vertices[classes[n]] = point(vertices[n]);
  stitch(classes, out.surface.corners, out.surface.introduced_by);
}

Expected<EncodedSurface> encode_faces(const SurfaceFaces& surface, int level, Wanted wanted) {
  EncodedSurface out;
  const Faces& faces = surface.faces;
  const SurfaceArrays arrays{faces.org, surface.twins, surface.vertex_count, surface.sizes};
  auto coded = encode_connectivity(arrays, level, wanted == Wanted::surface_with_twins);
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
    for (std::uint32_t i = 0; i < order.size(); ++i) {
      const std::uint32_t gate = coded->gates[i].index();
      order[i] = faces.face(gate);
      first_corners[i] = gate - faces.begin(order[i]);
    }
  }
  if (surface.cut) put_reversed(faces, surface.cut->reversed, out);
  if (!faces.triangles()) put_sizes(faces, out);

  const bool copies = surface.cut && !surface.cut->copied.empty();
  if (wanted != Wanted::nothing || copies) out.surface = coded_surface(arrays, *coded);
  if (copies)
    put_stitches(surface, coded->vertices, out);
  else
    out.order.vertices = std::move(coded->vertices);
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
  auto coded = adjacency.ends.empty()
                   ? encode_faces({faces, sizes, adjacency.twins, vertex_count}, level, wanted)
                   : encode_cut(std::move(adjacency), likely ? Fans::all : Fans::at_defects);
  if (coded || coded.error().code != ErrorCode::nonmanifold_vertex) return coded;
  return encode_cut(match_edges(faces, vertex_count), Fans::all);
}

/// Appends the faces that repeat others. `out` has those that do not, by their numbers in `all`.
void put_repeats(const Faces& all, std::span<const Repeat> repeats, EncodedSurface& out) {
  const auto surface_faces = static_cast<std::uint32_t>(out.order.faces.size());
  std::vector<std::uint32_t> place(all.count());
  for (std::uint32_t i = 0; i < surface_faces; ++i) place[out.order.faces[i]] = i;
  std::vector<bool> turned(surface_faces);
  for (const ReversedRun& run : out.runs)
    for (std::uint32_t i = 0; i < run.count; ++i) turned[run.first + i] = true;

  struct Coming {
    RepeatModel::Code code;
    std::uint32_t face, first_corner;
  };
  std::vector<Coming> coming;
  coming.reserve(repeats.size());
  for (const auto& [face, base] : repeats) {
    const std::uint32_t at = place[base], size = all.size(face);
    const auto cycle = all.cycle(face), base_cycle = all.cycle(base);
    const std::uint32_t first = out.order.first_corners[at];
    const auto begin = static_cast<std::uint32_t>(
        std::find(cycle.begin(), cycle.end(), base_cycle[first]) - cycle.begin());
    const bool same = cycle[(begin + 1) % size] == base_cycle[(first + 1) % size];
    coming.push_back({{at, same == turned[at]}, face, begin});
  }
  std::sort(coming.begin(), coming.end(), [](const Coming& a, const Coming& b) {
    if (a.code.base != b.code.base) return a.code.base < b.code.base;
    return a.code.reversed != b.code.reversed ? b.code.reversed : a.face < b.face;
  });
  rans::Encoder stream;
  EncodeTo coder(stream);
  RepeatModel model;
  for (const Coming& c : coming) {
    model.code(coder, c.code);
    out.order.faces.push_back(c.face);
    out.order.first_corners.push_back(c.first_corner);
    out.repeated_corners += all.size(c.face);
  }
  stream.finish(out.repeats);
  out.repeated_faces = repeats.size();
  out.features |= feature::repeats;
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
    for (std::uint32_t begin = 0; const std::uint32_t end : edges.ends) {
      crowded += end - begin > 2 ? end - begin : 0;
      begin = end;
    }
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
  put_repeats(all, repeats, *coded);
  return coded;
}

}  // namespace clers::internal
