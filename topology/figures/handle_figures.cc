// Figures of handles and of the operators that attach them (§4.1, §5.1).
#include <algorithm>
#include <cmath>
#include <numbers>

#include "topology/derived.h"
#include "topology/figures/drawing.h"
#include "topology/validate.h"

namespace clers::figures {
namespace {

void glue(Scene& scene, HalfEdge a, HalfEdge b, HandleCase expected) {
  must(must(scene.surface.glue(a, b)) == expected, name(expected));
  must(validate(scene.surface).empty(), "validate");
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

}  // namespace

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

}  // namespace clers::figures
