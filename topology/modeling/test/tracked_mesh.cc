#include "topology/modeling/test/tracked_mesh.h"

#include <algorithm>
#include <cstdlib>
#include <random>
#include <set>

#include "topology/dump.h"
#include "topology/validate.h"

namespace clers::test {

TrackedMesh::TrackedMesh(Surface base)
    : mesh_(*MultiTriangulation::over(std::move(base))),
      labels_(mesh_),
      oracle_(mesh_.surface()),
      base_dump_(dump(mesh_.surface())) {
  for (const Face f : surface().faces()) {
    const HalfEdge h = half_edge(f, 1), t = surface().sym(h);
    if (t && left(t) < f) continue;
    faces_of_block_.push_back(f.index());
    faces_of_block_.push_back(t ? left(t).index() : f.index());
  }
}

TrackedMesh::At TrackedMesh::at(const Label& label) const {
  const unsigned shift = 31 - (label.level + 1) / 2;
  const std::uint32_t i = label.i << shift, j = label.j << shift;
  if (std::uint64_t{i} + j <= Spot::unit) return {faces_of_block_[2 * label.block], {i, j}};
  return {faces_of_block_[2 * label.block + 1], {Spot::unit - i, Spot::unit - j}};
}

TrackedMesh::At TrackedMesh::corner_at(Face f, unsigned c) const {
  return at(labels_.of_corner(mesh_, f, c));
}

/// Of the corners' places in the face's own base face: a corner on the diagonal is in both.
Spot TrackedMesh::middle(HalfEdge h) const {
  const auto in = [](At p, std::uint32_t base) {
    return p.base == base ? p.place : Place{Spot::unit - p.place.x, Spot::unit - p.place.y};
  };
  std::uint32_t base = corner_at(left(h), corner(h)).base;
  const At a = corner_at(left(h), corner(h)), b = corner_at(left(h), corner(lnext(h)));
  const At c = corner_at(left(h), corner(lprev(h)));
  // The corner that is on no diagonal says which.
  for (const At& p : {a, b, c})
    if (p.place.x + p.place.y != Spot::unit) base = p.base;
  return oracle_.spot(base, Hierarchy::between(in(a, base), in(b, base)));
}

void TrackedMesh::Observer::operator()(const Refined& change) {
  of.labels_.refined(of.surface(), change);
  const Label label = of.labels_.of(of.mesh_, change.made);
  const At at = of.at(label);
  of.made_.push_back(of.oracle_.spot(at.base, at.place));
  if (!of.label_of_.emplace(change.made.index(), label).second) of.wrong_ = "a vertex made twice";
  if (!of.surface().is_live(change.a) || !of.surface().is_live(change.b))
    of.wrong_ = "ends that are not there";
  if (!of.mesh_.can_weld(change.made)) of.wrong_ = "a new vertex that cannot be welded";
}
void TrackedMesh::Observer::operator()(const Simplified& change) {
  const auto it = of.label_of_.find(change.gone.index());
  if (it == of.label_of_.end()) {
    of.wrong_ = "a vertex gone that was not made";
    return;
  }
  of.labels_.simplified(of.surface(), change);
  const At at = of.at(it->second);
  of.gone_.push_back(of.oracle_.spot(at.base, at.place));
  of.label_of_.erase(it);
  if (!of.mesh_.is_block(change.edge)) of.wrong_ = "a weld that left no block";
}

std::string TrackedMesh::compare(std::size_t made, std::size_t gone,
                                 const std::vector<Spot>& spots) {
  if (!wrong_.empty()) return wrong_;
  if (made_.size() != made || gone_.size() != gone) return "another number of splits or welds";
  auto ours = made != 0 ? made_ : gone_, theirs = spots;
  std::sort(ours.begin(), ours.end());
  std::sort(theirs.begin(), theirs.end());
  if (ours != theirs) return "other vertices";
  const Characteristic& c = surface().characteristic();
  if (c.f != static_cast<std::int64_t>(oracle_.leaves()) ||
      c.v != static_cast<std::int64_t>(oracle_.vertices()))
    return "another size";
  return "";
}

std::string TrackedMesh::refine(HalfEdge h) {
  made_.clear(), gone_.clear();
  const Spot spot = middle(h);
  const unsigned level = mesh_.level(left(h)) + (corner(h) == 1 ? 1u : 2u);
  const auto expected = mesh_.growth(h);
  const std::int64_t faces = surface().characteristic().f;
  const bool alone = mesh_.is_block(h);
  const auto v = mesh_.refine(h, Observer{*this});
  if (!v) return "refused: " + describe(v.error());
  oracle_.refine(spot);
  const std::size_t made = oracle_.changed().size();
  if (expected.splits != made) return "growth() has another number of splits";
  if (faces + expected.faces != surface().characteristic().f) return "growth() has other faces";
  if (alone != (made == 1)) return "is_block is wrong";
  if (made_.empty() || made_.back() != spot) return "another vertex";
  if (mesh_.level(*v) != level) return "another level";
  return compare(made, 0, oracle_.changed());
}

std::string TrackedMesh::simplify(Vertex v) {
  made_.clear(), gone_.clear();
  const At where = at(labels_.of(mesh_, v));
  const Spot spot = oracle_.spot(where.base, where.place);
  const bool alone = mesh_.can_weld(v);
  const auto edge = mesh_.simplify(v, Observer{*this});
  if (!edge) return "refused: " + describe(edge.error());
  oracle_.simplify(spot);
  const std::size_t gone = oracle_.changed().size();
  if (alone != (gone == 1)) return "can_weld is wrong";
  if (middle(*edge) != spot || !mesh_.is_block(*edge)) return "another edge";
  return compare(0, gone, oracle_.changed());
}

std::string TrackedMesh::refuse_refine(HalfEdge h, Precondition why) {
  const std::string before = dump(surface());
  made_.clear(), gone_.clear();
  const auto v = mesh_.refine(h, Observer{*this});
  if (v) return "not refused";
  if (v.error() != Violation{why, h.index()}) return "another reason: " + describe(v.error());
  if (!made_.empty() || !gone_.empty() || dump(surface()) != before) return "refused, but changed";
  return "";
}

std::string TrackedMesh::refuse_simplify(Vertex v, Precondition why) {
  const std::string before = dump(surface());
  made_.clear(), gone_.clear();
  const auto edge = mesh_.simplify(v, Observer{*this});
  if (edge) return "not refused";
  if (edge.error() != Violation{why, v.index()}) return "another reason: " + describe(edge.error());
  if (!made_.empty() || !gone_.empty() || dump(surface()) != before) return "refused, but changed";
  return "";
}

std::string TrackedMesh::simplify_all(std::uint32_t seed) {
  std::mt19937 random(seed);
  while (!label_of_.empty()) {
    // Whichever comes: low ids often are coarse and take much with them.
    Vertex v(static_cast<std::uint32_t>(random()) % surface().vertex_limit());
    if (!surface().is_live(v) || mesh_.level(v) == 0) {
      v = Vertex(label_of_.begin()->first);
    }
    if (const std::string wrong = simplify(v); !wrong.empty()) return wrong;
  }
  return dump(surface()) == base_dump_ ? "" : "not the base again\n" + dump(surface());
}

std::string TrackedMesh::check() const {
  if (const auto faults = validate(surface(), 1); !faults.empty())
    return "invalid: " + describe(faults[0]);
  std::vector<std::optional<Spot>> spot_of(surface().vertex_limit());
  std::set<Spot> spots;
  std::set<Label> labels;
  for (const Vertex v : surface().vertices()) {
    const Label label = labels_.of(mesh_, v);
    if (!labels.insert(label).second) return "two vertices of one label";
    const auto it = label_of_.find(v.index());
    if ((it == label_of_.end()) != (mesh_.level(v) == 0)) return "a base vertex made, or not";
    if (it != label_of_.end() && it->second != label) return "a label that changed";
    const At where = at(label);
    const Spot spot = oracle_.spot(where.base, where.place);
    if (!spots.insert(spot).second) return "two vertices at one place";
    const std::optional<unsigned> level = oracle_.level(spot);
    if (mesh_.level(v) != level.value_or(0)) return "a wrong level";
    if (label.level != mesh_.level(v)) return "a label of another level";
    if (!level && spot.kind != Spot::vertex) return "a vertex that is not there";
    spot_of[v.index()] = spot;
    if (mesh_.can_weld(v))
      for (const HalfEdge h : surface().fan(v))
        if (corner(h) != 0) return "a vertex to weld that is not the newest";
  }
  std::set<std::uint32_t> leaves;
  for (const Face f : surface().faces()) {
    unsigned finest = 0;
    std::array<At, 3> at;
    for (const HalfEdge h : surface().star(f)) {
      at[corner(h)] = corner_at(f, corner(h));
      finest = std::max(finest, mesh_.level(surface().org(h)));
      if (oracle_.spot(at[corner(h)].base, at[corner(h)].place) !=
          spot_of[surface().org(h).index()])
        return "a corner that is elsewhere";
      const Spot edge = middle(h);
      const HalfEdge twin = surface().sym(h);
      if (oracle_.sides(edge) != (twin ? 2u : 1u)) return "an edge that is not there";
      if (!twin) continue;
      if (middle(twin) != edge) return "neighbours that are none";
      if (std::abs(int(mesh_.level(f)) - int(mesh_.level(left(twin)))) > 1)
        return "neighbours more than a level apart";
    }
    if (mesh_.level(f) != finest) return "a weld vertex that is not the newest";
    std::uint32_t base = at[0].base;
    for (const At& p : at)
      if (p.place.x + p.place.y != Spot::unit) base = p.base;
    std::array<Place, 3> places;
    for (unsigned c = 0; c < 3; ++c)
      places[c] = at[c].base == base
                      ? at[c].place
                      : Place{Spot::unit - at[c].place.x, Spot::unit - at[c].place.y};
    const auto leaf = oracle_.leaf(base, places);
    if (!leaf) return "a face that is no leaf";
    if (!leaves.insert(*leaf).second) return "a leaf twice";
  }
  if (leaves.size() != oracle_.leaves()) return "leaves missing";
  return "";
}

}  // namespace clers::test
