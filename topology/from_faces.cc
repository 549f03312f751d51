// A whole surface from the corners of its triangles: finds what is glued to what.
#include <algorithm>
#include <optional>

#include "topology/buckets.h"
#include "topology/surface.h"

namespace CLERS_VISIBLE clers {
namespace {

Failure<BrokenRule> broken(FaceRule rule, std::size_t element) {
  return {BrokenRule{rule, static_cast<std::uint32_t>(element)}};
}

/// Half-edge i runs from `corners[i]` to the next corner of its triangle.
std::uint32_t next_corner(std::uint32_t h) {
  return lnext(HalfEdge(h)).index();
}

/// Pairs the half-edges between the same two vertices; if some edge has too many or they run the
/// same way, returns that with the lowest half-edge.
std::optional<BrokenRule> pair_half_edges(std::span<const std::uint32_t> corners,
                                          std::uint32_t vertex_count, std::span<HalfEdge> twins) {
  const auto low = [&](std::uint32_t h) { return std::min(corners[h], corners[next_corner(h)]); };
  const internal::Buckets by_low(static_cast<std::uint32_t>(corners.size()), vertex_count, low);
  /// The edge from the vertex whose bucket is looked at to another.
  struct Edge {
    std::uint32_t from = Vertex::null_index;  // the vertex for which the rest was written
    std::uint32_t sides = 0, first = 0, met = 0;
  };
  std::vector<Edge> edge_to(vertex_count);
  std::optional<BrokenRule> worst;
  const auto note = [&](FaceRule rule, std::uint32_t h) {
    if (!worst || h < worst->element) worst = BrokenRule{rule, h};
  };
  for (std::uint32_t v = 0; v < vertex_count; ++v) {
    const std::span<const std::uint32_t> bucket = by_low[v];
    const auto edge_of = [&](std::uint32_t h) -> Edge& {
      return edge_to[std::max(corners[h], corners[next_corner(h)])];
    };
    for (const std::uint32_t h : bucket) {
      Edge& edge = edge_of(h);
      if (edge.from != v) edge = {v, 0, h, 0};
      ++edge.sides;
    }
    for (const std::uint32_t h : bucket) {
      Edge& edge = edge_of(h);
      ++edge.met;
      if (edge.sides > 2) {
        if (edge.met == 3) note(FaceRule::at_most_two_faces, h);
      } else if (edge.met == 2) {
        if (corners[h] == corners[edge.first]) note(FaceRule::opposite_directions, h);
        twins[h] = HalfEdge(edge.first);
        twins[edge.first] = HalfEdge(h);
      }
    }
  }
  return worst;
}

}  // namespace

Result<Surface, BrokenRule> Surface::from_faces(std::span<const std::uint32_t> corners,
                                                std::uint32_t vertex_count,
                                                std::span<const Point> points) {
  if (corners.size() % 3 != 0 || corners.size() / 3 > max_faces)
    return broken(FaceRule::array_sizes, corners.size());
  if (!points.empty() && points.size() != vertex_count)
    return broken(FaceRule::array_sizes, points.size());
  if (vertex_count == Vertex::null_index) return broken(FaceRule::array_sizes, vertex_count);
  for (std::size_t h = 0; h < corners.size(); ++h)
    if (corners[h] >= vertex_count) return broken(FaceRule::vertex_in_range, h);
  for (std::uint32_t h = 0; h < corners.size(); ++h)
    if (corners[h] == corners[next_corner(h)]) return broken(FaceRule::distinct_corners, h / 3);

  std::vector<HalfEdge> twins(corners.size());
  if (const auto wrong = pair_half_edges(corners, vertex_count, twins)) return Failure{*wrong};
  std::vector<Vertex> org;
  org.reserve(corners.size());
  for (const std::uint32_t v : corners) org.emplace_back(v);
  Result<Surface, Fault> surface = from_twins(org, twins, vertex_count, points);
  // All that from_twins could still find.
  if (!surface) return broken(FaceRule::one_fan, surface.error().element);
  return *std::move(surface);
}

}  // namespace clers
