// Positions -> bytes, in contexts of the sizes of residuals.
#include "codec/attributes/sized_model.h"
#include "codec/attributes/sized_positions.h"
#include "codec/entropy/lanes.h"

namespace clers::internal {

template <class Int>
Bytes encode_sized_positions(const CodedSurface& surface, Lattice<Int> positions,
                             VisitOrder order) {
  if (surface.twins.empty()) order = VisitOrder::introduction;
  LaneEncoder coder;
  with_sized_model(surface, positions, [&](auto& model) { return model.code(coder, order); });
  Bytes out;
  put_u8(out, static_cast<std::uint8_t>(order));
  coder.finish(out);
  return out;
}

template Bytes encode_sized_positions(const CodedSurface&, Lattice<std::int32_t>, VisitOrder);
template Bytes encode_sized_positions(const CodedSurface&, Lattice<std::int64_t>, VisitOrder);

}  // namespace clers::internal
