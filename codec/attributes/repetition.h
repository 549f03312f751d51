// Coordinates that were there before, at vertices beside one or on a line with it: which are coded
// so. Knows three coordinates and the surface, and no coder.
#ifndef CLERS_CODEC_ATTRIBUTES_REPETITION_H
#define CLERS_CODEC_ATTRIBUTES_REPETITION_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "codec/attributes/lines.h"
#include "codec/attributes/repeats.h"
#include "codec/connectivity/coded_surface.h"

namespace clers::internal {

/// Which coordinates are looked for at other vertices. The numbers are the file format's.
enum class Repetition : std::uint8_t {
  none = 0,
  beside = 1,  ///< at vertices beside (repeats.h)
  lines = 2,   ///< two of them at vertices of one line first (lines.h)
};
inline constexpr unsigned repetition_count = 3;

template <class Int>
class RepeatedCoordinates {
 public:
  /// `rows` has three integers a vertex, which are looked at once they are known. Throws
  /// std::bad_alloc only. Precondition: twins are there, or none is looked for.
  RepeatedCoordinates(Repetition repetition, Int* rows, std::size_t vertices,
                      const CodedSurface& surface) {
    if (repetition != Repetition::none) repeats_.emplace(rows, vertices);
    if (repetition == Repetition::lines) lines_.emplace(rows, vertices, surface);
  }

  /// The bytes that one takes.
  static std::uint64_t memory(Repetition repetition, std::uint64_t vertices) {
    return (repetition != Repetition::none ? Repeats<Int>::memory(vertices) : 0) +
           (repetition == Repetition::lines ? Lines<Int>::memory(vertices) : 0);
  }

  /// Whether code() may set anything.
  bool any() const { return repeats_.has_value(); }

  /// Codes which coordinates of the vertex are those of others, and sets these: a bit for each.
  /// decide(i, model, yes) codes a decision about coordinate i, or the first about two. `ends` is
  /// where the parallelogram a + b - c ends, within -2^61 .. 2^61. Precondition: any().
  template <class Decide>
  unsigned code(const Gate& gate, const std::array<std::int64_t, 3>& ends, Decide decide) {
    const unsigned done = lines_ ? lines_->code(gate, ends, decide) : 0;
    return repeats_->code(gate, ends, done, decide);
  }

  /// Says that the integers of v are in its row from now on.
  void known(std::uint32_t v) {
    if (lines_) lines_->known(v);
  }

 private:
  std::optional<Repeats<Int>> repeats_;
  std::optional<Lines<Int>> lines_;
};

}  // namespace clers::internal

#endif
