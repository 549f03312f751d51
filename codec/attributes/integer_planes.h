// Integers of a lattice <-> planes of bytes (planes.h).
#ifndef CLERS_CODEC_ATTRIBUTES_INTEGER_PLANES_H
#define CLERS_CODEC_ATTRIBUTES_INTEGER_PLANES_H

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "codec/attributes/planes.h"
#include "codec/error.h"
#include "codec/numbers/lattice.h"

namespace clers::internal {

template <class Int>
WordShape integer_shape(std::size_t components) {
  return {sizeof(Int) == 4 ? Scalar::uint32 : Scalar::uint64, components};
}

/// Errors: internal.
template <class Int>
Expected<PackedPlanes> pack_integers(Lattice<const Int> lattice,
                                     std::span<const Predictor> candidates,
                                     const CodedSurface& surface, int zstd_level,
                                     std::size_t most_quick = no_bound) {
  return pack_planes(std::as_bytes(lattice.rows), integer_shape<Int>(lattice.axes.size()),
                     candidates, surface, zstd_level, most_quick);
}

/// Residuals into memory of just their size. Errors: invalid.
template <class Int>
Expected<Done> unpack_integers(std::span<const std::byte> packed, std::uint64_t at,
                               const Lattice<Int>& residuals) {
  const auto rows = std::as_writable_bytes(residuals.rows);
  if (auto ok = check_frame(packed, at, rows.size(), "the values"); !ok) return ok;
  return unpack_planes(packed, at, integer_shape<Int>(residuals.axes.size()), rows);
}

/// Integers of residuals, in their place. Besides, takes as many bytes again. Errors: invalid.
template <class Int>
Expected<Done> add_to_integers(Predictor predictor, const CodedSurface& surface, std::uint64_t at,
                               const Lattice<Int>& lattice) {
  const auto [rows, axes] = lattice;
  const WordShape shape = integer_shape<Int>(axes.size());
  if (in_order_of_values(predictor)) {
    const auto bytes = std::as_writable_bytes(rows);
    add_predictions(predictor, shape, surface, bytes, bytes);
  } else {
    const std::vector<Int> residuals(rows.begin(), rows.end());
    add_predictions(predictor, shape, surface, std::as_bytes(std::span(residuals)),
                    std::as_writable_bytes(rows));
  }
  for (std::size_t c = 0; c < axes.size(); ++c)
    for (std::size_t i = c; i < rows.size(); i += axes.size())
      if (static_cast<std::uint64_t>(rows[i]) > axes[c].top)
        return fail(ErrorCode::invalid, Place::byte, at,
                    "component " + std::to_string(c) + " of value " +
                        std::to_string(i / axes.size()) + " is beyond what its numbers have");
  return Done{};
}

}  // namespace clers::internal

#endif
