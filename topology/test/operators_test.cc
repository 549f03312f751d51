// Random sequences of operators, judged by the oracle.
//
// Short sequences: after every operator the oracle recounts everything, validate() is clean, what a
// refused operator left is what was there, and the operator's inverse gives back an equivalent
// surface. Handle and stellar operators are mixed. What is composed of stellar ones is also judged
// by what it should do to the triangles as triples of vertices. Long sequences: the oracle and
// validate() every so often, the Euler-Poincaré formula always.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <optional>
#include <set>

#include "topology/derived.h"
#include "topology/dump.h"
#include "topology/equivalence.h"
#include "topology/stellar.h"
#include "topology/test/oracle.h"
#include "topology/validate.h"

namespace clers {
namespace {

using test::Oracle;

/// One random step; what its numbers mean depends on the surface it meets.
struct Op {
  std::uint8_t kind = 0;
  std::uint8_t choice = 0;
  std::uint16_t a = 0, b = 0;
};

void showValue(const Op& op, std::ostream& os) {
  os << "{" << int{op.kind} << ", " << int{op.choice} << ", " << op.a << ", " << op.b << "}";
}

/// A surface and an oracle that live through the same operators.
class Pair {
 public:
  explicit Pair(bool thorough) : thorough_(thorough) {}

  const Surface& surface() const { return surface_; }
  const Oracle& oracle() const { return oracle_; }
  std::uint64_t glued(HandleCase kind) const { return glued_[static_cast<unsigned>(kind)]; }
  std::uint64_t split(StellarCase kind) const { return split_[static_cast<unsigned>(kind)]; }
  std::uint64_t welded(StellarCase kind) const { return welded_[static_cast<unsigned>(kind)]; }
  std::uint64_t composed(unsigned which) const { return composed_[which]; }
  std::uint64_t done() const { return done_; }
  std::uint64_t refused() const { return refused_; }

  /// Does the step; empty, or what went wrong.
  std::string step(const Op& op, std::uint32_t target_faces) {
    seed_ = (std::uint64_t{op.a} << 32) ^ (std::uint64_t{op.b} << 8) ^ op.choice;
    const bool crowded = surface_.characteristic().f > std::int64_t{target_faces};
    if (op.kind >= 100) return stellar(op, crowded);
    // kind: a percentage
    const unsigned kind = op.kind;
    if (kind < 10 && !crowded) return create(op);
    if (kind < 15) return destroy(op);
    if (kind < 50) {
      first_ = pick(true);
      return glue(first_, partner(op));
    }
    if (kind < 65) return unglue(pick(false));
    if (kind < 90 && !crowded) return attach(pick(true), Point(op.b));
    return detach(op);
  }

  std::string stellar(const Op& op, bool crowded) {
    const unsigned kind = (op.kind - 100u) % 78;  // in 78 parts, 255 - 100 being 155
    if (kind < 18) return flip(pick(false));
    if (kind < 30 && !crowded) return split_edge(pick(op.choice % 3 == 0), Point(op.b));
    if (kind < 38 && !crowded) return split_face(left(pick(op.choice % 2 == 0)), Point(op.b));
    if (kind < 56) return weld(op);
    if (kind < 64) return remove(op);
    if (kind < 72) return collapse(pick(op.choice % 3 == 0));
    if (!crowded) return split_vertex(op);
    return collapse(pick(op.choice % 3 == 0));
  }

  std::string check() const {
    if (std::string difference = oracle_.compare(surface_); !difference.empty()) return difference;
    const std::vector<Fault> faults = validate(surface_);
    return faults.empty() ? "" : describe(faults[0]);
  }

 private:
  using Handled = Result<HandleCase, Violation>;

  std::uint32_t random(std::uint32_t n) {
    seed_ = seed_ * 6364136223846793005u + 1442695040888963407u;
    return n == 0 ? 0 : static_cast<std::uint32_t>((seed_ >> 33) % n);
  }

  /// Mostly a live half-edge on the boundary or inside; now and then any number at all.
  HalfEdge pick(bool boundary) {
    HalfEdge h;
    for (int tries = 0; tries < 12; ++tries) {
      h = HalfEdge(random(surface_.half_edge_limit() + 2));
      if (surface_.is_live(h) && surface_.is_boundary(h) == boundary) {
        return h;
      }
    }
    return h;
  }

  /// A second half-edge for glue: by its place relative to the first, so that every case comes up.
  HalfEdge partner(const Op& op) {
    const HalfEdge h = pick(true);
    if (!surface_.is_live(first_) || !surface_.is_boundary(first_)) return h;
    switch (op.choice % 8) {
      case 0: return surface_.boundary_next(first_);
      case 1: return surface_.boundary_prev(first_);
      case 2: {
        HalfEdge x = first_;
        for (std::uint32_t i = random(5) + 2; i > 0; --i) x = surface_.boundary_next(x);
        return x;
      }
      case 3: {  // a curve of one edge, if there is one near
        for (int i = 0; i < 8; ++i)
          if (const HalfEdge x = pick(true);
              surface_.is_live(x) && surface_.is_boundary(x) && surface_.boundary_next(x) == x)
            return x;
        return h;
      }
      default: return h;
    }
  }

  std::string refuse(const std::string& before) {
    ++refused_;
    if (thorough_ && dump(surface_) != before) return "a refused operator changed the surface";
    return "";
  }

  std::string create(const Op& op) {
    const Characteristic before = surface_.characteristic();
    const auto f = surface_.create(Point(op.a), Point(op.b), Point(op.a));
    if (!f) return "create was refused";
    oracle_.create(f->index());
    ++done_;
    if (surface_.characteristic() != before + effect_of_create) return "wrong effect of create";
    if (thorough_) {
      Surface undone = surface_;
      const auto points = undone.destroy(*f);
      if (!points || (*points)[1] != Point(op.b) || undone.characteristic() != before)
        return "destroy does not undo create";
    }
    return "";
  }

  std::string destroy(const Op&) {
    const HalfEdge h = pick(true);
    const Face f = left(h);
    const bool alone = surface_.is_live(f) && surface_.is_boundary(half_edge(f, 0)) &&
                       surface_.is_boundary(half_edge(f, 1)) &&
                       surface_.is_boundary(half_edge(f, 2));
    const std::string before = thorough_ ? dump(surface_) : "";
    const auto points = surface_.destroy(f);
    if (points.ok() != alone) return "destroy of " + std::to_string(f.index()) + " misjudged";
    if (!points) return refuse(before);
    oracle_.destroy(f.index());
    ++done_;
    if (thorough_) {
      Surface undone = surface_;
      const auto again = undone.create((*points)[0], (*points)[1], (*points)[2]);
      if (!again || *again != f) return "create does not undo destroy";
      for (unsigned i = 0; i < 3; ++i)
        if (undone.point(undone.org(half_edge(f, i))) != (*points)[i]) return "points were lost";
    }
    return "";
  }

  std::string glue(HalfEdge h0, HalfEdge h1) {
    const bool allowed = surface_.is_live(h0) && surface_.is_live(h1) && h0 != h1 &&
                         surface_.is_boundary(h0) && surface_.is_boundary(h1);
    const std::string text = thorough_ ? dump(surface_) : "";
    const std::optional<Surface> old = thorough_ ? std::optional(surface_) : std::nullopt;
    const Characteristic before = surface_.characteristic();
    const Handled kind = surface_.glue(h0, h1);
    if (kind.ok() != allowed) return "glue misjudged";
    if (!kind) return refuse(text);
    ++done_;
    ++glued_[static_cast<unsigned>(*kind)];
    oracle_.glue(h0.index(), h1.index());
    if (surface_.characteristic() != before + effect(*kind)) return "wrong effect of glue";
    if (old) {
      Surface undone = surface_;
      const Handled back = undone.unglue(h0);
      if (!back || *back != *kind) return "unglue does not name the glue it undoes";
      return compare(undone, *old, "unglue does not undo glue");
    }
    return "";
  }

  std::string unglue(HalfEdge h) {
    const bool allowed = surface_.is_live(h) && !surface_.is_boundary(h);
    const std::string text = thorough_ ? dump(surface_) : "";
    const std::optional<Surface> old = thorough_ ? std::optional(surface_) : std::nullopt;
    const Characteristic before = surface_.characteristic();
    const HalfEdge twin = allowed ? surface_.sym(h) : HalfEdge();
    const Handled kind = surface_.unglue(h);
    if (kind.ok() != allowed) return "unglue misjudged";
    if (!kind) return refuse(text);
    oracle_.unglue(h.index());
    ++done_;
    if (surface_.characteristic() != before - effect(*kind)) return "wrong effect of unglue";
    if (old) {
      Surface undone = surface_;
      const Handled back = undone.glue(h, twin);
      if (!back || *back != *kind) return "glue is not of the case that unglue named";
      if (std::string wrong = compare(undone, *old, "glue does not undo unglue"); !wrong.empty())
        return wrong;
      for (const Face f : undone.faces())
        for (const HalfEdge x : undone.star(f))
          if (undone.point(undone.org(x)) != old->point(old->org(x))) return "points were lost";
    }
    return "";
  }

  std::string attach(HalfEdge h, Point p) {
    const bool allowed = surface_.is_live(h) && surface_.is_boundary(h);
    const std::string text = thorough_ ? dump(surface_) : "";
    const std::optional<Surface> old = thorough_ ? std::optional(surface_) : std::nullopt;
    const Vertex org = allowed ? surface_.org(h) : Vertex();
    const auto f = clers::attach(surface_, h, p);
    if (f.ok() != allowed) return "attach misjudged";
    if (!f) return refuse(text);
    oracle_.create(f->index());
    oracle_.glue(h.index(), 3 * f->index());
    done_ += 2;
    if (surface_.org(h) != org) return "attach renamed a vertex of the gate";
    if (surface_.point(surface_.org(half_edge(*f, 2))) != p) return "the apex is on another point";
    if (old) {
      Surface undone = surface_;
      if (!clers::detach(undone, half_edge(*f, 1))) return "detach was refused";
      return compare(undone, *old, "detach does not undo attach");
    }
    return "";
  }

  std::string detach(const Op& op) {
    const HalfEdge h = pick(op.choice % 2 == 0);
    const bool allowed = surface_.is_live(h);
    const std::string text = thorough_ ? dump(surface_) : "";
    const std::optional<Surface> old = thorough_ ? std::optional(surface_) : std::nullopt;
    const Characteristic before = surface_.characteristic();
    const auto done = clers::detach(surface_, h);
    if (done.ok() != allowed) return "detach misjudged";
    if (!done) return refuse(text);
    Characteristic after = before - effect_of_create;
    for (const Cut& cut : done->cuts()) {
      oracle_.unglue(cut.h.index());
      after -= effect(cut.undone);
    }
    oracle_.destroy(left(h).index());
    done_ += 1 + done->cuts().size();
    if (surface_.characteristic() != after) return "wrong effect of detach";
    if (old) {
      Surface undone = surface_;
      const auto f = undone.create(done->points()[0], done->points()[1], done->points()[2]);
      if (!f || *f != left(h)) return "create does not undo destroy";
      for (std::size_t i = done->cuts().size(); i-- > 0;) {
        const Cut& cut = done->cuts()[i];
        const Handled kind = undone.glue(cut.h, cut.twin);
        if (!kind || *kind != cut.undone) return "glue is not of the case that detach named";
      }
      return compare(undone, *old, "glues do not undo detach");
    }
    return "";
  }

  // Stellar operators ---------------------------------------------------------------------------

  /// As many of some kind, half-edge by half-edge: not only equivalent, but of the same ids.
  static bool identical(const Surface& a, const Surface& b) {
    const std::uint32_t n = std::max(a.half_edge_limit(), b.half_edge_limit());
    for (std::uint32_t i = 0; i < n; ++i) {
      const HalfEdge h(i);
      if (a.is_live(h) != b.is_live(h)) return false;
      if (a.is_live(h) && (a.org(h) != b.org(h) || a.sym(h) != b.sym(h))) return false;
    }
    for (const Vertex v : a.vertices())
      if (a.point(v) != b.point(v)) return false;
    return true;
  }

  std::string flip(HalfEdge h) {
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
      if (auto wrong = compare(undone, *old, "flip does not undo flip"); !wrong.empty())
        return wrong;
      for (int i = 0; i < 2; ++i) (void)undone.flip(h);
      if (!identical(undone, *old)) return "four flips change something";
      return validate(undone).empty() ? "" : "four flips leave faults";
    }
    return "";
  }

  /// Welds what a split made, splits it again, and compares.
  std::string unsplit(const Surface& old, Vertex v, StellarCase kind, bool exact) {
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

  std::string split_edge(HalfEdge h, Point p) {
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

  std::string split_face(Face f, Point p) {
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
  HalfEdge pick_weldable() {
    HalfEdge h;
    for (int tries = 0; tries < 20; ++tries) {
      h = HalfEdge(random(surface_.half_edge_limit() + 2));
      if (!surface_.is_live(h)) continue;
      const std::uint32_t degree = surface_.degree(surface_.org(h));
      if (degree == 3 || degree == 4) return h;
    }
    return h;
  }

  bool simple_star(Vertex v) const {
    std::set<Face> faces;
    for (const HalfEdge h : surface_.fan(v)) faces.insert(left(h));
    return faces.size() == surface_.corner_count(v);
  }

  std::string weld(const Op& op) {
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

  // Composed: judged by the triangles, as triples of vertices, the least of three rotations.
  using Triple = std::array<Vertex, 3>;
  using Triples = std::multiset<Triple>;
  static Triple least(Triple t) {
    const Triple once{t[1], t[2], t[0]}, twice{t[2], t[0], t[1]};
    return std::min({t, once, twice});
  }
  template <class Rename>
  static Triples triples(const Surface& s, Rename rename) {
    Triples out;
    for (const Face f : s.faces()) {
      Triple t;
      for (unsigned i = 0; i < 3; ++i) t[i] = rename(s.org(half_edge(f, i)));
      out.insert(least(t));
    }
    return out;
  }
  static Triples triples(const Surface& s) {
    return triples(s, [](Vertex v) { return v; });
  }
  static void erase(Triples& from, const Triple& t) {
    if (const auto at = from.find(least(t)); at != from.end()) from.erase(at);
  }

  /// By sets of vertices, the boundary being one more: no other way to say what cannot be undone.
  bool may_collapse(HalfEdge h) const {
    const Surface& s = surface_;
    const Vertex u = s.org(h), w = s.dest(h), beyond;
    if (u == w) return false;
    const auto link = [&](Vertex v) {
      std::multiset<Vertex> out;
      for (const HalfEdge x : s.star(v)) out.insert(s.org(x) == v ? s.dest(x) : s.org(x));
      if (s.is_boundary(v)) out.insert(beyond);
      return out;
    };
    const std::multiset<Vertex> link_u = link(u), link_w = link(w);
    std::multiset<Vertex> link_edge{s.org(lprev(h)), s.sym(h) ? s.org(lprev(s.sym(h))) : beyond};
    if (*link_edge.begin() == *link_edge.rbegin()) return false;
    if (link_u.count(u) != 0 || link_u.count(w) != 1) return false;
    for (const Vertex x : link_u) {
      if (x == w || link_w.count(x) == 0) continue;  // a loop of w may stay
      if (link_edge.count(x) == 0) return false;
      if (x != beyond && link_u.count(x) * link_w.count(x) > 1) return false;
    }
    // A common edge of the links: one face beyond, or the boundary.
    for (const HalfEdge rim : s.link(u))
      if (s.sym(rim) && s.org(lprev(s.sym(rim))) == w) return false;
    return s.sym(h) || !s.is_boundary(lnext(h)) || !s.is_boundary(lprev(h));
  }

  std::string collapse(HalfEdge h) {
    const bool allowed = surface_.is_live(h) && may_collapse(h);
    const std::string text = thorough_ ? dump(surface_) : "";
    const Characteristic before = surface_.characteristic();
    Vertex u, w;
    bool boundary = false;
    Triples expected;
    if (allowed) {
      boundary = surface_.is_boundary(h);
      u = surface_.org(h), w = surface_.dest(h);
      if (surface_.is_boundary(u) && !surface_.is_boundary(w)) std::swap(u, w);
      if (thorough_) {
        expected = triples(surface_, [&](Vertex v) { return v == u ? w : v; });
        for (const HalfEdge x : surface_.star(h)) erase(expected, {w, w, surface_.org(lprev(x))});
      }
    }
    const auto kept = clers::collapse(surface_, h);
    if (kept.ok() != allowed) return "collapse of " + std::to_string(h.index()) + " misjudged";
    if (!kept) return refuse(text);
    ++done_, ++composed_[0];
    oracle_.adopt(surface_);
    if (*kept != w || surface_.is_live(u)) return "collapse kept the wrong vertex";
    const auto kind = boundary ? StellarCase::boundary_edge : StellarCase::interior_edge;
    if (surface_.characteristic() != before - effect(kind)) return "wrong effect of collapse";
    if (thorough_ && triples(surface_) != expected) return "collapse made other triangles";
    return "";
  }

  std::string split_vertex(const Op& op) {
    const HalfEdge from = pick(op.choice % 3 == 0);
    HalfEdge to;
    if (surface_.is_live(from) && op.choice % 4 != 0) {
      to = from;
      for (std::uint32_t i = random(4) + 1; i > 0 && to; --i) to = surface_.sym(lprev(to));
    }
    if (op.choice % 16 == 1) to = pick(false);
    bool allowed = surface_.is_live(from) && (!to || surface_.is_live(to)) && from != to;
    std::set<Face> given;
    if (allowed) {
      allowed = simple_star(surface_.org(from));
      HalfEdge h = from;
      do {
        given.insert(left(h));
        h = surface_.sym(lprev(h));
      } while (h && h != to && h != from);
      allowed = allowed && h == to;
    }
    const std::string text = thorough_ ? dump(surface_) : "";
    const Characteristic before = surface_.characteristic();
    const std::optional<Surface> old = thorough_ ? std::optional(surface_) : std::nullopt;
    const auto edge = clers::split_vertex(surface_, from, to, Point(op.b));
    if (edge.ok() != allowed) return "split_vertex misjudged";
    if (!edge) return refuse(text);
    ++done_, ++composed_[1];
    oracle_.adopt(surface_);
    const auto kind = to ? StellarCase::interior_edge : StellarCase::boundary_edge;
    if (surface_.characteristic() != before + effect(kind)) return "wrong effect of split_vertex";
    if (old) {
      const Vertex u = surface_.org(*edge), w = surface_.dest(*edge);
      if (u == w || old->is_live(u) != false || surface_.point(u) != Point(op.b))
        return "split_vertex made another vertex";
      Triples expected;
      for (const Face f : old->faces()) {
        Triple t;
        for (unsigned i = 0; i < 3; ++i) {
          t[i] = old->org(half_edge(f, i));
          if (t[i] == w && given.count(f) != 0) t[i] = u;
        }
        expected.insert(least(t));
      }
      Triples made = triples(surface_);
      for (const HalfEdge x : surface_.star(*edge))
        erase(made, {surface_.org(x), surface_.dest(x), surface_.org(lprev(x))});
      if (made != expected) return "split_vertex made other triangles";
      Surface undone = surface_;
      if (const auto kept = clers::collapse(undone, *edge)) {
        if (*kept != w) return "collapse kept the wrong vertex";
        if (triples(undone) != triples(*old)) return "collapse does not undo split_vertex";
        return compare(undone, *old, "collapse does not undo split_vertex");
      }
    }
    return "";
  }

  std::string remove(const Op& op) {
    const HalfEdge h = pick(op.choice % 3 == 0);
    const bool live = surface_.is_live(h);
    const Vertex v = live ? surface_.org(h) : Vertex(surface_.vertex_limit() + 1);
    const std::uint32_t degree = op.choice % 5 == 0 ? op.choice % 7 : 3 + op.choice % 2;
    const bool boundary = live && surface_.is_boundary(v);
    const bool allowed = live && simple_star(v) && (degree == 3 || (degree == 4 && !boundary)) &&
                         surface_.degree(v) >= degree;
    const std::string text = thorough_ ? dump(surface_) : "";
    const Characteristic before = surface_.characteristic();
    Triples kept;
    if (thorough_) kept = triples(surface_);
    if (thorough_ && live)
      for (const HalfEdge x : surface_.fan(v))
        erase(kept, {surface_.org(x), surface_.dest(x), surface_.org(lprev(x))});
    const auto price = [&](const Surface& s, HalfEdge x) {
      return (s.dest(x).index() * 2654435761u) ^ op.b;
    };
    const auto done = op.choice % 2 == 0 ? clers::remove(surface_, v, degree)
                                         : clers::remove(surface_, v, degree, price);
    if (done.ok() != allowed) return "remove misjudged";
    if (!done) return refuse(text);
    ++done_, ++composed_[2];
    oracle_.adopt(surface_);
    if (surface_.characteristic() != before - effect(done->undone)) return "wrong effect of remove";
    if (surface_.is_live(v)) return "the removed vertex is alive";
    if (!thorough_) return "";
    const Triples now = triples(surface_);
    if (!std::includes(now.begin(), now.end(), kept.begin(), kept.end()))
      return "remove changed triangles elsewhere";
    return "";
  }

  static std::string compare(const Surface& a, const Surface& b, const char* wrong) {
    const auto map = equivalent(a, b);
    if (!map) return wrong;
    for (const Face f : a.faces())
      for (const HalfEdge h : a.star(f)) {
        const HalfEdge image = map->half_edges[h.index()];
        if (map->vertices[a.org(h).index()] != b.org(image)) return "bad correspondence";
        if (lnext(image) != map->half_edges[lnext(h).index()]) return "bad correspondence";
      }
    return validate(a).empty() ? "" : "an undone operator leaves faults";
  }

  Surface surface_;
  Oracle oracle_;
  bool thorough_;
  std::uint64_t seed_ = 0;
  HalfEdge first_;  // that of the glue under way
  std::uint64_t glued_[handle_case_count] = {};
  std::uint64_t split_[stellar_case_count] = {}, welded_[stellar_case_count] = {};
  std::uint64_t composed_[4] = {};        // collapse, split_vertex, remove, flip
  std::uint64_t done_ = 0, refused_ = 0;  // counting the parts of attach and detach
};

}  // namespace
}  // namespace clers

namespace rc {
template <>
struct Arbitrary<clers::Op> {
  static Gen<clers::Op> arbitrary() {
    return gen::build<clers::Op>(gen::set(&clers::Op::kind), gen::set(&clers::Op::choice),
                                 gen::set(&clers::Op::a), gen::set(&clers::Op::b));
  }
};
}  // namespace rc

namespace clers {
namespace {

/// The same cases in every run, unless RC_PARAMS says otherwise; CLERS_LONG multiplies their
/// number.
const bool params_set = [] {
  const char* factor = std::getenv("CLERS_LONG");
  const int cases = 100 * (factor ? std::max(1, std::atoi(factor)) : 1);
  setenv("RC_PARAMS", ("seed=2010 max_success=" + std::to_string(cases)).c_str(), 0);
  return true;
}();

/// Runs the steps and checks after every `stride`-th, and at the end.
void run(Pair& pair, const std::vector<Op>& ops, std::uint32_t target_faces, std::size_t stride) {
  const auto fail = [&](std::size_t i, const std::string& wrong) {
    RC_FAIL(wrong + " (step " + std::to_string(i) + ")\n" + dump(pair.surface()) +
            dump_code(pair.surface()));
  };
  for (std::size_t i = 0; i < ops.size(); ++i) {
    if (const std::string wrong = pair.step(ops[i], target_faces); !wrong.empty()) fail(i, wrong);
    if (!pair.surface().characteristic().is_valid()) fail(i, "the formula does not hold");
    if ((i + 1) % stride == 0 || i + 1 == ops.size())
      if (const std::string wrong = pair.check(); !wrong.empty()) fail(i, wrong);
  }
}

/// Up to `length` steps; failing sequences shrink by leaving steps out.
std::vector<Op> sequence(int length) {
  return *rc::gen::resize(
      length, rc::gen::container<std::vector<Op>>(rc::gen::resize(200, rc::gen::arbitrary<Op>())));
}

/// What all the cases of a property did together.
struct Tally {
  std::uint64_t done = 0, refused = 0, kinds[handle_case_count] = {};
  std::uint64_t splits[stellar_case_count] = {}, welds[stellar_case_count] = {}, composed[4] = {};

  void add(const Pair& pair) {
    done += pair.done();
    refused += pair.refused();
    for (unsigned i = 0; i < handle_case_count; ++i) kinds[i] += pair.glued(HandleCase(i));
    for (unsigned i = 0; i < stellar_case_count; ++i) {
      splits[i] += pair.split(StellarCase(i));
      welds[i] += pair.welded(StellarCase(i));
    }
    for (unsigned i = 0; i < 4; ++i) composed[i] += pair.composed(i);
  }

  void expect_all_cases() const {
    const auto expect = [](const std::string& what, std::uint64_t count) {
      std::printf("%-26s %llu\n", what.c_str(), static_cast<unsigned long long>(count));
      EXPECT_GT(count, 0u) << what << " never happened";
    };
    for (unsigned i = 0; i < handle_case_count; ++i) expect(name(HandleCase(i)), kinds[i]);
    for (unsigned i = 0; i < stellar_case_count; ++i) {
      expect(std::string("split ") + name(StellarCase(i)), splits[i]);
      expect(std::string("weld ") + name(StellarCase(i)), welds[i]);
    }
    expect("collapse", composed[0]);
    expect("split_vertex", composed[1]);
    expect("remove", composed[2]);
    expect("flip", composed[3]);
    std::printf("operators done %llu, refused %llu\n", static_cast<unsigned long long>(done),
                static_cast<unsigned long long>(refused));
    EXPECT_GT(refused, 0u);
  }
};

/// Many steps on surfaces that stay small: every one is checked and undone.
void thorough(std::uint32_t target_faces, int length) {
  Tally tally;
  EXPECT_TRUE(rc::check([&] {
    const auto ops = sequence(length);
    Pair pair(true);
    run(pair, ops, target_faces, 1);
    tally.add(pair);
  }));
  tally.expect_all_cases();
}

TEST(Operators, EveryStepOnUpTo4Faces) {
  thorough(4, 300);
}
TEST(Operators, EveryStepOnUpTo12Faces) {
  thorough(12, 400);
}
TEST(Operators, EveryStepOnUpTo40Faces) {
  thorough(40, 200);
}

TEST(Operators, AMillionSteps) {
  Tally tally;
  EXPECT_TRUE(rc::check([&] {
    const auto target = *rc::gen::element<std::uint32_t>(20, 60, 200, 1000, 4000);
    const auto ops = sequence(30'000);
    Pair pair(false);
    run(pair, ops, target, 1000);
    tally.add(pair);
  }));
  tally.expect_all_cases();
  EXPECT_GE(tally.done, 1'000'000u);
}

}  // namespace
}  // namespace clers
