// What is known of a mesh, and of what it costs in a file.
#ifndef CLERS_CODEC_INFO_H
#define CLERS_CODEC_INFO_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "codec/mesh.h"

namespace clers {

/// Shape of a mesh. Components, boundary curves and genus are those of the surface that is left
/// when it is cut at its non-manifold edges and vertices.
struct MeshShape {
  std::uint64_t vertices = 0;
  std::uint64_t faces = 0;
  std::uint64_t triangles = 0;  ///< a polygon of n corners counts n-2
  std::uint64_t components = 0;
  std::uint64_t boundary_curves = 0;
  std::uint64_t genus = 0;                 ///< sum over the components
  std::uint64_t nonmanifold_edges = 0;     ///< edges of more than two faces
  std::uint64_t nonmanifold_vertices = 0;  ///< vertices whose faces form more than one fan
  std::uint64_t misoriented_edges = 0;     ///< edges of two faces that run along them the same way
  std::uint64_t degenerate_faces = 0;      ///< faces that use a vertex twice, or have under three
  std::uint64_t duplicate_faces = 0;       ///< faces on the same vertices as an earlier one
  std::uint64_t nonorientable_components = 0;  ///< that have no consistent orientation
  std::uint64_t isolated_vertices = 0;         ///< vertices that no face uses
};

/// Cost of one attribute in a file.
struct AttributeInfo {
  std::string name;
  Domain domain = Domain::vertex;
  Scalar scalar = Scalar::float32;
  std::uint8_t components = 1;
  std::uint64_t count = 0;  ///< values
  std::uint64_t bytes = 0;  ///< compressed
};

/// What the codec did to make an oriented manifold surface of a mesh; decoding undoes it.
struct Cuts {
  std::uint64_t turned_faces = 0;     ///< ran against their component
  std::uint64_t copied_vertices = 0;  ///< the surface has more vertices than the mesh by as many
  std::uint64_t repeated_faces = 0;   ///< coded as references to another face
  std::uint64_t loose_faces = 0;      ///< coded separately because degenerate
};

/// One mesh of a file.
struct MeshInfo {
  MeshShape shape;
  std::uint64_t pieces = 1;                 ///< that decode alone
  Cuts cuts;                                ///< summed over the pieces, as all below
  std::array<std::uint64_t, 5> clers = {};  ///< how many C, L, E, R, S
  std::uint64_t connectivity_bytes = 0;     ///< of the faces, all told
  std::uint64_t polygon_bytes = 0;          ///< of them: which triangles make a polygon
  std::uint64_t stitching_bytes = 0;        ///< of them: what undoes the cuts, seams included
  std::uint64_t order_bytes = 0;            ///< of them: the order of the file, where it is kept
  std::uint64_t position_bytes = 0;
  std::uint64_t attribute_bytes = 0;  ///< of all attributes but the position
  std::uint64_t metadata_bytes = 0;
  std::vector<AttributeInfo> attributes;
  std::string name;
  std::vector<MetadataEntry> metadata;  ///< of inspect() only
};

struct FileInfo {
  std::uint32_t format_major = 0, format_minor = 0;
  int level = 0;  ///< that the file was made with
  std::uint64_t total_bytes = 0;
  std::uint64_t overhead_bytes = 0;  ///< total less what is told of the meshes
  std::vector<MeshInfo> meshes;
};

}  // namespace clers

#endif
