// Integers of values of any name -> bytes.
#ifndef CLERS_CODEC_ATTRIBUTES_NAMED_VALUES_ENCODER_H
#define CLERS_CODEC_ATTRIBUTES_NAMED_VALUES_ENCODER_H

#include <cstddef>
#include <optional>

#include "codec/attributes/value_surface.h"
#include "codec/entropy/bytes.h"
#include "codec/mesh.h"
#include "codec/numbers/lattice.h"

namespace clers::internal {

/// Encodes values that lie on a surface as for_each_nearby says. Of a mesh of polygons, corners are
/// those of the mesh, without twins. The model is what does best on the first of them. No bytes
/// where a few of them show that these would take clearly more than `beside`, what another coder
/// takes.
/// Precondition: what lattice.h says. Cost: linear. Throws std::bad_alloc only.
template <class Int>
Bytes encode_named_values(const Lattice<Int>& values, const ValueSurface& along,
                          Domain domain = Domain::vertex, std::optional<std::size_t> beside = {});

}  // namespace clers::internal

#endif
