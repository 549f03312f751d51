// Random surfaces of all kinds, simplicial complexes or not.
#ifndef CLERS_CORPUS_RANDOM_GLUING_H
#define CLERS_CORPUS_RANDOM_GLUING_H

#include <cstdint>
#include <vector>

namespace clers::corpus {

/// An oriented triangulated surface by half-edges: 3f+i runs from corner i to corner i+1 of face f.
/// Every vertex is one fan of faces. Two edges may have the same two ends and, unless excluded, the
/// same end twice, so that corner indices alone would not tell which edges are glued.
struct Gluing {
  std::uint32_t vertex_count = 0;
  std::vector<std::uint32_t> org;   ///< vertex that each half-edge leaves
  std::vector<std::uint32_t> twin;  ///< half-edge glued to each, or 0xffffffff on a boundary
};

struct GluingOptions {
  /// Of 100 triangles, how many start apart instead of being glued to the surface at once. Random
  /// pairs join some of them later.
  unsigned apart = 5;
  /// Of 100 other gluings, how many close two neighbouring edges of a boundary curve; the rest glue
  /// random pairs of boundary edges. 100: every component has genus 0; 0: few vertices, nearly the
  /// greatest genus there is.
  unsigned zips = 50;
  /// Of 100 half-edges, how many are left on the boundary (at least one if 3 * triangles is odd;
  /// gluing all triangles that do not start apart leaves no more than about 33 + apart / 2).
  unsigned boundary = 0;
  /// Whether an edge may have the same vertex at both ends. If not, edges that could not be glued
  /// without making a loop stay on the boundary, besides those asked for.
  bool loops = true;
};

/// Cost: O(triangles log triangles).
Gluing random_gluing(std::uint32_t triangles, std::uint64_t seed,
                     const GluingOptions& options = {});

}  // namespace clers::corpus

#endif
