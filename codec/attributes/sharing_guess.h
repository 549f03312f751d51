// Which value a wedge shares, by what is around it: where charts lie on others, as both halves of a
// symmetric shape often do, whole triangles have the values of earlier ones.
//
//        w           ?        a, b have the values that p, q have; so w mostly has that of the third
//       / \         / \       corner there, which is not that of o.
//      a---b       q---p
//       \ /
//        o
#ifndef CLERS_CODEC_ATTRIBUTES_SHARING_GUESS_H
#define CLERS_CODEC_ATTRIBUTES_SHARING_GUESS_H

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "codec/attributes/coded_faces.h"
#include "codec/base/no_index.h"
#include "codec/mesh.h"
#include "topology/ids.h"

namespace clers::internal {

/// Walks along the surface as wedges get their values, in order. Cost: linear.
class SharingGuess {
 public:
  /// `wedge_of` of each corner of the mesh, which are numbered as half-edges come to them; `values`
  /// of each wedge, looked at once they are coded. Of no surface nothing is guessed.
  SharingGuess(const CodedFaces& faces, std::span<const std::uint32_t> wedge_of,
               std::span<const std::uint32_t> values)
      : faces_(faces),
        wedge_of_(wedge_of),
        values_(values),
        sides_(static_cast<std::size_t>(slots_for(faces.surface.corners.size()))) {}

  static std::uint64_t memory(std::uint64_t half_edges) {
    return slots_for(half_edges) * sizeof(Side);
  }

  /// The value that the next wedge may have, or no_index. Call it for wedges 0, 1, 2 ..; those
  /// before have their values.
  std::uint32_t operator()(std::uint32_t wedge) {
    const std::span<const std::uint32_t> corners = faces_.surface.corners;
    for (; at_ < corners.size(); ++at_) {
      if (at_ % 3 == 0 && at_ > 0) enter(at_ - 3);
      if (wedge_at(at_) == wedge) return guess(at_++, wedge);
    }
    return no_index;
  }

 private:
  /// The values of the ends of a side, the less one first, and of the third corners of two
  /// triangles that have it.
  struct Side {
    std::uint32_t a = no_index, b = no_index, thirds[2] = {no_index, no_index};
  };
  static constexpr std::size_t reach = 8;

  static std::uint64_t slots_for(std::uint64_t half_edges) {
    return std::bit_ceil(std::max<std::uint64_t>(half_edges + half_edges / 4, 8));
  }
  std::uint32_t wedge_at(std::size_t h) const { return wedge_of_[faces_.corner(h)]; }
  /// That of a corner whose wedge is before this one, or no_index.
  std::uint32_t value_at(std::size_t h, std::uint32_t wedge) const {
    const std::uint32_t w = wedge_at(h);
    return w < wedge ? values_[w] : no_index;
  }

  /// The side with these ends, or a free place for it, or nullptr.
  Side* find(std::uint32_t a, std::uint32_t b) {
    const std::uint64_t mixed = (std::uint64_t(a) << 32 | b) * 0x9e3779b97f4a7c15u;
    std::size_t slot = static_cast<std::size_t>(mixed >> 32 ^ mixed);
    for (std::size_t i = 0; i < reach; ++i, ++slot) {
      Side& side = sides_[slot & (sides_.size() - 1)];
      if (side.a == no_index || (side.a == a && side.b == b)) return &side;
    }
    return nullptr;
  }

  std::uint32_t guess(std::size_t h, std::uint32_t wedge) {
    const std::size_t next = h % 3 == 2 ? h - 2 : h + 1, previous = h % 3 == 0 ? h + 2 : h - 1;
    const std::uint32_t a = value_at(next, wedge), b = value_at(previous, wedge);
    if (a == no_index || b == no_index) return no_index;
    const Side* side = find(std::min(a, b), std::max(a, b));
    if (side == nullptr) return no_index;
    std::uint32_t beside = no_index;
    if (!faces_.surface.twins.empty())
      if (const HalfEdge over = faces_.surface.twins[next])
        beside = value_at(lprev(over).index(), wedge);
    for (const std::uint32_t third : side->thirds)
      if (third != no_index && third != beside) return third;
    return no_index;
  }

  /// A triangle whose wedges have their values.
  void enter(std::size_t first) {
    std::uint32_t value[3];
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t wedge = wedge_at(first + i);
      if (wedge == no_value) return;
      value[i] = values_[wedge];
    }
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t p = value[i], q = value[(i + 1) % 3], third = value[(i + 2) % 3];
      Side* side = find(std::min(p, q), std::max(p, q));
      if (side == nullptr) continue;
      side->a = std::min(p, q);
      side->b = std::max(p, q);
      for (std::uint32_t& known : side->thirds) {
        if (known == third) break;
        if (known != no_index) continue;
        known = third;
        break;
      }
    }
  }

  const CodedFaces& faces_;
  const std::span<const std::uint32_t> wedge_of_, values_;
  std::vector<Side> sides_;
  std::size_t at_ = 0;
};

}  // namespace clers::internal

#endif
