#include <memory>
#include <new>

#include "codec/bytes.h"
#include "codec/connectivity.h"
#include "codec/spirale_reversi.h"
#include "codec/stream_source.h"
#include "topology/mirror.h"

namespace clers {
namespace {

/// A symbol takes at least log2(32768 / 32756) bits, so a byte holds fewer than this many.
constexpr std::uint64_t max_symbols_per_byte = 16384;

const char* explain(Broken broken) {
  switch (broken) {
    case Broken::none: break;
    case Broken::too_many_vertices: return "more vertices than declared";
    case Broken::c_on_two_edges: return "C where the boundary curve has two edges";
    case Broken::s_without_gate: return "S without a part to join";
    case Broken::curve_too_short: return "a handle on a boundary curve that is too short for it";
    case Broken::position: return "a hole or handle outside its boundary curve";
    case Broken::waiting_curve: return "a handle with one end";
    case Broken::gate_left: return "parts that no S joins";
    case Broken::vertex_count: return "fewer vertices than declared";
    case Broken::work: return "more steps along boundary curves than allowed";
    case Broken::stream: return "the symbols end too early";
  }
  return "";
}

Failure<Error> broken_stream(Breakage b) {
  const ErrorCode code = b.broken == Broken::work ? ErrorCode::limit : ErrorCode::invalid;
  return fail(code, Place::symbol, b.symbol, explain(b.broken));
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

#ifdef CLERS_BOOKKEEPING
constexpr bool bookkeeping = true;
#else
constexpr bool bookkeeping = false;
#endif

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
  const std::uint64_t vertices = in.varint(), merges = in.varint();
  const std::uint32_t history = in.u8();
  if (!in.ok()) return Failure{in.error()};
  const auto invalid = [&](std::string what) {
    return fail(ErrorCode::invalid, Place::byte, at, std::move(what));
  };
  if (faces > max_faces) return invalid("too many faces: " + std::to_string(faces));
  if (faces > max_symbols_per_byte * in.left())
    return invalid(std::to_string(faces) + " faces cannot be coded in " +
                   std::to_string(in.left()) + " bytes");
  if (vertices < 3 || vertices > 3 * faces || merges > 3 * faces - vertices)
    return invalid(std::to_string(vertices) + " vertices and " + std::to_string(merges) +
                   " merges cannot belong to " + std::to_string(faces) + " faces");
  if (history < 1 || history > SymbolModel::max_history)
    return invalid("a history of " + std::to_string(history) + " symbols, expected 1 to 8");
  header.faces = static_cast<std::uint32_t>(faces);
  header.vertices = static_cast<std::uint32_t>(vertices);
  header.merges = static_cast<std::uint32_t>(merges);
  header.history = history;
  header.bytes = in.position();
  return header;
}

Expected<ConnectivityCounts> decode_connectivity(std::span<const std::byte> bytes, std::uint64_t at,
                                                 const ConnectivityHeader& header,
                                                 std::span<std::uint32_t> corners,
                                                 std::span<HalfEdge> twins) try {
  const std::size_t ids = std::size_t(header.vertices) + header.merges;
  if (header.faces == 0) {
    if (bytes.size() != header.bytes)
      return fail(ErrorCode::invalid, Place::byte, at + header.bytes,
                  "bytes after the last symbol");
    return ConnectivityCounts{};
  }
  StreamSource source(bytes.subspan(header.bytes), header.history);
  if (!source.ok()) throw std::bad_alloc();
  const std::unique_ptr<FrontLink[]> links(new FrontLink[ids]);
  Building building;
  building.corners = corners;
  building.links = {links.get(), ids};

  Breakage breakage;
  if (!twins.empty()) {
    std::vector<HalfEdge> into(ids);
    Opposites pairing(twins, into);
    breakage = SpiraleReversi<Opposites, StreamSource>(building, pairing, source).run();
  } else if constexpr (bookkeeping) {
    BuildingMirror pairing(ids);
    breakage = SpiraleReversi<BuildingMirror, StreamSource>(building, pairing, source).run();
    if (!pairing.agrees)
      return fail(ErrorCode::internal, "the front and the full surface do not agree");
  } else {
    NoPairing pairing;
    breakage = SpiraleReversi<NoPairing, StreamSource>(building, pairing, source).run();
  }
  if (breakage.broken != Broken::none) return broken_stream(breakage);
  if (building.finished != header.vertices || building.merged.size() != header.merges)
    return broken_stream({Broken::vertex_count, header.faces});
  if (!source.finished())
    return fail(ErrorCode::invalid, Place::byte, at + bytes.size(),
                "the symbols do not end where the data end");
  number_vertices(building);
  if (!twins.empty()) reverse_faces(twins);
  source.counts.boundary_curves =
      source.counts.coded_holes + source.counts.components - source.closed_components;
  return source.counts;
} catch (const std::bad_alloc&) {
  return fail(ErrorCode::out_of_memory, "not enough memory for the connectivity");
}

}  // namespace clers
