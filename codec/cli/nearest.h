// Which point of some triangles is nearest.
#ifndef CLERS_CODEC_CLI_NEAREST_H
#define CLERS_CODEC_CLI_NEAREST_H

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "codec/cli/vec3.h"

namespace clers::cli {

/// A triangle as a set of points, or, where corners coincide, a segment or a point.
using Triangle = std::array<Vec3, 3>;

/// A point of a triangle: its weights sum up to 1, none is negative.
struct PointOfTriangle {
  std::array<double, 3> weights{1, 0, 0};
  Vec3 at;
  double distance2 = std::numeric_limits<double>::infinity();  ///< squared, from what was asked for
};

/// The point of a triangle nearest to p.
PointOfTriangle nearest_of(const Triangle& triangle, const Vec3& p);
/// The same of those in the plane through p with this normal; none if the plane misses the
/// triangle.
std::optional<PointOfTriangle> nearest_in_plane(const Triangle& triangle, const Vec3& p,
                                                const Vec3& normal);

/// Triangles sorted by place, in an R-tree of their boxes.
class Nearest {
 public:
  /// Preconditions: finite coordinates, below 1e100. Cost: O(n log n), some 80 bytes a triangle.
  explicit Nearest(std::span<const Triangle> triangles);
  Nearest(Nearest&&) noexcept;
  ~Nearest();

  struct Found : PointOfTriangle {
    std::uint32_t triangle = 0;
  };

  /// What is looked for: a point near `p`.
  struct Query {
    Vec3 p;
    /// Only of triangles whose normals are within a right angle of this one; null: of all. A
    /// segment or a point has no normal and is left out unless this is null.
    Vec3 facing = {};
    /// Only of the plane through p with this normal; null: of all of space.
    Vec3 plane = {};
  };
  /// The nearest, that of the lowest triangle if several are; none if there is none such. Cost:
  /// about O(log n).
  std::optional<Found> operator()(const Query& query) const;

 private:
  struct Tree;
  std::vector<Triangle> triangles_;
  std::unique_ptr<Tree> tree_;
};

}  // namespace clers::cli

#endif
