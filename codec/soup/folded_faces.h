// Triangles on the two ends of an edge of the surface, one of them twice: what strips of triangles
// and simplification leave. All they need is to say which edge, and which end is there twice.
#ifndef CLERS_CODEC_SOUP_FOLDED_FACES_H
#define CLERS_CODEC_SOUP_FOLDED_FACES_H

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "codec/entropy/coder.h"

namespace clers::internal {

/// At half-edge h from a to b: the triangle (a, a, b), or (a, b, b).
struct Folded {
  std::uint32_t half_edge;
  bool first_twice;
};

/// Codes them by ascending half-edge.
class FoldedModel {
 public:
  /// A Coder that encodes gets the face. What is decoded may be at no half-edge.
  template <class Coder>
  Folded code(Coder& coder, Folded value) {
    const std::uint32_t step = step_[near_].code(coder, value.half_edge - last_);
    near_ = step < 4;
    last_ += step;
    first_twice_ = coder.bit(twice_[first_twice_], value.first_twice);
    return {last_, first_twice_};
  }

 private:
  std::uint32_t last_ = 0;
  bool near_ = false, first_twice_ = false;
  NumberModel step_[2];
  BitModel twice_[2];
};

/// A face on two vertices, u < v, and a number for it.
struct TwoVertexFace {
  std::uint32_t u, v, number;
};

/// Calls visit(number, half-edge) for each face whose vertices an edge of the triangles joins, by
/// ascending half-edge: the first one of the edge. Returns the numbers of the others, ascending.
/// Vertices are below `vertices`. Cost: linear in the triangles, n log n in the faces.
template <class Visit>
std::vector<std::uint32_t> find_folds(std::span<const TwoVertexFace> unsorted,
                                      std::uint32_t vertices,
                                      std::span<const std::uint32_t> triangles, Visit visit) {
  std::vector<std::uint32_t> begin(vertices + std::size_t(2));  // by u
  std::vector<bool> is_v(vertices);
  for (const TwoVertexFace& f : unsorted) {
    ++begin[f.u + 2];
    is_v[f.v] = true;
  }
  for (std::size_t u = 2; u < begin.size(); ++u) begin[u] += begin[u - 1];
  std::vector<TwoVertexFace> faces(unsorted.size());
  for (const TwoVertexFace& f : unsorted) faces[begin[f.u + 1]++] = f;
  for (std::uint32_t u = 0; u < vertices; ++u)
    if (begin[u + 1] - begin[u] > 1)
      std::stable_sort(faces.begin() + begin[u], faces.begin() + begin[u + 1],
                       [](const auto& a, const auto& b) { return a.v < b.v; });
  std::vector<bool> taken(faces.size());
  for (std::uint32_t h = 0; h < triangles.size(); ++h) {
    const std::uint32_t a = triangles[h], b = triangles[h % 3 == 2 ? h - 2 : h + 1];
    const std::uint32_t u = std::min(a, b), v = std::max(a, b);
    if (!is_v[v] || begin[u] == begin[u + 1]) continue;
    const auto less = [](const TwoVertexFace& f, std::uint32_t w) { return f.v < w; };
    auto i = static_cast<std::size_t>(
        std::lower_bound(faces.begin() + begin[u], faces.begin() + begin[u + 1], v, less) -
        faces.begin());
    for (; i < begin[u + 1] && faces[i].v == v && !taken[i]; ++i) {
      taken[i] = true;
      visit(faces[i].number, h);
    }
  }
  std::vector<std::uint32_t> others;
  for (std::size_t i = 0; i < faces.size(); ++i)
    if (!taken[i]) others.push_back(faces[i].number);
  std::sort(others.begin(), others.end());
  return others;
}

}  // namespace clers::internal

#endif
