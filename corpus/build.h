// What the generators share: making a Mesh of points and corners, and finding neighbours in one.
#ifndef CLERS_CORPUS_BUILD_H
#define CLERS_CORPUS_BUILD_H

#include <array>
#include <cstdint>
#include <vector>

#include "codec/mesh.h"

namespace clers::corpus {

using Point = std::array<float, 3>;

/// The positions of a mesh that is being made.
class Points {
 public:
  explicit Points(std::size_t expected = 0) { list_.reserve(expected); }

  std::uint32_t add(double x, double y, double z) {
    list_.push_back({static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)});
    return static_cast<std::uint32_t>(list_.size() - 1);
  }

  std::uint32_t size() const { return static_cast<std::uint32_t>(list_.size()); }
  const std::vector<Point>& list() const { return list_; }

 private:
  std::vector<Point> list_;
};

Mesh make_mesh(const Points& points, std::vector<std::uint32_t> corners);

/// The positions of a mesh made here. Precondition: it has float32 positions of three components.
std::vector<Point> points_of(const Mesh& mesh);

/// Two triangles for the quadrilateral a b c d (counterclockwise), split from a to c.
///
///     d---c
///     | / |
///     a---b
///
/// One argument, for the elements of a list are evaluated in order and arguments are not.
inline void add_quad(std::vector<std::uint32_t>& corners, const std::array<std::uint32_t, 4>& q) {
  corners.insert(corners.end(), {q[0], q[1], q[2], q[0], q[2], q[3]});
}

inline constexpr std::uint32_t no_twin = 0xffffffffu;

constexpr std::uint32_t next_corner(std::uint32_t h) {
  return h % 3 == 2 ? h - 2 : h + 1;
}
constexpr std::uint32_t prev_corner(std::uint32_t h) {
  return h % 3 == 0 ? h + 2 : h - 1;
}

/// For each half-edge (h runs from corner h to the next of its face) the one that runs back, or
/// no_twin. Precondition: triangles; no two half-edges run from and to the same vertices. Cost:
/// linear in the faces times the mean valence.
std::vector<std::uint32_t> twins_of(const std::vector<std::uint32_t>& corners,
                                    std::uint32_t vertex_count);

/// The values of `attribute` at `indices`, in that order.
Attribute gather(const Attribute& attribute, const std::vector<std::uint32_t>& indices);

}  // namespace clers::corpus

#endif
