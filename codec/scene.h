// What a file may hold beside meshes: values of no mesh, bytes, and a document that says what all
// that is.
#ifndef CLERS_CODEC_SCENE_H
#define CLERS_CODEC_SCENE_H

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <clers/mesh.h>
#include <clers/scalar.h>
#include <clers/topology/export.h>

namespace CLERS_VISIBLE clers {

/// Values that belong to no mesh: keys of an animation, matrices of joints, indices of lines. Like
/// an Attribute, but of as many values as there are, in an order that is kept.
struct Array {
  std::string name;  ///< UTF-8, at most 255 bytes; need not be the only one of its name
  Scalar scalar = Scalar::float32;
  std::uint8_t components = 1;  ///< at least 1
  std::vector<std::byte> data;  ///< stride() bytes a value; at most 2^32 - 1 values

  /// If set, the values are vertices of this mesh, an index into Scene::meshes: single
  /// Scalar::uint32, each below its vertex_count. encode() renumbers them as it does vertices.
  std::optional<std::size_t> vertices_of = {};

  std::size_t stride() const { return size_of(scalar) * components; }
  std::size_t value_count() const { return data.size() / stride(); }
};

/// Bytes that come back as they are: a picture, what no accessor of a glTF names.
struct Blob {
  std::string name;  ///< UTF-8, at most 255 bytes
  std::vector<std::byte> bytes;
};

/// Meshes, and what there is besides. A point cloud, or the points of lines, is a mesh without
/// faces. The library looks into none of the texts: `document` says what arrays, blobs and
/// attributes are, in the words of who wrote it. <clers/gltf.h> has the JSON of a glTF there.
struct Scene {
  std::vector<Mesh> meshes;
  std::vector<Array> arrays;
  std::vector<Blob> blobs;
  std::string document;                 ///< any bytes; may be empty
  std::vector<MetadataEntry> metadata;  ///< of the file; meshes have their own
};

}  // namespace clers

#endif
