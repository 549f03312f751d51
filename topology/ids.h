// Identifiers of a surface's elements: distinct types over a 32-bit index.
#ifndef CLERS_TOPOLOGY_IDS_H
#define CLERS_TOPOLOGY_IDS_H

#include <compare>
#include <cstdint>
#include <functional>

#include <clers/topology/export.h>

namespace CLERS_VISIBLE clers {

/// An index that knows what it counts. Default: the null id. Converts from and to integers only
/// explicitly, and never compares with an id of another kind.
template <class Tag>
class Id {
 public:
  static constexpr std::uint32_t null_index = 0xffffffffu;

  constexpr Id() = default;
  constexpr explicit Id(std::uint32_t index) : index_(index) {}

  constexpr std::uint32_t index() const { return index_; }
  constexpr explicit operator bool() const { return index_ != null_index; }

  friend constexpr bool operator==(Id, Id) = default;
  friend constexpr auto operator<=>(Id, Id) = default;

 private:
  std::uint32_t index_ = null_index;
};

using Vertex = Id<struct VertexTag>;
using Face = Id<struct FaceTag>;
using HalfEdge = Id<struct HalfEdgeTag>;    ///< 3f+i runs from corner i to corner i+1 of face f
using Curve = Id<struct CurveTag>;          ///< a boundary curve
using Component = Id<struct ComponentTag>;  ///< a connected component
using Point = Id<struct PointTag>;  ///< what copies of a vertex made by a cut share (Appendix A)

constexpr std::uint32_t max_faces = 0xfffffffeu / 3;  ///< so that every half-edge has an id

constexpr HalfEdge half_edge(Face f, unsigned corner) {
  return HalfEdge(3 * f.index() + corner);
}
constexpr Face left(HalfEdge h) {
  return Face(h.index() / 3);
}
constexpr unsigned corner(HalfEdge h) {
  return h.index() % 3;
}
constexpr HalfEdge lnext(HalfEdge h) {
  return HalfEdge(corner(h) == 2 ? h.index() - 2 : h.index() + 1);
}
constexpr HalfEdge lprev(HalfEdge h) {
  return HalfEdge(corner(h) == 0 ? h.index() + 2 : h.index() - 1);
}

}  // namespace clers

template <class Tag>
struct std::hash<clers::Id<Tag>> {
  std::size_t operator()(clers::Id<Tag> id) const noexcept { return id.index(); }
};

#endif
