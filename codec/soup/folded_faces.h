// Triangles on the two ends of an edge of the surface, one of them twice: what strips of triangles
// and simplification leave. All they need is to say which edge, and which end is there twice.
// Decoding appends them to the faces of the surface, whose triangles this knows by vertices of the
// mesh. codec/format.md, Mesh.
#ifndef CLERS_CODEC_SOUP_FOLDED_FACES_H
#define CLERS_CODEC_SOUP_FOLDED_FACES_H

#include <algorithm>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "codec/base/faces.h"
#include "codec/entropy/stream.h"
#include "codec/order.h"

namespace clers::internal {

/// At half-edge h from a to b: the triangle (a, a, b), or (a, b, b).
struct Folded {
  std::uint32_t half_edge;
  bool first_twice;
};

/// Codes them by ascending half-edge.
class FoldedModel {
 public:
  /// What is decoded may be at no half-edge.
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

/// Encodes those of the faces `degenerate` that are triangles on an edge of `triangles`, and
/// appends them to the order. `number[v]`: what vertex v of `faces` is in the triangles, where it
/// is one of them if it is below `surface_vertices`. Returns the faces that are left, ascending.
inline std::vector<std::uint32_t> encode_folded(const Cycles& faces,
                                                std::span<const std::uint32_t> degenerate,
                                                std::span<const std::uint32_t> number,
                                                std::span<const std::uint32_t> triangles,
                                                std::uint32_t surface_vertices, Permutation& order,
                                                EncodedStream& out) {
  std::vector<TwoVertexFace> candidates;
  std::vector<std::uint32_t> others;
  for (const std::uint32_t f : degenerate) {
    const auto c = faces.cycle(f);
    if (c.size() == 3 && (c[0] != c[1] || c[1] != c[2])) {
      const auto [u, v] = std::minmax(number[c[0]], number[c[c[0] == c[1] ? 2 : 1]]);
      if (v < surface_vertices) {
        candidates.push_back({u, v, f});
        continue;
      }
    }
    others.push_back(f);
  }
  std::uint64_t count = 0;
  Bytes bytes = encode_stream([&](EncodeTo& coder) {
    FoldedModel model;
    const auto visit = [&](std::uint32_t f, std::uint32_t h) {
      const auto n = [&](std::uint32_t j) { return number[faces.cycle(f)[j % 3]]; };
      // The corner after which the face is (a, a, b) or (a, b, b).
      const std::uint32_t a = triangles[h];
      std::uint32_t first = 0;
      while (n(first) != a || n(first + 2) == a) ++first;
      model.code(coder, {h, n(first + 1) == a});
      order.faces.push_back(f);
      order.first_corners.push_back(first);
      ++count;
    };
    const auto left = find_folds(candidates, surface_vertices, triangles, visit);
    others.insert(others.end(), left.begin(), left.end());
  });
  if (count > 0) out = {{count}, std::move(bytes)};
  std::sort(others.begin(), others.end());
  return others;
}

/// What a mesh says of its folded faces before it is decoded.
struct FoldedHeader {
  std::uint64_t faces = 0;
  Stream stream;

  void read(ByteReader& in) { stream = read_stream(in, {&faces}); }
  /// Why the stream cannot have them; empty: it can.
  std::string fault() const {
    if (faces > 0 && faces <= stream.max_decisions()) return {};
    return std::to_string(faces) + " folded faces cannot be coded in " +
           std::to_string(stream.bytes.size()) + " bytes";
  }
};

/// Appends triangles on the vertices of an edge of `triangles`; no sizes: all are triangles.
/// Precondition: no fault. Error: invalid.
inline Expected<Done> append_folded(const FoldedHeader& header,
                                    std::span<const std::uint32_t> triangles,
                                    std::vector<std::uint32_t>& sizes,
                                    std::vector<std::uint32_t>& corners) {
  return decode_stream(header.stream, "the folded faces", [&](DecodeFrom& coder) -> std::string {
    FoldedModel model;
    std::uint32_t last = 0;
    for (std::uint64_t i = 0; i < header.faces; ++i) {
      const Folded folded = model.code(coder, {});
      const std::uint32_t h = folded.half_edge;
      if (h < last || h >= triangles.size())
        return "folded face " + std::to_string(i) + " has no such edge";
      last = h;
      const std::uint32_t a = triangles[h], b = triangles[h % 3 == 2 ? h - 2 : h + 1];
      if (!sizes.empty()) sizes.push_back(3);
      corners.insert(corners.end(), {a, folded.first_twice ? a : b, b});
    }
    return {};
  });
}

}  // namespace clers::internal

#endif
