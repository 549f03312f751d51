// Meshes -> bytes.
#ifndef CLERS_CODEC_ENCODE_H
#define CLERS_CODEC_ENCODE_H

#include <cstddef>
#include <span>
#include <vector>

#include <clers/error.h>
#include <clers/info.h>
#include <clers/mesh.h>
#include <clers/mesh_view.h>
#include <clers/options.h>
#include <clers/order.h>
#include <clers/precision.h>
#include <clers/scene.h>
#include <clers/topology/export.h>

namespace CLERS_VISIBLE clers {

/// Of each mesh, in their order: how it was renumbered, and what it costs.
struct Encoded {
  std::vector<std::byte> bytes;
  std::vector<Permutation> permutations;
  std::vector<MeshInfo> report;      ///< as Decoder::info of the bytes, but for metadata
  std::vector<CodingCounts> counts;  ///< as inspect of the bytes
  std::vector<Warning> warnings;     ///< of all meshes
  SceneInfo scene;                   ///< as Decoder::info of the bytes, but for metadata
};

/// Encodes a mesh into a .clers file. A Mesh converts to a view: encode(mesh).
///
/// Takes any faces: polygons of any size, non-manifold, degenerate and duplicate ones. All of them
/// come back.
///
/// The same input and options give the same bytes on any compiler and machine, with any number of
/// threads, by one version of this library and, where there is metadata, or attributes from level 5
/// on, of zstd. Other versions may give other bytes. A library decodes one version of the format
/// (codec/format.md, codec/format-values.md), its own, and refuses others with unsupported_version:
/// before 1.0 any release may have a new one.
///
/// A manifold mesh as it was decoded encodes to the same bytes again, if it is in one piece, or if
/// no two positions coincide and its pieces are manifold too. Other meshes may not: where they are
/// cut depends on the order of faces.
///
/// Errors: inconsistent_mesh, too_large, bad_option, not_on_grid, out_of_memory; and where options
/// reject them, degenerate_face, duplicate_face, nonmanifold_edge, nonorientable,
/// nonmanifold_vertex, each with the first such element. Throws nothing but what `progress` throws
/// (std::bad_alloc becomes out_of_memory). Thread safe: calls share nothing, and only read the
/// mesh.
///
/// Cost: linear in the faces, O(log n) a handle, and sorts of non-manifold edges, of degenerate
/// faces and of the patches that pieces are made of. Of the arrays of the mesh, 16-bit corners are
/// copied (4 bytes each), the values of one attribute a thread, and those of corners or by index,
/// of all attributes; a mesh in pieces is copied piece by piece. One that has values by index stays
/// whole. From level 5 on a mesh with boundaries, of which vertices are at one place, is coded
/// twice: with these as one, and not. Values that are quantised are copied three times before that.
/// To code values takes 4 bytes a component, 8 where the integers that they become need more than
/// 29 bits, several times; from level 5 on 12 bytes a triangle where vertices or corners have
/// values, for which sides are the same edge, and at level 9 some hundred bytes a vertex.
Expected<Encoded> encode(const MeshView& mesh, const EncodeOptions& options = {});

/// Encodes several meshes into one file. Errors say which mesh.
Expected<Encoded> encode(std::span<const MeshView> meshes, const EncodeOptions& options = {});
Expected<Encoded> encode(std::span<const Mesh> meshes, const EncodeOptions& options = {});

/// Encodes a scene into one file: its meshes as above, arrays without loss unless
/// options.precisions name them, without a domain, and no `vertices_of`; blobs and the document
/// packed where that helps. `orders`, if there are any, are one a mesh, instead of options.order.
/// Errors besides: inconsistent_mesh for arrays, blobs and metadata that are not as
/// <clers/scene.h> says; bad_option for another number of orders.
Expected<Encoded> encode(const Scene& scene, const EncodeOptions& options = {},
                         std::span<const Order> orders = {});

}  // namespace clers

#endif
