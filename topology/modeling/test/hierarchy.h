// An oracle for multi-triangulations: all of the hierarchy, explicitly, and nothing of the mesh.
#ifndef CLERS_TOPOLOGY_MODELING_TEST_HIERARCHY_H
#define CLERS_TOPOLOGY_MODELING_TEST_HIERARCHY_H

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include "topology/surface.h"

namespace clers::test {

/// A point of the base, exactly: a vertex, a point of an edge or one inside a face. Corners 0, 1
/// and 2 of a face are at (0, 0), (unit, 0) and (0, unit).
struct Spot {
  enum Kind : std::uint32_t { vertex, edge, face };
  Kind kind = vertex;
  std::uint32_t id = 0, x = 0, y = 0;

  static constexpr std::uint32_t unit = std::uint32_t{1} << 31;
  friend auto operator<=>(const Spot&, const Spot&) = default;
};
struct SpotHash {
  std::size_t operator()(const Spot& s) const {
    std::uint64_t h = s.id * 3u + s.kind;
    for (const std::uint32_t part : {s.x, s.y}) {
      h = (h + part) * 0x9e3779b97f4a7c15u;
      h ^= h >> 29;
    }
    return static_cast<std::size_t>(h);
  }
};

/// A place in a base face.
struct Place {
  std::uint32_t x = 0, y = 0;
  friend bool operator==(const Place&, const Place&) = default;
};

/// A binary tree of triangles for each base face. The triangle (p0 p1 p2) is split at the middle m
/// of p1-p2 into (m p0 p1) and (m p2 p0). Which triangles meet at an edge is looked up by its
/// middle, for which there is one edge only; that middle is also the vertex that the edge's split
/// makes. Program 1 and its inverse are recursions on that.
class Hierarchy {
 public:
  explicit Hierarchy(const Surface& base);

  /// Splits the edge with this middle and what must be split first.
  void refine(const Spot& middle);
  /// Takes a vertex back, and all that cannot be without it.
  void simplify(const Spot& vertex);
  /// Of the last call.
  const std::vector<Spot>& changed() const { return changed_; }

  std::size_t leaves() const { return leaves_; }
  std::size_t vertices() const { return vertices_; }

  Spot spot(std::uint32_t base, Place at) const;
  static Place between(Place a, Place b);
  /// How many leaves are at the edge with this middle; none if there is no such edge now.
  unsigned sides(const Spot& middle) const;
  /// The level of a vertex that was made, if it is there.
  std::optional<unsigned> level(const Spot& vertex) const;
  /// Which leaf has these corners in this order, if one has.
  std::optional<std::uint32_t> leaf(std::uint32_t base, const std::array<Place, 3>& corners) const;

 private:
  static constexpr std::uint32_t none = 0xffffffffu;
  struct Triangle {
    std::uint32_t base = 0, level = 0;
    std::array<Place, 3> at;
    std::uint32_t parts = none;  // the first of two, which stay when they are welded
    bool is_split = false;
  };
  struct Edge {
    std::array<std::uint32_t, 2> triangles{none, none};  // leaves; or those that it splits
    bool is_split = false;
  };

  Spot middle(const Triangle& t, unsigned edge) const;
  void add(const Spot& edge, std::uint32_t t);
  void replace(const Spot& edge, std::uint32_t t, std::uint32_t by);
  void split(std::uint32_t t);
  void weld(std::uint32_t t);
  void refine_all(const Spot& edge);
  void simplify_all(const Spot& vertex);

  std::vector<Vertex> org_;
  std::vector<HalfEdge> twin_;
  std::vector<Triangle> triangles_;
  std::unordered_map<Spot, Edge, SpotHash> edges_;
  std::vector<Spot> changed_;
  std::size_t leaves_ = 0, vertices_ = 0;
};

}  // namespace clers::test

#endif
