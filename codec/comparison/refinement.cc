// The hash of a face read from each of its corners: a polynomial that is rotated in constant time.
#include "codec/comparison/refinement.h"

#include <cstddef>
#include <cstdint>

namespace clers::internal {
namespace {

// The base of the polynomial by which cycles are hashed, and its inverse modulo 2^64.
constexpr Colour base = 0xd1342543de82ef95u;
constexpr Colour base_inverse = [] {
  Colour x = 1;
  for (int i = 0; i < 6; ++i) x *= 2 - base * x;  // Newton doubles the right bits: 1, 2, .. 64
  return x;
}();
static_assert(base * base_inverse == 1);

/// How each vertex looks in a cycle.
std::vector<Colour> looks(const ComparedMesh& mesh) {
  std::vector<Colour> looks(mesh.colour.size());
  for (std::size_t v = 0; v < looks.size(); ++v) looks[v] = mix(mesh.colour[v]);
  return looks;
}

/// Calls visit(corner, hash) for each corner of a face with the hash of the face's cycle read from
/// that corner on; all of them in time linear in the face.
template <class Visit>
void each_rotation(const ComparedMesh& mesh, const std::vector<Colour>& look, std::uint32_t f,
                   Visit visit) {
  const std::uint32_t begin = mesh.faces.begin(f), end = mesh.faces.end(f);
  const Colour tail = combine(mesh.value_of_face(f), end - begin);
  const auto token = [&](std::uint32_t c) {
    return look[mesh.faces.org[c]] + 5 * mesh.value_of_corner(c);
  };
  Colour sum = 0, power = base_inverse;  // sum of token(begin + j) * base^j; base^(n-1)
  for (std::uint32_t c = begin; c < end; ++c) {
    power *= base;
    sum += token(c) * power;
  }
  for (std::uint32_t c = begin; c < end; ++c) {
    visit(c, mix(sum ^ tail));
    const Colour first = token(c);
    sum = (sum - first) * base_inverse + first * power;
  }
}

}  // namespace

void refine(ComparedMesh& mesh) {
  const std::vector<Colour> look = looks(mesh);
  std::vector<Colour> around(mesh.colour.size());
  for (std::uint32_t f = 0; f < mesh.faces.count(); ++f)
    each_rotation(mesh, look, f,
                  [&](std::uint32_t c, Colour h) { around[mesh.faces.org[c]] += h; });
  for (std::size_t v = 0; v < around.size(); ++v)
    mesh.colour[v] = combine(mesh.colour[v], around[v]);
}

std::vector<Colour> face_colours(const ComparedMesh& mesh) {
  const std::vector<Colour> look = looks(mesh);
  std::vector<Colour> colours(mesh.faces.count());
  for (std::uint32_t f = 0; f < mesh.faces.count(); ++f) {
    Colour sum = combine(mesh.value_of_face(f), mesh.faces.size(f));
    each_rotation(mesh, look, f, [&](std::uint32_t, Colour h) { sum += h; });
    colours[f] = mix(sum);
  }
  return colours;
}

}  // namespace clers::internal
