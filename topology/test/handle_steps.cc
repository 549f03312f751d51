// Steps of create, destroy, glue and unglue, and of attach and detach, composed of them.
#include <optional>

#include "topology/derived.h"
#include "topology/dump.h"
#include "topology/test/pair.h"

namespace clers::test {

/// A second half-edge for glue: by its place relative to the first, so that every case comes up.
HalfEdge Pair::partner(const Op& op) {
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

std::string Pair::create(const Op& op) {
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

std::string Pair::destroy(const Op&) {
  const HalfEdge h = pick(true);
  const Face f = left(h);
  const bool alone = surface_.is_live(f) && surface_.is_boundary(half_edge(f, 0)) &&
                     surface_.is_boundary(half_edge(f, 1)) && surface_.is_boundary(half_edge(f, 2));
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

std::string Pair::glue(HalfEdge h0, HalfEdge h1) {
  const bool allowed = surface_.is_live(h0) && surface_.is_live(h1) && h0 != h1 &&
                       surface_.is_boundary(h0) && surface_.is_boundary(h1);
  const std::string text = thorough_ ? dump(surface_) : "";
  const std::optional<Surface> old = thorough_ ? std::optional(surface_) : std::nullopt;
  const Characteristic before = surface_.characteristic();
  const Result<HandleCase, Violation> kind = surface_.glue(h0, h1);
  if (kind.ok() != allowed) return "glue misjudged";
  if (!kind) return refuse(text);
  ++done_;
  ++glued_[static_cast<unsigned>(*kind)];
  oracle_.glue(h0.index(), h1.index());
  if (surface_.characteristic() != before + effect(*kind)) return "wrong effect of glue";
  if (old) {
    Surface undone = surface_;
    const Result<HandleCase, Violation> back = undone.unglue(h0);
    if (!back || *back != *kind) return "unglue does not name the glue it undoes";
    return compare(undone, *old, "unglue does not undo glue");
  }
  return "";
}

std::string Pair::unglue(HalfEdge h) {
  const bool allowed = surface_.is_live(h) && !surface_.is_boundary(h);
  const std::string text = thorough_ ? dump(surface_) : "";
  const std::optional<Surface> old = thorough_ ? std::optional(surface_) : std::nullopt;
  const Characteristic before = surface_.characteristic();
  const HalfEdge twin = allowed ? surface_.sym(h) : HalfEdge();
  const Result<HandleCase, Violation> kind = surface_.unglue(h);
  if (kind.ok() != allowed) return "unglue misjudged";
  if (!kind) return refuse(text);
  oracle_.unglue(h.index());
  ++done_;
  if (surface_.characteristic() != before - effect(*kind)) return "wrong effect of unglue";
  if (old) {
    Surface undone = surface_;
    const Result<HandleCase, Violation> back = undone.glue(h, twin);
    if (!back || *back != *kind) return "glue is not of the case that unglue named";
    if (std::string wrong = compare(undone, *old, "glue does not undo unglue"); !wrong.empty())
      return wrong;
    for (const Face f : undone.faces())
      for (const HalfEdge x : undone.star(f))
        if (undone.point(undone.org(x)) != old->point(old->org(x))) return "points were lost";
  }
  return "";
}

std::string Pair::attach(HalfEdge h, Point p) {
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

std::string Pair::detach(const Op& op) {
  const HalfEdge h = pick(op.choice % 2 == 0);
  const bool allowed = surface_.is_live(h);
  const std::string text = thorough_ ? dump(surface_) : "";
  const std::optional<Surface> old = thorough_ ? std::optional(surface_) : std::nullopt;
  const Characteristic before = surface_.characteristic();
  const auto done = clers::detach(surface_, h);
  if (done.ok() != allowed) return "detach misjudged";
  if (!done) return refuse(text);
  Characteristic after = before - effect_of_create;
  for (const Unglued& cut : done->unglued()) {
    oracle_.unglue(cut.h.index());
    after -= effect(cut.undone);
  }
  oracle_.destroy(left(h).index());
  done_ += 1 + done->unglued().size();
  if (surface_.characteristic() != after) return "wrong effect of detach";
  if (old) {
    Surface undone = surface_;
    const auto f = undone.create(done->points()[0], done->points()[1], done->points()[2]);
    if (!f || *f != left(h)) return "create does not undo destroy";
    for (std::size_t i = done->unglued().size(); i-- > 0;) {
      const Unglued& cut = done->unglued()[i];
      const Result<HandleCase, Violation> kind = undone.glue(cut.h, cut.twin);
      if (!kind || *kind != cut.undone) return "glue is not of the case that detach named";
    }
    return compare(undone, *old, "glues do not undo detach");
  }
  return "";
}

}  // namespace clers::test
