// The sequence of decoding: connectivity, what undoes the cuts, other faces, values, reversed
// faces.
#include "codec/file/mesh_decoder.h"

#include <algorithm>
#include <string>
#include <utility>

#include "codec/base/budget.h"
#include "codec/base/parallel.h"
#include "codec/file/file_order.h"

namespace clers::internal {
namespace {

/// No sizes where all faces are triangles.
void drop_sizes_of_triangles(Mesh& mesh) {
  const auto is_triangle = [](std::uint32_t size) { return size == 3; };
  if (std::all_of(mesh.face_sizes.begin(), mesh.face_sizes.end(), is_triangle))
    mesh.face_sizes = {};
}

/// A piece without attributes, and the triangles that those are predicted along.
struct DecodedFaces {
  Mesh mesh;
  std::size_t surface_corners = 0;       ///< so many of mesh.corners are those triangles
  std::vector<std::uint32_t> triangles;  ///< or, with polygons, these are
  std::vector<ReversedRun> reversed;
  ConnectivityCounts counts;

  std::span<const std::uint32_t> predicted_along() const {
    return triangles.empty() ? std::span(mesh.corners).first(surface_corners) : triangles;
  }
};

/// Decodes the triangles of the surface, by vertices of the mesh but for polygons and reversed
/// faces.
struct DecodedSurface {
  ConnectivityCounts counts;
  std::vector<ReversedRun> reversed;
  std::vector<std::uint32_t> sizes;  ///< of polygons, where there are any
};
Expected<DecodedSurface> decode_surface(const PieceSections& sections,
                                        std::span<std::uint32_t> triangles,
                                        std::span<HalfEdge> twins = {}) {
  DecodedSurface result;
  auto counts = decode_connectivity(sections.connectivity_bytes, sections.connectivity_at,
                                    sections.connectivity, triangles, twins);
  if (!counts) return Failure{counts.error()};
  result.counts = *counts;
  if (sections.features & feature::reversed) {
    auto reversed = decode_reversed(sections.reversed, sections.surface_faces);
    if (!reversed) return Failure{reversed.error()};
    result.reversed = std::move(*reversed);
  }
  if (sections.features & feature::polygons) {
    auto sizes = decode_sizes(sections.polygons, triangles);
    if (!sizes) return Failure{sizes.error()};
    result.sizes = std::move(*sizes);
  }
  if (sections.features & feature::copies)
    if (auto ok = decode_copies(sections.copies, sections.connectivity.vertices, triangles); !ok)
      return Failure{ok.error()};
  return result;
}

Expected<DecodedFaces> decode_faces(const PieceSections& sections) {
  DecodedFaces result;
  Mesh& mesh = result.mesh;
  mesh.vertex_count = static_cast<std::uint32_t>(sections.vertices);
  if (sections.features == feature::raw) {
    if (auto ok = decode_raw(sections.raw, mesh.face_sizes, mesh.corners); !ok)
      return Failure{ok.error()};
    drop_sizes_of_triangles(mesh);
    result.surface_corners = mesh.corners.size();
    if (!mesh.triangles_only()) result.triangles = fan_triangles(mesh.corners, mesh.face_sizes);
    return result;
  }
  const bool polygons = sections.features & feature::polygons;
  const std::size_t surface_corners = 3 * std::size_t(sections.connectivity.faces);
  std::vector<std::uint32_t> triangles;
  // What is appended to triangles finds room behind them.
  triangles.reserve(polygons ? surface_corners : static_cast<std::size_t>(sections.corners));
  triangles.resize(surface_corners);
  auto surface = decode_surface(sections, triangles);
  if (!surface) return Failure{surface.error()};
  result.counts = surface->counts;
  result.reversed = std::move(surface->reversed);
  std::span<const std::uint32_t> along = triangles;
  if (sections.may_have_sizes()) mesh.face_sizes.reserve(static_cast<std::size_t>(sections.faces));
  if (polygons) {
    mesh.corners.reserve(static_cast<std::size_t>(sections.corners));
    append_polygons(triangles, surface->sizes, mesh.corners);
    mesh.face_sizes.assign(surface->sizes.begin(), surface->sizes.end());
    result.triangles = std::move(triangles);
    along = result.triangles;
  } else {
    result.surface_corners = surface_corners;
    mesh.corners = std::move(triangles);
    if (sections.may_have_sizes()) mesh.face_sizes.assign(surface_corners / 3, 3);
  }
  std::vector<std::uint32_t>&sizes = mesh.face_sizes, &corners = mesh.corners;
  Expected<Done> ok = Done{};
  if (sections.features & feature::repeats)
    ok = append_repeats(sections.repeats, sections.surface_faces, sizes, corners);
  if (ok && sections.features & feature::folded)
    ok = append_folded(sections.folded, along, sizes, corners);
  if (ok && sections.features & feature::degenerate)
    ok = append_degenerate(sections.degenerate, along,
                           static_cast<std::uint32_t>(sections.surface_vertices), mesh.vertex_count,
                           sizes, corners);
  if (!ok) return Failure{ok.error()};
  drop_sizes_of_triangles(mesh);
  return result;
}

constexpr std::uint64_t each = sizeof(std::uint32_t);

/// What vertices of no surface count, though no array has them before a user makes one.
std::uint64_t isolated_memory(const PieceSections& s) {
  return each * (s.vertices - s.surface_vertices);
}

std::uint64_t attribute_memory(const Attribute& what, std::uint64_t count) {
  return sizeof(Attribute) + what.name.size() + count * what.stride();
}

}  // namespace

PieceMemory memory_of(const PieceSections& s, Values values) {
  // Tables of models and of zstd, which are as large for any piece.
  constexpr std::uint64_t constant = 256 << 10;
  const bool raw = s.features == feature::raw, copied = s.features & feature::copies,
             polygons = s.features & feature::polygons;
  const std::uint64_t sizes = s.may_have_sizes() ? each * s.faces : 0;
  const std::uint64_t triangles = each * (raw        ? 3 * s.corners
                                          : polygons ? 3 * s.connectivity.faces
                                                     : s.corners);
  const std::uint64_t runs = s.reversed.memory();

  PieceMemory memory;
  memory.result = each * s.corners + sizes + isolated_memory(s);
  if (raw) {
    memory.faces = memory.result + triangles;
  } else {
    const std::uint64_t corners = 3 * s.connectivity.faces, vertices = s.connectivity.vertices;
    memory.faces =
        triangles +
        std::max(
            {connectivity_memory(s.connectivity, false),
             runs + sizes +
                 (copied ? each * vertices +
                               std::max(Stitching::memory(corners, vertices, s.copies.copies),
                                        each * vertices)
                         : 0),
             runs + sizes + (polygons ? memory.result : 0) +
                 (s.features & feature::degenerate ? CornersOf::memory(corners, s.surface_vertices)
                                                   : 0)});
  }
  memory.values = memory.result + runs + (raw || polygons ? triangles : 0);
  if (values == Values::decode) {
    std::uint64_t most = 0;
    for (const PieceSections::AttributeSection& a : s.attributes) {
      const std::uint64_t size = attribute_memory(a.header.attribute, a.count);
      memory.result += size;
      memory.values += size + sizeof(Expected<Attribute>) + sizeof(std::uint64_t);
      most = std::max(most, decoding_memory(a.header, a.count));
    }
    memory.values += most;
  }
  memory.faces += constant;
  memory.values += constant;
  return memory;
}

Expected<DecodedPiece> decode_piece(const PieceSections& sections, Values values, unsigned threads,
                                    std::uint64_t left) {
  auto decoded = decode_faces(sections);
  if (!decoded) return Failure{decoded.error()};
  const std::span<const std::uint32_t> along = decoded->predicted_along();  // survives the move
  DecodedPiece result{std::move(decoded->mesh), decoded->counts, 0};
  if (values == Values::decode) {
    std::vector<Expected<Attribute>> attributes(
        sections.attributes.size(), fail(ErrorCode::internal, "an attribute is not decoded"));
    std::vector<std::uint64_t> memory;
    memory.reserve(attributes.size());
    for (const PieceSections::AttributeSection& a : sections.attributes)
      memory.push_back(decoding_memory(a.header, a.count));
    const std::uint64_t held =
        memory_of(sections, values).values -
        (memory.empty() ? 0 : *std::max_element(memory.begin(), memory.end()));
    const unsigned workers =
        workers_that_fit(std::move(memory), threads, left > held ? left - held : 0);
    for_each_item(attributes.size(), workers, [&](std::size_t i, unsigned) {
      const PieceSections::AttributeSection& a = sections.attributes[i];
      attributes[i] = decode_attribute(a.bytes, a.at, a.header, a.count, along);
    });
    result.mesh.attributes.reserve(attributes.size());
    for (auto& attribute : attributes) {
      if (!attribute) return Failure{attribute.error()};
      result.mesh.attributes.push_back(std::move(*attribute));
    }
  }
  // Not before: values are predicted along faces that all run one way.
  reverse_runs(result.mesh.corners, result.mesh.face_sizes, decoded->reversed);
  result.reversed_faces = count_reversed(decoded->reversed);
  return result;
}

Expected<Done> decode_triangles(const PieceSections& sections, std::span<std::uint32_t> corners,
                                std::span<HalfEdge> twins) {
  auto surface = decode_surface(sections, corners, twins);
  if (!surface) return Failure{surface.error()};
  reverse_runs(corners, {}, surface->reversed);
  return Done{};
}

std::uint64_t room_memory(const MeshSections& sections, Values values) {
  std::uint64_t memory =
      each * (sections.corners + (sections.may_have_sizes() ? sections.faces : 0));
  for (const PieceSections& piece : sections.pieces) memory += isolated_memory(piece);
  if (values == Values::skip) return memory;
  for (const PieceSections::AttributeSection& a : sections.pieces[0].attributes)
    memory += attribute_memory(a.header.attribute, sections.count(a.header.attribute.domain));
  return memory;
}

Mesh make_room(const MeshSections& sections, Values values) {
  Mesh mesh;
  mesh.vertex_count = static_cast<std::uint32_t>(sections.vertices);
  mesh.corners.resize(static_cast<std::size_t>(sections.corners));
  if (sections.may_have_sizes()) mesh.face_sizes.resize(static_cast<std::size_t>(sections.faces));
  if (values == Values::skip) return mesh;
  mesh.attributes.reserve(sections.pieces[0].attributes.size());
  for (const PieceSections::AttributeSection& a : sections.pieces[0].attributes) {
    Attribute attribute = a.header.attribute;
    const std::uint64_t count = sections.count(attribute.domain);
    attribute.data.resize(static_cast<std::size_t>(count) * attribute.stride());
    mesh.attributes.push_back(std::move(attribute));
  }
  return mesh;
}

std::uint64_t finishing_memory(const MeshSections& s, Values values) {
  if (!s.has_order) return 0;
  std::uint64_t most = 0;
  if (values == Values::decode)
    for (const PieceSections::AttributeSection& a : s.pieces[0].attributes)
      most =
          std::max(most, attribute_memory(a.header.attribute, s.count(a.header.attribute.domain)));
  return restoring_memory(s.corners, s.faces, s.vertices, s.may_have_sizes(), most);
}

Expected<Done> finish_mesh(const MeshSections& sections, Mesh& mesh) {
  mesh.name = sections.name;
  if (sections.metadata) {
    auto metadata = decode_metadata(*sections.metadata);
    if (!metadata) return Failure{metadata.error()};
    mesh.metadata = std::move(*metadata);
  }
  if (sections.pieces.size() > 1) drop_sizes_of_triangles(mesh);
  if (!sections.has_order) return Done{};
  return restore_order(sections.order, mesh);
}

}  // namespace clers::internal
