// Ids without gaps.
#include <utility>

#include "topology/surface.h"

namespace CLERS_VISIBLE clers {
namespace {

/// The new id of each of the first `limit` ids, given to those of `live` in their order.
template <class IdType, class Range>
std::vector<IdType> dense(std::uint32_t limit, Range live) {
  std::vector<IdType> to(limit);
  std::uint32_t next = 0;
  for (const IdType id : live) to[id.index()] = IdType(next++);
  return to;
}

/// Values move down, in the order of ids: where one goes it overwrites what is dead or has gone.
void compress_data(internal::Attachments& data, const Compressed& to) {
  if (!data.any()) return;
  std::uint32_t faces = 0, vertices = 0;
  for (std::uint32_t i = 0; i < to.faces.size(); ++i) {
    if (!to.faces[i]) continue;
    ++faces;
    data.make(to.faces[i], Face(i));
    for (unsigned c = 0; c < 3; ++c) data.make(half_edge(to.faces[i], c), half_edge(Face(i), c));
  }
  for (std::uint32_t i = 0; i < to.vertices.size(); ++i) {
    if (!to.vertices[i]) continue;
    ++vertices;
    data.make(to.vertices[i], Vertex(i));
  }
  data.resize(internal::DataKind::face, faces);
  data.resize(internal::DataKind::half_edge, 3 * std::size_t{faces});
  data.resize(internal::DataKind::vertex, vertices);
}

}  // namespace

Compressed Surface::compress() {
  Compressed to;
  to.faces = dense<Face>(faces_.size(), faces());
  to.vertices = dense<Vertex>(vertices_.size(), vertices());
  to.curves = dense<Curve>(curves_.size(), curves());
  to.components = dense<Component>(components_.size(), components());
  const auto image = [&](HalfEdge h) {
    return h ? half_edge(to.faces[clers::left(h).index()], corner(h)) : HalfEdge();
  };

  Surface s;
  const auto face_count = static_cast<std::uint32_t>(total_.f);
  s.org_.reserve(3 * std::size_t{face_count});
  s.twin_.reserve(3 * std::size_t{face_count});
  s.component_.reserve(face_count);
  for (const Face f : faces()) {
    for (const HalfEdge h : star(f)) {
      s.org_.push_back(to.vertices[org(h).index()]);
      s.twin_.push_back(image(sym(h)));
    }
    s.component_.push_back(to.components[component(f).index()]);
  }
  s.star_.reserve(static_cast<std::size_t>(total_.v));
  s.corners_.reserve(static_cast<std::size_t>(total_.v));
  s.point_.reserve(static_cast<std::size_t>(total_.v));
  s.node_.resize(static_cast<std::size_t>(total_.v));
  s.reserve_nodes(static_cast<std::uint32_t>(2 * total_.e - 3 * total_.f));
  for (const Vertex v : vertices()) {
    s.star_.push_back(image(star_[v.index()]));
    s.corners_.push_back(corners_[v.index()]);
    s.point_.push_back(point(v));
    if (is_boundary(v)) s.set_node(to.vertices[v.index()], s.rings_.single());
  }
  s.ring_.reserve(static_cast<std::size_t>(total_.b));
  for (const Curve c : curves()) {
    internal::RingNode tree;
    for (const HalfEdge h : boundary(c))
      tree = s.rings_.join(tree, s.node_[to.vertices[org(h).index()].index()]);
    s.name_curve(tree, to.curves[c.index()]);
  }
  s.counts_.reserve(static_cast<std::size_t>(total_.s));
  for (const Component k : components()) s.counts_.push_back(counts_[k.index()]);
  s.faces_.fill(face_count);
  s.vertices_.fill(static_cast<std::uint32_t>(total_.v));
  s.curves_.fill(static_cast<std::uint32_t>(total_.b));
  s.components_.fill(static_cast<std::uint32_t>(total_.s));
  s.total_ = total_;

  // Nothing fails any more.
  compress_data(data_, to);
  s.data_ = std::move(data_);
  *this = std::move(s);
  return to;
}

}  // namespace clers
