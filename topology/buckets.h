// Numbers sorted by keys that are numbers too: a counting sort. Corners by vertex, mostly, though
// this knows of neither.
#ifndef CLERS_TOPOLOGY_BUCKETS_H
#define CLERS_TOPOLOGY_BUCKETS_H

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

namespace clers::internal {

/// Cost: two passes over items, one over keys; 4 bytes for each of both.
class Buckets {
 public:
  /// 0 .. count - 1, those of one key together and ascending. Each key(item) is below `keys`.
  template <class Key>
  Buckets(std::uint32_t count, std::size_t keys, Key key) : begin_(keys + 1), items_(count) {
    fill([](std::uint32_t i) { return i; }, key);
  }
  /// The same of other items, which keep their order within each bucket.
  template <class Key>
  Buckets(std::span<const std::uint32_t> items, std::size_t keys, Key key)
      : begin_(keys + 1), items_(items.size()) {
    fill([items](std::uint32_t i) { return items[i]; }, key);
  }

  std::span<const std::uint32_t> operator[](std::uint32_t key) const {
    return std::span(items_).subspan(begin_[key], begin_[key + std::size_t(1)] - begin_[key]);
  }

  /// All items, by key.
  std::vector<std::uint32_t> items() && { return std::move(items_); }

 private:
  template <class Item, class Key>
  void fill(Item item, Key key) {
    const std::uint32_t count = static_cast<std::uint32_t>(items_.size());
    for (std::uint32_t i = 0; i < count; ++i) ++begin_[key(item(i))];
    std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
    for (std::uint32_t i = count; i-- > 0;) items_[--begin_[key(item(i))]] = item(i);
  }

  std::vector<std::uint32_t> begin_;  ///< of each bucket, and the number of items
  std::vector<std::uint32_t> items_;
};

}  // namespace clers::internal

#endif
