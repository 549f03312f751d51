// What operators do where containers follow: out of the way of those without.
#include <array>

#include "topology/follow.h"
#include "topology/surface.h"

namespace CLERS_VISIBLE clers {

using internal::DataKind;

void Surface::reserve_face_data() {
  data_.reserve(DataKind::face, component_.capacity());
  data_.reserve(DataKind::half_edge, org_.capacity());
}
void Surface::reserve_vertex_data() {
  data_.reserve(DataKind::vertex, star_.capacity());
}

/// The face is new, and a part of `of`, if not null; its sides are new.
void Surface::make_data(Face f, Face of) {
  data_.resize(DataKind::face, component_.size());
  data_.resize(DataKind::half_edge, org_.size());
  data_.make(f, of);
  for (unsigned i = 0; i < 3; ++i) data_.make(half_edge(f, i), HalfEdge());
}

/// The vertex is new, and a copy of `of`, if not null; or is to be like it.
void Surface::make_data(Vertex v, Vertex of) {
  data_.resize(DataKind::vertex, star_.size());
  data_.make(v, of);
}

void Surface::move_sides(const Change& change) {
  std::array<internal::MovedValue, internal::AttachedData::max_moved> moved;
  std::size_t count = 0;
  for (const Change::Slot& slot : change.slots())
    moved[count++] = {slot.at.index(), slot.side.index()};
  data_.move_sides(moved.data(), count);
}

}  // namespace clers
