// Are two surfaces the same up to renumbering, or up to homeomorphism?
#ifndef CLERS_TOPOLOGY_EQUIVALENCE_H
#define CLERS_TOPOLOGY_EQUIVALENCE_H

#include <optional>
#include <vector>

#include <clers/topology/export.h>
#include <clers/topology/surface.h>

namespace CLERS_VISIBLE clers {

/// Which element of the second surface each element of the first is; null at dead ids.
struct Correspondence {
  std::vector<HalfEdge> half_edges;  ///< by half-edge of the first; faces follow by left()
  std::vector<Vertex> vertices;      ///< by vertex of the first
};

/// A renumbering of faces, their corners (rotated) and vertices that turns `a` into `b` and keeps
/// the orientation, or nothing if there is none. Points do not matter.
///
/// Two components are compared by a walk that starts from one half-edge and must fit everywhere; it
/// is tried from each half-edge of the rarest neighbourhood. O(F log F) when few look alike; up to
/// O(F^2) for a regular surface that is almost the other.
std::optional<Correspondence> equivalent(const Surface& a, const Surface& b);

/// Is there a homeomorphism? By the classification of surfaces (Theorem 2) there is one if the
/// components of the two can be matched so that genus and number of boundary curves agree, however
/// they are triangulated. O(s log s) for s components, besides one look at every component id.
bool homeomorphic(const Surface& a, const Surface& b);

}  // namespace clers

#endif
