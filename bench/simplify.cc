// How near fewer triangles are to a surface, how good they are and how long that takes, beside
// CGAL, OpenMesh and meshoptimizer.
//
// usage: simplify [OPTION]... [MESH]...    without meshes: a sphere and an open wave, irregular
//   --faces LIST    as 50%,10%,80000, which is the default but for the last
//   --samples N     points on either side; 200000 is the default
//   --rounds N      runs of each, by turns, of which the median counts; 3 is the default
//   --result FILE   one more row: what somebody else made of the mesh
//   --histogram     radius ratios in tenths, as Fig. 17 of Topological mesh operators has them
//   --topology      instead: of each mesh, cut if it is no manifold, whether 50 %, 10 %, 1 % and
//   the
//                   fewest faces leave components, curves and genus; it fails if they do not
//
// Errors are the larger of both sides, over the diagonal. Times are processor time from arrays to
// arrays. p5: the radius ratio that 5 % of the triangles do not reach. All is measured by code that
// the project does not simplify by (triangles.h).
#include "topology/modeling/simplify.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <exception>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "bench/input.h"
#include "bench/simplifiers.h"
#include "bench/timing.h"
#include "bench/triangles.h"
#include "codec/surface.h"
#include "corpus/generate.h"
#include "topology/validate.h"

namespace clers::bench {
namespace {

struct Options {
  std::vector<std::string> faces{"50%", "10%"};
  std::size_t samples = 200'000;
  std::size_t rounds = 3;
  std::optional<std::string> result;
  bool histogram = false, topology = false;
  std::vector<std::string> files;
};

std::size_t number(std::string_view text) {
  std::size_t n = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), n);
  if (error != std::errc() || end != text.data() + text.size() || n == 0)
    throw std::runtime_error("no number above 0: " + std::string(text));
  return n;
}

Options options_of(int argc, char** argv) {
  Options options;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    const auto value = [&]() -> std::string {
      if (++i == argc) throw std::runtime_error(word + " needs a value");
      return argv[i];
    };
    if (word == "--faces") {
      options.faces.clear();
      std::string list = value() + ",";
      for (std::size_t at = 0, comma; (comma = list.find(',', at)) != list.npos; at = comma + 1)
        options.faces.push_back(list.substr(at, comma - at));
    } else if (word == "--samples") {
      options.samples = number(value());
    } else if (word == "--rounds") {
      options.rounds = number(value());
    } else if (word == "--result") {
      options.result = value();
    } else if (word == "--histogram") {
      options.histogram = true;
    } else if (word == "--topology") {
      options.topology = true;
    } else if (word.starts_with("-")) {
      throw std::runtime_error("unknown option " + word);
    } else {
      options.files.push_back(word);
    }
  }
  return options;
}

/// "50%" or "80000" of so many.
std::size_t faces_of(std::string_view text, std::size_t all) {
  if (!text.ends_with('%')) return number(text);
  return all * number(text.substr(0, text.size() - 1)) / 100;
}

struct Row {
  std::string name;
  Triangles mesh;
  std::vector<double> seconds;
};

void print_histogram(const char* name, const std::vector<double>& ratios) {
  std::vector<double> tenths(10);
  for (const double r : ratios)
    tenths[std::min<std::size_t>(9, static_cast<std::size_t>(r * 10))] +=
        100 / static_cast<double>(ratios.size());
  std::printf("    %-26s", name);
  for (const double share : tenths) std::printf(" %5.1f", share);
  std::printf("\n");
}

void compare(const Input& input, std::size_t faces, const Options& options) {
  std::vector<Simplifier> all = our_simplifiers();
  for (const Simplifier& peer : {cgal_simplifier(), openmesh_simplifier(), meshopt_simplifier()})
    all.push_back(peer);
  std::vector<Row> rows(all.size());
  for (std::size_t round = 0; round < options.rounds; ++round)
    for (std::size_t i = 0; i < all.size(); ++i) {
      const double start = thread_seconds();
      rows[i].mesh = all[i].run(input, faces);
      rows[i].seconds.push_back(thread_seconds() - start);
      rows[i].name = all[i].name;
    }
  if (options.result) rows.push_back({"(result)", triangles_of(read_input(*options.result)), {}});

  const Triangles whole = triangles_of(input);
  const Joined before = joined(whole);
  const double size = diagonal(whole);
  const Target target(whole);
  const double ours = summary(rows[0].seconds).median;
  std::printf("  to %zu faces%16s %9s %9s %6s %8s %7s  %s\n", faces, "faces", "rms", "greatest",
              "p5", "seconds", "ratio", "topology");
  for (const Row& row : rows) {
    const Target simplified(row.mesh);
    const auto there = target.from(row.mesh, options.samples),
               back = simplified.from(whole, options.samples);
    const std::vector<double> ratios = radius_ratios(row.mesh);
    const double seconds = row.seconds.empty() ? 0 : summary(row.seconds).median;
    const Joined after = joined(row.mesh);
    std::printf("    %-26s%9zu %9.2e %9.2e %6.3f %8.3f %7.2f  %s\n", row.name.c_str(),
                row.mesh.count(), std::max(there.rms, back.rms) / size,
                std::max(there.greatest, back.greatest) / size,
                ratios.empty() ? 0 : ratios[ratios.size() / 20], seconds, seconds / ours,
                after == before   ? "kept"
                : !after.manifold ? "not manifold"
                                  : "changed");
  }
  if (!options.histogram) return;
  std::printf("    %-26s", "radius ratios, % of faces");
  for (int i = 1; i <= 10; ++i) std::printf("  <%3.1f", 0.1 * i);
  std::printf("\n");
  print_histogram("before", radius_ratios(whole));
  for (const Row& row : rows) print_histogram(row.name.c_str(), radius_ratios(row.mesh));
}

/// Nothing but the arrays of a surface is asked what it is.
Joined joined(const Surface& surface) {
  Triangles mesh;
  mesh.points.resize(surface.vertex_limit());
  std::vector<std::uint32_t> number(surface.half_edge_limit(), no_twin), twins;
  for (const Face f : surface.faces())
    for (const HalfEdge h : surface.star(f)) {
      number[h.index()] = static_cast<std::uint32_t>(mesh.corners.size());
      mesh.corners.push_back(surface.org(h).index());
    }
  for (const Face f : surface.faces())
    for (const HalfEdge h : surface.star(f)) {
      const HalfEdge twin = surface.sym(h);
      twins.push_back(twin ? number[twin.index()] : no_twin);
    }
  return joined(mesh, twins);
}

bool topology_stays(const Input& input) {
  const auto cut = to_surface_by_cuts(input.mesh);
  if (!cut) throw std::runtime_error(describe(cut.error()));
  std::vector<Position3> at = triangles_of(input).points;
  for (const std::uint32_t v : cut->copied) at.push_back(at[v]);
  const std::int64_t all = cut->surface.characteristic().f;
  const Joined before = joined(cut->surface);
  std::printf("  cut: %lld components, %lld curves, genus %lld; faces: %lld",
              static_cast<long long>(before.components), static_cast<long long>(before.curves),
              static_cast<long long>(before.genus), static_cast<long long>(all));
  bool right = true;
  for (const std::int64_t percent : {50, 10, 1, 0}) {
    Surface surface = cut->surface;
    std::vector<Position3> places = at;
    SimplifyOptions options;
    options.faces = all * percent / 100;
    if (!simplify(surface, places, options)) {
      std::printf(", refused: positions");
      break;
    }
    const bool stays = validate(surface).empty() && joined(surface) == before;
    right = right && stays;
    std::printf(" %lld%s", static_cast<long long>(surface.characteristic().f),
                stays ? "" : " CHANGED");
  }
  std::printf("\n");
  return right;
}

/// A sphere, and a wave with a boundary, whose edges were flipped at random.
std::vector<Input> generated() {
  std::vector<Input> inputs;
  for (const bool closed : {true, false}) {
    const Mesh mesh =
        corpus::flip_edges(closed ? corpus::icosphere(4) : corpus::grid(50, 50), 500, 1);
    const Attribute& a = *mesh.position();
    std::vector<float> at(3 * std::size_t{mesh.vertex_count});
    for (std::size_t i = 0; i < at.size(); ++i)
      std::memcpy(&at[i], a.data.data() + 4 * i, sizeof(float));
    if (!closed)
      for (std::size_t v = 0; v < mesh.vertex_count; ++v)
        at[3 * v + 2] = 3 * std::sin(at[3 * v] / 6) * std::cos(at[3 * v + 1] / 6);
    inputs.push_back(
        make_input(closed ? "sphere" : "wave", mesh.vertex_count, mesh.corners, std::move(at)));
    inputs.back().manifold = true;
  }
  return inputs;
}

int run(int argc, char** argv) {
  const Options options = options_of(argc, argv);
  bool right = true;
  const auto measure = [&](const Input& input) {
    std::printf("%s: %zu triangles%s\n", input.name.c_str(), input.triangle_count(),
                input.manifold ? "" : ", no manifold");
    if (options.topology)
      right = topology_stays(input) && right;
    else if (input.manifold)
      for (const std::string& faces : options.faces)
        compare(input, faces_of(faces, input.triangle_count()), options);
    std::fflush(stdout);
  };
  if (options.files.empty())
    for (const Input& input : generated()) measure(input);
  for (const auto& file : list_files(options.files)) measure(read_input(file));
  return right ? 0 : 1;
}

}  // namespace
}  // namespace clers::bench

int main(int argc, char** argv) {
  try {
    return clers::bench::run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "simplify: %s\n", error.what());
    return 2;
  }
}
