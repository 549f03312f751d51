// Bytes -> positions, in contexts of the sizes of residuals.
#include "codec/attributes/sized_model.h"
#include "codec/attributes/sized_positions.h"
#include "codec/entropy/lanes.h"

namespace clers::internal {

template <class Int>
Expected<Done> decode_sized_positions(std::span<const std::byte> bytes, std::uint64_t at,
                                      const CodedSurface& surface, Lattice<Int> positions) {
  ByteReader in(bytes, at);
  const std::uint32_t order = in.u8();
  LaneDecoder coder(in);
  if (!in.ok()) return Failure<Error>{in.error()};
  if (order > 1 || (order == 1 && surface.twins.empty()))
    return fail(ErrorCode::invalid, Place::byte, at, "an order of positions that there is not");
  const bool valid = with_sized_model(surface, positions, [&](auto& model) {
    return model.code(coder, static_cast<VisitOrder>(order));
  });
  if (!valid)
    return fail(ErrorCode::invalid, Place::byte, at, "a position is outside of its range");
  if (!coder.finished())
    return fail(ErrorCode::invalid, Place::byte, at, "positions do not end where their bytes end");
  return Done{};
}

template Expected<Done> decode_sized_positions(std::span<const std::byte>, std::uint64_t,
                                               const CodedSurface&, Lattice<std::int32_t>);
template Expected<Done> decode_sized_positions(std::span<const std::byte>, std::uint64_t,
                                               const CodedSurface&, Lattice<std::int64_t>);

}  // namespace clers::internal
