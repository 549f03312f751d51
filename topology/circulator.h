// Ranges over a surface's elements and over the neighbourhood of one, for range-for; they allocate
// nothing.
#ifndef CLERS_TOPOLOGY_CIRCULATOR_H
#define CLERS_TOPOLOGY_CIRCULATOR_H

#include <cstddef>
#include <cstdint>
#include <iterator>

#include <clers/topology/export.h>
#include <clers/topology/ids.h>

namespace CLERS_VISIBLE clers {

class Surface;

/// The values of a Cursor from where it stands to its end(). A Cursor has a value(), advances, and
/// is at the same place as another if their remaining() are equal.
template <class Cursor>
class ElementRange {
 public:
  class iterator {
   public:
    using value_type = decltype(Cursor().value());
    using difference_type = std::ptrdiff_t;
    using iterator_category = std::forward_iterator_tag;
    using pointer = const value_type*;
    using reference = value_type;

    iterator() = default;
    explicit iterator(Cursor at) : at_(at) {}

    value_type operator*() const { return at_.value(); }
    iterator& operator++() {
      at_.advance();
      return *this;
    }
    iterator operator++(int) {
      iterator old = *this;
      ++*this;
      return old;
    }
    friend bool operator==(const iterator& a, const iterator& b) {
      return a.at_.remaining() == b.at_.remaining();
    }

   private:
    Cursor at_;
  };

  explicit ElementRange(Cursor first) : first_(first) {}

  iterator begin() const { return iterator(first_); }
  iterator end() const { return iterator(first_.end()); }
  bool empty() const { return begin() == end(); }
  /// Not of ranges over all elements, which skip dead ids: those are counted by characteristic().
  std::uint32_t size() const requires Cursor::counts { return first_.remaining(); }

 private:
  Cursor first_;
};

/// Half-edges, each got from the one before by Step. It counts instead of comparing with the start:
/// a neighbourhood may pass the same vertex or face more than once.
template <class Step>
class CirculatorCursor {
 public:
  static constexpr bool counts = true;

  CirculatorCursor() = default;
  CirculatorCursor(const Surface& surface, HalfEdge start, std::uint32_t size)
      : surface_(&surface), at_(start), remaining_(size) {}

  HalfEdge value() const { return at_; }
  void advance() {
    if (--remaining_ != 0) at_ = Step::after(*surface_, at_);
  }
  std::uint32_t remaining() const { return remaining_; }
  CirculatorCursor end() const { return {}; }

 protected:
  const Surface* surface_ = nullptr;
  HalfEdge at_;
  std::uint32_t remaining_ = 0;
};
template <class Step>
using Circulator = ElementRange<CirculatorCursor<Step>>;

/// The other ends of the edges that a circulator around a vertex passes.
template <class Step>
class NeighbourCursor : public CirculatorCursor<Step> {
 public:
  NeighbourCursor() = default;
  NeighbourCursor(const Surface& surface, Vertex v, HalfEdge start, std::uint32_t size)
      : CirculatorCursor<Step>(surface, start, size), centre_(v) {}

  Vertex value() const { return Step::other_end(*this->surface_, this->at_, centre_); }
  NeighbourCursor end() const { return {}; }

 private:
  Vertex centre_;
};

/// The ids among 0 .. limit-1 for which Which::holds, in order.
template <class Which, class IdType>
class FilterCursor {
 public:
  static constexpr bool counts = false;

  FilterCursor() = default;
  FilterCursor(const Surface& surface, std::uint32_t limit) : surface_(&surface), limit_(limit) {
    skip();
  }

  IdType value() const { return IdType(at_); }
  void advance() {
    ++at_;
    skip();
  }
  std::uint32_t remaining() const { return limit_ - at_; }
  FilterCursor end() const { return {}; }

 private:
  void skip() {
    while (at_ < limit_ && !Which::holds(*surface_, IdType(at_))) ++at_;
  }
  const Surface* surface_ = nullptr;
  std::uint32_t at_ = 0, limit_ = 0;
};

}  // namespace clers

#endif
