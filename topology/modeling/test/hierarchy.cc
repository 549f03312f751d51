#include "topology/modeling/test/hierarchy.h"

namespace clers::test {

Hierarchy::Hierarchy(const Surface& base)
    : org_(base.origins().begin(), base.origins().end()),
      twin_(base.twins().begin(), base.twins().end()) {
  for (std::uint32_t f = 0; f < base.face_limit(); ++f) {
    Triangle t;
    t.base = f;
    t.at = {Place{0, 0}, Place{Spot::unit, 0}, Place{0, Spot::unit}};
    triangles_.push_back(t);
    if (!base.is_live(Face(f))) continue;
    for (unsigned i = 0; i < 3; ++i) add(middle(t, i), f);
    ++leaves_;
  }
  for ([[maybe_unused]] const Vertex v : base.vertices()) ++vertices_;
}

Place Hierarchy::between(Place a, Place b) {
  const auto half = [](std::uint32_t p, std::uint32_t q) {
    return static_cast<std::uint32_t>((std::uint64_t{p} + q) / 2);
  };
  return {half(a.x, b.x), half(a.y, b.y)};
}

Spot Hierarchy::spot(std::uint32_t base, Place at) const {
  // On which sides of the face, and where along the first of them.
  const bool on[3] = {at.y == 0, at.x + at.y == Spot::unit, at.x == 0};
  const std::uint32_t along[3] = {at.x, at.y, Spot::unit - at.y};
  for (unsigned i = 0; i < 3; ++i) {
    if (!on[i]) continue;
    const std::uint32_t h = 3 * base + i, twin = twin_[h].index();
    if (on[(i + 2) % 3] && along[i] == 0) return {Spot::vertex, org_[h].index(), 0, 0};
    if (on[(i + 1) % 3] && along[i] == Spot::unit)
      return {Spot::vertex, org_[3 * base + (i + 1) % 3].index(), 0, 0};
    if (twin_[h] && twin < h) return {Spot::edge, twin, Spot::unit - along[i], 0};
    return {Spot::edge, h, along[i], 0};
  }
  return {Spot::face, base, at.x, at.y};
}

Spot Hierarchy::middle(const Triangle& t, unsigned edge) const {
  return spot(t.base, between(t.at[edge], t.at[(edge + 1) % 3]));
}

void Hierarchy::add(const Spot& edge, std::uint32_t t) {
  auto& at = edges_[edge].triangles;
  (at[0] == none ? at[0] : at[1]) = t;
}

/// Once: a triangle may be on both sides of an edge.
void Hierarchy::replace(const Spot& edge, std::uint32_t t, std::uint32_t by) {
  auto& at = edges_.find(edge)->second.triangles;
  (at[0] == t ? at[0] : at[1]) = by;
}

void Hierarchy::split(std::uint32_t t) {
  if (triangles_[t].parts == none) {
    const Triangle whole = triangles_[t];
    const Place m = between(whole.at[1], whole.at[2]);
    triangles_[t].parts = static_cast<std::uint32_t>(triangles_.size());
    triangles_.push_back({whole.base, whole.level + 1, {m, whole.at[0], whole.at[1]}, none, false});
    triangles_.push_back({whole.base, whole.level + 1, {m, whole.at[2], whole.at[0]}, none, false});
  }
  const std::uint32_t first = triangles_[t].parts, second = first + 1;
  replace(middle(triangles_[t], 0), t, first);
  replace(middle(triangles_[t], 2), t, second);
  add(middle(triangles_[first], 0), first);
  add(middle(triangles_[first], 2), first);
  add(middle(triangles_[second], 0), second);
  add(middle(triangles_[second], 2), second);
  triangles_[t].is_split = true;
  ++leaves_;
}

void Hierarchy::weld(std::uint32_t t) {
  const std::uint32_t first = triangles_[t].parts, second = first + 1;
  replace(middle(triangles_[t], 0), first, t);
  replace(middle(triangles_[t], 2), second, t);
  for (const std::uint32_t part : {first, second})
    for (const unsigned edge : {0u, 2u}) edges_.erase(middle(triangles_[part], edge));
  triangles_[t].is_split = false;
  --leaves_;
}

void Hierarchy::refine_all(const Spot& edge) {
  for (bool waits = true; waits;) {
    waits = false;
    for (const std::uint32_t t : edges_.find(edge)->second.triangles) {
      if (t == none) continue;
      const Spot first = middle(triangles_[t], 1);
      if (first == edge) continue;
      refine_all(first);
      waits = true;
      break;  // the edge has another triangle now
    }
  }
  const auto at = edges_.find(edge)->second.triangles;
  for (const std::uint32_t t : at)
    if (t != none) split(t);
  edges_.find(edge)->second = {at, true};
  changed_.push_back(edge);
  ++vertices_;
}

void Hierarchy::simplify_all(const Spot& vertex) {
  const auto at = edges_.find(vertex)->second.triangles;
  for (const std::uint32_t t : at)
    for (std::uint32_t part = 0; t != none && part < 2; ++part)
      if (const Triangle& p = triangles_[triangles_[t].parts + part]; p.is_split)
        simplify_all(middle(p, 1));
  for (const std::uint32_t t : at)
    if (t != none) weld(t);
  edges_.find(vertex)->second = {at, false};
  changed_.push_back(vertex);
  --vertices_;
}

void Hierarchy::refine(const Spot& middle) {
  changed_.clear();
  refine_all(middle);
}

void Hierarchy::simplify(const Spot& vertex) {
  changed_.clear();
  simplify_all(vertex);
}

unsigned Hierarchy::sides(const Spot& middle) const {
  const auto it = edges_.find(middle);
  if (it == edges_.end() || it->second.is_split) return 0;
  return it->second.triangles[1] == none ? 1 : 2;
}

std::optional<unsigned> Hierarchy::level(const Spot& vertex) const {
  const auto it = edges_.find(vertex);
  if (it == edges_.end() || !it->second.is_split) return std::nullopt;
  return triangles_[it->second.triangles[0]].level + 1;
}

std::optional<std::uint32_t> Hierarchy::leaf(std::uint32_t base,
                                             const std::array<Place, 3>& corners) const {
  const auto it = edges_.find(spot(base, between(corners[1], corners[2])));
  if (it == edges_.end() || it->second.is_split) return std::nullopt;
  for (const std::uint32_t t : it->second.triangles)
    if (t != none && triangles_[t].base == base && triangles_[t].at == corners) return t;
  return std::nullopt;
}

}  // namespace clers::test
