// Figures of blocks and of what their numbering says (Dynamic adaptive meshes, Figs. 5, 9 and 10).
#include <algorithm>
#include <array>

#include "topology/figures/drawing.h"
#include "topology/figures/plane.h"

namespace clers::figures {

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

namespace {

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

}  // namespace clers::figures
