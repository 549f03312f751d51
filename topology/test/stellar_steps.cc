// Steps of flip, split and weld.
#include <optional>

#include "topology/dump.h"
#include "topology/test/pair.h"
#include "topology/validate.h"

namespace clers::test {

std::string Pair::flip(HalfEdge h) {
  const bool allowed =
      surface_.is_live(h) && !surface_.is_boundary(h) && left(surface_.sym(h)) != left(h);
  const std::string text = thorough_ ? dump(surface_) : "";
  const std::optional<Surface> old = thorough_ ? std::optional(surface_) : std::nullopt;
  const auto done = surface_.flip(h);
  if (done.ok() != allowed) return "flip misjudged";
  if (!done) return refuse(text);
  oracle_.flip(h.index());
  ++done_, ++composed_[3];
  if (old) {
    if (surface_.characteristic() != old->characteristic()) return "flip changes counts";
    Surface undone = surface_;
    (void)undone.flip(h);
    if (undone.org(h) != old->dest(h)) return "two flips do not turn the edge round";
    if (auto wrong = compare(undone, *old, "flip does not undo flip"); !wrong.empty()) return wrong;
    for (int i = 0; i < 2; ++i) (void)undone.flip(h);
    if (!identical(undone, *old)) return "four flips change something";
    return validate(undone).empty() ? "" : "four flips leave faults";
  }
  return "";
}

/// Welds what a split made, splits it again, and compares.
std::string Pair::unsplit(const Surface& old, Vertex v, StellarCase kind, bool exact) {
  Surface undone = surface_;
  const auto welded = undone.weld(v);
  if (!welded || welded->undone != kind || welded->point != surface_.point(v))
    return "weld does not name the split it undoes";
  if (exact && !identical(undone, old)) return "weld does not give back every id";
  if (auto wrong = compare(undone, old, "weld does not undo split"); !wrong.empty()) return wrong;
  const auto again = kind == StellarCase::face ? undone.split(left(welded->at), welded->point)
                                               : undone.split(welded->at, welded->point);
  if (!again || *again != v) return "the same split does not make the same vertex";
  if (exact && !identical(undone, surface_)) return "split does not undo weld";
  return compare(undone, surface_, "split does not undo weld");
}

std::string Pair::split_edge(HalfEdge h, Point p) {
  const HalfEdge t = surface_.is_live(h) ? surface_.sym(h) : HalfEdge();
  const bool allowed = surface_.is_live(h) && (!t || left(t) != left(h));
  const std::string text = thorough_ ? dump(surface_) : "";
  const std::optional<Surface> old = thorough_ ? std::optional(surface_) : std::nullopt;
  const Characteristic before = surface_.characteristic();
  const Vertex a = allowed ? surface_.org(h) : Vertex();
  const auto v = surface_.split(h, p);
  if (v.ok() != allowed) return "split of an edge misjudged";
  if (!v) return refuse(text);
  const StellarCase kind = t ? StellarCase::interior_edge : StellarCase::boundary_edge;
  ++done_, ++split_[static_cast<unsigned>(kind)];
  const HalfEdge new_f = surface_.sym(half_edge(left(h), 0));
  const HalfEdge new_g = t ? surface_.sym(half_edge(left(t), 0)) : HalfEdge();
  oracle_.split_edge(h.index(), left(new_f).index(), t ? left(new_g).index() : 0);
  if (surface_.characteristic() != before + effect(kind)) return "wrong effect of split";
  if (surface_.point(*v) != p) return "the new vertex is on another point";
  for (const HalfEdge x : surface_.fan(*v))
    if (corner(x) != 0) return "the new vertex is not corner 0";
  if (t && surface_.dest(surface_.star_half_edge(*v)) != a) return "the star leads elsewhere";
  const bool exact = corner(h) == 1 && (!t || corner(t) == 1);
  return old ? unsplit(*old, *v, kind, exact) : "";
}

std::string Pair::split_face(Face f, Point p) {
  const bool allowed = surface_.is_live(f);
  const std::string text = thorough_ ? dump(surface_) : "";
  const std::optional<Surface> old = thorough_ ? std::optional(surface_) : std::nullopt;
  const Characteristic before = surface_.characteristic();
  const auto v = surface_.split(f, p);
  if (v.ok() != allowed) return "split of a face misjudged";
  if (!v) return refuse(text);
  ++done_, ++split_[static_cast<unsigned>(StellarCase::face)];
  const Face b = left(surface_.sym(half_edge(f, 2))), c = left(surface_.sym(half_edge(f, 0)));
  oracle_.split_face(f.index(), b.index(), c.index());
  if (surface_.characteristic() != before + effect(StellarCase::face))
    return "wrong effect of split";
  if (surface_.point(*v) != p) return "the new vertex is on another point";
  return old ? unsplit(*old, *v, StellarCase::face, true) : "";
}

/// A half-edge that leaves a vertex of few edges, if there is one near.
HalfEdge Pair::pick_weldable() {
  HalfEdge h;
  for (int tries = 0; tries < 20; ++tries) {
    h = HalfEdge(random(surface_.half_edge_limit() + 2));
    if (!surface_.is_live(h)) continue;
    const std::uint32_t degree = surface_.degree(surface_.org(h));
    if (degree == 3 || degree == 4) return h;
  }
  return h;
}

std::string Pair::weld(const Op& op) {
  HalfEdge h = pick_weldable();
  const bool live = surface_.is_live(h);
  const Vertex v = live ? surface_.org(h) : Vertex();
  if (live && op.choice % 2 == 0) h = surface_.star_half_edge(v);
  const std::uint32_t degree = live ? surface_.degree(v) : 0;
  const bool boundary = live && surface_.is_boundary(v);
  const bool allowed = (degree == 3 || (degree == 4 && !boundary)) && simple_star(v);
  const std::string text = thorough_ ? dump(surface_) : "";
  const std::optional<Surface> old = thorough_ ? std::optional(surface_) : std::nullopt;
  const Characteristic before = surface_.characteristic();
  const Vertex a = live ? surface_.dest(h) : Vertex();
  const auto done = surface_.weld(h);
  if (done.ok() != allowed) return "weld misjudged";
  if (!done) return refuse(text);
  const StellarCase kind = boundary      ? StellarCase::boundary_edge
                           : degree == 4 ? StellarCase::interior_edge
                                         : StellarCase::face;
  if (done->undone != kind) return "weld took another case";
  ++done_, ++welded_[static_cast<unsigned>(kind)];
  oracle_.weld(h.index());
  if (surface_.characteristic() != before - effect(kind)) return "wrong effect of weld";
  if (!boundary && surface_.org(done->at) != a) return "the edge begins elsewhere";
  if (old) {
    if (surface_.is_live(v)) return "the welded vertex is alive";
    Surface undone = surface_;
    const auto again = kind == StellarCase::face ? undone.split(left(done->at), done->point)
                                                 : undone.split(done->at, done->point);
    if (!again || *again != v) return "split does not give the vertex back";
    if (undone.point(v) != old->point(v)) return "the point was lost";
    return compare(undone, *old, "split does not undo weld");
  }
  return "";
}

std::string Pair::turn(Face f) {
  const bool allowed = surface_.is_live(f);
  const std::string text = thorough_ ? dump(surface_) : "";
  const Characteristic before = surface_.characteristic();
  const Vertex a = allowed ? surface_.org(half_edge(f, 0)) : Vertex();
  const auto done = surface_.turn(f);
  if (done.ok() != allowed) return "turn misjudged";
  if (!done) return refuse(text);
  oracle_.turn(f.index());
  ++done_;
  if (surface_.characteristic() != before) return "turn changes counts";
  if (surface_.org(half_edge(f, 1)) != a) return "corner 0 is not corner 1 now";
  if (!thorough_) return "";
  Surface undone = surface_;
  for (int i = 0; i < 2; ++i) (void)undone.turn(f);
  return dump(undone) == text ? "" : "three turns change something";
}

std::string Pair::begin_star(HalfEdge h) {
  const bool allowed = surface_.is_live(h) && !surface_.is_boundary(surface_.org(h));
  const std::string text = thorough_ ? dump(surface_) : "";
  const HalfEdge was = surface_.is_live(h) ? surface_.star_half_edge(surface_.org(h)) : h;
  const auto done = surface_.begin_star(h);
  if (done.ok() != allowed) return "begin_star misjudged";
  if (!done) return refuse(text);
  ++done_;
  if (*surface_.fan(surface_.org(h)).begin() != h) return "the star begins elsewhere";
  if (!thorough_) return "";
  Surface undone = surface_;
  (void)undone.begin_star(was);
  return dump(undone) == text ? "" : "begin_star does not undo begin_star";
}

}  // namespace clers::test
