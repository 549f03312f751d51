#include "codec/soup/polygons.h"

#include <algorithm>

namespace clers::internal {
namespace {

/// Edgebreaker's walk (edgebreaker.h) over polygons, for the order alone: what it makes is then
/// encoded as any triangulated surface, and walked in this same order again.
class PolygonWalk {
 public:
  PolygonWalk(const Faces& faces, std::span<const HalfEdge> twins, std::uint32_t vertex_count)
      : faces_(faces),
        twins_(twins),
        open_(faces.org.size()),
        done_(faces.count()),
        visited_(vertex_count),
        side_(faces.org.size()) {
    const std::size_t triangles = faces.org.size() - 2 * std::size_t(faces.count());
    result_.corners.reserve(3 * triangles);
    result_.twins.resize(3 * triangles);
    result_.gates.reserve(faces.count());
  }

  Triangulation run() {
    for (std::uint32_t h = 0; h < twins_.size(); ++h) open_[h] = !twins_[h];
    for (const std::uint32_t start : curves_by_length())
      if (!done_[faces_.face(start)]) component(start);
    for (std::uint32_t f = 0; f < faces_.count(); ++f) {
      if (done_[f]) continue;
      const std::uint32_t gate = faces_.begin(f);
      open_[gate] = open_[twins_[gate].index()] = true;
      visited_[faces_.org[gate]] = visited_[faces_.org[faces_.next(gate)]] = true;
      component(gate);
    }
    for (std::uint32_t h = 0; h < twins_.size(); ++h)
      if (twins_[h]) result_.twins[side_[h].index()] = side_[twins_[h].index()];
    return std::move(result_);
  }

 private:
  static constexpr std::uint32_t none = HalfEdge::null_index;

  std::uint32_t sym(std::uint32_t h) const { return open_[h] ? none : twins_[h].index(); }

  /// Smallest half-edge of every boundary curve, longest curve first. Marks the vertices on them.
  std::vector<std::uint32_t> curves_by_length() {
    struct BoundaryCurve {
      std::uint64_t length;
      std::uint32_t first;
    };
    std::vector<BoundaryCurve> curves;
    std::vector<bool> seen(twins_.size());
    for (std::uint32_t first = 0; first < twins_.size(); ++first) {
      if (!open_[first] || seen[first]) continue;
      std::uint64_t length = 0;
      std::uint32_t h = first;
      do {
        seen[h] = true;
        visited_[faces_.org[h]] = true;
        ++length;
        h = faces_.next(h);
        while (!open_[h]) h = faces_.next(twins_[h].index());
      } while (h != first);
      curves.push_back({length, first});
    }
    std::stable_sort(
        curves.begin(), curves.end(),
        [](const BoundaryCurve& a, const BoundaryCurve& b) { return a.length > b.length; });
    std::vector<std::uint32_t> firsts;
    for (const BoundaryCurve& c : curves) firsts.push_back(c.first);
    return firsts;
  }

  void component(std::uint32_t gate) {
    std::vector<std::uint32_t> aside;
    while (gate != none) {
      gate = polygon(gate, aside);
      while (gate == none && !aside.empty()) {
        if (!done_[faces_.face(aside.back())]) gate = aside.back();
        aside.pop_back();
      }
    }
  }

  /// Takes a polygon away triangle by triangle. Returns the next gate; none after an E.
  std::uint32_t polygon(std::uint32_t gate, std::vector<std::uint32_t>& aside) {
    const std::uint32_t f = faces_.face(gate), last_side = faces_.next(gate);
    const std::uint32_t b = faces_.org[last_side];
    done_[f] = true;
    result_.gates.push_back(gate);
    std::uint32_t a = faces_.org[gate], next = none;
    HalfEdge diagonal;
    for (std::uint32_t apex = faces_.prev(gate);; apex = faces_.prev(apex)) {
      const Face t(static_cast<std::uint32_t>(result_.corners.size() / 3));
      const std::uint32_t v = faces_.org[apex];
      result_.corners.insert(result_.corners.end(), {a, b, v});
      if (diagonal) {
        result_.twins[half_edge(t, 0).index()] = diagonal;
        result_.twins[diagonal.index()] = half_edge(t, 0);
      } else {
        side_[gate] = half_edge(t, 0);
      }
      side_[apex] = half_edge(t, 2);
      const bool last = faces_.prev(apex) == last_side;
      const std::uint32_t left = sym(apex);
      const std::uint32_t right = last ? sym(last_side) : none;
      if (left != none) open_[left] = true;
      if (right != none) open_[right] = true;
      if (!visited_[v]) {  // C
        visited_[v] = true;
        next = right;
      } else if (last && right == none) {  // R or E
        next = left;
      } else {  // S or L
        if (left != none) aside.push_back(left);
        next = right;
      }
      if (last) {
        side_[last_side] = half_edge(t, 1);
        return next;
      }
      diagonal = half_edge(t, 1);
      a = v;
    }
  }

  const Faces& faces_;
  std::span<const HalfEdge> twins_;
  std::vector<bool> open_;             ///< half-edges on the boundary of what is left
  std::vector<bool> done_;             ///< faces
  std::vector<std::uint8_t> visited_;  ///< vertices on that boundary
  std::vector<HalfEdge> side_;         ///< of a triangle that is made: each half-edge of a polygon
  Triangulation result_;
};

}  // namespace

Triangulation triangulate(const Faces& faces, std::span<const HalfEdge> twins,
                          std::uint32_t vertex_count) {
  return PolygonWalk(faces, twins, vertex_count).run();
}

}  // namespace clers::internal
