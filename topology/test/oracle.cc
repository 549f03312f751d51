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

/// The faces' other half-edges lose their mates; those of the rim move, `inside` are glued.
void Oracle::replace(const Pairs& rim, const Pairs& inside, const std::vector<std::uint32_t>& born,
                     const std::vector<std::uint32_t>& die) {
  std::map<std::uint32_t, std::uint32_t> goes(rim.begin(), rim.end());
  Pairs glued = inside;
  for (const auto& [from, to] : rim) {
    if (mate_[from] < 0) continue;
    const auto other = goes.find(mate(from));
    glued.emplace_back(to, other == goes.end() ? mate(from) : other->second);
  }
  for (const std::uint32_t f : born) create(f);
  for (const auto& [from, to] : rim) mate_[from] = -1;
  for (const auto& [from, to] : rim) mate_[to] = -1;
  for (const auto& [a, b] : inside) mate_[a] = mate_[b] = -1;
  for (const auto& [a, b] : glued) glue(a, b);
  for (const std::uint32_t f : die) {
    create(f);
    destroy(f);
  }
}

void Oracle::flip(std::uint32_t h) {
  const std::uint32_t t = mate(h), n = around(h), p = around(n), tn = around(t), tp = around(tn);
  replace({{p, n}, {tn, p}, {tp, tn}, {n, tp}}, {{h, t}}, {}, {});
}

void Oracle::split_edge(std::uint32_t h, std::uint32_t born_f, std::uint32_t born_g) {
  const std::uint32_t f = h / 3 * 3, f2 = 3 * born_f;
  const bool inside = mate_[h] >= 0;
  Pairs rim{{around(h), f2 + 1}, {around(around(h)), f + 1}};
  Pairs glued{{f, f2 + 2}};
  std::vector<std::uint32_t> born{born_f};
  if (inside) {
    const std::uint32_t t = mate(h), g = t / 3 * 3, g2 = 3 * born_g;
    rim.insert(rim.end(), {{around(t), g2 + 1}, {around(around(t)), g + 1}});
    glued.insert(glued.end(), {{g, g2 + 2}, {f + 2, g2}, {g + 2, f2}});
    born.push_back(born_g);
  } else {
    rim.emplace_back(h, f + 2);
  }
  replace(rim, glued, born, {});
}

void Oracle::split_face(std::uint32_t f, std::uint32_t born_b, std::uint32_t born_c) {
  const std::uint32_t a = 3 * f, b = 3 * born_b, c = 3 * born_c;
  replace({{a, a + 1}, {a + 1, b + 1}, {a + 2, c + 1}}, {{a + 2, b}, {b + 2, c}, {c + 2, a}},
          {born_b, born_c}, {});
}

void Oracle::weld(std::uint32_t h) {
  // All half-edges that leave the vertex, from h on, or from the boundary on.
  const auto before = [&](std::uint32_t x) { return mate_[x] < 0 ? -1 : mate_[x]; };
  std::uint32_t first = h;
  for (std::int64_t x = h; (x = before(static_cast<std::uint32_t>(x))) >= 0;) {
    x = around(static_cast<std::uint32_t>(x));
    first = static_cast<std::uint32_t>(x);
    if (first == h) break;
  }
  std::vector<std::uint32_t> from_v{first};
  for (;;) {
    const std::uint32_t side = around(around(from_v.back()));
    if (mate_[side] < 0 || mate(side) == first) break;
    from_v.push_back(mate(side));
  }
  const auto rim = [&](std::size_t i) { return around(from_v[i]); };
  const auto corner0 = [&](std::size_t i) { return from_v[i] / 3 * 3; };
  if (from_v.size() == 2) {
    const std::uint32_t f = corner0(1);
    replace({{rim(1), f}, {around(rim(1)), f + 1}, {rim(0), f + 2}}, {}, {}, {from_v[0] / 3});
  } else if (from_v.size() == 3) {
    const std::uint32_t f = corner0(0);
    replace({{rim(0), f}, {rim(1), f + 1}, {rim(2), f + 2}}, {}, {},
            {from_v[2] / 3, from_v[1] / 3});
  } else {
    const std::uint32_t f = corner0(3), g = corner0(1);
    replace({{rim(3), f}, {rim(2), f + 2}, {rim(1), g}, {rim(0), g + 2}}, {{f + 1, g + 1}}, {},
            {from_v[0] / 3, from_v[2] / 3});
  }
}

void Oracle::turn(std::uint32_t f) {
  const std::uint32_t h = 3 * f;
  replace({{h, h + 1}, {h + 1, h + 2}, {h + 2, h}}, {}, {}, {});
}

void Oracle::adopt(const Surface& s) {
  alive_.assign(s.face_limit(), false);
  mate_.assign(s.half_edge_limit(), -1);
  for (std::uint32_t h = 0; h < mate_.size(); ++h) {
    alive_[h / 3] = s.is_live(Face(h / 3));
    if (s.twins()[h]) mate_[h] = s.twins()[h].index();
  }
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
