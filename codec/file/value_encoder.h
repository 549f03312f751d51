// The attributes of a mesh -> their sections, once its faces are coded. Knows which values are
// coded after which, and nothing of what is in their bytes.
#ifndef CLERS_CODEC_FILE_VALUE_ENCODER_H
#define CLERS_CODEC_FILE_VALUE_ENCODER_H

#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include "codec/attributes/attribute_encoder.h"
#include "codec/attributes/coded_faces.h"
#include "codec/attributes/points.h"
#include "codec/base/faces.h"
#include "codec/error.h"
#include "codec/mesh_view.h"
#include "codec/options.h"
#include "codec/order.h"
#include "codec/soup/reversed_faces.h"

namespace clers::internal {

/// Takes the stage of the work and the share of it that is done.
using Progress = std::function<void(std::string_view stage, double share)>;

/// A mesh whose faces are coded.
struct CodedMesh {
  MeshView mesh;
  const Cycles& faces;  ///< its own
  const Permutation& order;
  std::span<const ReversedRun> reversed;
  CodedFaces coded;                ///< the faces in that order, of welded vertices if they are
  const Points* points = nullptr;  ///< or not
};

/// Whether an attribute is coded with a structure (structure_encoder.h), for which CodedFaces need
/// all corners.
inline bool may_have_structure(const AttributeView& a) {
  return a.domain == Domain::corner || !a.indices.empty();
}

/// Whether values of faces may be coded along a surface (face_surface.h), for which CodedFaces need
/// all corners, too.
inline bool may_be_predicted_by_faces(const AttributeView& a, int level) {
  return a.domain == Domain::face && a.components == 3 && a.indices.empty() &&
         level >= first_level_with_twins;
}

/// Encodes all attributes; as many `plans`, or none. Errors: internal. Throws std::bad_alloc only.
Expected<std::vector<EncodedAttribute>> encode_values(const CodedMesh& mesh,
                                                      const EncodeOptions& options,
                                                      std::span<const AttributePlan> plans,
                                                      unsigned threads, const Progress& progress);

}  // namespace clers::internal

#endif
