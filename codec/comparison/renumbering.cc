// Least rotations of faces, sorted by hash and compared by bits.
#include "codec/comparison/renumbering.h"

#include "codec/base/least_rotation.h"

namespace clers::internal {
namespace {

using Index = std::uint32_t;

/// Where the least rotation of a face's cycle starts, vertices numbered by `number`, ties broken by
/// the corners' bits.
template <class Number>
Index least_rotation_of(const ComparedMesh& mesh, Index f, Number number) {
  const Index begin = mesh.faces.begin(f);
  return least_rotation(mesh.faces.size(f), [&](Index x, Index y) {
    const Index nx = number(mesh.faces.org[begin + x]), ny = number(mesh.faces.org[begin + y]);
    return nx != ny ? (nx < ny ? -1 : 1)
                    : mesh.compare_values(Domain::corner, begin + x, mesh, begin + y);
  });
}

/// The faces by a hash of their least rotation, and where that starts.
template <class Number>
Classes cycles(const ComparedMesh& mesh, Number number, std::vector<Index>& start) {
  start.resize(mesh.faces.count());
  std::vector<Colour> hashes(mesh.faces.count());
  for (Index f = 0; f < mesh.faces.count(); ++f) {
    const Index n = mesh.faces.size(f), begin = mesh.faces.begin(f);
    start[f] = least_rotation_of(mesh, f, number);
    Colour h = combine(n, mesh.value_of_face(f));
    for (Index j = 0; j < n; ++j) {
      const Index c = begin + (start[f] + j < n ? start[f] + j : start[f] + j - n);
      h = combine(combine(h, number(mesh.faces.org[c])), mesh.value_of_corner(c));
    }
    hashes[f] = h;
  }
  return classes(hashes);
}

}  // namespace

std::optional<std::string> renumbering_fails(const ComparedMesh& a, const ComparedMesh& b,
                                             const std::vector<Index>& image) {
  std::vector<bool> hit(image.size());
  for (Index v = 0; v < image.size(); ++v) {
    if (image[v] >= image.size() || hit[image[v]]) return "the renumbering is no bijection";
    hit[image[v]] = true;
    if (!a.equal_values(Domain::vertex, v, b, image[v]))
      return "vertex " + std::to_string(v) + " of the first mesh has other values";
  }
  std::vector<Index> start_a, start_b;
  const Classes faces_a = cycles(
      a, [&](Index v) { return image[v]; }, start_a);
  const Classes faces_b = cycles(
      b, [](Index v) { return v; }, start_b);
  if (auto what = histograms_differ(faces_a, faces_b, "face", "the same vertices and values"))
    return what;

  const auto equal = [&](Index f, Index g) {
    const Index n = a.faces.size(f);
    if (n != b.faces.size(g) || !a.equal_values(Domain::face, f, b, g)) return false;
    for (Index j = 0; j < n; ++j) {
      const Index x = a.faces.begin(f) + (start_a[f] + j) % n;
      const Index y = b.faces.begin(g) + (start_b[g] + j) % n;
      if (image[a.faces.org[x]] != b.faces.org[y] || !a.equal_values(Domain::corner, x, b, y))
        return false;
    }
    return true;
  };
  // Faces of one hash are duplicates of each other, and pair off in order, unless hashes collide.
  for (std::size_t i = 0; i < faces_a.size(); ++i)
    if (!equal(faces_a[i].second, faces_b[i].second))
      return "face " + std::to_string(faces_a[i].second) + " of the first mesh has other values";
  return std::nullopt;
}

}  // namespace clers::internal
