#include "codec/test/golden_cases.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <utility>

#include "corpus/build.h"
#include "corpus/generate.h"
#include "corpus/random.h"

namespace clers::test {
namespace {

using corpus::Random;
using Index = std::uint32_t;

// Meshes that corpus/ does not make.
// -----------------------------------------------------------------------------------------------

Mesh bare(Mesh mesh) {
  mesh.attributes.clear();
  return mesh;
}

/// Generators compute places in doubles, which may differ in the last bit from one library or
/// processor to the next; their multiples of 1/1024 do not.
Mesh steady(Mesh mesh) {
  for (Attribute& a : mesh.attributes) {
    std::vector<float> values(a.data.size() / sizeof(float));
    std::memcpy(values.data(), a.data.data(), a.data.size());
    for (float& x : values) x = static_cast<float>(std::llround(x * 1024.0)) / 1024;
    std::memcpy(a.data.data(), values.data(), a.data.size());
  }
  return mesh;
}

void add_face(Mesh& mesh, const std::vector<Index>& face) {
  mesh.corners.insert(mesh.corners.end(), face.begin(), face.end());
  mesh.face_sizes.push_back(static_cast<Index>(face.size()));
}

std::vector<std::vector<Index>> faces_of(const Mesh& mesh) {
  std::vector<std::vector<Index>> faces;
  auto at = mesh.corners.begin();
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const std::ptrdiff_t size = mesh.triangles_only() ? 3 : mesh.face_sizes[f];
    faces.emplace_back(at, at + size);
    at += size;
  }
  return faces;
}

Mesh with_faces(const Mesh& mesh, const std::vector<std::vector<Index>>& faces) {
  Mesh out = mesh;
  out.corners.clear();
  out.face_sizes.clear();
  for (const auto& face : faces) add_face(out, face);
  if (std::all_of(out.face_sizes.begin(), out.face_sizes.end(), [](Index n) { return n == 3; }))
    out.face_sizes.clear();
  return out;
}

/// Makes quadrilaterals of `percent` of the pairs of triangles that generators split them into.
Mesh quads(const Mesh& mesh, unsigned percent = 100, std::uint64_t seed = 0) {
  const auto triangles = faces_of(mesh);
  std::vector<std::vector<Index>> faces;
  Random random(seed);
  for (std::size_t f = 0; f + 1 < triangles.size(); f += 2) {
    const auto &s = triangles[f], &t = triangles[f + 1];
    if (random.chance(percent))
      faces.push_back({s[0], s[1], s[2], t[2]});
    else
      faces.insert(faces.end(), {s, t});
  }
  return with_faces(mesh, faces);
}

/// A vertex for each triangle, and a polygon around each vertex. Precondition: closed.
Mesh dual(const Mesh& mesh) {
  const std::vector<Index> twin = corpus::twins_of(mesh.corners, mesh.vertex_count);
  std::vector<Index> at(mesh.vertex_count);
  for (Index h = 0; h < mesh.corners.size(); ++h) at[mesh.corners[h]] = h;
  Mesh out;
  out.vertex_count = static_cast<Index>(mesh.face_count());
  for (const Index begin : at) {
    std::vector<Index> face;
    Index h = begin;
    do {
      face.push_back(h / 3);
      h = twin[corpus::prev_corner(h)];
    } while (h != begin);
    add_face(out, face);
  }
  return out;
}

/// Two polygons of n corners and a belt of quadrilaterals.
Mesh prism(Index n) {
  Mesh out;
  out.vertex_count = 2 * n;
  std::vector<Index> top(n), bottom(n);
  for (Index i = 0; i < n; ++i) top[i] = i, bottom[i] = 2 * n - 1 - i;
  add_face(out, top);
  for (Index i = 0; i < n; ++i) {
    const Index j = (i + 1) % n;
    add_face(out, {j, i, n + i, n + j});
  }
  add_face(out, bottom);
  return out;
}

/// Every k-th face is left out, reversed, or repeated.
enum class Do { leave_out, reverse, repeat };
Mesh every(Index k, Do what, const Mesh& mesh) {
  std::vector<std::vector<Index>> faces;
  Index i = 0;
  for (auto& face : faces_of(mesh)) {
    const bool chosen = ++i % k == 0;
    if (chosen && what == Do::leave_out) continue;
    if (chosen && what == Do::reverse) std::reverse(face.begin(), face.end());
    faces.push_back(face);
    if (chosen && what == Do::repeat) faces.push_back(std::move(face));
  }
  return with_faces(mesh, faces);
}

/// Random vertices become one, and leave isolated ones behind.
Mesh merge_vertices(Mesh mesh, Index times, std::uint64_t seed) {
  Random random(seed);
  for (Index i = 0; i < times; ++i) {
    const Index from = random.below(mesh.vertex_count), to = random.below(mesh.vertex_count);
    for (Index& v : mesh.corners)
      if (v == from) v = to;
  }
  return mesh;
}

/// Behind every k-th face a triangle (a, a, b) on one of its edges, and one (a, a, a) now and then.
Mesh fold(const Mesh& mesh, Index k) {
  std::vector<std::vector<Index>> faces;
  for (auto& face : faces_of(mesh)) {
    faces.push_back(face);
    const auto i = faces.size();
    const Index a = face[i % face.size()], b = face[(i + 1) % face.size()];
    if (i % k == 0) faces.push_back(i % 2 ? std::vector{a, a, b} : std::vector{b, a, b});
    if (i % (5 * k) == 0) faces.push_back({a, a, a});
  }
  return with_faces(mesh, faces);
}

/// Faces of 0 .. 6 corners, which repeat each other and themselves.
Mesh wild_soup(Index vertices, Index count, std::uint64_t seed) {
  Random random(seed);
  Mesh out;
  out.vertex_count = vertices;
  std::vector<std::vector<Index>> faces;
  for (Index f = 0; f < count; ++f) {
    std::vector<Index> face;
    if (f > 0 && random.chance(20)) {
      face = faces[random.below(f)];
      if (random.chance(50)) std::reverse(face.begin(), face.end());
    } else {
      face.resize(random.below(7));
      for (Index& v : face) v = random.below(vertices);
    }
    faces.push_back(std::move(face));
  }
  for (const auto& face : faces) add_face(out, face);
  return out;
}

// Values.
// -----------------------------------------------------------------------------------------------

/// Each suits another predictor: the parallelogram, the value before, none.
enum class Values { planes, steps, noise };

template <class T>
void put(std::vector<std::byte>& data, T value) {
  data.resize(data.size() + sizeof value);
  std::memcpy(data.data() + data.size() - sizeof value, &value, sizeof value);
}

void put(std::vector<std::byte>& data, Scalar scalar, std::int64_t x) {
  switch (scalar) {
    case Scalar::int8: return put(data, static_cast<std::int8_t>(x));
    case Scalar::uint8: return put(data, static_cast<std::uint8_t>(x));
    case Scalar::int16: return put(data, static_cast<std::int16_t>(x));
    case Scalar::uint16: return put(data, static_cast<std::uint16_t>(x));
    case Scalar::int32: return put(data, static_cast<std::int32_t>(x));
    case Scalar::uint32: return put(data, static_cast<std::uint32_t>(x));
    case Scalar::int64: return put(data, x);
    case Scalar::uint64: return put(data, static_cast<std::uint64_t>(x));
    case Scalar::float32: return put(data, static_cast<float>(x % (1 << 24)) / 64);
    case Scalar::float64: return put(data, static_cast<double>(x % (1ll << 53)) / 64);
  }
}

/// Planes are made for the vertices of corpus::grid(c, 7), eight in a column.
Attribute values(const Mesh& mesh, std::string name, Domain domain, Scalar scalar,
                 unsigned components, Values kind, std::uint64_t seed = 1) {
  Attribute a{std::move(name), domain, scalar, static_cast<std::uint8_t>(components), {}};
  Random random(seed);
  for (std::size_t i = 0; i < mesh.value_count(domain); ++i)
    for (unsigned c = 0; c < components; ++c) {
      const auto n = static_cast<std::int64_t>(i), k = static_cast<std::int64_t>(c);
      const auto noise = static_cast<std::int64_t>(random.next());
      if (kind == Values::planes)
        put(a.data, scalar, (3 + k) * (n / 8) - (5 + k * k) * (n % 8) + 60);
      else if (kind == Values::steps)
        put(a.data, scalar, n / 5 * (k + 1) - 70);
      else
        put(a.data, scalar, noise);
    }
  return a;
}

Mesh with_positions(Mesh mesh, Scalar scalar, unsigned components, Values kind) {
  mesh.attributes = {
      values(mesh, position_name, Domain::vertex, scalar, components, kind, components)};
  return mesh;
}

/// Positions, and a value of each domain.
Mesh dressed(Mesh mesh) {
  if (mesh.attributes.empty())
    mesh = with_positions(std::move(mesh), Scalar::float32, 3, Values::steps);
  mesh.attributes.push_back(
      values(mesh, "normal", Domain::corner, Scalar::int16, 3, Values::planes));
  mesh.attributes.push_back(
      values(mesh, "colour", Domain::vertex, Scalar::uint8, 4, Values::planes));
  mesh.attributes.push_back(
      values(mesh, "material", Domain::face, Scalar::uint32, 1, Values::steps));
  return mesh;
}

Mesh odd_floats(Mesh mesh) {
  const float f[] = {-0.0f,
                     0.0f,
                     std::numeric_limits<float>::infinity(),
                     -std::numeric_limits<float>::infinity(),
                     std::numeric_limits<float>::denorm_min(),
                     -std::numeric_limits<float>::max()};
  Attribute a{position_name, Domain::vertex, Scalar::float32, 3, {}};
  for (std::size_t i = 0; i < 3 * std::size_t(mesh.vertex_count); ++i)
    if (i % 7 == 6)
      put(a.data, std::uint32_t(0x7fc00000u + i));  // NaNs
    else
      put(a.data, f[i % 7]);
  mesh.attributes = {a};
  return mesh;
}

// The cases.
// -----------------------------------------------------------------------------------------------

struct Named {
  const char* name;
  Mesh mesh;
};

/// Surfaces as they are: nothing to cut.
std::vector<Named> surfaces() {
  const Mesh parts[] = {corpus::tetrahedron(), corpus::grid(2, 3), corpus::torus(3, 4)};
  return {{"triangle", corpus::single_triangle()},
          {"pair", corpus::glued_pair()},
          {"sphere", corpus::icosphere(3)},
          {"irregular sphere", corpus::flip_edges(corpus::icosphere(4), 4000, 1)},
          {"holes", corpus::punch_holes(corpus::torus(40, 30), 20, 2)},
          {"annulus", corpus::shuffle(corpus::cylinder(20, 9), 3)},
          {"gyroid", corpus::gyroid(2, 1, 1, 10, corpus::Ends::open)},
          {"periodic gyroid", corpus::gyroid(1, 1, 2, 9, corpus::Ends::periodic)},
          {"lattice", corpus::lattice(4)},
          {"strip", corpus::strip(500)},
          {"fan", corpus::fan(200)},
          {"parts", corpus::disjoint_union(parts)},
          {"copies", corpus::copies(corpus::flip_edges(corpus::icosphere(2), 100, 3), 20)},
          {"apart", corpus::loose_triangles(30)},
          {"reversed", corpus::reversed(corpus::punch_holes(corpus::icosphere(2), 3, 4))},
          {"quads", quads(corpus::torus(24, 17))},
          {"quads with holes", every(9, Do::leave_out, quads(corpus::grid(20, 20)))},
          {"quads and triangles", quads(corpus::cylinder(25, 14), 60, 5)},
          {"dual", dual(corpus::flip_edges(corpus::icosphere(3), 2000, 6))},
          {"dual with handles", dual(corpus::lattice(3))},
          {"dual with holes",
           every(11, Do::leave_out, dual(corpus::flip_edges(corpus::torus(20, 21), 500, 7)))},
          {"prism", prism(700)}};
}

/// Faces that a surface does not have, or not so.
std::vector<Named> defects() {
  const Mesh ball = corpus::flip_edges(corpus::icosphere(2), 200, 8);
  return {{"fins", corpus::add_fins(ball, 40, 9)},
          {"book", corpus::book(12)},
          {"chessboard", corpus::chessboard(9)},
          {"hub", corpus::pinched_hub(25)},
          {"pinches", merge_vertices(corpus::torus(20, 15), 12, 10)},
          {"pinched quads", merge_vertices(quads(corpus::torus(20, 15)), 12, 11)},
          {"moebius", corpus::moebius_strip(30, 4)},
          {"moebius quads", quads(corpus::moebius_strip(30, 4))},
          {"some reversed", corpus::reverse_some(ball, 60, 12)},
          {"some polygons reversed", every(6, Do::reverse, dual(ball))},
          {"doubled", corpus::doubled(ball)},
          {"two-sided", corpus::two_sided(quads(corpus::grid(9, 8)))},
          {"some repeated", every(5, Do::repeat, ball)},
          {"some polygons repeated", every(5, Do::repeat, dual(ball))},
          {"folded", fold(corpus::grid(12, 12), 4)},
          {"folded quads", fold(quads(corpus::torus(12, 12)), 4)},
          {"same triangle", corpus::same_triangle(20)},
          {"all triples", corpus::all_triples(11)},
          {"soup", corpus::random_soup(60, 200, 3, 13)},
          {"thin soup", corpus::random_soup(3000, 900, 3, 14)},
          {"soup of polygons", corpus::random_soup(300, 300, 9, 15)},
          {"wild soup", wild_soup(40, 150, 16)},
          {"isolated", corpus::isolate(ball, 31)}};
}

class Cases {
 public:
  void add(const std::string& name, std::vector<Mesh> meshes, EncodeOptions options = {}) {
    cases_.push_back({name, std::move(meshes), std::move(options)});
  }
  void add(const std::string& name, const Mesh& mesh, EncodeOptions options = {}) {
    add(name, std::vector{mesh}, std::move(options));
  }

  /// Faces alone: no zstd in these files.
  void connectivity() {
    std::vector<Named> all = surfaces();
    for (Named& m : defects()) all.push_back(std::move(m));
    for (const Named& m : all) {
      for (const int level : {1, 3, 5, 7, 9}) {
        EncodeOptions options;
        options.level = level;
        add(m.name + (", level " + std::to_string(level)), bare(m.mesh), options);
      }
      EncodeOptions keep;
      keep.order = Order::keep;
      add(std::string(m.name) + ", order kept", bare(corpus::shuffle(m.mesh, 17)), keep);
    }
  }

  void pieces() {
    std::vector<Named> all = surfaces();
    for (Named& m : defects()) all.push_back(std::move(m));
    for (Named& m : all) {
      const Mesh mesh = dressed(steady(std::move(m.mesh)));
      EncodeOptions options;
      options.piece_faces = static_cast<Index>(std::max<std::size_t>(mesh.face_count() / 7, 1));
      add(std::string(m.name) + ", values, in pieces", mesh, options);
      options.order = Order::keep;
      options.level = 9;
      add(std::string(m.name) + ", values, in pieces, order kept, level 9", mesh, options);
      options.piece_faces = 0;
      options.level = 1;
      add(std::string(m.name) + ", values, order kept, level 1", mesh, options);
    }
    EncodeOptions options;
    options.piece_faces = 30;
    add("torus, in pieces without positions",
        bare(corpus::flip_edges(corpus::torus(20, 20), 90, 18)), options);
  }

  void attributes() {
    const char* const domains[] = {"vertices", "corners", "faces"};
    const Mesh grid = bare(quads(corpus::grid(9, 7), 50, 19));
    Mesh every_kind = grid;
    for (unsigned d = 0; d < 3; ++d)
      for (unsigned s = 0; s < scalar_count; ++s) {
        Mesh mesh = grid;
        for (unsigned components = 1; components <= 4; ++components)
          for (const Values kind : {Values::planes, Values::steps, Values::noise}) {
            const std::string name = "a" + std::to_string(components) + "pqr"[int(kind)];
            mesh.attributes.push_back(values(mesh, name, static_cast<Domain>(d),
                                             static_cast<Scalar>(s), components, kind, s));
          }
        every_kind.attributes.push_back(mesh.attributes[d + s]);
        every_kind.attributes.back().name += std::to_string(10 * d + s);
        add(std::string("values of ") + domains[d] + ", scalar " + std::to_string(s), mesh);
      }
    for (const int level : {1, 2, 3, 4, 5, 6, 7, 8, 9}) {
      EncodeOptions options;
      options.level = level;
      add("values of every kind, level " + std::to_string(level), every_kind, options);
    }
    for (unsigned s = 0; s < scalar_count; ++s) {
      std::vector<Mesh> meshes;
      for (unsigned components = 1; components <= 4; ++components)
        for (const Values kind : {Values::planes, Values::noise})
          meshes.push_back(with_positions(grid, static_cast<Scalar>(s), components, kind));
      add("positions, scalar " + std::to_string(s), meshes);
    }
    add("odd floats", odd_floats(corpus::icosphere(1)));
    Mesh wide = grid;
    wide.attributes = {
        values(grid, "wide", Domain::vertex, Scalar::float32, 255, Values::planes),
        values(grid, std::string(255, 'n'), Domain::face, Scalar::int8, 1, Values::noise)};
    add("255 components, a name of 255 bytes", wide);
  }

  void files() {
    Mesh points;
    points.vertex_count = 13;
    Mesh named = steady(corpus::icosphere(1));
    named.name = "B\xc3\xa4llchen";
    named.metadata = {
        {"from", "golden_cases.cc"}, {"empty", ""}, {"bytes", std::string(900, '\0')}};
    const Mesh cases[] = {Mesh{}, points, named};
    add("no meshes", std::vector<Mesh>());
    add("an empty mesh", Mesh{});
    add("vertices alone", points);
    add("vertices alone, with values", dressed(points));
    add("name and metadata", named);
    std::vector<Mesh> meshes(std::begin(cases), std::end(cases));
    for (Named& m : surfaces()) meshes.push_back(steady(std::move(m.mesh)));
    for (Named& m : defects()) meshes.push_back(steady(std::move(m.mesh)));
    add("all meshes", meshes);
    EncodeOptions options;
    options.piece_faces = 300;
    add("all meshes, large ones in pieces", meshes, options);
    options.order = Order::keep;
    options.level = 9;
    add("all meshes, large ones in pieces, order kept, level 9", meshes, options);
  }

  std::vector<GoldenCase> take() { return std::move(cases_); }

 private:
  std::vector<GoldenCase> cases_;
};

}  // namespace

std::vector<GoldenCase> golden_cases() {
  Cases cases;
  cases.connectivity();
  cases.pieces();
  cases.attributes();
  cases.files();
  return cases.take();
}

}  // namespace clers::test
