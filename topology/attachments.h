// How a surface reaches the containers that follow its edits (element_data.h). Internal: no part of
// the API, though surface.h must include it.
#ifndef CLERS_TOPOLOGY_ATTACHMENTS_H
#define CLERS_TOPOLOGY_ATTACHMENTS_H

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace clers::internal {

class Attachments;

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
  AttachedData() = default;
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
};

/// The containers attached to one kind of id. A copy of a surface has none; a surface that is moved
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

  bool empty() const { return all_.empty(); }
  void reserve(std::size_t ids) {
    for (AttachedData* data : all_) data->reserve(ids);
  }
  void resize(std::size_t ids) noexcept {
    for (AttachedData* data : all_) data->resize(ids);
  }
  /// `to` is new: a copy of `from`, or at the initial value.
  template <class IdType>
  void make(IdType to, IdType from) noexcept {
    for (AttachedData* data : all_) {
      if (from)
        data->copy(to.index(), from.index());
      else
        data->reset(to.index());
    }
  }
  void move(const MovedValue* moved, std::size_t count) noexcept {
    for (AttachedData* data : all_) data->move(moved, count);
  }

 private:
  friend class AttachedData;

  void release() noexcept {
    for (AttachedData* data : all_) data->list_ = nullptr;
    all_.clear();
  }
  void take(Attachments& other) noexcept {
    all_.swap(other.all_);
    for (AttachedData* data : all_) data->list_ = this;
  }

  std::vector<AttachedData*> all_;
};

inline void AttachedData::attach(Attachments& list) {
  list.all_.push_back(this);
  list_ = &list;
}
inline void AttachedData::detach() noexcept {
  if (list_) std::erase(list_->all_, this);
  list_ = nullptr;
}
inline void AttachedData::replace(AttachedData& other) noexcept {
  detach();
  list_ = other.list_;
  if (list_) *std::find(list_->all_.begin(), list_->all_.end(), &other) = this;
  other.list_ = nullptr;
}

}  // namespace clers::internal

#endif
