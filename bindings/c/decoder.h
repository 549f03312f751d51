// What a clers_decoder is, and what of it may be asked for.
#ifndef CLERS_BINDINGS_C_DECODER_H
#define CLERS_BINDINGS_C_DECODER_H

#include <cstddef>
#include <string>
#include <vector>

#include "bindings/c/structs.h"
#include "codec/decoder.h"
#include "codec/info.h"

/// What was read once: infos hand out its names.
struct clers_decoder {
  clers::Decoder decoder;
  clers::FileInfo info;
  std::vector<std::size_t> first_pieces;  ///< one a mesh
};

namespace clers::internal {

inline Expected<const MeshInfo*> mesh_info(const clers_decoder* decoder, std::size_t mesh) {
  if (decoder == nullptr) return bad_option("no decoder");
  const auto& meshes = decoder->info.meshes;
  if (mesh >= meshes.size())
    return bad_option("mesh " + std::to_string(mesh) + ", there are " +
                      std::to_string(meshes.size()));
  return &meshes[mesh];
}

inline Expected<const AttributeInfo*> attribute_info(const MeshInfo& mesh, std::size_t attribute) {
  if (attribute >= mesh.attributes.size())
    return bad_option("attribute " + std::to_string(attribute) + ", there are " +
                      std::to_string(mesh.attributes.size()));
  return &mesh.attributes[attribute];
}

}  // namespace clers::internal

#endif
