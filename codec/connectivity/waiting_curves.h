// Boundary curves split off for a handle that wait to be joined, by how recently they came.
#ifndef CLERS_CODEC_CONNECTIVITY_WAITING_CURVES_H
#define CLERS_CODEC_CONNECTIVITY_WAITING_CURVES_H

#include <cstddef>
#include <cstdint>
#include <vector>

#include "codec/connectivity/curve_index.h"
#include "codec/connectivity/sequences.h"

namespace clers::internal {

/// A list of rings from which any may be taken. Cost of each operation: O(log n) amortised.
class WaitingCurves {
 public:
  using Ticket = Sequences::Node;  ///< a ring in the list, never 0

  std::uint32_t size() const { return order_.length(list_); }
  bool empty() const { return list_ == 0; }

  /// Puts a ring at the end of the list.
  Ticket put(CurveIndex::Curve ring) {
    const Ticket ticket = order_.make(1);
    if (ticket >= rings_.size()) rings_.resize(ticket + std::size_t(1));
    rings_[ticket] = ring;
    list_ = order_.join(list_, ticket);
    return ticket;
  }

  /// How many came after a ring.
  std::uint32_t recency(Ticket ticket) {
    list_ = order_.to_root(ticket);
    return size() - 1 - order_.before(list_);
  }

  /// Takes the ring out after which `recency` others came. Precondition: recency < size().
  CurveIndex::Curve take(std::uint32_t recency) {
    const Ticket ticket = order_.find(list_, size() - 1 - recency);
    const Sequences::Node before = order_.cut_before(ticket), after = order_.cut_after(ticket);
    order_.release(ticket);
    list_ = order_.join(before, after);
    return rings_[ticket];
  }

 private:
  Sequences order_;
  Sequences::Node list_ = 0;
  std::vector<CurveIndex::Curve> rings_;  ///< by ticket
};

}  // namespace clers::internal

#endif
