// The linear map that fits pairs of vectors best, by least squares, in integers: the same on every
// machine.
#ifndef CLERS_CODEC_ATTRIBUTES_LINEAR_FIT_H
#define CLERS_CODEC_ATTRIBUTES_LINEAR_FIT_H

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace clers::internal {

class LinearFit {
 public:
  using Vector = std::array<std::int64_t, 3>;

  static constexpr int vector_bits = 20;  ///< besides the sign
  static constexpr int fraction = 14;     ///< bits of an entry of the map after the point

  LinearFit() { clear(); }

  /// Forgets all pairs. Across what the vectors span the map is the identity.
  void clear() {
    for (std::size_t i = 0; i < 3; ++i) {
      squares_[i] = products_[i] = map_[i] = {};
      map_[i][i] = std::int64_t(1) << fraction;
    }
    pairs_ = solved_at_ = 0;
  }

  std::uint32_t pairs() const { return pairs_; }

  /// Precondition: coordinates have vector_bits. So sums stay below 2^60 with the most pairs.
  void add(const Vector& from, const Vector& to) {
    if (pairs_ == most_pairs) return;
    ++pairs_;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) {
        squares_[i][j] += from[i] * from[j];
        products_[i][j] += to[i] * from[j];
      }
  }

  /// Coordinate i of the image of a vector is the sum of map()[i][j] times its coordinate j, and so
  /// many bits too long. Entries are within +-2^most_bits. Solves anew while there are few pairs,
  /// and then whenever there are a quarter more: where little would change it does not.
  const std::array<Vector, 3>& map() {
    if (pairs_ != solved_at_ && (pairs_ <= 12 || pairs_ - solved_at_ > solved_at_ / 4)) solve();
    return map_;
  }
  static constexpr int most_bits = 18;

 private:
  static constexpr std::uint32_t most_pairs = 1u << 20;

  // products * inverse of squares, by Cramer's rule, with 20 bits an entry: then minors have 41,
  // and sums of three products of both less than 63. The identity is added with a small weight
  // (Tikhonov), which outweighs what the shift may take from the determinant.
  void solve() {
    solved_at_ = pairs_;
    std::int64_t most = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      most = std::max(most, squares_[i][i]);
      for (const std::int64_t p : products_[i]) most = std::max(most, p < 0 ? -p : p);
    }
    const int shift = std::max(0, int(std::bit_width(static_cast<std::uint64_t>(most))) - 20);
    std::array<Vector, 3> s, p;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) {
        const std::int64_t ridge = i != j ? 0 : shift > 0 ? 4 : 1;
        s[i][j] = (squares_[i][j] >> shift) + ridge;
        p[i][j] = (products_[i][j] >> shift) + ridge;
      }
    const auto minor = [&](std::size_t i, std::size_t j) {
      const std::size_t a = (i + 1) % 3, b = (i + 2) % 3, c = (j + 1) % 3, d = (j + 2) % 3;
      return s[a][c] * s[b][d] - s[a][d] * s[b][c];
    };
    std::array<Vector, 3> adjugate;  // symmetric as s is
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) adjugate[i][j] = minor(i, j);
    const std::int64_t determinant =
        s[0][0] * adjugate[0][0] + s[0][1] * adjugate[0][1] + s[0][2] * adjugate[0][2];
    if (determinant <= 0) return;
    // One division for all: the determinant is made one of 31 bits, and all that is divided by it
    // is shifted likewise, where it is less than 16 times as large.
    const int up = std::countl_zero(static_cast<std::uint64_t>(determinant)) - 33;
    const auto scaled = [&](std::int64_t n) {
      return up >= 0 ? n * (std::int64_t(1) << up) : n >> -up;
    };
    const std::int64_t inverse = (std::int64_t(1) << 62) / scaled(determinant);  // 2^31 .. 2^32
    constexpr std::int64_t bound = std::int64_t(1) << most_bits;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) {
        const std::int64_t n =
            p[i][0] * adjugate[0][j] + p[i][1] * adjugate[1][j] + p[i][2] * adjugate[2][j];
        if (n >> (most_bits - fraction) >= determinant)
          map_[i][j] = bound;
        else if (-n >> (most_bits - fraction) >= determinant)
          map_[i][j] = -bound;
        else
          map_[i][j] = (scaled(n) >> 6) * inverse >> (62 - 6 - fraction);
      }
  }

  std::array<Vector, 3> squares_, products_, map_;  // sums of from * from, and of to * from
  std::uint32_t pairs_, solved_at_;
};

}  // namespace clers::internal

#endif
