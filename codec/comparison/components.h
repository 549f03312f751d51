// The components of a compared mesh: faces that vertices connect. Knows colours of faces.
#ifndef CLERS_CODEC_COMPARISON_COMPONENTS_H
#define CLERS_CODEC_COMPARISON_COMPONENTS_H

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "codec/comparison/compared_mesh.h"

namespace clers::internal {

class Components {
 public:
  /// `by_colour`: all faces of the mesh. Those without corners are in no component.
  /// Cost: nearly linear.
  Components(const ComparedMesh& mesh, const Classes& by_colour);

  std::uint32_t count() const { return static_cast<std::uint32_t>(colour.size()); }
  /// The faces of a component, by colour.
  std::span<const std::pair<Colour, std::uint32_t>> faces(std::uint32_t k) const {
    return std::span(faces_).subspan(begin_[k], begin_[k + 1] - begin_[k]);
  }

  std::vector<Colour> colour;  ///< of each component: the multiset of its faces' colours

 private:
  Classes faces_;
  std::vector<std::uint32_t> begin_;
};

}  // namespace clers::internal

#endif
