#include "codec/test/golden_cases.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <utility>

#include "codec/test/golden_meshes.h"
#include "corpus/generate.h"
#include "corpus/random.h"

namespace clers::test {
namespace {

using corpus::Random;
using Index = std::uint32_t;

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
    std::vector<NamedMesh> all = surfaces();
    for (NamedMesh& m : defects()) all.push_back(std::move(m));
    for (const NamedMesh& m : all) {
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
    std::vector<NamedMesh> all = surfaces();
    for (NamedMesh& m : defects()) all.push_back(std::move(m));
    for (NamedMesh& m : all) {
      const Mesh mesh = dressed(steady(std::move(m.mesh)));
      EncodeOptions options;
      options.piece_faces = static_cast<Index>(std::max<std::size_t>(mesh.face_count() / 7, 1));
      add(std::string(m.name) + ", values, in pieces", mesh, options);
      options.order = Order::keep;
      options.level = 9;
      add(std::string(m.name) + ", values, in pieces, order kept, level 9", mesh, options);
      options.piece_faces.reset();
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
      EncodeOptions options;
      options.piece_faces = 20;
      add("positions, scalar " + std::to_string(s) + ", in pieces", meshes, options);
    }
    add("odd floats", odd_floats(corpus::icosphere(1)));
    Mesh wide = grid;
    wide.attributes = {
        values(grid, "wide", Domain::vertex, Scalar::float32, 255, Values::planes),
        values(grid, std::string(255, 'n'), Domain::face, Scalar::int8, 1, Values::noise)};
    add("255 components, a name of 255 bytes", wide);
  }

  /// Symmetric and not, rounded to grids and not: what coders of positions know of all is used.
  void positions() {
    const NamedMesh meshes[] = {{"a grid", bare(corpus::grid(40, 7))},
                                {"parts", bare(corpus::copies(corpus::icosphere(2), 3))}};
    const std::pair<const char*, Precision> precisions[] = {
        {"lossless", Precision::lossless()},
        {"11 bits", Precision::of_bits(11)},
        {"steps of 0.37", Precision::of_step(0.37)},
        {"off by 0.003", Precision::of_error(0.003)},
        {"a grid of 0.25", Precision::on_grid({0.5, -1, 0}, 0.25)}};
    for (const NamedMesh& m : meshes)
      for (const Values kind : {Values::planes, Values::steps, Values::noise}) {
        unsigned i = static_cast<unsigned>(kind);
        for (const auto& [words, precision] : precisions) {
          const Scalar scalar = i++ % 2 == 0 ? Scalar::float32 : Scalar::float64;
          const Mesh mesh = dressed(with_positions(m.mesh, scalar, 3, kind));
          const bool all_levels = precision.kind <= Precision::Kind::bits;
          for (const int level : all_levels ? std::vector{1, 5, 7, 9} : std::vector{5}) {
            EncodeOptions options;
            options.level = level;
            options.precisions = {{position_name, precision}, {"colour", Precision::of_bits(5)}};
            add(std::string(m.name) + ", " + "pqr"[int(kind)] + ", " +
                    std::string(clers::name(scalar)) + ", " + words + ", level " +
                    std::to_string(level),
                mesh, options);
          }
        }
      }
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
    EncodeOptions options;
    options.piece_faces = 30;
    add("name and metadata, in pieces", named, options);
    options.level = 1;
    options.piece_faces = never_in_pieces;
    add("many faces in no order", bare(corpus::shuffle(corpus::torus(700, 100), 25)), options);
    std::vector<Mesh> meshes(std::begin(cases), std::end(cases));
    for (NamedMesh& m : surfaces()) meshes.push_back(steady(std::move(m.mesh)));
    for (NamedMesh& m : defects()) meshes.push_back(steady(std::move(m.mesh)));
    add("all meshes", meshes);
    options = {};
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
  cases.positions();
  cases.files();
  return cases.take();
}

}  // namespace clers::test
