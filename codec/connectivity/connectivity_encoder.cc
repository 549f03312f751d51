// A surface -> symbols and events -> bytes: Edgebreaker (CAGD 2010, §7.2, Algorithm 2), and what a
// decoder needs besides.
#include <new>
#include <span>
#include <utility>
#include <vector>

#include "codec/connectivity/connectivity.h"
#include "codec/connectivity/place_handles.h"
#include "codec/connectivity/symbol_encoder.h"
#include "codec/connectivity/unbuilt.h"
#include "codec/entropy/bytes.h"
#include "codec/symbols/context_models.h"

namespace clers::internal {

static_assert(Traversal::max_valence == ContextTables::max_valence);

namespace {

void put_header(Bytes& out, std::uint32_t faces, std::uint32_t vertices, std::uint32_t merges,
                SymbolModel model) {
  put_varint(out, faces);
  put_signed_varint(out, 2 * std::int64_t(vertices) - faces - 4);
  std::uint32_t room = 0;
  while (room_for_merges(room) < merges) ++room;
  put_u8(out, room);
  put_u8(out, model.byte());
}

}  // namespace

Expected<Done> place_specials(Traversal& traversal, bool polygons, bool valences) {
  if (traversal.trouble == Traversal::Trouble::several_fans)  // a surface has a vertex for each
    return fail(ErrorCode::nonmanifold_vertex, "the faces of a vertex form more than one fan");
  const bool uncounted = polygons && valences;
  if ((traversal.handles || uncounted) &&
      !(uncounted ? place_handles_and_count_valences(traversal) : place_handles(traversal)))
    return fail(ErrorCode::internal, "handles that are not where they were");
  return Done{};
}

EncodedConnectivity encode_script(DecodeScript script, Traversal traversal, int level) {
  const auto faces = static_cast<std::uint32_t>(script.contexts.size());
  const auto count = [&](Clers symbol) { return script.symbols[static_cast<unsigned>(symbol)]; };
  const auto ids =
      static_cast<std::size_t>(count(Clers::R) + count(Clers::L) + 3 * count(Clers::E));
  const CodedSymbols coded = encode_briefly(script, level, ids);

  EncodedConnectivity result;
  put_header(result.bytes, faces, static_cast<std::uint32_t>(script.vertices.size()),
             static_cast<std::uint32_t>(count(Clers::S)), coded.model);
  put_bytes(result.bytes, coded.bytes);
  result.special_cost = coded.special_cost;
  result.counts.symbols = script.symbols;
  result.counts.components = traversal.starts.size();
  result.counts.handles = coded.handles;
  result.counts.coded_holes = coded.holes;
  result.counts.boundary_curves = coded.holes + traversal.starts.size() - coded.closed_components;
  result.vertices = std::move(script.vertices);
  result.gates = std::move(traversal.gates);
  result.corners = std::move(traversal.corners);
  result.parts_of = std::move(traversal.parts_of);
  return result;
}

EncodedConnectivity encode_nothing() {
  EncodedConnectivity result;
  put_varint(result.bytes, 0);
  return result;
}

Expected<EncodedConnectivity> encode_fast(SurfaceArrays surface, int level, Kept kept) {
  if (surface.org.empty()) return encode_nothing();
  const bool valences = level >= 3;
  Traversal traversal;
  std::vector<HalfEdge> twins;
  if (kept == Kept::corners_and_twins) {
    KeepTwins witness(surface.org.size(), 3 * std::size_t(triangles_of(surface)));
    traversal = unbuild(surface, valences, witness, true);
    twins = std::move(witness.twins);
  } else {
    NoWitness witness;
    traversal = unbuild(surface, valences, witness, kept == Kept::corners);
  }
  if (auto ok = place_specials(traversal, !surface.sizes.empty(), valences); !ok)
    return Failure{ok.error()};
  DecodeScript script = script_of(traversal);
  EncodedConnectivity result = encode_script(std::move(script), std::move(traversal), level);
  result.twins = std::move(twins);
  return result;
}

CodedArrays coded_surface(std::uint32_t vertex_count, EncodedConnectivity& coded) {
  CodedArrays result;
  result.corners = std::move(coded.corners);
  result.twins = std::move(coded.twins);
  std::vector<std::uint32_t> number(vertex_count + coded.parts_of.size());
  for (std::uint32_t n = 0; n < coded.vertices.size(); ++n) number[coded.vertices[n]] = n;
  for (std::size_t i = 0; i < coded.parts_of.size(); ++i)
    number[vertex_count + i] = number[coded.parts_of[i]];
  result.introduced_by.resize(coded.vertices.size());
  for (std::size_t k = result.corners.size(); k-- > 0;) {  // the first triangle is the last to say
    std::uint32_t& corner = result.corners[k];
    corner = number[corner];
    result.introduced_by[corner] = static_cast<std::uint32_t>(k / 3);
  }
  return result;
}

Expected<EncodedConnectivity> encode_connectivity(SurfaceArrays surface, int level, Kept kept) try {
#ifdef CLERS_BOOKKEEPING
  std::vector<std::uint8_t> trace;
  return encode_on_surface(surface, level, kept, trace);
#else
  return encode_fast(surface, level, kept);
#endif
} catch (const std::bad_alloc&) {
  return fail(ErrorCode::out_of_memory, "not enough memory for the connectivity");
}

}  // namespace clers::internal
