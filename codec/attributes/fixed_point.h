// Logarithms, powers and roots in integers, for sizes that are kept in 1/256 octaves. Whatever the
// machine, the same results. Knows no values.
#ifndef CLERS_CODEC_ATTRIBUTES_FIXED_POINT_H
#define CLERS_CODEC_ATTRIBUTES_FIXED_POINT_H

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace clers::internal::fixed {

/// The top 64 bits of a product.
constexpr std::uint64_t multiply_high(std::uint64_t a, std::uint64_t b) {
  const std::uint64_t a0 = a & 0xffffffff, a1 = a >> 32, b0 = b & 0xffffffff, b1 = b >> 32;
  const std::uint64_t middle = a1 * b0 + (a0 * b0 >> 32);
  return a1 * b1 + (middle >> 32) + ((a0 * b1 + (middle & 0xffffffff)) >> 32);
}

/// An octave in the units of sizes.
inline constexpr int octave = 256;

namespace tables {

/// 2^(i/256) in units of 2^-16.
inline constexpr auto powers = [] {
  std::array<std::uint32_t, octave + 1> r = {};
  std::uint64_t p = std::uint64_t(1) << 62;             // units of 2^-62
  constexpr std::uint64_t factor = 0x8058d7d2d5e5f6b1;  // 2^(1/256) in units of 2^-63
  for (std::size_t i = 0; i <= octave; ++i) {
    r[i] = static_cast<std::uint32_t>((p + (std::uint64_t(1) << 45)) >> 46);
    p = multiply_high(p, factor) << 1;
  }
  return r;
}();

/// log2(1 + (i + 1/2)/256) in 1/256, rounded.
inline constexpr auto logs = [] {
  std::array<std::uint8_t, 256> r = {};
  unsigned log = 0;
  for (std::uint32_t i = 0; i < 256; ++i) {
    const std::uint32_t x = 65536 + 256 * i + 128;
    while (log < 255 && std::uint64_t(powers[log]) * powers[log + 1] < std::uint64_t(x) * x) ++log;
    r[i] = static_cast<std::uint8_t>(log);
  }
  return r;
}();

}  // namespace tables

/// log2(x) in 1/256; of 0 as of 1.
constexpr int log2(std::uint64_t x) {
  if (x == 0) return 0;
  const int n = 63 - std::countl_zero(x);
  const std::uint64_t top = n >= 8 ? x >> (n - 8) : x << (8 - n);
  return n * octave + tables::logs[top & 255];
}

/// 2^(log/256) in units of 2^-16, rounded down; log at most 47 octaves.
constexpr std::uint64_t exp2(int log) {
  const std::uint64_t mantissa = tables::powers[static_cast<std::size_t>(log & 255)];
  const int n = log >> 8;
  return n >= 0 ? mantissa << n : n > -32 ? mantissa >> -n : 0;
}

/// 2^n / x, about: relative error below 1/128. 2^(n - 47) <= x, n <= 47.
constexpr std::uint64_t inverse(int n, std::uint64_t x) {
  return exp2(n * octave - log2(x)) >> 16;
}

/// 2^30 / sqrt(x), about; 2^28 <= x < 2^32.
constexpr std::int64_t inverse_root(std::uint64_t x) {
  // By its logarithm, then once Newton's y += y (1 - x y^2) / 2.
  const std::uint64_t y = exp2(30 * octave - log2(x) / 2) >> 16;
  const std::int64_t excess = std::int64_t(1 << 16) - static_cast<std::int64_t>(x * y * y >> 44);
  return static_cast<std::int64_t>(y) + (static_cast<std::int64_t>(y) * excess >> 17);
}

}  // namespace clers::internal::fixed

#endif
