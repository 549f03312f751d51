// A surface, unbuilt -> the bytes of it: what the encoder has in common with its proof on a full
// surface (encoder_on_surface.cc).
#ifndef CLERS_CODEC_CONNECTIVITY_UNBUILT_H
#define CLERS_CODEC_CONNECTIVITY_UNBUILT_H

#include <cstdint>
#include <vector>

#include "codec/connectivity/connectivity.h"
#include "codec/connectivity/decode_script.h"
#include "codec/connectivity/edgebreaker.h"

namespace clers::internal {

inline std::uint32_t triangles_of(const SurfaceArrays& surface) {
  return static_cast<std::uint32_t>(surface.sizes.empty()
                                        ? surface.org.size() / 3
                                        : surface.org.size() - 2 * surface.sizes.size());
}

/// Runs Edgebreaker. Valences of polygons show later: place_specials.
template <class Witness>
Traversal unbuild(const SurfaceArrays& surface, bool valences, Witness& witness,
                  bool with_corners) {
  if (!surface.sizes.empty())
    return Edgebreaker<PolygonFaces, Witness, false>(surface, witness, with_corners).run();
  return valences
             ? Edgebreaker<TriangleFaces, Witness, true>(surface, witness, with_corners).run()
             : Edgebreaker<TriangleFaces, Witness, false>(surface, witness, with_corners).run();
}

/// Finds where handles are, and counts the valences of polygons. Errors: nonmanifold_vertex,
/// internal.
Expected<Done> place_specials(Traversal& traversal, bool polygons, bool valences);

/// `traversal` is what is left of it when the script has been taken. Throws std::bad_alloc.
EncodedConnectivity encode_script(DecodeScript script, Traversal traversal, int level);

/// That there are no faces.
EncodedConnectivity encode_nothing();

/// As encode_connectivity, whatever the build. Throws std::bad_alloc.
Expected<EncodedConnectivity> encode_fast(SurfaceArrays surface, int level, Kept kept);

/// As encode_connectivity_on_surface. Throws std::bad_alloc.
Expected<EncodedConnectivity> encode_on_surface(SurfaceArrays surface, int level, Kept kept,
                                                std::vector<std::uint8_t>& trace);

}  // namespace clers::internal

#endif
