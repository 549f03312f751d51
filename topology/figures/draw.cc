// The figures of Topological mesh operators that show operators, drawn from surfaces on which our
// operators have just done what is shown. usage: draw DIRECTORY
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <numbers>

#include "topology/derived.h"
#include "topology/figures/scene.h"
#include "topology/stellar.h"
#include "topology/test/meshes.h"
#include "topology/validate.h"

namespace clers::figures {
namespace {

/// A figure must not show what did not happen.
void must(bool ok, const char* what) {
  if (ok) return;
  std::fprintf(stderr, "draw: %s\n", what);
  std::exit(1);
}
template <class T>
T must(Result<T, Violation> result) {
  if (!result) {
    std::fprintf(stderr, "draw: %s\n", describe(result.error()).c_str());
    std::exit(1);
  }
  return *std::move(result);
}
void glue(Scene& scene, HalfEdge a, HalfEdge b, HandleCase expected) {
  must(must(scene.surface.glue(a, b)) == expected, name(expected));
  must(validate(scene.surface).empty(), "validate");
}

Scene patch(const test::Triangles& triangles, std::vector<Place> at) {
  return {test::from_triangles(triangles), std::move(at), {}, {}, {}, {}};
}

HalfEdge between(const Scene& scene, std::uint32_t a, std::uint32_t b) {
  const Surface& s = scene.surface;
  for (const Face f : s.faces())
    for (const HalfEdge h : s.star(f))
      if (s.org(h) == Vertex(a) && s.dest(h) == Vertex(b)) return h;
  must(false, "no such edge");
  return HalfEdge();
}

Place on_circle(double radius, double turns) {
  const double angle = 2 * std::numbers::pi * turns;
  return {radius * std::cos(angle), radius * std::sin(angle), 0};
}

Place mean_of_neighbours(const Scene& scene, Vertex v) {
  Place mean;
  const double n = scene.surface.degree(v);
  for (const HalfEdge h : scene.surface.star(v)) {
    const Place& p = scene.at[scene.surface.other_end(h, v).index()];
    mean.x += p.x / n, mean.y += p.y / n, mean.z += p.z / n;
  }
  return mean;
}

Scene triangle() {
  return patch({{0, 1, 2}}, {{-0.9, -0.6}, {0.9, -0.6}, {0, 0.9}});
}
/// Two triangles about the edge from 0 to 1.
Scene diamond() {
  return patch({{2, 0, 1}, {3, 1, 0}}, {{-1, 0}, {1, 0}, {0, 0.9}, {0, -0.9}});
}

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

std::string create() {
  Figure figure(70, 170, 150);
  Scene s;
  figure.panel(s, "nothing");
  must(s.surface.create(Point(0), Point(1), Point(2)));
  s.at = triangle().at;
  figure.arrow("create", "destroy");
  figure.panel(s, "a triangle");
  return figure.svg();
}

/// A row of squares, in two triangles each, from 0 to `squares`; `place` puts its corners.
template <class Put>
Scene strip(std::uint32_t squares, Put put) {
  test::Triangles triangles;
  Scene s;
  for (std::uint32_t i = 0; i < squares; ++i) {
    const std::uint32_t a = 2 * i;
    triangles.push_back({a, a + 2, a + 3});
    triangles.push_back({a, a + 3, a + 1});
  }
  s.surface = test::from_triangles(triangles);
  for (std::uint32_t i = 0; i <= squares; ++i)
    for (std::uint32_t side = 0; side < 2; ++side) s.at.push_back(put(i, side));
  return s;
}

/// A tube bent to a ring, seen from above and in front: open by `gap(around)` turns where its ends
/// meet.
constexpr std::uint32_t tube_length = 16, tube_around = 8;
template <class Gap>
std::vector<Place> bent(Gap gap) {
  std::vector<Place> at;
  for (std::uint32_t i = 0; i <= tube_length; ++i)
    for (std::uint32_t j = 0; j < tube_around; ++j) {
      const double round = 2 * std::numbers::pi * j / tube_around;
      const double open = gap(j);
      const double along = open / 2 + (1 - open) * i / tube_length - 0.25;
      const double radius = 1 + 0.42 * std::cos(round);
      const Place p = on_circle(radius, along);
      const double height = 0.42 * std::sin(round);
      constexpr double tilt = 0.95;
      at.push_back({p.x, p.y * std::cos(tilt) + height * std::sin(tilt),
                    height * std::cos(tilt) - p.y * std::sin(tilt)});
    }
  return at;
}

/// The triangles of a tube whose ends meet if it is closed.
test::Triangles tube(bool closed) {
  test::Triangles triangles;
  const std::uint32_t vertices = (tube_length + (closed ? 0 : 1)) * tube_around;
  for (std::uint32_t i = 0; i < tube_length; ++i)
    for (std::uint32_t j = 0; j < tube_around; ++j) {
      const std::uint32_t p = i * tube_around + j, q = i * tube_around + (j + 1) % tube_around;
      const std::uint32_t p1 = (p + tube_around) % vertices, q1 = (q + tube_around) % vertices;
      triangles.push_back({p, p1, q1});
      triangles.push_back({p, q1, q});
    }
  return triangles;
}

/// A disk as a fan about vertex 0.
Scene fan(std::uint32_t corners, double radius) {
  test::Triangles triangles;
  std::vector<Place> at{{}};
  for (std::uint32_t i = 0; i < corners; ++i) {
    triangles.push_back({0, 1 + i, 1 + (i + 1) % corners});
    at.push_back(on_circle(radius, i / double(corners)));
  }
  return patch(triangles, at);
}

std::string handles_by_index() {
  Figure figure(70, 190, 160);
  figure.panel(fan(16, 0.9), "A0; B0 is empty");
  Scene square = strip(3, [](std::uint32_t i, std::uint32_t side) {
    return Place{0.5 * i - 0.75, side == 0 ? -0.6 : 0.6};
  });
  square.marked = {between(square, 1, 0), between(square, 6, 7)};
  must(square.surface.is_boundary(square.marked[0]) && square.surface.is_boundary(square.marked[1]),
       "sides");
  figure.panel(square, "A1 and B1, two sides");
  Scene disk = fan(16, 0.9);
  for (const HalfEdge h : disk.surface.boundary(*disk.surface.curves().begin()))
    disk.marked.push_back(h);
  figure.panel(disk, "A2 and B2, its boundary");
  return figure.svg();
}

/// A torus in four handles: a piece of the tube, a piece that closes it around, a piece that closes
/// it along its length, and the rest.
std::string torus_of_handles() {
  Figure figure(50, 190, 160);
  const std::vector<Place> at = bent([](std::uint32_t) { return 0.0; });
  const auto handle_of = [](Face f) {
    const std::uint32_t i = f.index() / 2 / tube_around, j = f.index() / 2 % tube_around;
    const bool front = i < 2 || i >= tube_length - 2;
    if (front) return j < 5 ? 0u : 1u;
    return j < 3 ? 2u : 3u;
  };
  Surface s = test::from_triangles(tube(true));
  must(s.genus() == 1 && s.characteristic().b == 0, "a torus");
  // The edges along which each handle is attached: those to a handle before it.
  std::vector<std::pair<HalfEdge, HalfEdge>> seams[4];
  std::vector<HalfEdge> edges;
  for (const HalfEdge h : s.edges()) edges.push_back(h);
  for (const HalfEdge h : edges) {
    const HalfEdge t = s.sym(h);
    const unsigned later = std::max(handle_of(left(h)), handle_of(left(t)));
    if (handle_of(left(h)) == handle_of(left(t))) continue;
    seams[later].push_back({h, t});
    must(bool(s.unglue(h)), "cut");
  }
  must(s.characteristic().s == 4 && s.characteristic().b == 4, "four disks");

  struct Expected {
    std::int64_t euler, b, g;
  };
  constexpr Expected expected[4] = {{1, 1, 0}, {0, 2, 0}, {-1, 1, 1}, {0, 0, 1}};
  const char* captions[4] = {"S1 = H0, one curve", "S2: two curves", "S3: one, and a handle",
                             "S4: none"};
  for (unsigned k = 0; k < 4; ++k) {
    for (const auto& [h, t] : seams[k]) must(bool(s.glue(h, t)), "glue");
    Scene scene;
    scene.surface = s;
    for (const Face f : s.faces())
      if (handle_of(f) > k) must(detach(scene.surface, f));
    const Characteristic& c = scene.surface.characteristic();
    must(c.euler() == expected[k].euler && c.b == expected[k].b && c.g == expected[k].g && c.s == 1,
         "Theorem 5");
    for (const Vertex v : scene.surface.vertices())
      scene.place(v) = at[scene.surface.point(v).index()];
    for (const auto& [h, t] : seams[k]) scene.marked.push_back(h);
    if (k == 0)
      figure.panel(scene, captions[k]);
    else
      figure.arrow(k == 3 ? "+ H2" : "+ H1"), figure.panel(scene, captions[k]);
    if (k == 1) figure.row();
  }
  return figure.svg();
}

std::string handles_of_type_1() {
  Figure figure(62, 210, 190);
  // (a) two components.
  Scene a = patch({{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}}, {{-1.4, -0.7},
                                                                 {-0.3, -0.7},
                                                                 {-0.3, 0.7},
                                                                 {-1.4, 0.7},
                                                                 {0.3, -0.7},
                                                                 {1.4, -0.7},
                                                                 {1.4, 0.7},
                                                                 {0.3, 0.7}});
  const HalfEdge left_side = between(a, 1, 2), right_side = between(a, 7, 4);
  a.marked = {left_side, right_side};
  figure.panel(a, "two components");
  glue(a, left_side, right_side, HandleCase::join_components);
  for (const std::uint32_t v : {0u, 1u, 2u, 3u, 4u, 5u, 6u, 7u})
    a.at[v].x += a.at[v].x < 0 ? 0.3 : -0.3;
  figure.arrow("glue", "unglue");
  figure.panel(a, "(a) one, with one curve less");
  figure.row();
  // (b) two edges of one boundary curve.
  constexpr std::uint32_t squares = 14;
  const auto ring = [](double gap) {
    return [gap](std::uint32_t i, std::uint32_t side) {
      return on_circle(side == 0 ? 1.3 : 0.75, gap / 2 + (1 - gap) * i / squares - 0.25);
    };
  };
  Scene b = strip(squares, ring(0.08));
  const HalfEdge start = between(b, 1, 0), end = between(b, 2 * squares, 2 * squares + 1);
  b.marked = {start, end};
  figure.panel(b, "one boundary curve");
  glue(b, start, end, HandleCase::split_curve);
  for (std::uint32_t i = 0; i <= squares; ++i)
    for (std::uint32_t side = 0; side < 2; ++side) b.at[2 * i + side] = ring(0)(i, side);
  figure.arrow("glue", "unglue");
  figure.panel(b, "(b) two");
  figure.row();
  // (c) two boundary curves of one component.
  Scene c = patch(tube(false), bent([](std::uint32_t) { return 0.1; }));
  must(c.surface.characteristic().b == 2, "a tube");
  constexpr std::uint32_t last = tube_length * tube_around;
  const HalfEdge front = between(c, 2, 1), back = between(c, last + 1, last + 2);
  c.marked = {front, back};
  figure.panel(c, "two boundary curves");
  glue(c, front, back, HandleCase::join_curves);
  must(c.surface.genus() == 1 && c.surface.characteristic().b == 1, "a handle");
  c.at = bent([](std::uint32_t j) { return j == 1 || j == 2 ? 0.0 : 0.1; });
  figure.arrow("glue", "unglue");
  figure.panel(c, "(c) one, and a handle");
  return figure.svg();
}

/// A disk with an edge inside, from 0 to 1.
Scene disk_about_an_edge() {
  test::Triangles triangles{{0, 1, 4}, {1, 0, 8}};
  for (std::uint32_t i = 2; i < 4; ++i) triangles.push_back({1, i, i + 1});
  triangles.push_back({1, 9, 2});
  triangles.push_back({1, 8, 9});
  for (std::uint32_t i = 4; i < 8; ++i) triangles.push_back({0, i, i + 1});
  std::vector<Place> at{{-0.45, 0}, {0.45, 0}};
  for (std::uint32_t i = 0; i < 8; ++i) at.push_back(on_circle(1.15, i / 8.));
  return patch(triangles, at);
}

std::string close() {
  Figure figure(70, 190, 180);
  Scene s = disk_about_an_edge();
  const HalfEdge h = between(s, 0, 1), t = s.surface.sym(h);
  must(must(s.surface.unglue(h)) == HandleCase::close, "a curve of two edges");
  s.marked = {h, t};
  s.bends = {{h, -0.22}, {t, -0.22}};
  figure.panel(s, "a boundary curve of two edges");
  glue(s, h, t, HandleCase::close);
  s.bends.clear();
  figure.arrow("glue", "unglue");
  figure.panel(s, "none");
  return figure.svg();
}

std::string zip() {
  Figure figure(70, 190, 180);
  Scene s = fan(8, 1.15);  // its edge to the right is cut
  const HalfEdge h = between(s, 0, 1), t = s.surface.sym(h);
  must(must(s.surface.unglue(h)) == HandleCase::zip, "a notch");
  s.place(s.surface.dest(h)) = on_circle(1.15, 0.055);
  s.place(s.surface.org(t)) = on_circle(1.15, -0.055);
  s.marked = {h, t};
  s.dot(Vertex(0));
  figure.panel(s, "two edges that share a vertex");
  glue(s, h, t, HandleCase::zip);
  s.place(s.surface.dest(h)) = on_circle(1.15, 0);
  figure.arrow("glue", "unglue");
  figure.panel(s, "the zip");
  return figure.svg();
}

std::string two_zips() {
  Figure figure(44, 200, 160);
  // Four squares by three, cut from the middle of the upper side two edges down.
  Scene open{test::grid(4, 3), {}, {}, {}, {}, {}};
  for (std::uint32_t v = 0; v < 20; ++v) open.at.push_back({v % 5 - 2., v / 5 - 1.5});
  const HalfEdge outer = between(open, 17, 12), inner = between(open, 12, 7);
  const HalfEdge outer_twin = open.surface.sym(outer), inner_twin = open.surface.sym(inner);
  must(must(open.surface.unglue(outer)) == HandleCase::zip, "cut");
  must(must(open.surface.unglue(inner)) == HandleCase::zip, "cut");
  const auto spread = [&](Scene& s, double top, double middle) {
    s.place(s.surface.org(outer)) = {top, 1.5};
    s.place(s.surface.dest(outer_twin)) = {-top, 1.5};
    s.place(s.surface.dest(outer)) = {middle, 0.5};
    s.place(s.surface.org(outer_twin)) = {-middle, 0.5};
  };
  // The half-edge down has its face, and so its side of the cut, on its left: east.
  spread(open, 0.5, 0.25);
  open.marked = {outer, outer_twin, inner, inner_twin};

  Scene s = open;
  figure.panel(s, "(a)");
  glue(s, inner, inner_twin, HandleCase::zip);
  spread(s, 0.5, 0);
  s.marked = {outer, outer_twin};
  figure.arrow("zip");
  figure.panel(s, "");
  glue(s, outer, outer_twin, HandleCase::zip);
  spread(s, 0, 0);
  s.marked.clear();
  figure.arrow("zip");
  figure.panel(s, "");
  figure.row();

  s = open;
  figure.panel(s, "(b)");
  glue(s, outer, outer_twin, HandleCase::split_curve);
  spread(s, 0, 0);
  s.bends = {{inner, -0.25}, {inner_twin, -0.25}};
  s.marked = {inner, inner_twin};
  figure.arrow("type 1 (b)");
  figure.panel(s, "");
  glue(s, inner, inner_twin, HandleCase::close);
  s.bends.clear();
  s.marked.clear();
  figure.arrow("type 2");
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

/// A move of Edgebreaker: the triangle at the gate and what is left of the six around its apex, the
/// origin of the plane; and when it is detached. Faces 0 .. 5 counterclockwise, the gate's is 4.
void move_of_edgebreaker(Figure& figure, char symbol, const std::vector<std::uint32_t>& visited,
                         const char* meaning, const char* next) {
  Scene s = fan(6, 1);
  for (std::size_t v = 0; v < s.at.size(); ++v)  // a side at the bottom
    if (v > 0) s.at[v] = on_circle(1, (static_cast<double>(v) - 1) / 6);
  const Face f(4);
  const HalfEdge gate = half_edge(f, 1), right = lnext(gate), left_side = lprev(gate);
  const auto take = [&](Face face) {
    std::array<Place, 3> corners;
    for (unsigned i = 0; i < 3; ++i) corners[i] = s.at[s.surface.org(half_edge(face, i)).index()];
    s.gone.push_back(corners);
  };
  const auto places_by_point = [&] {
    for (const Vertex v : s.surface.vertices())
      if (s.surface.point(v).index() < 7) {
        const std::uint32_t p = s.surface.point(v).index();
        s.place(v) = p == 0 ? Place{} : on_circle(1, (p - 1.) / 6);
      }
  };
  for (const std::uint32_t face : visited) {
    take(Face(face));
    must(detach(s.surface, Face(face)));
    places_by_point();
  }
  const Surface& surface = s.surface;
  const Vertex v = surface.org(left_side);
  const bool is_visited = surface.is_boundary(v), is_right = surface.is_boundary(right),
             is_left = surface.is_boundary(left_side);
  must((!is_visited ? 'C'
        : is_right  ? (is_left ? 'E' : 'R')
        : is_left   ? 'L'
                    : 'S') == symbol,
       "the symbol");
  must(surface.is_boundary(gate), "the gate");
  s.marked = {gate};
  s.dot(v);
  figure.panel(s, meaning);

  // detach (§6.4): the left side first.
  const HalfEdge to_right = surface.sym(right), to_left = surface.sym(left_side);
  take(f);
  if (!is_left) must(s.surface.unglue(left_side));
  if (!is_right) must(s.surface.unglue(right));
  must(s.surface.destroy(f));
  must(validate(s.surface).empty(), "validate");
  must(s.surface.characteristic().s == (symbol == 'E' ? 0 : symbol == 'S' ? 2 : 1), "what is left");
  places_by_point();
  s.unmark();
  if (to_right) s.marked.push_back(to_right);
  if (to_left && (is_right || symbol == 'S')) s.marked.push_back(to_left);
  figure.arrow(std::string(1, symbol));
  figure.panel(s, next);
}

std::string moves_of_edgebreaker() {
  Figure figure(52, 150, 120);
  move_of_edgebreaker(figure, 'C', {}, "v is new", "on through the right");
  move_of_edgebreaker(figure, 'L', {3}, "left visited", "on through the right");
  figure.row();
  move_of_edgebreaker(figure, 'E', {0, 1, 2, 3, 5}, "all visited", "end");
  move_of_edgebreaker(figure, 'R', {5}, "right visited", "on through the left");
  figure.row();
  move_of_edgebreaker(figure, 'S', {1}, "v visited, no side", "right, then left");
  return figure.svg();
}

void save(const std::string& directory, const char* file, const std::string& svg) {
  std::ofstream out(directory + "/" + file, std::ios::binary);
  out << svg;
  out.close();
  if (!out) {
    std::fprintf(stderr, "draw: cannot write %s/%s\n", directory.c_str(), file);
    std::exit(1);
  }
}

}  // namespace
}  // namespace clers::figures

int main(int argc, char** argv) {
  using namespace clers::figures;
  if (argc != 2) {
    std::fprintf(stderr, "usage: draw DIRECTORY\n");
    return 2;
  }
  const std::string directory = argv[1];
  save(directory, "fig01-handles.svg", handles_by_index());
  save(directory, "fig02-torus-of-handles.svg", torus_of_handles());
  save(directory, "fig03-bistellar-moves.svg", bistellar_moves());
  save(directory, "fig04-split-interior-edge.svg", split_edge(diamond(), "of an edge inside"));
  save(directory, "fig05-split-boundary-edge.svg",
       split_edge(patch({{2, 0, 1}}, {{-1, -0.4}, {1, -0.4}, {0, 0.8}}), "of a boundary edge"));
  save(directory, "fig06-flip-by-split-and-weld.svg", flip_by_split_and_weld());
  save(directory, "fig07-create.svg", create());
  save(directory, "fig08-glue-type-1.svg", handles_of_type_1());
  save(directory, "fig09-glue-type-2.svg", close());
  save(directory, "fig10-zip.svg", zip());
  save(directory, "fig11-two-zips.svg", two_zips());
  save(directory, "fig12-edge-collapse.svg", edge_collapse());
  save(directory, "fig14-edgebreaker.svg", moves_of_edgebreaker());
  save(directory, "fig15-sqrt3.svg", sqrt3_rules());
}
