// What an operator's inverse leaves out, read off its Change.
#include "topology/modeling/operator_log.h"

namespace CLERS_VISIBLE clers {

void OperatorLog::operator()(const Change& change) {
  reserve(1);
  operators_.resize(place_), points_.resize(point_place_), stars_.resize(star_place_);
  const auto slots = change.slots();
  Operator o;
  if (!change.gone()) {
    o.at = slots[0].at;
  } else {
    const bool face = change.gone_faces().size() == 2 && slots.size() == 3;
    o.kind = face                ? Kind::weld_face
             : slots.size() == 6 ? Kind::weld_interior_edge
                                 : Kind::weld_boundary_edge;
    o.at = slots[face ? 0 : 1].at;
    // Sides of the rim came after the side that left the vertex.
    unsigned count = 0;
    for (std::size_t i = 0; i < slots.size(); ++i)
      if (face || i % 3 != 1)
        o.corners =
            static_cast<std::uint8_t>(o.corners | corner(lprev(slots[i].side)) << 2 * count++);
    points_.push_back(change.gone_point());
  }
  for (const HalfEdge h : change.stars()) stars_.push_back(h);
  o.stars = static_cast<std::uint8_t>(change.stars().size());
  operators_.push_back(o);
  place_ = operators_.size(), point_place_ = points_.size(), star_place_ = stars_.size();
}

}  // namespace clers
