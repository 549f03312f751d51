#include <optional>

#include "codec/attributes/mixed_coder.h"
#include "codec/attributes/mixed_order.h"
#include "codec/entropy/stream.h"

namespace clers::internal {

template <class Int>
Expected<Done> decode_mixed(std::span<const std::byte> bytes, std::uint64_t at,
                            const CodedSurface& surface, const Lattice<Int>& lattice) {
  ByteReader in(bytes, at);
  const auto plane = read_mirror(in, lattice.axes);
  if (!plane.ok()) return Failure{plane.error()};
  const std::uint32_t kind = in.u8(), copies = kind & 1;
  if (!in.ok()) return Failure{in.error()};
  if (kind >= 2 * repetition_count || (kind > 1 && surface.twins.empty()))
    return fail(ErrorCode::invalid, Place::byte, in.offset() - 1,
                "copies and repetitions that there are not");
  const auto repetition = static_cast<Repetition>(kind >> 1);
  Originals originals;
  if (copies) originals = find_originals(surface);
  const Stream stream = {bytes.subspan(in.position()), in.offset()};
  return decode_stream(stream, "coordinates", [&](DecodeFrom& coder) {
    return mixed::code_all(coder, surface, lattice, *plane, copies ? &originals : nullptr,
                           repetition);
  });
}

std::uint64_t mixed_memory(std::uint64_t values, std::uint64_t triangles) {
  using namespace mixed;
  return Past::memory(values) + Stars::memory(values) + visit_order_memory(values) +
         Mirror<std::int64_t>::memory(values) + originals_memory(values, triangles) +
         Copies<std::int64_t>::memory(values) +
         RepeatedCoordinates<std::int64_t>::memory(Repetition::lines, values) + Mixing::memory() +
         Shapes::memory();
}

template Expected<Done> decode_mixed(std::span<const std::byte>, std::uint64_t, const CodedSurface&,
                                     const Lattice<std::int32_t>&);
template Expected<Done> decode_mixed(std::span<const std::byte>, std::uint64_t, const CodedSurface&,
                                     const Lattice<std::int64_t>&);

}  // namespace clers::internal
