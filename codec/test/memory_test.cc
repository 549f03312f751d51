// Peak memory against Limits::memory, for files that claim much and for honest ones.
#include <gtest/gtest.h>
#include <malloc.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <memory>
#include <new>

#include "codec/connectivity/connectivity.h"
#include "codec/decode.h"
#include "codec/encode.h"
#include "codec/inspect.h"
#include "codec/test/attribute.h"
#include "codec/test/decoding.h"
#include "codec/test/file_builder.h"
#include "corpus/generate.h"
#include "corpus/random.h"

namespace {

std::atomic<std::int64_t> held{0}, peak{0};

void* counted(void* block) {
  if (block == nullptr) throw std::bad_alloc();
  const auto size = static_cast<std::int64_t>(malloc_usable_size(block));
  const std::int64_t now = held += size;
  for (std::int64_t most = peak; now > most && !peak.compare_exchange_weak(most, now);) {
  }
  return block;
}
void uncounted(void* block) {
  if (block != nullptr) held -= static_cast<std::int64_t>(malloc_usable_size(block));
  std::free(block);
}

}  // namespace

void* operator new(std::size_t size) {
  return counted(std::malloc(size == 0 ? 1 : size));
}
void* operator new(std::size_t size, std::align_val_t alignment) {
  const auto a = static_cast<std::size_t>(alignment);
  return counted(std::aligned_alloc(a, (size + a - 1) / a * a));
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept try {
  return ::operator new(size);
} catch (const std::bad_alloc&) {
  return nullptr;
}
void operator delete(void* p, const std::nothrow_t&) noexcept {
  uncounted(p);
}
void operator delete(void* p) noexcept {
  uncounted(p);
}
void operator delete(void* p, std::size_t) noexcept {
  uncounted(p);
}
void operator delete(void* p, std::align_val_t) noexcept {
  uncounted(p);
}
void operator delete(void* p, std::size_t, std::align_val_t) noexcept {
  uncounted(p);
}

namespace clers::internal {
namespace {

using test::FileBuilder;
using test::Payload;

constexpr std::uint64_t MB = 1 << 20;
/// What no file can raise: error texts, threads, a vector's last element.
constexpr std::uint64_t slack = MB / 4;
/// What a test may take of the machine; files that need more are refused under every limit tried.
constexpr std::uint64_t most_tried = 512 * MB;

/// What a call takes at most, and the error that it ends with.
struct Outcome {
  std::uint64_t peak = 0;
  Error error{};
  bool ok = true;

  bool over_memory() const { return error.limited == Limited::memory; }
};

using Call = std::function<Expected<Done>(const DecodeOptions&)>;

Outcome run(const Call& call, const Limits& limits, unsigned threads) {
  DecodeOptions options;
  options.limits = limits;
  options.threads = threads;
  const std::int64_t before = held;
  peak = before;
  auto done = call(options);
  Outcome outcome;
  outcome.peak = static_cast<std::uint64_t>(peak - before);
  outcome.ok = done.ok();
  if (!done) outcome.error = done.error();
  return outcome;
}

template <class T>
Expected<Done> only_errors(const Expected<T>& result) {
  if (!result) return Failure{result.error()};
  return Done{};
}

struct NamedCall {
  const char* name;
  Call call;
};

/// Everything that takes bytes. Memory of the caller is made before.
std::vector<NamedCall> calls_on(std::span<const std::byte> bytes) {
  std::vector<NamedCall> calls = {
      {"decode", [=](const DecodeOptions& o) { return only_errors(decode(bytes, o)); }},
      {"pieces",
       [=](const DecodeOptions& o) {
         return test::decode_pieces(
             bytes, [](const Piece&) {}, o);
       }},
      {"decode_piece",
       [=](const DecodeOptions& o) -> Expected<Done> {
         const auto decoder = Decoder::open(bytes, o);
         if (!decoder) return Failure{decoder.error()};
         return only_errors(decoder->decode_piece(0));
       }},
      {"info",
       [=](const DecodeOptions& o) -> Expected<Done> {
         const auto decoder = Decoder::open(bytes, o);
         if (!decoder) return Failure{decoder.error()};
         return only_errors(decoder->info());
       }},
      {"inspect", [=](const DecodeOptions& o) { return only_errors(inspect(bytes, o.limits)); }}};
  DecodeOptions all;
  all.limits.memory = std::uint64_t(1) << 40;
  const auto decoder = Decoder::open(bytes, all);
  if (!decoder || decoder->mesh_count() != 1) return calls;
  const auto info = decoder->info();
  if (!info || info->meshes[0].corners > 32 * MB) return calls;
  const std::size_t n = info->meshes[0].corners;
  const auto corners = std::make_shared<std::vector<std::uint32_t>>(n);
  const auto narrow = std::make_shared<std::vector<std::uint16_t>>(n);
  const auto opposites = std::make_shared<std::vector<std::uint32_t>>(n);
  const auto sizes = std::make_shared<std::vector<std::uint32_t>>(info->meshes[0].faces);
  const auto into = [&](const char* name, MeshTarget target) {
    // Keeps the memory alive.
    calls.push_back({name, [=](const DecodeOptions& o) {
                       (void)corners, (void)narrow, (void)opposites, (void)sizes;
                       return test::decode_into(bytes, target, o);
                     }});
  };
  into("decode_into", {.corners = *corners});
  into("decode_into with opposites", {.corners = *corners, .opposites = *opposites});
  into("decode_into 16 bits", {.corners_16 = *narrow, .opposites = *opposites});
  into("decode_into, polygons",
       {.corners_16 = *narrow, .face_sizes = *sizes, .opposites = *opposites});
  into("opposites alone", {.face_sizes = *sizes, .opposites = *opposites});
  const auto& attributes = info->meshes[0].attributes;
  std::uint64_t bytes_of_values = 0;
  for (const AttributeInfo& a : attributes) bytes_of_values += 2 * a.count * a.value_size();
  if (bytes_of_values > 32 * MB) return calls;
  struct Values {
    std::vector<AttributeInfo> attributes;
    std::vector<std::vector<std::byte>> data;
    std::vector<AttributeTarget> targets;
  };
  const auto values = std::make_shared<Values>();
  values->attributes = attributes;
  for (const AttributeInfo& a : values->attributes) {
    auto& data = values->data.emplace_back(2 * a.count * a.value_size());
    values->targets.push_back({a.name, a.domain, a.scalar, a.components, data, 2 * a.value_size()});
  }
  calls.push_back({"decode_into, all", [=](const DecodeOptions& o) {
                     return test::decode_into(bytes,
                                              {.corners = *corners,
                                               .face_sizes = *sizes,
                                               .opposites = *opposites,
                                               .attributes = values->targets},
                                              o);
                   }});
  calls.push_back({"decode_into, values", [=](const DecodeOptions& o) {
                     return test::decode_into(bytes, {.attributes = values->targets}, o);
                   }});
  return calls;
}

/// The least limit that the call gets along with, found by what its errors say, and how it ends
/// with that.
struct Need {
  std::uint64_t memory;
  Outcome outcome;
};

Need needed(const Call& call) {
  Limits limits;
  limits.memory = 0;
  for (;;) {
    const Outcome o = run(call, limits, 1);
    if (!o.over_memory()) return {*limits.memory, o};
    EXPECT_EQ(o.error.code, ErrorCode::limit);
    EXPECT_GT(o.error.needed, *limits.memory);
    EXPECT_LE(o.peak, *limits.memory + slack);

    limits.memory = o.error.needed;
    if (*limits.memory > most_tried) return {*limits.memory, o};
  }
}

/// Peaks are within every limit, whatever the number of threads, which changes no outcome. Where
/// files are honest, what is needed is not much more than what is taken.
void expect_within_limits(std::span<const std::byte> bytes, bool honest = false) {
  for (const auto& named : calls_on(bytes)) {
    SCOPED_TRACE(named.name);
    const auto& call = named.call;  // clang 14 captures no structured binding
    const Need need = needed(call);
    std::optional<Outcome> done;  // the last one that took what it needed, for one thread
    const auto try_limit = [&](const Limits& limits) {
      const std::uint64_t limit = limits.memory.value_or(std::max(1024 * MB, 4096 * bytes.size()));
      const bool known = limit == need.memory && need.memory <= most_tried;
      const Outcome one = known ? need.outcome : run(call, limits, 1), four = run(call, limits, 4);
      EXPECT_EQ(one.over_memory(), limit < need.memory);
      EXPECT_LE(one.peak, limit + slack);
      EXPECT_LE(four.peak, limit + 4 * slack);
      EXPECT_EQ(one.ok, four.ok);
      EXPECT_EQ(describe(one.error), describe(four.error));
      EXPECT_EQ(one.error.needed, four.error.needed);
      if (!one.over_memory()) done = one;
    };
    for (const std::uint64_t memory :
         {need.memory - 1, std::min(need.memory, most_tried), 8 * MB}) {
      Limits limits;
      limits.memory = memory;
      try_limit(limits);
    }
    // The default, where 8 MB were too little.
    if (need.memory > 8 * MB && (need.memory <= most_tried || need.memory > 1024 * MB))
      try_limit({});
    // Models take up to a MB, however few the values.
    if (honest && done && done->ok) {
      EXPECT_LE(need.memory, 3 * done->peak + 3 * MB / 2);
    }
  }
}

/// Triangles that share nothing, as connectivity: E, a new component each time.
Bytes loose_triangles(std::uint32_t n, int level) {
  const Mesh mesh = corpus::loose_triangles(n);
  std::vector<HalfEdge> twins(mesh.corners.size());
  auto coded = encode_connectivity({mesh.corners, twins, mesh.vertex_count}, level);
  EXPECT_TRUE(coded.ok());
  return coded->bytes;
}

Payload surface(std::uint32_t features, std::uint64_t others) {
  return std::move(Payload().u8(features).varint(others));
}

const Bytes no_symbols = {std::byte{0}, std::byte{1}};  // a state of 256 alone

// The rows of the table of attacks, smaller where size adds nothing.

TEST(Memory, FilesOfAttackers) {
  for (const auto& entry : std::filesystem::directory_iterator(CLERS_TEST_CASES)) {
    SCOPED_TRACE(entry.path().filename().string());
    std::ifstream in(entry.path(), std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    ASSERT_FALSE(text.empty());
    const auto bytes = std::as_bytes(std::span(text));
    for (const auto& [name, call] : calls_on(bytes)) {
      SCOPED_TRACE(name);
      Limits small;
      small.memory = 64 * MB;
      EXPECT_LE(run(call, small, 1).peak, 64 * MB + slack);
      EXPECT_LE(run(call, small, 4).peak, 64 * MB + 4 * slack);
      EXPECT_LE(run(call, {}, 1).peak, 1024 * MB + slack);
    }
  }
}

TEST(Memory, PiecesThatClaimValues) {
  FileBuilder file;
  file.pieces(2);
  for (int i = 0; i < 2; ++i) {
    file.section(SectionKind::mesh, test::raw_mesh(std::uint64_t(1) << 30, 0, 0));
    file.section(SectionKind::attribute,
                 test::attribute_section("a", Domain::vertex, Scalar::uint8, 4, {}));
  }
  const Bytes bytes = file.finish();
  EXPECT_EQ(decode(bytes).error().code, ErrorCode::invalid);
  expect_within_limits(bytes);
}

TEST(Memory, PiecesOfZeros) {
  const Bytes frame = test::zstd_frame(Bytes(4 * MB));
  FileBuilder file;
  file.pieces(3);
  for (int i = 0; i < 3; ++i) {
    file.section(SectionKind::mesh, test::raw_mesh(1 * MB, 0, 0));
    file.section(SectionKind::attribute,
                 test::attribute_section("a", Domain::vertex, Scalar::uint8, 4, frame));
  }
  // Pieces after the first share a vertex at least: refused, but not before there is room for them.
  expect_within_limits(file.finish());
}

TEST(Memory, OneAttributeOfZeros) {
  const Bytes frame = test::zstd_frame(Bytes(8 * MB));
  FileBuilder file;
  file.section(SectionKind::mesh, test::raw_mesh(2 * MB, 0, 0));
  file.section(SectionKind::attribute,
               test::attribute_section("a", Domain::vertex, Scalar::uint8, 4, frame));
  const Bytes bytes = file.finish();
  EXPECT_TRUE(decode(bytes).ok());
  expect_within_limits(bytes);
}

TEST(Memory, SeveralAttributesOfZeros) {
  const Bytes frame = test::zstd_frame(Bytes(2 * MB));
  FileBuilder file;
  file.section(SectionKind::mesh, test::raw_mesh(MB / 2, 0, 0));
  for (const char* name : {"a", "b", "c", "d", "e"})
    file.section(SectionKind::attribute,
                 test::attribute_section(name, Domain::vertex, Scalar::float32, 1, frame));
  const Bytes bytes = file.finish();
  EXPECT_TRUE(decode(bytes).ok());
  expect_within_limits(bytes);
}

TEST(Memory, IsolatedVertices) {
  for (const unsigned bits : {20u, 24u, 28u, 31u}) {
    const Bytes bytes =
        FileBuilder()
            .section(SectionKind::mesh, test::tetrahedron_mesh(std::uint64_t(1) << bits))
            .finish();
    expect_within_limits(bytes);
  }
}

TEST(Memory, IsolatedVerticesInAnOrder) {
  for (const unsigned bits : {20u, 22u, 28u}) {
    FileBuilder file;
    file.section(SectionKind::mesh, test::tetrahedron_mesh(std::uint64_t(1) << bits));
    file.section(SectionKind::order, Payload().raw(no_symbols));
    expect_within_limits(file.finish());
  }
}

TEST(Memory, Copies) {
  Payload mesh = surface(feature::copies, 0);
  mesh.varint(1).stream(no_symbols).raw(loose_triangles(60'000, 5));
  expect_within_limits(FileBuilder().section(SectionKind::mesh, mesh).finish());
}

TEST(Memory, LevelNine) {
  Payload mesh = surface(0, 0);
  mesh.raw(loose_triangles(40'000, 9));
  const Bytes bytes = FileBuilder(9).section(SectionKind::mesh, mesh).finish();
  EXPECT_TRUE(decode(bytes).ok());
  expect_within_limits(bytes);
}

TEST(Memory, OrderOfManyFaces) {
  Payload mesh = surface(0, 0);
  mesh.raw(loose_triangles(150'000, 3));
  FileBuilder file;
  file.section(SectionKind::mesh, mesh);
  file.section(SectionKind::order, Payload().raw(Bytes(40, std::byte{1})));
  expect_within_limits(file.finish());
}

TEST(Memory, EmptyPieces) {
  constexpr unsigned n = 20'000;
  FileBuilder file;
  file.pieces(n);
  const Payload empty = test::raw_mesh(0, 0, 0);
  for (unsigned i = 0; i < n; ++i) file.section(SectionKind::mesh, empty);
  expect_within_limits(file.finish());
}

TEST(Memory, ManyMeshes) {
  FileBuilder file;
  for (unsigned i = 0; i < 10'000; ++i) {
    file.section(SectionKind::mesh, test::tetrahedron_mesh());
    file.section(SectionKind::name, Payload().text("a name that takes memory of its own"));
  }
  expect_within_limits(file.finish());
}

TEST(Memory, ManyAttributes) {
  FileBuilder file;
  file.section(SectionKind::mesh, test::tetrahedron_mesh());
  const Bytes frame = test::zstd_frame(Bytes(4));
  for (unsigned i = 0; i < 10'000; ++i)
    file.section(SectionKind::attribute,
                 test::attribute_section("", Domain::face, Scalar::uint8, 1, frame));
  expect_within_limits(file.finish());
}

TEST(Memory, ReversedAndDegenerateAndPolygonsThatAreNot) {
  const Bytes connectivity = loose_triangles(80'000, 5);
  const Bytes claims(128, std::byte{1});
  Payload reversed = surface(feature::reversed, 0);
  reversed.varint(80'000).stream(no_symbols).raw(connectivity);
  Payload polygons = surface(feature::polygons, 0);
  polygons.varint(79'999).stream(no_symbols).raw(connectivity);
  Payload degenerate = surface(feature::degenerate, 0);
  degenerate.varint(800'000).varint(800'000).stream(claims).raw(connectivity);
  const Payload raw = test::raw_mesh(10, 800'000, 800'000, 128);
  for (const Payload& mesh : {reversed, polygons, degenerate, raw})
    expect_within_limits(FileBuilder().section(SectionKind::mesh, mesh).finish());
}

// Honest files of every kind, which must not be refused for more than they take.

void expect_fair(const std::vector<Mesh>& meshes, EncodeOptions options) {
  auto coded = encode(meshes, options);
  ASSERT_TRUE(coded.ok()) << describe(coded.error());
  expect_within_limits(coded->bytes, true);
}

TEST(Memory, HonestFiles) {
  const auto with_values = [](Mesh mesh) {
    std::vector<float> position(3 * std::size_t(mesh.vertex_count));
    for (std::size_t i = 0; i < position.size(); ++i) position[i] = float(i * i % 1009);
    mesh.attributes = {
        test::attribute<float>("position", Domain::vertex, Scalar::float32, 3, position),
        test::attribute<std::uint8_t>("kind", Domain::face, Scalar::uint8, 1,
                                      std::vector<std::uint8_t>(mesh.face_count(), 7)),
        test::attribute<double>("uv", Domain::corner, Scalar::float64, 2,
                                std::vector<double>(2 * mesh.corners.size(), 0.5))};
    return mesh;
  };
  Mesh turned = corpus::torus(80, 60);
  for (std::size_t f = 0; f < turned.face_count(); f += 3)
    std::swap(turned.corners[3 * f], turned.corners[3 * f + 1]);
  Mesh degenerate = corpus::icosphere(4);
  for (std::size_t f = 0; f < degenerate.face_count(); f += 5)
    degenerate.corners[3 * f] = degenerate.corners[3 * f + 1];
  Mesh points = corpus::grid(80, 60);
  points.vertex_count += 20'000;
  points.attributes.clear();
  const std::vector<Mesh> kinds = {corpus::punch_holes(corpus::torus(100, 80), 30, 1),
                                   turned,
                                   degenerate,
                                   points,
                                   corpus::chessboard(80),
                                   corpus::random_soup(2000, 3000, 3, 1),
                                   corpus::random_soup(10000, 7000, 7, 2),
                                   corpus::loose_triangles(6000)};
  for (std::size_t k = 0; k < kinds.size(); ++k)
    for (const bool values : {false, true}) {
      SCOPED_TRACE("kind " + std::to_string(k) + (values ? " with values" : ""));
      const std::vector<Mesh> one = {values ? with_values(kinds[k]) : kinds[k]};
      EncodeOptions options;
      expect_fair(one, options);
      if (!values) continue;
      options.order = Order::keep;
      expect_fair(one, options);
      options.piece_faces = 1000;
      expect_fair(one, options);
      options = {};
      if (k % 5 == 0) options.level = 9;  // whose tables do not depend on kinds, and which is slow
      options.piece_faces = 2000;
      expect_fair({one[0], one[0]}, options);
    }
}

TEST(Memory, SharedValues) {
  Mesh mesh =
      corpus::torus(125, 100);  // four bytes a corner that are not counted are more than `slack`
  const auto corners = static_cast<std::uint32_t>(mesh.corners.size());
  const auto by_index = [&](const char* name, Domain domain, auto index_of, std::uint32_t values) {
    std::vector<float> numbers(2 * values);
    for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = float(i % 5009);
    Attribute a = test::attribute(name, domain, Scalar::float32, 2, numbers);
    const std::size_t count = mesh.value_count(domain);
    for (std::uint32_t e = 0; e < count; ++e) a.indices.push_back(index_of(e));
    return a;
  };
  const auto of_vertex = [&](std::uint32_t c) { return mesh.corners[c]; };
  const auto itself = [](std::uint32_t e) { return e; };
  const auto some = [&](std::uint32_t c) { return c % 5 == 0 ? no_value : mesh.corners[c] / 3; };
  const Attribute all[] = {
      by_index("wedges", Domain::corner, of_vertex, mesh.vertex_count),
      by_index("apart", Domain::corner, itself, corners),
      by_index("listed", Domain::corner, some, mesh.vertex_count),
      by_index(
          "unused", Domain::face, [](std::uint32_t f) { return f / 2; }, corners / 3)};
  // An order is coded the same way at any level.
  for (const auto& [level, order] : {std::pair(1, Order::keep), std::pair(5, Order::free)}) {
    EncodeOptions options;
    options.level = level;
    options.order = order;
    const auto expect_limited = [&] {
      const auto coded = encode(mesh, options);
      ASSERT_TRUE(coded.ok()) << describe(coded.error());
      expect_within_limits(coded->bytes);
    };
    for (const Attribute& a : all) {
      mesh.attributes = {a};
      expect_limited();
    }
    mesh.attributes = {all[0], all[1], all[2], all[3]};
    expect_limited();
  }
}

TEST(Memory, WeldedVertices) {
  constexpr std::uint32_t around = 150;
  Mesh mesh = corpus::grid(around, 120);
  std::vector<float> position;
  for (std::uint32_t v = 0; v < mesh.vertex_count; ++v) {
    const std::uint32_t x = v % (around + 1) % around;
    corpus::Random random(v / (around + 1) * around + x);
    for (unsigned i = 0; i < 3; ++i) position.push_back(float(random.below(1 << 24)));
  }
  std::vector<float> normal = position;
  std::reverse(normal.begin(), normal.end());
  mesh.attributes = {test::attribute("position", Domain::vertex, Scalar::float32, 3, position),
                     test::attribute("normal", Domain::vertex, Scalar::float32, 3, normal)};
  const auto coded = encode(mesh);
  ASSERT_TRUE(coded.ok());
  EXPECT_GT(coded->report[0].welded_vertices, 0u);
  expect_fair({mesh}, {});
  EncodeOptions options;
  options.piece_faces = 9000;
  options.order = Order::keep;
  expect_fair({mesh}, options);
}

/// More values than there are elements, and more places than there are vertices.
TEST(Memory, StructuresThatClaimValues) {
  for (const unsigned bits : {20u, 24u, 28u, 31u}) {
    const std::uint64_t claimed = std::uint64_t(1) << bits;
    Payload attribute;
    attribute.u8(1).text("a").u8(1 | 4 | 8).u8(static_cast<std::uint32_t>(Scalar::uint8)).u8(1);
    attribute.u8(0).varint(claimed).varint(claimed << 2).stream(no_symbols).u8(0);
    attribute.raw(test::zstd_frame({}));
    expect_within_limits(FileBuilder()
                             .section(SectionKind::mesh, test::tetrahedron_mesh())
                             .section(SectionKind::attribute, attribute)
                             .finish());
    const Payload tetrahedron = test::tetrahedron_mesh();
    Payload welded;
    welded.u8(feature::welded).varint(claimed).varint(claimed + 1).stream(no_symbols);
    welded.raw(std::span(tetrahedron.bytes).subspan(2));
    expect_within_limits(FileBuilder().section(SectionKind::mesh, welded).finish());
  }
}

/// What encoding takes besides the mesh, results included.
template <class Input>
std::uint64_t encoding_peak(const Input& input, const EncodeOptions& options) {
  const std::int64_t before = held;
  peak = before;
  const auto coded = encode(input, options);
  EXPECT_TRUE(coded.ok());
  return static_cast<std::uint64_t>(peak - before);
}

/// Views are read where they are: values with 100 bytes between them, 1.5 MB apart from 25 MB,
/// take no more memory than a Mesh, and the same for one Mesh as for its view. Only 16-bit corners
/// are copied.
TEST(Memory, ViewsAreEncodedWithoutACopy) {
  struct Vertex {
    float position[3];
    char others[200];
  };
  Mesh mesh = corpus::grid(250, 250);
  ASSERT_LE(mesh.vertex_count, 0x10000u);
  std::vector<Vertex> vertices(mesh.vertex_count);
  std::vector<float> packed;
  for (std::uint32_t v = 0; v < mesh.vertex_count; ++v)
    for (unsigned i = 0; i < 3; ++i)
      packed.push_back(vertices[v].position[i] = static_cast<float>((i == 0 ? v : v * v) % 1000));
  mesh.attributes = {test::attribute("position", Domain::vertex, Scalar::float32, 3, packed)};
  const AttributeView position = attribute_view("position", vertices, &Vertex::position);
  MeshView view = mesh;
  view.attributes = std::span(&position, 1);
  const std::vector<std::uint16_t> corners(mesh.corners.begin(), mesh.corners.end());
  MeshView narrow = view;
  narrow.corners = {};
  narrow.corners_16 = corners;
  for (const std::optional<std::uint32_t> faces : {std::optional<std::uint32_t>(), {20000}}) {
    EncodeOptions options;
    options.piece_faces = faces;
    const std::uint64_t as_mesh = encoding_peak(mesh, options),
                        as_view = encoding_peak(view, options),
                        as_narrow = encoding_peak(narrow, options);
    EXPECT_LE(as_view, as_mesh + 1024);
    EXPECT_LE(as_narrow, as_mesh + 4 * corners.size() + 1024);
    EXPECT_GE(as_narrow, as_mesh + 3 * corners.size());  // a copy is seen here
  }
}

}  // namespace
}  // namespace clers::internal
