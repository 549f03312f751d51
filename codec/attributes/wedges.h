// The values that corners share: corners at a vertex that no seam parts are a wedge and have one
// value; a wedge may have that of an earlier one at its vertex, and so may a corner that no
// surface has.
//
//        \   |   /               Wedges of the vertex in the middle: 1 above the seam, 3 below.
//     ====1==3====   seam        Only for the second it is asked whether its value is that of the
//        /   |   \               first: mostly they are alone.
#ifndef CLERS_CODEC_ATTRIBUTES_WEDGES_H
#define CLERS_CODEC_ATTRIBUTES_WEDGES_H

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "codec/attributes/coded_faces.h"
#include "codec/attributes/missing.h"
#include "codec/attributes/parallelograms.h"
#include "codec/attributes/seams.h"
#include "codec/base/no_index.h"
#include "codec/base/portable.h"
#include "codec/entropy/coder.h"
#include "topology/ids.h"

namespace clers::internal {

/// Gives corners that have values the numbers of these: in the order in which half-edges of the
/// surface come to them, then corners that have none. Cost: linear.
class WedgeCoder {
 public:
  /// Corners that have values are `unassigned`. There are at most so many values.
  WedgeCoder(const CodedFaces& faces, const Seams& seams, std::span<std::uint32_t> value_of,
             std::uint64_t most)
      : faces_(faces),
        seams_(seams),
        value_of_(value_of),
        most_(most),
        last_(faces.vertices, no_index) {
    next_.reserve(static_cast<std::size_t>(std::min<std::uint64_t>(most, value_of.size())));
  }
  static std::uint64_t memory(std::uint64_t vertices, std::uint64_t corners, std::uint64_t most) {
    return 4 * vertices + 4 * std::min(corners, most);
  }

  /// False: there are more values than at most. `same(c, d)` as for SeamCoder.
  template <class Coder, class Same>
  bool code(Coder& coder, const Same& same) {
    const auto half_edges = static_cast<std::uint32_t>(faces_.surface.corners.size());
    for (std::uint32_t h = 0; h < half_edges; ++h) {
      const std::uint32_t c = faces_.corner(h);
      if (value_of_[c] != unassigned) continue;
      std::uint32_t value = unassigned;
      if (last_[faces_.corners[c]] != no_index && !faces_.surface.twins.empty())
        value = known_in_wedge(h);
      if (value >= unassigned) value = code_value(coder, wedges_, c, same);
      if (value == no_index) return false;
      value_of_[c] = value;
    }
    for (std::uint32_t c = 0; c < value_of_.size(); ++c) {
      if (value_of_[c] != unassigned) continue;
      value_of_[c] = code_value(coder, others_, c, same);
      if (value_of_[c] == no_index) return false;
    }
    return true;
  }

  std::uint32_t count() const { return static_cast<std::uint32_t>(next_.size()); }
  /// A corner of each value; only of an encoder.
  std::vector<std::uint32_t> take_corners() { return std::move(corner_of_); }

 private:
  static constexpr unsigned most_offered = 32;  ///< so that hubs cost no more
  static constexpr unsigned ranks = 6;

  struct SameModel {
    BitModel bit[2][ranks];
    bool last = false;
  };

  /// That of corner c: one of the latest at its vertex, or a new one. no_index: one too many.
  template <class Coder, class Same>
  std::uint32_t code_value(Coder& coder, SameModel& model, std::uint32_t c, const Same& same) {
    std::uint32_t& last = last_[faces_.corners[c]];
    std::uint32_t k = last;
    for (unsigned i = 0; k != no_index && i < most_offered; k = next_[k], ++i)
      if (model.last = coder.bit(model.bit[model.last][std::min(i, ranks - 1)],
                                 Coder::encodes && same(corner(k), c));
          model.last)
        return k;
    if (next_.size() == most_) return no_index;
    const std::uint32_t value = count();
    next_.push_back(last);
    last = value;
    if constexpr (Coder::encodes) corner_of_.push_back(c);
    return value;
  }
  std::uint32_t corner(std::uint32_t value) const {
    return corner_of_.empty() ? 0 : corner_of_[value];
  }

  /// The value of the wedge of half-edge `first` if one of its corners has it, else one that is not
  /// below `unassigned`. Mostly a triangle beside it has it.
  std::uint32_t known_in_wedge(std::uint32_t first) const {
    const HalfEdge* const twins = faces_.surface.twins.data();
    const auto value = [&](std::uint32_t h) { return value_of_[faces_.corner(h)]; };
    // Where only the other end of an edge is known to be no seam, this one may have no value.
    const auto before = [&](std::uint32_t h) CLERS_INLINE_LAMBDA {  // clockwise
      return twins[h] && !seams_[h] ? next_in(twins[h].index()) : no_index;
    };
    const auto after = [&](std::uint32_t h) CLERS_INLINE_LAMBDA {
      const std::uint32_t side = previous_in(h);
      return twins[side] && !seams_[side] ? twins[side].index() : no_index;
    };
    std::uint32_t back = before(first), on = after(first);
    const std::uint32_t one = back == no_index ? unassigned : value(back);
    if (one < unassigned) return one;
    const std::uint32_t two = on == no_index ? unassigned : value(on);
    if (two < unassigned) return two;
    for (; on != no_index && on != first; on = after(on))
      if (const std::uint32_t v = value(on); v != unassigned) {
        if (v != no_value) return v;
        break;
      }
    if (on == first) return unassigned;
    for (; back != no_index && back != first; back = before(back))
      if (const std::uint32_t v = value(back); v != unassigned) return v;
    return unassigned;
  }

  const CodedFaces& faces_;
  const Seams& seams_;
  const std::span<std::uint32_t> value_of_;
  const std::uint64_t most_;
  std::vector<std::uint32_t> last_;  ///< value of each vertex, no_index: none yet
  std::vector<std::uint32_t> next_;  ///< of each value: the one before at its vertex
  std::vector<std::uint32_t> corner_of_;
  SameModel wedges_, others_;
};

}  // namespace clers::internal

#endif
