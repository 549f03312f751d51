#include "codec/attributes/mixed_coder.h"

#include <optional>
#include <string>

#include "codec/attributes/mixed_model.h"
#include "codec/attributes/mixed_star.h"
#include "codec/attributes/visit_order.h"
#include "codec/entropy/stream.h"

namespace clers::internal {
namespace {

using namespace mixed;

/// Vertices across parallelograms first; then, or where there are no twins, those that are left.
/// Returns what is wrong.
template <class Coder, class Int>
std::string code_all(Coder& coder, const CodedSurface& surface, const Lattice<Int>& lattice,
                     const std::optional<Symmetry>& plane, const Originals* originals) {
  Model<Int> model(surface, lattice, plane, originals);
  Star star;
  const Stars stars(surface);
  std::uint32_t before = no_vertex;
  bool good = true;
  const auto code = [&](std::uint32_t v) {
    good = good && model.code(coder, stars, v, star, before);
    before = v;
  };
  if (!surface.twins.empty()) {
    for_each_by_parallelograms(surface, [&](HalfEdge h, const Visited& visited) {
      stars.find(h, visited, star);
      code(surface.corners[h.index()]);
    });
  } else {
    for_each_introduced(surface, [&](std::uint32_t t, unsigned corner) {
      const std::uint32_t* const c = &surface.corners[3 * std::size_t(t)];
      star.ring_size = star.parallelograms = star.lines = 0;
      for (unsigned i = 0; i < 3; ++i)
        if (surface.introduced_by[c[i]] != t || i < corner) star.ring[star.ring_size++] = c[i];
      code(c[corner]);
    });
  }
  star.ring_size = star.parallelograms = star.lines = 0;
  for (std::uint32_t v = 0; v < lattice.count(); ++v)
    if (!surface.has(v)) code(v);
  return good ? std::string() : "a coordinate is beyond the end of its axis";
}

}  // namespace

template <class Int>
Bytes encode_mixed(const CodedSurface& surface, const Lattice<Int>& lattice) {
  const std::optional<Symmetry> plane = find_mirror(lattice);
  const Originals originals = find_originals(surface);
  const bool copies = originals.count > 0 && copies_pay(surface, originals, lattice);
  Bytes bytes;
  put_mirror(bytes, plane);
  put_u8(bytes, copies);
  put_bytes(bytes, encode_stream([&](EncodeTo& coder) {
              code_all(coder, surface, lattice, plane, copies ? &originals : nullptr);
            }));
  return bytes;
}

template <class Int>
Expected<Done> decode_mixed(std::span<const std::byte> bytes, std::uint64_t at,
                            const CodedSurface& surface, const Lattice<Int>& lattice) {
  ByteReader in(bytes, at);
  const auto plane = read_mirror(in, lattice.axes);
  if (!plane.ok()) return Failure{plane.error()};
  const std::uint32_t copies = in.u8();
  if (!in.ok()) return Failure{in.error()};
  if (copies > 1)
    return fail(ErrorCode::invalid, Place::byte, in.offset() - 1,
                "copies are neither followed nor not");
  Originals originals;
  if (copies) originals = find_originals(surface);
  const Stream stream = {bytes.subspan(in.position()), in.offset()};
  return decode_stream(stream, "coordinates", [&](DecodeFrom& coder) {
    return code_all(coder, surface, lattice, *plane, copies ? &originals : nullptr);
  });
}

std::uint64_t mixed_memory(std::uint64_t values, std::uint64_t triangles) {
  return Past::memory(values) + Stars::memory(values) + visit_order_memory(values) +
         Mirror<std::int64_t>::memory(values) + originals_memory(values, triangles) +
         Copies<std::int64_t>::memory(values) + Mixing::memory() + Shapes::memory();
}

template Bytes encode_mixed(const CodedSurface&, const Lattice<std::int32_t>&);
template Bytes encode_mixed(const CodedSurface&, const Lattice<std::int64_t>&);
template Expected<Done> decode_mixed(std::span<const std::byte>, std::uint64_t, const CodedSurface&,
                                     const Lattice<std::int32_t>&);
template Expected<Done> decode_mixed(std::span<const std::byte>, std::uint64_t, const CodedSurface&,
                                     const Lattice<std::int64_t>&);

}  // namespace clers::internal
