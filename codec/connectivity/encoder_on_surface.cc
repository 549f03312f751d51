// The proof of the encoder: every operator that it runs on arrays is run on a full Surface too,
// which classifies it for itself, and what is coded is what the surface says.
#include <algorithm>
#include <new>
#include <optional>
#include <utility>
#include <vector>

#include "codec/connectivity/connectivity.h"
#include "codec/connectivity/replayed_script.h"
#include "codec/connectivity/unbuilt.h"
#include "topology/mirror.h"

namespace clers::internal {
namespace {

UnbuildingMirror mirror_of(const SurfaceArrays& arrays) {
  std::vector<Vertex> org(arrays.org.size());
  for (std::size_t h = 0; h < org.size(); ++h) org[h] = Vertex(arrays.org[h]);
  auto surface = Surface::from_twins(org, arrays.twins, arrays.vertex_count);
  return UnbuildingMirror(surface ? std::move(*surface) : Surface());
}

/// What was unbuilt is gone now, and was built again by the same operators in opposite order.
bool agree(const UnbuildingMirror& unbuilt, const BuildingMirror& built) {
  return unbuilt.agrees && built.agrees && unbuilt.surface.characteristic() == Characteristic{} &&
         std::equal(unbuilt.trace.begin(), unbuilt.trace.end(), built.trace.rbegin(),
                    built.trace.rend());
}

bool agree(const DecodeScript& a, const DecodeScript& b) {
  return a.contexts == b.contexts && a.events == b.events && a.vertices == b.vertices;
}

/// Of triangles.
Expected<EncodedConnectivity> encode_triangles(SurfaceArrays surface, int level, Kept kept,
                                               OperatorTrace& trace) {
  if (surface.org.empty()) return encode_nothing();
  std::vector<HalfEdge> twins;
  if (kept == Kept::corners_and_twins) {
    std::vector<HalfEdge> consumed(surface.twins.begin(), surface.twins.end());
    SurfaceArrays copy = surface;
    copy.twins = consumed;
    KeepTwins witness(surface.org.size(), surface.org.size());
    unbuild(copy, true, witness, false);
    twins = std::move(witness.twins);
  }
  UnbuildingMirror witness = mirror_of(surface);
  Traversal traversal = unbuild(surface, true, witness, kept != Kept::nothing);
  if (auto ok = place_specials(traversal, false, true); !ok) return Failure{ok.error()};
  BuildingMirror pairing(surface.org.size());
  const auto built = replayed_script(surface.org, surface.vertex_count, traversal, pairing);
  if (!built || !agree(witness, pairing))
    return fail(ErrorCode::internal, "the fast operators and the full surface do not agree");
  trace = std::move(witness.trace);
  DecodeScript script = script_of(traversal);
  if (!agree(script, *built))
    return fail(ErrorCode::internal, "the script is not that of the surface built again");
  EncodedConnectivity result = encode_script(std::move(script), std::move(traversal), level);
  result.twins = std::move(twins);
  return result;
}

}  // namespace

/// Polygons as they are, and then their triangles.
Expected<EncodedConnectivity> encode_on_surface(SurfaceArrays surface, int level, Kept kept,
                                                OperatorTrace& trace) {
  if (surface.sizes.empty()) return encode_triangles(surface, level, kept, trace);
  auto coded = encode_fast(surface, level, Kept::corners_and_twins);
  if (!coded) return coded;
  std::vector<std::uint32_t> corners = coded->corners;
  for (std::uint32_t& v : corners)
    if (v >= surface.vertex_count) v = coded->parts_of[v - surface.vertex_count];
  std::vector<HalfEdge> twins = coded->twins;
  const auto again = encode_triangles({corners, twins, surface.vertex_count}, level,
                                      Kept::corners_and_twins, trace);
  if (!again) return again;
  bool same = again->bytes == coded->bytes && again->vertices == coded->vertices &&
              again->twins == coded->twins;
  for (std::uint32_t i = 0; i < again->gates.size(); ++i)
    same &= again->gates[i] == half_edge(Face(i), 0);
  if (!same) return fail(ErrorCode::internal, "polygons and their triangles are not coded alike");
  return coded;
}

Expected<EncodedConnectivity> encode_connectivity_on_surface(SurfaceArrays surface, int level,
                                                             OperatorTrace& trace) try {
  return encode_on_surface(surface, level, Kept::nothing, trace);
} catch (const std::bad_alloc&) {
  return fail(ErrorCode::out_of_memory, "not enough memory for the connectivity");
}

}  // namespace clers::internal
