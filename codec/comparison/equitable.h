// Both meshes cut into cells at once, until the elements of a cell cannot be told apart by what
// lies around them; then vertices are singled out, one of each mesh, until every cell has one.
//
// Colour refinement with the smaller half (Cardon and Crochemore 1982), and individualisation
// (McKay and Piperno, Practical graph isomorphism II, 2014) along a single path, without going
// back. Where cells are orbits, as in books, hubs, complete complexes and copies of one component,
// any choice is right.
#ifndef CLERS_CODEC_COMPARISON_EQUITABLE_H
#define CLERS_CODEC_COMPARISON_EQUITABLE_H

#include <cstdint>
#include <vector>

#include "codec/comparison/isomorphism.h"
#include "codec/verdict.h"

namespace clers::internal {

/// same: `image` has a renumbering of the vertices, right up to collisions of colours. different:
/// is certain. undecided: a choice was wrong, or there is none. Precondition: both have as many
/// vertices and corners, and as many of each colour. Cost: n log n in vertices and corners.
Comparison pair_by_cells(const Side& a, const Side& b, std::vector<std::uint32_t>& image);

}  // namespace clers::internal

#endif
