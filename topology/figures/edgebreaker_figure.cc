// Fig. 14, the moves of Edgebreaker (§7.2).
#include <array>

#include "topology/derived.h"
#include "topology/figures/drawing.h"
#include "topology/validate.h"

namespace clers::figures {
namespace {

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

}  // namespace

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

}  // namespace clers::figures
