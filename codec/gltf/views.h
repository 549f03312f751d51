// Views of buffers, exchanged for others.
#ifndef CLERS_CODEC_GLTF_VIEWS_H
#define CLERS_CODEC_GLTF_VIEWS_H

#include <cstddef>
#include <cstdint>
#include <vector>

#include "codec/gltf/json.h"
#include "codec/gltf/layout.h"
#include "codec/gltf/values.h"

namespace clers::gltf {

/// What a view is to hold.
struct NewView {
  std::vector<std::byte> bytes;
  std::uint64_t stride = 0;  ///< 0: not said
  std::uint64_t target = 0;  ///< likewise
};

/// Puts new views at the places of others, which nothing names any more, and behind the last. No
/// view gets another number, and bytes that no view has are left out. Where there are fewer new
/// ones, the last stands at all places that are left. Returns their numbers. Precondition: the
/// document has this layout.
std::vector<std::size_t> exchange_views(const Layout& layout, std::vector<std::size_t> places,
                                        std::vector<NewView> views, Json& document,
                                        Buffers& buffers);

}  // namespace clers::gltf

#endif
