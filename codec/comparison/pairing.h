// Which component of one mesh becomes which of another?
//
// Components of one colour are nearly always isomorphic, but only a search can tell. Each of the
// first mesh is compared with one of every kind known so far, and joins that kind or founds one;
// each of the second then takes one of its kind, no matter which. So a component is searched for
// as often as there are kinds of its colour, however many others there are.
#ifndef CLERS_CODEC_COMPARISON_PAIRING_H
#define CLERS_CODEC_COMPARISON_PAIRING_H

#include <cstdint>
#include <vector>

#include "codec/comparison/isomorphism.h"
#include "codec/verdict.h"

namespace clers::internal {

/// same: vertex v of the first mesh may become image[v], up to collisions of colours. different:
/// the meshes are. undecided: after a number of steps that grows with the mesh. Precondition: the
/// same attributes, and the same colours of vertices and faces as often.
Comparison pair_components(const Side& a, const Side& b, std::vector<std::uint32_t>& image);

}  // namespace clers::internal

#endif
