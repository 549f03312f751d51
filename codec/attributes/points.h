// The vertices of a mesh of which several are at one place, where a surface is coded on whose
// vertices they are one: which corners are of which. Glue for what seams had split: the paper's
// Vertex and Point (CAGD 2010, Appendix A), as a stream. codec/format.md, Welded vertices.
//
// Points are to a welded surface what values are to wedges, and are coded alike (structure.h).
#ifndef CLERS_CODEC_ATTRIBUTES_POINTS_H
#define CLERS_CODEC_ATTRIBUTES_POINTS_H

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "codec/attributes/coded_faces.h"
#include "codec/attributes/structure.h"
#include "codec/entropy/stream.h"
#include "codec/error.h"

namespace clers::internal {

/// Which point each corner has, and where they are.
struct Points {
  ValueStructure structure;
  std::vector<std::uint32_t> place_of;  ///< of each point: the vertex of the welded surface. Last
                                        ///< come those of vertices that no corner has
};

/// How many of the vertices no corner has.
inline std::uint32_t count_isolated(const CodedFaces& faces, std::vector<bool>& used) {
  used.assign(faces.vertices, false);
  std::uint32_t count = faces.vertices;
  for (const std::uint32_t v : faces.corners) {
    count -= !used[v];
    used[v] = true;
  }
  return count;
}

/// Finds places of points once it is known which corners have them.
inline void find_places(const CodedFaces& faces, std::uint32_t count, Points& points) {
  std::vector<bool> used;
  const std::uint32_t isolated = count_isolated(faces, used);
  points.place_of.resize(count);
  for (std::size_t c = 0; c < faces.corners.size(); ++c)
    points.place_of[points.structure.value_of[c]] = faces.corners[c];
  std::uint32_t next = count - isolated;
  for (std::uint32_t v = 0; v < faces.vertices; ++v)
    if (!used[v]) points.place_of[next++] = v;
}

struct EncodedPoints {
  EncodedStream stream;
  Points points;
  std::vector<std::uint32_t> vertices;  ///< vertices[new] = old
};

/// `vertices[c]` is the old vertex of corner c of the welded faces; those at isolated vertices of
/// the welded surface follow in `isolated`. Returns no stream where corners of a vertex are too far
/// apart to be told that they are of one.
inline EncodedPoints encode_points(const CodedFaces& faces, std::span<const std::uint32_t> vertices,
                                   std::span<const std::uint32_t> isolated,
                                   std::uint32_t vertex_count) {
  struct Elements {
    std::span<const std::uint32_t> vertices;
    std::vector<std::uint32_t> list = {};
    bool same(std::uint32_t c, std::uint32_t d) const { return vertices[c] == vertices[d]; }
    std::vector<std::uint32_t> share(std::uint32_t, std::vector<std::uint32_t> corners) {
      list = std::move(corners);
      return {};
    }
  } elements{vertices};
  EncodedPoints out;
  StructureHeader header;
  header.any = true;
  header.values = no_value;
  out.points.structure.value_of.resize(faces.corners.size());
  Bytes bytes = encode_stream([&](EncodeTo& coder) {
    code_structure(coder, header, faces, Domain::corner, nullptr, elements, out.points.structure);
  });
  if (elements.list.size() + isolated.size() != vertex_count) return out;
  for (const std::uint32_t c : elements.list) out.vertices.push_back(vertices[c]);
  out.vertices.insert(out.vertices.end(), isolated.begin(), isolated.end());
  find_places(faces, vertex_count, out.points);
  out.stream = {{vertex_count}, std::move(bytes)};
  return out;
}

/// What a mesh says of its points before it is decoded.
struct PointsHeader {
  std::uint64_t points = 0;  ///< vertices of the mesh
  Stream stream;

  void read(ByteReader& in) { stream = read_stream(in, {&points}); }
  /// Why a mesh of so many corners and welded vertices cannot have them; empty: it can.
  std::string fault(std::uint64_t corners, std::uint64_t vertices) const {
    if (points > vertices && points <= vertices + corners && points < no_value - 1) return {};
    return std::to_string(points) + " vertices at " + std::to_string(vertices) + " places with " +
           std::to_string(corners) + " corners";
  }
  /// Bytes that decoding takes, the points themselves included.
  std::uint64_t memory(std::uint64_t corners, std::uint64_t vertices,
                       std::uint64_t half_edges) const {
    StructureHeader header;
    header.values = points;
    return 4 * corners + 4 * points + vertices / 8 + 8 +
           structure_memory(header, Domain::corner, corners, vertices, half_edges);
  }
};

/// Precondition: no fault, and the surface has twins. Error: invalid.
inline Expected<Points> decode_points(const PointsHeader& header, const CodedFaces& faces) {
  std::vector<bool> used;
  const std::uint32_t isolated = count_isolated(faces, used);
  Points points;
  points.structure.value_of.resize(faces.corners.size());
  auto ok = decode_stream(header.stream, "the points", [&](DecodeFrom& coder) -> std::string {
    StructureHeader structure;
    structure.any = true;
    structure.values = header.points - isolated;
    UnknownElements elements;
    if (code_structure(coder, structure, faces, Domain::corner, nullptr, elements,
                       points.structure))
      return {};
    return "corners have not the " + std::to_string(header.points) + " vertices that are declared";
  });
  if (!ok) return Failure{ok.error()};
  find_places(faces, static_cast<std::uint32_t>(header.points), points);
  return points;
}

/// Values of points, of those at their places.
inline std::vector<std::byte> at_places(std::span<const std::uint32_t> place_of,
                                        std::span<const std::byte> values, std::size_t stride) {
  std::vector<std::byte> result(place_of.size() * stride);
  for (std::size_t p = 0; p < place_of.size(); ++p)
    std::copy_n(values.begin() + static_cast<std::ptrdiff_t>(place_of[p] * stride), stride,
                result.begin() + static_cast<std::ptrdiff_t>(p * stride));
  return result;
}

}  // namespace clers::internal

#endif
