// The bytes of one surface -> its triangles (CAGD 2010, §7.2, Algorithm 3). Sizes are checked
// before anything is allocated; the driver runs over the stream; ids of the construction become
// numbers.
#include <algorithm>
#include <memory>
#include <new>
#include <optional>

#include "codec/connectivity/connectivity.h"
#include "codec/connectivity/spirale_reversi.h"
#include "codec/connectivity/stream_source.h"
#include "codec/entropy/bytes.h"
#ifdef CLERS_BOOKKEEPING
#include "topology/mirror.h"
#endif

namespace clers::internal {
namespace {

/// A symbol takes at least log2(32768 / 32756) bits, so a byte holds fewer than this many.
constexpr std::uint64_t max_symbols_per_byte = 16384;

const char* explain(StreamFault broken) {
  switch (broken) {
    case StreamFault::none: break;
    case StreamFault::too_many_vertices: return "more vertices than declared";
    case StreamFault::too_many_merges: return "more S than declared";
    case StreamFault::c_on_two_edges: return "C where the boundary curve has two edges";
    case StreamFault::s_without_gate: return "S without a part to join";
    case StreamFault::curve_too_short:
      return "a handle on a boundary curve that is too short for it";
    case StreamFault::position: return "a hole or handle where no surface has one";
    case StreamFault::waiting_curve: return "a handle with one end";
    case StreamFault::gate_left: return "parts that no S joins";
    case StreamFault::vertex_count: return "fewer vertices than declared";
  }
  return "";
}

Failure<Error> broken_stream(StreamError b) {
  return fail(ErrorCode::invalid, Place::symbol, b.symbol, explain(b.broken));
}

bool repeats_a_vertex(std::span<const std::uint32_t> corners) {
  for (std::size_t h = 0; h < corners.size(); h += 3)
    if (corners[h] == corners[h + 1] || corners[h + 1] == corners[h + 2] ||
        corners[h + 2] == corners[h])
      return true;
  return false;
}

/// The driver makes faces in the opposite order of the one they are given in.
void reverse_faces(std::span<HalfEdge> twins) {
  const std::uint32_t faces = static_cast<std::uint32_t>(twins.size() / 3), last = faces - 1;
  for (std::uint32_t f = 0; f < faces - f; ++f)
    for (unsigned i = 0; i < 3; ++i)
      std::swap(twins[3 * std::size_t(f) + i], twins[3 * std::size_t(last - f) + i]);
  for (HalfEdge& h : twins)
    if (h) h = half_edge(Face(last - left(h).index()), corner(h));
}

template <class Source>
Expected<ConnectivityCounts> decode(Source& source, std::uint64_t end,
                                    const ConnectivityHeader& header,
                                    std::span<std::uint32_t> corners, std::span<HalfEdge> twins,
                                    std::span<std::uint32_t> introduced_by) {
  if (!source.ok()) throw std::bad_alloc();
  const std::size_t ids = std::size_t(header.vertices) + header.merges;
  const std::unique_ptr<FrontLink[]> links(new FrontLink[ids]);
  Building building;
  building.corners = corners;
  building.links = {links.get(), ids};
  building.merges = header.merges;
  building.merged.reserve(header.merges);

  StreamError breakage;
#ifdef CLERS_BOOKKEEPING
  std::optional<BuildingMirror> mirror;
#endif
  if (!twins.empty()) {
    std::vector<HalfEdge> into(ids);
    Opposites pairing(twins, into);
    breakage = SpiraleReversi<Opposites, Source>(building, pairing, source).run();
  } else {
#ifdef CLERS_BOOKKEEPING
    mirror.emplace(ids);
    breakage = SpiraleReversi<BuildingMirror, Source>(building, *mirror, source).run();
    if (!mirror->agrees)
      return fail(ErrorCode::internal, "the front and the full surface do not agree");
#else
    NoPairing pairing;
    breakage = SpiraleReversi<NoPairing, Source>(building, pairing, source).run();
#endif
  }
  if (breakage.broken != StreamFault::none) return broken_stream(breakage);
  if (building.finished != header.vertices)
    return broken_stream({StreamFault::vertex_count, header.faces});
  if (!source.finished())
    return fail(ErrorCode::invalid, Place::byte, end, "the symbols do not end where the data end");
  number_vertices(building, introduced_by);
#ifdef CLERS_BOOKKEEPING
  if (mirror && !mirror->same_vertices(corners))
    return fail(ErrorCode::internal, "the vertices are not those of the full surface");
#endif
  // Only the glue of a hole or handle can bring together two vertices of one face.
  if (source.counts.coded_holes + source.counts.handles > 0 && repeats_a_vertex(corners))
    return broken_stream({StreamFault::position, header.faces});
  if (!twins.empty()) reverse_faces(twins);
  source.counts.boundary_curves =
      source.counts.coded_holes + source.counts.components - source.closed_components;
  return source.counts;
}

}  // namespace

Expected<ConnectivityHeader> read_connectivity_header(std::span<const std::byte> bytes,
                                                      std::uint64_t at) {
  ByteReader in(bytes, at);
  ConnectivityHeader header;
  const std::uint64_t faces = in.varint();
  if (in.ok() && faces == 0) {
    header.bytes = in.position();
    return header;
  }
  const std::int64_t excess = in.signed_varint();
  const std::uint32_t room = in.u8(), model_byte = in.u8();
  if (!in.ok()) return Failure{in.error()};
  const auto invalid = [&](std::string what) {
    return fail(ErrorCode::invalid, Place::byte, at, std::move(what));
  };
  if (faces > max_faces) return invalid("too many faces: " + std::to_string(faces));
  if (faces > max_symbols_per_byte * in.left())
    return invalid(std::to_string(faces) + " faces cannot be coded in " +
                   std::to_string(in.left()) + " bytes");
  const std::int64_t most = 3 * static_cast<std::int64_t>(faces);
  const std::int64_t twice = std::clamp(excess, -2 * most, 2 * most) + most / 3 + 4;
  const std::int64_t vertices = twice / 2;
  if (twice % 2 != 0 || vertices < 3 || vertices > most)
    return invalid("vertices that cannot belong to " + std::to_string(faces) + " faces");
  const std::int64_t merges =
      std::min(static_cast<std::int64_t>(room_for_merges(room)), most - vertices);
  const std::optional<SymbolModel> model = SymbolModel::of(model_byte);
  if (!model) return invalid("no model has the number " + std::to_string(model_byte));
  header.model = *model;
  if (model->kind == SymbolModel::Kind::code) {
    const std::uint64_t symbol_bytes = in.varint();
    if (!in.ok()) return Failure{in.error()};
    if (symbol_bytes > in.left()) return invalid("more bytes of symbols than there are");
    if (faces - 1 > 8 * symbol_bytes) return invalid("fewer bytes of symbols than faces take");
    header.symbol_bytes = static_cast<std::size_t>(symbol_bytes);
  }
  header.faces = static_cast<std::uint32_t>(faces);
  header.vertices = static_cast<std::uint32_t>(vertices);
  header.merges = static_cast<std::uint32_t>(merges);
  header.bytes = in.position();
  return header;
}

std::uint64_t connectivity_memory(const ConnectivityHeader& header, bool twins) {
  if (header.faces == 0) return 0;
  const std::uint64_t ids = std::uint64_t(header.vertices) + header.merges;
  // Each S takes back a gate, or adds to the curves that wait or to the holes. Those lists grow by
  // doubling: three times their length while they move.
  constexpr std::uint64_t lists = 3 * (sizeof(Front<Opposites>::Gate) + sizeof(std::uint32_t));
  const std::uint64_t model = header.model.kind == SymbolModel::Kind::mixing
                                  ? MixingModel::memory(header.faces, ids)
                                  : ContextTables::most_memory;
  return ids * (sizeof(FrontLink) + (twins ? sizeof(HalfEdge) : 0)) +
         header.merges * (sizeof(std::uint32_t) + lists) + model;
}

Expected<ConnectivityCounts> decode_connectivity(std::span<const std::byte> bytes, std::uint64_t at,
                                                 const ConnectivityHeader& header,
                                                 std::span<std::uint32_t> corners,
                                                 std::span<HalfEdge> twins,
                                                 std::span<std::uint32_t> introduced_by) {
  if (header.faces == 0) {
    if (bytes.size() != header.bytes)
      return fail(ErrorCode::invalid, Place::byte, at + header.bytes,
                  "bytes after the last symbol");
    return ConnectivityCounts{};
  }
  return with_stream_source(header, bytes, [&](auto& source) {
    return decode(source, at + bytes.size(), header, corners, twins, introduced_by);
  });
}

}  // namespace clers::internal
