// The command subdivide: topology/modeling on the vertices of a mesh.
#include "codec/cli/subdivide.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "codec/cli/vertex_values.h"
#include "codec/surface.h"
#include "topology/modeling/four_eight.h"
#include "topology/modeling/loop.h"
#include "topology/modeling/sqrt3.h"

namespace clers::cli {
namespace {

/// The values of a vertex: all components of its attributes, one after the other.
template <std::size_t n>
struct Values : std::array<double, n> {
  Values() : std::array<double, n>{} {}
  Values& operator+=(const Values& o) {
    for (std::size_t i = 0; i < n; ++i) (*this)[i] += o[i];
    return *this;
  }
  friend Values operator*(double k, Values v) {
    for (double& x : v) x *= k;
    return v;
  }
};

/// Averages, and counts what is set, to report how far the work is.
template <class V>
class Counted : public Averaging<V> {
 public:
  Counted(std::vector<V> values, double total, const std::function<void(double)>& progress)
      : Averaging<V>(std::move(values)), total_(total), progress_(progress) {}
  void set(Vertex v, V value) {
    Averaging<V>::set(v, std::move(value));
    if (++count_ % 65536 == 0 && progress_)
      progress_(std::min(1.0, static_cast<double>(count_) / total_));
  }

 private:
  std::uint64_t count_ = 0;
  double total_;
  const std::function<void(double)>& progress_;
};

double faces_after(const Subdivision& how, double faces) {
  const double factor = how.scheme == Scheme::loop ? 4 : how.scheme == Scheme::sqrt3 ? 3 : 2;
  if (how.scheme == Scheme::four_eight) faces *= 3;  // at most, as a tri-quad mesh
  return faces * std::pow(factor, how.times);
}

template <class Geometry>
Result<Done, Violation> run(Surface& surface, Geometry& geometry, const Subdivision& how) {
  Creases none;
  if (how.scheme == Scheme::four_eight) {
    const auto length = [&](const Surface& s, HalfEdge h) {
      const auto &a = geometry[s.org(h)], &b = geometry[s.dest(h)];
      return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
    };
    if (const auto ok = make_tri_quad(surface, geometry, none, length); !ok) return ok;
  }
  for (unsigned i = 0; i < how.times; ++i) {
    const auto ok = how.scheme == Scheme::loop ? subdivide_loop(surface, geometry, none)
                    : how.scheme == Scheme::four_eight
                        ? subdivide_4_8(surface, geometry, none)
                        : subdivide_sqrt3(surface, geometry, none,
                                          i % 2 == 0 ? Sqrt3Step::first : Sqrt3Step::second);
    if (!ok) return ok;
  }
  return Done{};
}

template <std::size_t n>
Expected<Done> run(Surface& surface, const std::vector<const Attribute*>& carried,
                   const Subdivision& how, const std::function<void(double)>& progress, Mesh& out) {
  std::vector<Values<n>> values(surface.vertex_limit());
  for (std::size_t v = 0; v < values.size(); ++v) {
    std::size_t i = 0;
    for (const Attribute* a : carried)
      for (std::size_t k = 0; k < a->components; ++k)
        values[v][i++] = load(a->scalar, a->data.data() + v * a->stride() + k * size_of(a->scalar));
  }
  const double faces = static_cast<double>(surface.characteristic().f);
  Counted<Values<n>> geometry(std::move(values), faces_after(how, faces) * 0.67, progress);
  if (const auto ok = run(surface, geometry, how); !ok)
    return fail(ErrorCode::too_large, clers::describe(ok.error()));

  std::vector<std::vector<std::byte>> data;
  std::vector<AttributeView> views;
  std::size_t first = 0;
  for (const Attribute* a : carried) {
    std::byte* at = data.emplace_back(surface.vertex_limit() * a->stride()).data();
    for (const Vertex v : surface.vertices())
      for (std::size_t k = 0; k < a->components; ++k)
        store(a->scalar, geometry[v][first + k],
              at + v.index() * a->stride() + k * size_of(a->scalar));
    first += a->components;
    views.push_back({a->name, a->domain, a->scalar, a->components, data.back(), 0});
  }
  auto made = to_mesh(surface, views);
  if (!made) return Failure{made.error()};
  made->mesh.name = std::move(out.name);
  out = std::move(made->mesh);
  return Done{};
}

}  // namespace

const char* name(Scheme scheme) {
  constexpr const char* names[] = {"sqrt3", "loop", "4-8"};
  return names[static_cast<unsigned>(scheme)];
}

Expected<Subdivided> subdivide(const Mesh& mesh, const Subdivision& how,
                               const std::function<void(double)>& progress) {
  const Attribute* position = mesh.position();
  if (position == nullptr || position->components != 3)
    return fail(ErrorCode::unsupported, "has no positions to subdivide by");
  auto surface = to_surface(mesh);
  if (!surface) return Failure{surface.error()};
  const double faces = faces_after(how, static_cast<double>(surface->characteristic().f));
  if (faces > max_faces)
    return fail(ErrorCode::too_large,
                fmt::format("would become {:.3g} faces, expected at most {}", faces, max_faces));
  Subdivided result;
  result.before = surface->characteristic();
  result.mesh.name = mesh.name;
  const std::uint64_t isolated = mesh.vertex_count - static_cast<std::uint64_t>(result.before.v);
  if (isolated != 0)
    result.notes.push_back(fmt::format("{} isolated {} left out", isolated,
                                       isolated == 1 ? "vertex is" : "vertices are"));
  // Positions first: edges have lengths.
  constexpr std::size_t most = 32;
  std::vector<const Attribute*> carried{position};
  std::size_t components = 3;
  for (const Attribute& a : mesh.attributes) {
    if (&a == position) continue;
    if (a.domain == Domain::vertex && components + a.components <= most) {
      carried.push_back(&a);
      components += a.components;
    } else {
      result.notes.push_back(fmt::format("attribute \"{}\" is left out", a.name));
    }
  }
  const auto ok = components == 3   ? run<3>(*surface, carried, how, progress, result.mesh)
                  : components <= 8 ? run<8>(*surface, carried, how, progress, result.mesh)
                                    : run<most>(*surface, carried, how, progress, result.mesh);
  if (!ok) return Failure{ok.error()};
  result.after = surface->characteristic();
  return result;
}

std::string describe(const Subdivision& how, const Subdivided& result) {
  const auto &a = result.before, &b = result.after;
  const auto many = [](std::int64_t n, const char* one, const char* more) {
    return fmt::format("{} {}", n, n == 1 ? one : more);
  };
  return fmt::format("{}, {}: {} -> {} triangles, {} -> {} vertices; {}, {}, genus {}",
                     name(how.scheme), many(how.times, "time", "times"), a.f, b.f, a.v, b.v,
                     many(b.s, "component", "components"),
                     many(b.b, "boundary curve", "boundary curves"), b.g);
}

}  // namespace clers::cli
