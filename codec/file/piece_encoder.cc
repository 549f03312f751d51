// Vertices that an earlier piece has are its seam; all others are numbered on.
#include "codec/file/piece_encoder.h"

#include <utility>

#include "codec/base/faces.h"
#include "codec/base/no_index.h"
#include "codec/file/attribute_sums.h"
#include "codec/file/file_order.h"
#include "codec/pieces/seams.h"

namespace clers::internal {
namespace {

/// Adds what is said of a piece that shares vertices with those before.
void add(const MeshInfo& piece, std::uint64_t shared, MeshInfo& whole, AttributeSums& sums) {
  whole.vertices += piece.vertices - shared;
  whole.faces += piece.faces;
  whole.corners += piece.corners;
  whole.triangles_only &= piece.triangles_only;
  whole.copied_vertices += piece.copied_vertices;
  whole.welded_vertices += piece.welded_vertices;
  whole.repeated_faces += piece.repeated_faces;
  whole.degenerate_faces += piece.degenerate_faces;
  whole.connectivity_bytes += piece.connectivity_bytes;
  whole.polygon_bytes += piece.polygon_bytes;
  whole.stitching_bytes += piece.stitching_bytes;
  for (std::size_t i = 0; i < piece.attributes.size(); ++i) {
    const AttributeInfo& a = piece.attributes[i];
    sums.add(i, a, a.count - (a.domain == Domain::vertex ? shared : 0));
  }
}

void add(const CodingCounts& piece, CodingCounts& whole) {
  whole.reversed_faces += piece.reversed_faces;
  for (std::size_t i = 0; i < piece.symbols.size(); ++i) whole.symbols[i] += piece.symbols[i];
}

}  // namespace

Expected<EncodedMesh> encode_piece(PieceCutter::Piece piece, std::span<const std::uint32_t> faces,
                                   const EncodeOptions& options,
                                   std::span<const AttributePlan> plans, const Progress& progress) {
  auto coded = encode_mesh(piece.mesh, options, plans, 1, progress);
  if (!coded) return coded;
  for (std::uint32_t& v : coded->order.vertices) v = piece.vertices[v];
  for (std::uint32_t& f : coded->order.faces) f = faces[f];
  return coded;
}

EncodedMesh join_pieces(std::vector<EncodedMesh> pieces, const MeshView& mesh, Order order) {
  EncodedMesh whole;
  Bytes count;
  put_varint(count, pieces.size());
  whole.sections.push_back({SectionKind::pieces, std::move(count)});
  whole.info.name = mesh.name;
  whole.info.pieces = pieces.size();
  whole.order.vertices.reserve(mesh.vertex_count);
  whole.order.faces.reserve(mesh.face_count());
  whole.order.first_corners.reserve(mesh.face_count());
  std::vector<std::uint32_t> number(mesh.vertex_count, no_index), numbers;
  AttributeSums sums(whole.info);
  for (EncodedMesh& piece : pieces) {
    const std::uint32_t first_own = static_cast<std::uint32_t>(whole.order.vertices.size());
    numbers.clear();
    for (const std::uint32_t v : piece.order.vertices) {
      if (number[v] == no_index) {
        number[v] = static_cast<std::uint32_t>(whole.order.vertices.size());
        whole.order.vertices.push_back(v);
      }
      numbers.push_back(number[v]);
    }
    const auto append = [](std::vector<std::uint32_t>& to, const std::vector<std::uint32_t>& from) {
      to.insert(to.end(), from.begin(), from.end());
    };
    append(whole.order.faces, piece.order.faces);
    append(whole.order.first_corners, piece.order.first_corners);

    const std::size_t shared = numbers.size() - (whole.order.vertices.size() - first_own);
    for (EncodedSection& section : piece.sections) {
      const bool is_mesh = section.kind == SectionKind::mesh;
      whole.sections.push_back(std::move(section));
      if (!is_mesh || shared == 0) continue;
      Bytes seam = encode_seam(shared, numbers, first_own);
      whole.info.connectivity_bytes += seam.size();
      whole.info.stitching_bytes += seam.size();
      whole.sections.push_back({SectionKind::seam, std::move(seam)});
    }
    add(piece.info, shared, whole.info, sums);
    add(piece.counts, whole.counts);
    piece = {};
  }
  if (!mesh.name.empty()) {
    const auto name = std::as_bytes(std::span(mesh.name));
    whole.sections.push_back({SectionKind::name, Bytes(name.begin(), name.end())});
  }
  if (order == Order::keep) {
    Bytes kept = encode_order(Cycles(mesh.corners, mesh.face_sizes), whole.order);
    whole.info.order_bytes = kept.size();
    whole.info.connectivity_bytes += kept.size();
    whole.sections.push_back({SectionKind::order, std::move(kept)});
    whole.order = identity(mesh);
  }
  return whole;
}

}  // namespace clers::internal
