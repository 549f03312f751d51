#include "codec/adjacency.h"

#include <algorithm>
#include <optional>
#include <string>

#include "codec/edges.h"

namespace clers {
namespace {

constexpr std::uint32_t none = HalfEdge::null_index;

/// Matches half-edges while the faces stream by.
///
/// The edges of a vertex to larger vertices fill one cache line; in the order of most files it is
/// in cache already. An edge lies where the larger vertex puts it, so it is found, or its place is
/// found empty, at the first look and without a branch that depends on which: what irregular meshes
/// would cost here is the branches that nobody can predict. Edges whose place is taken go to the
/// next one, and where the line is full into a list. Where lists turn out long (hubs) the matcher
/// gives up, as it does at an edge that is not one of an oriented manifold.
class StreamingMatcher {
 public:
  StreamingMatcher(const Faces& faces, std::span<HalfEdge> twins, std::uint32_t vertices)
      : faces_(faces),
        org_(faces.org),
        twins_(twins),
        nobody_(static_cast<std::uint32_t>(faces.org.size())),
        cells_(vertices) {}

  bool run() {
    const std::uint32_t n = static_cast<std::uint32_t>(org_.size());
    if (n == 0) return true;
    if (cells_.size() > max_vertices) return false;
    patience_ = 64 + 32 * std::uint64_t(n);
    return faces_.triangles() ? match_triangles(n) : match_polygons(faces_.count());
  }

 private:
  /// Twice the larger end of an edge, and whether its half-edge starts at the smaller one.
  using Key = std::uint32_t;
  static constexpr Key matched = 1u << 31;  ///< both half-edges were met
  static constexpr std::size_t max_vertices = 1u << 30;

  struct Slot {
    Key awaited = none;              ///< of the half-edge to come; none: no edge is here
    std::uint32_t half_edge = none;  ///< that was met
    bool is_free_or(Key key) const { return std::min(awaited ^ key, ~awaited) == 0; }
    bool has_edge_of(Key key) const { return ((awaited ^ key) & ~(matched | 1)) == 0; }
  };
  static constexpr std::uint32_t places = 8;
  struct alignas(64) Cell {
    Slot slots[places];
  };
  static std::uint32_t place(Key key) { return (key >> 1) * 0x9e3779b1u >> 29; }
  struct More {
    Slot slot;
    std::uint32_t next;
  };

  /// Whether faces that follow each other lie far from each other: then each waits for memory.
  bool shuffled(std::uint32_t n) const {
    constexpr std::uint32_t far = 1u << 12, samples = 256;
    if (cells_.size() < 16 * far) return false;
    std::uint32_t count = 0;
    for (std::uint32_t i = 0; i < samples; ++i) {
      const std::uint32_t h =
          static_cast<std::uint32_t>(std::uint64_t(n / 3 - 1) * i / samples) * 3;
      count += std::max(org_[h], org_[h + 3]) - std::min(org_[h], org_[h + 3]) > far;
    }
    return count > samples / 2;
  }

  bool match_triangles(std::uint32_t n) {
    return shuffled(n) ? match_triangles<true>(n) : match_triangles<false>(n);
  }

  template <bool prefetch>
  bool match_triangles(std::uint32_t n) {
    constexpr std::uint32_t ahead = 3 * 12;  // enough faces to hide what memory takes
    const std::uint32_t* const org = org_.data();
    Slot* const slots = cells_.data()->slots;
    HalfEdge* const twins = twins_.data();
    for (std::uint32_t h = 0; h < n; h += 3) {
      if constexpr (prefetch) {
        if (h + ahead < n) {
          const std::uint32_t *const o = &org[h + ahead], low = std::min(o[0], o[1]);
          __builtin_prefetch(&slots[std::size_t(places) * low], 1);
          __builtin_prefetch(&slots[std::size_t(places) * std::min(std::max(o[0], o[1]), o[2])], 1);
          __builtin_prefetch(&slots[std::size_t(places) * std::min(low, o[2])], 1);
        }
      }
      const std::uint32_t a = org[h], b = org[h + 1], c = org[h + 2];
      if (!match(slots, twins, h, a, b) || !match(slots, twins, h + 1, b, c) ||
          !match(slots, twins, h + 2, c, a))
        return false;
    }
    return true;
  }

  bool match_polygons(std::uint32_t n) {
    Slot* const slots = cells_.data()->slots;
    HalfEdge* const twins = twins_.data();
    for (std::uint32_t f = 0; f < n; ++f) {
      const std::uint32_t first = faces_.begin(f), last = faces_.end(f) - 1;
      for (std::uint32_t h = first; h < last; ++h)
        if (!match(slots, twins, h, org_[h], org_[h + 1])) return false;
      if (!match(slots, twins, last, org_[last], org_[first])) return false;
    }
    return true;
  }

  /// Half-edge h from a to b. The first of an edge waits for the second; false if it is a third, or
  /// runs the same way as the first.
  [[gnu::always_inline]] bool match(Slot* slots, HalfEdge* twins, std::uint32_t h, std::uint32_t a,
                                    std::uint32_t b) {
    const bool up = a < b;
    const std::uint32_t low = up ? a : b, high = up ? b : a;
    const Key key = 2 * high + up;
    Slot* slot = &slots[std::size_t(places) * low + place(key)];
    if (!slot->is_free_or(key)) {
      slot = find(low, key);
      if (!slot) return false;
    }
    const std::uint32_t e = slot->half_edge;
    twins[h] = HalfEdge(e);
    twins[std::min(e, nobody_)] = HalfEdge(h);
    *slot = {(key ^ 1) | (~slot->awaited & matched), h};
    return true;
  }

  /// Where the edge is, or goes, whose first place is taken; null if it may not be.
  [[gnu::noinline]] Slot* find(std::uint32_t low, Key key) {
    const auto good = [&](Slot& slot) { return slot.awaited == key ? &slot : nullptr; };
    std::uint32_t at = place(key);
    for (unsigned left = places; left > 0; --left, at = (at + 1) % places) {
      Slot& slot = cells_[low].slots[at];
      if (slot.awaited == none) return &slot;
      if (slot.has_edge_of(key)) return good(slot);
    }
    if (heads_.empty()) heads_.assign(cells_.size(), none);
    for (std::uint32_t i = heads_[low]; i != none; i = more_[i].next) {
      if (more_[i].slot.has_edge_of(key)) return good(more_[i].slot);
      if (patience_-- == 0) return nullptr;
    }
    more_.push_back({Slot(), heads_[low]});
    heads_[low] = static_cast<std::uint32_t>(more_.size() - 1);
    return &more_.back().slot;
  }

  const Faces& faces_;
  std::span<const std::uint32_t> org_;
  std::span<HalfEdge> twins_;
  const std::uint32_t nobody_;        ///< one past the last half-edge: whose twin nobody asks for
  std::vector<Cell> cells_;           ///< by smaller end
  std::vector<std::uint32_t> heads_;  ///< by smaller end: lists of the edges that did not fit
  std::vector<More> more_;
  std::uint64_t patience_ = 0;
};

/// Twins by sorting, which no hub slows down; or the first edge, in the order of the faces, that is
/// not one of an oriented manifold.
std::optional<Failure<Error>> match_sorted(const Faces& faces, std::uint32_t vertex_count,
                                           std::span<HalfEdge> twins) {
  std::fill(twins.begin(), twins.end(), HalfEdge());
  std::uint32_t first = none;
  std::size_t faces_there = 0;
  for_each_edge(faces, vertex_count, [&](std::span<const std::uint32_t> sides) {
    const bool bad =
        sides.size() > 2 || (sides.size() == 2 && faces.org[sides[0]] == faces.org[sides[1]]);
    if (bad && sides[0] < first) {
      first = sides[0];
      faces_there = sides.size();
    } else if (!bad && sides.size() == 2) {
      twins[sides[0]] = HalfEdge(sides[1]);
      twins[sides[1]] = HalfEdge(sides[0]);
    }
  });
  if (first == none) return std::nullopt;
  const std::string edge = "the edge of vertices " + std::to_string(faces.org[first]) + " and " +
                           std::to_string(faces.org[faces.next(first)]);
  if (faces_there > 2)
    return fail(ErrorCode::nonmanifold_edge, Place::face, faces.face(first),
                edge + " has " + std::to_string(faces_there) + " faces, expected at most 2");
  return fail(
      ErrorCode::nonorientable, Place::face, faces.face(first),
      edge + " is run along in the same direction by its two faces, expected opposite ones");
}

/// Corners of the fan that contains a corner, both ways round.
std::uint64_t fan_size(const Faces& faces, std::span<const HalfEdge> twins, std::uint32_t start) {
  std::uint64_t count = 0;
  std::uint32_t h = start;
  do {
    ++count;
    h = twins[faces.prev(h)].index();
  } while (h != none && h != start);
  if (h == start) return count;
  for (h = twins[start].index(); h != none; h = twins[faces.next(h)].index()) ++count;
  return count;
}

}  // namespace

Expected<std::vector<HalfEdge>> find_twins(const Faces& faces, std::uint32_t vertex_count) {
  std::vector<HalfEdge> twins(faces.org.size() + 1);
  const bool matched = StreamingMatcher(faces, twins, vertex_count).run();
  twins.pop_back();
  if (matched) return twins;
  if (auto failure = match_sorted(faces, vertex_count, twins)) return *failure;
  return twins;
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

}  // namespace clers
