// Walks the sections of a file mesh by mesh, decodes nothing, and checks all that headers say: what
// decode and inspect share.
#ifndef CLERS_CODEC_FILE_MESH_READER_H
#define CLERS_CODEC_FILE_MESH_READER_H

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "codec/attributes/attribute_decoder.h"
#include "codec/attributes/points.h"
#include "codec/base/budget.h"
#include "codec/connectivity/connectivity.h"
#include "codec/file/container.h"
#include "codec/file/mesh_features.h"
#include "codec/file/metadata.h"
#include "codec/file/scene_sections.h"
#include "codec/limits.h"
#include "codec/pieces/assembly.h"
#include "codec/soup/degenerate_faces.h"
#include "codec/soup/folded_faces.h"
#include "codec/soup/polygon_sizes.h"
#include "codec/soup/raw_faces.h"
#include "codec/soup/repeated_faces.h"
#include "codec/soup/reversed_faces.h"
#include "codec/soup/stitching.h"

namespace clers::internal {

/// A part of a file that decodes alone: a mesh, or a piece of one.
struct PieceSections : PiecePlace {
  std::uint64_t surface_vertices = 0;  ///< of the piece, that its surface has
  std::uint64_t places = 0;            ///< vertices, welded if they are
  std::uint64_t surface_faces = 0;     ///< neither repeated, folded nor degenerate
  std::uint32_t features = 0;          ///< which of these it has:
  ReversedHeader reversed;
  PolygonHeader polygons;
  CopiesHeader copies;
  RepeatsHeader repeats;
  FoldedHeader folded;
  DegenerateHeader degenerate;
  PointsHeader points;
  RawHeader raw;
  ConnectivityHeader connectivity;
  std::span<const std::byte> connectivity_bytes;  ///< without what stands before
  std::uint64_t connectivity_at = 0;
  std::uint64_t payload_size = 0;
  struct AttributeSection {
    AttributeHeader header;
    std::span<const std::byte> bytes;
    std::uint64_t at = 0;
    std::uint64_t count = 0;  ///< elements
    bool wanted = true;       ///< false: only others need it,
    bool decoded = true;      ///< its values too; false: only which corners share them

    std::uint64_t places = 0;  ///< not 0: that many are coded, of welded vertices

    /// That are coded.
    std::uint64_t values() const { return places > 0 ? places : header.values(count); }
  };
  std::vector<AttributeSection> attributes;
  /// The number of the attribute whose values are the joints of the weights of this number; that of
  /// all attributes if there is none.
  std::size_t joints_of(std::size_t weights) const;
  /// Leaves those that are wanted, and what these need. Precondition: one flag for each.
  void keep_attributes(const std::vector<bool>& wanted);

  std::uint64_t seam_size = 0;  ///< of the section's payload

  bool is_welded() const { return features & feature::welded && features != feature::raw; }
  bool may_have_sizes() const {
    return features & (feature::polygons | feature::degenerate | feature::raw);
  }
};

/// One mesh of a file: its sections, with what they say about sizes.
struct MeshSections {
  std::vector<PieceSections> pieces;  ///< one at least
  std::uint64_t vertices = 0, faces = 0, corners = 0;
  Stream order;
  std::optional<MetadataHeader> metadata;
  std::string name;
  bool has_order = false, has_name = false;

  std::uint64_t count(Domain domain) const {
    switch (domain) {
      case Domain::vertex: return vertices;
      case Domain::corner: return corners;
      case Domain::face: return faces;
    }
    return 0;
  }

  bool may_have_sizes() const {
    return std::any_of(pieces.begin(), pieces.end(),
                       [](const PieceSections& p) { return p.may_have_sizes(); });
  }
};

struct FileSections {
  std::vector<MeshSections> meshes;
  SceneSections scene;
};

/// Everything that can be checked before a mesh is decoded, against the limits too. What is
/// returned is taken out of the budget; what decoding will need is not.
Expected<FileSections> read_sections(ContainerReader& file, const Limits& limits, Budget& budget);

}  // namespace clers::internal

#endif
