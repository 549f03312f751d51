// What must always hold of a surface, walked on raw arrays.
#include "topology/validate.h"

namespace CLERS_VISIBLE clers {

using internal::IdPool;
using internal::RingNode;
using internal::Rings;

/// The checks go in stages: each may follow the references that those before it have found good.
class Validator {
 public:
  Validator(const Surface& surface, std::size_t limit) : s_(surface), limit_(limit) {}

  std::vector<Fault> run() {
    void (Validator::*const stages[])() = {
        &Validator::sizes, &Validator::pools,       &Validator::half_edges, &Validator::vertices,
        &Validator::rings, &Validator::ring_orders, &Validator::components,
    };
    for (const auto stage : stages) {
      (this->*stage)();
      if (!faults_.empty()) break;
    }
    return std::move(faults_);
  }

 private:
  void expect(bool holds, Invariant i, std::size_t element) {
    if (!holds && faults_.size() < limit_)
      faults_.push_back({i, static_cast<std::uint32_t>(element)});
  }

  void sizes() {
    const std::size_t faces = s_.faces_.size(), vertices = s_.vertices_.size();
    const auto is = [&](std::size_t size, std::size_t expected) {
      expect(size == expected, Invariant::array_sizes, size);
    };
    is(s_.org_.size(), 3 * faces);
    is(s_.twin_.size(), 3 * faces);
    is(s_.component_.size(), faces);
    is(s_.star_.size(), vertices);
    is(s_.corners_.size(), vertices);
    is(s_.point_.size(), vertices);
    is(s_.node_.size(), vertices);
    is(s_.rings_.nodes().size(), s_.rings_.pool().size());
    is(s_.ring_.size(), s_.curves_.size());
    is(s_.counts_.size(), s_.components_.size());
  }

  template <class IdType, class IsLive>
  void pool(const IdPool<IdType>& ids, Invariant invariant, IsLive is_live) {
    std::vector<bool> listed(ids.size());
    for (const IdType id : ids.free_ids()) {
      const bool good = id.index() < ids.size() && !listed[id.index()] && !is_live(id);
      expect(good, invariant, id.index());
      if (good) listed[id.index()] = true;
    }
    for (std::uint32_t i = 0; i < ids.size(); ++i)
      expect(listed[i] || is_live(IdType(i)), invariant, i);
  }

  void pools() {
    const auto live = [this](auto id) { return s_.is_live(id); };
    pool(s_.faces_, Invariant::face_pool, live);
    pool(s_.vertices_, Invariant::vertex_pool, live);
    pool(s_.curves_, Invariant::curve_pool, live);
    pool(s_.components_, Invariant::component_pool, live);
    pool(s_.rings_.pool(), Invariant::node_pool,
         [this](RingNode n) { return s_.rings_.nodes()[n.index()].size != 0; });
  }

  void half_edges() {
    for (std::uint32_t i = 0; i < s_.org_.size(); ++i) {
      const HalfEdge h(i), t = s_.twin_[i];
      if (!s_.is_live(left(h))) {
        expect(!s_.org_[i], Invariant::origin_is_live, i);
        expect(!t, Invariant::twin_in_range, i);
        continue;
      }
      expect(s_.is_live(s_.org_[i]), Invariant::origin_is_live, i);
      if (!t) continue;
      if (!s_.is_live(t))
        expect(false, Invariant::twin_in_range, i);
      else if (t == h || s_.twin_[t.index()] != h)
        expect(false, Invariant::twin_is_mutual, i);
      else
        expect(s_.org(t) == s_.dest(h) && s_.dest(t) == s_.org(h), Invariant::twin_is_opposite, i);
    }
  }

  void vertices() {
    std::vector<std::uint32_t> corners(s_.star_.size());
    std::vector<HalfEdge> on_boundary(s_.star_.size());
    for (std::uint32_t i = 0; i < s_.org_.size(); ++i) {
      if (!s_.org_[i]) continue;
      ++corners[s_.org_[i].index()];
      if (!s_.twin_[i]) on_boundary[s_.org_[i].index()] = HalfEdge(i);
    }
    for (std::uint32_t v = 0; v < s_.star_.size(); ++v) {
      const HalfEdge star = s_.star_[v];
      if (!star) {
        expect(corners[v] == 0, Invariant::star_leaves_vertex, v);
        expect(s_.corners_[v] == 0, Invariant::corner_count, v);
        continue;
      }
      if (star.index() >= s_.org_.size() || s_.org(star) != Vertex(v)) {
        expect(false, Invariant::star_leaves_vertex, v);
        continue;
      }
      expect(!on_boundary[v] || !s_.sym(star), Invariant::star_on_boundary, v);
      expect(s_.corners_[v] == corners[v], Invariant::corner_count, v);
      // From the star, as many steps as there are corners end the fan, and no fewer.
      HalfEdge h = star;
      std::uint32_t steps = 0;
      do {
        h = s_.sym(lprev(h));
        ++steps;
      } while (h && h != star && steps < corners[v]);
      expect(steps == corners[v] && (!h || h == star), Invariant::one_fan, v);
    }
  }

  void rings() {
    const std::vector<Rings::Node>& nodes = s_.rings_.nodes();
    const auto good = [&](RingNode n) { return n.index() < nodes.size(); };
    for (std::uint32_t v = 0; v < s_.node_.size(); ++v) {
      const RingNode n = s_.node_[v];
      const HalfEdge star = s_.star_[v];
      expect(bool(n) == (star && !s_.sym(star)), Invariant::ring_members, v);
      if (n) expect(good(n) && nodes[n.index()].vertex == Vertex(v), Invariant::ring_members, v);
    }
    for (std::uint32_t i = 0; i < nodes.size(); ++i) {
      const RingNode at(i);
      const Rings::Node& n = nodes[i];
      if (n.size == 0) {
        expect(!n.parent && !n.lower && !n.upper && !n.vertex && !n.curve, Invariant::ring_links,
               i);
        continue;
      }
      // A node that no vertex names has leaked.
      expect(n.vertex.index() < s_.node_.size() && s_.node_[n.vertex.index()] == at,
             Invariant::ring_members, n.vertex.index());
      std::uint64_t size = 1;
      bool linked = !n.parent || (good(n.parent) && (nodes[n.parent.index()].lower == at) !=
                                                        (nodes[n.parent.index()].upper == at));
      bool heap = true;
      for (const RingNode child : {n.lower, n.upper}) {
        if (!child) continue;
        if (!good(child) || nodes[child.index()].parent != at) {
          linked = false;
        } else {
          size += nodes[child.index()].size;
          heap = heap && Rings::priority(child) < Rings::priority(at);
        }
      }
      expect(linked, Invariant::ring_links, i);
      // Decreasing priorities also prove that the links have no cycle.
      expect(heap && size == n.size, Invariant::ring_shape, i);
      if (n.parent)
        expect(!n.curve, Invariant::curve_names, n.curve.index());
      else
        expect(s_.is_live(n.curve) && s_.ring_[n.curve.index()] == at, Invariant::curve_names,
               n.curve.index());
    }
    for (std::uint32_t c = 0; c < s_.ring_.size(); ++c) {
      const RingNode root = s_.ring_[c];
      expect(!root || (good(root) && nodes[root.index()].size != 0 &&
                       nodes[root.index()].curve == Curve(c)),
             Invariant::curve_names, c);
    }
  }

  void ring_orders() {
    for (std::uint32_t i = 0; i < s_.org_.size(); ++i)
      if (const HalfEdge h(i); s_.is_live(h) && !s_.sym(h))
        expect(s_.boundary_next(s_.boundary_prev(h)) == h, Invariant::ring_order, i);
  }

  void components() {
    const std::size_t faces = s_.component_.size();
    std::vector<Characteristic> counts(s_.counts_.size());
    for (std::uint32_t f = 0; f < faces; ++f)
      if (s_.is_live(Face(f))) expect(s_.is_live(s_.component_[f]), Invariant::component_labels, f);
    if (!faults_.empty()) return;
    for (std::uint32_t i = 0; i < s_.org_.size(); ++i) {
      const HalfEdge h(i);
      if (!s_.is_live(h)) continue;
      Characteristic& c = counts[s_.component(left(h)).index()];
      const HalfEdge t = s_.sym(h);
      expect(!t || s_.component(left(t)) == s_.component(left(h)), Invariant::component_labels,
             left(h).index());
      if (corner(h) == 0) ++c.f;
      if (s_.star_half_edge(s_.org(h)) == h) ++c.v;
      if (!t || h < t) ++c.e;
    }
    for (const Curve c : s_.curves()) ++counts[s_.component(left(s_.on_curve(c))).index()].b;

    // Each label's faces, reached from the first of them.
    std::vector<bool> seen(faces);
    std::vector<Face> queue;
    for (std::uint32_t f = 0; f < faces; ++f) {
      if (seen[f] || !s_.is_live(Face(f))) continue;
      const Component k = s_.component(Face(f));
      expect(counts[k.index()].s == 0, Invariant::component_connected, k.index());
      counts[k.index()].s = 1;
      queue.assign(1, Face(f));
      seen[f] = true;
      while (!queue.empty()) {
        const Face at = queue.back();
        queue.pop_back();
        for (unsigned i = 0; i < 3; ++i) {
          const HalfEdge t = s_.sym(half_edge(at, i));
          if (!t || seen[left(t).index()]) continue;
          seen[left(t).index()] = true;
          queue.push_back(left(t));
        }
      }
    }

    Characteristic total;
    for (std::uint32_t k = 0; k < counts.size(); ++k) {
      const Characteristic& kept = s_.counts_[k];
      counts[k].g = kept.g;
      expect(kept == counts[k], Invariant::component_counts, k);
      expect(kept.is_valid(), Invariant::euler_poincare, k);
      total += kept;
    }
    const auto is = [&](std::int64_t kept, std::int64_t sum, std::size_t which) {
      expect(kept == sum, Invariant::total_counts, which);
    };
    is(s_.total_.v, total.v, 0);
    is(s_.total_.e, total.e, 1);
    is(s_.total_.f, total.f, 2);
    is(s_.total_.b, total.b, 3);
    is(s_.total_.g, total.g, 4);
    is(s_.total_.s, total.s, 5);
  }

  const Surface& s_;
  std::size_t limit_;
  std::vector<Fault> faults_;
};

std::vector<Fault> validate(const Surface& surface, std::size_t limit) {
  return Validator(surface, limit).run();
}

}  // namespace clers
