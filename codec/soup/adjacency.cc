// Half-edges matched while faces stream by; what does not fit is sorted afterwards.
#include "codec/soup/adjacency.h"

#include <algorithm>
#include <numeric>
#include <string>
#include <utility>

#include "codec/base/no_index.h"
#include "codec/base/portable.h"

namespace clers::internal {
namespace {

/// Matches half-edges while the faces stream by.
///
/// The edges of a vertex to larger vertices fill one cache line; in the order of most files it is
/// in cache already. An edge is where the larger vertex puts it, so it is found, or its place is
/// found empty, at the first look and without a branch that depends on which: what irregular meshes
/// would cost here is the branches that nobody can predict. Edges whose place is taken go to the
/// next one. Edges that find their line full (hubs) are matched by sorting, after all others.
///
/// A half-edge that does not fit the edge it is on, a third or one that runs the same way as the
/// first, is noted and the matching goes on: what a few such edges cost does not depend on the size
/// of the mesh.
class StreamingMatcher {
 public:
  StreamingMatcher(const Faces& faces, std::uint32_t vertices)
      : faces_(faces),
        org_(faces.org),
        nobody_(static_cast<std::uint32_t>(faces.org.size())),
        cells_(vertices <= max_vertices ? vertices : 0) {
    result_.twins.resize(org_.size() + 1);
  }

  Adjacency run() {
    const std::uint32_t n = static_cast<std::uint32_t>(org_.size());
    if (cells_.empty()) {
      for (std::uint32_t h = 0; h < n; ++h) spill(h);
    } else if (faces_.triangles()) {
      shuffled(n) ? match_triangles<true>(n) : match_triangles<false>(n);
    } else {
      match_polygons(faces_.count());
    }
    result_.twins.pop_back();
    std::vector<Cell>().swap(cells_);
    gather_misfits();
    match_spilled();
    return std::move(result_);
  }

 private:
  /// Twice the larger end of an edge, and whether its half-edge starts at the smaller one.
  using Key = std::uint32_t;
  static constexpr Key matched = 1u << 31;  ///< both half-edges were met
  static constexpr std::uint32_t max_vertices = 1u << 30;

  struct Slot {
    Key awaited = no_index;              ///< of the half-edge to come; none: no edge is here
    std::uint32_t half_edge = no_index;  ///< that was met
    bool is_free_or(Key key) const { return std::min(awaited ^ key, ~awaited) == 0; }
    bool has_edge_of(Key key) const { return ((awaited ^ key) & ~(matched | 1)) == 0; }
  };
  static constexpr std::uint32_t places = 8;
  struct alignas(64) Cell {
    Slot slots[places];
  };
  static std::uint32_t place(Key key) { return (key >> 1) * 0x9e3779b1u >> 29; }

  /// Whether many faces are far from the one before: then each waits for memory, or at least for
  /// a cache that is not the nearest.
  bool shuffled(std::uint32_t n) const {
    constexpr std::uint32_t far = 1u << 7, samples = 256;
    const std::uint32_t faces = n / 3;
    if (cells_.size() < 64 * far || faces < 2 * samples) return false;
    std::uint32_t count = 0;
    for (std::uint32_t i = 0; i < samples; ++i) {
      const std::uint32_t h =
          static_cast<std::uint32_t>(std::uint64_t(faces - 1) * i / samples) * 3;
      count += std::max(org_[h], org_[h + 3]) - std::min(org_[h], org_[h + 3]) > far;
    }
    return count > samples / 4;
  }

  template <bool prefetch>
  void match_triangles(std::uint32_t n) {
    constexpr std::uint32_t ahead = 3 * 12;  // enough faces to hide what memory takes
    const std::uint32_t* const org = org_.data();
    Slot* const slots = cells_.data()->slots;
    HalfEdge* const twins = result_.twins.data();
    for (std::uint32_t h = 0; h < n; h += 3) {
      if constexpr (prefetch) {
        if (h + ahead < n) {
          const std::uint32_t *const o = &org[h + ahead], low = std::min(o[0], o[1]);
          fetch_for_writing(&slots[std::size_t(places) * low]);
          fetch_for_writing(&slots[std::size_t(places) * std::min(std::max(o[0], o[1]), o[2])]);
          fetch_for_writing(&slots[std::size_t(places) * std::min(low, o[2])]);
        }
      }
      const std::uint32_t a = org[h], b = org[h + 1], c = org[h + 2];
      match(slots, twins, h, a, b);
      match(slots, twins, h + 1, b, c);
      match(slots, twins, h + 2, c, a);
    }
  }

  void match_polygons(std::uint32_t n) {
    Slot* const slots = cells_.data()->slots;
    HalfEdge* const twins = result_.twins.data();
    for (std::uint32_t f = 0; f < n; ++f) {
      const std::uint32_t first = faces_.begin(f), last = faces_.end(f) - 1;
      for (std::uint32_t h = first; h < last; ++h) match(slots, twins, h, org_[h], org_[h + 1]);
      match(slots, twins, last, org_[last], org_[first]);
    }
  }

  /// Half-edge h from a to b. The first of an edge waits for the second.
  CLERS_ALWAYS_INLINE void match(Slot* slots, HalfEdge* twins, std::uint32_t h, std::uint32_t a,
                                 std::uint32_t b) {
    const bool up = a < b;
    const std::uint32_t low = up ? a : b, high = up ? b : a;
    const Key key = 2 * high + up;
    Slot* slot = &slots[std::size_t(places) * low + place(key)];
    if (!slot->is_free_or(key)) {
      slot = find(low, key, h);
      if (!slot) return;
    }
    const std::uint32_t e = slot->half_edge;
    twins[h] = HalfEdge(e);
    twins[std::min(e, nobody_)] = HalfEdge(h);
    *slot = {(key ^ 1) | (~slot->awaited & matched), h};
  }

  /// Where the edge is, or goes, whose first place is taken; null if h is put off.
  CLERS_NEVER_INLINE Slot* find(std::uint32_t low, Key key, std::uint32_t h) {
    std::uint32_t at = place(key);
    for (unsigned left = places; left > 0; --left, at = (at + 1) % places) {
      Slot& slot = cells_[low].slots[at];
      if (slot.awaited == no_index || slot.awaited == key) return &slot;
      if (slot.has_edge_of(key)) {
        misfits_.push_back(std::uint64_t(slot.half_edge) << 32 | h);
        return nullptr;
      }
    }
    spill(h);
    return nullptr;
  }

  void spill(std::uint32_t h) {
    const auto [low, high] = std::minmax(org_[h], org_[faces_.next(h)]);
    spilled_.push_back({std::uint64_t(low) << 32 | high, h});
  }

  /// Edges with misfits lose the pair that was matched.
  void gather_misfits() {
    std::vector<HalfEdge>& twins = result_.twins;
    // The first side of an edge is one of the pair, since it was there first.
    for (std::uint64_t& m : misfits_) {
      const std::uint32_t side = static_cast<std::uint32_t>(m >> 32);
      m = std::uint64_t(std::min(side, twins[side].index())) << 32 | (m & 0xffffffffu);
    }
    std::sort(misfits_.begin(), misfits_.end());
    result_.sides.reserve(2 * misfits_.size());
    for (std::size_t i = 0; i < misfits_.size();) {
      const std::uint32_t first = static_cast<std::uint32_t>(misfits_[i] >> 32);
      const HalfEdge second = twins[first];
      const std::size_t begin = result_.sides.size();
      result_.sides.push_back(first);
      for (; i < misfits_.size() && misfits_[i] >> 32 == first; ++i)
        result_.sides.push_back(static_cast<std::uint32_t>(misfits_[i]));
      if (second) {
        twins[first] = twins[second.index()] = HalfEdge();
        const auto place =
            std::upper_bound(result_.sides.begin() + static_cast<std::ptrdiff_t>(begin),
                             result_.sides.end(), second.index());
        result_.sides.insert(place, second.index());
      }
      result_.ends.push_back(static_cast<std::uint32_t>(result_.sides.size()));
    }
  }

  void match_spilled() {
    const std::size_t streamed = result_.ends.size();
    std::sort(spilled_.begin(), spilled_.end());
    for (std::size_t i = 0, j; i < spilled_.size(); i = j) {
      j = i + 1;
      while (j < spilled_.size() && spilled_[j].first == spilled_[i].first) ++j;
      const std::uint32_t g = spilled_[i].second, h = spilled_[j - 1].second;
      if (j == i + 2 && org_[g] != org_[h]) {
        result_.twins[g] = HalfEdge(h);
        result_.twins[h] = HalfEdge(g);
      } else if (j > i + 1) {
        for (std::size_t k = i; k < j; ++k) result_.sides.push_back(spilled_[k].second);
        result_.ends.push_back(static_cast<std::uint32_t>(result_.sides.size()));
      }
    }
    if (result_.ends.size() > streamed) order_defects(result_);
  }

  const Faces& faces_;
  std::span<const std::uint32_t> org_;
  const std::uint32_t nobody_;          ///< one past the last half-edge: whose twin nobody asks for
  std::vector<Cell> cells_;             ///< by smaller end
  std::vector<std::uint64_t> misfits_;  ///< a side of the edge << 32 | one that does not fit it
  std::vector<std::pair<std::uint64_t, std::uint32_t>> spilled_;  ///< ends of the edge, half-edge
  Adjacency result_;
};

/// Corners of the fan that contains a corner, both ways round.
std::uint64_t fan_size(const Faces& faces, std::span<const HalfEdge> twins, std::uint32_t start) {
  std::uint64_t count = 0;
  std::uint32_t h = start;
  do {
    ++count;
    h = twins[faces.prev(h)].index();
  } while (h != no_index && h != start);
  if (h == start) return count;
  for (h = twins[start].index(); h != no_index; h = twins[faces.next(h)].index()) ++count;
  return count;
}

}  // namespace

void order_defects(Adjacency& adjacency) {
  Adjacency all;
  all.sides.swap(adjacency.sides);
  all.ends.swap(adjacency.ends);
  std::vector<std::uint32_t> order(all.edges());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t a, std::uint32_t b) { return all.edge(a)[0] < all.edge(b)[0]; });
  for (const std::uint32_t e : order) {
    const auto sides = all.edge(e);
    adjacency.sides.insert(adjacency.sides.end(), sides.begin(), sides.end());
    adjacency.ends.push_back(static_cast<std::uint32_t>(adjacency.sides.size()));
  }
}

Adjacency match_edges(const Faces& faces, std::uint32_t vertex_count) {
  if (vertex_count <= faces.org.size()) return StreamingMatcher(faces, vertex_count).run();
  // Most vertices are isolated. They shall cost nothing.
  std::vector<std::uint32_t> used(faces.org.begin(), faces.org.end());
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  std::vector<std::uint32_t> corners(faces.org.begin(), faces.org.end());
  for (std::uint32_t& v : corners)
    v = static_cast<std::uint32_t>(std::lower_bound(used.begin(), used.end(), v) - used.begin());
  Faces renumbered = faces;
  renumbered.org = corners;
  return StreamingMatcher(renumbered, static_cast<std::uint32_t>(used.size())).run();
}

Expected<std::vector<HalfEdge>> find_twins(const Faces& faces, std::uint32_t vertex_count) {
  Adjacency all = match_edges(faces, vertex_count);
  if (all.ends.empty()) return std::move(all.twins);
  const std::uint32_t first = all.sides[0];
  const std::string edge = "the edge of vertices " + std::to_string(faces.org[first]) + " and " +
                           std::to_string(faces.org[faces.next(first)]);
  if (all.ends[0] > 2)
    return fail(ErrorCode::nonmanifold_edge, Place::face, faces.face(first),
                edge + " has " + std::to_string(all.ends[0]) + " faces, expected at most 2");
  return fail(
      ErrorCode::nonorientable, Place::face, faces.face(first),
      edge + " is run along in the same direction by its two faces, expected opposite ones");
}

std::uint32_t vertex_of_several_fans(const Faces& faces, std::span<const HalfEdge> twins,
                                     std::uint32_t vertex_count) {
  std::vector<std::uint32_t> corners_of(vertex_count);
  for (const std::uint32_t v : faces.org) ++corners_of[v];
  for (std::uint32_t h = 0; h < faces.org.size(); ++h) {
    std::uint32_t& left_over = corners_of[faces.org[h]];
    if (left_over == 0) continue;  // looked at before
    if (fan_size(faces, twins, h) != left_over) return faces.org[h];
    left_over = 0;
  }
  return Vertex::null_index;
}

}  // namespace clers::internal
