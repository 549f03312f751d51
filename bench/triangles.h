// What simplification is measured by: triangles in space, their shapes, what they are joined to,
// and how far one surface is from another. None of it is the project's own geometry.
#ifndef CLERS_BENCH_TRIANGLES_H
#define CLERS_BENCH_TRIANGLES_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "bench/input.h"

namespace clers::bench {

struct Triangles {
  std::vector<std::array<double, 3>> points;
  std::vector<std::uint32_t> corners;  ///< 3 for each triangle

  std::size_t count() const { return corners.size() / 3; }
};
Triangles triangles_of(const Input& input);

/// Of the circle within to the one around, twice: 1 if equilateral, 0 if flat. Ascending.
std::vector<double> radius_ratios(const Triangles& mesh);

/// Counted by union of vertices, by boundary edges one after the other, and by Euler's formula.
struct Joined {
  bool manifold = false;  ///< oriented, at edges and vertices; nothing else is counted if not
  std::int64_t components = 0, curves = 0, genus = 0;

  bool operator==(const Joined&) const = default;
};
Joined joined(const Triangles& mesh);
/// Of triangles that may have two edges between two vertices, so that it takes twins to say which
/// are joined: by half-edge, no_twin on the boundary. Precondition: they make a manifold.
inline constexpr std::uint32_t no_twin = 0xffffffffu;
Joined joined(const Triangles& mesh, const std::vector<std::uint32_t>& twins);

/// Of the box around the points.
double diagonal(const Triangles& mesh);

/// A surface from which distances are asked, by CGAL's tree of boxes.
class Target {
 public:
  /// The triangles must outlive this. Those without area are left out.
  explicit Target(const Triangles& mesh);
  ~Target();

  struct Distance {
    double rms = 0, greatest = 0;
  };
  /// Of so many points of the other surface, evenly spread over its area at random.
  Distance from(const Triangles& other, std::size_t samples) const;

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

}  // namespace clers::bench

#endif
