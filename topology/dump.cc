// A surface as text, and as code to paste into a test.
#include "topology/dump.h"

#include <ostream>
#include <sstream>

namespace CLERS_VISIBLE clers {
namespace {

template <class Tag>
struct Shown {
  Id<Tag> id;
};
template <class Tag>
Shown<Tag> show(Id<Tag> id) {
  return {id};
}
template <class Tag>
std::ostream& operator<<(std::ostream& os, Shown<Tag> shown) {
  return shown.id ? os << shown.id.index() : os << '-';
}

void write(std::ostream& os, const Characteristic& c) {
  os << "v " << c.v << " e " << c.e << " f " << c.f << " b " << c.b << " g " << c.g << " s " << c.s
     << '\n';
}

/// const std::vector<Type> name{Type(1), Type(), ...};
template <class Tag>
void write_list(std::ostream& os, const char* type, const char* name,
                std::span<const Id<Tag>> ids) {
  os << "const std::vector<" << type << "> " << name << '{';
  for (std::size_t i = 0; i < ids.size(); ++i) {
    if (i != 0) os << (i % 9 == 0 ? ",\n    " : ", ");
    os << type << '(';
    if (ids[i]) os << ids[i].index();
    os << ')';
  }
  os << "};\n";
}

}  // namespace

std::string dump(const Surface& surface) {
  std::ostringstream os;
  os << "surface: ";
  write(os, surface.characteristic());
  for (const Component k : surface.components()) {
    os << "component " << show(k) << ": ";
    write(os, surface.characteristic(k));
  }
  for (const Face f : surface.faces()) {
    os << "face " << show(f) << ": origins";
    for (const HalfEdge h : surface.star(f)) os << ' ' << show(surface.org(h));
    os << ", twins";
    for (const HalfEdge h : surface.star(f)) os << ' ' << show(surface.sym(h));
    os << ", component " << show(surface.component(f)) << '\n';
  }
  for (const Vertex v : surface.vertices())
    os << "vertex " << show(v) << ": point " << show(surface.point(v)) << ", degree "
       << surface.degree(v) << ", star " << show(surface.star_half_edge(v)) << '\n';
  for (const Curve c : surface.curves()) {
    os << "curve " << show(c) << ':';
    for (const HalfEdge h : surface.boundary(c)) os << ' ' << show(h);
    os << '\n';
  }
  return os.str();
}

std::string dump_code(const Surface& surface) {
  std::ostringstream os;
  write_list(os, "Vertex", "origins", surface.origins());
  write_list(os, "HalfEdge", "twins", surface.twins());
  write_list(os, "Point", "points", surface.points());
  os << "Surface surface = *Surface::from_twins(origins, twins, " << surface.vertex_limit()
     << ", points);\n";
  return os.str();
}

}  // namespace clers
