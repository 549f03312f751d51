// The flow, and how finely a mesh must follow it.
#include "topology/figures/deforming_sphere.h"

#include <algorithm>
#include <numbers>
#include <vector>

namespace clers::figures {
namespace {

Vector operator+(const Vector& a, const Vector& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
Vector operator-(const Vector& a, const Vector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
Vector operator*(double k, const Vector& a) {
  return {k * a[0], k * a[1], k * a[2]};
}
double dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double length(const Vector& a) {
  return std::sqrt(dot(a, a));
}
Vector unit(const Vector& a) {
  const double l = length(a);
  return l == 0 ? a : (1 / l) * a;
}

constexpr Vector centre{0.35, 0.35, 0.35};

/// Equation (1), with sin(2t) = 2 sin(t) cos(t).
Vector velocity(const Vector& p) {
  Vector s, c;
  for (std::size_t i = 0; i < 3; ++i) {
    s[i] = std::sin(std::numbers::pi * p[i]);
    c[i] = std::cos(std::numbers::pi * p[i]);
  }
  const Vector twice{2 * s[0] * c[0], 2 * s[1] * c[1], 2 * s[2] * c[2]};
  return {2 * s[0] * s[0] * twice[1] * twice[2], -twice[0] * s[1] * s[1] * twice[2],
          -twice[0] * twice[1] * s[2] * s[2]};
}

Vector advect(const Vector& p, double dt) {
  const Vector a = velocity(p);
  const Vector b = velocity(p + (dt / 2) * a);
  const Vector c = velocity(p + (dt / 2) * b);
  const Vector d = velocity(p + dt * c);
  return p + (dt / 6) * (a + 2 * b + 2 * c + d);
}

/// On the sphere, and where the flow takes it.
DeformingSphere::Value place(const Vector& direction, unsigned iterations) {
  DeformingSphere::Value value;
  value.now = value.start = centre + DeformingSphere::radius * unit(direction);
  for (unsigned i = 0; i < iterations; ++i) value.now = advect(value.now, DeformingSphere::step);
  return value;
}

}  // namespace

DeformingSphere::Value DeformingSphere::Sample::operator()(const Value& a, const Value& b) const {
  Value value = place((a.start - centre) + (b.start - centre), *iteration);
  value.normal = unit(a.normal + b.normal);
  value.curvature = std::max(a.curvature, b.curvature);
  return value;
}

DeformingSphere::DeformingSphere(Criterion criterion, unsigned iteration)
    : criterion_(criterion), iteration_(iteration), mesh_(Sample{&iteration_}) {
  constexpr std::array<std::uint32_t, 24> corners{0, 2, 3, 1, 4, 5, 7, 6, 0, 1, 5, 4,
                                                  2, 6, 7, 3, 0, 4, 6, 2, 1, 3, 7, 5};
  constexpr std::array<std::uint32_t, 6> sizes{4, 4, 4, 4, 4, 4};
  std::vector<Value> values;
  for (unsigned i = 0; i < 8; ++i)
    values.push_back(place({i % 2 * 2. - 1, i / 2 % 2 * 2. - 1, i / 4 * 2. - 1}, iteration));
  auto cube = surface_of_polygons(sizes, corners, 8, [](auto...) { return false; });
  (void)mesh_.read(*std::move(cube), std::move(values),
                   [](const Value& a, const Value& b) { return length(a.now - b.now); });
  adaptation_.emplace(mesh_.mesh(), Priority{this}, Thresholds{1, criterion_.keep});
  // The curvature is that of the mesh: a coarse one shows little of it. From the middle down, until
  // it tells nothing new.
  constexpr unsigned enough = 7;
  (void)mesh_.adapt_refine([](const Mesh& m, HalfEdge h) { return m.level(h) < enough; });
  constexpr int rounds = 8;
  for (int i = 0; i < rounds; ++i) {
    const Adapted done = adapt();
    if (done.refined + done.simplified == 0) break;
  }
}

void DeformingSphere::deform() {
  ++iteration_;
  for (const Vertex v : mesh_.surface().vertices()) mesh_[v].now = advect(mesh_[v].now, step);
}

Adapted DeformingSphere::adapt() {
  find_curvature();
  adaptation_->all_changed();
  NoObserver none;
  return adaptation_->adapt({}, mesh_.follow(none));
}

void DeformingSphere::find_curvature() {
  const Surface& surface = mesh_.surface();
  for (const Vertex v : surface.vertices()) mesh_[v].normal = {};
  for (const Face f : surface.faces()) {
    const Vertex a = surface.org(half_edge(f, 0)), b = surface.org(half_edge(f, 1)),
                 c = surface.org(half_edge(f, 2));
    const Vector area = cross(mesh_[b].now - mesh_[a].now, mesh_[c].now - mesh_[a].now);
    for (const Vertex v : {a, b, c}) mesh_[v].normal = mesh_[v].normal + area;
  }
  for (const Vertex v : surface.vertices()) {
    mesh_[v].normal = unit(mesh_[v].normal);
    mesh_[v].curvature = 0;
  }
  for (const HalfEdge h : surface.edges()) {
    Value &a = mesh_[surface.org(h)], &b = mesh_[surface.dest(h)];
    const double turn = length(a.normal - b.normal) / std::fmax(length(a.now - b.now), 1e-12);
    a.curvature = std::max(a.curvature, turn);
    b.curvature = std::max(b.curvature, turn);
  }
}

double DeformingSphere::Priority::operator()(const MultiTriangulation& mesh, HalfEdge h) const {
  const Surface& surface = mesh.surface();
  const Value &a = sphere->mesh_[surface.org(h)], &b = sphere->mesh_[surface.dest(h)];
  return length(a.now - b.now) / sphere->criterion_.length(std::max(a.curvature, b.curvature));
}

double DeformingSphere::Priority::operator()(const MultiTriangulation& mesh, Vertex v) const {
  // The edge that a weld restores runs from the star half-edge's end straight through v.
  const Surface& surface = mesh.surface();
  const HalfEdge h = surface.star_half_edge(v);
  const HalfEdge across = surface.sym(lprev(surface.sym(lprev(h))));
  const Value &a = sphere->mesh_[surface.dest(h)], &b = sphere->mesh_[surface.dest(across)];
  const double curvature = std::max({a.curvature, b.curvature, sphere->mesh_[v].curvature});
  return length(a.now - b.now) / sphere->criterion_.length(curvature);
}

double DeformingSphere::volume() const {
  double six = 0;
  for (const Face f : mesh_.surface().faces()) {
    const auto at = [&](unsigned i) -> const Vector& {
      return (*this)[mesh_.surface().org(half_edge(f, i))];
    };
    six += dot(at(0), cross(at(1), at(2)));
  }
  return six / 6;
}

double DeformingSphere::worst_edge() const {
  double worst = 0;
  for (const HalfEdge h : mesh_.surface().edges()) {
    const Value &a = mesh_[mesh_.surface().org(h)], &b = mesh_[mesh_.surface().dest(h)];
    worst = std::max(worst,
                     length(a.now - b.now) / criterion_.length(std::max(a.curvature, b.curvature)));
  }
  return worst;
}

}  // namespace clers::figures
