// The vertex that stays gets the values of the place where it is put: of the faces around both
// ends. Along an edge that is a seam, those of the edge, and each side its own:
//
//         l            The corners of `gone` and `kept` in the face of l become mixtures of both,
//        / .           and so do those in the face of r. All corners that have these values, as
//   gone ---- kept     those of a fan between two seams do, get the mixtures. Where other seams
//        . /           end, `kept` stays, and so do its values.
//         r
#include "codec/cli/carried.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "codec/cli/nearest.h"
#include "codec/cli/vertex_values.h"

namespace clers::cli {

// ---- Elements

Carried::Carried(const Mesh& mesh, const SurfaceByCuts& cut, Creases& creases,
                 std::vector<std::string>& notes)
    : surface_(cut.surface), cut_(cut), creases_(creases), mesh_(mesh) {
  for (const Attribute& a : mesh.attributes) {
    if (&a == mesh.position()) continue;
    Track track{&a, MixedValues(a), {}};
    const auto give = [&](std::uint32_t i) {
      track.of.push_back(a.indices.empty() ? i : a.indices[i]);
    };
    switch (a.domain) {
      case Domain::vertex:
        for (std::uint32_t v = 0; v < mesh.vertex_count; ++v) give(v);
        for (const std::uint32_t v : cut.copied) give(v);
        vertices_.push_back(std::move(track));
        break;
      case Domain::face:
        for (std::uint32_t f = 0; f < surface_.face_limit(); ++f) give(f);
        if (!mark_seams(track, creases))
          notes.push_back(fmt::format(
              "attribute \"{}\" changes at most edges: faces alike are not kept together", a.name));
        faces_.push_back(std::move(track));
        break;
      case Domain::corner:
        for (std::uint32_t h = 0; h < surface_.half_edge_limit(); ++h)
          give(corner_of_mesh(HalfEdge(h)));
        share(track);
        if (mark_seams(track, creases))
          corners_.push_back(std::move(track));
        else
          notes.push_back(
              fmt::format("attribute \"{}\" is left out: it has seams at most edges", a.name));
        break;
    }
  }
}

std::uint32_t Carried::corner_of_mesh(HalfEdge h) const {
  const std::uint32_t f = left(h).index(), i = corner(h);
  const bool turned = std::binary_search(cut_.reversed.begin(), cut_.reversed.end(), f);
  return 3 * f + (turned ? (3 - i) % 3 : i);
}

/// Gives equal values at a vertex one number.
void Carried::share(Track& track) const {
  std::vector<HalfEdge> corners;
  for (const Vertex v : surface_.vertices()) {
    corners.clear();
    for (const HalfEdge h : surface_.fan(v)) corners.push_back(h);
    const auto value = [&](HalfEdge h) -> std::uint32_t& { return track.of[h.index()]; };
    std::sort(corners.begin(), corners.end(),
              [&](HalfEdge a, HalfEdge b) { return track.values.less(value(a), value(b)); });
    for (std::size_t i = 1; i < corners.size(); ++i)
      if (track.values.same(value(corners[i]), value(corners[i - 1])))
        value(corners[i]) = value(corners[i - 1]);
  }
}

bool Carried::is_seam(const Track& track, HalfEdge h) const {
  const HalfEdge twin = surface_.sym(h);
  if (!twin) return false;
  const auto& of = track.of;
  if (track.attribute->domain == Domain::face)
    return !track.values.same(of[left(h).index()], of[left(twin).index()]);
  return of[h.index()] != of[lnext(twin).index()] || of[lnext(h).index()] != of[twin.index()];
}

/// Or does not: returns false if they are most edges.
bool Carried::mark_seams(const Track& track, Creases& creases) const {
  std::vector<HalfEdge> seams;
  std::size_t inside = 0;
  for (const HalfEdge h : surface_.edges()) {
    if (!surface_.is_boundary(h)) ++inside;
    if (is_seam(track, h)) seams.push_back(h);
  }
  if (4 * seams.size() > 3 * inside) return false;
  for (const HalfEdge h : seams) creases.mark(surface_, h);
  return true;
}

// ---- Contractions

/// For the side of the edge on which this half-edge is.
Carried::Origin Carried::origin(const Contraction& c, HalfEdge side,
                                const std::vector<Position3>& at) const {
  if (c.place == at[c.kept.index()] || c.place == at[c.gone.index()]) {
    const bool of_kept = (surface_.org(side) == c.kept) == (c.place == at[c.kept.index()]);
    return {{side, lnext(side), lprev(side)}, {of_kept ? 1. : 0., of_kept ? 0. : 1., 0}};
  }
  const auto point = [&](HalfEdge h) {
    const Position3& p = at[surface_.org(h).index()];
    return Vec3{p[0], p[1], p[2]};
  };
  Origin origin;
  double nearest = std::numeric_limits<double>::infinity();
  const auto look_at = [&](const std::array<HalfEdge, 3>& corners) {
    const PointOfTriangle found =
        nearest_of({point(corners[0]), point(corners[1]), point(corners[2])},
                   {c.place[0], c.place[1], c.place[2]});
    if (!(found.distance2 < nearest)) return;
    nearest = found.distance2;
    origin = {corners, found.weights};
  };
  if (creases_.is_sharp(surface_, side)) {
    // The place may be beyond an end of the edge: on the curve before or after it.
    HalfEdge before = lprev(side), after = lnext(side);
    while (!creases_.is_sharp(surface_, before)) before = lprev(surface_.sym(before));
    while (!creases_.is_sharp(surface_, after)) after = lnext(surface_.sym(after));
    for (const HalfEdge h : {side, before, after}) look_at({h, lnext(h), lnext(h)});
  } else {
    for (const Vertex end : {c.kept, c.gone})
      for (const HalfEdge f : surface_.fan(end)) look_at({f, lnext(f), lprev(f)});
  }
  return origin;
}

void Carried::before(const Contraction& c, const std::vector<Position3>& at) {
  if (vertices_.empty() && corners_.empty() && faces_.empty()) return;
  const HalfEdge twin = surface_.sym(c.edge);
  const Origin one = origin(c, c.edge, at),
               two = twin && creases_.is_sharp(surface_, c.edge) ? origin(c, twin, at) : one;
  for (Track& t : vertices_) {
    std::array<std::uint32_t, 3> of{};
    for (std::size_t i = 0; i < 3; ++i) of[i] = t.of[surface_.org(one.corners[i]).index()];
    t.of[c.kept.index()] = t.values.mix(of, one.weights);
  }
  if (corners_.empty() && faces_.empty()) return;

  /// What corners of both ends become, on each side.
  struct Side {
    std::uint32_t kept, gone, mixture;
  };
  std::vector<std::array<Side, 2>> sides;
  for (Track& t : corners_) {
    const auto mixed = [&](HalfEdge at_kept, HalfEdge at_gone, const Origin& from) {
      std::array<std::uint32_t, 3> of{};
      for (std::size_t i = 0; i < 3; ++i) of[i] = t.of[from.corners[i].index()];
      return Side{t.of[at_kept.index()], t.of[at_gone.index()], t.values.mix(of, from.weights)};
    };
    const Side first = mixed(lnext(c.edge), c.edge, one);
    const bool alike =
        !twin || (t.of[twin.index()] == first.kept && t.of[lnext(twin).index()] == first.gone);
    sides.push_back({first, alike ? first : mixed(twin, lnext(twin), two)});
  }

  kept_.clear();
  values_.clear();
  for (const Vertex end : {c.kept, c.gone}) {
    const Vertex other = end == c.kept ? c.gone : c.kept;
    for (const HalfEdge f : surface_.fan(end)) {
      const Vertex to = surface_.dest(f), next = surface_.org(lprev(f));
      if (to == other || next == other) continue;
      kept_.push_back({to, next, values_.size()});
      for (std::size_t i = 0; i < corners_.size(); ++i) {
        const auto& of = corners_[i].of;
        std::uint32_t value = of[f.index()];
        for (const Side& side : sides[i])
          if (value == (end == c.kept ? side.kept : side.gone)) {
            value = side.mixture;
            break;
          }
        values_.insert(values_.end(), {value, of[lnext(f).index()], of[lprev(f).index()]});
      }
      for (const Track& t : faces_) values_.push_back(t.of[left(f).index()]);
    }
  }
}

void Carried::after(const Contraction& c) {
  if (corners_.empty() && faces_.empty()) return;
  std::size_t expected = 0;  // they come in the same order but for where they begin
  for (const HalfEdge f : surface_.fan(c.kept)) {
    const Vertex to = surface_.dest(f), next = surface_.org(lprev(f));
    for (std::size_t tried = 0; tried < kept_.size(); ++tried, ++expected) {
      if (expected >= kept_.size()) expected = 0;
      const Kept& kept = kept_[expected];
      if (kept.to != to || kept.next != next) continue;
      const std::uint32_t* value = values_.data() + kept.values;
      for (Track& t : corners_)
        for (const HalfEdge h : {f, lnext(f), lprev(f)}) t.of[h.index()] = *value++;
      for (Track& t : faces_) t.of[left(f).index()] = *value++;
      ++expected;
      break;
    }
  }
}

// ---- The mesh

Attribute Carried::made_of(const Track& track, const std::vector<std::uint32_t>& elements) {
  const Attribute& a = *track.attribute;
  Attribute out{a.name, a.domain, a.scalar, a.components, {}};
  const std::size_t stride = a.stride();
  const auto append = [&](std::uint32_t value) {
    out.data.resize(out.data.size() + stride);
    track.values.write(value, out.data.data() + out.data.size() - stride);
  };
  if (a.indices.empty()) {
    out.data.reserve(elements.size() * stride);
    for (const std::uint32_t i : elements) append(track.of[i]);
    return out;
  }
  std::vector<std::uint32_t> number;  // of values that elements have
  for (const std::uint32_t i : elements) {
    const std::uint32_t value = track.of[i];
    if (value == no_value) {
      out.indices.push_back(no_value);
      continue;
    }
    if (value >= number.size()) number.resize(value + std::size_t{1}, no_value);
    if (number[value] == no_value) {
      number[value] = static_cast<std::uint32_t>(out.data.size() / stride);
      append(value);
    }
    out.indices.push_back(number[value]);
  }
  return out;
}

std::vector<Attribute> Carried::attributes(const MeshOfSurface& made,
                                           const std::vector<Position3>& at) const {
  std::vector<std::uint32_t> vertices, corners, faces;
  for (const Vertex v : made.vertices) vertices.push_back(v.index());
  for (const Face f : made.faces) {
    faces.push_back(f.index());
    for (unsigned i = 0; i < 3; ++i) corners.push_back(half_edge(f, i).index());
  }
  std::vector<Attribute> out;
  for (const Attribute& a : mesh_.attributes) {
    if (&a == mesh_.position()) {
      Attribute& position = out.emplace_back(Attribute{a.name, a.domain, a.scalar, 3, {}});
      const std::size_t size = size_of(a.scalar);
      position.data.resize(vertices.size() * 3 * size);
      std::byte* to = position.data.data();
      for (const std::uint32_t v : vertices)
        for (const double x : at[v]) store(a.scalar, x, std::exchange(to, to + size));
      continue;
    }
    for (const auto* tracks : {&vertices_, &corners_, &faces_})
      for (const Track& t : *tracks)
        if (t.attribute == &a)
          out.push_back(made_of(t, a.domain == Domain::vertex   ? vertices
                                   : a.domain == Domain::corner ? corners
                                                                : faces));
  }
  return out;
}

}  // namespace clers::cli
