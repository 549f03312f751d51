#include <optional>
#include <utility>

#include "codec/attributes/mixed_coder.h"
#include "codec/attributes/mixed_order.h"
#include "codec/entropy/stream.h"

namespace clers::internal {

template <class Int>
Bytes encode_mixed(const CodedSurface& surface, const Lattice<Int>& lattice) {
  const std::optional<Symmetry> plane = find_mirror(lattice);
  const Originals originals = find_originals(surface);
  const bool copies = originals.count > 0 && copies_pay(surface, originals, lattice);
  const auto encode = [&](Repetition repetition) {
    Bytes bytes;
    put_mirror(bytes, plane);
    put_u8(bytes, (copies ? 1 : 0) | static_cast<std::uint32_t>(repetition) << 1);
    put_bytes(bytes, encode_stream([&](EncodeTo& coder) {
                mixed::code_all(coder, surface, lattice, plane, copies ? &originals : nullptr,
                                repetition);
              }));
    return bytes;
  };
  Bytes best = encode(Repetition::none);
  if (surface.twins.empty() || !repeats_may_pay(surface, lattice)) return best;
  for (const Repetition repetition : {Repetition::beside, Repetition::lines}) {
    Bytes bytes = encode(repetition);
    if (bytes.size() >= best.size()) break;
    best = std::move(bytes);
  }
  return best;
}

template Bytes encode_mixed(const CodedSurface&, const Lattice<std::int32_t>&);
template Bytes encode_mixed(const CodedSurface&, const Lattice<std::int64_t>&);

}  // namespace clers::internal
