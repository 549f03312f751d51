// Hands out ids and takes them back: the last one freed is the next one given.
// Internal: installed because surface.h needs it, no part of the API.
#ifndef CLERS_TOPOLOGY_ID_POOL_H
#define CLERS_TOPOLOGY_ID_POOL_H

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <clers/topology/export.h>

namespace CLERS_VISIBLE clers {
struct SurfacePeer;  // corrupts arrays, in tests
}

namespace clers {
namespace CLERS_VISIBLE internal {

/// Grows the capacity of `v` geometrically so that `extra` more elements fit without allocation.
/// `inline` keeps it hidden in shared libraries, though its namespace is visible.
template <class T>
inline void reserve_more(std::vector<T>& v, std::size_t extra) {
  if (v.capacity() - v.size() < extra) v.reserve(std::max(v.size() + extra, 2 * v.capacity()));
}

/// The ids 0 .. size()-1, some of them free. `take` and `give` never allocate: `room_to_give` did.
template <class IdType>
class IdPool {
 public:
  std::uint32_t size() const { return size_; }
  std::uint32_t free_count() const { return static_cast<std::uint32_t>(free_.size()); }
  const std::vector<IdType>& free_ids() const { return free_; }

  /// How many of the next `count` ids will be new ones, for which the caller's arrays must grow.
  std::uint32_t growth(std::uint32_t count) const {
    return count > free_count() ? count - free_count() : 0;
  }

  /// Makes room for giving `count` ids back.
  void room_to_give(std::uint32_t count) { reserve_more(free_, count); }

  /// The ids 0 .. size-1, none of them free.
  void fill(std::uint32_t size) {
    free_.clear();
    size_ = size;
  }

  IdType take() {
    if (free_.empty()) return IdType(size_++);
    const IdType id = free_.back();
    free_.pop_back();
    return id;
  }

  void give(IdType id) { free_.push_back(id); }

 private:
  friend struct clers::SurfacePeer;
  std::vector<IdType> free_;
  std::uint32_t size_ = 0;
};

}  // namespace internal
}  // namespace clers

#endif
