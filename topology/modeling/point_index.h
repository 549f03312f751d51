// Points that are near others.
#ifndef CLERS_TOPOLOGY_MODELING_POINT_INDEX_H
#define CLERS_TOPOLOGY_MODELING_POINT_INDEX_H

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "topology/modeling/empty_ball.h"

namespace clers::internal {

/// A k-d tree over points that stay where they are, and of each the nearest others.
class PointIndex {
 public:
  /// The nearest k others of each point, nearest first: fewer if there are not so many.
  /// Cost: O(n (k + log n)).
  PointIndex(std::span<const Place> points, std::uint32_t k);
  ~PointIndex();

  std::span<const std::uint32_t> near(std::uint32_t p) const {
    return std::span(near_).subspan(p * std::size_t{k_}, k_);
  }
  /// Some of the nearest points of a place, nearest first, at most count of them.
  std::vector<std::uint32_t> nearest(const Place& at, std::uint32_t count) const;
  /// All points nearer to a place than the radius, in no order that is promised.
  void within(const Place& at, double radius, std::vector<std::uint32_t>& found) const;

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
  std::uint32_t k_;
  std::vector<std::uint32_t> near_;
};

}  // namespace clers::internal

#endif
