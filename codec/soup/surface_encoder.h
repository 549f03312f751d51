// Faces that are not degenerate -> the streams of the surface that they make: the first time that
// what was cut, reversed and left out is coded. Knows no mesh, no attributes and no sections.
#ifndef CLERS_CODEC_SOUP_SURFACE_ENCODER_H
#define CLERS_CODEC_SOUP_SURFACE_ENCODER_H

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "codec/base/faces.h"
#include "codec/connectivity/coded_surface.h"
#include "codec/connectivity/connectivity.h"
#include "codec/entropy/stream.h"
#include "codec/error.h"
#include "codec/order.h"
#include "codec/soup/reversed_faces.h"

namespace clers::internal {

/// A coded surface, and how it numbers what it is made of.
struct EncodedSurface {
  EncodedStream reversed, polygons, copies, repeats;  ///< where there are any
  Bytes connectivity;
  ConnectivityCounts counts;
  std::vector<ReversedRun> reversed_runs;
  std::uint64_t copied_vertices = 0, repeated_faces = 0;
  bool given_up = false;  ///< nothing else holds
  Permutation order;      ///< vertices: only those that the surface has
  CodedArrays surface;    ///< as far as it is wanted
};

/// What is wanted of a surface besides its bytes.
enum class Wanted : std::uint8_t { nothing, surface, surface_with_twins };

/// Encodes faces: those that repeat others as references, and the rest cut where it is no oriented
/// manifold. Cuts, and which face another one repeats, depend on the order of the faces. Asks
/// whether to give up where most sides lie on defective edges (adjacency.h), so that little of the
/// faces is a surface.
/// Precondition: every face has three corners or more, repeats no vertex, and vertices are below
/// vertex_count. Errors: out_of_memory. Throws std::bad_alloc. Cost: linear, O(log n) for each
/// handle, and sorts of the faces at edges that are not manifold.
Expected<EncodedSurface> encode_surface(std::span<const std::uint32_t> corners,
                                        std::span<const std::uint32_t> sizes,
                                        std::uint32_t vertex_count, int level, Wanted wanted,
                                        const std::function<bool()>& give_up);

}  // namespace clers::internal

#endif
