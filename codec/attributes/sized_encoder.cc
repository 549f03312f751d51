// Positions -> bytes, in contexts of the sizes of residuals.
#include <utility>

#include "codec/attributes/copies.h"
#include "codec/attributes/mirror.h"
#include "codec/attributes/repetition.h"
#include "codec/attributes/sized_model.h"
#include "codec/attributes/sized_positions.h"
#include "codec/attributes/symmetry.h"
#include "codec/entropy/lanes.h"

namespace clers::internal {

namespace {

template <class Int>
Bytes encode(const CodedSurface& surface, const Lattice<Int>& positions, const Guides& guides,
             VisitOrder order) {
  LaneEncoder coder;
  with_sized_model(surface, positions, guides, order,
                   [&](auto& model) { return model.code(coder); });
  Bytes out;
  put_u8(out, static_cast<std::uint32_t>(order) | (guides.copies ? 2 : 0) |
                  static_cast<std::uint32_t>(guides.repeats) << 2);
  put_mirror(out, guides.symmetry);
  coder.finish(out);
  return out;
}

}  // namespace

template <class Int>
Bytes encode_sized_positions(const CodedSurface& surface, Lattice<Int> positions,
                             VisitOrder order) {
  Guides guides;
  if (surface.twins.empty()) {
    order = VisitOrder::introduction;
  } else {
    guides.symmetry = find_mirror(positions);
    if (component_count(surface) > 1) {
      guides.originals = find_originals(surface);
      guides.copies = copies_pay(surface, guides.originals, positions);
    }
  }
  Bytes out = encode(surface, positions, guides, order);
  if (surface.twins.empty() || !repeats_may_pay(surface, positions)) return out;
  for (const Repetition repeats : {Repetition::beside, Repetition::lines}) {
    guides.repeats = repeats;
    Bytes other = encode(surface, positions, guides, order);
    // It takes time to decode, which a small gain is not worth.
    if (other.size() >= out.size() - out.size() / 128) break;
    out = std::move(other);
  }
  return out;
}

template Bytes encode_sized_positions(const CodedSurface&, Lattice<std::int32_t>, VisitOrder);
template Bytes encode_sized_positions(const CodedSurface&, Lattice<std::int64_t>, VisitOrder);

}  // namespace clers::internal
