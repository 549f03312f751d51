// Surfaces in space, as a camera sees them: shaded, and hidden where something is in front.
#ifndef CLERS_TOPOLOGY_FIGURES_SHADED_H
#define CLERS_TOPOLOGY_FIGURES_SHADED_H

#include <functional>
#include <string>
#include <vector>

#include "topology/figures/vector.h"
#include "topology/surface.h"

namespace clers::figures {

/// A camera that looks at `target`, in perspective if its distance is finite.
struct Camera {
  Camera(const Vector& from, const Vector& up, const Vector& target, double pixels,
         double distance = 0);

  /// Right and up from the target in pixels, and how far towards the camera, in the surface's unit.
  Vector see(const Vector& p) const;

  Vector target, right, up, towards;
  double pixels;    ///< for a unit of length at the target
  double distance;  ///< 0: parallel projection
};

/// The faces of a surface that are turned to the camera and not wholly hidden, as paths of
/// SVG in tenths of a pixel about the target. Faces do not intersect. The same on every machine if
/// the places are, in whatever order the surface has its elements.
///
/// `tone`: which of the tones of a face's colour (shaded.cc) it has.
std::string shaded(const Surface& surface, const Camera& camera,
                   const std::function<Vector(Vertex)>& at,
                   const std::function<unsigned(Face)>& tone = {});

}  // namespace clers::figures

#endif
