// All small triangulations of the sphere.
#ifndef CLERS_CORPUS_ENUMERATE_H
#define CLERS_CORPUS_ENUMERATE_H

#include <cstdint>
#include <functional>

#include "codec/mesh.h"

namespace clers::corpus {

/// Visits every rooted simple triangulation of the sphere with n vertices once, always in the same
/// order. The root is the half-edge from corner 0 to corner 1 of face 0: triangulations with
/// several essentially different half-edges come once for each, mirror images apart. For n = 4, 5,
/// .. there are 1, 3, 13, 68, 399, 2530, 16965, .. of them: 2 (4m-3)! / (m! (3m-1)!) with m = n - 2
/// (Tutte 1962). Positions are arbitrary but distinct. Precondition: 4 <= n <= 20; time grows
/// tenfold with each n (10 takes about a second).
void for_each_sphere_triangulation(std::uint32_t n, const std::function<void(const Mesh&)>& visit);

}  // namespace clers::corpus

#endif
