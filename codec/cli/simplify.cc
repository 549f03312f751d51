// The command simplify: triangles, a surface by cuts, contractions, and a mesh again.
#include "codec/cli/simplify.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "codec/cli/carried.h"
#include "codec/cli/places.h"
#include "codec/cli/report.h"
#include "codec/cli/triangle_shape.h"
#include "codec/cli/triangulated.h"
#include "codec/surface.h"

namespace clers::cli {
namespace {

/// That which 5 % of the faces do not reach.
double worst_ratio(const Surface& surface, const std::vector<Position3>& at) {
  std::vector<double> ratios;
  for (const Face f : surface.faces()) {
    std::array<double, 3> side;
    for (unsigned i = 0; i < 3; ++i) {
      const Position3 &p = at[surface.org(half_edge(f, i)).index()],
                      &q = at[surface.dest(half_edge(f, i)).index()];
      side[i] = length(Vec3{q[0] - p[0], q[1] - p[1], q[2] - p[2]});
    }
    ratios.push_back(radius_ratio(side[0], side[1], side[2]));
  }
  return low_ratio(ratios);
}

/// How many pairs of vertices have more than one edge: where more than two faces meet and the
/// surface passes several times.
std::size_t several_edges(const Surface& surface) {
  std::vector<std::pair<Vertex, Vertex>> ends;
  for (const HalfEdge h : surface.edges())
    ends.push_back(std::minmax(surface.org(h), surface.dest(h)));
  std::sort(ends.begin(), ends.end());
  std::size_t count = 0;
  for (std::size_t i = 1; i < ends.size(); ++i)
    if (ends[i] == ends[i - 1] && (i == 1 || ends[i - 2] != ends[i])) ++count;
  return count;
}

/// What made a surface of the mesh.
void note_cuts(const SurfaceByCuts& cut, SimplifiedMesh& result) {
  result.copied = cut.copied.size();
  result.reversed = cut.reversed.size();
  result.left_out = cut.degenerate.size() + cut.repeated.size();
  if (!cut.degenerate.empty())
    result.notes.push_back(counted(cut.degenerate.size(),
                                   "face without area, on a vertex twice, is",
                                   "faces without area, on a vertex twice, are") +
                           " left out");
  if (!cut.repeated.empty())
    result.notes.push_back(counted(cut.repeated.size(), "face that repeats another one is",
                                   "faces that repeat others are") +
                           " left out");
  if (!cut.reversed.empty())
    result.notes.push_back(counted(cut.reversed.size(), "face is", "faces are") +
                           " turned around, to look where the faces beside look");
  if (!cut.copied.empty())
    result.notes.push_back("it is cut where it is no manifold: " +
                           counted(cut.copied.size(), "vertex is", "vertices are") + " doubled");
  if (const std::size_t several = several_edges(cut.surface); several != 0)
    result.notes.push_back(
        counted(several, "edge of more than two faces is", "edges of more than two faces are") +
        " taken for several edges between the same vertices, two faces at each");
}

}  // namespace

Expected<SimplifiedMesh> simplify(const Mesh& given, const Fewer& how,
                                  const std::function<void(double)>& progress) {
  auto places = places_of(given, "simplify");
  if (!places) return Failure{places.error()};
  SimplifiedMesh result;
  Mesh of_triangles;
  if (!given.triangles_only()) {
    for (const std::uint32_t size : given.face_sizes) result.polygons += size > 3 ? 1 : 0;
    const auto none = std::count_if(given.face_sizes.begin(), given.face_sizes.end(),
                                    [](std::uint32_t size) { return size < 3; });
    if (none != 0)
      result.notes.push_back(counted(static_cast<std::uint64_t>(none),
                                     "face of fewer than three corners is",
                                     "faces of fewer than three corners are") +
                             " left out");
    if (result.polygons != 0)
      result.notes.push_back(counted(result.polygons, "polygon is", "polygons are") +
                             " cut into triangles");
    of_triangles = triangulated(given, *places);
  }
  const Mesh& mesh = given.triangles_only() ? given : of_triangles;
  auto cut = to_surface_by_cuts(mesh);
  if (!cut) return Failure{cut.error()};
  note_cuts(*cut, result);
  Surface& surface = cut->surface;
  result.before = surface.characteristic();
  if (const std::int64_t isolated =
          static_cast<std::int64_t>(mesh.vertex_count + cut->copied.size()) - result.before.v;
      isolated != 0)
    result.notes.push_back(counted(static_cast<std::uint64_t>(isolated), "isolated vertex is",
                                   "isolated vertices are") +
                           " left out");

  for (const std::uint32_t v : cut->copied) places->push_back((*places)[v]);
  result.diagonal = diagonal_of(surface, *places);
  std::vector<Position3> at;
  at.reserve(places->size());
  for (const Vec3& p : *places) at.push_back({p.x, p.y, p.z});
  result.ratio_before = worst_ratio(surface, at);

  SimplifyOptions options;
  const FaceCount faces =
      how.faces.value_or(how.error ? FaceCount{} : FaceCount{0, 0.5});  // see the help
  options.faces = faces.share ? static_cast<std::int64_t>(std::llround(
                                    *faces.share * static_cast<double>(result.before.f)))
                              : faces.count;
  // Less is what places are rounded by.
  if (how.error)
    options.error = std::max(how.error->in_units(result.diagonal), 1e-9 * result.diagonal);
  result.asked = options.faces;

  Creases creases;
  Carried carried(mesh, *cut, creases, result.notes);
  Simplification simplification(surface, at, creases, options);
  const double to_go =
      static_cast<double>(std::max<std::int64_t>(1, result.before.f - options.faces));
  for (std::uint32_t i = 1; const auto next = simplification.next(); ++i) {
    carried.before(*next, at);
    contract(surface, creases, *next);
    simplification.contracted(*next);
    carried.after(*next);
    if (i % 4096 == 0)
      progress(static_cast<double>(result.before.f - surface.characteristic().f) / to_go);
  }
  result.ended = simplification.result().ended;
  result.error = simplification.result().error;
  result.after = surface.characteristic();
  result.ratio_after = worst_ratio(surface, at);

  auto made = to_mesh(surface);
  if (!made) return Failure{made.error()};
  made->mesh.attributes = carried.attributes(*made, at);
  made->mesh.name = given.name;
  made->mesh.metadata = given.metadata;
  result.mesh = std::move(made->mesh);
  return result;
}

std::string unreached(const SimplifiedMesh& r) {
  if (r.asked == 0 || r.ended == SimplifyEnd::faces) return "";
  const std::string left = counted(static_cast<std::uint64_t>(r.after.f), "face is", "faces are");
  return left + (r.ended == SimplifyEnd::smallest
                     ? " the fewest that keep components, curves, handles, seams and sides"
                     : " the fewest within the error");
}

std::string describe(const SimplifiedMesh& r) {
  const auto count = [](std::int64_t n) { return grouped(static_cast<std::uint64_t>(n)); };
  const auto kept = [](std::int64_t n, const char* one, const char* more) {
    return counted(static_cast<std::uint64_t>(n), one, more);
  };
  return fmt::format(
      "{} -> {} triangles, {} -> {} vertices; error {:.3g} ({:.2g} % of the diagonal), "
      "5 % of the radius ratios below {:.2f} ({:.2f} before); {}, {}, genus {}",
      count(r.before.f), count(r.after.f), count(r.before.v), count(r.after.v), r.error,
      r.diagonal > 0 ? 100 * r.error / r.diagonal : 0., r.ratio_after, r.ratio_before,
      kept(r.after.s, "component", "components"),
      kept(r.after.b, "boundary curve", "boundary curves"), r.after.g);
}

std::string simplified_json(const std::string& name, const SimplifiedMesh& r) {
  const char* ends[] = {"faces", "error", "smallest"};
  const nlohmann::ordered_json json{
      {"file", name},
      {"triangles_before", r.before.f},
      {"vertices_before", r.before.v},
      {"triangles", r.after.f},
      {"vertices", r.after.v},
      {"triangles_asked", r.asked},
      {"ended", ends[static_cast<unsigned>(r.ended)]},
      {"error", r.error},
      {"error_of_diagonal", r.diagonal > 0 ? r.error / r.diagonal : 0.},
      {"worst_radius_ratio_before", r.ratio_before},
      {"worst_radius_ratio", r.ratio_after},
      {"components", r.after.s},
      {"boundary_curves", r.after.b},
      {"genus", r.after.g},
      {"polygons_cut", r.polygons},
      {"vertices_doubled", r.copied},
      {"faces_turned", r.reversed},
      {"faces_left_out", r.left_out}};
  return json.dump(2);
}

}  // namespace clers::cli
