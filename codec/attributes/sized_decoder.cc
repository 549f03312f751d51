// Bytes -> positions, in contexts of the sizes of residuals.
#include "codec/attributes/copies.h"
#include "codec/attributes/repetition.h"
#include "codec/attributes/sized_model.h"
#include "codec/attributes/sized_positions.h"
#include "codec/attributes/symmetry.h"
#include "codec/entropy/lanes.h"

namespace clers::internal {

template <class Int>
Expected<Done> decode_sized_positions(std::span<const std::byte> bytes, std::uint64_t at,
                                      const CodedSurface& surface, Lattice<Int> positions) {
  ByteReader in(bytes, at);
  const std::uint32_t kind = in.u8();
  const auto symmetry = read_mirror(in, positions.axes);
  if (!symmetry) return Failure{symmetry.error()};
  LaneDecoder coder(in);
  if (!in.ok()) return Failure{in.error()};
  if (kind >= 4 * repetition_count || (surface.twins.empty() && (kind != 0 || *symmetry)))
    return fail(ErrorCode::invalid, Place::byte, at, "an order of positions that there is not");
  Guides guides{*symmetry, (kind & 2) != 0, {}, static_cast<Repetition>(kind >> 2)};
  if (guides.copies) guides.originals = find_originals(surface);
  const bool valid = with_sized_model(surface, positions, guides, static_cast<VisitOrder>(kind & 1),
                                      [&](auto& model) { return model.code(coder); });
  if (!valid)
    return fail(ErrorCode::invalid, Place::byte, at, "a position is outside of its range");
  if (!coder.finished())
    return fail(ErrorCode::invalid, Place::byte, at, "positions do not end where their bytes end");
  return Done{};
}

std::uint64_t sized_positions_memory(std::span<const std::byte> bytes, std::uint64_t count,
                                     std::uint64_t triangles) {
  // Records of positions, the order of visit, distributions.
  std::uint64_t sum = count * sizeof(Quadruple<std::int64_t>) + (std::uint64_t(1) << 16);
  const auto at = [&](std::size_t i) {
    return i < bytes.size() ? std::to_integer<unsigned>(bytes[i]) : 0u;
  };
  if (at(0) & 1) sum += visit_order_memory(count) + count * sizeof(HalfEdge);
  if (at(0) & 2) sum += originals_memory(count, triangles) + Copies<std::int64_t>::memory(count);
  sum += RepeatedCoordinates<std::int64_t>::memory(static_cast<Repetition>(at(0) >> 2), count);
  if (at(1)) sum += Mirror<std::int64_t>::memory(count);
  return sum;
}

template Expected<Done> decode_sized_positions(std::span<const std::byte>, std::uint64_t,
                                               const CodedSurface&, Lattice<std::int32_t>);
template Expected<Done> decode_sized_positions(std::span<const std::byte>, std::uint64_t,
                                               const CodedSurface&, Lattice<std::int64_t>);

}  // namespace clers::internal
