// Residuals <-> bytes: split into planes of bytes, and left to zstd. It knows neither the surface
// nor what the words mean, so that it can run while connectivity is decoded.
#ifndef CLERS_CODEC_ATTRIBUTES_RESIDUALS_H
#define CLERS_CODEC_ATTRIBUTES_RESIDUALS_H

#include <cstddef>
#include <span>
#include <utility>

#include "codec/attributes/transform.h"
#include "codec/entropy/bytes.h"
#include "codec/entropy/zstd_frame.h"
#include "codec/error.h"
#include "codec/scalar.h"

namespace clers::internal {

/// For every component all lowest bytes, then all second ones, and so on: where in a plane a row
/// goes is where it is.
template <class U>
void to_planes(std::span<const std::byte> rows, std::size_t components,
               std::span<std::byte> planes) {
  const std::size_t count = rows.size() / (components * sizeof(U));
  for (std::size_t c = 0; c < components; ++c)
    for (std::size_t row = 0; row < count; ++row) {
      const U word = word_at<U>(rows.data(), row * components + c);
      for (std::size_t byte = 0; byte < sizeof(U); ++byte)
        planes[(c * sizeof(U) + byte) * count + row] =
            static_cast<std::byte>(word >> 8 * byte & 0xff);
    }
}
/// Undoes to_planes.
template <class U>
void from_planes(std::span<const std::byte> planes, std::size_t components,
                 std::span<std::byte> rows) {
  const std::size_t count = rows.size() / (components * sizeof(U));
  for (std::size_t c = 0; c < components; ++c) {
    const std::byte* plane = planes.data() + c * sizeof(U) * count;
    for (std::size_t row = 0; row < count; ++row) {
      U word = 0;
      for (std::size_t byte = 0; byte < sizeof(U); ++byte)
        word = static_cast<U>(
            word | static_cast<U>(std::to_integer<U>(plane[byte * count + row]) << 8 * byte));
      set_word(rows.data(), row * components + c, word);
    }
  }
}

inline Bytes planes_of(std::span<const std::byte> rows, Scalar scalar, std::size_t components) {
  Bytes planes(rows.size());
  with_word(scalar, [&](auto word) { to_planes<decltype(word)>(rows, components, planes); });
  return planes;
}

/// Rows of residuals, `size` bytes in all. Precondition: check_frame. Errors: invalid.
inline Expected<Bytes> unpack_residuals(std::span<const std::byte> packed, std::uint64_t at,
                                        std::uint64_t size, Scalar scalar, std::size_t components) {
  auto planes = unpack_frame(packed, at, size, "the values");
  if (!planes) return planes;
  Bytes rows(planes->size());
  with_word(scalar, [&](auto word) { from_planes<decltype(word)>(*planes, components, rows); });
  return rows;
}

}  // namespace clers::internal

#endif
