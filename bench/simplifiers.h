// Who makes fewer triangles of many: this project, and those it is measured beside.
#ifndef CLERS_BENCH_SIMPLIFIERS_H
#define CLERS_BENCH_SIMPLIFIERS_H

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "bench/input.h"
#include "bench/triangles.h"

namespace clers::bench {

struct Simplifier {
  std::string name;
  /// From arrays to arrays: at most so many faces, if it can. What it builds in between is a part
  /// of its work.
  std::function<Triangles(const Input& input, std::size_t faces)> run;
};

/// The project's, with the weight of shapes that is the default, and two for rounder triangles.
std::vector<Simplifier> our_simplifiers();
/// Lindstrom and Turk's cost and place, as CGAL has them.
Simplifier cgal_simplifier();
/// Quadrics, and a test that normals do not flip: without it, faces fold.
Simplifier openmesh_simplifier();
/// The distribution's meshoptimizer.
Simplifier meshopt_simplifier();

}  // namespace clers::bench

#endif
