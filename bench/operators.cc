// What an operator costs as the surface around it grows.
//
// The counter `ns` is processor time per operator (or per face, where the name says so), f and g
// are the surface's faces and genus; the other columns are for whole rounds. Every benchmark puts
// the surface back, outside the time measured, so each round works on the same one.
#include <benchmark/benchmark.h>
#include <time.h>

#include <cstdio>
#include <cstdlib>
#include <utility>
#include <vector>

#include "topology/derived.h"
#include "topology/equivalence.h"
#include "topology/handlebody.h"
#include "topology/stellar.h"
#include "topology/surface.h"
#include "topology/test/meshes.h"
#include "topology/validate.h"

namespace clers {
namespace {

using benchmark::State;
using Edges = std::vector<HalfEdge>;

/// Seconds of processor time this thread has had: what others do on the machine does not count.
double now() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

/// Adds up the time of rounds of some operators each, for the counter `ns`.
class Meter {
 public:
  Meter(State& state, const Characteristic& counts, double operators)
      : state_(state), operators_(operators) {
    state.counters["f"] = static_cast<double>(counts.f);
    state.counters["g"] = static_cast<double>(counts.g);
  }
  ~Meter() {
    state_.counters["ns"] = 1e9 * total_ / (operators_ * static_cast<double>(state_.iterations()));
  }
  void add(double seconds) {
    state_.SetIterationTime(seconds);
    total_ += seconds;
  }

 private:
  State& state_;
  double operators_;
  double total_ = 0;
};

constexpr std::uint32_t places = 64;  // operators timed together

/// A square grid or torus of about this many faces.
std::uint32_t side(std::int64_t faces) {
  std::uint32_t n = 1;
  while (2 * std::int64_t{n + 1} * (n + 1) <= faces) ++n;
  return n;
}

void must(bool ok, const char* what) {
  if (ok) return;
  std::fprintf(stderr, "bench: %s\n", what);
  std::abort();
}

/// Cuts every edge and glues it again, last first; the time is that of one direction.
enum class Timed { unglue, glue };
void cut_and_paste(State& state, Surface& s, const Edges& edges, HandleCase expected, Timed timed) {
  std::vector<std::pair<HalfEdge, HalfEdge>> cut(edges.size());
  // The first round, not timed, lets the arrays grow to what is needed.
  for (const HalfEdge h : edges) {
    cut.push_back({h, s.sym(h)});
    must(bool(s.unglue(h)), "cut");
  }
  for (; cut.size() > edges.size(); cut.pop_back())
    must(bool(s.glue(cut.back().first, cut.back().second)), "paste");
  Meter meter(state, s.characteristic(), static_cast<double>(edges.size()));
  for (auto _ : state) {
    const double start = now();
    for (std::size_t i = 0; i < edges.size(); ++i) {
      cut[i] = {edges[i], s.sym(edges[i])};
      must(*s.unglue(edges[i]) == expected, name(expected));
    }
    const double middle = now();
    for (std::size_t i = cut.size(); i-- > 0;)
      must(*s.glue(cut[i].first, cut[i].second) == expected, name(expected));
    const double end = now();
    const double time = timed == Timed::unglue ? middle - start : end - middle;
    meter.add(time);
  }
}

/// Interior edges far from each other and from the boundary, half-edge 0 of faces spread evenly.
Edges spread(const Surface& s) {
  Edges edges;
  std::vector<bool> near(s.vertex_limit());
  const std::uint32_t step = std::max(1u, s.face_limit() / (2 * places));
  for (std::uint32_t f = step / 2; f < s.face_limit() && edges.size() < places; f += step) {
    const HalfEdge h = half_edge(Face(f), 0);
    bool free = !s.is_boundary(h);
    for (const Vertex v : {s.org(h), s.dest(h)}) {
      free = free && !near[v.index()] && !s.is_boundary(v);
      for (const HalfEdge x : s.link(v))
        free = free && !near[s.org(x).index()] && !s.is_boundary(s.org(x));
    }
    if (!free) continue;
    edges.push_back(h);
    for (const Vertex v : {s.org(h), s.dest(h)}) {
      near[v.index()] = true;
      for (const HalfEdge x : s.link(v)) near[s.org(x).index()] = true;
    }
  }
  must(edges.size() >= 8, "too few places");
  return edges;
}

template <Timed timed>
void close(State& state) {
  Surface s = test::torus(side(state.range(0)), side(state.range(0)));
  cut_and_paste(state, s, spread(s), HandleCase::close, timed);
}

template <Timed timed>
void zip(State& state) {
  Surface s = test::torus(side(state.range(0)), side(state.range(0)));
  Edges next;
  for (const HalfEdge h : spread(s)) {
    must(bool(s.unglue(h)), "open");
    next.push_back(lnext(h));
  }
  cut_and_paste(state, s, next, HandleCase::zip, timed);
}

/// Edges between the long rim of a grid and slits beside it: every cut lengthens the rim.
template <Timed timed>
void split_curve(State& state) {
  const std::uint32_t n = side(state.range(0));
  Surface s = test::grid(n, n);
  Edges bridges;
  // Square (x, 0): its right side runs from the rim vertex (x+1, 0) up to (x+1, 1).
  const std::uint32_t step = std::max(4u, n / places);
  for (std::uint32_t x = 1; x + 3 < n && bridges.size() < places; x += step) {
    const HalfEdge bridge = half_edge(Face(2 * x), 1);
    const HalfEdge slit = half_edge(Face(2 * (n + x + 1)), 1);  // up from (x+2, 1)
    must(s.dest(bridge) != s.org(slit), "slit");
    // The vertex above the bridge, and the one above that.
    HalfEdge up;
    for (const HalfEdge h : s.star(s.dest(bridge)))
      if (s.org(h) == s.dest(bridge) && !s.is_boundary(s.dest(h)) &&
          s.dest(h).index() == (x + 1) + 2 * (n + 1))
        up = h;
    must(bool(up), "up");
    must(*s.unglue(up) == HandleCase::close, "slit");
    bridges.push_back(bridge);
  }
  cut_and_paste(state, s, bridges, HandleCase::split_curve, timed);
}

/// Ears on the rim, each a triangle alone: what detach does all the time. On genus 0, or on a torus
/// with a hole, where every cut must be searched.
template <Timed timed, bool handle>
void ear(State& state) {
  const std::uint32_t n = side(state.range(0));
  Surface s = handle ? test::torus(n, n) : test::grid(n, n);
  if (handle) must(detach(s, Face(0)).ok(), "hole");
  Edges ears;
  HalfEdge h = s.on_curve(*s.curves().begin());
  for (std::uint32_t i = 0; i < places; ++i) {
    // On the newest ear once the rim is used up.
    const HalfEdge next = s.boundary_next(h);
    const Face f = *attach(s, h, Point(0));
    ears.push_back(half_edge(f, 0));
    h = s.is_boundary(next) ? next : half_edge(f, 1);
  }
  std::reverse(ears.begin(), ears.end());
  cut_and_paste(state, s, ears, HandleCase::join_components, timed);
}

/// Two halves of a grid: the last edge of a cut straight through.
template <Timed timed>
void halves(State& state) {
  const std::uint32_t n = side(state.range(0));
  Surface s = test::grid(n, n);
  HalfEdge last;
  for (std::uint32_t y = 0; y < n; ++y) {
    last = half_edge(Face(2 * (y * n + n / 2)), 1);
    if (y + 1 < n) must(bool(s.unglue(last)), "cut");
  }
  cut_and_paste(state, s, {last}, HandleCase::join_components, timed);
}

/// The last edge of a cut round a torus, the shorter way: the searches must meet behind it.
template <Timed timed>
void handle_of_torus(State& state) {
  const std::uint32_t n = side(state.range(0));
  Surface s = test::torus(n, n);
  HalfEdge last;
  for (std::uint32_t y = 0; y < n; ++y) {
    last = half_edge(Face(2 * (y * n + n / 2)), 1);
    if (y + 1 < n) must(bool(s.unglue(last)), "cut");
  }
  cut_and_paste(state, s, {last}, HandleCase::join_curves, timed);
}

/// One handle after the other of a surface of many: tori of 128 faces in a row.
template <Timed timed>
void handles_of_chain(State& state) {
  constexpr std::uint32_t n = 8;
  const auto tori =
      static_cast<std::uint32_t>(std::max<std::int64_t>(2, state.range(0) / (2 * n * n)));
  Surface s = test::chain_of_tori(tori, n);
  // The lower sides of row 5 of a torus are a closed cut that keeps clear of both seams.
  Edges last;
  const std::uint32_t step = std::max(1u, tori / places);
  for (std::uint32_t t = 0; t < tori && last.size() < places; t += step)
    for (std::uint32_t x = 0; x < n; ++x) {
      const HalfEdge h = half_edge(Face(t * 2 * n * n + 2 * (6 * n + x)), 0);
      if (x + 1 < n)
        must(bool(s.unglue(h)), "cut");
      else
        last.push_back(h);
    }
  cut_and_paste(state, s, last, HandleCase::join_curves, timed);
}

/// The edges are turned four times, which leaves all as it was. `follow` observes it or is
/// NoObserver.
template <class Follow>
void flip(State& state) {
  Surface s = test::torus(side(state.range(0)), side(state.range(0)));
  const Edges edges = spread(s);
  Meter meter(state, s.characteristic(), 4 * static_cast<double>(edges.size()));
  for (auto _ : state) {
    const double start = now();
    for (int turn = 0; turn < 4; ++turn)
      for (const HalfEdge h : edges) must(clers::flip(s, h, Follow{}).ok(), "flip");
    meter.add(now() - start);
  }
}
/// The faces are numbered anew three times, which leaves all as it was.
void turn(State& state) {
  Surface s = test::torus(side(state.range(0)), side(state.range(0)));
  const Edges edges = spread(s);
  Meter meter(state, s.characteristic(), 3 * static_cast<double>(edges.size()));
  for (auto _ : state) {
    const double start = now();
    for (int i = 0; i < 3; ++i)
      for (const HalfEdge h : edges) must(s.turn(left(h)).ok(), "turn");
    meter.add(now() - start);
  }
}
struct Listens {
  void operator()(const Change& change) const { benchmark::DoNotOptimize(change.slots().size()); }
};

/// Splits at many places, then welds, last first; the time is that of one direction.
enum class Half { split, weld };
template <StellarCase kind, Half timed>
void split_and_weld(State& state) {
  const std::uint32_t n = side(state.range(0));
  Surface s = kind == StellarCase::boundary_edge ? test::grid(n, n) : test::torus(n, n);
  Edges edges;
  if (kind == StellarCase::boundary_edge) {
    // Every other edge of the rim; each face has one.
    for (const HalfEdge h : s.boundary(*s.curves().begin()))
      if (edges.size() < places && s.corner_count(s.org(h)) > 1) edges.push_back(h);
  } else {
    edges = spread(s);
  }
  // Half-edge 1 of its faces, so that all is as it was in the end.
  std::vector<Vertex> made(edges.size());
  const auto split = [&](HalfEdge h) {
    return kind == StellarCase::face ? *s.split(left(h), Point(0)) : *s.split(h, Point(0));
  };
  for (HalfEdge& h : edges) h = s.weld(split(h))->at;
  Meter meter(state, s.characteristic(), static_cast<double>(edges.size()));
  for (auto _ : state) {
    const double start = now();
    for (std::size_t i = 0; i < edges.size(); ++i) made[i] = split(edges[i]);
    const double middle = now();
    for (std::size_t i = made.size(); i-- > 0;) must(s.weld(made[i])->undone == kind, name(kind));
    const double end = now();
    meter.add(timed == Half::split ? middle - start : end - middle);
  }
}

/// A vertex is split and its new edge collapsed: six flips, a split and a weld, and the condition.
void split_vertex_collapse(State& state) {
  const std::uint32_t n = side(state.range(0));
  Surface s = test::torus(n, n);
  std::vector<Vertex> vertices;
  for (const HalfEdge h : spread(s)) vertices.push_back(s.org(h));
  Meter meter(state, s.characteristic(), 2 * static_cast<double>(vertices.size()));
  for (auto _ : state) {
    const double start = now();
    for (const Vertex v : vertices) {
      const HalfEdge from = s.star_half_edge(v);
      HalfEdge to = from;
      for (int i = 0; i < 3; ++i) to = s.sym(lprev(to));
      const auto edge = split_vertex(s, from, to, Point(0));
      must(edge && collapse(s, *edge).ok(), "collapse");
    }
    meter.add(now() - start);
  }
}

void create_destroy(State& state) {
  Surface s = test::torus(side(state.range(0)), side(state.range(0)));
  must(s.destroy(*s.create(Point(0), Point(1), Point(2))).ok(), "destroy");
  Meter meter(state, s.characteristic(), 2 * places);
  for (auto _ : state) {
    const double start = now();
    for (std::uint32_t i = 0; i < places; ++i)
      must(s.destroy(*s.create(Point(0), Point(1), Point(2))).ok(), "destroy");
    meter.add(now() - start);
  }
}

/// A disk grown by attach alone, as decoding grows it.
void attach_only(State& state) {
  Meter meter(state, {.f = state.range(0)}, static_cast<double>(state.range(0)));
  for (auto _ : state) {
    const double start = now();
    Surface s;
    HalfEdge h = half_edge(*s.create(Point(0), Point(1), Point(2)), 0);
    for (std::int64_t i = 1; i < state.range(0); ++i)
      h = half_edge(*attach(s, h, Point(0)), i % 2 == 0 ? 1 : 2);
    const double time = now() - start;
    meter.add(time);
  }
}

void same_boundary(State& state) {
  const std::uint32_t n = side(state.range(0));
  const Surface s = test::grid(n, n);
  Edges rim;
  for (const HalfEdge h : s.boundary(*s.curves().begin())) rim.push_back(h);
  Meter meter(state, s.characteristic(), static_cast<double>(rim.size()));
  for (auto _ : state) {
    const double start = now();
    for (std::size_t i = 0; i < rim.size(); ++i)
      benchmark::DoNotOptimize(s.same_boundary(rim[i], rim[(7 * i + rim.size() / 2) % rim.size()]));
    meter.add(now() - start);
  }
}

/// Whole surfaces; the time is per face.
template <class Work>
void per_face(State& state, Surface s, Work work) {
  Meter meter(state, s.characteristic(), static_cast<double>(s.characteristic().f));
  for (auto _ : state) {
    Surface copy = s;
    const double start = now();
    work(copy);
    const double time = now() - start;
    meter.add(time);
  }
}

Surface torus_of(std::int64_t faces) {
  return test::torus(side(faces), side(faces));
}

void unbuild_torus(State& state) {
  per_face(state, torus_of(state.range(0)), [](Surface& s) { (void)unbuild(s); });
}
void unbuild_grid(State& state) {
  per_face(state, test::grid(side(state.range(0)), side(state.range(0))),
           [](Surface& s) { (void)unbuild(s); });
}
void build_torus(State& state) {
  Surface s = torus_of(state.range(0));
  const Surface whole = s;
  const Handlebody h = unbuild(s);
  per_face(state, whole, [&](Surface& out) { out = *build(h); });
}
void from_twins(State& state) {
  const Surface whole = torus_of(state.range(0));
  per_face(state, whole, [&](Surface& out) {
    out = *Surface::from_twins(whole.origins(), whole.twins(), whole.vertex_limit());
  });
}
void validate_torus(State& state) {
  per_face(state, torus_of(state.range(0)), [](Surface& s) { must(validate(s).empty(), "valid"); });
}

void sizes(benchmark::internal::Benchmark* b) {
  b->Arg(1'000)->Arg(10'000)->Arg(100'000)->UseManualTime()->MinTime(0.005);
}
BENCHMARK(create_destroy)->Apply(sizes)->Name("create, destroy");
BENCHMARK(same_boundary)->Apply(sizes);
BENCHMARK(close<Timed::unglue>)->Apply(sizes)->Name("unglue close");
BENCHMARK(close<Timed::glue>)->Apply(sizes)->Name("glue close");
BENCHMARK(zip<Timed::unglue>)->Apply(sizes)->Name("unglue zip");
BENCHMARK(zip<Timed::glue>)->Apply(sizes)->Name("glue zip");
BENCHMARK(split_curve<Timed::unglue>)->Apply(sizes)->Name("unglue split_curve, rim");
BENCHMARK(split_curve<Timed::glue>)->Apply(sizes)->Name("glue split_curve, rim");
BENCHMARK(ear<Timed::unglue, false>)->Apply(sizes)->Name("unglue join_components, ear, g 0");
BENCHMARK(ear<Timed::glue, false>)->Apply(sizes)->Name("glue join_components, ear, g 0");
BENCHMARK(ear<Timed::unglue, true>)->Apply(sizes)->Name("unglue join_components, ear, g 1");
BENCHMARK(ear<Timed::glue, true>)->Apply(sizes)->Name("glue join_components, ear, g 1");
BENCHMARK(halves<Timed::unglue>)->Apply(sizes)->Name("unglue join_components, halves");
BENCHMARK(halves<Timed::glue>)->Apply(sizes)->Name("glue join_components, halves");
BENCHMARK(handle_of_torus<Timed::unglue>)->Apply(sizes)->Name("unglue join_curves, torus");
BENCHMARK(handle_of_torus<Timed::glue>)->Apply(sizes)->Name("glue join_curves, torus");
BENCHMARK(handles_of_chain<Timed::unglue>)->Apply(sizes)->Name("unglue join_curves, chain");
BENCHMARK(handles_of_chain<Timed::glue>)->Apply(sizes)->Name("glue join_curves, chain");
BENCHMARK(flip<NoObserver>)->Apply(sizes)->Name("flip");
BENCHMARK(flip<Listens>)->Apply(sizes)->Name("flip, followed");
BENCHMARK(turn)->Apply(sizes)->Name("turn");
BENCHMARK(split_and_weld<StellarCase::interior_edge, Half::split>)
    ->Apply(sizes)
    ->Name("split edge");
BENCHMARK(split_and_weld<StellarCase::interior_edge, Half::weld>)->Apply(sizes)->Name("weld edge");
BENCHMARK(split_and_weld<StellarCase::boundary_edge, Half::split>)
    ->Apply(sizes)
    ->Name("split boundary edge");
BENCHMARK(split_and_weld<StellarCase::boundary_edge, Half::weld>)
    ->Apply(sizes)
    ->Name("weld boundary edge");
BENCHMARK(split_and_weld<StellarCase::face, Half::split>)->Apply(sizes)->Name("split face");
BENCHMARK(split_and_weld<StellarCase::face, Half::weld>)->Apply(sizes)->Name("weld face");
BENCHMARK(split_vertex_collapse)->Apply(sizes)->Name("split_vertex, collapse");
BENCHMARK(attach_only)->Apply(sizes)->Name("attach");
BENCHMARK(unbuild_grid)->Apply(sizes)->Name("unbuild grid, per face");
BENCHMARK(unbuild_torus)->Apply(sizes)->Name("unbuild torus, per face");
BENCHMARK(build_torus)->Apply(sizes)->Name("build torus, per face");
BENCHMARK(from_twins)->Apply(sizes)->Name("from_twins, per face");
BENCHMARK(validate_torus)->Apply(sizes)->Name("validate, per face");

}  // namespace
}  // namespace clers

BENCHMARK_MAIN();
