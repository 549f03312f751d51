// Figures of the stellar operators and of what is composed of them (§4.2, §5.2, §7.3).
#include "topology/figures/drawing.h"
#include "topology/stellar.h"
#include "topology/validate.h"

namespace clers::figures {

std::string bistellar_moves() {
  Figure figure(70, 170, 150);
  Scene s = triangle();
  figure.panel(s, "");
  const Vertex v = must(s.surface.split(Face(0), Point()));
  s.place(v) = mean_of_neighbours(s, v);
  s.dot(v);
  figure.arrow("split(f)", "weld(v)");
  figure.panel(s, "(a) 2-move and 0-move");
  figure.row();
  Scene d = diamond();
  d.marked = {HalfEdge(1)};
  figure.panel(d, "");
  must(d.surface.flip(HalfEdge(1)));
  figure.arrow("flip(e)", "flip(e)");
  figure.panel(d, "(b) 1-move");
  return figure.svg();
}

namespace {
std::string split_edge(Scene s, const char* caption) {
  Figure figure(70, 170, 150);
  s.marked = {HalfEdge(1)};
  figure.panel(s, "");
  const Vertex v = must(s.surface.split(HalfEdge(1), Point()));
  s.place(v) = Place{(s.at[0].x + s.at[1].x) / 2, (s.at[0].y + s.at[1].y) / 2};
  s.unmark();
  s.dot(v);
  figure.arrow("split(e)", "weld(v)");
  figure.panel(s, caption);
  return figure.svg();
}

}  // namespace

std::string split_interior_edge() {
  return split_edge(diamond(), "of an edge inside");
}
std::string split_boundary_edge() {
  return split_edge(patch({{2, 0, 1}}, {{-1, -0.4}, {1, -0.4}, {0, 0.8}}), "of a boundary edge");
}

std::string flip_by_split_and_weld() {
  Figure figure(70, 170, 150);
  Scene s = diamond();
  s.marked = {HalfEdge(1)};
  figure.panel(s, "");
  const Vertex v = must(s.surface.split(HalfEdge(1), Point()));
  s.place(v) = Place{};
  s.unmark();
  s.dot(v);
  figure.arrow("split(e)");
  figure.panel(s, "");
  for (const HalfEdge h : s.surface.fan(v))
    if (s.surface.dest(h) == Vertex(3)) {
      s.marked = {must(s.surface.weld(h)).at};
      break;
    }
  s.dots.clear();
  figure.arrow("weld(v)");
  figure.panel(s, "");
  return figure.svg();
}

std::string edge_collapse() {
  Figure figure(62, 160, 160);
  Scene s = fan(6, 1.1);  // the edge from 0 to 1 is collapsed
  s.marked = {between(s, 0, 1)};
  s.dot(Vertex(0));
  Scene merged = s;
  figure.panel(merged, "");
  must(collapse(merged.surface, between(merged, 0, 1)));
  merged.unmark();
  merged.dot(Vertex(1));
  figure.arrow("collapse(e)", "split_vertex");
  figure.panel(merged, "");
  figure.row();

  // The same by hand: flips, and a weld of the edge.
  figure.panel(s, "");
  for (const std::uint32_t neighbour : {2u, 3u}) {
    const HalfEdge h = between(s, 0, neighbour);
    must(s.surface.flip(h));
    s.unmark();
    s.marked = {h};
    s.dot(Vertex(0));
    s.place(Vertex(0)) = mean_of_neighbours(s, Vertex(0));
    figure.arrow("flip");
    figure.panel(s, "");
  }
  // Four edges are left: through the vertex, from 1 on.
  must(s.surface.weld(between(s, 0, 1)));
  s.unmark();
  s.dot(Vertex(1));
  figure.arrow("weld(v)");
  figure.panel(s, "");
  const auto same = [](const Scene& a, const Scene& b) {
    for (std::uint32_t v = 2; v < 7; ++v)
      if (a.surface.degree(Vertex(v)) != b.surface.degree(Vertex(v))) return false;
    return true;
  };
  must(same(s, merged), "flips and a weld make what collapse makes");
  return figure.svg();
}

std::string sqrt3_rules() {
  Figure figure(66, 200, 190);
  test::Triangles triangles;
  std::vector<Place> at{{0.05, 0.05}};
  for (std::uint32_t i = 0; i < 6; ++i) {
    triangles.push_back({0, 1 + i, 1 + (i + 1) % 6});
    at.push_back(on_circle(i % 2 == 0 ? 1.2 : 1.3, i / 6. + 0.03));
  }
  Scene s = patch(triangles, at);
  figure.panel(s, "");
  const std::uint32_t faces = s.surface.face_limit();
  for (std::uint32_t f = 0; f < faces; ++f) {
    const Vertex v = must(s.surface.split(Face(f), Point()));
    s.place(v) = mean_of_neighbours(s, v);
    s.dot(v);
  }
  std::vector<HalfEdge> old;
  for (const Face f : s.surface.faces())
    if (const HalfEdge h = half_edge(f, 1); s.surface.sym(h) && h < s.surface.sym(h))
      old.push_back(h);
  s.marked = old;
  figure.arrow("split(f)");
  figure.panel(s, "");
  for (const HalfEdge h : old) must(s.surface.flip(h));
  must(validate(s.surface).empty(), "validate");
  figure.arrow("flip(e)");
  figure.panel(s, "");
  return figure.svg();
}

}  // namespace clers::figures
