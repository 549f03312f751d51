#include "codec/surface_encoder.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "codec/adjacency.h"
#include "codec/cut.h"
#include "codec/mesh_features.h"
#include "codec/polygons.h"
#include "codec/stitching.h"
#include "codec/turned_faces.h"

namespace clers {
namespace {

/// A surface by its faces, as it is or as it was cut.
struct SurfaceFaces {
  const Faces& faces;
  std::span<HalfEdge> twins;
  std::uint32_t vertex_count;
  const CutSurface* cut = nullptr;
};

/// Faces that a decoder turns back, in the new order.
void put_turned(const std::vector<bool>& turned, EncodedSurface& out) {
  rans::Encoder stream;
  EncodeTo coder(stream);
  TurnedModel model;
  std::uint32_t end = 0;
  for (std::uint32_t i = 0; i < out.order.faces.size(); ++i) {
    if (!turned[out.order.faces[i]]) continue;
    const std::uint32_t first = i;
    while (i < out.order.faces.size() && turned[out.order.faces[i]]) ++i;
    model.code(coder, {first, i - first}, end);
    end = i;
    ++out.turned_runs;
    out.turned_faces += i - first;
  }
  if (out.turned_runs == 0) return;
  out.features |= feature::turned;
  stream.finish(out.turned);
}

void put_sizes(const Faces& faces, std::span<const std::uint32_t> gates, EncodedSurface& out) {
  rans::Encoder stream;
  EncodeTo coder(stream);
  SizeModel model;
  bool polygons = false;
  for (const std::uint32_t gate : gates) {
    const std::uint32_t size = faces.size(faces.face(gate));
    model.code(coder, size);
    polygons |= size > 3;
  }
  if (!polygons) return;
  out.features |= feature::polygons;
  stream.finish(out.polygons);
}

/// Makes one vertex again of those that are copies of each other. `vertices` are those of the
/// surface in the coded order.
void put_stitches(const CutSurface& cut, std::span<const std::uint32_t> vertices,
                  EncodedSurface& out) {
  const std::uint32_t count = static_cast<std::uint32_t>(vertices.size());
  std::vector<std::uint32_t> classes(count, Stitching::unknown);
  {
    const std::uint32_t points =
        cut.point.empty() ? 0 : *std::max_element(cut.point.begin(), cut.point.end()) + 1;
    std::vector<std::uint32_t> first(points, Stitching::unknown);
    for (const std::uint32_t v : out.triangles) {
      std::uint32_t& c = first[cut.point[vertices[v]]];
      if (c == Stitching::unknown) c = v;
      classes[v] = c;
    }
  }
  std::vector<std::uint32_t> numbers = classes;
  const std::uint32_t points = number_classes(numbers);
  out.copies = count - points;
  if (out.copies > 0) {
    out.features |= feature::copies;
    rans::Encoder stream;
    EncodeTo coder(stream);
    Stitching(out.triangles, count).code(coder, classes);
    stream.finish(out.stitches);
  }
  out.order.vertices.resize(points);
  for (std::uint32_t v = 0; v < count; ++v) out.order.vertices[numbers[v]] = cut.point[vertices[v]];
  for (std::uint32_t& v : out.triangles) v = numbers[v];
}

/// Corner j of a face of `size` corners is what in the face turned back?
std::uint32_t turned_back(std::uint32_t j, std::uint32_t size) {
  return (size - j) % size;
}

Expected<EncodedSurface> encode_faces(const SurfaceFaces& surface, int level, bool with_triangles) {
  EncodedSurface out;
  const Faces& faces = surface.faces;
  Triangulation fans;
  SurfaceArrays arrays{faces.org, surface.twins, surface.vertex_count};
  if (!faces.triangles()) {
    fans = triangulate(faces, surface.twins, surface.vertex_count);
    arrays = {fans.corners, fans.twins, surface.vertex_count};
  }
  auto coded = encode_connectivity(arrays, level);
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
    for (std::uint32_t t = 0; t < coded->gates.size(); ++t)
      if (coded->gates[t] != half_edge(Face(t), 0))
        return fail(ErrorCode::internal, "the walk over polygons is not that over their triangles");
    for (std::uint32_t i = 0; i < order.size(); ++i) {
      order[i] = faces.face(fans.gates[i]);
      first_corners[i] = fans.gates[i] - faces.begin(order[i]);
    }
  }
  if (surface.cut) {
    for (std::uint32_t i = 0; i < order.size(); ++i) {
      const std::uint32_t f = order[i], size = faces.size(f), input = surface.cut->faces[f];
      const std::uint32_t corner = (surface.cut->first_corners[f] + first_corners[i]) % size;
      order[i] = input;
      first_corners[i] = surface.cut->turned[input] ? turned_back(corner, size) : corner;
    }
  }
  if (surface.cut) put_turned(surface.cut->turned, out);
  if (!faces.triangles()) put_sizes(faces, fans.gates, out);

  if (with_triangles) {
    std::vector<std::uint32_t> number(surface.vertex_count);
    for (std::uint32_t i = 0; i < coded->vertices.size(); ++i) number[coded->vertices[i]] = i;
    out.triangles.reserve(arrays.org.size());
    for (HalfEdge h : coded->gates)
      for (unsigned side = 0; side < 3; ++side, h = lnext(h))
        out.triangles.push_back(number[arrays.org[h.index()]]);
  }
  if (surface.cut)
    put_stitches(*surface.cut, coded->vertices, out);
  else
    out.order.vertices = std::move(coded->vertices);
  out.connectivity = std::move(coded->bytes);
  out.counts = coded->counts;
  out.settled = !surface.cut || surface.cut->order_free;
  return out;
}

Expected<EncodedSurface> encode_cut(const Faces& faces, std::uint32_t vertex_count, int level) {
  const auto encoded = [&](Handles handles) {
    CutSurface surface = cut(faces, vertex_count, handles);
    return encode_faces({Faces(surface.corners, surface.sizes), surface.twins,
                         static_cast<std::uint32_t>(surface.point.size()), &surface},
                        level, true);
  };
  auto coded = encoded(Handles::keep);
  // Where handles would cost a decoder more steps than the format allows, there must be none.
  if (!coded && coded.error().code == ErrorCode::limit) return encoded(Handles::cut);
  return coded;
}

/// Corners and sizes of faces as a decoder will give them.
struct Decoded {
  std::vector<std::uint32_t> corners, sizes;
};
Decoded decoded(const Faces& faces, std::uint32_t vertex_count, const Permutation& order) {
  Decoded result;
  std::vector<std::uint32_t> number(vertex_count);
  for (std::uint32_t i = 0; i < order.vertices.size(); ++i) number[order.vertices[i]] = i;
  result.corners.reserve(faces.org.size());
  for (std::size_t i = 0; i < order.faces.size(); ++i) {
    const auto cycle = faces.cycle(order.faces[i]);
    std::size_t j = order.first_corners[i];
    for (std::size_t k = 0; k < cycle.size(); ++k, j = j + 1 == cycle.size() ? 0 : j + 1)
      result.corners.push_back(number[cycle[j]]);
    if (!faces.triangles()) result.sizes.push_back(static_cast<std::uint32_t>(cycle.size()));
  }
  return result;
}

/// `second` tells the order of what `first` has made.
Permutation composed(const Permutation& first, Permutation second, const Faces& faces) {
  for (std::uint32_t& v : second.vertices) v = first.vertices[v];
  for (std::size_t i = 0; i < second.faces.size(); ++i) {
    const std::uint32_t before = second.faces[i], f = first.faces[before];
    second.faces[i] = f;
    second.first_corners[i] =
        (second.first_corners[i] + first.first_corners[before]) % faces.size(f);
  }
  return second;
}

Bytes bytes_of(const EncodedSurface& s) {
  Bytes all;
  for (const Bytes* part : {&s.turned, &s.polygons, &s.stitches, &s.connectivity}) {
    put_varint(all, part->size());
    put_bytes(all, *part);
  }
  return all;
}

}  // namespace

Expected<EncodedSurface> encode_surface(std::span<const std::uint32_t> corners,
                                        std::span<const std::uint32_t> sizes,
                                        std::uint32_t vertex_count, int level,
                                        bool with_triangles) {
  const Faces faces(corners, sizes);
  if (auto twins = find_twins(faces, vertex_count)) {
    auto coded = encode_faces({faces, *twins, vertex_count}, level, with_triangles);
    if (coded || (coded.error().code != ErrorCode::nonmanifold_vertex &&
                  coded.error().code != ErrorCode::limit))
      return coded;
  }

  // Coding what was coded leads into a circle, nearly always of one. From wherever one comes, the
  // one with the least bytes on the circle is taken.
  auto coded = encode_cut(faces, vertex_count, level);
  if (!coded || coded->settled) return coded;
  std::vector<Bytes> history = {bytes_of(*coded)};
  // Circles can be long where all faces look alike, as in ten triangles on the same three vertices.
  const std::size_t most_rounds = std::max<std::size_t>(16, (1u << 15) / corners.size());
  const Bytes* goal = nullptr;
  for (std::size_t round = 1; round < 2 * most_rounds; ++round) {
    if (goal && bytes_of(*coded) == *goal) break;
    const Decoded again = decoded(faces, vertex_count, coded->order);
    const Faces again_faces(again.corners, again.sizes);
    auto next =
        encode_cut(again_faces, static_cast<std::uint32_t>(coded->order.vertices.size()), level);
    if (!next) return next;
    next->order = composed(coded->order, std::move(next->order), faces);
    coded = std::move(next);
    if (goal) continue;
    Bytes bytes = bytes_of(*coded);
    const auto seen = std::find(history.begin(), history.end(), bytes);
    if (seen != history.end())
      goal = &*std::min_element(seen, history.end(), [](const Bytes& a, const Bytes& b) {
        return a.size() != b.size() ? a.size() < b.size() : a < b;
      });
    else if (history.size() == most_rounds)
      break;
    else
      history.push_back(std::move(bytes));
  }
  // A surface with symmetries may come back to itself renumbered. Values and loose faces must not.
  const Decoded result = decoded(faces, vertex_count, coded->order);
  if (std::equal(result.corners.begin(), result.corners.end(), corners.begin(), corners.end()) &&
      std::equal(result.sizes.begin(), result.sizes.end(), sizes.begin(), sizes.end())) {
    std::iota(coded->order.vertices.begin(), coded->order.vertices.end(), 0u);
    std::iota(coded->order.faces.begin(), coded->order.faces.end(), 0u);
    std::fill(coded->order.first_corners.begin(), coded->order.first_corners.end(), 0u);
  }
  return coded;
}

}  // namespace clers
