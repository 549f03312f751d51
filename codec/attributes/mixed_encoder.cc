#include <optional>

#include "codec/attributes/mixed_coder.h"
#include "codec/attributes/mixed_order.h"
#include "codec/entropy/stream.h"

namespace clers::internal {

template <class Int>
Bytes encode_mixed(const CodedSurface& surface, const Lattice<Int>& lattice) {
  const std::optional<Symmetry> plane = find_mirror(lattice);
  const Originals originals = find_originals(surface);
  const bool copies = originals.count > 0 && copies_pay(surface, originals, lattice);
  Bytes bytes;
  put_mirror(bytes, plane);
  put_u8(bytes, copies);
  put_bytes(bytes, encode_stream([&](EncodeTo& coder) {
              mixed::code_all(coder, surface, lattice, plane, copies ? &originals : nullptr);
            }));
  return bytes;
}

template Bytes encode_mixed(const CodedSurface&, const Lattice<std::int32_t>&);
template Bytes encode_mixed(const CodedSurface&, const Lattice<std::int64_t>&);

}  // namespace clers::internal
