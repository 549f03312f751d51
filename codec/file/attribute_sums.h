// What attributes cost, entered into the figures of a mesh. Knows types and bytes, no values.
#ifndef CLERS_CODEC_FILE_ATTRIBUTE_SUMS_H
#define CLERS_CODEC_FILE_ATTRIBUTE_SUMS_H

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "codec/info.h"
#include "codec/mesh.h"

namespace clers::internal {

/// The attributes of a mesh, whose pieces all have the same ones.
class AttributeSums {
 public:
  explicit AttributeSums(MeshInfo& info) : info_(&info) {}

  /// Attribute i of the mesh, or of one more piece of it, where `count` of its values are new;
  /// those before i were entered. How it is coded is said of the first piece. The first "position"
  /// of vertices is the position.
  void add(std::size_t i, AttributeInfo what, std::uint64_t count) {
    const std::uint64_t bytes = what.bytes;
    if (i == info_->attributes.size()) {
      if (position_ == none && what.domain == Domain::vertex && what.name == position_name)
        position_ = i;
      what.count = what.bytes = 0;
      info_->attributes.push_back(std::move(what));
    } else {
      info_->attributes[i].error = std::max(info_->attributes[i].error, what.error);
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
