// A mesh, subdivided: between plain arrays and the surface.
#ifndef CLERS_CODEC_CLI_SUBDIVIDE_H
#define CLERS_CODEC_CLI_SUBDIVIDE_H

#include <functional>
#include <string>
#include <vector>

#include "codec/error.h"
#include "codec/mesh.h"
#include "topology/characteristic.h"

namespace clers::cli {

enum class Scheme { sqrt3, loop, four_eight };
const char* name(Scheme scheme);

struct Subdivision {
  Scheme scheme = Scheme::loop;
  unsigned times = 1;  ///< steps; of 4-8 each doubles the faces, after the mesh is made a tri-quad
};

struct Subdivided {
  Mesh mesh;
  Characteristic before, after;
  std::vector<std::string> notes;  ///< what was not carried over
};

/// Subdivides a triangle mesh. Values of vertices of any type go with the positions, by the same
/// weights; those of corners and faces, and isolated vertices, are left out, which the notes say.
/// Errors: unsupported (a polygon, or no positions), degenerate_face, nonmanifold_edge,
/// nonmanifold_vertex, nonorientable, each with the first offending element; too_large. Throws
/// std::bad_alloc.
Expected<Subdivided> subdivide(const Mesh& mesh, const Subdivision& how,
                               const std::function<void(double done)>& progress);

/// One line: "loop twice: 200 triangles -> 3200, ...".
std::string describe(const Subdivision& how, const Subdivided& result);

}  // namespace clers::cli

#endif
