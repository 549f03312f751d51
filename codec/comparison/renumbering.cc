// Least rotations of faces, sorted by hash and compared by bits.
#include "codec/comparison/renumbering.h"

#include <algorithm>
#include <utility>

#include "codec/base/least_rotation.h"

namespace clers::internal {
namespace {

using Index = std::uint32_t;

/// Asks whether values agree, and are shared by the same elements; keeps the largest differences of
/// those that do.
class Agreement {
 public:
  Agreement(const ComparedMesh& a, const ComparedMesh& b, std::vector<double>& errors)
      : a_(a), b_(b), errors_(errors), image_(a.attributes.size()), origin_(image_.size()) {
    errors_.assign(a.attributes.size(), 0);
    for (std::size_t k = 0; k < image_.size(); ++k) {
      if (!a.shared[k]) continue;
      image_[k].assign(a.attributes[k]->value_count(), no_value);
      origin_[k].assign(b.attributes[k]->value_count(), no_value);
    }
  }
  bool operator()(Domain domain, Index i, Index j) {
    if (!a_.agree(domain, i, b_, j)) return false;
    const auto [begin, end] = a_.of_domain[static_cast<std::size_t>(domain)];
    for (std::size_t k = begin; k < end; ++k) {
      if (!a_.has(k, i)) continue;
      if (a_.tolerance[k]) errors_[k] = std::max(errors_[k], a_.difference_of(k, i, b_, j));
      if (a_.shared[k] && !pair(k, a_.attributes[k]->indices[i], b_.attributes[k]->indices[j]))
        return false;
    }
    return true;
  }

 private:
  /// Value v of one is value w of the other, and no other is.
  bool pair(std::size_t k, Index v, Index w) {
    if (image_[k][v] == no_value && origin_[k][w] == no_value) {
      image_[k][v] = w;
      origin_[k][w] = v;
    }
    return image_[k][v] == w && origin_[k][w] == v;
  }

  const ComparedMesh &a_, &b_;
  std::vector<double>& errors_;
  std::vector<std::vector<Index>> image_, origin_;  ///< of values that are shared
};

/// Whether a list has each number below its size once.
bool is_bijection(const std::vector<Index>& list, std::size_t size) {
  std::vector<bool> hit(size);
  for (const Index i : list) {
    if (i >= size || hit[i]) return false;
    hit[i] = true;
  }
  return list.size() == size;
}

/// Where the least rotation of a face's cycle starts, vertices numbered by `number`, ties broken by
/// the corners' values.
template <class Number>
Index least_rotation_of(const ComparedMesh& mesh, Index f, Number number) {
  const Index begin = mesh.faces.begin(f);
  return least_rotation(mesh.faces.size(f), [&](Index x, Index y) {
    const Index nx = number(mesh.faces.org[begin + x]), ny = number(mesh.faces.org[begin + y]);
    return nx != ny ? (nx < ny ? -1 : 1) : mesh.compare_corners(begin + x, begin + y);
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

std::optional<Mismatch> renumbering_fails(const ComparedMesh& a, const ComparedMesh& b,
                                          const std::vector<Index>& image,
                                          std::vector<double>& errors) {
  Agreement agree(a, b, errors);
  std::vector<bool> hit(image.size());
  for (Index v = 0; v < image.size(); ++v) {
    if (image[v] >= image.size() || hit[image[v]])
      return Mismatch{"the renumbering is no bijection"};
    hit[image[v]] = true;
    if (!agree(Domain::vertex, v, image[v]))
      return Mismatch{"vertex " + std::to_string(v) + " of the first mesh has other values",
                      !a.shares()};
  }
  std::vector<Index> start_a, start_b;
  const Classes faces_a = cycles(
      a, [&](Index v) { return image[v]; }, start_a);
  const Classes faces_b = cycles(
      b, [](Index v) { return v; }, start_b);
  if (auto what = histograms_differ(faces_a, faces_b, "face", "the same vertices and values"))
    return Mismatch{std::move(*what)};

  const auto equal = [&](Index f, Index g) {
    const Index n = a.faces.size(f);
    if (n != b.faces.size(g) || !agree(Domain::face, f, g)) return false;
    for (Index j = 0; j < n; ++j) {
      const Index x = a.faces.begin(f) + (start_a[f] + j) % n;
      const Index y = b.faces.begin(g) + (start_b[g] + j) % n;
      if (image[a.faces.org[x]] != b.faces.org[y] || !agree(Domain::corner, x, y)) return false;
    }
    return true;
  };
  // Another rotation of it may agree, or another face.
  const auto has_choice = [&](std::size_t i) {
    const auto [colour, f] = faces_a[i];
    if ((i > 0 && faces_a[i - 1].first == colour) ||
        (i + 1 < faces_a.size() && faces_a[i + 1].first == colour))
      return true;
    std::vector<Index> vertices;
    for (Index c = a.faces.begin(f); c < a.faces.end(f); ++c) vertices.push_back(a.faces.org[c]);
    std::sort(vertices.begin(), vertices.end());
    return std::adjacent_find(vertices.begin(), vertices.end()) != vertices.end();
  };
  // Faces of one hash are duplicates of each other, and pair off in order, unless hashes collide.
  for (std::size_t i = 0; i < faces_a.size(); ++i)
    if (!equal(faces_a[i].second, faces_b[i].second))
      return Mismatch{
          "face " + std::to_string(faces_a[i].second) + " of the first mesh has other values",
          (a.is_exact() && !a.shares()) || !has_choice(i)};
  return std::nullopt;
}

Expected<std::optional<std::string>> renumbering_fails(const ComparedMesh& a, const ComparedMesh& b,
                                                       const Permutation& renumbering,
                                                       std::vector<double>& errors) {
  const auto& [vertices, faces, first_corners] = renumbering;
  if (!is_bijection(vertices, a.vertices()) || !is_bijection(faces, a.faces.count()) ||
      first_corners.size() != faces.size())
    return fail(ErrorCode::bad_option, "the renumbering is none of these meshes");
  Agreement agree(a, b, errors);
  const auto other = [](const char* element, std::size_t i) {
    return std::optional(std::string(element) + " " + std::to_string(i) +
                         " of the first mesh has other values");
  };
  for (Index v = 0; v < vertices.size(); ++v)
    if (!agree(Domain::vertex, vertices[v], v)) return other("vertex", vertices[v]);
  for (Index g = 0; g < faces.size(); ++g) {
    const Index f = faces[g], n = a.faces.size(f);
    if (first_corners[g] >= std::max(n, Index(1)))
      return fail(ErrorCode::bad_option, Place::face, f,
                  "has no corner " + std::to_string(first_corners[g]));
    if (n != b.faces.size(g) || !agree(Domain::face, f, g)) return other("face", f);
    for (Index j = 0; j < n; ++j) {
      const Index x = a.faces.begin(f) + (first_corners[g] + j) % n, y = b.faces.begin(g) + j;
      if (a.faces.org[x] != vertices[b.faces.org[y]] || !agree(Domain::corner, x, y))
        return other("face", f);
    }
  }
  return std::optional<std::string>();
}

}  // namespace clers::internal
