// Shapes that have an image of themselves, in a mirror or turned: the map, its bytes, and for each
// vertex the one that it is the image of, found while values are coded, the same by who encodes and
// who decodes. Knows three coordinates and the surface, and no coder.
//
//        x = 0            sum / 2            sum          in a mirror the image of x is sum - x
//          |        v -> .   |   . <- w                   v and w are partners
//          |       / \   |   |   |   / \                  .
//          |      a---b  |   |   |  q---p                 p is b's partner, q is a's
//
// Where a and b have partners, v is predicted to be where w's image is: of the vertices around p
// and q whose image is not known yet, w is the one nearest to the parallelogram then.
#ifndef CLERS_CODEC_ATTRIBUTES_MIRROR_H
#define CLERS_CODEC_ATTRIBUTES_MIRROR_H

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <span>
#include <vector>

#include "codec/attributes/around_vertex.h"
#include "codec/attributes/parallelograms.h"
#include "codec/attributes/symmetry.h"
#include "codec/base/portable.h"
#include "codec/connectivity/coded_surface.h"
#include "codec/numbers/lattice.h"

namespace clers::internal {

/// The symmetry that most vertices can be predicted by, if at least a twentieth can: worth coding
/// with. Cost: linear, but for sorting; bounded where many coordinates are equal. Throws
/// std::bad_alloc only. Precondition: three axes.
template <class Int>
std::optional<Symmetry> find_mirror(const Lattice<Int>& lattice);

/// The partners of the vertices that are coded so far. A vertex on the mirror is its own. Every
/// call takes bounded time, whatever the coordinates and the surface are.
template <class Int>
class Mirror {
 public:
  static constexpr std::uint32_t nobody = 0xffffffffu;

  /// `rows` has three integers a vertex, which are looked at once they are known. Where the surface
  /// has no twins nothing is ever guessed. Throws std::bad_alloc only. Precondition: it fits.
  Mirror(const Symmetry& symmetry, const Int* rows, std::size_t vertices,
         const CodedSurface& surface)
      : surface_(surface),
        rows_(rows),
        axis_(symmetry.axis),
        maps_(symmetry),
        partner_(vertices, unknown),
        state_(vertices),
        slots_(static_cast<std::size_t>(slots_for(vertices)), unknown) {}

  /// The bytes that one takes.
  static std::uint64_t memory(std::uint64_t vertices) {
    return 5 * vertices + 4 * slots_for(vertices);
  }

  /// The partner of a vertex; nobody, if it has none or is not known yet.
  std::uint32_t partner(std::uint32_t v) const {
    return partner_[v] < nothing ? partner_[v] : nobody;
  }
  /// Coordinate c of the image of v's partner, which is about where v is. Precondition: it has one.
  Int partner_image(std::uint32_t v, std::size_t c) const {
    return maps_.image(state_[v] & 3, row(partner_[v]), c);
  }
  /// Coordinate c of the image of the vertex that was guessed last: within -T .. 2 T, if T is the
  /// greatest top. It is not clamped.
  Int image(std::uint32_t w, std::size_t c) const { return maps_.image(guessed_by_, row(w), c); }

  /// Whose image the next vertex will be, by connectivity: the vertex that completes a triangle
  /// with the partners of a and b, if it is free and its image is not farther from a + b - c than
  /// the length of a-b, or than half of it if `strictly`. Or nobody. Precondition: a, b and c are
  /// known.
  std::uint32_t guess(std::uint32_t a, std::uint32_t b, std::uint32_t c, bool strictly) {
    const std::uint32_t q = partner_[a], p = partner_[b];
    if (q >= nothing || p >= nothing || ((state_[a] ^ state_[b]) & 3) != 0) return nobody;
    guessed_by_ = state_[a] & 3u;
    if (surface_.twins.empty()) return nobody;
    const std::uint32_t w = beyond(q, p, guessed_by_);
    if (w == nobody) return nobody;
    std::int64_t off = 0, length = 8;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::int64_t d = std::int64_t(image(w, i)) - row(b)[i] - row(a)[i] + row(c)[i];
      off += std::min(std::abs(d), std::int64_t(1) << 59);  // so that no sum overflows
      length += std::abs(std::int64_t(row(b)[i]) - row(a)[i]);
    }
    return off << strictly <= length ? w : nobody;
  }
  /// The same by places: known, around the partners of a or b, and of those the one whose image is
  /// nearest to the prediction. Or nobody. Preconditions: a and b are known; predictions are within
  /// -T .. 2 T.
  std::uint32_t guess(std::uint32_t a, std::uint32_t b, const Int* prediction) {
    const std::uint32_t q = partner_[a], p = partner_[b];
    if ((q >= nothing && p >= nothing) || surface_.twins.empty()) return nobody;
    return nearest(q, state_[a] & 3u, p, state_[b] & 3u, prediction);
  }

  /// Says that the integers of v are in its row from now on. Precondition: guessed is what guess()
  /// returned for v, or nobody.
  CLERS_ALWAYS_INLINE void known(std::uint32_t v, std::uint32_t guessed = nobody) {
    if (guessed != nobody && is_image(v, guessed, guessed_by_, 0))
      return pair(v, guessed, guessed_by_);
    look_up(v, guessed);
  }

  /// How many vertices were found to be the image of another one, when they became known.
  std::size_t images() const { return images_; }

 private:
  // What partner_ says besides vertices: known, without a partner; not known.
  static constexpr std::uint32_t nothing = 0xfffffffeu, unknown = 0xffffffffu;
  static constexpr Int nearly = 2;         // how far off a partner may be that was guessed
  static constexpr std::size_t reach = 8;  // slots from that of a place on, for all who are there

  static std::uint64_t slots_for(std::uint64_t vertices) {
    return std::bit_ceil(std::max<std::uint64_t>(2 * vertices, 2));
  }

  const Int* row(std::uint32_t v) const { return rows_ + 3 * std::size_t(v); }

  /// Places that differ by 1 along the axis have neighbouring slots.
  std::size_t slot_of(const Int* place) const {
    const std::uint64_t y = static_cast<std::uint64_t>(place[(axis_ + 1) % 3]);
    const std::uint64_t z = static_cast<std::uint64_t>(place[(axis_ + 2) % 3]);
    const std::uint64_t mixed = y * 0x9e3779b97f4a7c15u ^ (z + 1) * 0xc2b2ae3d27d4eb4fu;
    return static_cast<std::size_t>((mixed >> 32 ^ mixed) +
                                    static_cast<std::uint64_t>(place[axis_])) &
           (slots_.size() - 1);
  }

  /// Whether the image by a map of a vertex that is known may be one that is not.
  bool is_free(std::uint32_t w, unsigned map) const {
    return partner_[w] != unknown && (state_[w] >> (2 + map) & 1) == 0;
  }

  /// v is w's image.
  void pair(std::uint32_t v, std::uint32_t w, unsigned map) {
    const unsigned back = maps_.inverse(map);
    ++images_;
    partner_[v] = w;
    state_[v] = static_cast<std::uint8_t>(state_[v] | 4u << back | map);
    state_[w] = static_cast<std::uint8_t>(state_[w] | 4u << map);
    if (partner_[w] < nothing && partner_[w] != w) return;
    partner_[w] = v;
    state_[w] = static_cast<std::uint8_t>((state_[w] & ~3u) | back);
  }

  /// Whether w's image is where v is, but for so much, and 1 more where coordinates are moved.
  bool is_image(std::uint32_t v, std::uint32_t w, unsigned map, Int apart) const {
    for (std::size_t c = 0; c < 3; ++c) {
      const Int off = maps_.image(map, row(w), c) - row(v)[c];
      const Int most = apart + (maps_.moves(map, c) ? 1 : 0);
      if (off < -most || off > most) return false;
    }
    return true;
  }

  static bool same(const Int* a, const Int* b) {
    return a[0] == b[0] && a[1] == b[1] && a[2] == b[2];
  }

  /// Who is at a place, and free.
  std::uint32_t free_at(const Int* place, unsigned map) const {
    for (std::size_t i = 0, slot = slot_of(place); i < reach; ++i) {
      const std::uint32_t w = slots_[(slot + i) & (slots_.size() - 1)];
      if (w == unknown) break;
      if (same(place, row(w)) && is_free(w, map)) return w;
    }
    return nobody;
  }

  void look_up(std::uint32_t v, std::uint32_t guessed) {
    bool own[3] = {};
    // Exactly first, then 1 off along one axis.
    for (const bool off : {false, true})
      for (unsigned map = 0; map < maps_.count(); ++map) {
        std::array<Int, 3> place;
        for (std::size_t c = 0; c < 3; ++c) place[c] = maps_.image(maps_.inverse(map), row(v), c);
        const auto is_there = [&] {
          own[map] = own[map] || same(place.data(), row(v));
          const std::uint32_t w = own[map] ? nobody : free_at(place.data(), map);
          if (w != nobody) pair(v, w, map);
          return w != nobody;
        };
        if (!off && is_there()) return;
        for (std::size_t c = 0; off && c < 3; ++c) {
          if (!maps_.moves(map, c)) continue;
          ++place[c];
          if (is_there()) return;
          place[c] -= 2;
          if (is_there()) return;
          ++place[c];
        }
      }
    if (guessed != nobody && is_image(v, guessed, guessed_by_, nearly))
      return pair(v, guessed, guessed_by_);
    partner_[v] = nothing;
    for (unsigned map = 0; map < maps_.count(); ++map) {
      if (!own[map]) continue;
      partner_[v] = v;
      state_[v] = static_cast<std::uint8_t>((state_[v] & ~3u) | 4u << map | map);
    }
    if (maps_.count() == 1 && own[0]) return;
    for (std::size_t i = 0, slot = slot_of(row(v)); i < reach; ++i) {
      std::uint32_t& w = slots_[(slot + i) & (slots_.size() - 1)];
      if (w != unknown) continue;
      w = v;
      return;
    }
  }

  std::uint32_t nearest(std::uint32_t q, unsigned by_q, std::uint32_t p, unsigned by_p,
                        const Int* prediction) {
    std::uint64_t least = ~std::uint64_t(0);
    std::uint32_t best = nobody;
    const auto consider = [&](std::uint32_t w, unsigned map, std::uint64_t weight) {
      std::uint64_t far = 0;
      for (std::size_t c = 0; c < 3; ++c) {
        const Int off = maps_.image(map, row(w), c) - prediction[c];
        far += static_cast<std::uint64_t>(off < 0 ? -off : off);
      }
      far = weight * std::min(far, std::uint64_t(1) << 61);
      if (far < least) least = far, best = w, guessed_by_ = map;
    };
    // What is around both completes a triangle mostly, as v does: it may be farther.
    std::uint32_t found[most_around];
    std::size_t count = 0;
    if (q < nothing)
      look_around(surface_, q, [&](std::uint32_t w) {
        if (is_free(w, by_q)) found[count++] = w;
      });
    if (p < nothing && (p != q || by_p != by_q))
      look_around(surface_, p, [&](std::uint32_t w) {
        if (!is_free(w, by_p)) return;
        std::uint32_t* const same =
            by_p == by_q ? std::find(found, found + count, w) : found + count;
        const bool both = same != found + count;
        if (both) *same = found[--count];
        consider(w, by_p, both ? 1 : 4);
      });
    for (std::size_t i = 0; i < count; ++i) consider(found[i], by_q, 4);
    return best;
  }

  /// Who completes a triangle with q and p as the image of v does, if it is free.
  std::uint32_t beyond(std::uint32_t q, std::uint32_t p, unsigned map) const {
    if (!surface_.has(q)) return nobody;
    const auto at = [&](std::uint32_t h) { return surface_.corners[h]; };
    std::uint32_t h = 3 * surface_.introduced_by[q];
    h += at(h) == q ? 0u : at(h + 1) == q ? 1u : 2u;
    const std::uint32_t first = h;
    for (unsigned i = 0; i < most_steps_around; ++i) {
      const std::uint32_t back = previous_in(h);
      const HalfEdge across = surface_.twins[back];
      if (maps_.reverses(map)) {  // to the left of p - q
        if (at(back) == p) return free_or_nobody(at(next_in(h)), map);
      } else {  // to the left of q - p
        if (at(next_in(h)) == p) return free_or_nobody(at(back), map);
      }
      if (!across) return nobody;
      h = across.index();
      if (h == first) return nobody;
    }
    return nobody;
  }
  std::uint32_t free_or_nobody(std::uint32_t w, unsigned map) const {
    return is_free(w, map) ? w : nobody;
  }

  CodedSurface surface_;
  const Int* rows_;
  std::uint32_t axis_;
  SymmetryMaps<Int> maps_;
  std::size_t images_ = 0;
  std::vector<std::uint32_t> partner_;
  // Of each vertex: by which map it is its partner's image, and by which its own images are known.
  std::vector<std::uint8_t> state_;
  std::vector<std::uint32_t> slots_;  // vertices that were no image, by their places
  unsigned guessed_by_ = 0;
};

}  // namespace clers::internal

#endif
