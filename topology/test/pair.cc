#include "topology/test/pair.h"

#include <algorithm>
#include <ostream>
#include <set>
#include <vector>

#include "topology/dump.h"
#include "topology/equivalence.h"
#include "topology/validate.h"

namespace clers::test {

void showValue(const Op& op, std::ostream& os) {
  os << "{" << int{op.kind} << ", " << int{op.choice} << ", " << op.a << ", " << op.b << "}";
}

std::string Pair::step(const Op& op, std::uint32_t target_faces) {
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

std::string Pair::stellar(const Op& op, bool crowded) {
  const unsigned kind = (op.kind - 100u) % 78;  // in 78 parts, 255 - 100 being 155
  if (kind < 15) return flip(pick(false));
  if (kind == 15) return turn(left(pick(op.choice % 2 == 0)));
  if (kind < 18) return begin_star(pick(false));
  if (kind < 30 && !crowded) return split_edge(pick(op.choice % 3 == 0), Point(op.b));
  if (kind < 38 && !crowded) return split_face(left(pick(op.choice % 2 == 0)), Point(op.b));
  if (kind < 56) return weld(op);
  if (kind < 64) return remove(op);
  if (kind < 72) return collapse(pick(op.choice % 3 == 0));
  if (!crowded) return split_vertex(op);
  return collapse(pick(op.choice % 3 == 0));
}

std::string Pair::check() const {
  if (std::string difference = oracle_.compare(surface_); !difference.empty()) return difference;
  const std::vector<Fault> faults = validate(surface_);
  return faults.empty() ? "" : describe(faults[0]);
}

std::uint32_t Pair::random(std::uint32_t n) {
  seed_ = seed_ * 6364136223846793005u + 1442695040888963407u;
  return n == 0 ? 0 : static_cast<std::uint32_t>((seed_ >> 33) % n);
}

HalfEdge Pair::pick(bool boundary) {
  HalfEdge h;
  for (int tries = 0; tries < 12; ++tries) {
    h = HalfEdge(random(surface_.half_edge_limit() + 2));
    if (surface_.is_live(h) && surface_.is_boundary(h) == boundary) {
      return h;
    }
  }
  return h;
}

bool Pair::simple_star(Vertex v) const {
  std::set<Face> faces;
  for (const HalfEdge h : surface_.fan(v)) faces.insert(left(h));
  return faces.size() == surface_.corner_count(v);
}

std::string Pair::refuse(const std::string& before) {
  ++refused_;
  if (thorough_ && dump(surface_) != before) return "a refused operator changed the surface";
  return "";
}

bool Pair::identical(const Surface& a, const Surface& b) {
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

std::string Pair::compare(const Surface& a, const Surface& b, const char* wrong) {
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

}  // namespace clers::test
