// Ranges over the neighbourhood of an element, for range-for; nothing is allocated.
#ifndef CLERS_TOPOLOGY_CIRCULATOR_H
#define CLERS_TOPOLOGY_CIRCULATOR_H

#include <cstddef>
#include <cstdint>
#include <iterator>

#include "topology/ids.h"

namespace clers {

class Surface;

/// `size()` half-edges, each got from the one before by Step. It counts instead of comparing with
/// the start: a neighbourhood may pass the same vertex or face more than once.
template <class Step>
class Circulator {
 public:
  class iterator {
   public:
    using value_type = HalfEdge;
    using difference_type = std::ptrdiff_t;
    using iterator_category = std::forward_iterator_tag;
    using pointer = const HalfEdge*;
    using reference = HalfEdge;

    iterator() = default;
    iterator(const Surface* surface, HalfEdge at, std::uint32_t remaining)
        : surface_(surface), at_(at), remaining_(remaining) {}

    HalfEdge operator*() const { return at_; }
    iterator& operator++() {
      if (--remaining_ != 0) at_ = Step::after(*surface_, at_);
      return *this;
    }
    iterator operator++(int) {
      iterator old = *this;
      ++*this;
      return old;
    }
    friend bool operator==(const iterator& a, const iterator& b) {
      return a.remaining_ == b.remaining_;
    }

   private:
    const Surface* surface_ = nullptr;
    HalfEdge at_;
    std::uint32_t remaining_ = 0;
  };

  Circulator(const Surface& surface, HalfEdge start, std::uint32_t size)
      : surface_(&surface), start_(start), size_(size) {}

  iterator begin() const { return {surface_, start_, size_}; }
  iterator end() const { return {}; }
  std::uint32_t size() const { return size_; }
  bool empty() const { return size_ == 0; }

 private:
  const Surface* surface_;
  HalfEdge start_;
  std::uint32_t size_;
};

/// The ids among 0 .. limit-1 that `owner.is_live` holds of, in order.
template <class Owner, class IdType>
class LiveIds {
 public:
  class iterator {
   public:
    using value_type = IdType;
    using difference_type = std::ptrdiff_t;
    using iterator_category = std::forward_iterator_tag;
    using pointer = const IdType*;
    using reference = IdType;

    iterator() = default;
    iterator(const Owner* surface, std::uint32_t at, std::uint32_t limit)
        : surface_(surface), at_(at), limit_(limit) {
      skip();
    }
    IdType operator*() const { return IdType(at_); }
    iterator& operator++() {
      ++at_;
      skip();
      return *this;
    }
    iterator operator++(int) {
      iterator old = *this;
      ++*this;
      return old;
    }
    friend bool operator==(const iterator& a, const iterator& b) { return a.at_ == b.at_; }

   private:
    void skip() {
      while (at_ < limit_ && !surface_->is_live(IdType(at_))) ++at_;
    }
    const Owner* surface_ = nullptr;
    std::uint32_t at_ = 0, limit_ = 0;
  };

  LiveIds(const Owner& surface, std::uint32_t limit) : surface_(&surface), limit_(limit) {}
  iterator begin() const { return {surface_, 0, limit_}; }
  iterator end() const { return {surface_, limit_, limit_}; }

 private:
  const Owner* surface_;
  std::uint32_t limit_;
};

}  // namespace clers

#endif
