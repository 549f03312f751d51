// Guesses values from values before them, in integers only.
//
// Floats are mapped to integers that sort like them, so that a small difference of values mostly is
// a small difference of integers, every bit pattern survives, and no rounding is involved. The
// parallelogram rule (Touma and Gotsman 1998) adds and subtracts these modulo the word.
#ifndef CLERS_CODEC_ATTRIBUTES_PREDICTION_H
#define CLERS_CODEC_ATTRIBUTES_PREDICTION_H

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <span>
#include <type_traits>
#include <vector>

namespace clers::internal {

/// An integer that sorts like the float with these bits. Self-inverse pair with from_ordered.
template <class U>
U to_ordered(U bits) {
  constexpr U sign = U(1) << (std::numeric_limits<U>::digits - 1);
  return static_cast<U>(bits & sign ? ~bits : bits | sign);
}
template <class U>
U from_ordered(U key) {
  constexpr U sign = U(1) << (std::numeric_limits<U>::digits - 1);
  return static_cast<U>(key & sign ? key & ~sign : ~key);
}

/// Differences around zero to small numbers: 0, -1, 1, -2, 2 ..
template <class U>
U zigzag(U difference) {
  constexpr int top = std::numeric_limits<U>::digits - 1;
  return static_cast<U>(static_cast<U>(difference << 1) ^
                        static_cast<U>(-static_cast<U>(difference >> top)));
}
template <class U>
U unzigzag(U z) {
  return static_cast<U>(static_cast<U>(z >> 1) ^ static_cast<U>(-static_cast<U>(z & 1)));
}

/// Vertices from which to guess another: a + b - c. With b == c: just a.
struct Guess {
  std::uint32_t a, b, c;
};

/// Calls visit(vertex, guess) for every vertex that a triangle uses, in the order of first use,
/// with a guess from vertices visited before; then for all others in their order, guessed from the
/// one before. The first has no guess and gets itself.
///
///        v          c is the vertex of the face before that lies across the gate a-b
///       / \         .
///      a===b
///       \ /
///        c
template <class Visit>
void for_each_vertex(std::span<const std::uint32_t> corners, std::uint32_t vertex_count,
                     Visit visit) {
  std::vector<bool> seen(vertex_count);
  std::uint32_t last = 0;
  bool any = false;
  for (std::size_t i = 0; i < corners.size(); i += 3) {
    const std::uint32_t* face = corners.data() + i;
    for (unsigned j = 0; j < 3; ++j) {
      const std::uint32_t v = face[j];
      if (seen[v]) continue;
      seen[v] = true;
      Guess guess{last, last, last};
      if (j == 2 && i > 0) {
        const std::uint32_t* before = face - 3;
        if (face[0] == before[2] && face[1] == before[1])
          guess = {face[0], face[1], before[0]};
        else if (face[0] == before[0] && face[1] == before[2])
          guess = {face[0], face[1], before[1]};
        else
          guess = {face[1], face[1], face[1]};
      } else if (j > 0) {
        guess = {face[j - 1], face[j - 1], face[j - 1]};
      }
      if (!any) guess = {v, v, v};
      any = true;
      visit(v, guess);
      last = v;
    }
  }
  for (std::uint32_t v = 0; v < vertex_count; ++v) {
    const std::uint32_t g = v == 0 ? v : v - 1;
    if (!seen[v]) visit(v, Guess{g, g, g});
  }
}

}  // namespace clers::internal

#endif
