// Normals of vertices, and which part of the surface a sample may be on.
#include "codec/cli/shape.h"

#include <algorithm>
#include <cmath>

namespace clers::cli {
namespace {

double angle(const Vec3& a, const Vec3& b) {
  return std::atan2(length(cross(a, b)), dot(a, b));
}

}  // namespace

Shape::Shape(const Surface& surface, const std::vector<Vec3>& at)
    : corners_(surface.vertex_limit()),
      of_(surface.face_limit()),
      components_(surface.face_limit()) {
  std::vector<Triangle> triangles(surface.face_limit());
  for (const Face f : surface.faces()) {
    Triangle& t = triangles[f.index()];
    for (unsigned i = 0; i < 3; ++i) {
      const Vertex v = surface.org(half_edge(f, i));
      of_[f.index()][i] = v;
      t[i] = at[v.index()];
    }
    components_[f.index()] = surface.component(f).index();
    // Weighted by angles: how a corner is cut into triangles makes no difference.
    const Vec3 normal = unit(cross(t[1] - t[0], t[2] - t[0]));
    for (unsigned i = 0; i < 3; ++i) {
      const Vec3 &p = t[i], &next = t[(i + 1) % 3], &prev = t[(i + 2) % 3];
      corners_[of_[f.index()][i].index()].normal += angle(next - p, prev - p) * normal;
    }
  }
  for (const Vertex v : surface.vertices()) {
    const HalfEdge h = surface.star_half_edge(v);
    Sample& sample = corners_[v.index()];
    sample.at = at[v.index()];
    sample.normal = unit(sample.normal);
    sample.face = left(h);
    sample.weights = {};
    sample.weights[corner(h)] = 1;
    if (surface.is_boundary(v)) sample.curve = surface.curve(h);
  }
  faces_.emplace(triangles);
  triangles.clear();
  for (const Curve c : surface.curves())
    for (const HalfEdge h : surface.boundary(c)) {
      const Vec3 &a = at[surface.org(h).index()], &b = at[surface.dest(h).index()];
      rim_.push_back(h);
      curves_.push_back(c.index());
      triangles.push_back({a, b, b});
    }
  rim_places_.emplace(triangles);
}

Sample Shape::sample(Face f, const std::array<double, 3>& weights, const Vec3& at,
                     Curve curve) const {
  Sample made{at, {}, f, weights, curve};
  for (unsigned i = 0; i < 3; ++i)
    made.normal += weights[i] * corners_[of_[f.index()][i].index()].normal;
  made.normal = unit(made.normal);
  return made;
}

std::optional<Nearest::Found> Shape::find(const Nearest& where, const Nearest::Query& query,
                                          const Sample& a, const Sample& b,
                                          const std::vector<std::uint32_t>& classes) const {
  const Vec3 edge = b.at - a.at;
  auto found = where(query, classes);
  if (!found) return found;
  const double share = dot(found->at - a.at, edge);
  if (share >= 0.25 * squared(edge) && share <= 0.75 * squared(edge)) return found;
  Nearest::Query halving = query;
  halving.plane = edge;
  if (const auto other = where(halving, classes)) return other;
  return found;
}

Sample Shape::between(const Sample& a, const Sample& b, bool boundary) const {
  Nearest::Query query;
  query.p = 0.5 * (a.at + b.at);
  if (boundary) {
    const std::uint32_t curve = a.curve.index();
    query.of_class = &curve;
    const auto found = find(*rim_places_, query, a, b, curves_);
    const HalfEdge h = rim_[found->triangle];
    std::array<double, 3> weights{};
    weights[corner(h)] = found->weights[0];
    weights[(corner(h) + 1) % 3] = found->weights[1] + found->weights[2];
    return sample(left(h), weights, found->at, a.curve);
  }
  const std::uint32_t component = components_[a.face.index()];
  query.of_class = &component;
  query.facing = a.normal + b.normal;
  auto found = find(*faces_, query, a, b, components_);
  if (!found) {
    query.facing = {};
    found = find(*faces_, query, a, b, components_);
  }
  return sample(Face(found->triangle), found->weights, found->at, {});
}

}  // namespace clers::cli
