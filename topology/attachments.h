// How a surface reaches the containers that follow its edits (element_data.h).
// Internal: installed because surface.h needs it, no part of the API.
#ifndef CLERS_TOPOLOGY_ATTACHMENTS_H
#define CLERS_TOPOLOGY_ATTACHMENTS_H

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <clers/topology/export.h>
#include <clers/topology/ids.h>

namespace clers {
namespace CLERS_VISIBLE internal {

class Attachments;

/// What values are kept by.
enum class DataKind : std::uint8_t { vertex, face, half_edge };

constexpr DataKind kind_of(Vertex) {
  return DataKind::vertex;
}
constexpr DataKind kind_of(Face) {
  return DataKind::face;
}
constexpr DataKind kind_of(HalfEdge) {
  return DataKind::half_edge;
}

/// Where a value goes when ids are given to other elements.
struct MovedValue {
  std::uint32_t to = 0;
  std::uint32_t from = 0xffffffffu;  ///< none: `to` gets the initial value
};

/// A container of values by id. Only `reserve` may fail; a surface calls it before it changes
/// anything.
class AttachedData {
 public:
  virtual void reserve(std::size_t ids) = 0;
  virtual void resize(std::size_t ids) noexcept = 0;  ///< new ids get the initial value
  virtual void reset(std::uint32_t id) noexcept = 0;
  virtual void copy(std::uint32_t to, std::uint32_t from) noexcept = 0;
  /// All at once; at most max_moved of them.
  virtual void move(const MovedValue* moved, std::size_t count) noexcept = 0;
  static constexpr std::size_t max_moved = 12;

  bool attached() const { return list_ != nullptr; }

 protected:
  explicit AttachedData(DataKind kind) : kind_(kind) {}
  AttachedData(const AttachedData&) = delete;
  AttachedData& operator=(const AttachedData&) = delete;
  ~AttachedData() { detach(); }

  Attachments* list() const { return list_; }
  inline void attach(Attachments& list);
  inline void detach() noexcept;
  /// Takes the place of another, which is attached no longer.
  inline void replace(AttachedData& other) noexcept;

 private:
  friend class Attachments;
  Attachments* list_ = nullptr;
  DataKind kind_;
};

/// The containers attached to a surface. A copy of a surface has none; a surface that is moved
/// takes its containers along; one that is assigned to leaves those it had, which keep their values
/// and follow it no longer.
class Attachments {
 public:
  Attachments() = default;
  Attachments(const Attachments&) noexcept {}
  Attachments(Attachments&& other) noexcept { take(other); }
  Attachments& operator=(const Attachments& other) noexcept {
    if (this != &other) release();
    return *this;
  }
  Attachments& operator=(Attachments&& other) noexcept {
    if (this == &other) return *this;
    release();
    take(other);
    return *this;
  }
  ~Attachments() { release(); }

  /// Is there any? Asked first by operators, which otherwise need nothing of all this.
  bool any() const { return any_; }

  void reserve(DataKind kind, std::size_t ids) {
    each(kind, [&](AttachedData& data) { data.reserve(ids); });
  }
  void resize(DataKind kind, std::size_t ids) noexcept {
    each(kind, [&](AttachedData& data) { data.resize(ids); });
  }
  /// `to` is new, or is to be as if it were: a copy of `from`, or at the initial value.
  template <class IdType>
  void make(IdType to, IdType from) noexcept {
    each(kind_of(to), [&](AttachedData& data) {
      if (from)
        data.copy(to.index(), from.index());
      else
        data.reset(to.index());
    });
  }
  void move_sides(const MovedValue* moved, std::size_t count) noexcept {
    each(DataKind::half_edge, [&](AttachedData& data) { data.move(moved, count); });
  }

 private:
  friend class AttachedData;

  template <class Call>
  void each(DataKind kind, Call call) {
    for (AttachedData* data : all_)
      if (data->kind_ == kind) call(*data);
  }
  void release() noexcept {
    for (AttachedData* data : all_) data->list_ = nullptr;
    all_.clear();
    any_ = false;
  }
  void take(Attachments& other) noexcept {
    all_.swap(other.all_);
    std::swap(any_, other.any_);
    for (AttachedData* data : all_) data->list_ = this;
  }

  std::vector<AttachedData*> all_;
  bool any_ = false;
};

inline void AttachedData::attach(Attachments& list) {
  list.all_.push_back(this);
  list.any_ = true;
  list_ = &list;
}
inline void AttachedData::detach() noexcept {
  if (!list_) return;
  std::erase(list_->all_, this);
  list_->any_ = !list_->all_.empty();
  list_ = nullptr;
}
inline void AttachedData::replace(AttachedData& other) noexcept {
  detach();
  list_ = other.list_;
  if (list_) *std::find(list_->all_.begin(), list_->all_.end(), &other) = this;
  other.list_ = nullptr;
}

}  // namespace internal
}  // namespace clers

#endif
