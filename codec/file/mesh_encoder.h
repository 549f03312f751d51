// A mesh -> the sections of it: which stream is encoded after which, and whether the faces are raw
// instead. Knows the streams by their rooms, and nothing of what is in them.
#ifndef CLERS_CODEC_FILE_MESH_ENCODER_H
#define CLERS_CODEC_FILE_MESH_ENCODER_H

#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include "codec/attributes/attribute_encoder.h"
#include "codec/entropy/bytes.h"
#include "codec/error.h"
#include "codec/file/container.h"
#include "codec/file/value_encoder.h"
#include "codec/info.h"
#include "codec/mesh_view.h"
#include "codec/options.h"

namespace clers::internal {

struct EncodedSection {
  SectionKind kind;
  Bytes payload;

  friend bool operator==(const EncodedSection&, const EncodedSection&) = default;
};

/// A mesh, or a piece of one, that will decode alone.
struct EncodedMesh {
  std::vector<EncodedSection> sections;
  Permutation order;
  MeshInfo info;
  CodingCounts counts;
  bool has_boundary = false;  ///< the surface has, or there is none
};

/// Refuses meshes whose arrays disagree, and those with faces that the options do not allow.
Expected<Done> check(const MeshView& mesh, const EncodeOptions& options);

/// Encodes in one piece. `progress` takes shares of this mesh. Threads are for its attributes.
/// Precondition: check() has passed it. Errors: internal, limit.
/// Throws std::bad_alloc only.
Expected<EncodedMesh> encode_mesh(const MeshView& mesh, const EncodeOptions& options,
                                  std::span<const AttributePlan> plans, unsigned threads,
                                  const Progress& progress);

}  // namespace clers::internal

#endif
