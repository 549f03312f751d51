#include "codec/mesh_decoder.h"

#include <algorithm>
#include <cstring>
#include <string>
#include <utility>

#include "codec/file_order.h"
#include "codec/loose_faces.h"
#include "codec/plain_faces.h"
#include "codec/polygons.h"
#include "codec/stitching.h"

namespace clers {
namespace {

Failure<Error> broken(const MeshSections::Stream& stream, std::string what) {
  return fail(ErrorCode::invalid, Place::byte, stream.at, std::move(what));
}

Expected<Done> finished(const rans::Decoder& in, const MeshSections::Stream& stream,
                        const char* what) {
  if (in.finished()) return Done{};
  return broken(stream, std::string(what) + " do not end where their bytes end");
}

Expected<std::vector<TurnedRun>> decode_turned(const MeshSections& sections) {
  rans::Decoder in(sections.turned.bytes);
  DecodeFrom coder(in);
  TurnedModel model;
  std::vector<TurnedRun> runs;
  std::uint32_t end = 0;
  for (std::uint64_t i = 0; i < sections.turned_runs; ++i) {
    const TurnedRun run = model.code(coder, {}, end);
    if (run.first < end || (i > 0 && run.first == end) || run.first >= sections.surface_faces ||
        run.count == 0 || run.count > sections.surface_faces - run.first)
      return broken(sections.turned, "a run of turned faces is out of order or beyond all faces");
    end = run.first + run.count;
    runs.push_back(run);
  }
  if (auto ok = finished(in, sections.turned, "the turned faces"); !ok) return Failure{ok.error()};
  return runs;
}

/// Sizes of the polygons that consecutive triangles make.
Expected<std::vector<std::uint32_t>> decode_sizes(const MeshSections& sections,
                                                  std::span<const std::uint32_t> triangles) {
  rans::Decoder in(sections.polygons.bytes);
  DecodeFrom coder(in);
  SizeModel model;
  std::vector<std::uint32_t> sizes;
  sizes.reserve(static_cast<std::size_t>(sections.surface_faces));
  std::size_t left = triangles.size() / 3;
  for (std::uint64_t i = 0; i < sections.surface_faces; ++i) {
    const std::uint32_t size = model.code(coder, 3);
    if (size < 3 || size - 2 > left)
      return broken(sections.polygons, "polygon " + std::to_string(i) + " has " +
                                           std::to_string(size) + " corners where " +
                                           std::to_string(left) + " triangles are left");
    const std::uint32_t* t = triangles.data() + triangles.size() - 3 * left;
    for (std::uint32_t k = 3; k < size; ++k, t += 3)
      if (t[3] != t[2] || t[4] != t[1])
        return broken(sections.polygons, "the triangles of polygon " + std::to_string(i) +
                                             " do not follow each other");
    left -= size - 2;
    sizes.push_back(size);
  }
  if (left != 0)
    return broken(sections.polygons, std::to_string(left) + " triangles belong to no polygon");
  if (auto ok = finished(in, sections.polygons, "the polygons"); !ok) return Failure{ok.error()};
  return sizes;
}

/// Makes vertices of the mesh of those of the surface.
Expected<Done> stitch(const MeshSections& sections, std::span<std::uint32_t> triangles) {
  rans::Decoder in(sections.stitches.bytes);
  DecodeFrom coder(in);
  std::vector<std::uint32_t> classes(sections.connectivity.vertices, Stitching::unknown);
  if (!Stitching(triangles, sections.connectivity.vertices).code(coder, classes))
    return broken(sections.stitches, "a vertex is a copy of none");
  if (auto ok = finished(in, sections.stitches, "the copies"); !ok) return ok;
  if (number_classes(classes) != sections.surface_vertices)
    return broken(sections.stitches,
                  "not " + std::to_string(sections.copies) + " copies, as it was said");
  for (std::uint32_t& v : triangles) v = classes[v];
  return Done{};
}

Expected<Done> append_loose(const MeshSections& sections, std::span<const std::uint32_t> triangles,
                            std::vector<std::uint32_t>& sizes,
                            std::vector<std::uint32_t>& corners) {
  rans::Decoder in(sections.loose.bytes);
  DecodeFrom coder(in);
  LooseFaceModel model(triangles, static_cast<std::uint32_t>(sections.surface_vertices),
                       static_cast<std::uint32_t>(sections.vertices));
  std::uint64_t left = sections.loose_corners;
  for (std::uint64_t i = 0; i < sections.loose_faces; ++i) {
    const std::uint32_t size = model.code_size(coder, 0);
    if (size > left) return broken(sections.loose, "more loose corners than declared");
    left -= size;
    sizes.push_back(size);
    corners.resize(corners.size() + size);
    if (!model.code_corners(coder, std::span(corners).last(size)))
      return broken(sections.loose, "loose face " + std::to_string(i) + " has no such vertex");
  }
  if (left != 0) return broken(sections.loose, "fewer loose corners than declared");
  return finished(in, sections.loose, "the loose faces");
}

/// No sizes where all faces are triangles.
void drop_sizes_of_triangles(Mesh& mesh) {
  const auto is_triangle = [](std::uint32_t size) { return size == 3; };
  if (std::all_of(mesh.face_sizes.begin(), mesh.face_sizes.end(), is_triangle))
    mesh.face_sizes.clear();
}

Expected<Done> decode_plain(const MeshSections& sections, Mesh& mesh) {
  rans::Decoder in(sections.plain.bytes);
  DecodeFrom coder(in);
  PlainFaceModel model(mesh.vertex_count);
  mesh.corners.resize(static_cast<std::size_t>(sections.corners));
  mesh.face_sizes.reserve(static_cast<std::size_t>(sections.faces));
  std::size_t at = 0;
  for (std::uint64_t f = 0; f < sections.faces; ++f) {
    const std::uint32_t size = model.code_size(coder, 0);
    if (size > mesh.corners.size() - at)
      return broken(sections.plain, "more corners than declared");
    if (!model.code_corners(coder, std::span(mesh.corners).subspan(at, size)))
      return broken(sections.plain, "face " + std::to_string(f) + " has no such vertex");
    at += size;
    mesh.face_sizes.push_back(size);
  }
  if (at != mesh.corners.size()) return broken(sections.plain, "fewer corners than declared");
  drop_sizes_of_triangles(mesh);
  return finished(in, sections.plain, "the faces");
}

/// Values in another order: to[i] = from[source(i)], and `values` of them.
template <class Source>
void reorder(Attribute& a, std::size_t values, Source source) {
  const std::size_t stride = a.stride();
  std::vector<std::byte> from = std::move(a.data);
  a.data.resize(from.size());
  for (std::size_t i = 0; i < values; ++i)
    std::memcpy(a.data.data() + i * stride, from.data() + source(i) * stride, stride);
}

}  // namespace

Expected<Done> restore_order(const MeshSections& sections, Mesh& mesh) {
  if (sections.order.bytes.empty()) return Done{};
  FileOrder order;
  const Faces faces(mesh.corners, mesh.face_sizes);
  {
    rans::Decoder in(sections.order.bytes);
    DecodeFrom coder(in);
    if (!FileOrderCoder(faces, mesh.vertex_count).code(coder, order))
      return broken(sections.order, "the order names a face or a vertex twice, or none");
    if (auto ok = finished(in, sections.order, "the orders"); !ok) return ok;
  }
  std::vector<std::uint32_t> corners, sizes, source;  // source: the new corner of each old one
  corners.reserve(mesh.corners.size());
  for (std::uint32_t j = 0; j < faces.count(); ++j) {
    const std::uint32_t f = order.faces[j], size = faces.size(f);
    for (std::uint32_t i = 0; i < size; ++i) {
      source.push_back(faces.begin(f) + (order.first_corners[j] + i) % size);
      corners.push_back(order.vertices[mesh.corners[source.back()]]);
    }
    if (!mesh.triangles_only()) sizes.push_back(size);
  }
  std::vector<std::uint32_t> new_vertex(mesh.vertex_count);
  for (std::uint32_t v = 0; v < mesh.vertex_count; ++v) new_vertex[order.vertices[v]] = v;
  for (Attribute& a : mesh.attributes) {
    switch (a.domain) {
      case Domain::vertex:
        reorder(a, new_vertex.size(), [&](std::size_t v) { return new_vertex[v]; });
        break;
      case Domain::face:
        reorder(a, faces.count(), [&](std::size_t f) { return order.faces[f]; });
        break;
      case Domain::corner:
        reorder(a, source.size(), [&](std::size_t c) { return source[c]; });
        break;
    }
  }
  mesh.corners = std::move(corners);
  mesh.face_sizes = std::move(sizes);
  return Done{};
}

Expected<DecodedFaces> decode_faces(const MeshSections& sections) {
  DecodedFaces result;
  Mesh& mesh = result.mesh;
  mesh.name = sections.name;
  mesh.vertex_count = static_cast<std::uint32_t>(sections.vertices);
  if (sections.features == feature::plain) {
    if (auto ok = decode_plain(sections, mesh); !ok) return Failure{ok.error()};
    result.all_on_surface = mesh.triangles_only();
    if (!result.all_on_surface) result.triangles = fan_triangles(mesh.corners, mesh.face_sizes);
    return result;
  }
  std::vector<std::uint32_t> triangles(3 * std::size_t(sections.connectivity.faces));
  auto counts = decode_connectivity(sections.connectivity_bytes, sections.connectivity_at,
                                    sections.connectivity, triangles);
  if (!counts) return Failure{counts.error()};
  result.counts = *counts;

  if (sections.features & feature::turned) {
    auto turned = decode_turned(sections);
    if (!turned) return Failure{turned.error()};
    result.turned = std::move(*turned);
  }
  std::vector<std::uint32_t> sizes;
  if (sections.features & feature::polygons) {
    auto decoded = decode_sizes(sections, triangles);
    if (!decoded) return Failure{decoded.error()};
    sizes = std::move(*decoded);
  }
  if (sections.features & feature::copies)
    if (auto ok = stitch(sections, triangles); !ok) return Failure{ok.error()};
  if (!(sections.features & (feature::polygons | feature::loose))) {
    mesh.corners = std::move(triangles);
    return result;
  }

  mesh.corners.reserve(static_cast<std::size_t>(sections.corners));
  mesh.face_sizes.reserve(static_cast<std::size_t>(sections.faces));
  if (sections.features & feature::polygons) {
    const std::uint32_t* t = triangles.data();
    for (const std::uint32_t size : sizes) {
      mesh.corners.insert(mesh.corners.end(), {t[0], t[1]});
      for (std::uint32_t k = size - 2; k-- > 0;) mesh.corners.push_back(t[3 * std::size_t(k) + 2]);
      t += 3 * std::size_t(size - 2);
    }
    mesh.face_sizes = std::move(sizes);
  } else {
    mesh.corners = triangles;
    mesh.face_sizes.assign(triangles.size() / 3, 3);
  }
  if (sections.features & feature::loose)
    if (auto ok = append_loose(sections, triangles, mesh.face_sizes, mesh.corners); !ok)
      return Failure{ok.error()};
  drop_sizes_of_triangles(mesh);
  result.all_on_surface = false;
  result.triangles = std::move(triangles);
  return result;
}

void turn_back(Mesh& mesh, std::span<const TurnedRun> runs) {
  std::size_t face = 0, begin = 0;
  const auto size = [&](std::size_t f) { return mesh.triangles_only() ? 3 : mesh.face_sizes[f]; };
  for (const TurnedRun& run : runs) {
    for (; face < run.first; ++face) begin += size(face);
    for (; face < std::size_t(run.first) + run.count; ++face) {
      const auto first = mesh.corners.begin() + static_cast<std::ptrdiff_t>(begin);
      begin += size(face);
      std::reverse(first + 1, mesh.corners.begin() + static_cast<std::ptrdiff_t>(begin));
    }
  }
}

}  // namespace clers
