// Values as integers that predict well, and back without loss. It knows single words only.
//
// Floats are mapped to integers that sort like them, so that a small difference of values mostly is
// a small difference of integers, every bit pattern survives, and no rounding is involved.
#ifndef CLERS_CODEC_NUMBERS_TRANSFORM_H
#define CLERS_CODEC_NUMBERS_TRANSFORM_H

#include <cstddef>
#include <cstring>
#include <limits>

namespace clers::internal {

/// An integer that sorts like the float with these bits.
template <class U>
U to_ordered(U bits) {
  constexpr U sign = U(1) << (std::numeric_limits<U>::digits - 1);
  return static_cast<U>(bits & sign ? ~bits : bits | sign);
}
/// Undoes to_ordered.
template <class U>
U from_ordered(U key) {
  constexpr U sign = U(1) << (std::numeric_limits<U>::digits - 1);
  return static_cast<U>(key & sign ? key & ~sign : ~key);
}

/// Differences around zero to small numbers: 0, -1, 1, -2, 2 .. as 0, 1, 2, 3, 4 ..
template <class U>
U zigzag(U difference) {
  constexpr int top = std::numeric_limits<U>::digits - 1;
  return static_cast<U>(static_cast<U>(difference << 1) ^
                        static_cast<U>(-static_cast<U>(difference >> top)));
}
/// Undoes zigzag.
template <class U>
U unzigzag(U z) {
  return static_cast<U>(static_cast<U>(z >> 1) ^ static_cast<U>(-static_cast<U>(z & 1)));
}

/// Word i of an array of words in bytes of any alignment.
template <class U>
U word_at(const std::byte* words, std::size_t i) {
  U word;
  std::memcpy(&word, words + i * sizeof(U), sizeof(U));
  return word;
}
template <class U>
void set_word(std::byte* words, std::size_t i, U word) {
  std::memcpy(words + i * sizeof(U), &word, sizeof(U));
}

}  // namespace clers::internal

#endif
