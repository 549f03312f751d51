// Bytes of buffers that no mesh and no array has: pictures, and everything else.
#ifndef CLERS_CODEC_GLTF_REST_H
#define CLERS_CODEC_GLTF_REST_H

#include <string>
#include <utility>
#include <vector>

#include "codec/gltf/layout.h"
#include "codec/gltf/plan.h"

namespace clers::gltf {

/// A blob: its name, and the parts of a buffer that it is made of, one after the other.
struct Remains {
  std::string name;
  std::size_t buffer = 0;
  std::vector<std::pair<std::size_t, std::size_t>> parts;  ///< from, to
  std::size_t size() const;
};

/// All blobs that are parts of buffers, in order: for each buffer with bytes what nobody has, and
/// each picture in a view that is one's alone. Cost: linear in the buffers' sizes, a bit a byte.
std::vector<Remains> find_remains(const Layout& layout, const Plan& plan, const Json& document,
                                  const std::vector<bool>& empty);

/// Whether a blob of zeros is left out.
inline constexpr std::size_t most_zeros = 1 << 16;

/// "image 3", "buffer 0"
std::string blob_name(const char* what, std::size_t index);

}  // namespace clers::gltf

#endif
