// Disjoint sets of numbers, which are united but never parted (Galler and Fischer 1964), with path
// halving. Knows nothing of what is numbered.
#ifndef CLERS_CODEC_BASE_DISJOINT_SETS_H
#define CLERS_CODEC_BASE_DISJOINT_SETS_H

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace clers::internal {

/// The least number of a set stands for it. Cost: of both operations O(log n) amortised, nearly
/// constant in practice.
class DisjointSets {
 public:
  /// Each of 0 .. count - 1 in a set of its own.
  explicit DisjointSets(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), 0u);
  }

  std::uint32_t find(std::uint32_t v) {
    while (parent_[v] != v) v = parent_[v] = parent_[parent_[v]];
    return v;
  }
  void unite(std::uint32_t v, std::uint32_t w) {
    if (parent_[v] == parent_[w]) return;
    const std::uint32_t a = find(v), b = find(w);
    parent_[std::max(a, b)] = std::min(a, b);
  }

  /// find() of each.
  std::vector<std::uint32_t> all() && {
    for (std::uint32_t& p : parent_) p = parent_[p];
    return std::move(parent_);
  }

 private:
  std::vector<std::uint32_t> parent_;  ///< at most the number itself
};

/// Sets whose members are each other's equals or opposites, and have weights.
class SignedSets {
 public:
  /// The next number, in a set of its own.
  void add(std::uint32_t weight) {
    parent_.push_back(static_cast<std::uint32_t>(parent_.size()));
    opposite_.push_back(false);
    weight_.push_back(weight);
  }

  struct Member {
    std::uint32_t set;
    bool opposite;  ///< to what stands for the set
  };
  Member find(std::uint32_t v) {
    bool opposite = false;
    while (parent_[v] != v) {  // path halving: the grandparent of v becomes its parent
      const std::uint32_t p = parent_[v];
      opposite_[v] ^= opposite_[p];
      parent_[v] = parent_[p];
      opposite ^= opposite_[v];
      v = parent_[v];
    }
    return {v, opposite};
  }

  /// Makes v and w opposites, or equals; false if they are known to be the other.
  bool unite(std::uint32_t v, std::uint32_t w, bool opposites) {
    Member a = find(v), b = find(w);
    if (a.set == b.set) return (a.opposite != b.opposite) == opposites;
    const bool opposite = (a.opposite != b.opposite) != opposites;
    if (weight_[a.set] < weight_[b.set]) std::swap(a, b);
    parent_[b.set] = a.set;
    opposite_[b.set] = opposite;
    weight_[a.set] += weight_[b.set];
    return true;
  }

  std::uint32_t count() const { return static_cast<std::uint32_t>(parent_.size()); }  ///< numbers
  /// Of all members of a set.
  std::uint64_t weight(std::uint32_t set) const { return weight_[set]; }

 private:
  std::vector<std::uint32_t> parent_;
  std::vector<std::uint8_t> opposite_;  ///< to the parent; 0 at a root
  std::vector<std::uint64_t> weight_;   ///< of the set, at its root
};

}  // namespace clers::internal

#endif
