// Figures of what a split or a weld waits for (Dynamic adaptive meshes, Figs. 6 and 7; Topological
// mesh operators, Fig. 18).
#include <array>
#include <utility>

#include "topology/figures/drawing.h"
#include "topology/figures/plane.h"

namespace clers::figures {
namespace {

Plane square() {
  return plane_of({{0, 1, 2, 3}}, {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}});
}

/// Finer towards a place.
Plane graded(Plane plane, unsigned levels, const Place& towards, double reach) {
  must(plane
           .adapt_refine([&](const Plane& p, HalfEdge h) {
             return p.level(h) < levels &&
                    distance(middle(p[p.surface().org(h)], p[p.surface().dest(h)]), towards) <
                        reach / (1 + 0.6 * p.level(h));
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

}  // namespace

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
