#include "codec/pieces/piece_cutter.h"

#include <algorithm>
#include <utility>

#include "codec/base/no_index.h"

namespace clers::internal {
PieceCutter::PieceCutter(const Mesh& mesh, Partition parts)
    : mesh_(mesh), parts_(std::move(parts)), all_(mesh.corners, mesh.face_sizes) {
  std::vector<bool> used(mesh.vertex_count);
  for (const std::uint32_t v : mesh.corners) used[v] = true;
  for (std::uint32_t v = 0; v < mesh.vertex_count; ++v)
    if (!used[v]) isolated_.push_back(v);
}

PieceCutter::Piece PieceCutter::cut(std::size_t piece, std::vector<std::uint32_t>& number) const {
  Piece result;
  Mesh& mesh = result.mesh;
  number.resize(std::max<std::size_t>(number.size(), mesh_.vertex_count), no_index);
  const auto faces = parts_.piece(piece);
  mesh.corners.reserve(3 * faces.size());
  for (const std::uint32_t f : faces) {
    for (const std::uint32_t old : all_.cycle(f)) {
      std::uint32_t& v = number[old];
      if (v == no_index) {
        v = static_cast<std::uint32_t>(result.vertices.size());
        result.vertices.push_back(old);
      }
      mesh.corners.push_back(v);
    }
    if (!all_.triangles()) mesh.face_sizes.push_back(all_.size(f));
  }
  for (const std::uint32_t v : result.vertices) number[v] = no_index;
  if (piece + 1 == parts_.count())
    result.vertices.insert(result.vertices.end(), isolated_.begin(), isolated_.end());
  mesh.vertex_count = static_cast<std::uint32_t>(result.vertices.size());

  for (const Attribute& a : mesh_.attributes) {
    Attribute part{a.name, a.domain, a.scalar, a.components, {}};
    const auto copy = [&](std::size_t first, std::size_t values) {
      const auto from = a.data.begin() + static_cast<std::ptrdiff_t>(first * a.stride());
      part.data.insert(part.data.end(), from,
                       from + static_cast<std::ptrdiff_t>(values * a.stride()));
    };
    switch (a.domain) {
      case Domain::vertex:
        part.data.reserve(result.vertices.size() * a.stride());
        for (const std::uint32_t v : result.vertices) copy(v, 1);
        break;
      case Domain::face:
        part.data.reserve(faces.size() * a.stride());
        for (const std::uint32_t f : faces) copy(f, 1);
        break;
      case Domain::corner:
        part.data.reserve(mesh.corners.size() * a.stride());
        for (const std::uint32_t f : faces) copy(all_.begin(f), all_.size(f));
        break;
    }
    mesh.attributes.push_back(std::move(part));
  }
  return result;
}

}  // namespace clers::internal
