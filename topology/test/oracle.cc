#include "topology/test/oracle.h"

#include <map>
#include <numeric>

namespace clers::test {
namespace {

std::uint32_t around(std::uint32_t h) {
  return h - h % 3 + (h + 1) % 3;
}  // since 3 | h - h % 3

struct Sets {
  std::vector<std::uint32_t> parent;
  explicit Sets(std::size_t n) : parent(n) { std::iota(parent.begin(), parent.end(), 0u); }
  std::uint32_t find(std::uint32_t x) {
    while (parent[x] != x) x = parent[x] = parent[parent[x]];
    return x;
  }
  void unite(std::uint32_t x, std::uint32_t y) { parent[find(x)] = find(y); }
};

/// Do equal classes have equal ids, and different classes different ones?
template <class IdType>
class Bijection {
 public:
  bool add(int cls, IdType id) {
    return to_.emplace(cls, id).first->second == id && back_.emplace(id, cls).first->second == cls;
  }
  std::size_t size() const { return to_.size(); }

 private:
  std::map<int, IdType> to_;
  std::map<IdType, int> back_;
};

}  // namespace

void Oracle::create(std::uint32_t face) {
  if (face >= alive_.size()) {
    alive_.resize(face + 1);
    mate_.resize(3 * (std::size_t{face} + 1), -1);
  }
  alive_[face] = true;
  for (std::uint32_t i = 0; i < 3; ++i) mate_[3 * face + i] = -1;
}

void Oracle::destroy(std::uint32_t face) {
  alive_[face] = false;
}

void Oracle::glue(std::uint32_t h0, std::uint32_t h1) {
  mate_[h0] = h1;
  mate_[h1] = h0;
}

void Oracle::unglue(std::uint32_t h) {
  mate_[static_cast<std::size_t>(mate_[h])] = -1;
  mate_[h] = -1;
}

Oracle::Account Oracle::recount() const {
  const std::size_t n = mate_.size();
  Sets corners(n), faces(alive_.size());
  for (std::uint32_t h = 0; h < n; ++h) {
    if (!alive_[h / 3] || mate_[h] < 0) continue;
    const auto t = static_cast<std::uint32_t>(mate_[h]);
    corners.unite(h, around(t));
    corners.unite(around(h), t);
    faces.unite(h / 3, t / 3);
  }

  Account a;
  a.vertex_of.assign(n, -1);
  a.curve_of.assign(n, -1);
  a.component_of.assign(alive_.size(), -1);
  std::map<std::uint32_t, int> vertex, component;
  for (std::uint32_t f = 0; f < alive_.size(); ++f) {
    if (!alive_[f]) continue;
    const int k =
        component.emplace(faces.find(f), static_cast<int>(component.size())).first->second;
    a.component_of[f] = k;
    a.components.resize(component.size());
    ++a.components[static_cast<std::size_t>(k)].f;
  }
  int curves = 0;
  for (std::uint32_t h = 0; h < n; ++h) {
    if (!alive_[h / 3]) continue;
    Characteristic& c = a.components[static_cast<std::size_t>(a.component_of[h / 3])];
    const auto [at, fresh] = vertex.emplace(corners.find(h), static_cast<int>(vertex.size()));
    a.vertex_of[h] = at->second;
    if (fresh) ++c.v;
    if (mate_[h] < static_cast<std::int64_t>(h)) ++c.e;
    if (mate_[h] >= 0 || a.curve_of[h] >= 0) continue;
    // Along the boundary: turn about the head of the edge until there is no mate.
    for (std::uint32_t x = h; a.curve_of[x] < 0;) {
      a.curve_of[x] = curves;
      x = around(x);
      while (mate_[x] >= 0) x = around(static_cast<std::uint32_t>(mate_[x]));
    }
    ++curves;
    ++c.b;
  }
  for (Characteristic& c : a.components) {
    c.s = 1;
    c.g = (2 - c.b - (c.v - c.e + c.f)) / 2;
    a.total += c;
  }
  return a;
}

std::string Oracle::compare(const Surface& s) const {
  const Account a = recount();
  const auto at = [](const char* what, std::uint32_t i) {
    return std::string(what) + " differs at " + std::to_string(i);
  };
  if (s.characteristic() != a.total) return "total counts differ";
  if (s.face_limit() != alive_.size()) return "face_limit differs";

  Bijection<Vertex> vertices;
  Bijection<Curve> curves;
  Bijection<Component> components;
  std::map<Vertex, std::uint32_t> degree;
  std::map<Curve, std::uint32_t> length;
  std::map<Vertex, bool> on_boundary;
  for (std::uint32_t f = 0; f < alive_.size(); ++f) {
    if (s.is_live(Face(f)) != alive_[f]) return at("life of face", f);
    if (!alive_[f]) continue;
    const Component k = s.component(Face(f));
    if (!components.add(a.component_of[f], k)) return at("component of face", f);
    if (s.characteristic(k) != a.components[static_cast<std::size_t>(a.component_of[f])])
      return at("counts of the component of face", f);
    for (std::uint32_t i = 3 * f; i < 3 * f + 3; ++i) {
      const HalfEdge h(i);
      if (s.sym(h) != (mate_[i] < 0 ? HalfEdge() : HalfEdge(static_cast<std::uint32_t>(mate_[i]))))
        return at("sym", i);
      if (!s.is_live(s.org(h)) || !vertices.add(a.vertex_of[i], s.org(h))) return at("org", i);
      if (s.dest(h) != s.org(HalfEdge(around(i)))) return at("dest", i);
      ++degree[s.org(h)];
      if (mate_[i] >= 0) continue;
      ++degree[s.dest(h)];
      on_boundary[s.org(h)] = true;
      if (!s.is_live(s.curve(h)) || !curves.add(a.curve_of[i], s.curve(h))) return at("curve", i);
      ++length[s.curve(h)];
      std::uint32_t next = around(i);
      while (mate_[next] >= 0) next = around(static_cast<std::uint32_t>(mate_[next]));
      if (s.boundary_next(h) != HalfEdge(next)) return at("boundary_next", i);
      if (s.boundary_prev(HalfEdge(next)) != h) return at("boundary_prev", next);
    }
  }
  std::size_t live_vertices = 0, live_curves = 0, live_components = 0;
  for (const Vertex v : s.vertices()) {
    ++live_vertices;
    if (s.degree(v) != degree[v]) return at("degree of vertex", v.index());
    if (s.is_boundary(v) != on_boundary[v]) return at("is_boundary of vertex", v.index());
  }
  for (const Curve c : s.curves()) {
    ++live_curves;
    if (s.length(c) != length[c]) return at("length of curve", c.index());
  }
  for ([[maybe_unused]] const Component k : s.components()) ++live_components;
  if (live_vertices != vertices.size()) return "live vertices differ";
  if (live_curves != curves.size()) return "live curves differ";
  if (live_components != components.size()) return "live components differ";
  return "";
}

}  // namespace clers::test
