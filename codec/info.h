// What can be known of a mesh, and of a mesh in a file.
#ifndef CLERS_CODEC_INFO_H
#define CLERS_CODEC_INFO_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <clers/mesh.h>
#include <clers/precision.h>
#include <clers/topology/export.h>

namespace CLERS_VISIBLE clers {

/// A mesh as it is measured, defects included.
struct MeshShape {
  std::uint64_t vertices = 0;
  std::uint64_t faces = 0;
  std::uint64_t triangles = 0;             ///< a polygon of n corners counts n - 2
  std::uint64_t isolated_vertices = 0;     ///< vertices that no face uses
  std::uint64_t nonmanifold_edges = 0;     ///< edges of more than two faces
  std::uint64_t nonmanifold_vertices = 0;  ///< vertices whose faces form more than one fan
  std::uint64_t misoriented_edges = 0;     ///< edges of two faces that run along them the same way
  std::uint64_t degenerate_faces = 0;      ///< faces that repeat a vertex, or have fewer than three
  std::uint64_t duplicate_faces = 0;       ///< faces on the same vertices as an earlier one

  /// What is left without degenerate faces, cut at non-manifold edges and vertices.
  struct Surface {
    std::uint64_t components = 0;
    std::uint64_t nonorientable_components = 0;  ///< of them: with no consistent orientation
    std::uint64_t boundary_curves = 0;
    std::uint64_t genus = 0;  ///< sum over the components
  } surface;
};

/// An attribute in a file.
struct AttributeInfo {
  std::string name;
  Domain domain = Domain::vertex;
  Scalar scalar = Scalar::float32;
  std::uint8_t components = 1;
  std::uint64_t count = 0;  ///< values: one an element, or as many as there are by index
  std::uint64_t bytes = 0;  ///< compressed
  /// What values have in common, by which they became integers, and what coded these, for people:
  /// "3 decimals", "steps of 0.01", "float, 24 bits"; "sized", "named". Of the first piece.
  std::string numbers, coder;
  /// Which elements have which values, for people; empty: each its own. "wedges": corners that no
  /// seam parts share one; "by index", "shared", "apart", "some missing", "some unused"; "welded":
  /// vertices at one place have one.
  std::string structure;
  /// By how much its values were changed at most. 0: they come back bit for bit.
  double error = 0;
  ErrorMeasure measure = ErrorMeasure::difference;  ///< what the error is

  std::uint64_t value_size() const { return size_of(scalar) * components; }
};

/// A mesh in a file, by what can be read without decoding it. Of a mesh in pieces, sums over them.
struct MeshInfo {
  std::string name;
  std::uint64_t vertices = 0, faces = 0, corners = 0;
  bool triangles_only = true;  ///< false: there are, or may be, other faces
  std::uint64_t pieces = 1;    ///< that decode alone

  // What encoding changed to have an oriented manifold surface, and decoding undoes.
  std::uint64_t copied_vertices = 0;   ///< the surface has this many more vertices than the mesh
  std::uint64_t welded_vertices = 0;   ///< .. or so many fewer, since others are at their place
  std::uint64_t repeated_faces = 0;    ///< coded as references to another face
  std::uint64_t degenerate_faces = 0;  ///< coded separately

  // Bytes that it takes.
  std::uint64_t connectivity_bytes = 0;  ///< of faces, with the three that follow
  std::uint64_t polygon_bytes = 0;       ///< which triangles form a polygon
  std::uint64_t stitching_bytes = 0;     ///< to undo the changes, and seams between pieces
  std::uint64_t order_bytes = 0;         ///< the order of the input, if it is kept
  std::uint64_t position_bytes = 0;
  std::uint64_t attribute_bytes = 0;  ///< of all attributes but the position
  std::uint64_t metadata_bytes = 0;

  std::vector<AttributeInfo> attributes;
  std::vector<MetadataEntry> metadata;  ///< empty in Encoded::report: the caller has it
};

/// What the faces of a mesh show once they are coded or decoded. Of a mesh in pieces, sums.
struct CodingCounts {
  std::uint64_t reversed_faces = 0;           ///< coded against their orientation
  std::array<std::uint64_t, 5> symbols = {};  ///< how many C, L, E, R, S
};

/// An array of a scene (<clers/scene.h>) in a file.
struct ArrayInfo {
  std::string name;
  Scalar scalar = Scalar::float32;
  std::uint8_t components = 1;
  std::uint64_t count = 0;                        ///< values
  std::uint64_t bytes = 0;                        ///< compressed
  std::string numbers, coder;                     ///< as in AttributeInfo
  std::optional<std::uint64_t> vertices_of = {};  ///< the mesh
  double error = 0;                               ///< as in AttributeInfo, of a component
};

/// A blob of a scene in a file.
struct BlobInfo {
  std::string name;
  std::uint64_t size = 0;   ///< of the blob
  std::uint64_t bytes = 0;  ///< compressed
};

/// What a file holds besides meshes.
struct SceneInfo {
  std::vector<ArrayInfo> arrays;
  std::vector<BlobInfo> blobs;
  std::uint64_t document_size = 0, document_bytes = 0;  ///< 0 without one
  std::uint64_t array_bytes = 0, blob_bytes = 0;        ///< of all
  std::uint64_t metadata_bytes = 0;
  std::vector<MetadataEntry> metadata = {};  ///< empty in Encoded: the caller has it

  std::uint64_t bytes() const { return document_bytes + array_bytes + blob_bytes + metadata_bytes; }
};

/// A file, by what can be read without decoding it.
struct FileInfo {
  std::uint32_t format_major = 0, format_minor = 0;
  int level = 0;  ///< that it was made with
  std::uint64_t total_bytes = 0;
  std::uint64_t overhead_bytes = 0;  ///< the total less what is counted for meshes and the scene
  std::vector<MeshInfo> meshes;
  SceneInfo scene;
};

}  // namespace clers

#endif
