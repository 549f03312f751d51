// What names accessors besides primitives: animations, skins, instances.
#ifndef CLERS_CODEC_GLTF_USES_H
#define CLERS_CODEC_GLTF_USES_H

#include <string>
#include <vector>

#include "codec/gltf/layout.h"

namespace clers::gltf {

struct Use {
  std::string name = {};   ///< of the arrays for such; "" for none
  std::uint64_t each = 1;  ///< so many elements are one value
};

/// One an accessor. Errors: malformed.
Expected<std::vector<Use>> other_uses(const Layout& layout, const Json& document);

}  // namespace clers::gltf

#endif
