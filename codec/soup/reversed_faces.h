// Faces that run against the others of their component.
#ifndef CLERS_CODEC_SOUP_REVERSED_FACES_H
#define CLERS_CODEC_SOUP_REVERSED_FACES_H

#include <cstdint>

#include "codec/entropy/coder.h"

namespace clers::internal {

/// A maximal sequence of turned faces.
struct ReversedRun {
  std::uint32_t first;
  std::uint32_t count;  ///< at least 1
};

/// Codes runs in their order.
class ReversedModel {
 public:
  /// A Coder that encodes is told the run. `end` is where the run before ends, 0 at first. What is
  /// decoded may begin beyond any face.
  template <class Coder>
  ReversedRun code(Coder& coder, ReversedRun run, std::uint32_t end) {
    const std::uint32_t gap = between_.code(coder, run.first - end);
    const std::uint32_t more = length_.code(coder, run.count - 1);
    return {end + gap, more + 1};
  }

 private:
  NumberModel between_, length_;
};

}  // namespace clers::internal

#endif
