// Charts that lie on others, as both halves of a symmetric shape often do, or that are their images
// in a mirror: which values repeat others, found while values are coded, the same by who encodes
// and who decodes. Knows two components and the surface, and no coder.
//
//        v           w        a and p have the same value, or one the image of the other's; so
//       / \         / \       have b and q. The triangle on p and q has w: v is predicted to
//      a---b       q---p      be where w is, or its image. Of the two triangles there it is the
//       \ /         \ /       one that is not that of o.
//        o           .
#ifndef CLERS_CODEC_ATTRIBUTES_VALUE_REPEATS_H
#define CLERS_CODEC_ATTRIBUTES_VALUE_REPEATS_H

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "codec/attributes/parallelograms.h"
#include "codec/connectivity/coded_surface.h"
#include "codec/entropy/bytes.h"
#include "codec/error.h"
#include "codec/numbers/lattice.h"
#include "topology/ids.h"

namespace clers::internal {

/// Which values are like others. The numbers are the format's.
struct Likeness {
  enum Kind : std::uint8_t {
    equal,      ///< those that are equal
    reflected,  ///< those that are, once the coordinate is subtracted from the sum
  };
  Kind kind = equal;
  std::uint32_t axis = 0;
  std::uint64_t sum = 0;
};

/// Appends a byte: 0 for none, 1 for equal ones, else 2 + axis, and the sum.
inline void put_likeness(Bytes& out, const std::optional<Likeness>& likeness) {
  const bool reflected = likeness && likeness->kind == Likeness::reflected;
  put_u8(out, !likeness ? 0 : reflected ? 2 + likeness->axis : 1);
  if (reflected) put_varint(out, likeness->sum);
}
/// Reads and checks what put_likeness wrote. Errors: truncated, invalid.
inline Expected<std::optional<Likeness>> read_likeness(ByteReader& in, std::span<const Axis> axes) {
  const std::uint64_t at = in.offset();
  const std::uint32_t kind = in.u8();
  Likeness likeness;
  if (kind >= 2) {
    likeness.kind = Likeness::reflected;
    likeness.axis = kind - 2;
    likeness.sum = in.varint();
  }
  if (!in.ok()) return Failure{in.error()};
  if (kind == 0) return std::optional<Likeness>();
  if (likeness.axis > 1 || (kind >= 2 && likeness.sum > 2 * axes[likeness.axis].top))
    return fail(ErrorCode::invalid, Place::byte, at, "a mirror beyond all values");
  return std::optional(likeness);
}

/// Who is like whom, of the values that are known. Every call takes bounded time.
template <class Int>
class ValueRepeats {
 public:
  static constexpr std::uint32_t nobody = 0xffffffffu;
  static constexpr Int nearly = 1;  ///< how far off an image may be, where values are quantised

  /// `rows` has two integers a value, looked at once they are known. Precondition: twins are there.
  ValueRepeats(const Likeness& likeness, const Int* rows, std::size_t values,
               const CodedSurface& surface)
      : surface_(surface),
        rows_(rows),
        likeness_(likeness),
        partner_(values, unknown),
        slots_(static_cast<std::size_t>(slots_for(values)), unknown) {}

  static std::uint64_t memory(std::uint64_t values) { return 4 * values + 4 * slots_for(values); }

  bool reflects() const { return likeness_.kind == Likeness::reflected; }
  std::uint32_t axis() const { return likeness_.axis; }
  /// Coordinate c of the image: within -T .. 2 T.
  Int image(std::uint32_t w, std::size_t c) const {
    const Int x = row(w)[c];
    return reflects() && c == likeness_.axis ? static_cast<Int>(likeness_.sum) - x : x;
  }
  /// Whether w's image is where v is.
  bool is_image(std::uint32_t w, std::uint32_t v) const {
    for (std::size_t c = 0; c < 2; ++c) {
      const Int off = image(w, c) - row(v)[c],
                most = reflects() && c == likeness_.axis ? nearly : 0;
      if (off < -most || off > most) return false;
    }
    return true;
  }

  /// Which value v repeats, across the side from a to b from o, which may be nobody.
  std::uint32_t guess(std::uint32_t a, std::uint32_t b, std::uint32_t o) const {
    const std::uint32_t p = partner_[a], q = partner_[b];
    if (p >= nothing || q >= nothing) return nobody;
    std::uint32_t found = nobody;
    const auto look = [&](HalfEdge h) {
      const std::uint32_t x = surface_.corners[lnext(h).index()],
                          y = surface_.corners[lprev(h).index()];
      const std::uint32_t w = x == q ? y : y == q ? x : nobody;
      if (w == nobody || partner_[w] == unknown || (o != nobody && is_image(w, o))) return;
      found = w;
    };
    if (!surface_.has(p)) return nobody;
    const HalfEdge first = introducing_corner(surface_, p);
    HalfEdge h = first;
    for (unsigned i = 0; i < most_steps; ++i) {
      look(h);
      h = surface_.twins[lprev(h).index()];
      if (h == first) return found;
      if (!h) break;
    }
    h = surface_.twins[first.index()];
    for (unsigned i = 0; i < most_steps && h; ++i) {
      look(h = lnext(h));
      h = surface_.twins[h.index()];
    }
    return found;
  }

  /// v is known from now on, as a repetition of w if that is one.
  void known(std::uint32_t v, std::uint32_t w) {
    if (w == nobody || !is_image(w, v)) w = find_like(v);
    partner_[v] = w == nobody ? nothing : w;
    if (w == nobody) return enter(v);
    if (partner_[w] != nothing) return;
    partner_[w] = v;
  }

 private:
  // What partner_ says besides values: known, without a partner; not known.
  static constexpr std::uint32_t nothing = 0xfffffffeu, unknown = 0xffffffffu;
  static constexpr std::size_t reach = 8;  // slots from that of a value on
  static constexpr unsigned most_steps = 16;

  static std::uint64_t slots_for(std::uint64_t values) {
    return std::bit_ceil(std::max<std::uint64_t>(2 * values, 2));
  }
  const Int* row(std::uint32_t v) const { return rows_ + 2 * std::size_t(v); }
  /// Values that differ by 1 along the axis have neighbouring slots.
  std::size_t slot_of(Int along, Int other) const {
    const std::uint64_t mixed = (static_cast<std::uint64_t>(other) + 1) * 0x9e3779b97f4a7c15u;
    return static_cast<std::size_t>((mixed >> 32 ^ mixed) + static_cast<std::uint64_t>(along)) &
           (slots_.size() - 1);
  }
  /// Who is known whose image is v.
  std::uint32_t find_like(std::uint32_t v) const {
    const std::size_t c = likeness_.axis;
    const Int along = image(v, c), other = row(v)[1 - c];
    for (const Int off : {0, 1, -1}) {
      if (off != 0 && !reflects()) break;
      for (std::size_t i = 0, slot = slot_of(along + off, other); i < reach; ++i) {
        const std::uint32_t w = slots_[(slot + i) & (slots_.size() - 1)];
        if (w == unknown) break;
        if (row(w)[c] == along + off && row(w)[1 - c] == other) return w;
      }
    }
    return nobody;
  }
  void enter(std::uint32_t v) {
    const std::size_t c = likeness_.axis;
    for (std::size_t i = 0, slot = slot_of(row(v)[c], row(v)[1 - c]); i < reach; ++i) {
      std::uint32_t& w = slots_[(slot + i) & (slots_.size() - 1)];
      if (w != unknown) continue;
      w = v;
      return;
    }
  }

  CodedSurface surface_;
  const Int* rows_;
  Likeness likeness_;
  std::vector<std::uint32_t> partner_;
  std::vector<std::uint32_t> slots_;  // values that are like no other one
};

}  // namespace clers::internal

#endif
