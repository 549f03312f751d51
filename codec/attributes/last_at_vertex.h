// Which value was coded last at each vertex of the mesh: across a seam values are often the same.
#ifndef CLERS_CODEC_ATTRIBUTES_LAST_AT_VERTEX_H
#define CLERS_CODEC_ATTRIBUTES_LAST_AT_VERTEX_H

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

namespace clers::internal {

class LastAtVertex {
 public:
  static constexpr std::uint32_t none = 0xffffffffu;

  /// The vertex of each value; or nothing is known, if there are none.
  explicit LastAtVertex(std::span<const std::uint32_t> vertex_of) : vertex_of_(vertex_of) {
    std::uint32_t vertices = 0;
    for (const std::uint32_t v : vertex_of) vertices = std::max(vertices, v + 1);
    last_.assign(vertices, none);
  }
  static std::uint64_t memory(std::uint64_t vertices) { return 4 * vertices; }

  /// The value coded last at the vertex of this one, or none.
  std::uint32_t operator()(std::uint32_t value) const {
    return vertex_of_.empty() ? none : last_[vertex_of_[value]];
  }
  void coded(std::uint32_t value) {
    if (!vertex_of_.empty()) last_[vertex_of_[value]] = value;
  }

 private:
  std::span<const std::uint32_t> vertex_of_;
  std::vector<std::uint32_t> last_;
};

}  // namespace clers::internal

#endif
