// Compiles, unless one of the mistakes that the id types are there to catch is asked for.
#include "topology/ids.h"

using namespace clers;

bool use(Vertex v, Face f, HalfEdge h) {
  bool good = v == Vertex(1) && f < Face(3) && h != HalfEdge();
#if defined(COMPARE_VERTEX_WITH_FACE)
  good = v == f;
#elif defined(ORDER_HALF_EDGE_AND_VERTEX)
  good = h < v;
#elif defined(VERTEX_FROM_INTEGER)
  v = 1u;
#elif defined(INTEGER_FROM_FACE)
  unsigned i = f;
  good = i == 0;
#elif defined(FACE_FROM_VERTEX)
  f = v;
#elif defined(COMPARE_WITH_INTEGER)
  good = f == 0u;
#endif
  return good;
}
