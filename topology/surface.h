// A triangulated oriented surface with boundary, changed only by operators that keep it one.
#ifndef CLERS_TOPOLOGY_SURFACE_H
#define CLERS_TOPOLOGY_SURFACE_H

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <clers/topology/attachments.h>
#include <clers/topology/characteristic.h>
#include <clers/topology/circulator.h>
#include <clers/topology/errors.h>
#include <clers/topology/export.h>
#include <clers/topology/id_pool.h>
#include <clers/topology/ids.h>
#include <clers/topology/result.h>
#include <clers/topology/ring.h>

namespace CLERS_VISIBLE clers {

class Change;  // follow.h

/// What a weld undid, and how to split again.
struct Welded {
  StellarCase undone = StellarCase::face;
  HalfEdge at;  ///< split(at, point) undoes the weld; of a face: split(left(at), point)
  Point point;  ///< the vertex's
};

/// The new ids that compress gave, by old id; null where that was dead. Half-edge i of face f is
/// now half-edge i of faces[f].
struct Compressed {
  std::vector<Face> faces;
  std::vector<Vertex> vertices;
  std::vector<Curve> curves;
  std::vector<Component> components;
};

/// An oriented 2-manifold with boundary made of triangles, as the paper's handle-edge structure
/// (Topological mesh operators, §6 and Appendix A) by index.
///
///                 c
///                / \                   The half-edge 3f+i runs from corner i to corner i+1 of the
///       3f+2   /     \   3f+1          face f, which is on its left; lnext and lprev (ids.h) go
///            /    f    \               around the face. Its twin is the other side of its edge, or
///           a --------- b              null: then the edge is on the boundary and its half-edge
///               3f+0                   is on a boundary curve, which runs the same way.
///
/// A surface is any set of triangles glued along edges, not only a simplicial complex: two
/// triangles may share all three edges, two edges may share both ends, an edge may begin and end at
/// one vertex, a triangle may be glued to itself, a boundary curve may have one edge or two. Every
/// vertex has one fan of corners.
///
/// A vertex carries a point (Appendix A): what its copies share after a cut. Points are the
/// caller's numbers; the surface never interprets them.
///
/// Ids of faces, vertices, curves and components are reused, the last one freed first. An operator
/// keeps every id that its documentation does not mention, and always the order of corners.
///
/// Memory: 28 bytes for each face, 16 for each vertex and 24 for each edge of the boundary, so 36 a
/// face of a large closed surface; twice that at most while it grows. Operators that have to search
/// keep 4 bytes for each face of the component they searched.
///
/// For values by vertex, face or half-edge that follow the operators see element_data.h.
///
/// Queries need live arguments (`is_live`); operators check theirs and refuse with a Violation.
/// When memory runs out an operator throws std::bad_alloc before it has changed anything.
///
/// In costs F, V and B are the numbers of faces, vertices and boundary edges, n that of the edges
/// of the curves involved.
class Surface {
 public:
  // Elements ----------------------------------------------------------------------------------

  bool is_live(Face f) const { return f.index() < faces_.size() && bool(component_[f.index()]); }
  bool is_live(HalfEdge h) const { return h.index() < org_.size() && is_live(clers::left(h)); }
  bool is_live(Vertex v) const { return v.index() < star_.size() && bool(star_[v.index()]); }
  bool is_live(Curve c) const { return c.index() < curves_.size() && bool(ring_[c.index()]); }
  bool is_live(Component k) const {
    return k.index() < components_.size() && counts_[k.index()].s != 0;
  }

  /// All of a kind in the order of their ids, to range over. Cost: that of all ids below the limit.
  auto faces() const { return live<Face>(faces_.size()); }
  auto vertices() const { return live<Vertex>(vertices_.size()); }
  auto curves() const { return live<Curve>(curves_.size()); }
  auto components() const { return live<Component>(components_.size()); }
  /// All edges, each by the half-edge that stands for it: edge(h) == h.
  auto edges() const {
    return ElementRange(FilterCursor<IsEdge, HalfEdge>(*this, half_edge_limit()));
  }

  /// One more than the largest id used so far: the size of arrays indexed by that id.
  std::uint32_t face_limit() const { return faces_.size(); }
  std::uint32_t half_edge_limit() const { return 3 * faces_.size(); }
  std::uint32_t vertex_limit() const { return vertices_.size(); }

  // Queries (§6.1); left(h), lnext(h) and lprev(h) are functions of ids.h. O(1) unless said -----

  Vertex org(HalfEdge h) const { return org_[h.index()]; }
  Vertex dest(HalfEdge h) const { return org(lnext(h)); }
  /// The other side of the edge, null on the boundary.
  HalfEdge sym(HalfEdge h) const { return twin_[h.index()]; }

  bool is_boundary(HalfEdge h) const { return !sym(h); }
  bool is_boundary(Vertex v) const { return bool(node_[v.index()]); }
  /// Does the face have an edge on the boundary?
  bool is_boundary(Face f) const {
    return is_boundary(half_edge(f, 0)) || is_boundary(half_edge(f, 1)) ||
           is_boundary(half_edge(f, 2));
  }

  /// The half-edge that stands for its edge: the one with the lower id, or the only one.
  HalfEdge edge(HalfEdge h) const { return std::min(h, sym(h)); }
  /// Are these two sides, or the same side, of one edge?
  bool same_edge(HalfEdge a, HalfEdge b) const { return edge(a) == edge(b); }

  /// The other end of an edge of which v is one; v itself if the edge is a loop.
  Vertex other_end(HalfEdge h, Vertex v) const { return org(h) == v ? dest(h) : org(h); }
  /// Edge ends at the vertex: a loop edge counts twice.
  std::uint32_t degree(Vertex v) const { return corners_[v.index()] + (is_boundary(v) ? 1u : 0u); }
  /// Corners of triangles at the vertex.
  std::uint32_t corner_count(Vertex v) const { return corners_[v.index()]; }
  Point point(Vertex v) const { return point_[v.index()]; }
  /// A half-edge that leaves the vertex: of a boundary vertex the one on the boundary, first of its
  /// fan counterclockwise.
  HalfEdge star_half_edge(Vertex v) const { return star_[v.index()]; }

  /// The half-edge after / before a boundary half-edge on its curve. Before: O(log n).
  HalfEdge boundary_next(HalfEdge h) const { return star_[dest(h).index()]; }
  HalfEdge boundary_prev(HalfEdge h) const {
    return star_[rings_.vertex(rings_.prev(node(h))).index()];
  }
  /// The curve of a boundary half-edge. O(log n).
  Curve curve(HalfEdge h) const { return rings_.curve(rings_.root(node(h))); }
  /// Are two boundary half-edges on one curve? O(log n).
  bool same_boundary(HalfEdge a, HalfEdge b) const {
    return rings_.root(node(a)) == rings_.root(node(b));
  }
  /// Edges of a curve.
  std::uint32_t length(Curve c) const { return rings_.size(ring_[c.index()]); }
  /// Some half-edge on a curve.
  HalfEdge on_curve(Curve c) const { return star_[rings_.vertex(ring_[c.index()]).index()]; }

  /// Does every face at v have only one corner there? Then no edge of the star is a loop.
  /// O(degree).
  bool has_simple_star(Vertex v) const;
  /// Is there a split that weld(h) would undo? O(1).
  bool can_weld(HalfEdge h) const { return !refuse_weld(h); }

  Component component(Face f) const { return component_[f.index()]; }

  /// The six counts, exact at all times, of the surface and of one component.
  const Characteristic& characteristic() const { return total_; }
  const Characteristic& characteristic(Component k) const { return counts_[k.index()]; }
  std::int64_t genus() const { return total_.g; }

  // Circulators (§2.1, §6.1): ranges of half-edges, counterclockwise, that allocate nothing. They
  // are valid until the next operator.

  /// One half-edge leaving v for each corner of v: left() of it is the face.
  auto fan(Vertex v) const { return circulate<AroundVertex>(star_[v.index()], corner_count(v)); }
  /// The edges of v's star, degree(v) of them, each by a half-edge that leaves v; except that the
  /// last one of a boundary vertex arrives at v, since that edge has no side that leaves.
  auto star(Vertex v) const { return circulate<AroundVertex>(star_[v.index()], degree(v)); }
  /// The vertices at the other ends of v's edges, in the order of star(v), degree(v) of them. In a
  /// simplicial complex each neighbour comes once; elsewhere once for every edge that joins it to
  /// v, and v itself twice for every loop.
  auto adjacent_vertices(Vertex v) const {
    return ElementRange(NeighbourCursor<AroundVertex>(*this, v, star_[v.index()], degree(v)));
  }
  /// The edges of v's link, those opposite v: a closed curve, or a path if v is on the boundary.
  auto link(Vertex v) const {
    return circulate<AlongLink>(lnext(star_[v.index()]), corner_count(v));
  }
  /// The edge's sides: left() of them are the one or two faces of its star.
  auto star(HalfEdge h) const { return circulate<AcrossEdge>(h, is_boundary(h) ? 1 : 2); }
  /// The edge's link, one or two vertices: the origins of these.
  auto link(HalfEdge h) const { return circulate<OppositeEdge>(lprev(h), is_boundary(h) ? 1 : 2); }
  /// The three sides of f, from corner 0.
  auto star(Face f) const { return circulate<AroundFace>(half_edge(f, 0), 3); }
  /// Nothing: no simplex of a surface is joined to a whole triangle.
  auto link(Face f) const { return circulate<AroundFace>(half_edge(f, 0), 0); }
  /// Along a boundary curve, all of it, from h or from some half-edge.
  auto boundary(HalfEdge h) const { return circulate<AlongBoundary>(h, length(curve(h))); }
  auto boundary(Curve c) const { return circulate<AlongBoundary>(on_curve(c), length(c)); }

  // Handle operators (§5.1, §6.2) -----------------------------------------------------------------

  /// Type 0: a new component of one triangle with three new vertices on these points (corner i on
  /// p_i; they need not differ).
  ///
  /// Precondition: `ids_left`. Effect on (v,e,f,b,g,s): (3,3,1,1,0,1). Inverse: destroy.
  /// Cost: O(1), amortised over the growth of the arrays. All ids stay valid.
  Result<Face, Violation> create(Point p0, Point p1, Point p2);

  /// Undoes create: removes a component of one triangle with all its edges on the boundary, and
  /// returns the points of its corners.
  ///
  /// Preconditions: `live_face`, `all_edges_on_boundary` (so the face is alone).
  /// Effect: (-3,-3,-1,-1,0,-1). Inverse: create on the points returned, which gives the face and
  /// vertices the same ids when it comes next. Cost: O(1).
  /// The ids of the face, its vertices, curve and component are freed.
  Result<std::array<Point, 3>, Violation> destroy(Face f);

  /// Identifies two boundary edges, the origin of each with the destination of the other, and says
  /// which handle this attached:
  ///
  ///     ---> u --h0--> w --->               ---> u --->
  ///          :         :            or as          |          : h0 and h1 now are twins,
  ///     <--- y <--h1-- x <---               <--- w <---       : u = y, w = x
  ///
  /// The case follows from the positions of h0 and h1 on the boundary curves, never from the
  /// vertices they share: the ends of two edges may coincide in every case (errata.md).
  ///
  ///   one curve   h0, h1 are all of it               close            (0,-1,0,-1,0,0)     type 2
  ///               neighbours, more edges remain      zip              (-1,-1,0,0,0,0)
  ///               else                               split_curve      (-2,-1,0,+1,0,0)    type 1b
  ///   two curves  of two components                  join_components  (-2,-1,0,-1,0,-1)   type 1a
  ///               of one component                   join_curves      (-2,-1,0,-1,+1,0)   type 1c
  ///   each a curve of one edge, of two components    join_components_at_loops (-1,-1,0,-2,0,-1)
  ///                             of one component     join_curves_at_loops     (-1,-1,0,-2,+1,0)
  ///
  /// Preconditions: `live_half_edge`, `boundary_edge`, `two_half_edges`.
  /// Inverse: unglue(h0), up to vertex ids and to the points of h1's ends.
  /// Cost: O(log n) for the curves, plus the smaller of any two fans of corners that meet, plus the
  /// faces of the smaller component in join_components.
  /// Ids: all of faces and half-edges stay. Of vertices that merge the one with most corners stays
  /// (h0's if equal), and carries the point of h0's end; the only vertex of a loop counts as
  /// its origin. Curves: joined and zipped ones keep the id of h0's; of a split one the part with
  /// boundary_next(h0) is new. Components: the one with more faces stays (h0's if equal).
  Result<HandleCase, Violation> glue(HalfEdge h0, HalfEdge h1);

  /// Cuts an interior edge into two boundary edges, and says which case of glue that undid.
  ///
  ///   no end on the boundary   two ends                           close
  ///                            one, of a loop edge                one of the .._at_loops
  ///   one end on the boundary                                     zip
  ///   both ends                on two curves                      split_curve
  ///                            on one curve                       join_components or join_curves
  ///
  /// The effect is the negative of glue's. Preconditions: `live_half_edge`, `interior_edge`.
  /// Inverse: glue(h, sym(h)).
  /// Cost: O(log n) for the curves plus the smaller of the fans a vertex is cut into (all but the
  /// largest of three). Where the cut may separate: nothing to decide while the component's genus
  /// is 0 (Jordan), else a search from both sides at once that ends when they meet (a handle was
  /// cut) or one is exhausted; the smaller part is searched and relabelled either way. Ids: faces
  /// and half-edges stay. The largest fan keeps the vertex's id (the other fans' vertices are new,
  /// on the same point), the larger part the component's. Curves: a lengthened or joined one keeps
  /// the id, with the curve at org(h) first; of a split one the part with h keeps it.
  Result<HandleCase, Violation> unglue(HalfEdge h);

  // Stellar operators (§5.2, §6.3) ----------------------------------------------------------------
  //
  // They change how a surface is triangulated, never its topology. A star is replaced by another
  // with the same rim; what the rim is glued to, even itself, does not matter. Faces keep their
  // corners in an order that means something to hierarchies (Dynamic adaptive meshes, §5): in faces
  // made by a split the new vertex is corner 0, so the side opposite is half-edge 1, an edge that
  // was there before. Costs are O(1), as the paper says, plus O(log n) for a split or weld of an
  // edge of the boundary.

  /// Turns the edge between two triangles counterclockwise (Fig. 3 b):
  ///
  ///          c                   c           f: (a b c) at h  ->  (d c a)
  ///         / \                 /|\          g: (b a d) at twin  ->  (c d b)
  ///        / f \               / | \         .
  ///       a --h-> b           a f|g b        h and its twin stay the two sides of the edge. The rim
  ///        \ g /               \ ^ /         turns with it: c-a goes to lnext(h), a-d to lprev(h),
  ///         \ /                 \h/          d-b to lnext(twin), b-c to lprev(twin).
  ///          d                   d
  ///
  /// Preconditions: `live_half_edge`, `interior_edge`, `two_faces`. Effect on (v,e,f,b,g,s): none;
  /// a and b lose a corner, c and d gain one. Inverse: flip(h), which leaves h running from b to a;
  /// four flips leave every id and corner as it was. Cost: O(1).
  /// Ids: all stay. The star half-edges of a and b, if they were the edge's, are the next ones.
  Result<Done, Violation> flip(HalfEdge h);

  /// Puts a vertex on an edge, and joins it to the vertices opposite (stellar subdivision, Fig. 4
  /// and 5):
  ///
  ///          c                    c            f: (a b c) at h  ->  (v c a)    f': (v b c)
  ///         / \                  /|\           g: (b a d) at twin -> (v d b)   g': (v a d)
  ///        / f \                /f|f'\         .
  ///       a --h-> b            a--v--b         On a boundary there is no g. The half-edges of f
  ///        \ g /                \g'|g/         that ran a-b, b-c, c-a: a-v is half-edge 2 of f,
  ///         \ /                  \|/           v-b 0 of f', b-c 1 of f', c-a 1 of f; likewise
  ///          d                    d            those of g.
  ///
  /// Preconditions: `live_half_edge`; `two_faces` of an interior edge; `ids_left`. Effect:
  /// (1,3,2,0,0,0), on a boundary (1,2,1,0,0,0). Inverse: weld of the vertex returned; it leaves
  /// all as it was if the edge was half-edge 1 of its faces, else f and g with their corners
  /// turned. Cost: O(1). Ids: all stay valid. An interior vertex's star half-edge leads to a, where
  /// h began.
  Result<Vertex, Violation> split(HalfEdge h, Point p);

  /// Puts a vertex into a face and joins it to the corners (Fig. 3 a):
  ///
  ///          c                    c
  ///         / \                  /|\           f: (a b c)  ->  (v a b)
  ///        /   \                / | \          f': (v b c), f'': (v c a)
  ///       /  f  \              /f''v f'\         .
  ///      /       \            / _/ f \_ \      The half-edges a-b, b-c, c-a each are half-edge 1
  ///     a ------- b          a ----------b     of their faces.
  ///
  /// Preconditions: `live_face`, `ids_left`. Effect: (1,3,2,0,0,0). Inverse: weld of the vertex
  /// returned, which leaves all as it was. Cost: O(1). Ids: all stay valid. The vertex's star
  /// half-edge leads to a.
  Result<Vertex, Violation> split(Face f, Point p);

  /// Removes the vertex that h leaves, undoing the split that could have made it: of a face if it
  /// has three edges; of an interior edge, which runs from dest(h) straight through the vertex, if
  /// it has four; of a boundary edge if the vertex is on the boundary and has three edges.
  ///
  /// Read the figures of the splits backwards; h leads to a. Faces f and g stay, with the edge a-b
  /// as half-edge 1 (of a boundary edge: f alone); of a face split f stays, with corner 0 at a.
  ///
  /// Preconditions: `live_half_edge`, `weld_degree`, `simple_star`. Effect: the negative of the
  /// split's. Inverse: the split that Welded names, which gives the vertex and faces the same ids
  /// when it comes next. Cost: O(1). Ids: those of the vertex and of one or two faces are freed.
  Result<Welded, Violation> weld(HalfEdge h);

  /// weld(star_half_edge(v)): undoes the split that made v, unless flips have turned its star.
  Result<Welded, Violation> weld(Vertex v) {
    if (!is_live(v)) return Failure{Violation{Precondition::live_vertex, v.index()}};
    return weld(star_half_edge(v));
  }

  // Numbering -------------------------------------------------------------------------------------
  //
  // What flips and welds change besides how the surface is triangulated, and what does not come
  // back when they are undone: with these it does (operator_log.h). No simplex changes.

  /// Numbers the corners of a face anew: corner i becomes corner i+1, and half-edge i half-edge
  /// i+1. What they lead to, and what is glued to them, stays with them.
  ///
  /// Precondition: `live_face`. Effect: none. Inverse: two more turns. Cost: O(1). Ids: those of
  /// the face's half-edges change places; a star half-edge among them, and values, go along.
  Result<Done, Violation> turn(Face f);

  /// Makes h the star half-edge of its origin, with which circulators begin.
  ///
  /// Preconditions: `live_half_edge`; `interior_vertex`, since on the boundary there is no choice.
  /// Effect: none. Inverse: begin_star of the star half-edge that was. Cost: O(1). Ids: all stay.
  Result<Done, Violation> begin_star(HalfEdge h);

  // Whole surfaces --------------------------------------------------------------------------------

  /// The surface with these arrays: org and twin by half-edge, points by vertex (empty: vertex i is
  /// on point i). A face whose three origins are null, and a vertex without corners, are free ids.
  /// O(F + B log B).
  ///
  /// Errors: the first invariant that the arrays break, of array_sizes, origin_is_live,
  /// twin_in_range, twin_is_mutual, twin_is_opposite, one_fan; and its element.
  static Result<Surface, Fault> from_twins(std::span<const Vertex> org,
                                           std::span<const HalfEdge> twin,
                                           std::uint32_t vertex_count,
                                           std::span<const Point> points = {});

  /// The surface of triangles given by their corners, three vertices below vertex_count a face,
  /// counterclockwise: face i has the corners 3i, 3i+1 and 3i+2. Points by vertex (empty: vertex i
  /// is on point i). A vertex without faces is a free id.
  ///
  /// Errors: the first FaceRule (errors.h) that the triangles break, and the first element at which
  /// they do: they must be an oriented manifold, with at most one edge between two vertices.
  /// Cost: O(F + V + B log B).
  static Result<Surface, BrokenRule> from_faces(std::span<const std::uint32_t> corners,
                                                std::uint32_t vertex_count,
                                                std::span<const Point> points = {});

  /// Renumbers the elements of each kind 0 .. n-1, in the order of their ids: afterwards no id
  /// below the limits is dead, and arrays are as small as they can be. Nothing else changes;
  /// containers (element_data.h) follow. Returns which id became which. Throws std::bad_alloc,
  /// having changed nothing, if there is no memory. Cost: O(ids + B log B).
  Compressed compress();

  /// Makes room for this many more faces and vertices at once, so that the arrays need not grow
  /// again and again, and for one weld, which then cannot run out of memory if it comes before any
  /// other. Changes nothing else.
  void reserve(std::uint32_t faces, std::uint32_t vertices) {
    reserve_faces(faces);
    reserve_vertices(vertices);
    room_to_weld();
  }

  /// The arrays from_twins takes, null at dead faces.
  std::span<const Vertex> origins() const { return org_; }
  std::span<const HalfEdge> twins() const { return twin_; }
  /// Of all vertices below vertex_limit(); null at dead ones.
  std::span<const Point> points() const { return point_; }

 private:
  friend struct SurfacePeer;  // corrupts arrays, in tests
  friend class Validator;     // reads them as they are
  template <class IdType, class T>
  friend class ElementData;

  template <class Step>
  Circulator<Step> circulate(HalfEdge start, std::uint32_t size) const {
    return Circulator<Step>({*this, start, size});
  }

  struct IsLive {
    template <class IdType>
    static bool holds(const Surface& s, IdType id) {
      return s.is_live(id);
    }
  };
  template <class IdType>
  ElementRange<FilterCursor<IsLive, IdType>> live(std::uint32_t limit) const {
    return ElementRange(FilterCursor<IsLive, IdType>(*this, limit));
  }
  struct IsEdge {
    static bool holds(const Surface& s, HalfEdge h) { return s.is_live(h) && s.edge(h) == h; }
  };
  struct AroundVertex {
    static HalfEdge after(const Surface& s, HalfEdge h) {
      const HalfEdge side = lprev(h), other = s.sym(side);
      return other ? other : side;
    }
    static Vertex other_end(const Surface& s, HalfEdge h, Vertex v) { return s.other_end(h, v); }
  };
  struct AlongLink {
    static HalfEdge after(const Surface& s, HalfEdge h) { return lnext(s.sym(lnext(h))); }
  };
  struct AcrossEdge {
    static HalfEdge after(const Surface& s, HalfEdge h) { return s.sym(h); }
  };
  struct OppositeEdge {
    static HalfEdge after(const Surface& s, HalfEdge h) { return lprev(s.sym(lnext(h))); }
  };
  struct AroundFace {
    static HalfEdge after(const Surface&, HalfEdge h) { return lnext(h); }
  };
  struct AlongBoundary {
    static HalfEdge after(const Surface& s, HalfEdge h) { return s.boundary_next(h); }
  };

  // Room for so many new ones, so that nothing fails half-way. An operator that frees some asks
  // their pools for room, too.
  void reserve_faces(std::uint32_t count) {
    const std::size_t growth = faces_.growth(count);
    if (room(org_) < 3 * growth || room(twin_) < 3 * growth || room(component_) < growth ||
        data_.any())
      grow_faces(growth);
  }
  void reserve_vertices(std::uint32_t count) {
    const std::size_t growth = vertices_.growth(count);
    if (room(star_) < growth || room(corners_) < growth || room(point_) < growth ||
        room(node_) < growth || data_.any())
      grow_vertices(growth);
  }
  template <class T>
  static std::size_t room(const std::vector<T>& v) {
    return v.capacity() - v.size();
  }
  void grow_faces(std::size_t growth);
  void grow_vertices(std::size_t growth);
  void room_to_weld();
  void reserve_curves(std::uint32_t count);
  void reserve_nodes(std::uint32_t count) { rings_.reserve(count); }
  void reserve_search(Component k);
  void reserve_components(std::uint32_t count);

  // In containers the new element gets the values of `of`, if not null.
  Face new_face(Face of = {}) {
    const Face f = faces_.take();
    if (f.index() == component_.size()) {
      for (unsigned i = 0; i < 3; ++i) org_.emplace_back(), twin_.emplace_back();
      component_.emplace_back();
    }
    if (data_.any()) make_data(f, of);
    return f;
  }
  Vertex new_vertex(HalfEdge star, std::uint32_t corners, Point p, Vertex of = {}) {
    const Vertex v = vertices_.take();
    if (v.index() == star_.size()) {
      star_.emplace_back();
      corners_.emplace_back();
      point_.emplace_back();
      node_.emplace_back();
    }
    if (data_.any()) make_data(v, of);
    star_[v.index()] = star;
    corners_[v.index()] = corners;
    point_[v.index()] = p;
    return v;
  }
  void new_curve(internal::RingNode tree) { name_curve(tree, curves_.take()); }
  Component new_component();
  // Containers; each after data_.any(), so that an operator without them does not pay
  // (element_data.cc).
  void reserve_face_data();
  void reserve_vertex_data();
  void make_data(Face f, Face of);
  void make_data(Vertex v, Vertex of);
  void move_sides(const Change& change);

  void free_face(Face f);
  void free_vertex(Vertex v);
  void free_curve(Curve c);
  void free_component(Component k);

  /// Of a half-edge on the boundary.
  internal::RingNode node(HalfEdge h) const { return node_[org(h).index()]; }
  void set_node(Vertex v, internal::RingNode n) {
    node_[v.index()] = n;
    rings_.set_vertex(n, v);
  }
  void name_curve(internal::RingNode tree, Curve c);
  HandleCase classify(HalfEdge h0, HalfEdge h1) const;
  Vertex merge_fans(std::span<const HalfEdge> starts);
  void relabel_fan(HalfEdge start, Vertex v);
  void split_fans(std::span<const HalfEdge> starts, HalfEdge cut);
  void splice_for_glue(internal::RingNode n0, internal::RingNode n1);
  void relabel_component(Face start, Component k);
  bool separate(HalfEdge h, HalfEdge t, Component whole);
  Characteristic count(std::span<const Face> part) const;
  void find_components();

  /// A side of the rim of a star that is being replaced: which half-edge it was and will be.
  struct RimSide {
    HalfEdge from, to;
  };
  template <std::size_t n>
  void move_rim(const RimSide (&rim)[n]);
  void join(HalfEdge a, HalfEdge b) { twin_[a.index()] = b, twin_[b.index()] = a; }
  void replace_star(HalfEdge gone, HalfEdge other);
  Face split_off(HalfEdge h, Face fresh, Vertex v);
  std::optional<Violation> refuse_weld(HalfEdge h) const;
  Welded weld_interior_edge(HalfEdge h);
  Welded weld_boundary_edge(Vertex v);
  Welded weld_face(HalfEdge h);

  // By half-edge.
  std::vector<Vertex> org_;
  std::vector<HalfEdge> twin_;  // null: boundary
  // By face.
  std::vector<Component> component_;  // null: dead
  // By vertex.
  std::vector<HalfEdge> star_;  // null: dead
  std::vector<std::uint32_t> corners_;
  std::vector<Point> point_;
  std::vector<internal::RingNode> node_;  // null: not on the boundary
  internal::Rings rings_;                 // the boundary curves
  // By curve.
  std::vector<internal::RingNode> ring_;  // root of its tree; null: dead
  // By component.
  std::vector<Characteristic> counts_;  // s is 1; 0: dead

  internal::IdPool<Face> faces_;
  internal::IdPool<Vertex> vertices_;
  internal::IdPool<Curve> curves_;
  internal::IdPool<Component> components_;
  Characteristic total_;
  std::vector<Face> scratch_;  // queues of searches

  internal::Attachments data_;
};

}  // namespace clers

#endif
