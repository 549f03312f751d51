#include "codec/soup/measure.h"

#include <algorithm>
#include <numeric>
#include <span>
#include <string>

#include "codec/base/check.h"
#include "codec/base/disjoint_sets.h"
#include "codec/soup/duplicates.h"

namespace clers::internal {
namespace {

/// The number of sets whose least element `counts` says to count.
template <class Counts>
std::uint64_t count(DisjointSets& sets, std::size_t elements, Counts counts) {
  std::uint64_t n = 0;
  for (std::uint32_t i = 0; i < elements; ++i) n += sets.find(i) == i && counts(i);
  return n;
}

/// Counts by plain union of what is glued; slow and obvious, and independent of the codec. Works on
/// corners: the side of a corner runs to the next corner of its face. Degenerate faces are left out
/// of the surface.
class Measuring {
 public:
  explicit Measuring(const Mesh& mesh) : mesh_(mesh), corners_(mesh.corners.size()) {}

  Expected<MeshShape> run() {
    if (auto ok = lay_out(); !ok) return Failure{ok.error()};
    // Sides 2f and 2f + 1 of face f: a component is one-sided when they meet.
    DisjointSets fans(corners_), faces(faces_), sides_of_faces(2 * faces_);
    std::uint64_t edges = 0;
    std::vector<bool> boundary(corners_);
    for_each_edge([&](std::span<const std::uint32_t> sides) {
      if (sides.size() == 2) {
        ++edges;
        const auto [g, h] = std::pair(sides[0], sides[1]);
        faces.unite(face_[g], face_[h]);
        const bool opposite = mesh_.corners[g] != mesh_.corners[h];
        shape_.misoriented_edges += !opposite;
        for (const std::uint32_t side : {0u, 1u})
          sides_of_faces.unite(2 * face_[g] + side, 2 * face_[h] + (opposite ? side : 1 - side));
        fans.unite(g, opposite ? next_[h] : h);
        fans.unite(next_[g], opposite ? h : next_[h]);
      } else {
        shape_.nonmanifold_edges += sides.size() > 2;
        edges += sides.size();
        for (const std::uint32_t side : sides) boundary[side] = true;
      }
    });

    std::vector<bool> used(mesh_.vertex_count), several(mesh_.vertex_count);
    std::uint64_t vertices = 0;
    for (std::uint32_t c = 0; c < corners_; ++c) {
      if (degenerate_[face_[c]] || fans.find(c) != c) continue;
      ++vertices;
      const std::uint32_t v = mesh_.corners[c];
      if (used[v]) several[v] = true;
      used[v] = true;
    }
    for (const std::uint32_t v : mesh_.corners) used[v] = true;
    shape_.nonmanifold_vertices =
        static_cast<std::uint64_t>(std::count(several.begin(), several.end(), true));
    shape_.isolated_vertices =
        static_cast<std::uint64_t>(std::count(used.begin(), used.end(), false));
    shape_.components = count(faces, faces_, [&](std::uint32_t f) { return !degenerate_[f]; });

    shape_.nonorientable_components = count(faces, faces_, [&](std::uint32_t f) {
      return sides_of_faces.find(2 * f) == sides_of_faces.find(2 * f + 1);
    });

    // An open fan lies between two boundary edges, so boundary edges linked by fans are the curves.
    DisjointSets curves(corners_);
    std::vector<bool> on_boundary(corners_);
    for (std::uint32_t c = 0; c < corners_; ++c) {
      if (!boundary[c]) continue;
      const std::uint32_t from = fans.find(c), to = fans.find(next_[c]);
      curves.unite(from, to);
      on_boundary[from] = on_boundary[to] = true;
    }
    shape_.boundary_curves =
        count(curves, corners_, [&](std::uint32_t c) { return on_boundary[c]; });

    const std::int64_t regular_faces =
        static_cast<std::int64_t>(shape_.faces - shape_.degenerate_faces);
    const std::int64_t chi =
        static_cast<std::int64_t>(vertices) - static_cast<std::int64_t>(edges) + regular_faces;
    // Euler-Poincare (paper §2.2): chi = 2 (s - g) - b.
    shape_.genus =
        static_cast<std::uint64_t>((2 * static_cast<std::int64_t>(shape_.components) -
                                    static_cast<std::int64_t>(shape_.boundary_curves) - chi) /
                                   2);
    return shape_;
  }

 private:
  /// Face and successor of every corner.
  Expected<Done> lay_out() {
    for (const Attribute& a : mesh_.attributes)
      if (const std::string defect = kind_defect(a); !defect.empty())
        return fail(ErrorCode::inconsistent_mesh, "attribute \"" + a.name + "\" has " + defect);
    faces_ = mesh_.face_count();
    shape_.vertices = mesh_.vertex_count;
    shape_.faces = faces_;
    if (corners_ >= 0xffffffffu || faces_ >= 0x7fffffffu)
      return fail(ErrorCode::too_large, std::to_string(corners_) + " corners");
    next_.resize(corners_);
    face_.resize(corners_);
    degenerate_.resize(faces_);
    std::vector<std::uint32_t> sorted;
    std::size_t first = 0;
    for (std::uint32_t f = 0; f < faces_; ++f) {
      const std::size_t size = mesh_.triangles_only() ? 3 : mesh_.face_sizes[f];
      if (size > corners_ - first)
        return fail(ErrorCode::inconsistent_mesh, Place::face, f,
                    "has more corners than are given");
      for (std::size_t j = 0; j < size; ++j) {
        const std::uint32_t v = mesh_.corners[first + j];
        if (v >= mesh_.vertex_count)
          return fail(ErrorCode::inconsistent_mesh, Place::face, f,
                      "has vertex " + std::to_string(v) + ", expected one below " +
                          std::to_string(mesh_.vertex_count));
        face_[first + j] = f;
        next_[first + j] = static_cast<std::uint32_t>(first + (j + 1) % size);
      }
      sorted.assign(mesh_.corners.begin() + static_cast<std::ptrdiff_t>(first),
                    mesh_.corners.begin() + static_cast<std::ptrdiff_t>(first + size));
      std::sort(sorted.begin(), sorted.end());
      degenerate_[f] = size < 3 || std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end();
      shape_.degenerate_faces += degenerate_[f];
      if (size >= 3) shape_.triangles += size - 2;
      first += size;
    }
    if (first != corners_)
      return fail(ErrorCode::inconsistent_mesh,
                  std::to_string(corners_ - first) + " corners belong to no face");
    shape_.duplicate_faces = duplicate_faces(mesh_).size();
    return Done{};
  }

  /// Calls visit with the sides of every edge, in file order. Sides are bucketed by smaller end.
  template <class Visit>
  void for_each_edge(Visit visit) {
    const auto low = [&](std::uint32_t c) {
      return std::min(mesh_.corners[c], mesh_.corners[next_[c]]);
    };
    const auto high = [&](std::uint32_t c) {
      return std::max(mesh_.corners[c], mesh_.corners[next_[c]]);
    };
    std::vector<std::uint32_t> end(std::size_t(mesh_.vertex_count) + 1), sides;
    for (std::uint32_t c = 0; c < corners_; ++c)
      if (!degenerate_[face_[c]]) ++end[low(c) + 1];
    std::partial_sum(end.begin(), end.end(), end.begin());
    sides.resize(end.back());
    std::vector<std::uint32_t> fill(end.begin(), end.end() - 1);
    for (std::uint32_t c = 0; c < corners_; ++c)
      if (!degenerate_[face_[c]]) sides[fill[low(c)]++] = c;
    for (std::uint32_t v = 0; v < mesh_.vertex_count; ++v) {
      const auto begin = sides.begin() + end[v], stop = sides.begin() + end[v + 1];
      std::sort(begin, stop, [&](std::uint32_t a, std::uint32_t b) {
        return high(a) != high(b) ? high(a) < high(b) : a < b;
      });
      for (auto i = begin; i != stop;) {
        auto j = i + 1;
        while (j != stop && high(*j) == high(*i)) ++j;
        visit(std::span<const std::uint32_t>(&*i, static_cast<std::size_t>(j - i)));
        i = j;
      }
    }
  }

  const Mesh& mesh_;
  std::size_t corners_;
  std::size_t faces_ = 0;
  MeshShape shape_;
  std::vector<std::uint32_t> next_, face_;
  std::vector<bool> degenerate_;
};

}  // namespace

std::uint64_t measuring_memory(std::uint64_t corners, std::uint64_t faces, std::uint64_t vertices,
                               bool sizes) {
  constexpr std::uint64_t each = sizeof(std::uint32_t);
  const std::uint64_t bits = (2 * corners + 2 * faces + 2 * vertices) / 8 + 64;
  const std::uint64_t sorted = sizes ? 2 * each * corners : 0,  // of a face that was larger
      duplicates = each * (corners + 2 * faces + 1) + 3 * 2 * each * faces,  // grown by doubling
      surface = each * (corners + 3 * faces) + each * std::max(corners + 2 * vertices + 1, corners);
  return 2 * each * corners + bits + sorted + std::max(duplicates, surface);
}

Expected<MeshShape> shape_of(const Mesh& mesh) {
  return Measuring(mesh).run();
}

}  // namespace clers::internal
