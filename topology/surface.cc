// Elements of a surface: ids, room for them, create and destroy.
#include "topology/surface.h"

namespace CLERS_VISIBLE clers {

using internal::reserve_more;

void Surface::grow_faces(std::size_t growth) {
  reserve_more(org_, 3 * growth);
  reserve_more(twin_, 3 * growth);
  reserve_more(component_, growth);
  if (data_.any()) reserve_face_data();
}

void Surface::grow_vertices(std::size_t growth) {
  reserve_more(star_, growth);
  reserve_more(corners_, growth);
  reserve_more(point_, growth);
  reserve_more(node_, growth);
  if (data_.any()) reserve_vertex_data();
}

void Surface::room_to_weld() {
  faces_.room_to_give(2);
  vertices_.room_to_give(1);
  rings_.room_to_free(1);
}

void Surface::reserve_curves(std::uint32_t count) {
  reserve_more(ring_, curves_.growth(count));
}

/// Makes room for the queues of a search in this component, which then holds all its faces. Other
/// operators need none.
void Surface::reserve_search(Component k) {
  const auto faces = static_cast<std::size_t>(counts_[k.index()].f);
  if (scratch_.size() >= faces) return;
  reserve_more(scratch_, faces - scratch_.size());
  scratch_.resize(faces);
}

void Surface::reserve_components(std::uint32_t count) {
  reserve_more(counts_, components_.growth(count));
}

Component Surface::new_component() {
  const Component k = components_.take();
  if (k.index() == counts_.size()) counts_.emplace_back();
  return k;
}

void Surface::free_face(Face f) {
  for (HalfEdge h : star(f)) {
    org_[h.index()] = Vertex();
    twin_[h.index()] = HalfEdge();
  }
  component_[f.index()] = Component();
  faces_.give(f);
}

void Surface::free_vertex(Vertex v) {
  star_[v.index()] = HalfEdge();
  corners_[v.index()] = 0;
  point_[v.index()] = Point();
  node_[v.index()] = internal::RingNode();
  vertices_.give(v);
}

void Surface::free_curve(Curve c) {
  ring_[c.index()] = internal::RingNode();
  curves_.give(c);
}

void Surface::free_component(Component k) {
  counts_[k.index()] = Characteristic{};
  components_.give(k);
}

void Surface::name_curve(internal::RingNode tree, Curve c) {
  if (c.index() == ring_.size()) ring_.emplace_back();
  ring_[c.index()] = tree;
  rings_.set_curve(tree, c);
}

Result<Face, Violation> Surface::create(Point p0, Point p1, Point p2) {
  if (faces_.growth(1) != 0 && faces_.size() == max_faces)
    return Failure{Violation{Precondition::ids_left, max_faces}};
  reserve_faces(1);
  reserve_vertices(3);
  reserve_nodes(3);
  reserve_curves(1);
  reserve_components(1);

  const Face f = new_face();
  const Point points[3] = {p0, p1, p2};
  internal::RingNode ring;
  for (unsigned i = 0; i < 3; ++i) {
    const HalfEdge h = half_edge(f, i);
    const Vertex v = new_vertex(h, 1, points[i]);
    org_[h.index()] = v;
    set_node(v, rings_.single());
    ring = rings_.join(ring, node(h));
  }
  new_curve(ring);

  const Component k = new_component();
  component_[f.index()] = k;
  counts_[k.index()] = effect_of_create;
  total_ += effect_of_create;
  return f;
}

Result<std::array<Point, 3>, Violation> Surface::destroy(Face f) {
  if (!is_live(f)) return Failure{Violation{Precondition::live_face, f.index()}};
  for (HalfEdge h : star(f))
    if (!is_boundary(h)) return Failure{Violation{Precondition::all_edges_on_boundary, f.index()}};

  faces_.room_to_give(1);
  vertices_.room_to_give(3);
  rings_.room_to_free(3);
  curves_.room_to_give(1);
  components_.room_to_give(1);

  std::array<Point, 3> points;
  free_curve(curve(half_edge(f, 0)));
  // Backwards, so that a create next gives every corner the same vertex again.
  for (unsigned i = 3; i-- > 0;) {
    const HalfEdge h = half_edge(f, i);
    points[i] = point(org(h));
    rings_.free(node(h));
    free_vertex(org(h));
  }
  free_component(component(f));
  free_face(f);
  total_ -= effect_of_create;
  return points;
}

}  // namespace clers
