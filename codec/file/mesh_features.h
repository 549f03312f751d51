// Which streams a mesh has besides a triangulated surface: the first byte of a mesh section.
// codec/format.md, Mesh.
#ifndef CLERS_CODEC_FILE_MESH_FEATURES_H
#define CLERS_CODEC_FILE_MESH_FEATURES_H

#include <cstdint>

namespace clers::internal {

/// Bits of the first byte of a mesh.
namespace feature {
inline constexpr std::uint32_t reversed = 1;  ///< faces that run against their component
inline constexpr std::uint32_t polygons = 2;  ///< triangles that belong together
inline constexpr std::uint32_t copies = 4;    ///< surface vertices that are one vertex of the mesh
inline constexpr std::uint32_t degenerate = 8;  ///< faces that are not on the surface
inline constexpr std::uint32_t raw = 16;        ///< alone: faces one by one, no surface
inline constexpr std::uint32_t repeats = 32;    ///< faces that repeat one of the surface
inline constexpr std::uint32_t folded = 64;     ///< triangles on two vertices of an edge
inline constexpr std::uint32_t welded = 128;    ///< vertices are points at those of the surface
inline constexpr std::uint32_t on_surface =
    reversed | polygons | copies | degenerate | repeats | folded | welded;
}  // namespace feature

}  // namespace clers::internal

#endif
