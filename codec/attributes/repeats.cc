// Whether to code which coordinates occur again.
#include "codec/attributes/repeats.h"

#include <algorithm>
#include <bit>

#include "codec/numbers/lattice.h"
#include "topology/ids.h"

namespace clers::internal {

template <class Int>
bool repeats_may_pay(const CodedSurface& surface, const Lattice<Int>& lattice) {
  std::uint64_t repeated = 0, others = 0, bits = 0;  // bits of what others are off
  for_each_introduced(surface, [&](std::uint32_t t, unsigned corner) {
    const std::uint32_t* const c = &surface.corners[3 * std::size_t(t)];
    const HalfEdge across = surface.twins[3 * std::size_t(t)];
    if (corner != 2 || !across) return;
    const std::uint32_t o = surface.corners[lprev(across).index()];
    for (std::size_t i = 0; i < 3; ++i) {
      const auto at = [&](std::uint32_t v) {
        return std::int64_t(lattice.rows[3 * std::size_t(v) + i]);
      };
      const bool again = at(c[2]) == at(c[0]) || at(c[2]) == at(c[1]);
      repeated += again;
      others += !again;
      bits += again ? 0 : std::bit_width(apart(at(c[2]) + at(o), at(c[0]) + at(c[1])));
    }
  });
  // Of numbers of so many bits about so many agree by chance: one in 2^(bits / others).
  const std::uint64_t all = repeated + others, part = bits % (others + 1) * 256 / (others + 1);
  return 64 * repeated > all &&
         repeated * ((256 + part) << std::min<std::uint64_t>(bits / (others + 1), 20)) > 256 * all;
}

template bool repeats_may_pay(const CodedSurface&, const Lattice<std::int32_t>&);
template bool repeats_may_pay(const CodedSurface&, const Lattice<std::int64_t>&);

}  // namespace clers::internal
