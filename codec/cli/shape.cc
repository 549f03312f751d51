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
      component_(surface.face_limit()) {
  std::vector<std::vector<Triangle>> triangles;  // by component
  for (const Face f : surface.faces()) {
    Triangle t;
    for (unsigned i = 0; i < 3; ++i) {
      const Vertex v = surface.org(half_edge(f, i));
      of_[f.index()][i] = v;
      t[i] = at[v.index()];
    }
    const std::size_t component = surface.component(f).index();
    component_[f.index()] = surface.component(f);
    if (component >= triangles.size()) {
      triangles.resize(component + 1);
      components_.resize(component + 1);
    }
    triangles[component].push_back(t);
    components_[component].of.push_back(half_edge(f, 0));
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
  for (std::size_t k = 0; k < triangles.size(); ++k) components_[k].nearest.emplace(triangles[k]);
  std::vector<Triangle> segments;
  for (const Curve c : surface.curves()) {
    curves_.resize(c.index() + std::size_t{1});
    Part& part = curves_.back();
    segments.clear();
    for (const HalfEdge h : surface.boundary(c)) {
      const Vec3 &a = at[surface.org(h).index()], &b = at[surface.dest(h).index()];
      part.of.push_back(h);
      segments.push_back({a, b, b});
    }
    part.nearest.emplace(segments);
  }
}

Sample Shape::sample(Face f, const std::array<double, 3>& weights, const Vec3& at,
                     Curve curve) const {
  Sample made{at, {}, f, weights, curve};
  for (unsigned i = 0; i < 3; ++i)
    made.normal += weights[i] * corners_[of_[f.index()][i].index()].normal;
  made.normal = unit(made.normal);
  return made;
}

Sample Shape::between(const Sample& a, const Sample& b, bool boundary) const {
  const Part& part =
      boundary ? curves_[a.curve.index()] : components_[component_[a.face.index()].index()];
  const Vec3 edge = b.at - a.at, facing = boundary ? Vec3() : a.normal + b.normal;
  Nearest::Query query;
  query.p = 0.5 * (a.at + b.at);

  const auto made = [&](const Nearest::Found& found) {
    Sample q;
    const HalfEdge h = part.of[found.triangle];
    if (boundary) {
      std::array<double, 3> weights{};
      weights[corner(h)] = found.weights[0];
      weights[(corner(h) + 1) % 3] = found.weights[1] + found.weights[2];
      q = sample(left(h), weights, found.at, a.curve);
    } else {
      q = sample(left(h), found.weights, found.at, {});
    }
    q.distance = std::sqrt(found.distance2);
    return q;
  };
  // As far as the ends are from the middle, at most; then the parts are shorter than the edge.
  using Maybe = std::optional<Nearest::Found>;
  const auto try_nearest = [&](const Vec3& direction) -> Maybe {
    query.facing = direction, query.plane = {};
    const Maybe found = (*part.nearest)(query);
    if (!found || found->distance2 > 0.25001 * squared(edge)) return {};
    const double share = dot(found->at - a.at, edge);
    return share >= 0.25 * squared(edge) && share <= 0.75 * squared(edge) ? found : Maybe();
  };
  const auto try_halving = [&](const Vec3& direction) -> Maybe {
    query.facing = direction, query.plane = edge;
    const Maybe found = (*part.nearest)(query);
    return found && found->distance2 <= 0.25001 * squared(edge) ? found : Maybe();
  };
  for (const Vec3& direction : {facing, Vec3()}) {
    if (const Maybe found = try_nearest(direction)) return made(*found);
    if (const Maybe found = try_halving(direction)) return made(*found);
  }
  query.facing = query.plane = {};
  Sample middle = made(*(*part.nearest)(query));  // there is one: no part is empty
  middle.at = query.p;
  middle.on_shape = false;
  return middle;
}

}  // namespace clers::cli
