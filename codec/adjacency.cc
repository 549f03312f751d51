#include "codec/adjacency.h"

#include <algorithm>
#include <optional>
#include <string>

#include "codec/edges.h"

namespace clers {
namespace {

constexpr std::uint32_t none = HalfEdge::null_index;

/// Matches half-edges while the faces stream by. The edges of a vertex that are known so far, those
/// to larger vertices, fill one cache line; in the order of most files it is in cache already.
/// Edges that do not fit there hang in lists, and where lists turn out long (hubs) the matcher
/// gives up, as it does at an edge that is not one of an oriented manifold.
class StreamingMatcher {
 public:
  StreamingMatcher(std::span<const std::uint32_t> org, std::span<HalfEdge> twins,
                   std::uint32_t vertices)
      : org_(org), twins_(twins), cells_(vertices) {}

  bool run() {
    const std::uint32_t n = static_cast<std::uint32_t>(org_.size());
    patience_ = 64 + 32 * std::uint64_t(n);
    for (std::uint32_t h = 0; h < n; h += 3) {
      const std::uint32_t a = org_[h], b = org_[h + 1], c = org_[h + 2];
      if (!match(h, a, b) || !match(h + 1, b, c) || !match(h + 2, c, a)) return false;
    }
    return true;
  }

 private:
  struct Slot {
    std::uint32_t end = none;        ///< the larger end of an edge; none: no edge
    std::uint32_t half_edge = none;  ///< its only half-edge so far; none: it has two
  };
  struct alignas(64) Cell {
    Slot slots[8];
  };
  struct More {
    Slot slot;
    std::uint32_t next;
  };

  bool match(std::uint32_t h, std::uint32_t a, std::uint32_t b) {
    const std::uint32_t low = std::min(a, b), high = std::max(a, b);
    for (Slot& slot : cells_[low].slots) {
      if (slot.end == high) return complete(slot, h, b);
      if (slot.end == none) {
        slot = {high, h};
        return true;
      }
    }
    return match_more(h, low, high, b);
  }

  /// The second half-edge of an edge; false if it is a third, or runs the same way as the first.
  bool complete(Slot& slot, std::uint32_t h, std::uint32_t b) {
    const std::uint32_t e = slot.half_edge;
    if (e == none || org_[e] != b) return false;
    twins_[e] = HalfEdge(h);
    twins_[h] = HalfEdge(e);
    slot.half_edge = none;
    return true;
  }

  [[gnu::noinline]] bool match_more(std::uint32_t h, std::uint32_t low, std::uint32_t high,
                                    std::uint32_t b) {
    if (heads_.empty()) heads_.assign(cells_.size(), none);
    for (std::uint32_t i = heads_[low]; i != none; i = more_[i].next) {
      if (more_[i].slot.end == high) return complete(more_[i].slot, h, b);
      if (patience_-- == 0) return false;
    }
    more_.push_back({{high, h}, heads_[low]});
    heads_[low] = static_cast<std::uint32_t>(more_.size() - 1);
    return true;
  }

  std::span<const std::uint32_t> org_;
  std::span<HalfEdge> twins_;
  std::vector<Cell> cells_;           ///< by smaller end
  std::vector<std::uint32_t> heads_;  ///< by smaller end: lists of the edges that did not fit
  std::vector<More> more_;
  std::uint64_t patience_ = 0;
};

/// The first edge, in the order of the faces, that is not one of an oriented manifold.
std::optional<Failure<Error>> bad_edge(std::span<const std::uint32_t> org,
                                       std::span<const std::uint32_t> order) {
  std::uint32_t first = none;
  std::size_t faces_there = 0;
  for (std::size_t i = 0; i < order.size();) {
    std::size_t j = i + 1;
    while (j < order.size() && edge_of(org, order[i]) == edge_of(org, order[j])) ++j;
    const bool bad = j - i > 2 || (j - i == 2 && org[order[i]] == org[order[i + 1]]);
    if (bad && order[i] < first) {
      first = order[i];
      faces_there = j - i;
    }
    i = j;
  }
  if (first == none) return std::nullopt;
  const std::string edge = "the edge of vertices " + std::to_string(org[first]) + " and " +
                           std::to_string(org[next_corner(first)]);
  if (faces_there > 2)
    return fail(ErrorCode::nonmanifold_edge, Place::face, first / 3,
                edge + " has " + std::to_string(faces_there) + " faces, expected at most 2");
  return fail(
      ErrorCode::nonorientable, Place::face, first / 3,
      edge + " is run along in the same direction by its two faces, expected opposite ones");
}

void match_sorted(std::span<const std::uint32_t> org, std::span<const std::uint32_t> order,
                  std::span<HalfEdge> twins) {
  std::fill(twins.begin(), twins.end(), HalfEdge());
  for (std::size_t i = 0; i + 1 < order.size(); ++i) {
    if (edge_of(org, order[i]) != edge_of(org, order[i + 1])) continue;
    twins[order[i]] = HalfEdge(order[i + 1]);
    twins[order[i + 1]] = HalfEdge(order[i]);
    ++i;
  }
}

/// Corners of the fan that contains a corner, both ways round.
std::uint64_t fan_size(std::span<const HalfEdge> twins, std::uint32_t start) {
  std::uint64_t count = 0;
  std::uint32_t h = start;
  do {
    ++count;
    h = twins[previous_corner(h)].index();
  } while (h != none && h != start);
  if (h == start) return count;
  for (h = twins[start].index(); h != none; h = twins[next_corner(h)].index()) ++count;
  return count;
}

}  // namespace

Expected<std::vector<HalfEdge>> find_twins(std::span<const std::uint32_t> corners,
                                           std::uint32_t vertex_count) {
  for (std::size_t h = 0; h < corners.size(); h += 3) {
    const std::uint32_t a = corners[h], b = corners[h + 1], c = corners[h + 2];
    for (const std::uint32_t v : {a, b, c})
      if (v >= vertex_count)
        return fail(ErrorCode::inconsistent_mesh, Place::face, h / 3,
                    "has vertex " + std::to_string(v) + ", expected one below " +
                        std::to_string(vertex_count));
    if (a == b || b == c || c == a)
      return fail(ErrorCode::repeated_vertex, Place::face, h / 3,
                  "uses vertex " + std::to_string(a == b ? a : c) + " twice");
  }
  std::vector<HalfEdge> twins(corners.size());
  if (StreamingMatcher(corners, twins, vertex_count).run()) return twins;

  const std::vector<std::uint32_t> order = sorted_by_edge(corners);
  if (auto failure = bad_edge(corners, order)) return *failure;
  match_sorted(corners, order, twins);
  return twins;
}

std::uint32_t vertex_of_several_fans(std::span<const std::uint32_t> corners,
                                     std::span<const HalfEdge> twins, std::uint32_t vertex_count) {
  std::vector<std::uint32_t> corners_of(vertex_count);
  for (const std::uint32_t v : corners) ++corners_of[v];
  for (std::uint32_t h = 0; h < corners.size(); ++h) {
    std::uint32_t& left_over = corners_of[corners[h]];
    if (left_over == 0) continue;  // looked at before
    if (fan_size(twins, h) != left_over) return corners[h];
    left_over = 0;
  }
  return Vertex::null_index;
}

}  // namespace clers
