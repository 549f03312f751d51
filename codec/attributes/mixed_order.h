// The order in which positions are mixed: once for both directions.
#ifndef CLERS_CODEC_ATTRIBUTES_MIXED_ORDER_H
#define CLERS_CODEC_ATTRIBUTES_MIXED_ORDER_H

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "codec/attributes/mixed_model.h"
#include "codec/attributes/mixed_star.h"
#include "codec/attributes/visit_order.h"
#include "codec/connectivity/coded_surface.h"
#include "codec/numbers/lattice.h"

namespace clers::internal::mixed {

/// Vertices across parallelograms first; then, or where there are no twins, those that are left.
/// Returns what is wrong.
template <class Coder, class Int>
std::string code_all(Coder& coder, const CodedSurface& surface, const Lattice<Int>& lattice,
                     const std::optional<Symmetry>& plane, const Originals* originals,
                     Repetition repetition) {
  Model<Int> model(surface, lattice, plane, originals, repetition);
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

}  // namespace clers::internal::mixed

#endif
