// The sequence of decoding: connectivity, what undoes the cuts, other faces, values, reversed
// faces.
#include "codec/file/mesh_decoder.h"

#include <algorithm>
#include <atomic>
#include <functional>
#include <optional>
#include <utility>

#include "codec/attributes/coded_faces.h"
#include "codec/attributes/face_surface.h"
#include "codec/attributes/points.h"
#include "codec/attributes/structure.h"
#include "codec/attributes/structure_decoder.h"
#include "codec/base/budget.h"
#include "codec/base/parallel.h"
#include "codec/file/file_order.h"
#include "codec/soup/corner_map.h"

namespace clers::internal {
namespace {

/// No sizes where all faces are triangles.
void drop_sizes_of_triangles(Mesh& mesh) {
  const auto is_triangle = [](std::uint32_t size) { return size == 3; };
  if (std::all_of(mesh.face_sizes.begin(), mesh.face_sizes.end(), is_triangle))
    mesh.face_sizes = {};
}

/// A piece without attributes, and the surface that those are predicted along.
struct DecodedFaces {
  Mesh mesh;
  std::size_t surface_corners = 0;           ///< so many of mesh.corners are its triangles
  std::vector<std::uint32_t> triangles;      ///< or, with polygons, these are
  std::vector<std::uint32_t> introduced_by;  ///< where they are wanted
  std::vector<HalfEdge> twins;               ///< likewise
  std::vector<ReversedRun> reversed;
  ConnectivityCounts counts;
  // Of welded vertices:
  std::vector<std::uint32_t> welded;  ///< corners, before they were those of points
  std::vector<std::uint32_t> corner_of;
  Points points;

  CodedSurface surface() const {
    const std::vector<std::uint32_t>& corners = welded.empty() ? mesh.corners : welded;
    return {triangles.empty() ? std::span(corners).first(surface_corners) : triangles, twins,
            introduced_by};
  }
};

/// Which corners of faces those of the surface are; empty: the same numbers.
std::vector<std::uint32_t> corners_of_surface(const PieceSections& sections, const Mesh& mesh,
                                              std::size_t corners) {
  if (sections.features == feature::raw)
    return mesh.triangles_only() ? std::vector<std::uint32_t>()
                                 : corners_of_fans(mesh.face_sizes, corners);
  return sections.features & feature::polygons ? corners_of_polygons(mesh.face_sizes, corners)
                                               : std::vector<std::uint32_t>();
}

/// Decodes the triangles of the surface, by vertices of the mesh but for polygons and reversed
/// faces.
struct DecodedSurface {
  ConnectivityCounts counts;
  std::vector<ReversedRun> reversed;
  std::vector<std::uint32_t> sizes;  ///< of polygons, where there are any
  std::vector<std::uint32_t> introduced_by;
};
Expected<DecodedSurface> decode_surface(const PieceSections& sections,
                                        std::span<std::uint32_t> triangles,
                                        std::span<HalfEdge> twins, bool with_introduced) {
  DecodedSurface result;
  if (with_introduced) result.introduced_by.resize(sections.connectivity.vertices);
  auto counts = decode_connectivity(sections.connectivity_bytes, sections.connectivity_at,
                                    sections.connectivity, triangles, twins, result.introduced_by);
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
    if (auto ok = decode_copies(sections.copies, sections.connectivity.vertices, triangles,
                                result.introduced_by);
        !ok)
      return Failure{ok.error()};
  return result;
}

/// The most that the values of a piece are decoded along.
Along decoded_along(const PieceSections& sections, Values values) {
  Along most = sections.is_welded() ? Along::twins : Along::nothing;
  if (values == Values::decode)
    for (const PieceSections::AttributeSection& a : sections.attributes)
      most = std::max(most, along(a.header));
  return sections.features == feature::raw ? std::min(most, Along::surface) : most;
}

Expected<DecodedFaces> decode_faces(const PieceSections& sections, Along along_what) {
  const bool with_introduced = along_what != Along::nothing;
  DecodedFaces result;
  Mesh& mesh = result.mesh;
  mesh.vertex_count = static_cast<std::uint32_t>(sections.vertices);
  if (sections.features == feature::raw) {
    if (auto ok = decode_raw(sections.raw, mesh.face_sizes, mesh.corners); !ok)
      return Failure{ok.error()};
    drop_sizes_of_triangles(mesh);
    if (mesh.triangles_only())
      result.surface_corners = mesh.corners.size();
    else
      result.triangles = fan_triangles(mesh.corners, mesh.face_sizes);
    if (with_introduced) {
      const auto along = result.surface().corners;
      const auto last = std::max_element(along.begin(), along.end());
      result.introduced_by.resize(last == along.end() ? 0 : *last + std::size_t(1));
      find_introducing(along, result.introduced_by);
    }
    return result;
  }
  const bool polygons = sections.features & feature::polygons;
  const std::size_t surface_corners = 3 * std::size_t(sections.connectivity.faces);
  std::vector<std::uint32_t> triangles;
  // What is appended to triangles finds room behind them.
  triangles.reserve(polygons ? surface_corners : static_cast<std::size_t>(sections.corners));
  triangles.resize(surface_corners);
  if (along_what == Along::twins) result.twins.resize(surface_corners);
  auto surface = decode_surface(sections, triangles, result.twins, with_introduced);
  if (!surface) return Failure{surface.error()};
  result.counts = surface->counts;
  result.reversed = std::move(surface->reversed);
  result.introduced_by = std::move(surface->introduced_by);
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
                           static_cast<std::uint32_t>(sections.surface_vertices),
                           static_cast<std::uint32_t>(sections.places), sizes, corners);
  if (!ok) return Failure{ok.error()};
  drop_sizes_of_triangles(mesh);
  if (!sections.is_welded()) return result;
  result.welded = std::move(mesh.corners);
  const CodedSurface welded = result.surface();
  result.corner_of = corners_of_surface(sections, mesh, welded.corners.size());
  auto points =
      decode_points(sections.points, {welded, result.corner_of, result.welded, mesh.face_sizes,
                                      static_cast<std::uint32_t>(sections.places)});
  if (!points) return Failure{points.error()};
  result.points = std::move(*points);
  mesh.corners = result.points.structure.value_of;
  return result;
}

constexpr std::uint64_t each = sizeof(std::uint32_t);

/// Pieces of fewer corners are decoded before another thread has begun.
constexpr std::uint64_t worth_threads = 1 << 15;

/// What vertices of no surface count, though no array has them before a user makes one.
std::uint64_t isolated_memory(const PieceSections& s) {
  return each * (s.vertices - s.surface_vertices);
}

/// What a decoded attribute takes, for so many elements.
std::uint64_t attribute_memory(const AttributeHeader& header, std::uint64_t count) {
  const Attribute& what = header.attribute;
  return sizeof(Attribute) + what.name.size() + header.result_values(count) * what.stride() +
         (header.structure.indexed ? each * count : 0);
}

SurfaceSize surface_size(const PieceSections& s) {
  if (s.features == feature::raw) return {s.vertices, s.corners, s.vertices};
  return {s.connectivity.vertices, s.connectivity.faces, s.vertices};
}

std::uint64_t half_edges(const PieceSections& s) {
  return s.features == feature::raw ? 3 * s.corners : 3 * s.connectivity.faces;
}

/// What an attribute takes from when it is read until its values are there, and at most besides.
struct ValuesMemory {
  std::uint64_t held, step;
};
ValuesMemory memory_of(const PieceSections& s, const PieceSections::AttributeSection& a) {
  const StructureHeader& structure = a.header.structure;
  const std::uint64_t values = a.values(),
                      sides = a.header.attribute.domain == Domain::face ? 0 : half_edges(s);
  SurfaceSize surface = surface_size(s);
  if (structure.any) surface.vertices = values;
  const AttributeMemory memory = decoding_memory(a.bytes, a.header, values, surface);
  const std::uint64_t result = attribute_memory(a.header, a.count);
  const std::uint64_t sharing =
      structure_memory(structure, a.header.attribute.domain, a.count, s.vertices, sides);
  const std::uint64_t found = each * a.count + seams_memory(sides);
  if (!a.decoded) return {found, sharing};
  ValuesMemory out{std::max(memory.begun, result) + sizeof(Expected<BegunAttribute>),
                   std::max(memory.beginning, result + memory.finishing)};
  if (is_along_faces(a.header)) out.step += FaceSurface::memory(half_edges(s), a.count);
  if (a.places > 0) out.held += a.places * a.header.attribute.stride();
  if (!structure.any) return out;
  const std::uint64_t coded = values * a.header.attribute.stride();
  out.held += found;
  out.step = std::max({memory.beginning,
                       coded + memory.finishing + value_surface_memory(sides, true, values),
                       result + coded + spreading_memory(structure), sharing});
  return out;
}

/// What the faces take once more, as values of corners are coded along them.
std::uint64_t corner_map_memory(const PieceSections& s, Values values) {
  bool needed = s.is_welded();
  if (values == Values::decode)
    for (const PieceSections::AttributeSection& a : s.attributes)
      needed |= (a.header.structure.any && a.header.attribute.domain == Domain::corner) ||
                is_along_faces(a.header);
  return needed && s.features & (feature::polygons | feature::raw) ? each * half_edges(s) : 0;
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
  const std::uint64_t map = corner_map_memory(s, values);
  if (s.is_welded()) {
    const std::uint64_t points =
        each * s.corners + s.points.memory(s.corners, s.places, half_edges(s));
    memory.faces = std::max(memory.faces, memory.result + runs + triangles + points);
    memory.values += points + value_surface_memory(half_edges(s), true, s.vertices);
  }
  memory.faces += map;
  memory.values += map;
  if (const Along along = decoded_along(s, values); along != Along::nothing) {
    std::uint64_t held = each * (raw ? s.corners > 0 ? s.vertices : 0 : s.connectivity.vertices);
    if (along == Along::twins) {
      held += sizeof(HalfEdge) * 3 * s.connectivity.faces;
      memory.faces +=
          connectivity_memory(s.connectivity, true) - connectivity_memory(s.connectivity, false);
    }
    memory.faces += held;
    memory.values += held;
  }
  if (values == Values::decode) {
    std::uint64_t held = (sizeof(Expected<BegunAttribute>) + sizeof(ValueStructure) +
                          sizeof(Attribute) + sizeof(std::size_t) + sizeof(Expected<Done>)) *
                         s.attributes.size();
    memory.faces += held;
    memory.values += held;
    std::uint64_t most = 0;
    for (const PieceSections::AttributeSection& a : s.attributes) {
      const ValuesMemory values_memory = memory_of(s, a);
      if (a.wanted) memory.result += attribute_memory(a.header, a.count);
      memory.values += values_memory.held;
      most = std::max(most, values_memory.step);
    }
    memory.values += most;
  }
  memory.faces += constant;
  memory.values += constant;
  return memory;
}

namespace {

/// How many threads may decode a piece while `left` bytes are left: at least 1. More than one need
/// room for residuals while faces are decoded, and for what several attributes take at a time.
unsigned workers_of(const PieceSections& sections, const PieceMemory& memory, unsigned threads,
                    std::uint64_t left) {
  const std::size_t attributes = sections.attributes.size();
  if (sections.corners < worth_threads) threads = 1;
  std::vector<std::uint64_t> steps;
  steps.reserve(attributes);
  std::uint64_t read = 0;
  for (const PieceSections::AttributeSection& a : sections.attributes) {
    const ValuesMemory of_values = memory_of(sections, a);
    steps.push_back(of_values.step);
    read += of_values.held;
  }
  std::sort(steps.begin(), steps.end(), std::greater<>());
  const std::uint64_t held = memory.values - steps[0];
  const unsigned most = worker_count(threads, attributes + 1);
  std::uint64_t others = 0;  // steps beside the faces
  unsigned fit = 1;
  for (; fit < most; ++fit) {
    others += steps[fit - 1];
    const std::uint64_t after = others + (fit < attributes ? steps[fit] : 0);
    if (std::max(memory.faces + read + others, held + after) > left) break;
  }
  return fit;
}

}  // namespace

Expected<DecodedPiece> decode_piece(const PieceSections& sections, Values values, unsigned threads,
                                    std::uint64_t left) {
  const Along along = decoded_along(sections, values);
  const std::size_t attributes = values == Values::decode ? sections.attributes.size() : 0;
  const unsigned workers =
      attributes == 0 ? 1 : workers_of(sections, memory_of(sections, values), threads, left);

  // What needs no faces is read beside them, then values are made of both. Whatever the threads do,
  // the error of the faces comes first, then that of the first attribute.
  Expected<DecodedFaces> decoded = fail(ErrorCode::internal, "not decoded");
  std::vector<Expected<BegunAttribute>> begun(attributes, fail(ErrorCode::internal, "not decoded"));
  std::atomic<bool> in_vain{false};
  for_each_item(1 + attributes, workers, [&](std::size_t i, unsigned) {
    if (i == 0) {
      decoded = decode_faces(sections, along);
      in_vain = !decoded.ok();
    } else if (!in_vain) {
      const PieceSections::AttributeSection& a = sections.attributes[i - 1];
      if (!a.decoded) begun[i - 1] = BegunAttribute();
      if (a.decoded) begun[i - 1] = begin_attribute(a.bytes, a.at, a.header, a.values());
    }
  });
  if (!decoded) return Failure{decoded.error()};
  for (const auto& attribute : begun)
    if (!attribute) return Failure{attribute.error()};

  const CodedSurface surface = decoded->surface();  // survives the move
  DecodedPiece result{std::move(decoded->mesh), decoded->counts, 0};
  Mesh& mesh = result.mesh;
  mesh.attributes.resize(attributes);

  // Which elements have which values; each may need to know it of the one before. Values of
  // vertices are coded along a surface of their own where those of the surface are welded.
  if (corner_map_memory(sections, values) > 0 && decoded->corner_of.empty())
    decoded->corner_of = corners_of_surface(sections, mesh, surface.corners.size());
  const bool welded = sections.is_welded();
  const CodedFaces faces{surface, decoded->corner_of,
                         welded ? std::span<const std::uint32_t>(decoded->welded) : mesh.corners,
                         mesh.face_sizes, static_cast<std::uint32_t>(sections.places)};
  CodedFaces of_vertices = faces;
  ValueArrays of_points;
  if (welded && attributes > 0) {
    of_points =
        make_value_surface(faces, Domain::corner, decoded->points.structure, mesh.vertex_count);
    of_vertices.surface = of_points.surface.view();
    of_vertices.vertices = mesh.vertex_count;
    of_vertices.place_of = decoded->points.place_of;
  }
  std::vector<ValueStructure> structures(attributes);
  const Seams* beside = welded ? &decoded->points.structure.seams : nullptr;
  for (std::size_t i = 0; i < attributes; ++i) {
    const PieceSections::AttributeSection& a = sections.attributes[i];
    if (!a.header.structure.any) continue;
    const Domain domain = a.header.attribute.domain;
    auto structure = decode_structure(
        a.header.structure, domain == Domain::vertex ? of_vertices : faces, domain, beside);
    if (!structure) return Failure{structure.error()};
    structures[i] = std::move(*structure);
    if (domain == Domain::corner) beside = &structures[i].seams;
  }

  // Positions first: others may be predicted from them. Joints before their weights.
  const PieceSections::AttributeSection* first_position = nullptr;
  for (std::size_t i = attributes; i-- > 0;) {
    const PieceSections::AttributeSection& a = sections.attributes[i];
    if (a.decoded && a.header.attribute.domain == Domain::vertex &&
        a.header.attribute.name == position_name && !a.header.structure.any)
      first_position = &a;
  }
  const Attribute* position = nullptr;
  std::vector<Attribute> at_welded(attributes);  // values of places, as they are coded
  const auto as_coded = [&](std::size_t i) {
    return sections.attributes[i].places > 0 ? &at_welded[i] : &mesh.attributes[i];
  };
  const auto joints_for = [&](std::size_t i) -> const Attribute* {
    if (!needs_joints(sections.attributes[i].header)) return nullptr;
    const std::size_t k = sections.joints_of(i);
    return k < attributes ? as_coded(k) : nullptr;
  };
  const auto finish = [&](std::size_t i) -> Expected<Done> {
    const PieceSections::AttributeSection& a = sections.attributes[i];
    const CodedFaces& along_faces =
        a.header.attribute.domain == Domain::vertex && a.places == 0 ? of_vertices : faces;
    ValueStructure structure = std::move(structures[i]);
    ValueArrays arrays;
    if (a.header.structure.any)
      arrays = make_value_surface(along_faces, a.header.attribute.domain, structure,
                                  static_cast<std::size_t>(a.values()));
    std::optional<FaceSurface> of_faces;
    ValueSurface values_along =
        a.header.structure.any
            ? arrays.view(position)
            : ValueSurface{along_faces.surface, along_faces.place_of, position, {}, joints_for(i)};
    if (is_along_faces(a.header)) values_along = of_faces.emplace(faces).view(position);
    auto attribute =
        finish_attribute(a.bytes, a.at, a.header, a.values(), std::move(*begun[i]), values_along);
    if (!attribute) return Failure{attribute.error()};
    arrays = {};
    if (a.header.structure.any)
      if (auto ok =
              spread_values(a.header.structure, a.at, std::move(structure.value_of), *attribute);
          !ok)
        return ok;
    if (a.places > 0) {
      at_welded[i] = *attribute;
      attribute->data = at_places(decoded->points.place_of, attribute->data, attribute->stride());
    }
    mesh.attributes[i] = std::move(*attribute);
    return Done{};
  };
  if (first_position != nullptr) {
    const auto i = static_cast<std::size_t>(first_position - sections.attributes.data());
    if (auto ok = finish(i); !ok) return Failure{ok.error()};
    position = as_coded(i);
  }
  std::vector<Expected<Done>> finished(attributes, Done{});
  for (const bool of_joints : {false, true}) {
    std::vector<std::size_t> others;
    for (std::size_t i = 0; i < attributes; ++i) {
      const PieceSections::AttributeSection& a = sections.attributes[i];
      if (a.decoded && &a != first_position && needs_joints(a.header) == of_joints)
        others.push_back(i);
    }
    for_each_item(others.size(), workers,
                  [&](std::size_t i, unsigned) { finished[others[i]] = finish(others[i]); });
  }
  for (const auto& ok : finished)
    if (!ok) return Failure{ok.error()};
  std::size_t wanted = 0;
  for (std::size_t i = 0; i < attributes; ++i)
    if (sections.attributes[i].wanted && wanted++ < i)
      mesh.attributes[wanted - 1] = std::move(mesh.attributes[i]);
  mesh.attributes.resize(wanted);
  // Not before: values are predicted along faces that all run one way.
  for (Attribute& a : mesh.attributes) {
    if (a.domain != Domain::corner) continue;
    if (a.indices.empty())
      reverse_runs(a.data, a.stride(), mesh.face_sizes, decoded->reversed);
    else
      reverse_runs(a.indices, mesh.face_sizes, decoded->reversed);
  }
  reverse_runs(mesh.corners, mesh.face_sizes, decoded->reversed);
  result.reversed_faces = count_reversed(decoded->reversed);
  return result;
}

Expected<Done> decode_triangles(const PieceSections& sections, std::span<std::uint32_t> corners,
                                std::span<HalfEdge> twins) {
  auto surface = decode_surface(sections, corners, twins, false);
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
    if (a.wanted) memory += attribute_memory(a.header, sections.count(a.header.attribute.domain));
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
    if (!a.wanted) continue;
    Attribute attribute = a.header.attribute;
    const std::uint64_t count = sections.count(attribute.domain);
    attribute.data.resize(static_cast<std::size_t>(count) * attribute.stride());
    mesh.attributes.push_back(std::move(attribute));
  }
  return mesh;
}

std::uint64_t finishing_memory(const MeshSections& s, Values values) {
  std::uint64_t most = 0, numbering = 0;
  if (values == Values::decode)
    for (const PieceSections::AttributeSection& a : s.pieces[0].attributes) {
      const Attribute& what = a.header.attribute;
      const std::uint64_t size = a.header.structure.indexed ? each : what.stride();
      most = std::max(most, s.count(what.domain) * size);
      if (a.header.structure.indexed)
        numbering = std::max(numbering, numbering_by_use_memory(a.header.structure, what.stride()));
    }
  if (!s.has_order) return numbering;
  return std::max(numbering,
                  restoring_memory(s.corners, s.faces, s.vertices, s.may_have_sizes(), most));
}

Expected<Done> finish_mesh(const MeshSections& sections, Mesh& mesh) {
  mesh.name = sections.name;
  if (sections.metadata) {
    auto metadata = decode_metadata(*sections.metadata);
    if (!metadata) return Failure{metadata.error()};
    mesh.metadata = std::move(*metadata);
  }
  if (sections.pieces.size() > 1) drop_sizes_of_triangles(mesh);
  if (sections.has_order)
    if (auto ok = restore_order(sections.order, mesh); !ok) return ok;
  auto attribute = mesh.attributes.begin();
  for (const PieceSections::AttributeSection& a : sections.pieces[0].attributes) {
    if (attribute == mesh.attributes.end()) break;  // only faces were decoded
    if (!a.wanted) continue;
    if (a.header.structure.indexed)
      if (auto ok = number_values_by_use(a.header.structure, *attribute); !ok) return ok;
    ++attribute;
  }
  return Done{};
}

}  // namespace clers::internal
