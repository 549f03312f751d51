#include <algorithm>
#include <new>
#include <optional>
#include <type_traits>

#include "codec/connectivity/connectivity.h"
#include "codec/connectivity/decode_script.h"
#include "codec/connectivity/event_writer.h"
#include "codec/connectivity/place_handles.h"
#include "codec/connectivity/replayed_script.h"
#include "codec/connectivity/spirale_reversi.h"
#include "codec/entropy/bytes.h"
#include "codec/entropy/rans.h"
#include "codec/symbols/choose_model.h"
#include "codec/symbols/context_models.h"
#include "codec/symbols/mixing_model.h"
#include "codec/symbols/prefix_code.h"
#include "topology/mirror.h"

namespace clers::internal {
namespace {

static_assert(Traversal::max_valence == ContextTables::max_valence);

/// Writes symbols and events while the surface is built once more, with all that the decoder will
/// know of it.
class EncodingSource : public EventWriter {
 public:
  EncodingSource(const DecodeScript& script, std::size_t ids, rans::Encoder& out)
      : EventWriter(script.events, out),
        contexts_(script.contexts),
        coder_(out),
        model_(contexts_.size(), ids) {}

  void first() { ++next_; }
  template <class Front, class Gate, class Then>
  auto symbol(const Front& front, const Gate& gate, std::size_t aside, Then then) {
    symbol_begins();
    const Clers symbol = static_cast<Clers>(contexts_[next_++] & 7);
    model_.code(coder_, front, gate, aside, symbol);
    return with_symbol(symbol, then);
  }

 private:
  const std::vector<std::uint8_t>& contexts_;
  std::size_t next_ = 0;
  EncodeTo coder_;
  MixingModel model_;
};

/// What follows the header, and what it says.
struct CodedSymbols {
  SymbolModel model;
  Bytes bytes;
  std::uint64_t handles = 0, holes = 0, closed_components = 0, special_cost = 0;
};

/// Encodes the symbols and events with a model.
CodedSymbols encode_symbols(SymbolModel model, const DecodeScript& script, std::size_t ids) {
  CodedSymbols coded;
  coded.model = model;
  rans::Encoder stream;
  const auto finish = [&](const EventWriter& events) {
    coded.handles = events.handles;
    coded.holes = events.holes;
    coded.closed_components = events.closed_components;
    coded.special_cost = events.special_cost;
    stream.finish(coded.bytes);
  };
  const std::uint32_t faces = static_cast<std::uint32_t>(script.contexts.size());
  if (model.kind == SymbolModel::Kind::mixing) {
    std::vector<std::uint32_t> corners(3 * faces);
    std::vector<FrontLink> links(ids);
    Building building;
    building.corners = corners;
    building.links = links;
    NoPairing none;
    EncodingSource source(script, ids, stream);
    SpiraleReversi<NoPairing, EncodingSource>(building, none, source).run();
    finish(source);
    return coded;
  }
  EventWriter events(script.events, stream);
  // put(symbol, valence) for each, and the events where they are asked for.
  const auto put_all = [&](auto put) {
    const std::uint8_t* const contexts = script.contexts.data();
    const auto put_at = [&](std::uint32_t i) {
      if (i > 0) put(static_cast<Clers>(contexts[i] & 7), contexts[i] >> 3);
    };
    for (std::uint32_t i = 0;; ++i) {
      for (const std::uint32_t next = std::min(events.next_symbol(), faces); i < next; ++i)
        put_at(i);
      if (i == faces) break;
      events.symbol_begins();
      put_at(i);
      events.write_after(i);
    }
  };
  const auto encode_with = [&](auto symbols) {
    if (!symbols.ok()) throw std::bad_alloc();
    stream.reserve(faces + 4 * script.events.size());
    put_all([&](Clers symbol, std::uint32_t kx) { stream.put(symbols.encode(symbol, kx)); });
  };
  switch (model.kind) {
    case SymbolModel::Kind::single: encode_with(SingleModel(model.history)); break;
    case SymbolModel::Kind::code: {
      SymbolWriter symbols(faces);
      put_all([&](Clers symbol, std::uint32_t) { symbols.put(symbol); });
      const Bytes code = symbols.finish();
      put_varint(coded.bytes, code.size());
      put_bytes(coded.bytes, code);
      break;
    }
    default:
      encode_with(PairModel(model.history, model.kind == SymbolModel::Kind::quick_pair));
      break;
  }
  finish(events);
  if (model.kind == SymbolModel::Kind::code)  // the symbols S, 4 bits each
    coded.special_cost += 4 * 256 * (coded.holes + 2 * coded.handles);
  return coded;
}

/// Encodes with the model of a level, or of a lower one where that takes fewer bytes: the more a
/// model has to learn, the less it pays where there is little to learn from, or little to say. So
/// no level is larger than those below. To look costs half as much again, and is done where it may
/// matter.
CodedSymbols encode_briefly(const DecodeScript& script, int level, std::size_t ids) {
  using Kind = SymbolModel::Kind;
  const SymbolModel model = choose_model(script.contexts, level);
  CodedSymbols coded = encode_symbols(model, script, ids);
  const std::size_t size = coded.bytes.size();
  const bool little =
      size > 96 && size < std::min<std::size_t>(512, script.contexts.size() * 3 / 64);
  if (model.kind == Kind::mixing || (level >= 5 && little)) {
    CodedSymbols simpler = encode_briefly(script, model.kind == Kind::mixing ? 5 : 3, ids);
    if (simpler.bytes.size() < coded.bytes.size()) return simpler;
  }
  return coded;
}

void put_header(Bytes& out, std::uint32_t faces, std::uint32_t vertices, std::uint32_t merges,
                SymbolModel model) {
  put_varint(out, faces);
  put_signed_varint(out, 2 * std::int64_t(vertices) - faces - 4);
  std::uint32_t room = 0;
  while (room_for_merges(room) < merges) ++room;
  put_u8(out, room);
  put_u8(out, model.byte());
}

template <class Witness>
Witness make_witness(const SurfaceArrays& arrays) {
  if constexpr (std::is_same_v<Witness, NoWitness>) {
    return {};
  } else {
    std::vector<Vertex> org(arrays.org.size());
    for (std::size_t h = 0; h < org.size(); ++h) org[h] = Vertex(arrays.org[h]);
    auto surface = Surface::from_twins(org, arrays.twins, arrays.vertex_count);
    return Witness(surface ? std::move(*surface) : Surface());
  }
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

std::uint32_t triangles_of(const SurfaceArrays& surface) {
  return static_cast<std::uint32_t>(surface.sizes.empty()
                                        ? surface.org.size() / 3
                                        : surface.org.size() - 2 * surface.sizes.size());
}

template <class Witness>
Traversal unbuild(const SurfaceArrays& surface, bool valences, Witness& witness) {
  if (!surface.sizes.empty())
    return Edgebreaker<PolygonFaces, Witness, false>(surface, witness).run();
  return valences ? Edgebreaker<TriangleFaces, Witness, true>(surface, witness).run()
                  : Edgebreaker<TriangleFaces, Witness, false>(surface, witness).run();
}

template <bool on_full_surface>
Expected<EncodedConnectivity> encode(SurfaceArrays surface, int level, bool with_twins,
                                     OperatorTrace* trace);

/// Polygons as they are, and then their triangles on a full surface.
Expected<EncodedConnectivity> encode_polygons_on_surface(SurfaceArrays surface, int level,
                                                         OperatorTrace* trace) {
  auto coded = encode<false>(surface, level, true, nullptr);
  if (!coded) return coded;
  const std::vector<std::uint32_t> corners = triangle_corners(surface, coded->gates);
  std::vector<HalfEdge> twins = coded->twins;
  const auto again = encode<true>({corners, twins, surface.vertex_count}, level, true, trace);
  if (!again) return again;
  bool same = again->bytes == coded->bytes && again->vertices == coded->vertices &&
              again->twins == coded->twins;
  for (std::uint32_t i = 0; i < again->gates.size(); ++i)
    same &= again->gates[i] == half_edge(Face(i), 0);
  if (!same) return fail(ErrorCode::internal, "polygons and their triangles are not coded alike");
  return coded;
}

template <bool on_full_surface>
Expected<EncodedConnectivity> encode(SurfaceArrays surface, int level, bool with_twins,
                                     OperatorTrace* trace) {
  const bool polygons = !surface.sizes.empty();
  if (on_full_surface && polygons) return encode_polygons_on_surface(surface, level, trace);
  EncodedConnectivity result;
  const std::uint32_t faces = triangles_of(surface);
  if (faces == 0) {
    put_varint(result.bytes, 0);
    return result;
  }
  const bool valences = on_full_surface || level >= 3;
  Traversal traversal;
  if (with_twins) {
    std::vector<HalfEdge> copy;
    SurfaceArrays arrays = surface;
    if (on_full_surface) {
      copy.assign(surface.twins.begin(), surface.twins.end());
      arrays.twins = copy;
    }
    KeepTwins witness(surface.org.size(), 3 * std::size_t(faces));
    traversal = unbuild(arrays, valences, witness);
    result.twins = std::move(witness.twins);
  }
  using Witness = std::conditional_t<on_full_surface, UnbuildingMirror, NoWitness>;
  Witness witness = make_witness<Witness>(surface);
  if (on_full_surface || !with_twins) traversal = unbuild(surface, valences, witness);
  if (traversal.trouble == Traversal::Trouble::several_fans)  // a surface has a vertex for each
    return fail(ErrorCode::nonmanifold_vertex, "the faces of a vertex form more than one fan");
  const bool uncounted = polygons && valences;
  if ((traversal.handles || uncounted) &&
      !(uncounted ? place_handles_and_count_valences(traversal) : place_handles(traversal)))
    return fail(ErrorCode::internal, "handles that are not where they were");

  std::optional<DecodeScript> built;
  if constexpr (on_full_surface) {
    BuildingMirror pairing(3 * std::size_t(faces));
    built = replayed_script(surface.org, surface.vertex_count, traversal, pairing);
    if (!built || !agree(witness, pairing))
      return fail(ErrorCode::internal, "the fast operators and the full surface do not agree");
    if (trace) *trace = std::move(witness.trace);
  }
  DecodeScript script = script_of(traversal);
  if (built && !agree(script, *built))
    return fail(ErrorCode::internal, "the script is not that of the surface built again");

  result.counts.symbols = script.symbols;
  const auto count = [&](Clers symbol) { return script.symbols[static_cast<unsigned>(symbol)]; };
  const auto ids =
      static_cast<std::size_t>(count(Clers::R) + count(Clers::L) + 3 * count(Clers::E));

  const CodedSymbols coded = encode_briefly(script, level, ids);
  put_header(result.bytes, faces, static_cast<std::uint32_t>(script.vertices.size()),
             static_cast<std::uint32_t>(count(Clers::S)), coded.model);
  put_bytes(result.bytes, coded.bytes);
  result.special_cost = coded.special_cost;
  result.counts.components = traversal.starts.size();
  result.counts.handles = coded.handles;
  result.counts.coded_holes = coded.holes;
  result.counts.boundary_curves = coded.holes + traversal.starts.size() - coded.closed_components;

  result.vertices = std::move(script.vertices);
  result.gates = std::move(traversal.gates);
  return result;
}

#ifdef CLERS_BOOKKEEPING
constexpr bool bookkeeping = true;
#else
constexpr bool bookkeeping = false;
#endif

}  // namespace

std::vector<std::uint32_t> triangle_corners(const SurfaceArrays& surface,
                                            std::span<const HalfEdge> gates) {
  std::vector<std::uint32_t> corners(3 * std::size_t(triangles_of(surface)));
  std::uint32_t* out = corners.data();
  const auto put = [&](HalfEdge a, HalfEdge b, HalfEdge v) {
    for (const HalfEdge h : {a, b, v}) *out++ = surface.org[h.index()];
  };
  if (surface.sizes.empty()) {
    for (const HalfEdge gate : gates) put(gate, lnext(gate), lprev(gate));
    return corners;
  }
  const PolygonFaces faces(surface.twins, surface.sizes);
  for (HalfEdge a : gates) {
    const HalfEdge b = faces.next(a);
    for (HalfEdge v = faces.prev(a); v != b; v = faces.prev(v)) {
      put(a, b, v);
      a = v;
    }
  }
  return corners;
}

CodedArrays coded_surface(const SurfaceArrays& surface, EncodedConnectivity& coded) {
  CodedArrays result;
  result.corners = triangle_corners(surface, coded.gates);
  result.twins = std::move(coded.twins);
  std::vector<std::uint32_t> number(surface.vertex_count);
  for (std::uint32_t n = 0; n < coded.vertices.size(); ++n) number[coded.vertices[n]] = n;
  result.introduced_by.resize(coded.vertices.size());
  for (std::size_t k = result.corners.size(); k-- > 0;) {  // the first triangle is the last to say
    std::uint32_t& corner = result.corners[k];
    corner = number[corner];
    result.introduced_by[corner] = static_cast<std::uint32_t>(k / 3);
  }
  return result;
}

Expected<EncodedConnectivity> encode_connectivity(SurfaceArrays surface, int level,
                                                  bool with_twins) try {
  return encode<bookkeeping>(surface, level, with_twins, nullptr);
} catch (const std::bad_alloc&) {
  return fail(ErrorCode::out_of_memory, "not enough memory for the connectivity");
}

Expected<EncodedConnectivity> encode_connectivity_on_surface(SurfaceArrays surface, int level,
                                                             OperatorTrace& trace) try {
  return encode<true>(surface, level, false, &trace);
} catch (const std::bad_alloc&) {
  return fail(ErrorCode::out_of_memory, "not enough memory for the connectivity");
}

}  // namespace clers::internal
