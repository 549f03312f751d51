#include "codec/pieces/pieces.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "codec/file/mesh_features.h"
#include "codec/pieces/seams.h"

namespace clers::internal {
namespace {

constexpr std::uint32_t none = 0xffffffffu;

/// Adds what is told of a piece that shares vertices with those before.
void add(const MeshInfo& piece, std::uint64_t shared, MeshInfo& whole) {
  whole.vertices += piece.vertices - shared;
  whole.faces += piece.faces;
  whole.corners += piece.corners;
  whole.triangles_only &= piece.triangles_only;
  whole.copied_vertices += piece.copied_vertices;
  whole.repeated_faces += piece.repeated_faces;
  whole.degenerate_faces += piece.degenerate_faces;
  whole.connectivity_bytes += piece.connectivity_bytes;
  whole.polygon_bytes += piece.polygon_bytes;
  whole.stitching_bytes += piece.stitching_bytes;
  whole.position_bytes += piece.position_bytes;
  whole.attribute_bytes += piece.attribute_bytes;
  const bool first = whole.attributes.empty();
  for (std::size_t i = 0; i < piece.attributes.size(); ++i) {
    const AttributeInfo& a = piece.attributes[i];
    if (first) whole.attributes.push_back({a.name, a.domain, a.scalar, a.components, 0, 0});
    whole.attributes[i].count += a.count - (a.domain == Domain::vertex ? shared : 0);
    whole.attributes[i].bytes += a.bytes;
  }
}

void add(const CodingCounts& piece, CodingCounts& whole) {
  whole.reversed_faces += piece.reversed_faces;
  for (std::size_t i = 0; i < piece.symbols.size(); ++i) whole.symbols[i] += piece.symbols[i];
}

}  // namespace

PieceCutter::PieceCutter(const MeshView& mesh, Partition parts)
    : mesh_(mesh), parts_(std::move(parts)) {
  begins_.reserve(mesh.face_sizes.size());
  std::uint32_t begin = 0;
  for (const std::uint32_t size : mesh.face_sizes) {
    begins_.push_back(begin);
    begin += size;
  }
  std::vector<bool> used(mesh.vertex_count);
  for (const std::uint32_t v : mesh.corners) used[v] = true;
  for (std::uint32_t v = 0; v < mesh.vertex_count; ++v)
    if (!used[v]) isolated_.push_back(v);
}

PieceCutter::Piece PieceCutter::cut(std::size_t piece, std::vector<std::uint32_t>& number) const {
  Piece result;
  Mesh& mesh = result.mesh;
  number.resize(std::max<std::size_t>(number.size(), mesh_.vertex_count), none);
  const auto faces = parts_.piece(piece);
  mesh.corners.reserve(3 * faces.size());
  const auto size = [&](std::uint32_t f) { return begins_.empty() ? 3 : mesh_.face_sizes[f]; };
  const auto begin = [&](std::uint32_t f) {
    return begins_.empty() ? 3 * std::size_t(f) : begins_[f];
  };
  for (const std::uint32_t f : faces) {
    const std::uint32_t* corner = mesh_.corners.data() + begin(f);
    for (std::uint32_t j = 0; j < size(f); ++j) {
      std::uint32_t& v = number[corner[j]];
      if (v == none) {
        v = static_cast<std::uint32_t>(result.vertices.size());
        result.vertices.push_back(corner[j]);
      }
      mesh.corners.push_back(v);
    }
    if (!begins_.empty()) mesh.face_sizes.push_back(size(f));
  }
  for (const std::uint32_t v : result.vertices) number[v] = none;
  if (piece + 1 == parts_.count())
    result.vertices.insert(result.vertices.end(), isolated_.begin(), isolated_.end());
  mesh.vertex_count = static_cast<std::uint32_t>(result.vertices.size());

  for (const AttributeView a : mesh_.attributes) {
    Attribute part{std::string(a.name), a.domain, a.scalar, a.components, {}};
    const std::size_t value_size = a.value_size(), step = a.step();
    const auto copy = [&](std::size_t value) {
      const std::byte* from = a.data.data() + value * step;
      part.data.insert(part.data.end(), from, from + value_size);
    };
    switch (a.domain) {
      case Domain::vertex:
        part.data.reserve(result.vertices.size() * value_size);
        for (const std::uint32_t v : result.vertices) copy(v);
        break;
      case Domain::face:
        part.data.reserve(faces.size() * value_size);
        for (const std::uint32_t f : faces) copy(f);
        break;
      case Domain::corner:
        part.data.reserve(mesh.corners.size() * value_size);
        for (const std::uint32_t f : faces)
          for (std::uint32_t j = 0; j < size(f); ++j) copy(begin(f) + j);
        break;
    }
    mesh.attributes.push_back(std::move(part));
  }
  return result;
}

Expected<EncodedMesh> encode_piece(PieceCutter::Piece piece, std::span<const std::uint32_t> faces,
                                   const EncodeOptions& options, const Progress& progress) {
  auto coded = encode_mesh(piece.mesh, options, 1, progress);
  if (!coded) return coded;
  for (std::uint32_t& v : coded->order.vertices) v = piece.vertices[v];
  for (std::uint32_t& f : coded->order.faces) f = faces[f];
  return coded;
}

EncodedMesh join(std::vector<EncodedMesh> pieces, const MeshView& mesh) {
  EncodedMesh whole;
  Bytes count;
  put_varint(count, pieces.size());
  whole.sections.push_back({SectionKind::pieces, std::move(count)});
  whole.info.name = mesh.name;
  whole.info.pieces = pieces.size();
  whole.order.vertices.reserve(mesh.vertex_count);
  whole.order.faces.reserve(mesh.face_count());
  whole.order.first_corners.reserve(mesh.face_count());
  std::vector<std::uint32_t> number(mesh.vertex_count, none), numbers;
  for (EncodedMesh& piece : pieces) {
    const std::uint32_t first_own = static_cast<std::uint32_t>(whole.order.vertices.size());
    numbers.clear();
    for (const std::uint32_t v : piece.order.vertices) {
      if (number[v] == none) {
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
      Bytes seam;
      put_varint(seam, shared);
      rans::Encoder stream;
      EncodeTo coder(stream);
      SeamModel model;
      for (const SeamRun& run : seam_runs(numbers, first_own)) model.code(coder, run);
      stream.finish(seam);
      whole.info.connectivity_bytes += seam.size();
      whole.info.stitching_bytes += seam.size();
      whole.sections.push_back({SectionKind::seam, std::move(seam)});
    }
    add(piece.info, shared, whole.info);
    add(piece.counts, whole.counts);
    piece = {};
  }
  return whole;
}

}  // namespace clers::internal
