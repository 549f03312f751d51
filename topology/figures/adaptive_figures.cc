// Figures of adaptive meshes in the plane (Dynamic adaptive meshes, Figs. 5 to 10; Topological mesh
// operators, Fig. 18).
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "topology/figures/drawing.h"
#include "topology/modeling/adaptive_mesh.h"
#include "topology/validate.h"

namespace clers::figures {
namespace {

Place middle(const Place& a, const Place& b) {
  return {(a.x + b.x) / 2, (a.y + b.y) / 2, 0};
}
double distance(const Place& a, const Place& b) {
  return std::sqrt((a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y));
}
Place mix(const Place& a, const Place& b, double k) {
  return {a.x + k * (b.x - a.x), a.y + k * (b.y - a.y), 0};
}

struct Middle {
  Place operator()(const Place& a, const Place& b) const { return middle(a, b); }
};
using Plane = AdaptiveMesh<Place, Middle>;

/// Of quadrilaterals, which are its blocks.
Plane plane_of(const std::vector<std::array<std::uint32_t, 4>>& quads, std::vector<Place> at) {
  std::vector<std::uint32_t> corners;
  for (const auto& quad : quads) corners.insert(corners.end(), quad.begin(), quad.end());
  const std::vector<std::uint32_t> sizes(quads.size(), 4);
  auto surface = surface_of_polygons(sizes, corners, static_cast<std::uint32_t>(at.size()),
                                     [](auto...) { return false; });
  must(static_cast<bool>(surface), "a base");
  Plane plane{Middle{}};
  must(plane.read(*std::move(surface), std::move(at), distance));
  must(plane.surface().characteristic().f == static_cast<std::int64_t>(2 * quads.size()), "blocks");
  return plane;
}
Plane square() {
  return plane_of({{0, 1, 2, 3}}, {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}});
}

/// Three quadrilaterals about a vertex.
Plane hexagon() {
  std::vector<Place> at{{0.06, -0.04}};
  for (unsigned i = 0; i < 6; ++i) at.push_back(on_circle(i % 2 == 0 ? 1.02 : 1.1, i / 6. + 0.05));
  return plane_of({{0, 1, 2, 3}, {0, 3, 4, 5}, {0, 5, 6, 1}}, std::move(at));
}

/// As it is now, split edges of blocks dashed.
Scene scene_of(const Plane& plane) {
  must(validate(plane.surface()).empty(), "validate");
  Scene s{plane.surface(), plane.values(), {}, {}, {}, {}};
  for (const HalfEdge h : s.surface.edges())
    if (plane.mesh().is_block(h) && !s.surface.is_boundary(h)) s.dashed.push_back(h);
  return s;
}
Place middle_of(const Plane& plane, HalfEdge h) {
  return middle(plane[plane.surface().org(h)], plane[plane.surface().dest(h)]);
}
/// The edge between two places, null if there is none.
HalfEdge find(const Scene& s, const std::array<Place, 2>& ends) {
  for (const HalfEdge h : s.surface.edges())
    for (unsigned turn = 0; turn < 2; ++turn)
      if (distance(s.at[s.surface.org(h).index()], ends[turn]) +
              distance(s.at[s.surface.dest(h).index()], ends[1 - turn]) ==
          0)
        return h;
  return {};
}
HalfEdge between(const Scene& s, const std::array<Place, 2>& ends) {
  const HalfEdge h = find(s, ends);
  must(static_cast<bool>(h), "no such edge");
  return h;
}

/// Finer towards a place.
Plane graded(Plane plane, unsigned levels, const Place& towards, double reach) {
  must(plane
           .adapt_refine([&](const Plane& p, HalfEdge h) {
             return p.level(h) < levels &&
                    distance(middle_of(p, h), towards) < reach / (1 + 0.6 * p.level(h));
           })
           .complete(),
       "graded");
  return plane;
}

/// What an operator does, step by step: where a vertex was made or welded, on which edge, and the
/// surface then.
struct Steps {
  const Plane& plane;
  std::vector<std::array<Place, 2>> edges{};
  std::vector<Place> vertices{};
  std::vector<Scene> after{};

  void operator()(const Refined& r) { add(r.made, plane[r.a], plane[r.b]); }
  void operator()(const Simplified& s) {
    const Surface& surface = plane.surface();
    add(s.gone, plane[surface.org(s.edge)], plane[surface.dest(s.edge)]);
  }

 private:
  void add(Vertex v, const Place& a, const Place& b) {
    edges.push_back({a, b});
    vertices.push_back(plane[v]);
    after.push_back(scene_of(plane));
  }
};

Steps steps_of(Plane& plane, HalfEdge h) {
  Steps steps{plane};
  const unsigned expected = plane.mesh().splits(h);
  must(plane.mesh().refine(h, plane.follow(steps)));
  must(steps.edges.size() == expected, "as many splits as was said");
  return steps;
}
Steps steps_of(Plane& plane, Vertex v) {
  Steps steps{plane};
  must(plane.mesh().simplify(v, plane.follow(steps)));
  return steps;
}

/// The split edge whose refinement needs so many splits.
HalfEdge edge_that_needs(const Plane& plane, unsigned splits) {
  for (const HalfEdge h : plane.surface().edges())
    for (const HalfEdge side : plane.surface().star(h))
      if (corner(side) == 1 && plane.mesh().splits(side) == splits) return side;
  must(false, "no such edge");
  return {};
}
/// The vertex whose simplification needs so many welds.
Vertex vertex_that_needs(const Plane& plane, std::size_t welds) {
  for (const Vertex v : plane.surface().vertices()) {
    if (plane.level(v) == 0) continue;
    Plane copy = plane;
    if (steps_of(copy, v).vertices.size() == welds) return v;
  }
  must(false, "no such vertex");
  return {};
}

void badge(Scene& scene, const Place& at, std::size_t number) {
  scene.notes.push_back({at, std::to_string(number), Note::Kind::badge});
}
void number_edges(Scene& before, const Steps& steps) {
  for (std::size_t i = 0; i < steps.edges.size(); ++i)
    badge(before, middle(steps.edges[i][0], steps.edges[i][1]), i + 1);
}
void number_vertices(Scene& before, const Steps& steps) {
  for (std::size_t i = 0; i < steps.vertices.size(); ++i) badge(before, steps.vertices[i], i + 1);
}

/// What a face calls its corners and, in red, its sides.
void number_face(Scene& s, Face f, const std::array<const char*, 3>& corners,
                 const std::array<const char*, 3>& sides, double inset) {
  const auto at = [&](unsigned i) { return s.at[s.surface.org(half_edge(f, i)).index()]; };
  const Place centre = mix(at(0), middle(at(1), at(2)), 2. / 3);
  for (unsigned i = 0; i < 3; ++i) {
    const auto inside = [&](const Place& p, double by) {
      return mix(p, centre, by / distance(p, centre));
    };
    s.notes.push_back({inside(at(i), i == 0 ? 0.24 : inset), corners[i]});
    const Place side = middle(at(i), at((i + 1) % 3));
    s.notes.push_back({inside(side, 0.21), sides[i], Note::Kind::red});
  }
}

}  // namespace

std::string interleaved_refinement() {
  Figure figure(68, 168, 150);
  Plane plane = hexagon();
  figure.panel(scene_of(plane), "level 0");
  for (unsigned level = 1; level <= 4; ++level) {
    const std::uint32_t before = plane.surface().vertex_limit();
    const std::int64_t faces = plane.surface().characteristic().f;
    const Adapted done =
        plane.adapt_refine([&](const Plane& p, HalfEdge h) { return p.level(h) < level; });
    must(done.complete() && plane.surface().characteristic().f == 2 * faces, "all blocks");
    Scene s = scene_of(plane);
    s.dot_size = 2.4;
    for (const Vertex v : s.surface.vertices())
      if (v.index() >= before) s.dot(v);
    figure.panel(s, "level " + std::to_string(level));
  }
  return figure.svg();
}

std::string dependencies_in_refinement() {
  Figure figure(62, 152, 140);
  Plane plane = graded(square(), 4, {-1, -1}, 2);
  const HalfEdge asked = edge_that_needs(plane, 4);
  Scene before = scene_of(plane);
  before.marked = {asked};
  Steps steps = steps_of(plane, asked);
  number_edges(before, steps);
  figure.panel(before, "refine(e), e is 4");
  for (std::size_t i = 0; i < steps.after.size(); ++i) {
    Scene& s = steps.after[i];
    s.dot(Vertex(s.surface.vertex_limit() - 1));
    if (i + 1 < steps.after.size()) s.marked = {between(s, steps.edges.back())};
    figure.panel(s, "split " + std::to_string(i + 1));
  }
  return figure.svg();
}

std::string dependencies_in_simplification() {
  Figure figure(62, 152, 140);
  Plane plane = graded(square(), 4, {-1, -1}, 2);
  const Vertex asked = vertex_that_needs(plane, 4);
  Scene before = scene_of(plane);
  Steps steps = steps_of(plane, asked);
  number_vertices(before, steps);
  figure.panel(before, "simplify(w), w is 4");
  for (std::size_t i = 0; i < steps.after.size(); ++i) {
    Scene& s = steps.after[i];
    s.marked = {between(s, steps.edges[i])};
    if (i + 1 < steps.after.size()) s.dot(asked);
    figure.panel(s, "weld " + std::to_string(i + 1));
  }
  return figure.svg();
}

std::string numbering() {
  Figure figure(92, 206, 200);
  Plane plane = plane_of({{0, 1, 2, 3}}, {{-1.05, 0}, {0, -1.05}, {1.05, 0}, {0, 1.05}});
  const HalfEdge e = half_edge(Face(0), 1);
  must(plane.mesh().is_block(e), "half-edge 1 is the split edge of both faces");
  Scene paper = scene_of(plane), ours = paper;
  for (const Face f : plane.surface().faces()) {
    must(plane.mesh().weld_vertex(f) == plane.surface().org(half_edge(f, 0)), "corner 0");
    // Its edge i is opposite to its vertex i.
    number_face(paper, f, {"v\u2080", "v\u2081", "v\u2082"}, {"e\u2082", "e\u2080", "e\u2081"},
                0.42);
    number_face(ours, f, {"0", "1", "2"}, {"0", "1", "2"}, 0.24);
    for (unsigned i = 0; i < 3; ++i) ours.arrows.push_back(half_edge(f, i));
  }
  figure.panel(paper, "the paper\u2019s numbers");
  figure.panel(ours, "corners and half-edges");
  NoObserver none;
  const Vertex v = must(plane.mesh().refine(e, plane.follow(none)));
  Scene after = scene_of(plane);
  after.dot(v);
  for (const Face f : after.surface.faces()) {
    must(plane.mesh().weld_vertex(f) == v, "the new vertex is corner 0");
    number_face(after, f, {"0", "", ""}, {"", "1", ""}, 0.24);
    after.arrows.push_back(half_edge(f, 1));
  }
  figure.arrow("refine(e)", "simplify(v)");
  figure.panel(after, "after a split");
  return figure.svg();
}

std::string weld_by_star() {
  Figure figure(66, 160, 146);
  for (const bool upright : {true, false}) {
    std::vector<Place> at{{-1, 0}, {0, -1}, {1, 0}, {0, 1}};
    if (!upright) std::rotate(at.begin(), at.begin() + 1, at.end());
    Plane plane = plane_of({{0, 1, 2, 3}}, at);
    const HalfEdge e = half_edge(Face(0), 1);
    const Place from = plane[plane.surface().org(e)], to = plane[plane.surface().dest(e)];
    Scene before = scene_of(plane);
    before.marked = {e};
    if (!upright) figure.row();
    figure.panel(before, "");
    NoObserver none;
    const Vertex v = must(plane.mesh().refine(e, plane.follow(none)));
    Scene star = scene_of(plane);
    star.dot(v);
    star.arrows = {star.surface.star_half_edge(v)};
    must(distance(plane[star.surface.dest(star.arrows[0])], from) == 0, "it leads to an end of e");
    figure.arrow("split(e)");
    figure.panel(star, "star half-edge of v");
    const HalfEdge back = must(plane.mesh().simplify(v, plane.follow(none)));
    Scene after = scene_of(plane);
    const HalfEdge restored = between(after, {from, to});
    must(plane.surface().edge(back) == plane.surface().edge(restored), "e is back");
    after.marked = {back};
    figure.arrow("weld(v)");
    figure.panel(after, "");
  }
  return figure.svg();
}

std::string dependencies() {
  Figure figure(110, 236, 240);
  const Plane plane = graded(hexagon(), 5, {0.35, 0.1}, 1.6);
  Plane finer = plane;
  const HalfEdge e = edge_that_needs(finer, 5);
  Scene before = scene_of(finer);
  before.marked = {e};
  const Steps steps = steps_of(finer, e);
  number_edges(before, steps);
  figure.panel(before, "e is 5");
  Scene after = scene_of(finer);
  for (const Vertex v : after.surface.vertices())
    if (v.index() >= before.surface.vertex_limit()) after.dot(v);
  must(after.dots.size() == 5, "new vertices");
  figure.arrow("refine(e)");
  figure.panel(after, "");
  figure.row();

  Plane coarser = plane;
  const Vertex w = vertex_that_needs(coarser, 7);
  before = scene_of(coarser);
  const Steps welds = steps_of(coarser, w);
  number_vertices(before, welds);
  figure.panel(before, "w is 7");
  after = scene_of(coarser);
  for (const auto& ends : welds.edges)
    if (const HalfEdge h = find(after, ends)) after.marked.push_back(h);
  figure.arrow("simplify(w)");
  figure.panel(after, "");
  return figure.svg();
}

}  // namespace clers::figures
