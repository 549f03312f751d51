// The k-d tree is nanoflann's.
#include "topology/modeling/point_index.h"

#include <algorithm>
#include <nanoflann.hpp>

namespace clers::internal {
namespace {

struct Cloud {
  std::span<const Place> points;

  std::size_t kdtree_get_point_count() const { return points.size(); }
  double kdtree_get_pt(std::size_t i, std::size_t axis) const { return points[i][axis]; }
  template <class Box>
  bool kdtree_get_bbox(Box&) const {
    return false;
  }
};

}  // namespace

struct PointIndex::Tree {
  using Index = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Cloud>,
                                                    Cloud, 3, std::uint32_t>;
  explicit Tree(std::span<const Place> points) : cloud{points}, index(3, cloud, {10}) {}

  Cloud cloud;
  Index index;
};

PointIndex::PointIndex(std::span<const Place> points, std::uint32_t k)
    : tree_(std::make_unique<Tree>(points)),
      k_(points.empty() ? 0
                        : static_cast<std::uint32_t>(std::min<std::size_t>(k, points.size() - 1))),
      near_(points.size() * k_) {
  std::vector<std::uint32_t> found(k_ + 1);
  std::vector<double> squared(k_ + 1);
  for (std::size_t p = 0; k_ > 0 && p < points.size(); ++p) {
    const std::size_t n =
        tree_->index.knnSearch(points[p].data(), k_ + 1, found.data(), squared.data());
    std::uint32_t* to = near_.data() + p * k_;
    for (std::size_t i = 0, kept = 0; i < n && kept < k_; ++i)
      if (found[i] != p) to[kept++] = found[i];
  }
}

PointIndex::~PointIndex() = default;

std::vector<std::uint32_t> PointIndex::nearest(const Place& at, std::uint32_t count) const {
  std::vector<std::uint32_t> found(count);
  std::vector<double> squared(count);
  found.resize(tree_->index.knnSearch(at.data(), count, found.data(), squared.data()));
  return found;
}

void PointIndex::within(const Place& at, double radius, std::vector<std::uint32_t>& found) const {
  std::vector<std::pair<std::uint32_t, double>> hits;
  nanoflann::SearchParams unsorted;
  unsorted.sorted = false;
  tree_->index.radiusSearch(at.data(), radius * radius, hits, unsorted);
  found.clear();
  for (const auto& hit : hits) found.push_back(hit.first);
}

}  // namespace clers::internal
