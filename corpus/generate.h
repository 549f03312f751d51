// Meshes made to order, the same on every machine: shapes of known topology, ways to make them
// irregular, perforated, shuffled and numerous, and soups that are no surface at all.
//
// All have float32 positions; all but some soups are triangles. Unless said otherwise a mesh is a
// consistently oriented manifold without isolated vertices, and simple: no two edges have the same
// two ends. Parameters are the caller's to get right: preconditions are not checked. Cost: linear
// in the size of the result unless said otherwise.
#ifndef CLERS_CORPUS_GENERATE_H
#define CLERS_CORPUS_GENERATE_H

#include <cstdint>
#include <span>

#include "codec/mesh.h"

namespace clers::corpus {

// Shapes (shapes.cc).
// ---------------------------------------------------------------------------------------

Mesh single_triangle();

/// The triangles (0,1,2) and (0,2,1), glued along all three edges: a sphere.
Mesh glued_pair();

Mesh tetrahedron();

/// The icosahedron with every triangle split in four `level` times: 20 * 4^level triangles.
Mesh icosphere(unsigned level);

/// 2 * around * across triangles, every vertex of valence 6. Precondition: both at least 3.
Mesh torus(std::uint32_t around, std::uint32_t across);

/// A flat disc of columns x rows quadrilaterals, each split in two. Precondition: both at least 1.
Mesh grid(std::uint32_t columns, std::uint32_t rows);

/// An annulus: a tube, open at both ends. Precondition: around at least 3, rows at least 1.
Mesh cylinder(std::uint32_t around, std::uint32_t rows);

/// Not orientable; one boundary curve. Precondition: around at least 5, rows at least 1.
Mesh moebius_strip(std::uint32_t around, std::uint32_t rows);

// Irregularity (flips.cc, holes.cc).
// ------------------------------------------------------------------------

/// Tries to flip `tries` random edges. Skips those on a boundary and those whose flip would give
/// two edges the same two ends or a vertex fewer than three edges (two on a boundary).
/// Precondition: simple triangle mesh. Cost: that of one pass over the mesh, and a star for each
/// try.
Mesh flip_edges(Mesh mesh, std::uint64_t tries, std::uint64_t seed);

/// Takes out single triangles and stars of vertices, at random, that touch neither each other nor
/// the boundary: each is one boundary curve more. Makes `count` holes, fewer if no more fit.
/// Vertices that are left over are removed, the others keep their order. Precondition: simple
/// triangle mesh.
Mesh punch_holes(const Mesh& mesh, std::uint32_t count, std::uint64_t seed);

// Handles (gyroid.cc).
// --------------------------------------------------------------------------------------

/// What happens to the gyroid at the faces of its box.
enum class Ends {
  open,      ///< ends there, in boundary curves
  capped,    ///< walls close it: the boundary of one of the two labyrinths
  periodic,  ///< opposite faces are identified, so some triangles span the box
};

/// A gyroid of x*y*z unit cells, each sampled with `resolution` steps a side, by marching
/// tetrahedra, which give a manifold whatever the samples. Periodic: genus 1 + 4xyz; otherwise
/// somewhat fewer, with a few small components at the corners; about 22 * resolution^2 triangles a
/// cell. Precondition: x, y, z at least 1, resolution at least 8. Cost: linear in the samples;
/// memory: three layers of samples and the result.
Mesh gyroid(std::uint32_t x, std::uint32_t y, std::uint32_t z, std::uint32_t resolution, Ends ends);

/// A scaffold (lattice.cc): n^3 cubes, and tubes between neighbours in place of the sides that face
/// each other. 24 n^3 - 12 n^2 triangles, of genus 3 n^2 (n-1) - n^3 + 1: a handle for every
/// twelve. Precondition: n at least 1.
Mesh lattice(std::uint32_t n);

// Arrangement (arrange.cc). These take meshes of any kind, polygons included.
// -------------------------------

/// Random order of vertices and of faces, and a random first corner for each face.
Mesh shuffle(const Mesh& mesh, std::uint64_t seed);

/// Every face the other way round; its first corner stays first.
Mesh reversed(const Mesh& mesh);

/// Precondition: all have the same attributes in the same order. The name is the first one's.
Mesh disjoint_union(std::span<const Mesh> meshes);

/// The disjoint union of n copies, all at the same place.
Mesh copies(const Mesh& mesh, std::uint32_t n);

// Defects (defects.cc): what keeps a mesh from being a surface.
// -----------------------------------------------------------

/// Every face twice. Takes meshes of any kind.
Mesh doubled(const Mesh& mesh);

/// Every face both ways round. Takes meshes of any kind.
Mesh two_sided(const Mesh& mesh);

/// Triangles at `count` random edges, each with a vertex of its own: edges of three faces and more.
/// Keeps positions only. Precondition: triangles; one at least.
Mesh add_fins(const Mesh& mesh, std::uint32_t count, std::uint64_t seed);

/// `count` random faces the other way round, or all. Precondition: triangles, no values of corners.
Mesh reverse_some(Mesh mesh, std::uint32_t count, std::uint64_t seed);

/// `count` vertices more, which no face uses. Keeps positions only. Precondition: triangles.
Mesh isolate(const Mesh& mesh, std::uint32_t count);

// Soups (soups.cc): meshes that need not be surfaces.
// -------------------------------------------------------

/// Faces of 3 .. max_polygon random corners: they repeat vertices and each other, either way round,
/// share edges in any number and leave vertices unused. Precondition: vertices > 0, max_polygon
/// >= 3.
Mesh random_soup(std::uint32_t vertices, std::uint32_t faces, std::uint32_t max_polygon,
                 std::uint64_t seed);

/// n triangles around vertex 0, a disc. Precondition: n at least 3.
Mesh fan(std::uint32_t n);

/// n triangles at the edge 0 1. Every one of them runs along it from 0 to 1.
Mesh book(std::uint32_t n);

/// The triangle (0,1,2), n times.
Mesh same_triangle(std::uint32_t n);

/// A triangle for any three of n vertices: n (n-1) (n-2) / 6.
Mesh all_triples(std::uint32_t n);

/// n triangles that share vertex 0 and nothing else.
Mesh pinched_hub(std::uint32_t n);

/// The black fields of a chessboard of size x size fields, two triangles each: they meet in
/// vertices only.
Mesh chessboard(std::uint32_t size);

/// A strip of n triangles: a disc without inner vertices. Precondition: n at least 1.
Mesh strip(std::uint32_t n);

/// n triangles that share nothing.
Mesh loose_triangles(std::uint32_t n);

}  // namespace clers::corpus

#endif
