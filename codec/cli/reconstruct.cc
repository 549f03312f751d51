// The command reconstruct: points, the surface that grows over them, and what became of it.
#include "codec/cli/reconstruct.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>
#include <utility>

#include "codec/cli/report.h"
#include "codec/cli/triangle_shape.h"
#include "codec/cli/vertex_values.h"
#include "codec/surface.h"
#include "topology/modeling/reconstruct.h"

namespace clers::cli {
namespace {

using Place = std::array<double, 3>;

bool is_place(const Place& p) {
  return std::all_of(p.begin(), p.end(), [](double x) { return std::abs(x) < 1e100; });
}

double distance(const Place& a, const Place& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

bool is_of_vertices(const Attribute& a) {
  return a.domain == Domain::vertex && a.indices.empty();
}

/// The points that have a place, and which vertices these are.
struct Points {
  std::vector<std::uint32_t> vertex;
  std::vector<Place> places, normals;
  double diagonal = 0;

  Points(const Mesh& mesh, const Attribute* normal) {
    for (std::uint32_t v = 0; v < mesh.vertex_count; ++v) {
      const Place p = load_three(*mesh.position(), v);
      if (!is_place(p)) continue;
      vertex.push_back(v);
      places.push_back(p);
      if (normal == nullptr) continue;
      const Place n = load_three(*normal, v);
      normals.push_back(is_place(n) ? n : Place{});  // which does not say where it looks
    }
    if (places.empty()) return;
    Place low = places[0], high = low;
    for (const Place& p : places)
      for (unsigned i = 0; i < 3; ++i) {
        low[i] = std::min(low[i], p[i]);
        high[i] = std::max(high[i], p[i]);
      }
    diagonal = distance(low, high);
  }
};

/// Edges, and shapes of triangles.
void measure(const Surface& surface, const Points& points, ReconstructedMesh& result) {
  std::vector<double> edges, ratios;
  for (const Face f : surface.faces()) {
    std::array<double, 3> side;
    for (unsigned i = 0; i < 3; ++i) {
      const HalfEdge h = half_edge(f, i);
      const auto place = [&](Vertex v) { return points.places[v.index()]; };
      side[i] = distance(place(surface.org(h)), place(surface.dest(h)));
      if (surface.is_boundary(h)) ++result.open_edges;
      if (surface.is_boundary(h) || h < surface.sym(h)) edges.push_back(side[i]);
    }
    ratios.push_back(radius_ratio(side[0], side[1], side[2]));
  }
  const auto middle = edges.begin() + static_cast<std::ptrdiff_t>(edges.size() / 2);
  std::nth_element(edges.begin(), middle, edges.end());
  result.after = surface.characteristic();
  result.median_edge = *middle;
  for (const double r : ratios) result.mean_ratio += r / static_cast<double>(ratios.size());
  result.low_ratio = low_ratio(ratios);
}

void note_what_is_left(ReconstructedMesh& r) {
  const auto note = [&](std::size_t n, const char* one, const char* more) {
    if (n != 0) r.notes.push_back(counted(n, one, more));
  };
  note(r.no_place, "point is at no place that is a number, and left out",
       "points are at no place that is a number, and left out");
  note(r.duplicates, "point is at the place of another, and left out",
       "points are at places of others, and left out");
  note(r.unused, "point is not on the surface, and left out",
       "points are not on the surface, and left out");
  note(r.removed, "triangle was taken away where the surface met itself",
       "triangles were taken away where the surface met itself");
}

Failure<Error> nothing_made(std::size_t distinct, const ReconstructedMesh& r) {
  if (distinct < 3)
    return fail(ErrorCode::unsupported,
                fmt::format("has points at {}, expected three or more",
                            distinct == 0 ? "no place" : counted(distinct, "place", "places")));
  return fail(ErrorCode::unsupported,
              r.radii.empty() ? "all points are on a line: there is no surface through them"
                              : "no ball of a --radius rests on three points: they are on a line, "
                                "or the radius does not suit them");
}

/// The surface as a mesh, whose vertex i is point i.
Expected<Mesh> mesh_of(const Surface& surface, const Points& points, const Mesh& mesh) {
  std::vector<std::vector<std::byte>> data;
  std::vector<AttributeView> views;
  for (const Attribute& a : mesh.attributes) {
    if (!is_of_vertices(a)) continue;
    std::byte* to = data.emplace_back(surface.vertex_limit() * a.stride()).data();
    for (const Vertex v : surface.vertices())
      std::memcpy(to + v.index() * a.stride(),
                  a.data.data() + points.vertex[v.index()] * a.stride(), a.stride());
    views.push_back({a.name, a.domain, a.scalar, a.components, data.back(), 0, {}});
  }
  auto made = to_mesh(surface, views);
  if (!made) return Failure{made.error()};
  made->mesh.name = mesh.name;
  return std::move(made->mesh);
}

}  // namespace

Expected<ReconstructedMesh> reconstruct(const Mesh& mesh, const Reconstructing& how,
                                        const std::function<void(double)>& progress) {
  const Attribute* position = mesh.position();
  if (position == nullptr || position->components != 3)
    return fail(ErrorCode::unsupported, "has no positions to make a surface of");
  ReconstructedMesh result;
  const Attribute* normal = nullptr;
  for (const Attribute& a : mesh.attributes) {
    if (!is_of_vertices(a))
      result.notes.push_back(fmt::format("attribute \"{}\" is left out", a.name));
    else if (a.name == "normal" && a.components == 3)
      normal = &a;
  }
  if (const std::size_t faces = mesh.face_count(); faces != 0)
    result.notes.push_back(counted(faces, "face is left out: points alone count",
                                   "faces are left out: points alone count"));
  const Points points(mesh, normal);
  result.points = mesh.vertex_count;
  result.no_place = result.points - points.places.size();
  result.with_normals = normal != nullptr;
  for (const Extent& r : how.radii) result.radii.push_back(r.in_units(points.diagonal));

  ReconstructionOptions options;
  // Of points at one place nothing is left but an error of its own.
  if (points.diagonal > 0) options.radii = result.radii;
  options.normals = points.normals;
  options.progress = [&](double share) {
    progress(share);
    return true;
  };
  const auto made = clers::reconstruct(points.places, options);
  if (!made)
    return fail(made.error() == ReconstructionError::too_many_points ? ErrorCode::too_large
                                                                     : ErrorCode::bad_option,
                clers::describe(made.error()));
  result.duplicates = made->duplicates;
  result.unused = made->unused;
  result.removed = made->removed;
  if (made->surface.characteristic().f == 0)
    return nothing_made(points.places.size() - made->duplicates, result);
  measure(made->surface, points, result);
  note_what_is_left(result);
  auto out = mesh_of(made->surface, points, mesh);
  if (!out) return Failure{out.error()};
  result.mesh = std::move(*out);
  return result;
}

std::string describe(const ReconstructedMesh& r) {
  return fmt::format(
      "{}{} -> {} on {}; {}, {}, genus {}; {} not on the surface; radius ratio {:.2f}, of the "
      "worst 5 % "
      "below {:.2f}; edges of {:.3g} in the median",
      counted(r.points, "point", "points"), r.with_normals ? " with normals" : "",
      counted(static_cast<std::uint64_t>(r.after.f), "triangle", "triangles"),
      grouped(static_cast<std::uint64_t>(r.after.v)),
      counted(static_cast<std::uint64_t>(r.after.s), "component", "components"),
      r.after.b == 0 ? "closed"
                     : fmt::format("open along {} of {}",
                                   counted(static_cast<std::uint64_t>(r.after.b), "boundary curve",
                                           "boundary curves"),
                                   counted(r.open_edges, "edge", "edges")),
      r.after.g, grouped(r.unused), r.mean_ratio, r.low_ratio, r.median_edge);
}

std::string reconstructed_json(const std::string& name, const ReconstructedMesh& r) {
  const nlohmann::ordered_json json{{"file", name},
                                    {"points", r.points},
                                    {"points_without_place", r.no_place},
                                    {"duplicate_points", r.duplicates},
                                    {"unused_points", r.unused},
                                    {"normals", r.with_normals},
                                    {"radii", r.radii},
                                    {"triangles", r.after.f},
                                    {"vertices", r.after.v},
                                    {"removed_triangles", r.removed},
                                    {"components", r.after.s},
                                    {"boundary_curves", r.after.b},
                                    {"boundary_edges", r.open_edges},
                                    {"genus", r.after.g},
                                    {"radius_ratio", r.mean_ratio},
                                    {"radius_ratio_5_percent", r.low_ratio},
                                    {"median_edge", r.median_edge}};
  return json.dump(2);
}

}  // namespace clers::cli
