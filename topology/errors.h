// Why an operator refused, and what is wrong with arrays that are not a surface.
#ifndef CLERS_TOPOLOGY_ERRORS_H
#define CLERS_TOPOLOGY_ERRORS_H

#include <cstdint>
#include <string>

#include <clers/topology/export.h>

namespace CLERS_VISIBLE clers {

/// What an operator requires of its arguments.
enum class Precondition : std::uint8_t {
  live_face,              ///< the face exists
  live_half_edge,         ///< the half-edge is one of a face that exists
  boundary_edge,          ///< the edge is on the boundary (glue, attach)
  interior_edge,          ///< the edge is not on the boundary (unglue, flip)
  two_half_edges,         ///< the two half-edges differ (glue, split_vertex)
  all_edges_on_boundary,  ///< no edge of the face is glued (destroy)
  ids_left,               ///< fewer than max_faces faces
  live_vertex,            ///< the vertex exists
  two_faces,              ///< the edge is between two different faces (flip, split)
  simple_star,            ///< no face has two corners at the vertex (weld, remove)
  weld_degree,            ///< the vertex has as many edges as a weld needs (weld, remove)
  link_condition,         ///< the ends' links meet in the edge's link only (collapse)
  leave_one_vertex,       ///< both half-edges leave one vertex (split_vertex)
  interior_vertex,        ///< the vertex is not on the boundary (begin_star)
  one_sharp_edge,         ///< the face has at most one edge that is trisected (modeling/sqrt3.h)
  tri_quad,               ///< the edge is half-edge 1 on both sides (modeling/four_eight.h)
  refined_vertex,         ///< the vertex is not of the base mesh (modeling/multi_triangulation.h)
  levels_left,            ///< the new vertex's level is at most max_level (the same)
};
inline constexpr unsigned precondition_count = 18;

/// A precondition that does not hold: which, and at which face, half-edge or vertex. Nothing was
/// changed.
struct Violation {
  Precondition precondition = Precondition::live_face;
  std::uint32_t element = 0;

  friend bool operator==(const Violation&, const Violation&) = default;
};

/// What holds of the arrays of every surface, in the order validate() checks it.
enum class Invariant : std::uint8_t {
  array_sizes,         ///< three half-edges a face, one entry for each id; element: a size
  face_pool,           ///< the free faces are the dead ones, each once; element: a face
  vertex_pool,         ///< the same of vertices; element: a vertex
  curve_pool,          ///< the same of curves; element: a curve
  component_pool,      ///< the same of components; element: a component
  node_pool,           ///< the same of the nodes of rings; element: a node
  origin_is_live,      ///< a half-edge leaves a vertex that exists; element: a half-edge
  twin_in_range,       ///< a twin is null or a half-edge of a live face; element: a half-edge
  twin_is_mutual,      ///< the twin's twin is the half-edge, which is not its own
  twin_is_opposite,    ///< the twin leaves where the half-edge arrives, and arrives where it leaves
  star_leaves_vertex,  ///< a vertex's star half-edge leaves it; element: a vertex
  star_on_boundary,    ///< that of a boundary vertex is on the boundary; element: a vertex
  corner_count,        ///< a vertex knows how many corners it has; element: a vertex
  one_fan,             ///< the corners of a vertex are one fan; element: a vertex
  ring_links,          ///< the tree links of a ring are mutual and in range; element: a node
  ring_members,        ///< a boundary vertex, and no other, has a node, its own; element: a vertex
  ring_shape,          ///< sizes add up and priorities decrease; element: a node
  ring_order,          ///< a ring runs along its boundary curve; element: a half-edge
  curve_names,         ///< curves and roots of rings name each other; element: a curve
  component_labels,    ///< neighbours are on one component, which exists; element: a face
  component_connected,  ///< the faces of one label are connected; element: a component
  component_counts,     ///< a component's six counts are right; element: a component
  total_counts,         ///< the surface's six counts are the sums; element: which, 0..5
  euler_poincare,       ///< v - e + f = 2(s - g) - b; element: a component
};
inline constexpr unsigned invariant_count = 24;

/// An invariant that does not hold: which, and at which element.
struct Fault {
  Invariant invariant = Invariant::array_sizes;
  std::uint32_t element = 0;

  friend bool operator==(const Fault&, const Fault&) = default;
};

/// What triangles given by their corners must keep to be an oriented manifold, in the order in
/// which Surface::from_faces checks it.
enum class FaceRule : std::uint8_t {
  array_sizes,       ///< three corners a face, at most max_faces, a point a vertex; element: a size
  vertex_in_range,   ///< a corner is below vertex_count; element: a half-edge, that from the corner
  distinct_corners,  ///< a face has three vertices; element: a face
  at_most_two_faces,    ///< no edge has more; element: the half-edge of the third
  opposite_directions,  ///< the two faces of an edge run along it opposite ways; element: the
                        ///< half-edge of the second
  one_fan,              ///< the faces at a vertex are one fan, open or closed; element: a vertex
};
inline constexpr unsigned face_rule_count = 6;

/// A rule that triangles break: which, and the first element at which they do.
struct BrokenRule {
  FaceRule rule = FaceRule::array_sizes;
  std::uint32_t element = 0;

  friend bool operator==(const BrokenRule&, const BrokenRule&) = default;
};

/// Names as in the enumerations.
const char* name(Precondition p);
const char* name(Invariant i);
const char* name(FaceRule r);

/// One line for people, such as "twin_is_mutual fails at half-edge 17".
std::string describe(const Violation& v);
std::string describe(const Fault& f);
std::string describe(const BrokenRule& b);

}  // namespace clers

#endif
