// Two triangles glued along an edge are a disk; subdivided, they are a finer one.
#include <clers/modeling/loop.h>
#include <clers/topology/surface.h>

int main() {
  clers::Surface surface;
  const auto f = surface.create(clers::Point(0), clers::Point(1), clers::Point(2));
  const auto g = surface.create(clers::Point(1), clers::Point(0), clers::Point(3));
  if (!f || !g || !surface.glue(half_edge(*f, 0), half_edge(*g, 0))) return 1;
  const clers::Characteristic& c = surface.characteristic();
  if (c.v != 4 || c.f != 2 || c.b != 1 || c.s != 1) return 1;

  clers::Averaging<double> heights(std::vector<double>(surface.vertex_limit(), 1.));
  clers::Creases none;
  if (!subdivide_loop(surface, heights, none)) return 1;
  return c.f == 8 && c.v == 9 && c.b == 1 ? 0 : 1;
}
