// Shapes that have a mirror image of themselves: the plane, its bytes, and for each vertex the one
// that is its image, found while values are coded, the same by who encodes and who decodes. Knows
// three coordinates and the surface, and no coder.
//
//        x = 0            sum / 2            sum          the image of x is sum - x
//          |        v -> .   |   . <- w                   v and w are partners
//          |       / \   |   |   |   / \                  .
//          |      a---b  |   |   |  q---p                 p is b's partner, q is a's
//
// Where a and b have partners, v is predicted to be where w's image is: of the vertices around p
// and q that nobody is the partner of yet, w is the one nearest to the image of the parallelogram.
#ifndef CLERS_CODEC_ATTRIBUTES_MIRROR_H
#define CLERS_CODEC_ATTRIBUTES_MIRROR_H

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "codec/attributes/lattice.h"
#include "codec/base/portable.h"
#include "codec/connectivity/coded_surface.h"
#include "codec/entropy/bytes.h"
#include "codec/error.h"
#include "topology/ids.h"

namespace clers::internal {

/// A plane at right angles to an axis, on a coordinate or half way between two.
struct MirrorPlane {
  std::uint32_t axis = 0;
  std::uint64_t sum = 0;  ///< of a coordinate and its image's; at most twice the axis's top
};

/// The plane that most vertices have a partner by, if at least a tenth do: worth coding with. Cost:
/// linear, but for sorting; bounded where many coordinates are equal. Throws std::bad_alloc only.
/// Precondition: three axes.
template <class Int>
std::optional<MirrorPlane> find_mirror(const Lattice<Int>& lattice);

/// Appends a byte: 0 for none, else 1 + axis; and then the sum.
inline void put_mirror(Bytes& out, const std::optional<MirrorPlane>& plane) {
  put_u8(out, plane ? 1 + plane->axis : 0);
  if (plane) put_varint(out, plane->sum);
}

/// Reads and checks what put_mirror wrote. Errors: truncated, invalid. Precondition: three axes.
inline Expected<std::optional<MirrorPlane>> read_mirror(ByteReader& in,
                                                        std::span<const Axis> axes) {
  const std::uint64_t at = in.offset();
  const std::uint32_t kind = in.u8();
  const std::uint64_t sum = kind ? in.varint() : 0;
  if (!in.ok()) return Failure{in.error()};
  if (kind == 0) return std::optional<MirrorPlane>();
  if (kind > 3 || sum > 2 * axes[kind - 1].top)
    return fail(ErrorCode::invalid, Place::byte, at, "a mirror plane beyond all vertices");
  return std::optional<MirrorPlane>({kind - 1, sum});
}

/// The partners of the vertices that are coded so far. A vertex on the plane is its own. Every call
/// takes bounded time, whatever the coordinates and the surface are.
template <class Int>
class Mirror {
 public:
  static constexpr std::uint32_t nobody = 0xffffffffu;

  /// `rows` has three integers a vertex, which are looked at once they are known. Where the surface
  /// has no twins nothing is ever guessed. Throws std::bad_alloc only.
  Mirror(const MirrorPlane& plane, const Int* rows, std::size_t vertices,
         const CodedSurface& surface)
      : surface_(surface),
        rows_(rows),
        axis_(plane.axis),
        first_((plane.axis + 1) % 3),
        second_((plane.axis + 2) % 3),
        sum_(static_cast<Int>(plane.sum)),
        partner_(vertices, unknown),
        slots_(static_cast<std::size_t>(slots_for(vertices)), unknown) {}

  /// The bytes that one takes.
  static std::uint64_t memory(std::uint64_t vertices) {
    return 4 * (vertices + slots_for(vertices));
  }

  /// The partner of a vertex; nobody, if it has none or is not known yet.
  std::uint32_t partner(std::uint32_t v) const {
    return partner_[v] < nothing ? partner_[v] : nobody;
  }

  /// Coordinate c of the image of a vertex that is known.
  Int image(std::uint32_t w, std::size_t c) const {
    const Int x = rows_[3 * std::size_t(w) + c];
    return c == axis_ ? sum_ - x : x;
  }

  /// Who the partner of the next vertex will be: known, without a partner, around those of a or b,
  /// and of those the one whose image is nearest to the prediction. Or nobody. Where v will be is
  /// image(.., 0 .. 2), each within -top .. 2 top: it is not clamped. Preconditions: a and b are
  /// known; predictions are within -top .. 2 top.
  CLERS_ALWAYS_INLINE std::uint32_t guess(std::uint32_t a, std::uint32_t b,
                                          const Int* prediction) const {
    const std::uint32_t q = partner_[a], p = partner_[b];
    if ((q >= nothing && p >= nothing) || surface_.twins.empty()) return nobody;
    return nearest(q, p, prediction);
  }

  /// Says that the integers of v are in its row from now on. Precondition: guessed is what guess()
  /// returned for v, or nobody.
  CLERS_ALWAYS_INLINE void known(std::uint32_t v, std::uint32_t guessed = nobody) {
    if (guessed != nobody && is_image(v, guessed, 0)) return pair(v, guessed);
    look_up(v, guessed);
  }

 private:
  // What partner_ says besides vertices: known, without a partner; not known.
  static constexpr std::uint32_t nothing = 0xfffffffeu, unknown = 0xffffffffu;
  static constexpr Int nearly = 2;         // how far off a partner may be that was guessed
  static constexpr std::size_t reach = 8;  // slots from that of a place on, for all who are there
  static constexpr unsigned most_steps = 16;  // around a vertex, in either direction
  static constexpr unsigned most_around = 2 * most_steps + 1;

  static std::uint64_t slots_for(std::uint64_t vertices) {
    return std::bit_ceil(std::max<std::uint64_t>(2 * vertices, 2));
  }

  const Int* row(std::uint32_t v) const { return rows_ + 3 * std::size_t(v); }

  /// Places that differ by 1 along the axis have neighbouring slots.
  std::size_t slot_of(const Int* place, Int x) const {
    const std::uint64_t y = static_cast<std::uint64_t>(place[first_]);
    const std::uint64_t z = static_cast<std::uint64_t>(place[second_]);
    const std::uint64_t mixed = y * 0x9e3779b97f4a7c15u ^ (z + 1) * 0xc2b2ae3d27d4eb4fu;
    return static_cast<std::size_t>((mixed >> 32 ^ mixed) + static_cast<std::uint64_t>(x));
  }

  void pair(std::uint32_t v, std::uint32_t w) {
    partner_[v] = w;
    partner_[w] = v;
  }

  /// Whether w's image is where v is, but for so much, and 1 more along the axis.
  bool is_image(std::uint32_t v, std::uint32_t w, Int apart) const {
    const Int* const p = row(v);
    const Int* const r = row(w);
    const auto within = [](Int off, Int most) { return off >= -most && off <= most; };
    return within(sum_ - p[axis_] - r[axis_], apart + 1) && within(p[first_] - r[first_], apart) &&
           within(p[second_] - r[second_], apart);
  }

  /// Who is known and has no partner where x is the coordinate along the axis, and the others are
  /// those of `place`.
  std::uint32_t alone_at(const Int* place, Int x) const {
    const std::size_t slot = slot_of(place, x), mask = slots_.size() - 1;
    for (std::size_t i = 0; i < reach; ++i) {
      const std::uint32_t w = slots_[(slot + i) & mask];
      if (w == unknown) break;
      const Int* const r = row(w);
      if (r[axis_] == x && r[first_] == place[first_] && r[second_] == place[second_] &&
          partner_[w] == nothing)
        return w;
    }
    return nobody;
  }

  void look_up(std::uint32_t v, std::uint32_t guessed) {
    const Int* const place = row(v);
    const Int x = sum_ - place[axis_];
    for (const Int image : {x, Int(x + 1), Int(x - 1)}) {
      if (image == place[axis_]) return pair(v, v);
      if (const std::uint32_t w = alone_at(place, image); w != nobody) return pair(v, w);
    }
    if (guessed != nobody && is_image(v, guessed, nearly)) return pair(v, guessed);
    partner_[v] = nothing;
    const std::size_t slot = slot_of(place, place[axis_]), mask = slots_.size() - 1;
    for (std::size_t i = 0; i < reach; ++i) {
      std::uint32_t& w = slots_[(slot + i) & mask];
      if (w != unknown) continue;
      w = v;
      return;
    }
  }

  std::uint32_t nearest(std::uint32_t q, std::uint32_t p, const Int* prediction) const {
    std::uint64_t least = ~std::uint64_t(0);
    std::uint32_t best = nobody;
    const auto consider = [&](std::uint32_t w, std::uint64_t weight) {
      std::uint64_t far = 0;
      for (std::size_t c = 0; c < 3; ++c) {
        const Int off = image(w, c) - prediction[c];
        far += static_cast<std::uint64_t>(off < 0 ? -off : off);
      }
      far = weight * std::min(far, std::uint64_t(1) << 61);
      if (far < least) least = far, best = w;
    };
    // What is around both completes a triangle mostly, as v does: it may be farther.
    std::uint32_t found[most_around];
    std::size_t count = 0;
    if (q < nothing)
      around(q, [&](std::uint32_t w) {
        if (partner_[w] == nothing) found[count++] = w;
      });
    if (p < nothing && p != q)
      around(p, [&](std::uint32_t w) {
        if (partner_[w] != nothing) return;
        std::uint32_t* const same = std::find(found, found + count, w);
        const bool both = same != found + count;
        if (both) *same = found[--count];
        consider(w, both ? 1 : 4);
      });
    for (std::size_t i = 0; i < count; ++i) consider(found[i], 4);
    return best;
  }

  /// Calls look(w) for the vertices around v, of which there may be more.
  template <class Look>
  CLERS_ALWAYS_INLINE void around(std::uint32_t v, const Look& look) const {
    if (!surface_.has(v)) return;
    const auto at = [&](HalfEdge h) { return surface_.corners[h.index()]; };
    HalfEdge first = half_edge(Face(surface_.introduced_by[v]), 0);
    while (at(first) != v) first = lnext(first);
    look(at(lnext(first)));
    HalfEdge h = first;
    for (unsigned i = 0; i < most_steps; ++i) {
      look(at(lprev(h)));
      h = surface_.twins[lprev(h).index()];
      if (h == first) return;
      if (!h) break;
    }
    h = surface_.twins[first.index()];
    for (unsigned i = 0; i < most_steps && h; ++i) {
      look(at(lprev(h)));
      h = surface_.twins[lnext(h).index()];
    }
  }

  CodedSurface surface_;
  const Int* rows_;
  std::uint32_t axis_, first_, second_;  // along which the image is reversed; the others
  Int sum_;
  std::vector<std::uint32_t> partner_;
  std::vector<std::uint32_t> slots_;  // vertices without a partner, by their places
};

}  // namespace clers::internal

#endif
