// Meshes -> bytes.
#ifndef CLERS_CODEC_ENCODE_H
#define CLERS_CODEC_ENCODE_H

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include "codec/error.h"
#include "codec/inspect.h"
#include "codec/mesh.h"

namespace clers {

inline constexpr int min_level = 1, max_level = 9, default_level = 5;

struct EncodeOptions {
  int level = default_level;  ///< 1 fastest .. 9 smallest

  /// Called now and then with the name of the stage and the share of the whole work that is done,
  /// 0..1, never decreasing; from the calling thread. May be empty.
  std::function<void(std::string_view stage, double done)> progress;
};

/// What the codec renumbered. Decoding gives the mesh in the new order.
struct Permutation {
  std::vector<std::uint32_t> vertices;       ///< vertices[new] = old, one for each vertex
  std::vector<std::uint32_t> faces;          ///< faces[new] = old, one for each face
  std::vector<std::uint32_t> first_corners;  ///< first_corners[new] = the corner of the old face
                                             ///< (0, 1, ..) that comes first now
};

struct Encoded {
  std::vector<std::byte> bytes;
  std::vector<Permutation> permutations;  ///< one for each mesh
  std::vector<MeshInfo> report;           ///< one for each mesh: what was found and what it costs
};

/// Encodes meshes into one .clers file.
/// Same input and options give the same bytes, whatever the compiler, build or machine.
/// Errors: inconsistent_mesh, polygon, repeated_vertex, nonmanifold_edge, nonmanifold_vertex,
/// nonorientable (each names the first offending element), too_large, out_of_memory.
/// Cost: linear in the faces; about 60 bytes of memory a triangle besides the input.
/// Thread safe: calls share nothing.
Expected<Encoded> encode(std::span<const Mesh> meshes, const EncodeOptions& options = {});

}  // namespace clers

#endif
