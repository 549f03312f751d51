// Paths down the binary tree of a base face, and the places they lead to.
#include "topology/modeling/labels.h"

#include <algorithm>
#include <array>
#include <bit>

namespace CLERS_VISIBLE clers {
namespace {

constexpr unsigned bits = MultiTriangulation::max_level / 2;  // of the finest lattice
constexpr std::uint32_t one = std::uint32_t{1} << bits;

struct Place {
  std::uint32_t i, j;
};

Place between(Place a, Place b) {
  return {(a.i + b.i) / 2, (a.j + b.j) / 2};
}

}  // namespace

double Label::u() const {
  return static_cast<double>(i) / static_cast<double>(std::uint32_t{1} << ((level + 1) / 2));
}
double Label::v() const {
  return static_cast<double>(j) / static_cast<double>(std::uint32_t{1} << ((level + 1) / 2));
}

Labels::Labels(const MultiTriangulation& base) : parts_(base.surface().face_limit()) {
  const Surface& surface = base.surface();
  for (const Face f : surface.faces()) {
    const HalfEdge h = MultiTriangulation::split_edge(f);
    if (surface.edge(h) != h) continue;
    for (const HalfEdge side : surface.star(h))
      parts_[left(side).index()].base = 2 * blocks_ + (side == h ? 0 : 1);
    ++blocks_;
  }
}

Label Labels::of_corner(const MultiTriangulation& mesh, Face f, unsigned c) const {
  const Part& part = parts_[f.index()];
  std::array<Place, 3> at = part.base % 2 == 0
                                ? std::array<Place, 3>{{{0, 0}, {one, 0}, {0, one}}}
                                : std::array<Place, 3>{{{one, one}, {0, one}, {one, 0}}};
  const std::uint64_t path = part.path();
  for (int bit = static_cast<int>(std::bit_width(path)) - 2; bit >= 0; --bit) {
    const Place middle = between(at[1], at[2]);
    at = (path >> bit & 1) == 0 ? std::array<Place, 3>{middle, at[0], at[1]}
                                : std::array<Place, 3>{middle, at[2], at[0]};
  }
  const unsigned level = mesh.level(mesh.surface().org(half_edge(f, c)));
  const unsigned coarser = bits - (level + 1) / 2;
  return {part.base / 2, at[c].j >> coarser, at[c].i >> coarser, level};
}

Label Labels::of(const MultiTriangulation& mesh, Vertex v) const {
  const HalfEdge first = mesh.surface().star_half_edge(v);
  Label least = of_corner(mesh, left(first), corner(first));
  for (const HalfEdge h : mesh.surface().fan(v))
    least = std::min(least, of_corner(mesh, left(h), corner(h)));
  return least;
}

void Labels::refined(const Surface& surface, const Refined& change) {
  parts_.resize(std::max<std::size_t>(parts_.size(), surface.face_limit()));
  // From the star half-edge on, the new part of a face and then the one that kept its id, which is
  // at the origin of the split edge's side (Surface::split).
  Face made;
  for (const HalfEdge h : surface.fan(change.made)) {
    if (!made) {
      made = left(h);
      continue;
    }
    Part& part = parts_[left(h).index()];
    parts_[made.index()].base = part.base;
    parts_[made.index()].set(2 * part.path() + 1);
    part.set(2 * part.path());
    made = Face();
  }
}

void Labels::simplified(const Surface& surface, const Simplified& change) {
  for (const HalfEdge side : surface.star(change.edge)) {
    Part& part = parts_[left(side).index()];
    part.set(part.path() / 2);
  }
}

}  // namespace clers
