#include "codec/adjacency.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

namespace clers {
namespace {

constexpr std::uint32_t none = HalfEdge::null_index;

/// Raw forms of lnext and lprev: these loops are what encoding takes longest for.
std::uint32_t next(std::uint32_t h) {
  return h % 3 == 2 ? h - 2 : h + 1;
}
std::uint32_t prev(std::uint32_t h) {
  return h % 3 == 0 ? h + 2 : h - 1;
}

/// Matches half-edges while the faces stream by. Those without a match yet hang in one list for
/// each smaller end, linked through the twins they do not have yet. In the order of most files,
/// lists are short and their half-edges recent. Gives up when lists turn out long (hubs in shuffled
/// files).
class StreamingMatcher {
 public:
  StreamingMatcher(std::span<const std::uint32_t> org, std::span<HalfEdge> twins,
                   std::uint32_t vertices)
      : org_(org), twins_(twins), heads_(vertices, none) {}

  bool run() {
    const std::uint32_t n = static_cast<std::uint32_t>(org_.size());
    std::uint64_t patience = 64 + 32 * std::uint64_t(n);
    for (std::uint32_t h = 0; h < n; h += 3) {
      const std::uint32_t a = org_[h], b = org_[h + 1], c = org_[h + 2];
      std::uint64_t steps = match(h, a, b);
      steps += match(h + 1, b, c);
      steps += match(h + 2, c, a);
      if (steps > patience) return false;
      patience -= steps;
    }
    for (std::uint32_t h : heads_) {
      while (h != none) {
        const std::uint32_t after = twins_[h].index();
        twins_[h] = HalfEdge();
        h = after;
      }
    }
    return true;
  }

 private:
  std::uint64_t match(std::uint32_t h, std::uint32_t a, std::uint32_t b) {
    const std::uint32_t low = std::min(a, b);
    std::uint64_t steps = 0;
    std::uint32_t before = none;
    for (std::uint32_t e = heads_[low]; e != none; e = twins_[e].index(), ++steps) {
      if (org_[e] == b && org_[next(e)] == a) {
        const HalfEdge after = twins_[e];
        if (before == none)
          heads_[low] = after.index();
        else
          twins_[before] = after;
        twins_[e] = HalfEdge(h);
        twins_[h] = HalfEdge(e);
        return steps;
      }
      before = e;
    }
    twins_[h] = HalfEdge(heads_[low]);
    heads_[low] = h;
    return steps;
  }

  std::span<const std::uint32_t> org_;
  std::span<HalfEdge> twins_;
  std::vector<std::uint32_t> heads_;  ///< by smaller end: latest half-edge without a match
};

/// Half-edges sorted by their edge, file order within: for meshes that defeat the lists, and to
/// find what is wrong with a mesh.
std::vector<std::uint32_t> sorted_by_edge(std::span<const std::uint32_t> org) {
  std::vector<std::uint32_t> order(org.size());
  for (std::uint32_t h = 0; h < order.size(); ++h) order[h] = h;
  std::sort(order.begin(), order.end(), [&](std::uint32_t g, std::uint32_t h) {
    const auto [g0, g1] = std::minmax(org[g], org[next(g)]);
    const auto [h0, h1] = std::minmax(org[h], org[next(h)]);
    return g0 != h0 ? g0 < h0 : g1 != h1 ? g1 < h1 : g < h;
  });
  return order;
}

bool same_edge(std::span<const std::uint32_t> org, std::uint32_t g, std::uint32_t h) {
  return std::minmax(org[g], org[next(g)]) == std::minmax(org[h], org[next(h)]);
}

/// The first edge, in the order of the faces, that is not one of an oriented manifold.
std::optional<Failure<Error>> bad_edge(std::span<const std::uint32_t> org,
                                       std::span<const std::uint32_t> order) {
  std::uint32_t first = none;
  std::size_t faces_there = 0;
  for (std::size_t i = 0; i < order.size();) {
    std::size_t j = i + 1;
    while (j < order.size() && same_edge(org, order[i], order[j])) ++j;
    const bool bad = j - i > 2 || (j - i == 2 && org[order[i]] == org[order[i + 1]]);
    if (bad && order[i] < first) {
      first = order[i];
      faces_there = j - i;
    }
    i = j;
  }
  if (first == none) return std::nullopt;
  const std::string edge = "the edge of vertices " + std::to_string(org[first]) + " and " +
                           std::to_string(org[next(first)]);
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
    if (!same_edge(org, order[i], order[i + 1])) continue;
    twins[order[i]] = HalfEdge(order[i + 1]);
    twins[order[i + 1]] = HalfEdge(order[i]);
    ++i;
  }
}

/// Whether the corners at every vertex form one fan in which no neighbour comes twice.
class FanCheck {
 public:
  FanCheck(std::span<const std::uint32_t> org, std::span<const HalfEdge> twins,
           std::uint32_t vertices)
      : org_(org), twins_(twins), start_(vertices, none), stamp_(vertices, none) {
    for (std::size_t h = org.size(); h-- > 0;) start_[org[h]] = static_cast<std::uint32_t>(h);
  }

  // Either of these once for an object: a vertex is walked round once.

  /// Whether the mesh is a manifold whose edges all have two faces at most.
  bool run() {
    std::uint64_t corners = 0;
    for (const std::uint32_t start : start_) {
      if (start == none) continue;
      const std::uint64_t fan = walk(start);
      if (fan == 0) return false;
      corners += fan;
    }
    return corners == org_.size();
  }

  /// The first vertex, in the order of the faces, of several fans.
  std::uint32_t vertex_of_several_fans() {
    std::vector<std::uint32_t> corners(start_.size(), 0);
    for (const std::uint32_t v : org_) ++corners[v];
    std::vector<bool> seen(start_.size());
    for (const std::uint32_t v : org_) {
      if (seen[v]) continue;
      seen[v] = true;
      if (walk(start_[v]) != corners[v]) return v;
    }
    return none;
  }

 private:
  /// Corners of the fan that contains a corner, both ways round; 0 when a neighbour comes twice.
  std::uint64_t walk(std::uint32_t start) {
    const std::uint32_t v = org_[start];
    std::uint64_t count = 0;
    std::uint32_t h = start, last;
    do {
      if (!stamp(org_[next(h)], v)) return 0;
      ++count;
      last = prev(h);
      h = twins_[last].index();
    } while (h != none && h != start);
    if (h == start) return count;
    if (!stamp(org_[last], v)) return 0;
    for (h = twins_[start].index(); h != none; h = twins_[h].index()) {
      h = next(h);
      if (!stamp(org_[next(h)], v)) return 0;
      ++count;
    }
    return count;
  }

  bool stamp(std::uint32_t neighbour, std::uint32_t v) {
    if (stamp_[neighbour] == v) return false;
    stamp_[neighbour] = v;
    return true;
  }

  std::span<const std::uint32_t> org_;
  std::span<const HalfEdge> twins_;
  std::vector<std::uint32_t> start_;
  std::vector<std::uint32_t> stamp_;
};

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
  const bool streamed = StreamingMatcher(corners, twins, vertex_count).run();
  if (streamed && FanCheck(corners, twins, vertex_count).run()) return twins;

  const std::vector<std::uint32_t> order = sorted_by_edge(corners);
  if (auto failure = bad_edge(corners, order)) return *failure;
  match_sorted(corners, order, twins);
  const std::uint32_t v = FanCheck(corners, twins, vertex_count).vertex_of_several_fans();
  if (v != none)
    return fail(ErrorCode::nonmanifold_vertex, Place::vertex, v,
                "its faces form more than one fan, expected one");
  return twins;
}

}  // namespace clers
