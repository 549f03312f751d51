// Which vertices of a piece are vertices of pieces before it.
//
// Along a seam the boundary vertices of both pieces were finished one after the other, in opposite
// directions. So numbers run up in one piece and down in the other, and what is told are runs:
//
//     this piece        12 -- 13 -- 14 -- 15 -- 16 -- 17
//     pieces before     96 -- 95 -- 94 -- 93    31 -- 30       two runs, both down
#ifndef CLERS_CODEC_PIECES_SEAMS_H
#define CLERS_CODEC_PIECES_SEAMS_H

#include <cstdint>
#include <span>
#include <vector>

#include "codec/attributes/transform.h"
#include "codec/entropy/coder.h"

namespace clers::internal {

/// Vertices first, first + 1 .. of a piece are global, global + 1 .. of the mesh, or down from
/// there.
struct SeamRun {
  std::uint32_t first = 0;
  std::uint32_t global = 0;
  std::uint32_t count = 1;  ///< at least 1
  bool down = true;

  std::uint32_t global_at(std::uint32_t i) const { return down ? global - i : global + i; }
};

/// Codes runs in their order.
class SeamModel {
 public:
  /// A Coder that encodes is told the run. What is decoded may lie anywhere.
  template <class Coder>
  SeamRun code(Coder& coder, SeamRun run) {
    run.first = end_ + between_.code(coder, run.first - end_);
    run.global = next_ + unzigzag(jump_.code(coder, zigzag(run.global - next_)));
    run.count = 1 + length_.code(coder, run.count - 1);
    run.down = run.count == 1 || coder.bit(down_, run.down);
    end_ = run.first + run.count;
    next_ = run.global_at(run.count);
    return run;
  }

 private:
  NumberModel between_, jump_, length_;
  BitModel down_;
  std::uint32_t end_ = 0, next_ = 0;  ///< what would go on the run before
};

/// The runs of a seam. `numbers[v]` is the number of vertex v in the mesh; those of the seam are
/// below `first_own`.
inline std::vector<SeamRun> seam_runs(std::span<const std::uint32_t> numbers,
                                      std::uint32_t first_own) {
  std::vector<SeamRun> runs;
  const auto shared = [&](std::size_t v) { return v < numbers.size() && numbers[v] < first_own; };
  for (std::size_t v = 0; v < numbers.size();) {
    if (!shared(v)) {
      ++v;
      continue;
    }
    SeamRun run{static_cast<std::uint32_t>(v), numbers[v], 1, true};
    if (shared(v + 1)) run.down = numbers[v + 1] != numbers[v] + 1;
    while (shared(++v) && numbers[v] == run.global_at(run.count)) ++run.count;
    if (run.count == 1) run.down = true;
    runs.push_back(run);
  }
  return runs;
}

}  // namespace clers::internal

#endif
