// Values by vertex, face or half-edge that stay with their elements when a surface is edited.
#ifndef CLERS_TOPOLOGY_ELEMENT_DATA_H
#define CLERS_TOPOLOGY_ELEMENT_DATA_H

#include <type_traits>
#include <utility>
#include <vector>

#include <clers/topology/export.h>
#include <clers/topology/surface.h>

namespace CLERS_VISIBLE clers {

/// A T for each id of one kind, attached to a surface: it grows with the surface, and every
/// operator keeps the values where they belong.
///
///     VertexData<double> area(surface, 0.);
///     area[v] = 1;
///     surface.split(h, p);   // area[v] is still 1, and the new vertex has 0.
///
/// What elements have after an operator (surface.h):
///
///     vertices     made by create or split  the initial value
///                  copies made by unglue    that of the vertex they are copies of
///                  merged by glue           that of h0's end, as its point
///     faces        made by create           the initial value
///                  made by split            that of the face they are parts of
///     half-edges   new sides                the initial value
///                  old ones                 their own, by whatever id a flip, split or weld calls them
///                  halves of a split edge   that of the whole edge's side
///                  a welded edge            that of its half at the origin of Welded::at
///
/// A half-edge is a side of a face, not a corner: of values by corner `Change::slots` says what
/// moved. Values that depend on where elements are made, such as positions, are set afterwards, or
/// by an observer (follow.h). The value of a dead id is unspecified.
///
/// Cost: that of one virtual call for every element made or moved; a surface without containers
/// pays a comparison. Memory: a T for each id below the limit. Attaching a container is an edit of
/// the surface where threads are concerned.
///
/// Lifetime: either may end first. A container whose surface is gone, or was assigned another one,
/// keeps its values and follows no longer (`attached`). A copy of a surface has no containers; a
/// surface that is moved takes its containers along. A copy of a container follows the same
/// surface.
template <class IdType, class T>
class ElementData final : private internal::AttachedData {
  static_assert(std::is_nothrow_copy_constructible_v<T> && std::is_nothrow_copy_assignable_v<T>,
                "Operators copy values where nothing may fail any more: keep what may throw when "
                "it is copied in an array of your own, and its index here.");

 public:
  using reference = typename std::vector<T>::reference;
  using const_reference = typename std::vector<T>::const_reference;

  /// Throws std::bad_alloc, having changed nothing, if there is no memory. Cost: O(ids).
  explicit ElementData(Surface& surface, T initial = T())
      : AttachedData(kind),
        initial_(initial),
        values_(limit(surface), initial),
        moving_(most_moved, initial) {
    attach(surface.data_);
  }
  ElementData(const ElementData& other)
      : AttachedData(kind),
        initial_(other.initial_),
        values_(other.values_),
        moving_(other.moving_) {
    if (other.attached()) attach(*other.list());
  }
  ElementData(ElementData&& other) noexcept
      : AttachedData(kind),
        initial_(other.initial_),
        values_(std::move(other.values_)),
        moving_(std::move(other.moving_)) {
    replace(other);
  }
  ElementData& operator=(const ElementData& other) {
    if (this != &other) *this = ElementData(other);
    return *this;
  }
  ElementData& operator=(ElementData&& other) noexcept {
    if (this == &other) return *this;
    initial_ = other.initial_;
    values_ = std::move(other.values_);
    moving_ = std::move(other.moving_);
    replace(other);
    return *this;
  }

  /// Precondition: the id is below the surface's limit.
  reference operator[](IdType id) { return values_[id.index()]; }
  const_reference operator[](IdType id) const { return values_[id.index()]; }

  /// By id, those of dead ones too.
  const std::vector<T>& values() const { return values_; }
  /// Does it still follow a surface?
  using internal::AttachedData::attached;

 private:
  static std::size_t limit(const Surface& surface) {
    if constexpr (kind == internal::DataKind::vertex)
      return surface.vertex_limit();
    else if constexpr (kind == internal::DataKind::face)
      return surface.face_limit();
    else
      return surface.half_edge_limit();
  }

  void reserve(std::size_t ids) override { values_.reserve(ids); }
  void resize(std::size_t ids) noexcept override { values_.resize(ids, initial_); }
  void reset(std::uint32_t id) noexcept override { values_[id] = initial_; }
  void copy(std::uint32_t to, std::uint32_t from) noexcept override {
    values_[to] = static_cast<T>(values_[from]);
  }
  void move(const internal::MovedValue* moved, std::size_t count) noexcept override {
    for (std::size_t i = 0; i < count; ++i)
      moving_[i] =
          moved[i].from < values_.size() ? static_cast<T>(values_[moved[i].from]) : initial_;
    for (std::size_t i = 0; i < count; ++i) values_[moved[i].to] = static_cast<T>(moving_[i]);
  }

  static constexpr internal::DataKind kind = internal::kind_of(IdType());
  static constexpr std::size_t most_moved = kind == internal::DataKind::half_edge ? max_moved : 0;

  T initial_;
  std::vector<T> values_;
  std::vector<T> moving_;  // room for `move`
};

template <class T>
using VertexData = ElementData<Vertex, T>;
template <class T>
using FaceData = ElementData<Face, T>;
template <class T>
using HalfEdgeData = ElementData<HalfEdge, T>;

}  // namespace clers

#endif
