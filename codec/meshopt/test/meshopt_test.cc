// What meshoptimizer compressed comes back; anything else is named.
#include "codec/meshopt/meshopt.h"

#include <gtest/gtest.h>
#include <meshoptimizer.h>

#include <array>
#include <cmath>
#include <cstring>
#include <string>

namespace clers {
namespace {

using Bytes = std::vector<std::byte>;

/// Numbers of three lines of a grid, as triangles and as they are.
std::vector<unsigned> grid_indices(unsigned n) {
  std::vector<unsigned> indices;
  for (unsigned j = 0; j + 1 < 3; ++j)
    for (unsigned i = 0; i + 1 < n; ++i)
      for (const unsigned v : {j * n + i, j * n + i + 1, j * n + i + n, j * n + i + 1,
                               j * n + i + n + 1, j * n + i + n})
        indices.push_back(v);
  return indices;
}

Bytes values(std::size_t count, std::size_t stride) {
  Bytes bytes(count * stride);
  for (std::size_t i = 0; i < bytes.size(); ++i)
    bytes[i] = static_cast<std::byte>(i / stride * (i % stride) % 251);
  return bytes;
}

template <class Encode>
Bytes encoded(std::size_t bound, Encode encode) {
  Bytes bytes(bound);
  bytes.resize(encode(reinterpret_cast<unsigned char*>(bytes.data()), bytes.size()));
  return bytes;
}

Bytes encoded_values(const Bytes& plain, std::size_t stride) {
  const std::size_t count = plain.size() / stride;
  return encoded(meshopt_encodeVertexBufferBound(count, stride), [&](auto* to, std::size_t size) {
    return meshopt_encodeVertexBuffer(to, size, plain.data(), count, stride);
  });
}

TEST(Meshopt, ValuesComeBack) {
  for (const std::size_t stride : {4u, 12u, 256u})
    for (const std::size_t count : {1u, 16u, 1000u}) {
      const Bytes plain = values(count, stride);
      const auto decoded = meshopt::decode_for_gltf(encoded_values(plain, stride), count, stride,
                                                    "ATTRIBUTES", "NONE");
      ASSERT_TRUE(decoded) << decoded.error().what;
      EXPECT_EQ(*decoded, plain);
    }
  // Nothing is smaller than values that are all alike.
  const Bytes zeros(256 * 400 * 4);
  EXPECT_TRUE(
      meshopt::decode_for_gltf(encoded_values(zeros, 4), 256 * 400, 4, "ATTRIBUTES", "NONE"));
}

TEST(Meshopt, IndicesComeBack) {
  const std::vector<unsigned> indices = grid_indices(40);
  const std::size_t n = indices.size();
  const Bytes triangles =
      encoded(meshopt_encodeIndexBufferBound(n, 120), [&](auto* to, std::size_t size) {
        return meshopt_encodeIndexBuffer(to, size, indices.data(), n);
      });
  const Bytes sequence =
      encoded(meshopt_encodeIndexSequenceBound(n, 120), [&](auto* to, std::size_t size) {
        return meshopt_encodeIndexSequence(to, size, indices.data(), n);
      });
  const auto as_triangles = meshopt::decode_for_gltf(triangles, n, 4, "TRIANGLES", "NONE");
  ASSERT_TRUE(as_triangles) << as_triangles.error().what;
  std::vector<unsigned> got(n);
  std::memcpy(got.data(), as_triangles->data(), as_triangles->size());
  for (std::size_t f = 0; f < n; f += 3) {  // which corner is first may differ
    unsigned sum = 0, expected = 0;
    for (std::size_t k = 0; k < 3; ++k) sum += got[f + k], expected += indices[f + k];
    EXPECT_EQ(sum, expected);
  }
  const auto in_turn = meshopt::decode_for_gltf(sequence, n, 2, "INDICES", "NONE");
  ASSERT_TRUE(in_turn) << in_turn.error().what;
  for (std::size_t i = 0; i < n; ++i) {
    std::uint16_t index = 0;
    std::memcpy(&index, in_turn->data() + 2 * i, 2);
    ASSERT_EQ(index, indices[i]);
  }
}

TEST(Meshopt, FiltersAreUndone) {
  constexpr std::size_t n = 100;
  std::vector<std::array<float, 4>> in(n);
  for (std::size_t i = 0; i < n; ++i) {
    const float t = static_cast<float>(i) * 0.1f;
    in[i] = {std::cos(t), std::sin(t) * 0.6f, std::sin(t) * 0.8f, 0};
  }
  Bytes octahedral(n * 8), quaternion(n * 8), exponential(n * 16);
  meshopt_encodeFilterOct(octahedral.data(), n, 8, 12, &in[0][0]);
  meshopt_encodeFilterQuat(quaternion.data(), n, 8, 12, &in[0][0]);
  meshopt_encodeFilterExp(exponential.data(), n, 16, 16, &in[0][0]);
  const auto decode = [&](const Bytes& bytes, std::size_t stride, const char* filter) {
    return *meshopt::decode_for_gltf(encoded_values(bytes, stride), n, stride, "ATTRIBUTES",
                                     filter);
  };
  const Bytes oct = decode(octahedral, 8, "OCTAHEDRAL"), quat = decode(quaternion, 8, "QUATERNION"),
              exp = decode(exponential, 16, "EXPONENTIAL");
  for (std::size_t i = 0; i < n; ++i) {
    std::array<std::int16_t, 4> o, q;
    std::array<float, 4> e;
    std::memcpy(&o, oct.data() + 8 * i, 8);
    std::memcpy(&q, quat.data() + 8 * i, 8);
    std::memcpy(&e, exp.data() + 16 * i, 16);
    float dot = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      if (k < 3) {
        EXPECT_NEAR(float(o[k]) / 32767, in[i][k], 2e-3);
      }
      dot += float(q[k]) / 32767 * in[i][k];  // a turn and its negative are one
      EXPECT_NEAR(e[k], in[i][k], 1e-3);
    }
    EXPECT_NEAR(std::abs(dot), 1, 2e-3);
  }
}

TEST(Meshopt, MistakesAreNamed) {
  const Bytes bytes = encoded_values(values(30, 8), 8);
  const struct {
    std::size_t count, stride;
    const char *mode, *filter;
    ErrorCode code;
  } mistakes[] = {
      {30, 8, "POINTS", "NONE", ErrorCode::unsupported},
      {30, 8, "ATTRIBUTES", "COLOR", ErrorCode::unsupported},
      {30, 0, "ATTRIBUTES", "NONE", ErrorCode::malformed},
      {30, 6, "ATTRIBUTES", "NONE", ErrorCode::malformed},
      {30, 260, "ATTRIBUTES", "NONE", ErrorCode::malformed},
      {30, 8, "TRIANGLES", "NONE", ErrorCode::malformed},
      {31, 4, "TRIANGLES", "NONE", ErrorCode::malformed},
      {30, 4, "TRIANGLES", "OCTAHEDRAL", ErrorCode::malformed},
      {30, 12, "ATTRIBUTES", "QUATERNION", ErrorCode::malformed},
      {30, 12, "ATTRIBUTES", "OCTAHEDRAL", ErrorCode::malformed},
      {30, 4, "TRIANGLES", "NONE", ErrorCode::malformed},  // they are no indices
      {std::size_t(1) << 60, 8, "ATTRIBUTES", "NONE", ErrorCode::malformed},
  };
  for (const auto& m : mistakes) {
    const auto decoded = meshopt::decode_for_gltf(bytes, m.count, m.stride, m.mode, m.filter);
    ASSERT_FALSE(decoded) << m.mode << m.count;
    EXPECT_EQ(decoded.error().code, m.code) << decoded.error().what;
  }
}

TEST(Meshopt, AnyBytesAreErrorsOrValues) {
  const Bytes bytes = encoded_values(values(50, 8), 8);
  for (std::size_t size = 0; size < bytes.size(); ++size)
    EXPECT_FALSE(
        meshopt::decode_for_gltf(std::span(bytes).first(size), 50, 8, "ATTRIBUTES", "NONE"));
  for (std::size_t i = 0; i < bytes.size(); ++i)
    for (const char* mode : {"ATTRIBUTES", "TRIANGLES", "INDICES"}) {
      Bytes flipped = bytes;
      flipped[i] ^= std::byte{0xff};
      if (mode != std::string("ATTRIBUTES"))
        flipped[0] = static_cast<std::byte>(mode[0] == 'T' ? 0xe1 : 0xd1);
      const std::size_t stride = mode[0] == 'A' ? 8 : 4;
      const auto decoded = meshopt::decode_for_gltf(flipped, 48, stride, mode, "NONE");
      if (decoded) {
        EXPECT_EQ(decoded->size(), 48 * stride);
      }
    }
}

}  // namespace
}  // namespace clers
