// Words <-> bytes: what they differ by from predictions, split into planes of bytes and left to
// zstd, which sees what repeats. Words are values as they are stored, or integers of a lattice.
//
// It is read in two steps: planes need no surface, so that they can be unpacked while connectivity
// is decoded.
#ifndef CLERS_CODEC_ATTRIBUTES_PLANES_H
#define CLERS_CODEC_ATTRIBUTES_PLANES_H

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "codec/attributes/prediction.h"
#include "codec/connectivity/coded_surface.h"
#include "codec/entropy/bytes.h"
#include "codec/entropy/zstd_frame.h"
#include "codec/error.h"
#include "codec/numbers/transform.h"
#include "codec/scalar.h"

namespace clers::internal {

/// What words are: unsigned integers of the size of a scalar, so many a row.
struct WordShape {
  Scalar scalar;
  std::size_t components;

  std::size_t row_size() const { return size_of(scalar) * components; }
};

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

inline constexpr std::size_t no_bound = ~std::size_t(0);

/// Words packed by the predictor whose residuals a quick zstd packs smallest.
struct PackedPlanes {
  Predictor predictor = Predictor::none;
  Bytes frame;
};
/// `words` are rows of a shape. The frame is empty if the quick zstd makes more than `most_quick`
/// bytes of them: they lose by far. Errors: internal. Throws std::bad_alloc only.
inline Expected<PackedPlanes> pack_planes(std::span<const std::byte> words, WordShape shape,
                                          std::span<const Predictor> candidates,
                                          const CodedSurface& surface, int zstd_level,
                                          std::size_t most_quick = no_bound) {
  const std::size_t count = words.size() / shape.row_size();
  Bytes residuals(words.size()), planes(words.size()), best;
  PackedPlanes packed;
  std::size_t least = no_bound;
  for (const Predictor predictor : candidates) {
    with_word(shape.scalar, [&](auto word) {
      using U = decltype(word);
      with_components(shape.components, [&](auto n) {
        subtract_predictions<U>(predictor, count, n, surface, words.data(), residuals.data());
      });
      to_planes<U>(residuals, shape.components, planes);
    });
    std::size_t size = 0;
    if (candidates.size() > 1 || most_quick < no_bound) {
      auto trial = pack_frame(planes, 1);
      if (!trial) return Failure{trial.error()};
      size = trial->size();
    }
    if (size >= least) continue;
    least = size;
    packed.predictor = predictor;
    best = planes;
  }
  if (most_quick < no_bound && least > most_quick) return packed;
  auto frame = pack_frame(best, zstd_level);
  if (!frame) return Failure{frame.error()};
  packed.frame = std::move(*frame);
  return packed;
}

/// Rows of residuals into `rows`, which has their size. Precondition: check_frame. Besides, while
/// it runs, takes as many bytes again. Errors: invalid. Throws std::bad_alloc only.
inline Expected<Done> unpack_planes(std::span<const std::byte> packed, std::uint64_t at,
                                    WordShape shape, std::span<std::byte> rows) {
  auto planes = unpack_frame(packed, at, rows.size(), "the values");
  if (!planes) return Failure{planes.error()};
  with_word(shape.scalar,
            [&](auto word) { from_planes<decltype(word)>(*planes, shape.components, rows); });
  return Done{};
}

/// Words of residuals. Where residuals are in the order of the values, both may be the same memory.
inline void add_predictions(Predictor predictor, WordShape shape, const CodedSurface& surface,
                            std::span<const std::byte> residuals, std::span<std::byte> words) {
  const std::size_t count = words.size() / shape.row_size();
  with_word(shape.scalar, [&](auto word) {
    with_components(shape.components, [&](auto n) {
      add_predictions<decltype(word)>(predictor, count, n, surface, residuals.data(), words.data());
    });
  });
}

}  // namespace clers::internal

#endif
