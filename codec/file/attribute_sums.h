// What attributes cost, entered into the figures of a mesh. Knows types and bytes, no values.
#ifndef CLERS_CODEC_FILE_ATTRIBUTE_SUMS_H
#define CLERS_CODEC_FILE_ATTRIBUTE_SUMS_H

#include <cstddef>
#include <cstdint>
#include <string>

#include "codec/info.h"
#include "codec/mesh.h"

namespace clers::internal {

/// The attributes of a mesh, whose pieces all have the same ones.
class AttributeSums {
 public:
  explicit AttributeSums(MeshInfo& info) : info_(&info) {}

  /// Attribute i of the mesh, or of one more piece of it; those before i were entered. `what` has a
  /// name, domain, scalar and components. The first "position" of vertices is the position.
  template <class What>
  void add(std::size_t i, const What& what, std::uint64_t count, std::uint64_t bytes) {
    if (i == info_->attributes.size()) {
      info_->attributes.push_back(
          {std::string(what.name), what.domain, what.scalar, what.components, 0, 0});
      if (position_ == none && what.domain == Domain::vertex && what.name == position_name)
        position_ = i;
    }
    info_->attributes[i].count += count;
    info_->attributes[i].bytes += bytes;
    (position_ == i ? info_->position_bytes : info_->attribute_bytes) += bytes;
  }

 private:
  MeshInfo* info_;
  static constexpr auto none = static_cast<std::size_t>(-1);
  std::size_t position_ = none;
};

}  // namespace clers::internal

#endif
