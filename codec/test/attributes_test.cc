// What attributes are predicted from, by plain definitions; and that threads change nothing.
#include <gtest/gtest.h>
#include <zstd.h>

#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <vector>

#include "codec/attributes/attribute_decoder.h"
#include "codec/attributes/attribute_encoder.h"
#include "codec/attributes/parallelograms.h"
#include "codec/attributes/prediction.h"
#include "codec/connectivity/connectivity.h"
#include "codec/decode.h"
#include "codec/encode.h"
#include "codec/soup/adjacency.h"
#include "codec/soup/raw_faces.h"
#include "codec/test/attribute.h"
#include "codec/test/coded_surfaces.h"
#include "codec/test/file_builder.h"
#include "corpus/generate.h"
#include "corpus/random.h"

namespace clers::internal {
namespace {

using test::coded;
using test::coded_surfaces;
using Surface = CodedArrays;

/// The order of first use, by a search.
std::vector<std::uint32_t> first_uses(std::span<const std::uint32_t> corners) {
  std::vector<std::uint32_t> order;
  for (const std::uint32_t v : corners)
    if (std::find(order.begin(), order.end(), v) == order.end()) order.push_back(v);
  return order;
}

using Triple = std::array<std::uint32_t, 3>;

/// All that for_each_parallelogram should find, in no order: corners with v that sides at v connect
/// with the first one, grown until no more come.
std::vector<Triple> parallelograms(const Surface& s, std::uint32_t v,
                                   const std::map<std::uint32_t, std::size_t>& place) {
  const auto n = static_cast<std::uint32_t>(s.corners.size());
  std::vector<bool> around(n);
  around[static_cast<std::size_t>(std::find(s.corners.begin(), s.corners.end(), v) -
                                  s.corners.begin())] = true;
  for (bool changed = true; changed;) {
    changed = false;
    for (std::uint32_t i = 0; i < n; ++i) {
      const HalfEdge h(i), out = s.twins[i];
      if (!out) continue;
      // h leaves its corner, and the twin arrives there: at the corner after the twin's.
      const std::uint32_t j = lnext(out).index();
      if (around[i] == around[j]) continue;
      around[i] = around[j] = changed = true;
    }
  }
  std::vector<Triple> found;
  for (std::uint32_t i = 0; i < n; ++i) {
    if (!around[i]) continue;
    const HalfEdge side = lnext(HalfEdge(i)), across = s.twins[side.index()];
    if (!across) continue;
    const Triple abc = {s.corners[side.index()], s.corners[lnext(side).index()],
                        s.corners[lprev(across).index()]};
    if (std::all_of(abc.begin(), abc.end(),
                    [&](std::uint32_t u) { return place.at(u) < place.at(v); }))
      found.push_back(abc);
  }
  std::sort(found.begin(), found.end());
  return found;
}

TEST(Introduction, IsInTheOrderOfFirstUse) {
  for (const Surface& s : coded_surfaces()) {
    const std::vector<std::uint32_t> expected = first_uses(s.corners);
    std::vector<std::uint32_t> order;
    for_each_introduced(s.view(), [&](std::uint32_t t, unsigned i) {
      order.push_back(s.corners[3 * std::size_t(t) + i]);
      EXPECT_EQ(s.introduced_by[order.back()], t);
    });
    ASSERT_EQ(order, expected);
    for (std::size_t i = 0; i < order.size(); i += 3)
      for (std::size_t j = 0; j < order.size(); ++j)
        ASSERT_EQ(s.view().before(order[i], order[j]), i < j);
  }
}

TEST(Parallelograms, EndAtVerticesIntroducedLater) {
  std::size_t found = 0, several = 0;
  for (const Surface& s : coded_surfaces()) {
    const std::vector<std::uint32_t> order = first_uses(s.corners);
    std::map<std::uint32_t, std::size_t> place;
    for (std::size_t i = 0; i < order.size(); ++i) place[order[i]] = i;
    for (const std::uint32_t v : order) {
      std::vector<Triple> triples;
      for_each_parallelogram(s.view(), v, [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        triples.push_back({a, b, c});
      });
      std::sort(triples.begin(), triples.end());
      ASSERT_EQ(triples, parallelograms(s, v, place));
      found += triples.size();
      several += triples.size() > 1;
    }
  }
  EXPECT_GT(found, 3000u);
  EXPECT_GT(several, 500u);
}

/// Guesses of the format, word for word: codec/format.md, "Attributes".
std::vector<std::array<std::uint32_t, 4>> guesses(std::span<const std::uint32_t> corners,
                                                  std::uint32_t vertices) {
  std::vector<std::array<std::uint32_t, 4>> result;
  std::vector<bool> seen(vertices);
  std::uint32_t last = 0;
  for (std::size_t h = 0; h < corners.size(); ++h) {
    const std::uint32_t v = corners[h];
    if (seen[v]) continue;
    seen[v] = true;
    std::uint32_t a = last, b = last, c = last;
    if (result.empty()) {
      a = b = c = v;
    } else if (h % 3 == 2 && h > 2) {
      const auto face = corners.subspan(h - 2, 2), before = corners.subspan(h - 5, 3);
      a = b = c = face[1];
      for (unsigned side = 1; side < 3; ++side)
        if (before[side] == face[1] && before[(side + 1) % 3] == face[0])
          a = face[0], c = before[side - 1];
    } else if (h % 3 > 0) {
      a = b = c = corners[h - 1];
    }
    result.push_back({v, a, b, c});
    last = v;
  }
  for (std::uint32_t v = 0; v < vertices; ++v)
    if (const std::uint32_t before = v == 0 ? v : v - 1; !seen[v])
      result.push_back({v, before, before, before});
  return result;
}

void expect_guesses(const CodedSurface& surface, std::uint32_t vertices) {
  std::vector<std::array<std::uint32_t, 4>> found;
  for_each_predicted_vertex(surface, vertices, [&](std::uint32_t v, Prediction from) {
    found.push_back({v, from.a, from.b, from.c});
  });
  ASSERT_EQ(found, guesses(surface.corners, vertices));
}

TEST(Prediction, IsAsTheFormatSays) {
  for (const Surface& s : coded_surfaces())
    expect_guesses(s.view(), static_cast<std::uint32_t>(s.introduced_by.size()));
}

/// Triangles of any vertices, as fans of raw faces are: some twice in one, some in none.
TEST(Prediction, IsAsTheFormatSaysWithoutASurface) {
  for (std::uint64_t seed = 0; seed < 2000; ++seed) {
    corpus::Random random(seed);
    const std::uint32_t vertices = 1 + random.below(12);
    Surface s;
    s.corners.resize(3 * std::size_t(random.below(12)));
    for (std::uint32_t& v : s.corners) v = random.below(vertices);
    s.introduced_by.resize(vertices);
    find_introducing(s.corners, s.introduced_by);
    expect_guesses(s.view(), vertices + 2);
  }
}

/// Both steps of decoding.
Expected<Attribute> decoded_attribute(std::span<const std::byte> bytes, std::uint64_t count,
                                      const CodedSurface& surface) {
  const auto header = read_attribute_header(bytes, 0);
  if (!header) return Failure{header.error()};
  if (auto ok = check_values(bytes, 0, *header, count); !ok) return Failure{ok.error()};
  auto begun = begin_attribute(bytes, 0, *header, count);
  if (!begun) return Failure{begun.error()};
  return finish_attribute(bytes, 0, *header, count, std::move(*begun), {surface});
}

TEST(Attributes, ComeBackByAnyPredictor) {
  const Surface s = coded(corpus::punch_holes(corpus::torus(11, 8), 5, 1));
  const auto vertices = static_cast<std::uint32_t>(s.introduced_by.size());
  corpus::Random random(1);
  for (unsigned scalar = 0; scalar < scalar_count; ++scalar)
    for (const unsigned components : {1u, 2u, 3u, 4u, 255u})
      for (const char* name : {position_name, "other"}) {
        std::vector<std::byte> values(vertices * components * size_of(Scalar(scalar)));
        for (std::byte& b : values) b = std::byte(random.below(256));
        Attribute in{name, Domain::vertex, Scalar(scalar), std::uint8_t(components), values};
        for (int level = 1; level <= (components == 255 ? 5 : 9); level += 2) {
          const auto coded = encode_attribute(in, {}, {s.view()}, level);
          ASSERT_TRUE(coded.ok());
          const auto out = decoded_attribute(coded->bytes, vertices, s.view());
          ASSERT_TRUE(out.ok()) << describe(out.error());
          EXPECT_EQ(out->data, in.data);
          EXPECT_EQ(out->name, in.name);
        }
      }
}

/// Raw faces of two corners have no triangle: all vertices are predicted as isolated ones are.
TEST(Attributes, FacesWithoutTrianglesPredictNothing) {
  const std::vector<std::uint32_t> corners = {0, 2, 1, 3}, sizes = {2, 2};
  test::Payload values;
  values.u8(1).text("a").u8(0).u8(static_cast<std::uint32_t>(Scalar::uint8)).u8(1);
  values.u8(static_cast<std::uint32_t>(Coder::words));
  values.u8(static_cast<std::uint32_t>(Predictor::parallelogram));
  const Bytes residuals = {std::byte{10}, std::byte{2}, std::byte{4}, std::byte{6}};
  values.raw(test::zstd_frame(residuals));
  test::FileBuilder file;
  file.section(SectionKind::mesh,
               test::Payload().u8(feature::raw).raw(encode_raw(Cycles(corners, sizes), 2, 4)));
  file.section(SectionKind::attribute, values);
  const auto out = decode(file.finish());
  ASSERT_TRUE(out.ok()) << describe(out.error());
  ASSERT_EQ(out->front().corners, corners);
  const Bytes expected = {std::byte{10}, std::byte{11}, std::byte{13}, std::byte{16}};
  EXPECT_EQ(out->front().attributes[0].data, expected);
}

/// Which error is reported does not depend on threads: that of the faces, else of the first
/// attribute.
TEST(Attributes, ErrorsDoNotDependOnThreads) {
  const Mesh mesh = corpus::grid(150, 100);
  std::vector<HalfEdge> twins = *find_twins({mesh.corners, {}}, mesh.vertex_count);
  Bytes connectivity = encode_connectivity({mesh.corners, twins, mesh.vertex_count}, 5)->bytes;
  const Bytes good = test::zstd_frame(Bytes(mesh.vertex_count));
  // A frame that does not say its size, with one block of a repeated byte: one value too few, which
  // nobody knows before it is unpacked.
  Bytes bad;
  put_u32(bad, ZSTD_MAGICNUMBER);
  for (const std::uint32_t byte : {0u, 0x38u}) put_u8(bad, byte);
  const std::uint32_t block = (mesh.vertex_count - 1) << 3 | 1 << 1 | 1;
  for (const std::uint32_t byte : {block & 0xff, block >> 8 & 0xff, block >> 16, 0u})
    put_u8(bad, byte);
  for (const bool broken_faces : {false, true}) {
    if (broken_faces) connectivity[connectivity.size() / 2] ^= std::byte{0x10};
    std::vector<std::string> errors;
    for (const unsigned threads : {1u, 2u, 3u, 8u}) {
      test::FileBuilder file;
      file.section(SectionKind::mesh, test::Payload().u8(0).varint(0).raw(connectivity));
      for (const Bytes& frame : {good, bad, good, bad})
        file.section(SectionKind::attribute,
                     test::attribute_section("a", Domain::vertex, Scalar::uint8, 1, frame));
      DecodeOptions options;
      options.threads = threads;
      const auto out = decode(file.finish(), options);
      ASSERT_FALSE(out.ok());
      errors.push_back(describe(out.error()));
      EXPECT_EQ(errors.back(), errors.front());
    }
    EXPECT_EQ(errors.front().find("the values take 15250") == std::string::npos, broken_faces)
        << errors.front();
  }
}

}  // namespace
}  // namespace clers::internal
