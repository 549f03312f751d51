// What codes the symbols: models of all levels, the mixer under level 9, the range coder.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>
#include <vector>

#include "codec/connectivity/connectivity.h"
#include "codec/entropy/logistic.h"
#include "codec/entropy/mixer.h"
#include "codec/entropy/rans.h"
#include "codec/soup/adjacency.h"
#include "corpus/generate.h"

namespace clers::internal {
namespace {

constexpr int levels[] = {1, 3, 5, 9};

std::vector<std::byte> coded(const Mesh& mesh, int level) {
  auto twins = find_twins({mesh.corners, mesh.face_sizes}, mesh.vertex_count);
  EXPECT_TRUE(twins.ok());
  auto encoded = encode_connectivity({mesh.corners, *twins, mesh.vertex_count}, level);
  EXPECT_TRUE(encoded.ok());
  return encoded->bytes;
}

/// Models are integers: these hashes hold for every compiler, build and machine, with and without
/// SIMD.
TEST(Levels, StreamsAreTheSameEverywhere) {
  const Mesh meshes[] = {corpus::flip_edges(corpus::icosphere(5), 4000, 1),
                         corpus::punch_holes(corpus::torus(60, 40), 20, 2),
                         corpus::gyroid(2, 2, 1, 12, corpus::Ends::open),
                         corpus::copies(corpus::flip_edges(corpus::icosphere(2), 100, 3), 30)};
  constexpr std::uint64_t expected[] = {15442063474598362110u, 1305011713142362185u,
                                        18153962323268303921u, 4059601029861293422u};
  for (unsigned i = 0; i < 4; ++i) {
    std::uint64_t hash = 0xcbf29ce484222325u;  // FNV-1a
    for (const Mesh& mesh : meshes)
      for (const std::byte b : coded(mesh, levels[i]))
        hash = (hash ^ std::to_integer<std::uint64_t>(b)) * 0x100000001b3u;
    EXPECT_EQ(hash, expected[i]) << "level " << levels[i];
  }
}

TEST(Levels, SmallMeshesCostAHandful) {
  const struct {
    Mesh mesh;
    std::size_t bytes;
  } cases[] = {{corpus::single_triangle(), 6},
               {corpus::tetrahedron(), 6},
               {corpus::icosphere(0), 9},
               {corpus::grid(3, 3), 10}};
  for (const auto& [mesh, bytes] : cases)
    for (const int level : {3, 5, 9})
      EXPECT_LE(coded(mesh, level).size(), bytes) << mesh.face_count() << " faces, level " << level;
}

/// A higher level is not larger: the encoder tries what the lower ones would do.
TEST(Levels, NineIsNeverLargerThanFive) {
  for (unsigned n = 1; n <= 12; ++n) {
    const Mesh mesh = corpus::flip_edges(corpus::torus(n + 2, n + 3), 10 * n, n);
    EXPECT_LE(coded(mesh, 9).size(), coded(mesh, 5).size()) << n;
    EXPECT_EQ(coded(mesh, 5), coded(mesh, 7));
    EXPECT_EQ(coded(mesh, 3), coded(mesh, 4));
    EXPECT_EQ(coded(mesh, 1), coded(mesh, 2));
  }
}

/// Nor is any other, by more than 1 % or 16 bytes: not where nearly every symbol is foreseen, nor
/// where there is little to learn from.
TEST(Levels, AreInOrder) {
  std::vector<Mesh> meshes = {corpus::strip(3000),
                              corpus::torus(150, 100),
                              corpus::lattice(5),
                              corpus::copies(corpus::cylinder(12, 20), 30),
                              corpus::copies(corpus::flip_edges(corpus::icosphere(1), 20, 1), 40),
                              corpus::gyroid(1, 1, 1, 16, corpus::Ends::open)};
  for (std::uint32_t n = 4; n <= 128; n *= 2) {
    meshes.push_back(corpus::grid(n, n));
    for (const std::uint64_t flips : {1u, 3u, 10u, 30u, 100u})
      meshes.push_back(corpus::flip_edges(corpus::grid(n, n), flips * n / 8, n));
  }
  for (const Mesh& mesh : meshes) {
    std::size_t below = ~std::size_t(0) / 2;
    for (const int level : levels) {
      const std::size_t size = coded(mesh, level).size();
      EXPECT_LE(size, below + std::max<std::size_t>(16, below / 100))
          << mesh.face_count() << " faces, level " << level;
      below = size;
    }
  }
}

TEST(Mixer, VectorsComputeWhatThePlainLoopsDo) {
  std::mt19937 random(1);
  for (int round = 0; round < 1000; ++round) {
    constexpr unsigned n = 56;
    alignas(16) std::array<std::int16_t, n> x;
    alignas(16) std::array<std::int32_t, n> w, other;
    for (auto& v : x) v = static_cast<std::int16_t>(int(random() % 8193) - 4096);
    for (auto& v : w) v = static_cast<std::int32_t>(random());
    if (round % 3 == 0) w.fill(round % 2 ? INT32_MAX : INT32_MIN);
    other = w;
    EXPECT_EQ(mixer::dot(x.data(), w.data(), n), mixer::portable::dot(x.data(), w.data(), n));
    const auto e = static_cast<std::int16_t>(int(random() % 65535) - 32767);
    mixer::train(x.data(), w.data(), n, e);
    mixer::portable::train(x.data(), other.data(), n, e);
    EXPECT_EQ(w, other);
  }
}

TEST(Logistic, SquashAndStretchAreInverseAndSteady) {
  EXPECT_EQ(logistic.squash(0), 32768);
  EXPECT_EQ(logistic.squash(-max_logit - 1), logistic.squash(-max_logit));
  for (int x = -max_logit; x < max_logit; ++x) {
    EXPECT_LE(logistic.squash(x), logistic.squash(x + 1));
    EXPECT_EQ(logistic.squash(x) + logistic.squash(-x), 65536);
  }
  for (std::uint32_t p = 1; p < 1u << 22; p += 1023) {
    EXPECT_LE(logistic.stretch(p), logistic.stretch(p + 1023 < 1u << 22 ? p + 1023 : p));
    EXPECT_NEAR(logistic.squash(logistic.stretch(p)), p / 64.0, 200) << p;
  }
}

/// Streams of every length, the shortest of a state alone, come back; cut short or altered they do
/// not pass.
TEST(Rans, StreamsOfEveryLength) {
  std::mt19937 random(2);
  std::size_t tried = 0;
  for (std::size_t n = 0; n < 200; ++n) {
    rans::Encoder encoder;
    for (std::size_t i = 0; i < n; ++i) {
      const auto start = static_cast<std::uint32_t>(random() % 32000);
      const auto size = static_cast<std::uint32_t>(1 + random() % (32767 - start));
      encoder.put(start, size);
    }
    std::vector<std::byte> bytes;
    encoder.finish(bytes);
    const auto decodes = [&](std::span<const std::byte> stream) {
      rans::Decoder decoder(stream);
      for (const rans::Interval interval : encoder.intervals()) {
        if (decoder.slot() - interval.start >= interval.size) return false;
        decoder.advance(interval.start, interval.size);
      }
      return decoder.finished();
    };
    ASSERT_TRUE(decodes(bytes)) << n;
    for (std::size_t k = 0; k < bytes.size(); ++k) {
      ASSERT_FALSE(decodes(std::span(bytes).first(k))) << n;
      bytes[k] ^= std::byte{16};
      ASSERT_FALSE(decodes(bytes)) << n;
      bytes[k] ^= std::byte{16};
      ++tried;
    }
  }
  EXPECT_GT(tried, 1000u);
}

}  // namespace
}  // namespace clers::internal
