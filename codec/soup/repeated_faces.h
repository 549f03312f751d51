// Faces on the vertices of an earlier face, in the same cycle or in the reversed one: all they need
// is to say which. So a doubled surface is coded once, and its edges are those of one surface.
#ifndef CLERS_CODEC_SOUP_REPEATED_FACES_H
#define CLERS_CODEC_SOUP_REPEATED_FACES_H

#include <cstdint>
#include <span>
#include <vector>

#include "codec/entropy/coder.h"
#include "codec/soup/adjacency.h"
#include "codec/soup/faces.h"

namespace clers::internal {

/// A face that repeats another one.
struct Repeat {
  std::uint32_t face, base;  ///< base: the first face in file order on this cycle
};

/// Those at defective edges that are better left away: without them most of their edges have two
/// faces at most. By ascending face. Precondition: `adjacency` is that of the faces. Cost: linear
/// but for a sort of the faces of each defective edge.
std::vector<Repeat> find_repeats(const Faces& faces, const Adjacency& adjacency);

/// Faces without those that repeat others, in their order.
struct DistinctFaces {
  DistinctFaces(const Faces& all, std::span<const Repeat> repeats);

  /// How their half-edges lie on edges, from how all do: what match_edges() would find. Cost:
  /// linear, but for a sort of the defective edges.
  Adjacency adjacency(const Faces& all, Adjacency of_all) const;

  std::vector<std::uint32_t> faces;           ///< of all
  std::vector<std::uint32_t> corners, sizes;  ///< no sizes: triangles
};

/// Codes repeats by ascending base.
class RepeatModel {
 public:
  struct Code {
    std::uint32_t base;
    bool reversed;
  };
  /// A Coder that encodes gets the repeat. What is decoded may be no face.
  template <class Coder>
  Code code(Coder& coder, Code value) {
    const std::uint32_t step = step_[consecutive_].code(coder, value.base - last_);
    consecutive_ = step == 1;
    last_ += step;
    reversed_ = coder.bit(reversed_model_[reversed_], value.reversed);
    return {last_, reversed_};
  }

 private:
  std::uint32_t last_ = 0;
  bool consecutive_ = false, reversed_ = false;
  NumberModel step_[2];
  BitModel reversed_model_[2];
};

}  // namespace clers::internal

#endif
