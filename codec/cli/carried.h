// Values of vertices, corners and faces that go along when edges are contracted.
#ifndef CLERS_CODEC_CLI_CARRIED_H
#define CLERS_CODEC_CLI_CARRIED_H

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "codec/cli/mixed_values.h"
#include "codec/mesh.h"
#include "codec/surface.h"
#include "topology/modeling/creases.h"
#include "topology/modeling/simplify.h"

namespace clers::cli {

/// All attributes of a triangle mesh but its positions, on the way from one surface to a coarser
/// one. Corners around a vertex that have one value keep one; where they have not, and where faces
/// have other values, the edges are seams, and creases.
///
///     Carried carried(mesh, cut, creases, notes);
///     for each contraction: carried.before(c, at); contract(..); carried.after(c);
class Carried {
 public:
  /// `mesh` and `cut` stay where they are as long as this lives. An attribute whose seams would be
  /// most edges is left out if it is of corners, and its seams are not kept if it is of faces: the
  /// notes say so.
  Carried(const Mesh& mesh, const SurfaceByCuts& cut, Creases& creases,
          std::vector<std::string>& notes);

  /// `at`: by vertex, before the one that is kept has moved.
  void before(const Contraction& c, const std::vector<Position3>& at);
  void after(const Contraction& c);

  /// The attributes for a mesh made of the surface, in their order; the positions by `at`.
  std::vector<Attribute> attributes(const MeshOfSurface& made,
                                    const std::vector<Position3>& at) const;

 private:
  /// An attribute, and which value each element has: by vertex, half-edge or face.
  struct Track {
    const Attribute* attribute;
    MixedValues values;
    std::vector<std::uint32_t> of;
  };
  /// A face that stays, on edge `to`-`next` opposite the vertex that moves, and the values that it
  /// and its corners are to have.
  struct Kept {
    Vertex to, next;
    std::size_t values;  ///< the first in values_: of all tracks of corners 3, then of faces 1
  };

  /// Where the values of the vertex that is kept come from: three corners.
  struct Origin {
    std::array<HalfEdge, 3> corners;
    std::array<double, 3> weights{};
  };

  std::uint32_t corner_of_mesh(HalfEdge h) const;
  Origin origin(const Contraction& c, HalfEdge side, const std::vector<Position3>& at) const;
  void share(Track& track) const;
  bool is_seam(const Track& track, HalfEdge h) const;
  bool mark_seams(const Track& track, Creases& creases) const;
  static Attribute made_of(const Track& track, const std::vector<std::uint32_t>& elements);

  const Surface& surface_;
  const SurfaceByCuts& cut_;
  const Creases& creases_;
  const Mesh& mesh_;
  std::vector<Track> vertices_, corners_, faces_;
  std::vector<Kept> kept_;
  std::vector<std::uint32_t> values_;
};

}  // namespace clers::cli

#endif
