// Meshes coded in pieces: tiny ones, so that everything is a seam.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <map>
#include <set>
#include <tuple>

#include "codec/base/parallel.h"
#include "codec/compare.h"
#include "codec/file/mesh_encoder.h"
#include "codec/inspect.h"
#include "codec/pieces/partition.h"
#include "codec/pieces/piece_cutter.h"
#include "codec/pieces/seams.h"
#include "codec/test/decoding.h"
#include "codec/test/round_trip.h"
#include "corpus/generate.h"

namespace clers::internal {
namespace {

using test::decode_into;
using test::decode_pieces;

Attribute numbers(std::string name, Domain domain, std::size_t count) {
  Attribute a{std::move(name), domain, Scalar::uint16, 1, {}};
  for (std::size_t i = 0; i < count; ++i) {
    a.data.push_back(static_cast<std::byte>(i * 7));
    a.data.push_back(static_cast<std::byte>(i >> 8));
  }
  return a;
}

Mesh with_attributes(Mesh mesh) {
  mesh.attributes.push_back(numbers("at vertices", Domain::vertex, mesh.vertex_count));
  mesh.attributes.push_back(numbers("at corners", Domain::corner, mesh.corners.size()));
  mesh.attributes.push_back(numbers("at faces", Domain::face, mesh.face_count()));
  return mesh;
}

/// No two vertices at one place.
Mesh with_positions(Mesh mesh) {
  Attribute a{position_name, Domain::vertex, Scalar::float32, 3, {}};
  for (std::uint32_t v = 0; v < mesh.vertex_count; ++v) {
    const float p[3] = {static_cast<float>(v * 37 % 101), static_cast<float>(v),
                        -static_cast<float>(v * 17 % 61)};
    a.data.resize(a.data.size() + sizeof p);
    std::memcpy(a.data.data() + a.data.size() - sizeof p, p, sizeof p);
  }
  if (!mesh.position()) mesh.attributes.insert(mesh.attributes.begin(), std::move(a));
  return mesh;
}

struct Named {
  const char* name;
  Mesh mesh;
};

std::vector<Named> meshes() {
  const Mesh parts[] = {corpus::tetrahedron(), corpus::grid(2, 3), corpus::torus(3, 4)};
  std::vector<Named> all = {{"pair", corpus::glued_pair()},
                            {"ball", corpus::icosphere(1)},
                            {"shuffled grid", corpus::shuffle(corpus::grid(8, 7), 1)},
                            {"torus", corpus::flip_edges(corpus::torus(8, 7), 90, 2)},
                            {"holes", corpus::punch_holes(corpus::icosphere(2), 6, 3)},
                            {"gyroid", corpus::gyroid(1, 1, 1, 5, corpus::Ends::open)},
                            {"parts", corpus::disjoint_union(parts)},
                            {"moebius", corpus::moebius_strip(17, 3)},
                            {"fan", corpus::fan(90)},
                            {"book", corpus::book(15)},
                            {"chessboard", corpus::chessboard(6)},
                            {"loose", corpus::loose_triangles(40)},
                            {"soup", corpus::random_soup(19, 60, 3, 1)},
                            {"polygons", corpus::random_soup(80, 90, 7, 2)}};
  for (Named& m : all) m.mesh = with_attributes(with_positions(std::move(m.mesh)));
  all[3].mesh.vertex_count += 2;  // that no face uses
  all[3].mesh.attributes.clear();
  all[3].mesh = with_attributes(with_positions(std::move(all[3].mesh)));
  all[4].mesh.name = "with a name";
  return all;
}

EncodeOptions in_pieces(std::uint32_t faces, Order order = Order::free) {
  EncodeOptions options;
  options.piece_faces = faces;
  options.order = order;
  return options;
}

constexpr std::uint32_t piece_sizes[] = {1, 2, 5, 50};

TEST(Pieces, RoundTrips) {
  for (const auto& [name, mesh] : meshes())
    for (const std::uint32_t faces : piece_sizes)
      for (const Order order : {Order::free, Order::keep}) {
        SCOPED_TRACE(std::string(name) + ", " + std::to_string(faces) + " faces a piece" +
                     (order == Order::keep ? ", order kept" : ""));
        const EncodeOptions options = in_pieces(faces, order);
        auto coded = encode({&mesh, 1}, options);
        ASSERT_TRUE(coded.ok()) << describe(coded.error());
        auto out = decode(coded->bytes);
        ASSERT_TRUE(out.ok()) << describe(out.error());
        ASSERT_EQ(out->size(), 1u);
        expect_permuted(mesh, out->front(), coded->permutations[0]);
        const auto compared = compare(mesh, out->front());
        ASSERT_TRUE(compared.ok()) << describe(compared.error());
        EXPECT_NE(compared->verdict, Verdict::different);
        if (order == Order::keep) {
          EXPECT_EQ(out->front().corners, mesh.corners);
        }
        if (!is_manifold(mesh)) continue;
        auto again = encode(*out, options);
        ASSERT_TRUE(again.ok());
        EXPECT_TRUE(again->bytes == coded->bytes) << "encoding is not idempotent";
      }
}

/// Where the place of a vertex is its distance from others, the parts depend on the order: but what
/// comes back is the mesh.
TEST(Pieces, WithoutPositions) {
  for (auto [name, mesh] : meshes()) {
    std::erase_if(mesh.attributes, [](const Attribute& a) { return a.name == position_name; });
    for (const std::uint32_t faces : piece_sizes) {
      SCOPED_TRACE(name);
      auto coded = encode({&mesh, 1}, in_pieces(faces));
      ASSERT_TRUE(coded.ok()) << describe(coded.error());
      auto out = decode(coded->bytes);
      ASSERT_TRUE(out.ok()) << describe(out.error());
      expect_permuted(mesh, out->front(), coded->permutations[0]);
    }
  }
}

unsigned long_runs() {
  const char* n = std::getenv("CLERS_LONG");
  return n ? static_cast<unsigned>(std::strtoul(n, nullptr, 10)) : 1;
}

TEST(Pieces, SoupsSurvive) {
  for (unsigned seed = 0; seed < 300 * long_runs(); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Mesh mesh = corpus::random_soup(5 + seed % 40, 10 + seed % 90, seed % 2 ? 3 : 6, seed);
    mesh.attributes.clear();
    mesh = with_attributes(with_positions(std::move(mesh)));
    const EncodeOptions options = in_pieces(1 + seed % 23);
    auto coded = encode({&mesh, 1}, options);
    ASSERT_TRUE(coded.ok()) << describe(coded.error());
    auto out = decode(coded->bytes);
    ASSERT_TRUE(out.ok()) << describe(out.error());
    expect_permuted(mesh, out->front(), coded->permutations[0]);
  }
}

TEST(Pieces, AnyNumberOfThreadsGivesTheSameBytes) {
  std::vector<Mesh> all;
  for (auto& m : meshes()) all.push_back(std::move(m.mesh));
  for (const std::uint32_t faces : {7u, never_in_pieces}) {
    EncodeOptions options = in_pieces(faces);
    const auto expected = encode(all, options);
    ASSERT_TRUE(expected.ok());
    const auto expected_meshes = decode(expected->bytes);
    ASSERT_TRUE(expected_meshes.ok());
    for (const unsigned threads : {0u, 2u, 5u}) {
      options.threads = threads;
      double last = 0;
      options.progress = [&](std::string_view, double done) {
        EXPECT_GE(done, last);
        last = done;
      };
      const auto coded = encode(all, options);
      ASSERT_TRUE(coded.ok());
      EXPECT_TRUE(coded->bytes == expected->bytes);
      EXPECT_EQ(last, 1);
      DecodeOptions how;
      how.threads = threads;
      const auto out = decode(coded->bytes, how);
      ASSERT_TRUE(out.ok());
      for (std::size_t i = 0; i < all.size(); ++i) {
        EXPECT_EQ((*out)[i].corners, (*expected_meshes)[i].corners);
        for (std::size_t k = 0; k < (*out)[i].attributes.size(); ++k)
          EXPECT_EQ((*out)[i].attributes[k].data, (*expected_meshes)[i].attributes[k].data);
      }
    }
  }
}

/// One piece alone is its part of the whole.
TEST(Pieces, DecodeAlone) {
  std::vector<Mesh> all;
  for (auto& m : meshes()) all.push_back(std::move(m.mesh));
  all.push_back(Mesh{});
  const auto coded = encode(all, in_pieces(20));
  ASSERT_TRUE(coded.ok());
  const auto whole = decode(coded->bytes);
  ASSERT_TRUE(whole.ok());
  const auto decoder = Decoder::open(coded->bytes);
  ASSERT_TRUE(decoder.ok());
  const auto info = decoder->info();
  ASSERT_TRUE(info.ok());
  std::size_t count = 0, corners = 0, mesh_index = 0;
  const auto ok = decode_pieces(coded->bytes, [&](const Piece& piece) {
    SCOPED_TRACE("piece " + std::to_string(count));
    ++count;
    ASSERT_LT(piece.mesh_index, all.size());
    if (piece.mesh_index != mesh_index || piece.index == 0) corners = 0;
    mesh_index = piece.mesh_index;
    const Mesh &mesh = (*whole)[mesh_index], &part = piece.mesh;
    EXPECT_EQ(part.name, mesh.name);
    EXPECT_EQ(info->meshes[mesh_index].pieces, piece.count);
    const auto said = decoder->piece_info(count - 1);
    ASSERT_TRUE(said.ok());
    EXPECT_EQ(std::tie(said->mesh_index, said->index, said->count),
              std::tie(piece.mesh_index, piece.index, piece.count));
    EXPECT_EQ(said->vertices, part.vertex_count);
    EXPECT_EQ(said->faces, part.face_count());
    EXPECT_EQ(said->corners, part.corners.size());
    EXPECT_TRUE(!said->triangles_only || part.triangles_only());
    EXPECT_EQ(std::tie(said->first_vertex, said->first_face),
              std::tie(piece.first_vertex, piece.first_face));

    std::vector<std::uint32_t> number(part.vertex_count);
    std::uint32_t next = piece.first_vertex;
    auto shared = piece.seam.begin();
    for (std::uint32_t v = 0; v < number.size(); ++v) {
      const bool is_shared = shared != piece.seam.end() && shared->vertex == v;
      number[v] = is_shared ? shared++->number : next++;
      if (is_shared) {
        EXPECT_LT(number[v], piece.first_vertex);
      }
    }
    EXPECT_TRUE(shared == piece.seam.end());
    const std::size_t first_corner = corners;
    for (std::size_t f = 0; f < part.face_count(); ++f) {
      ASSERT_EQ(size_of_face(part, f), size_of_face(mesh, piece.first_face + f));
      for (std::uint32_t j = 0; j < size_of_face(part, f); ++j, ++corners)
        ASSERT_EQ(number[part.corners[corners - first_corner]], mesh.corners[corners]);
    }
    for (std::size_t k = 0; k < part.attributes.size(); ++k) {
      const Attribute &a = part.attributes[k], &b = mesh.attributes[k];
      for (std::size_t i = 0; i < a.data.size() / a.stride(); ++i)
        ASSERT_TRUE(equal(value(a, i), value(b, a.domain == Domain::vertex ? number[i]
                                                : a.domain == Domain::face ? piece.first_face + i
                                                                           : first_corner + i)));
    }
  });
  ASSERT_TRUE(ok.ok()) << describe(ok.error());
  EXPECT_GT(count, 50u);
  EXPECT_EQ(decoder->piece_count(), count);
  EXPECT_EQ(decoder->decode_piece(count).error().code, ErrorCode::bad_option);
  EXPECT_EQ(decoder->piece_info(count).error().code, ErrorCode::bad_option);
}

/// Every prefix is refused, and every altered byte; with right checksums too it is at least decoded
/// to something valid, which fuzz/decode_any.cc tries at length.
TEST(Pieces, DamageIsFound) {
  const Mesh mesh = with_attributes(with_positions(corpus::icosphere(1)));
  const auto coded = encode({&mesh, 1}, in_pieces(30));
  ASSERT_TRUE(coded.ok());
  for (std::size_t n = 0; n < coded->bytes.size(); ++n) {
    EXPECT_FALSE(decode(std::span(coded->bytes).first(n)).ok());
    auto bytes = coded->bytes;
    bytes[n] ^= std::byte(1 + n % 255);
    EXPECT_FALSE(n != 6 && decode(bytes).ok()) << n;  // byte 6 is the level, for information
  }
}

/// Sections of one's own, with right checksums.
class Forged {
 public:
  explicit Forged(std::span<const std::byte> bytes) {
    ContainerReader in(bytes);
    EXPECT_TRUE(in.open().ok());
    for (auto s = in.next(); s.ok() && s->kind != SectionKind::end; s = in.next())
      sections.push_back({s->kind, Bytes(s->payload.begin(), s->payload.end())});
  }
  Expected<std::vector<Mesh>> decoded(std::uint64_t meshes = 1, DecodeOptions options = {}) const {
    ContainerWriter out(5);
    for (const EncodedSection& s : sections) out.section(s.kind, s.payload);
    return decode(out.finish(meshes), options);
  }
  std::size_t find(SectionKind kind, std::size_t nth = 0) const {
    for (std::size_t i = 0;; ++i)
      if (sections[i].kind == kind && nth-- == 0) return i;
  }
  std::vector<EncodedSection> sections;
};

TEST(Pieces, InconsistentSectionsAreRefused) {
  Mesh mesh = with_positions(corpus::icosphere(2));
  mesh.name = "ball";
  const auto coded = encode({&mesh, 1}, in_pieces(120, Order::keep));
  ASSERT_TRUE(coded.ok());
  const Forged good(coded->bytes);
  ASSERT_TRUE(good.decoded().ok());
  const std::size_t seam = good.find(SectionKind::seam);
  const auto refused = [&](auto change) {
    Forged file = good;
    change(file.sections);
    const auto out = file.decoded();
    EXPECT_FALSE(out.ok());
    return out.ok() ? std::string() : describe(out.error());
  };
  using Sections = std::vector<EncodedSection>;
  const auto at = [](Sections& s, std::size_t i) {
    return s.begin() + static_cast<std::ptrdiff_t>(i);
  };
  // One more piece than there are, and one less.
  EXPECT_NE(refused([&](Sections& s) { s[0].payload[0] = std::byte(4); }), "");
  EXPECT_NE(refused([&](Sections& s) { s[0].payload[0] = std::byte(2); }), "");
  for (const unsigned n : {0u, 1u})
    EXPECT_NE(refused([&](Sections& s) { s[0].payload[0] = std::byte(n); }), "");
  EXPECT_NE(refused([&](Sections& s) { s.push_back(s[0]); }), "");
  // Without its seam a piece has more vertices than the order names; a seam of the first piece,
  // two, one after the values, more shared than there are.
  EXPECT_NE(refused([&](Sections& s) { s.erase(at(s, seam)); }), "");
  EXPECT_NE(refused([&](Sections& s) { s.insert(at(s, 2), s[seam]); }), "");
  EXPECT_NE(refused([&](Sections& s) { s.insert(at(s, seam), s[seam]); }), "");
  EXPECT_NE(refused([&](Sections& s) { std::swap(s[seam], s[seam + 1]); }), "");
  EXPECT_NE(refused([&](Sections& s) { s[seam].payload[0] = std::byte(127); }), "");
  EXPECT_NE(refused([&](Sections& s) { s[seam].payload[0] ^= std::byte(1); }), "");
  // Values that only one piece has, a name and an order in front of the last piece.
  EXPECT_NE(refused([&](Sections& s) { s.erase(at(s, good.find(SectionKind::attribute))); }), "");
  EXPECT_NE(refused([&](Sections& s) { s.insert(at(s, 2), {SectionKind::name, {}}); }), "");
  EXPECT_NE(refused([&](Sections& s) { s.insert(at(s, 2), s.back()); }), "");
  // Limits are for the whole.
  DecodeOptions options;
  options.limits.faces = 200;
  EXPECT_EQ(good.decoded(1, options).error().code, ErrorCode::limit);
  options = {};
  options.limits.vertices = 100;
  EXPECT_EQ(good.decoded(1, options).error().code, ErrorCode::limit);
}

TEST(Seams, VerticesTwiceOrBeyondAreRefused) {
  const Mesh mesh = with_positions(corpus::grid(6, 6));
  const auto coded = encode({&mesh, 1}, in_pieces(36));
  ASSERT_TRUE(coded.ok());
  Forged file(coded->bytes);
  const std::size_t seam = file.find(SectionKind::seam);
  const auto with_runs = [&](std::vector<SeamRun> runs) {
    Bytes payload;
    std::uint32_t shared = 0;
    rans::Encoder stream;
    EncodeTo coder(stream);
    SeamModel model;
    for (const SeamRun& run : runs) {
      model.code(coder, run);
      shared += run.count;
    }
    put_varint(payload, shared);
    stream.finish(payload);
    file.sections[seam].payload = payload;
    return file.decoded().ok();
  };
  EXPECT_TRUE(with_runs({{0, 3, 2, true}, {5, 9, 1, true}}));
  EXPECT_FALSE(with_runs({{0, 3, 2, true}, {5, 2, 1, true}}));  // 2 twice
  EXPECT_FALSE(with_runs({{0, 1, 3, true}}));                   // below 0
  EXPECT_FALSE(with_runs({{0, 100, 1, true}}));                 // of no piece before
  EXPECT_FALSE(with_runs({{3, 3, 2, true}, {0, 9, 1, true}}));  // out of order
  EXPECT_FALSE(with_runs({{24, 3, 8, false}}));                 // more vertices than it has
  EXPECT_FALSE(with_runs({{0xffffffffu, 3, 1, true}}));
  EXPECT_FALSE(with_runs({{0, 0xffffffffu, 2, false}}));
}

/// Index buffers of the caller hold what decode gives, and opposites what brute force finds.
TEST(DecodeInto, IsWhatDecodeGives) {
  for (const auto& [name, mesh] : meshes())
    for (const std::uint32_t faces : {15u, never_in_pieces})
      for (const Order order : {Order::free, Order::keep}) {
        SCOPED_TRACE(name);
        auto coded = encode({&mesh, 1}, in_pieces(faces, order));
        ASSERT_TRUE(coded.ok());
        const auto whole = decode(coded->bytes);
        ASSERT_TRUE(whole.ok());
        const Mesh& expected = whole->front();
        std::vector<std::uint32_t> wide(expected.corners.size());
        std::vector<std::uint16_t> narrow(wide.size());
        std::vector<std::uint32_t> opposites(wide.size(), 7);
        DecodeOptions two;
        two.threads = 2;
        const auto ok = decode_into(coded->bytes, {.corners = wide, .opposites = opposites}, two);
        ASSERT_EQ(ok.ok(), expected.triangles_only());
        if (!ok) {
          EXPECT_EQ(ok.error().code, ErrorCode::bad_option);
          continue;
        }
        EXPECT_EQ(wide, expected.corners);
        ASSERT_TRUE(decode_into(coded->bytes, {.corners_16 = narrow}).ok());
        EXPECT_TRUE(std::equal(narrow.begin(), narrow.end(), wide.begin()));
        if (std::string(name) == "pair") continue;  // its edges are not told apart by their ends
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::uint32_t>> sides;
        const auto end = [&](std::uint32_t h) { return wide[h % 3 == 2 ? h - 2 : h + 1]; };
        for (std::uint32_t h = 0; h < wide.size(); ++h)
          sides[std::minmax(wide[h], end(h))].push_back(h);
        for (const auto& [ends, all] : sides)
          for (std::size_t i = 0; i < all.size(); ++i) {
            const bool has = all.size() == 2 && wide[all[0]] != wide[all[1]];
            EXPECT_EQ(opposites[all[i]], has ? all[1 - i] : MeshTarget::no_opposite);
          }
        wide.push_back(0);
        EXPECT_EQ(decode_into(coded->bytes, {.corners = wide}).error().code, ErrorCode::bad_option);
      }
}

/// The parts are those of the faces, whatever their order.
TEST(Partition, DependsOnPlacesOnly) {
  for (const auto& [name, mesh] : meshes())
    for (const std::uint32_t faces : piece_sizes) {
      SCOPED_TRACE(name);
      const Mesh other = corpus::shuffle(mesh, 9);
      const auto parts = [&](const Mesh& m) {
        // A face by the values of its vertices, which no two share.
        std::vector<std::uint32_t> begin = {0};
        for (std::size_t f = 0; f < m.face_count(); ++f)
          begin.push_back(begin.back() + size_of_face(m, f));
        std::vector<std::multiset<std::multiset<std::string>>> all;
        const Partition p = partition(m, faces);
        for (std::size_t i = 0; i < p.count(); ++i) {
          all.emplace_back();
          for (const std::uint32_t f : p.piece(i)) {
            std::multiset<std::string> corners;
            for (std::uint32_t h = begin[f]; h < begin[f + 1]; ++h) {
              const auto bytes = value(*m.position(), m.corners[h]);
              corners.emplace(reinterpret_cast<const char*>(bytes.data()), bytes.size());
            }
            all.back().insert(corners);
          }
        }
        return all;
      };
      EXPECT_EQ(parts(mesh), parts(other));
    }
}

TEST(Partition, PartsAreOfTheSizeAskedFor) {
  const Mesh torus = corpus::shuffle(corpus::torus(200, 150), 1);
  Mesh nowhere = torus;
  nowhere.attributes.clear();
  for (const Mesh& mesh : {torus, nowhere})
    for (const std::uint32_t faces : {100u, 1000u, 9999u, 59999u}) {
      const Partition parts = partition(mesh, faces);
      const std::size_t expected = (mesh.face_count() + faces - 1) / faces;
      EXPECT_EQ(parts.count(), expected);
      const std::size_t share = mesh.face_count() / expected;
      for (std::size_t i = 0; i < parts.count(); ++i) {
        const std::size_t size = parts.piece(i).size();
        EXPECT_LT(size, faces < 1000 ? share * 3 / 2 : share * 11 / 10);
        EXPECT_GT(size, faces < 1000 ? share / 2 : share * 9 / 10);
      }
    }
}

Mesh without_positions(Mesh mesh) {
  mesh.attributes.clear();
  return mesh;
}

/// A strip that is rolled up: planes would cut it at every turn, but seven cuts across it make
/// eight pieces.
TEST(Partition, FollowsTheSurface) {
  constexpr std::uint32_t length = 1600, width = 20;
  Mesh mesh = corpus::grid(length, width);
  const auto place = [&](std::uint32_t v, unsigned axis) {
    return mesh.attributes[0].data.data() + (3 * std::size_t(v) + axis) * sizeof(float);
  };
  for (std::uint32_t v = 0; v < mesh.vertex_count; ++v) {
    float x, y;
    std::memcpy(&x, place(v, 0), sizeof x);
    std::memcpy(&y, place(v, 1), sizeof y);
    const float turn = x / static_cast<float>(length) * 60, radius = 10 + turn;
    const float p[3] = {radius * std::cos(turn), radius * std::sin(turn), y};
    std::memcpy(place(v, 0), p, sizeof p);
  }
  mesh = corpus::shuffle(mesh, 5);
  for (const Mesh& m : {mesh, without_positions(mesh)}) {
    const PieceCutter cutter(m, partition(m, static_cast<std::uint32_t>(m.face_count() / 8)));
    ASSERT_EQ(cutter.count(), 8u);
    std::size_t vertices = 0;
    std::vector<std::uint32_t> number;
    for (std::size_t i = 0; i < cutter.count(); ++i) {
      const Mesh piece = cutter.cut(i, number).mesh;
      vertices += piece.vertex_count;
      const auto shape = measure(piece);
      ASSERT_TRUE(shape.ok());
      EXPECT_EQ(shape->surface.components, 1u);
      EXPECT_EQ(shape->surface.boundary_curves, 1u);
    }
    EXPECT_LE(vertices - m.vertex_count, 2 * 7 * (width + 1));
  }
}

/// Coordinates of any size and kind: planes, too, that no number of a float can be far from.
TEST(Partition, AnyCoordinates) {
  const Mesh ball = corpus::icosphere(5);
  const auto curves = [](const Mesh& mesh) {
    const PieceCutter cutter(mesh, partition(mesh, 3000));
    EXPECT_EQ(cutter.count(), 7u);
    std::vector<std::uint32_t> number;
    std::size_t vertices = 0;
    for (std::size_t i = 0; i < cutter.count(); ++i) {
      vertices += cutter.cut(i, number).mesh.vertex_count;
      EXPECT_LT(cutter.faces(i).size(), 3300u);
    }
    return vertices - mesh.vertex_count;
  };
  const std::size_t expected = curves(ball);
  const auto with = [&](auto scalar_of, Scalar scalar) {
    Mesh mesh = ball;
    Attribute& a = mesh.attributes[0];
    a.scalar = scalar;
    std::vector<std::byte> data;
    for (std::size_t i = 0; i < 3 * std::size_t(mesh.vertex_count); ++i) {
      float x;
      std::memcpy(&x, a.data.data() + 4 * i, 4);
      const auto value = scalar_of(x);
      const auto bytes = std::as_bytes(std::span(&value, 1));
      data.insert(data.end(), bytes.begin(), bytes.end());
    }
    a.data = std::move(data);
    return curves(mesh);
  };
  for (const float unit : {1e-41f, 1e-30f, 1e-3f, 1e5f, 1e30f})
    EXPECT_LE(with([&](float x) { return x * unit; }, Scalar::float32), expected * 3 / 2) << unit;
  EXPECT_LE(with([](float x) { return x + 1000; }, Scalar::float32), expected * 3 / 2);
  EXPECT_LE(with([](float x) { return x * 1e200; }, Scalar::float64), expected * 3 / 2);
  EXPECT_LE(with([](float x) { return static_cast<std::int16_t>(x * 30000); }, Scalar::int16),
            expected * 3 / 2);
  EXPECT_LE(with([](float x) { return static_cast<std::int64_t>(x * 1e15f); }, Scalar::int64),
            expected * 3 / 2);
  with([](float x) { return x > 0.9f ? std::nanf("") : x; }, Scalar::float32);
}

TEST(Partition, SmallComponentsStayWhole) {
  std::vector<Mesh> balls;
  for (int i = 0; i < 60; ++i) {
    Mesh ball = corpus::icosphere(1);
    for (std::size_t c = 0; c < 3 * std::size_t(ball.vertex_count); ++c) {
      float x;
      std::memcpy(&x, ball.attributes[0].data.data() + 4 * c, 4);
      x += static_cast<float>(i * (c % 3 == 0 ? 0.7 : 0.1));
      std::memcpy(ball.attributes[0].data.data() + 4 * c, &x, 4);
    }
    balls.push_back(std::move(ball));
  }
  const Mesh mesh = corpus::disjoint_union(balls);
  const Partition parts = partition(mesh, 1000);
  EXPECT_GT(parts.count(), 2u);
  std::map<std::uint32_t, std::set<std::size_t>> of_ball;
  for (std::size_t i = 0; i < parts.count(); ++i)
    for (const std::uint32_t f : parts.piece(i)) of_ball[f / 80].insert(i);
  for (const auto& [ball, in] : of_ball) EXPECT_EQ(in.size(), 1u) << ball;
}

RC_GTEST_PROP(Seams, RunsComeBack, ()) {
  const auto numbers = *rc::gen::container<std::vector<std::uint32_t>>(
      rc::gen::oneOf(rc::gen::inRange(0u, 30u), rc::gen::arbitrary<std::uint32_t>()));
  const std::uint32_t first_own = *rc::gen::inRange(1u, 40u);
  const std::vector<SeamRun> runs = seam_runs(numbers, first_own);
  std::vector<std::byte> bytes;
  {
    rans::Encoder stream;
    EncodeTo coder(stream);
    SeamModel model;
    for (const SeamRun& run : runs) model.code(coder, run);
    stream.finish(bytes);
  }
  rans::Decoder in(bytes);
  DecodeFrom coder(in);
  SeamModel model;
  std::vector<std::uint32_t> expected, found(numbers.size(), first_own);
  for (const std::uint32_t v : numbers) expected.push_back(std::min(v, first_own));
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const SeamRun run = model.code(coder, {});
    for (std::uint32_t k = 0; k < run.count; ++k) found[run.first + k] = run.global_at(k);
  }
  RC_ASSERT(in.finished());
  RC_ASSERT(found == expected);
}

TEST(Parallel, EveryItemOnceAndExceptionsComeBack) {
  for (const unsigned threads : {0u, 1u, 3u}) {
    std::vector<std::atomic<int>> times(1000);
    for_each_item(times.size(), threads, [&](std::size_t i, unsigned worker) {
      EXPECT_LT(worker, worker_count(threads, times.size()));  // 0: one a core
      ++times[i];
    });
    for (const auto& n : times) EXPECT_EQ(n, 1);
    const auto failing = [](std::size_t i, unsigned) {
      if (i == 77) throw std::bad_alloc();
    };
    EXPECT_THROW(for_each_item(1000, threads, failing), std::bad_alloc);
  }
}

TEST(Inspect, CountsPieces) {
  Mesh mesh = corpus::punch_holes(corpus::torus(20, 12), 3, 1);
  auto coded = encode({&mesh, 1}, in_pieces(60));
  ASSERT_TRUE(coded.ok());
  auto info = inspect(coded->bytes);
  ASSERT_TRUE(info.ok());
  auto shape = measure(mesh);
  ASSERT_TRUE(shape.ok());
  const MeshInfo &a = info->file.meshes[0], &b = coded->report[0];
  EXPECT_EQ(a.pieces, 8u);
  EXPECT_EQ(b.pieces, 8u);
  EXPECT_EQ(info->meshes[0].shape.surface.genus, shape->surface.genus);
  EXPECT_EQ(info->meshes[0].shape.surface.boundary_curves, shape->surface.boundary_curves);
  EXPECT_EQ(a.vertices, b.vertices);
  EXPECT_EQ(a.corners, b.corners);
  EXPECT_EQ(info->meshes[0].counts.symbols, coded->counts[0].symbols);
  EXPECT_EQ(a.connectivity_bytes, b.connectivity_bytes);
  EXPECT_EQ(a.position_bytes, b.position_bytes);
  ASSERT_EQ(a.attributes.size(), b.attributes.size());
  for (std::size_t i = 0; i < a.attributes.size(); ++i) {
    EXPECT_EQ(a.attributes[i].count, b.attributes[i].count);
    EXPECT_EQ(a.attributes[i].bytes, b.attributes[i].bytes);
  }
  EXPECT_EQ(info->file.overhead_bytes + a.connectivity_bytes + a.position_bytes + a.attribute_bytes,
            info->file.total_bytes);
}

}  // namespace
}  // namespace clers::internal
