// What others compressed becomes plain views, before anything else looks at the document.
#ifndef CLERS_CODEC_GLTF_FOREIGN_H
#define CLERS_CODEC_GLTF_FOREIGN_H

#include <cstdint>
#include <string>
#include <vector>

#include "codec/gltf/gltf.h"
#include "codec/gltf/json.h"
#include "codec/gltf/values.h"
#include <clers/error.h>

namespace clers::gltf {

/// KHR_draco_mesh_compression: values of accessors, decoded, in views of their own. `empty`:
/// buffers without bytes. Does nothing to a document without the extension; without `decode` only a
/// remark is made. Errors: malformed; those of `decode`.
Expected<Done> decode_draco(Json& document, Buffers& buffers, const std::vector<bool>& empty,
                            const decltype(Decoders::draco)& decode,
                            std::vector<std::string>& remarks);

/// EXT_meshopt_compression: views, decoded at their places. Buffers that only stood for them go:
/// the last ones, so that no other gets another number. `empty`: as a list. The same errors.
Expected<Done> decode_meshopt(Json& document, Buffers& buffers, std::vector<std::uint64_t>& empty,
                              const decltype(Decoders::meshopt)& decode,
                              std::vector<std::string>& remarks);

/// A remark that what an extension compressed stays so.
inline std::string kept_compressed(const std::string& extension) {
  return extension + " is not decoded here: what it compressed is carried as it is";
}

}  // namespace clers::gltf

#endif
