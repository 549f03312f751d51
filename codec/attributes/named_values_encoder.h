// Integers of values of any name -> bytes.
#ifndef CLERS_CODEC_ATTRIBUTES_NAMED_VALUES_ENCODER_H
#define CLERS_CODEC_ATTRIBUTES_NAMED_VALUES_ENCODER_H

#include "codec/attributes/lattice.h"
#include "codec/connectivity/coded_surface.h"
#include "codec/entropy/bytes.h"

namespace clers::internal {

/// Encodes values of vertices along their surface, others with one that is empty. The model is what
/// does best on the first of them. Precondition: what lattice.h says. Cost: linear. Throws
/// std::bad_alloc only.
template <class Int>
Bytes encode_named_values(const Lattice<Int>& values, const CodedSurface& surface);

}  // namespace clers::internal

#endif
