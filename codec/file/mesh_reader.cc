// A section at a time; what is known of a mesh only when all its sections were met comes last.
#include "codec/file/mesh_reader.h"

#include <algorithm>
#include <cstdint>
#include <string_view>

#include "codec/base/utf8.h"

namespace clers::internal {
namespace {

Failure<Error> over(std::uint64_t at, Limited limited, const char* what, std::uint64_t value,
                    std::uint64_t limit) {
  auto failure =
      fail(ErrorCode::limit, Place::byte, at,
           std::to_string(value) + " " + what + ", the limit is " + std::to_string(limit));
  failure.error.limited = limited;
  failure.error.needed = value;
  return failure;
}

/// Sizes of a mesh of raw faces.
Expected<Done> read_raw(const Section& section, ByteReader& in, PieceSections& mesh) {
  mesh.raw.read(in);
  if (!in.ok()) return Failure{in.error()};
  if (std::string fault = mesh.raw.fault(); !fault.empty())
    return fail(ErrorCode::invalid, Place::byte, section.at, std::move(fault));
  mesh.vertices = mesh.places = mesh.raw.vertices;
  mesh.faces = mesh.raw.faces;
  mesh.corners = mesh.raw.corners;
  return Done{};
}

/// What keeps the streams of a mesh from being those of its surface; empty if nothing does.
std::string fault_of_streams(const PieceSections& mesh) {
  const auto has = [&](std::uint32_t bit) { return (mesh.features & bit) != 0; };
  std::string fault;
  if (has(feature::polygons)) fault = mesh.polygons.fault(mesh.connectivity.faces);
  if (fault.empty() && has(feature::reversed)) fault = mesh.reversed.fault(mesh.surface_faces);
  if (fault.empty() && has(feature::copies)) fault = mesh.copies.fault(mesh.connectivity.vertices);
  if (fault.empty() && has(feature::repeats)) fault = mesh.repeats.fault();
  if (fault.empty() && has(feature::folded)) fault = mesh.folded.fault();
  if (fault.empty() && has(feature::degenerate)) fault = mesh.degenerate.fault();
  return fault;
}

/// Sizes of a mesh that is a surface, as far as it is one.
Expected<Done> read_surface(const Section& section, ByteReader& in, PieceSections& mesh) {
  const auto invalid = [&](std::string what) {
    return fail(ErrorCode::invalid, Place::byte, section.at, std::move(what));
  };
  if (mesh.features & ~feature::on_surface)
    return invalid("unknown features " + std::to_string(mesh.features));
  const std::uint64_t others = in.varint();
  if (mesh.features & feature::reversed) mesh.reversed.read(in);
  if (mesh.features & feature::polygons) mesh.polygons.read(in);
  if (mesh.features & feature::copies) mesh.copies.read(in);
  if (mesh.features & feature::repeats) mesh.repeats.read(in);
  if (mesh.features & feature::folded) mesh.folded.read(in);
  if (mesh.features & feature::degenerate) mesh.degenerate.read(in);
  if (mesh.features & feature::welded) mesh.points.read(in);
  if (!in.ok()) return Failure{in.error()};
  mesh.connectivity_bytes = section.payload.subspan(in.position());
  mesh.connectivity_at = in.offset();
  auto header = read_connectivity_header(mesh.connectivity_bytes, mesh.connectivity_at);
  if (!header) return Failure{header.error()};
  mesh.connectivity = *header;
  mesh.surface_faces = mesh.features & feature::polygons ? mesh.polygons.faces : header->faces;
  if (std::string fault = fault_of_streams(mesh); !fault.empty()) return invalid(std::move(fault));
  mesh.surface_vertices = header->vertices - mesh.copies.copies;
  if (others > 0xffffffffu - mesh.surface_vertices)
    return invalid(std::to_string(others) + " further vertices are more than there are numbers");
  mesh.vertices = mesh.places = mesh.surface_vertices + others;
  mesh.faces = mesh.surface_faces + mesh.repeats.faces + mesh.folded.faces + mesh.degenerate.faces;
  // A polygon of n corners is n - 2 triangles.
  mesh.corners = header->faces + 2 * mesh.surface_faces + mesh.repeats.corners +
                 3 * mesh.folded.faces + mesh.degenerate.corners;
  if (mesh.corners > max_corners)
    return invalid(std::to_string(mesh.corners) + " corners are more than there are numbers");
  if (mesh.features & feature::welded) {
    if (std::string fault = mesh.points.fault(mesh.corners, mesh.places); !fault.empty())
      return invalid(std::move(fault));
    mesh.vertices = mesh.points.points;
  }
  return Done{};
}

Expected<PieceSections> read_piece(const Section& section, const Limits& limits) {
  PieceSections mesh;
  mesh.payload_size = section.payload.size();
  mesh.at = section.at;
  ByteReader in(section.payload, section.at);
  mesh.features = in.u8();
  const auto ok =
      mesh.features == feature::raw ? read_raw(section, in, mesh) : read_surface(section, in, mesh);
  if (!ok) return Failure{ok.error()};
  if (mesh.vertices > limits.vertices)
    return over(section.at, Limited::vertices, "vertices", mesh.vertices, limits.vertices);
  if (mesh.faces > limits.faces)
    return over(section.at, Limited::faces, "faces", mesh.faces, limits.faces);
  return mesh;
}

Expected<PieceSections::AttributeSection> read_attribute(const Section& section,
                                                         const PieceSections& mesh) {
  auto header = read_attribute_header(section.payload, section.at);
  if (!header) return Failure{header.error()};
  PieceSections::AttributeSection result{*header, section.payload, section.at, 0};
  switch (header->attribute.domain) {
    case Domain::vertex: result.count = mesh.vertices; break;
    case Domain::corner: result.count = mesh.corners; break;
    case Domain::face: result.count = mesh.faces; break;
  }
  const Attribute& what = header->attribute;
  const bool at_places = header->structure.at_places;
  if (at_places ? !mesh.is_welded()
                : mesh.is_welded() && what.domain == Domain::vertex && what.name == position_name)
    return fail(ErrorCode::invalid, Place::byte, section.at,
                "values of places of a mesh that has none, or positions that are not");
  if (at_places) result.places = mesh.places;
  if (auto ok = check_values(result.bytes, result.at, result.header, result.values()); !ok)
    return Failure{ok.error()};
  return result;
}

/// How many vertices a piece shares with those before it.
Expected<Done> read_seam(const Section& section, PieceSections& piece) {
  ByteReader in(section.payload, section.at);
  piece.seam_size = section.payload.size();
  piece.seam.read(in);
  if (!in.ok()) return Failure{in.error()};
  const std::uint64_t shared = piece.seam.shared;
  if (shared == 0 || shared > piece.most_used_vertices() || shared > piece.first_vertex)
    return fail(ErrorCode::invalid, Place::byte, section.at,
                "a piece of " + std::to_string(piece.vertices) + " vertices after " +
                    std::to_string(piece.first_vertex) + " cannot share " + std::to_string(shared));
  return Done{};
}

bool same_attributes(const PieceSections& a, const PieceSections& b) {
  return std::equal(a.attributes.begin(), a.attributes.end(), b.attributes.begin(),
                    b.attributes.end(), [](const auto& x, const auto& y) {
                      const Attribute &p = x.header.attribute, &q = y.header.attribute;
                      return p.name == q.name && p.domain == q.domain && p.scalar == q.scalar &&
                             p.components == q.components;
                    });
}

/// Takes the sections of a file one after the other.
class MeshesReader {
 public:
  MeshesReader(const Limits& limits, std::uint64_t pieces_in_file)
      : limits_(limits), pieces_left_(pieces_in_file) {}

  Expected<Done> take(const Section& section) {
    const bool any_piece = !meshes.empty() && !meshes.back().pieces.empty();
    if (is_of_scene(section)) return add_to_scene(section);
    if (scene.any_after_meshes() && section.kind != SectionKind::end)
      return invalid(section, "a section of a mesh behind arrays or blobs");
    switch (section.kind) {
      case SectionKind::pieces: return begin_pieces(section);
      case SectionKind::mesh: return add_piece(section);
      case SectionKind::end: return finish_mesh(section);
      default: break;
    }
    if (!any_piece) return invalid(section, "expected a mesh first");
    PieceSections& piece = meshes.back().pieces.back();
    switch (section.kind) {
      case SectionKind::seam:
        if (meshes.back().pieces.size() == 1 || piece.seam.shared > 0 || !piece.attributes.empty())
          return invalid(section, "a seam where none can be");
        return read_seam(section, piece);
      case SectionKind::attribute: return add_attribute(section, piece);
      case SectionKind::name:
        if (pieces_to_come_ > 0) return invalid(section, "a name before the last piece");
        return add_name(section, meshes.back());
      default: break;
    }
    if (section.kind == SectionKind::metadata) return add_metadata(section);
    MeshSections& mesh = meshes.back();  // an order
    if (pieces_to_come_ > 0 || mesh.has_order ||
        (mesh.pieces.size() == 1 && piece.features == feature::raw))
      return invalid(section, "an order where none can be");
    mesh.order = {section.payload, section.at};
    mesh.has_order = true;
    return Done{};
  }

  std::vector<MeshSections> meshes;
  SceneSections scene;

 private:
  bool is_of_scene(const Section& section) const {
    switch (section.kind) {
      case SectionKind::document:
      case SectionKind::array:
      case SectionKind::blob: return true;
      case SectionKind::metadata: return meshes.empty();
      default: return false;
    }
  }

  Expected<Done> add_to_scene(const Section& section) {
    if (pieces_to_come_ > 0)
      return invalid(section, "expected " + std::to_string(pieces_to_come_) + " more pieces");
    if (section.kind == SectionKind::document) {
      if (!meshes.empty() || scene.document || scene.metadata || scene.any_after_meshes())
        return invalid(section, "a document that is not the first section");
      return keep(read_document(section), scene.document);
    }
    if (section.kind == SectionKind::metadata) {
      if (scene.metadata || scene.any_after_meshes())
        return invalid(section, "metadata where none can be");
      return keep(read_metadata_header(section.payload, section.at), scene.metadata);
    }
    if (section.kind == SectionKind::array) {
      if (!scene.blobs.empty()) return invalid(section, "an array behind blobs");
      return keep(read_array(section), scene.arrays);
    }
    return keep(read_blob(section), scene.blobs);
  }
  template <class T>
  static Expected<Done> keep(Expected<T> read, std::optional<T>& where) {
    if (!read) return Failure{read.error()};
    where = std::move(*read);
    return Done{};
  }
  template <class T>
  static Expected<Done> keep(Expected<T> read, std::vector<T>& where) {
    if (!read) return Failure{read.error()};
    where.push_back(std::move(*read));
    return Done{};
  }

  static Failure<Error> invalid(const Section& section, std::string what) {
    return fail(ErrorCode::invalid, Place::byte, section.at, std::move(what));
  }

  Expected<Done> begin_pieces(const Section& section) {
    ByteReader in(section.payload, section.at);
    const std::uint64_t pieces = in.varint();
    if (!in.ok()) return Failure{in.error()};
    if (pieces < 2 || in.left() > 0) return invalid(section, "no number of pieces, 2 at least");
    if (auto ok = begin_mesh(section); !ok) return ok;
    pieces_to_come_ = pieces;
    meshes.back().pieces.reserve(static_cast<std::size_t>(std::min(pieces, pieces_left_)));
    return Done{};
  }

  Expected<Done> begin_mesh(const Section& section) {
    if (auto ok = finish_mesh(section); !ok) return ok;
    if (meshes.size() >= limits_.meshes)
      return over(section.at, Limited::meshes, "meshes or more", meshes.size() + 1, limits_.meshes);
    meshes.emplace_back();
    return Done{};
  }

  Expected<Done> add_piece(const Section& section) {
    --pieces_left_;
    if (pieces_to_come_ > 0) {
      --pieces_to_come_;
      if (auto ok = finish_piece(); !ok) return ok;
    } else if (auto ok = begin_mesh(section); !ok) {
      return ok;
    }
    auto piece = read_piece(section, limits_);
    if (!piece) return Failure{piece.error()};
    MeshSections& mesh = meshes.back();
    piece->first_vertex = mesh.vertices;
    piece->first_face = mesh.faces;
    piece->first_corner = mesh.corners;
    mesh.pieces.push_back(std::move(*piece));
    return Done{};
  }

  /// Adds the latest piece, all of which is known now, to its mesh.
  Expected<Done> finish_piece() {
    MeshSections& mesh = meshes.back();
    if (mesh.pieces.empty()) return Done{};
    const PieceSections& piece = mesh.pieces.back();
    const auto refuse = [&](const char* what) {
      return fail(ErrorCode::invalid, Place::byte, piece.at, what);
    };
    if (!same_attributes(mesh.pieces.front(), piece))
      return refuse("this piece does not have the attributes of the first one");
    const auto by_index = [](const PieceSections::AttributeSection& a) {
      return a.header.structure.indexed;
    };
    if (mesh.pieces.size() > 1 &&
        std::any_of(piece.attributes.begin(), piece.attributes.end(), by_index))
      return refuse("values by index in a mesh in pieces");
    mesh.vertices += piece.vertices - piece.seam.shared;
    mesh.faces += piece.faces;
    mesh.corners += piece.corners;
    if (mesh.vertices > 0xffffffffu || mesh.corners > max_corners || mesh.faces > max_corners)
      return refuse("up to this piece there are more elements than numbers for them");
    if (mesh.vertices > limits_.vertices)
      return over(piece.at, Limited::vertices, "vertices", mesh.vertices, limits_.vertices);
    if (mesh.faces > limits_.faces)
      return over(piece.at, Limited::faces, "faces", mesh.faces, limits_.faces);
    return Done{};
  }

  /// Before another mesh, or the end of the file.
  Expected<Done> finish_mesh(const Section& next) {
    if (meshes.empty()) return Done{};
    if (pieces_to_come_ > 0)
      return invalid(next, "expected " + std::to_string(pieces_to_come_) + " more pieces");
    if (auto ok = finish_piece(); !ok) return ok;
    const MeshSections& mesh = meshes.back();
    // A face takes a decision at least.
    if (const auto& order = mesh.order; mesh.has_order && mesh.faces > order.max_decisions())
      return fail(ErrorCode::invalid, Place::byte, order.at,
                  "the order of " + std::to_string(mesh.faces) + " faces cannot be coded in " +
                      std::to_string(order.bytes.size()) + " bytes");
    return Done{};
  }

  Expected<Done> add_attribute(const Section& section, PieceSections& piece) {
    auto attribute = read_attribute(section, piece);
    if (!attribute) return Failure{attribute.error()};
    piece.attributes.push_back(std::move(*attribute));
    return Done{};
  }

  Expected<Done> add_name(const Section& section, MeshSections& mesh) {
    const std::string_view name(reinterpret_cast<const char*>(section.payload.data()),
                                section.payload.size());
    if (mesh.has_name) return invalid(section, "a second name of a mesh");
    if (const std::size_t i = first_not_utf8(name); i < name.size())
      return fail(ErrorCode::invalid, Place::byte, section.at + i,
                  "the name is not UTF-8 from here");
    mesh.name = name;
    mesh.has_name = true;
    return Done{};
  }

  Expected<Done> add_metadata(const Section& section) {
    MeshSections& mesh = meshes.back();
    if (pieces_to_come_ > 0 || mesh.metadata) return invalid(section, "metadata where none can be");
    auto header = read_metadata_header(section.payload, section.at);
    if (!header) return Failure{header.error()};
    mesh.metadata = *header;
    return Done{};
  }

  const Limits& limits_;
  std::uint64_t pieces_left_;         ///< in the file
  std::uint64_t pieces_to_come_ = 0;  ///< of the latest mesh
};

/// What sections become: a mesh or a piece each, and lists of attributes that grow by doubling.
std::uint64_t meshes_memory(const ContainerReader::Tally& tally) {
  const std::uint64_t pieces = tally.count(SectionKind::mesh),
                      attributes = tally.count(SectionKind::attribute);
  return pieces * (sizeof(PieceSections) + 3 * sizeof(MeshSections)) +
         attributes * 3 * sizeof(PieceSections::AttributeSection) +
         std::min(tally.size(SectionKind::attribute), 256 * attributes) +  // names
         2 * tally.size(SectionKind::name);  // here, and in the result
}

}  // namespace

std::size_t PieceSections::joints_of(std::size_t weights) const {
  const auto are = [&](const AttributeSection& a) {
    return may_be_joints_of(a.header, attributes[weights].header);
  };
  return static_cast<std::size_t>(std::find_if(attributes.begin(), attributes.end(), are) -
                                  attributes.begin());
}

void PieceSections::keep_attributes(const std::vector<bool>& wanted) {
  std::vector<bool> kept = wanted;
  for (std::size_t i = 0; i < attributes.size(); ++i)
    if (wanted[i] && needs_joints(attributes[i].header))
      if (const std::size_t k = joints_of(i); k < attributes.size()) kept[k] = true;
  // Backwards: the seams that an attribute needs stand before it.
  bool seams = false, position = false;
  for (std::size_t i = attributes.size(); i-- > 0;) {
    AttributeSection& a = attributes[i];
    const Attribute& what = a.header.attribute;
    a.wanted = wanted[i];
    a.decoded = kept[i];
    position |= a.decoded && needs_position(a.header);
    if (a.header.structure.any && what.domain == Domain::corner) {
      kept[i] = kept[i] || seams;
      seams = kept[i] && a.header.structure.beside;
    }
  }
  const auto is_position = [](const AttributeSection& a) {
    return a.header.attribute.domain == Domain::vertex && a.header.attribute.name == position_name;
  };
  const auto first = std::find_if(attributes.begin(), attributes.end(), is_position);
  if (position && first != attributes.end())
    first->decoded = kept[static_cast<std::size_t>(first - attributes.begin())] = true;
  std::size_t count = 0;
  for (std::size_t i = 0; i < attributes.size(); ++i)
    if (kept[i]) std::swap(attributes[count++], attributes[i]);
  attributes.resize(count);
}

Expected<FileSections> read_sections(ContainerReader& file, const Limits& limits, Budget& budget) {
  if (auto ok = file.open(); !ok) return Failure{ok.error()};
  const ContainerReader::Tally tally = file.tally();
  if (auto ok = budget.take(meshes_memory(tally) + tables_memory(tally)); !ok)
    return Failure{ok.error()};
  MeshesReader reader(limits, tally.count(SectionKind::mesh));
  for (bool more = true; more;) {
    auto section = file.next();
    if (!section) return Failure{section.error()};
    if (auto ok = reader.take(*section); !ok) return Failure{ok.error()};
    more = section->kind != SectionKind::end;
  }
  if (file.meshes() != reader.meshes.size())
    return fail(ErrorCode::invalid, std::to_string(reader.meshes.size()) +
                                        " meshes, but the file says " +
                                        std::to_string(file.meshes()));
  for (const MeshSections& mesh : reader.meshes)
    if (mesh.metadata)
      if (auto ok = budget.take(mesh.metadata->memory()); !ok) return Failure{ok.error()};
  if (reader.scene.metadata)
    if (auto ok = budget.take(reader.scene.metadata->memory()); !ok) return Failure{ok.error()};
  if (auto ok = check_vertices_of(reader.scene, reader.meshes.size()); !ok)
    return Failure{ok.error()};
  return FileSections{std::move(reader.meshes), std::move(reader.scene)};
}

}  // namespace clers::internal
