// How joints are coded: what encoder and decoder share. It knows the surface and a coder, but no
// bytes of a file.
#ifndef CLERS_CODEC_ATTRIBUTES_JOINTS_MODEL_H
#define CLERS_CODEC_ATTRIBUTES_JOINTS_MODEL_H

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "codec/attributes/joints.h"
#include "codec/attributes/known_values.h"
#include "codec/entropy/coder.h"

namespace clers::internal {

/// Codes tuples with Coder, one that encodes what is in the rows or one that fills them.
///
/// Vertices move with the bones that their neighbours move with. So a tuple mostly is that of a
/// neighbour; else one that was lately elsewhere; else its joints are asked for one by one, those
/// of neighbours first, in the order of how many have them.
template <class Coder>
class JointsModel {
 public:
  JointsModel(Coder& coder, std::span<const Axis> axes, std::span<std::int32_t> rows)
      : coder_(coder), axes_(axes), rows_(rows), width_(axes.size()), symbols_(width_) {}

  static std::uint64_t memory(std::uint64_t components) {
    return components * sizeof(SymbolModel) + sizeof(JointsModel);
  }

  /// False if an integer that is decoded is not in 0 .. top.
  bool code(std::uint32_t v, const Nearby& nearby) {
    if (nearby.same != Nearby::none && code_same(v, nearby.same)) return true;
    if (code_tuple(v, nearby)) return true;
    if (code_recent(v)) return true;
    for (std::size_t c = 0; c < width_; ++c)
      if (!code_near(v, c, nearby) && !code_symbol(v, c)) return false;
    remember(v);
    return true;
  }

 private:
  static constexpr std::size_t most_tuples = 4;  ///< of neighbours
  static constexpr std::size_t most_recent = 16;
  static constexpr std::size_t most_near = 12;  ///< joints of neighbours

  /// By the bits above, eight of them.
  struct SymbolModel {
    BitModel top[256];
  };
  /// Something that several neighbours have.
  struct Candidate {
    std::uint32_t at = 0;  ///< the neighbour with a tuple; or a joint
    unsigned here = 0;     ///< how many have it, a joint in the same component
    unsigned votes = 0;    ///< a joint in any component
    bool used = false;     ///< a joint in an earlier component of this tuple
    unsigned score() const { return (used ? 0 : 100) + 3 * here + 2 * votes; }
  };

  std::int32_t& at(std::size_t v, std::size_t c) { return rows_[v * width_ + c]; }
  bool equal(std::size_t v, std::size_t u) {
    return std::equal(&at(v, 0), &at(v, 0) + width_, &at(u, 0));
  }
  void copy(std::size_t u, std::size_t v) {
    if (!Coder::encodes) std::copy_n(&at(u, 0), width_, &at(v, 0));
  }

  /// Most votes first, and those of as many in the order in which they came.
  template <std::size_t N>
  static void sort(std::array<Candidate, N>& all, std::size_t count) {
    for (std::size_t i = 1; i < count; ++i)
      for (std::size_t k = i; k > 0 && all[k].score() > all[k - 1].score(); --k)
        std::swap(all[k], all[k - 1]);
  }

  bool code_same(std::uint32_t v, std::uint32_t u) {
    const bool same = coder_.bit(same_[last_same_], Coder::encodes && equal(v, u));
    last_same_ = (2 * last_same_ + same) % 4;
    if (same) copy(u, v);
    return same;
  }

  /// Whether the tuple is that of a neighbour, or of the value before, and whose.
  bool code_tuple(std::uint32_t v, const Nearby& nearby) {
    std::array<Candidate, most_tuples> all;
    std::size_t count = 0;
    const auto offer = [&](std::uint32_t u) {
      for (std::size_t i = 0; i < count; ++i)
        if (equal(all[i].at, u)) {
          ++all[i].here;
          return;
        }
      if (count < most_tuples) all[count++] = {u, 1, 0, false};
    };
    for (std::size_t i = 0; i < nearby.count; ++i) offer(nearby.around[i]);
    if (nearby.count == 0 && nearby.before != Nearby::none) offer(nearby.before);
    sort(all, count);
    unsigned left = static_cast<unsigned>(nearby.count);
    for (std::size_t i = 0; i < count; ++i) {
      left -= std::min(left, all[i].here);
      BitModel& model = tuple_[i][std::min(all[i].here, 4u)][std::min(left, 3u)][last_tuple_];
      const bool is = coder_.bit(model, Coder::encodes && equal(v, all[i].at));
      if (i == 0) last_tuple_ = (2 * last_tuple_ + is) % 4;
      if (!is) continue;
      copy(all[i].at, v);
      return true;
    }
    return false;
  }

  /// Whether it is one of those that were lately no neighbour's, and which.
  bool code_recent(std::uint32_t v) {
    if (recent_count_ == 0) return false;
    std::size_t is = recent_count_;
    if constexpr (Coder::encodes)
      for (std::size_t i = 0; i < recent_count_; ++i)
        if (is == recent_count_ && equal(v, recent_[i])) is = i;
    if (!coder_.bit(any_recent_[last_recent_], is < recent_count_)) {
      last_recent_ = last_recent_ * 2 % 4;
      return false;
    }
    last_recent_ = (last_recent_ * 2 + 1) % 4;
    std::size_t i = 0;
    while (i + 1 < recent_count_ && coder_.bit(recent_further_[i], i < is)) ++i;
    const std::uint32_t u = recent_[i];
    copy(u, v);
    for (; i > 0; --i) recent_[i] = recent_[i - 1];
    recent_[0] = v;
    return true;
  }
  void remember(std::uint32_t v) {
    recent_count_ = std::min(recent_count_ + 1, most_recent);
    for (std::size_t i = recent_count_ - 1; i > 0; --i) recent_[i] = recent_[i - 1];
    recent_[0] = v;
  }

  /// Whether component c is a joint of a neighbour, and which.
  bool code_near(std::uint32_t v, std::size_t c, const Nearby& nearby) {
    std::array<Candidate, most_near> all;
    std::size_t count = 0;
    for (std::size_t i = 0; i < nearby.count; ++i)
      for (std::size_t d = 0; d < width_; ++d) {
        const auto joint = static_cast<std::uint32_t>(at(nearby.around[i], d));
        if (joint > axes_[c].top) continue;
        std::size_t k = 0;
        while (k < count && all[k].at != joint) ++k;
        if (k == most_near) continue;
        if (k == count) {
          all[count++] = {joint, 0, 0, false};
          for (std::size_t e = 0; e < c; ++e)
            all[k].used |= static_cast<std::uint32_t>(at(v, e)) == joint;
        }
        all[k].here += d == c;
        ++all[k].votes;
      }
    sort(all, count);
    for (std::size_t k = 0; k < count; ++k) {
      const Candidate& x = all[k];
      BitModel& model = near_[x.used][std::min(x.here, 2u)][std::min(x.votes - 1, 3u)]
                             [std::min<std::size_t>(k, 2)][c == 0            ? 0
                                                           : c + 1 == width_ ? 2
                                                                             : 1];
      if (!coder_.bit(model, Coder::encodes && static_cast<std::uint32_t>(at(v, c)) == x.at))
        continue;
      at(v, c) = static_cast<std::int32_t>(x.at);
      return true;
    }
    return false;
  }

  /// A joint that no neighbour has. False if it is none.
  bool code_symbol(std::uint32_t v, std::size_t c) {
    unsigned bits = static_cast<unsigned>(std::bit_width(axes_[c].top));
    std::uint64_t x = 0, result = 0;
    if constexpr (Coder::encodes) x = static_cast<std::uint64_t>(at(v, c));
    std::size_t node = 1;
    while (bits > 0 && node < 256) {
      const bool bit = coder_.bit(symbols_[c].top[node], x >> --bits & 1);
      node = 2 * node + bit;
      result = 2 * result + bit;
    }
    while (bits > 0) {
      const unsigned part = std::min(bits, 14u);
      bits -= part;
      result = result << part |
               coder_.raw(part, static_cast<std::uint32_t>(x >> bits) & ((1u << part) - 1));
    }
    if (result > axes_[c].top) return false;
    at(v, c) = static_cast<std::int32_t>(result);
    return true;
  }

  Coder& coder_;
  const std::span<const Axis> axes_;
  const std::span<std::int32_t> rows_;
  const std::size_t width_;
  std::vector<SymbolModel> symbols_;
  std::array<std::uint32_t, most_recent> recent_ = {};
  std::size_t recent_count_ = 0;
  BitModel same_[4], tuple_[most_tuples][5][4][4], any_recent_[4], recent_further_[most_recent],
      near_[2][3][4][3][3];
  unsigned last_same_ = 3, last_tuple_ = 3, last_recent_ = 0;
};

}  // namespace clers::internal

#endif
