// Boundary curves put aside while a surface is unbuilt, and whether a vertex lies on one of them.
//
// The walk pushes vertices onto the curve before the gate's origin, and takes them away at both
// sides of the gate; an S cuts the curve in two. So if every vertex that is pushed gets a larger
// label than all before, labels grow along each curve from the end of the gate to its origin, and
// those of a curve put aside fill an interval that holds no other vertex, but for curves that were
// put aside within it:
//
//     gate's end  1  2  3 | 4  5  6 | 10 11  gate's origin      S at 4 put [4, 6] aside; now an S
//                    `-- the S here puts [3, 11] aside          at 3 will do so with what is left
#ifndef CLERS_CODEC_ASIDE_CURVES_H
#define CLERS_CODEC_ASIDE_CURVES_H

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "topology/ids.h"

namespace clers {

/// A stack of curves.
class AsideCurves {
 public:
  struct Curve {
    std::uint32_t index;        ///< of the S in the walk
    HalfEdge gate;              ///< where the walk will go on
    std::uint32_t first, last;  ///< labels of its vertices
    bool joined = false;        ///< to the curve of the gate, by another S: it is no more
    std::size_t inner = 0;      ///< where in `inner_` the curves within its labels begin
  };
  static constexpr std::size_t none = ~std::size_t(0);

  bool empty() const { return curves_.empty(); }
  Curve& operator[](std::size_t i) { return curves_[i]; }

  /// Labels of curves there are lie between `first` and `last`, or do not. Cost: a binary search.
  void put(std::uint32_t index, HalfEdge gate, std::uint32_t first, std::uint32_t last) {
    const auto begin = outer_.begin() + lower(first), end = outer_.begin() + lower(last);
    curves_.push_back({index, gate, first, last, false, inner_.size()});
    inner_.insert(inner_.end(), begin, end);
    outer_.insert(outer_.erase(begin, end), curves_.size() - 1);
  }

  /// The one put last.
  Curve take() {
    const Curve curve = curves_.back();
    const auto inner = inner_.begin() + static_cast<std::ptrdiff_t>(curve.inner);
    outer_.insert(outer_.erase(outer_.begin() + lower(curve.first)), inner, inner_.end());
    inner_.erase(inner, inner_.end());
    curves_.pop_back();
    return curve;
  }

  /// The curve that a vertex with this label lies on, or `none`. Cost: a binary search where it is
  /// none.
  std::size_t find(std::uint32_t label) const {
    const std::ptrdiff_t after = lower(label + 1);
    if (after == 0) return none;
    std::size_t found = outer_[static_cast<std::size_t>(after - 1)];
    if (curves_[found].last < label) return none;
    for (std::size_t i = curves_[found].inner; i < inner_end(found);) {
      const Curve& c = curves_[inner_[i]];
      if (c.first <= label && label <= c.last) {
        found = inner_[i];
        i = c.inner;
      } else {
        ++i;
      }
    }
    return found;
  }

 private:
  /// How many of the outer curves begin below a label.
  std::ptrdiff_t lower(std::uint32_t label) const {
    return std::partition_point(outer_.begin(), outer_.end(),
                                [&](std::size_t c) { return curves_[c].first < label; }) -
           outer_.begin();
  }
  std::size_t inner_end(std::size_t c) const {
    return c + 1 < curves_.size() ? curves_[c + 1].inner : inner_.size();
  }

  std::vector<Curve> curves_;       ///< the stack
  std::vector<std::size_t> outer_;  ///< those within no other, by labels
  std::vector<std::size_t> inner_;  ///< those within others: of each, one after the other
};

}  // namespace clers

#endif
