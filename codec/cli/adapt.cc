// The command adapt: a shape, a base, criteria; then the mesh and what became of it.
#include "codec/cli/adapt.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>
#include <utility>

#include "codec/cli/coarsen.h"
#include "codec/cli/criteria.h"
#include "codec/cli/places.h"
#include "codec/cli/printable.h"
#include "codec/cli/report.h"
#include "codec/cli/shape.h"
#include "codec/cli/vertex_values.h"
#include "codec/surface.h"
#include "topology/modeling/adaptive_mesh.h"
#include "topology/modeling/base_mesh.h"
#include "topology/modeling/dynamic_adaptation.h"

namespace clers::cli {
namespace {

constexpr double pi = 3.14159265358979323846;

ErrorCode code_of(FaceRule rule) {
  switch (rule) {
    case FaceRule::distinct_corners: return ErrorCode::degenerate_face;
    case FaceRule::at_most_two_faces: return ErrorCode::nonmanifold_edge;
    case FaceRule::opposite_directions: return ErrorCode::nonorientable;
    case FaceRule::one_fan: return ErrorCode::nonmanifold_vertex;
    default: return ErrorCode::inconsistent_mesh;
  }
}

/// The input's surface; polygons are cut into triangles, quadrilaterals along the shorter diagonal.
Expected<PolygonSurface> surface_of(const Mesh& mesh, const std::vector<Vec3>& at) {
  if (mesh.triangles_only()) {
    auto surface = to_surface(mesh);
    if (!surface) return Failure{surface.error()};
    return PolygonSurface{std::move(*surface), {}};
  }
  const auto across = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    return squared(at[a] - at[c]) < squared(at[b] - at[d]);
  };
  auto made = surface_of_polygons(mesh.face_sizes, mesh.corners, mesh.vertex_count, across);
  if (!made)
    return fail(code_of(made.error().rule),
                clers::describe(made.error()) + ", its polygons being cut into triangles");
  return std::move(*made);
}

/// Values of vertices that go along, the positions first.
struct Carried {
  std::vector<const Attribute*> attributes;

  Carried(const Mesh& mesh, std::vector<std::string>& notes) : attributes{mesh.position()} {
    for (const Attribute& a : mesh.attributes) {
      if (&a == mesh.position()) continue;
      if (a.domain == Domain::vertex && a.indices.empty())
        attributes.push_back(&a);
      else
        notes.push_back(fmt::format("attribute \"{}\" is left out", a.name));
    }
  }

  Expected<Mesh> mesh_of(const Followed& followed, const Shape& shape,
                         const std::string& name) const {
    const Surface& surface = followed.surface();
    std::vector<std::vector<std::byte>> data;
    std::vector<AttributeView> views;
    for (const Attribute* a : attributes) {
      data.emplace_back(surface.vertex_limit() * a->stride());
      for (const Vertex v : surface.vertices())
        put(*a, followed[v], shape, a == attributes[0],
            data.back().data() + v.index() * a->stride());
      views.push_back({a->name, a->domain, a->scalar, a->components, data.back(), 0, {}});
    }
    auto made = to_mesh(surface, views);
    if (!made) return Failure{made.error()};
    made->mesh.name = name;
    return std::move(made->mesh);
  }

 private:
  static void put(const Attribute& a, const Sample& sample, const Shape& shape, bool is_position,
                  std::byte* to) {
    const std::size_t size = size_of(a.scalar);
    const auto& corners = shape.corners(sample.face);
    const auto value = [&](unsigned i) { return a.data.data() + corners[i].index() * a.stride(); };
    for (unsigned i = 0; i < 3; ++i)
      if (sample.weights[i] == 1) {
        std::memcpy(to, value(i), a.stride());
        return;
      }
    const std::array<double, 3> at{sample.at.x, sample.at.y, sample.at.z};
    for (std::size_t k = 0; k < a.components; ++k) {
      double x = 0;
      if (is_position)
        x = at[k];
      else
        for (unsigned i = 0; i < 3; ++i)
          if (sample.weights[i] > 0) x += sample.weights[i] * load(a.scalar, value(i) + k * size);
      store(a.scalar, x, to + k * size);
    }
  }
};

/// Where the brush is in each frame: it goes from ball to ball, half the smaller radius a step.
std::vector<Brush> way_of(const std::vector<Brush>& balls, std::size_t most) {
  std::vector<Brush> way{balls[0]};
  for (std::size_t i = 1; i < balls.size(); ++i) {
    const Brush &from = balls[i - 1], &to = balls[i];
    const double step = std::min(from.radius, to.radius) / 2;
    const double steps = std::max(1., std::ceil(length(to.centre - from.centre) / step));
    if (!(steps < static_cast<double>(most - way.size()))) return {};
    for (double k = 1; k <= steps; ++k) {
      const double t = k / steps;
      way.push_back({(1 - t) * from.centre + t * to.centre, (1 - t) * from.radius + t * to.radius});
    }
  }
  return way;
}

void measure(const Followed& mesh, const Criteria& criteria, AdaptedMesh& result) {
  const Surface& surface = mesh.surface();
  result.after = surface.characteristic();
  for (const Vertex v : surface.vertices()) {
    result.level = std::max(result.level, mesh.level(v));
    if (!mesh[v].on_shape) ++result.off_shape;
  }
  result.least_angle = surface.characteristic().f == 0 ? 0 : 60;
  for (const Face f : surface.faces()) {
    Triangle t;
    Vec3 normal;
    for (unsigned i = 0; i < 3; ++i) {
      const Sample& corner = mesh[surface.org(half_edge(f, i))];
      t[i] = corner.at;
      normal += corner.normal;
      result.error = std::max(result.error, std::abs(criteria.off(half_edge(f, i))));
    }
    for (unsigned i = 0; i < 3; ++i) {
      const Vec3 next = t[(i + 1) % 3] - t[i], prev = t[(i + 2) % 3] - t[i];
      result.longest_edge = std::max(result.longest_edge, length(next));
      result.least_angle = std::min(
          result.least_angle, std::atan2(length(cross(next, prev)), dot(next, prev)) * 180 / pi);
    }
    if (dot(cross(t[1] - t[0], t[2] - t[0]), normal) < 0) ++result.turned;
  }
}

}  // namespace

Expected<AdaptedMesh> adapt(const Mesh& mesh, const Adaptation& how,
                            const std::function<void(double)>& progress,
                            const std::function<bool(Mesh)>& frame) {
  const auto at = places_of(mesh, "adapt");
  if (!at) return Failure{at.error()};
  auto input = surface_of(mesh, *at);
  if (!input) return Failure{input.error()};
  AdaptedMesh result;
  result.before = input->surface.characteristic();
  const std::uint64_t isolated = mesh.vertex_count - static_cast<std::uint64_t>(result.before.v);
  if (isolated != 0)
    result.notes.push_back(fmt::format("{} isolated {} left out", isolated,
                                       isolated == 1 ? "vertex is" : "vertices are"));
  const Carried carried(mesh, result.notes);
  result.diagonal = diagonal_of(input->surface, *at);

  const Shape shape(input->surface, *at);
  std::vector<Sample> samples(input->surface.vertex_limit());
  for (const Vertex v : input->surface.vertices()) samples[v.index()] = shape.at(v);
  if (how.base && result.before.f > *how.base) {
    coarsen(input->surface, shape, *how.base, [&](double done) { progress(0.5 * done); });
    input->quads.clear();
    const Compressed made = input->surface.compress();
    for (std::size_t v = 0; v < made.vertices.size(); ++v)
      if (made.vertices[v]) samples[made.vertices[v].index()] = samples[v];
    samples.resize(input->surface.vertex_limit());
  }
  result.base = input->surface.characteristic();

  Followed followed(Projection{&shape});
  const auto between = [](const Sample& a, const Sample& b) { return length(b.at - a.at); };
  if (const auto ok = followed.read(std::move(*input), std::move(samples), between); !ok)
    return fail(ErrorCode::too_large, clers::describe(ok.error()));
  Criteria criteria(followed);
  progress(0.6);

  Wanted wanted;
  if (how.error) wanted.error = how.error->in_units(result.diagonal);
  if (how.edge_length) wanted.edge_length = how.edge_length->in_units(result.diagonal);
  wanted.level = how.level.value_or(0);
  wanted.near = how.near;
  criteria.set(wanted);

  DynamicAdaptation adaptation(followed.mesh(), PriorityOf{&criteria}, Thresholds{1, 1});
  auto observer = followed.follow(criteria);
  AdaptationLimits limits{MultiTriangulation::max_level, how.faces};
  const auto show = [&]() -> Expected<Done> {
    auto made = carried.mesh_of(followed, shape, mesh.name);
    if (!made) return Failure{made.error()};
    ++result.frames;
    if (!frame(std::move(*made))) return fail(ErrorCode::io_failed, "a frame was not written");
    return Done{};
  };

  constexpr std::size_t most_frames = 9999;
  if (how.frames && how.near.size() > 1) {
    const std::vector<Brush> way = way_of(how.near, most_frames);
    if (way.empty())
      return fail(ErrorCode::bad_option,
                  fmt::format("the way of the ball has more than {} frames", most_frames));
    for (const Brush& brush : way) {
      wanted.near = {&brush, 1};
      criteria.set(wanted);
      adaptation.all_changed();
      result.limited = adaptation.adapt(limits, observer).face_limit;
      if (auto ok = show(); !ok) return Failure{ok.error()};
      progress(0.6 + 0.4 * static_cast<double>(result.frames) / static_cast<double>(way.size()));
    }
  } else if (how.frames) {
    Adapted done;
    for (limits.level = 0;; ++limits.level) {
      done = adaptation.adapt(limits, observer);
      if (limits.level == 0 || done.refined != 0)
        if (auto ok = show(); !ok) return Failure{ok.error()};
      if (!done.level_limit || limits.level == MultiTriangulation::max_level) break;
    }
    result.limited = done.face_limit;
  } else {
    const Adapted done = adaptation.adapt(limits, observer);
    result.limited = !done.complete();
  }
  auto made = carried.mesh_of(followed, shape, mesh.name);
  if (!made) return Failure{made.error()};
  result.mesh = std::move(*made);
  measure(followed, criteria, result);
  return result;
}

std::string describe(const AdaptedMesh& r) {
  const auto many = [](std::int64_t n, const char* one, const char* more) {
    return fmt::format("{} {}", n, n == 1 ? one : more);
  };
  return fmt::format(
      "{} -> {} triangles, {} -> {} vertices, base of {}, levels to {}; error {:.3g} ({:.2g} % of "
      "the diagonal), edges to {:.3g}, angles from {:.1f} degrees; {}, {}, genus {}",
      r.before.f, r.after.f, r.before.v, r.after.v, r.base.f, r.level, r.error,
      r.diagonal > 0 ? 100 * r.error / r.diagonal : 0., r.longest_edge, r.least_angle,
      many(r.after.s, "component", "components"),
      many(r.after.b, "boundary curve", "boundary curves"), r.after.g);
}

std::string adapted_json(const std::string& name, const AdaptedMesh& r) {
  const nlohmann::ordered_json json{{"file", name},
                                    {"triangles_before", r.before.f},
                                    {"vertices_before", r.before.v},
                                    {"base_triangles", r.base.f},
                                    {"triangles", r.after.f},
                                    {"vertices", r.after.v},
                                    {"levels", r.level},
                                    {"error", r.error},
                                    {"longest_edge", r.longest_edge},
                                    {"least_angle", r.least_angle},
                                    {"turned_faces", r.turned},
                                    {"vertices_off_surface", r.off_shape},
                                    {"components", r.after.s},
                                    {"boundary_curves", r.after.b},
                                    {"genus", r.after.g},
                                    {"limit_reached", r.limited},
                                    {"frames", r.frames}};
  return json.dump(2);
}

}  // namespace clers::cli
