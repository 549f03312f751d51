// What is remembered of vertices that are coded: what was left of them after prediction.
#ifndef CLERS_CODEC_ATTRIBUTES_MIXED_PAST_H
#define CLERS_CODEC_ATTRIBUTES_MIXED_PAST_H

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "codec/attributes/mixed_space.h"
#include "codec/attributes/mixed_star.h"
#include "codec/attributes/mixed_surroundings.h"
#include "codec/attributes/vector.h"

namespace clers::internal::mixed {

/// log2, in 1/256, of what the mean of parallelograms misses: along the normal, across it, and
/// along each axis, in coordinates.
struct PastSizes {
  std::int16_t along, across;
  std::array<std::int16_t, 3> axis;
};

/// That of the vertices of a star: of each of the gate, and on average around.
struct Recent {
  Vector a, b, c, ring, corners;  ///< residuals in the frame; of the c's of all parallelograms
  int along, across;              ///< of the ring
  std::array<int, 3> axis;
  const PastSizes *at_a, *at_b, *at_c;
};

class Past {
 public:
  Past(const Space& space, std::size_t vertices)
      : of_(vertices), coarser_(std::max(space.bits() - 31, 0) - 4) {}
  static std::uint64_t memory(std::uint64_t vertices) { return vertices * sizeof(Vertex); }

  Recent look(const Star& star, const Frame& frame) const {
    const Star::Parallelogram& gate = star.parallelogram[0];
    Vector around, corners;
    std::int64_t along = 0, across = 0;
    std::array<std::int64_t, 3> axis = {};
    for (unsigned i = 0; i < star.ring_size; ++i) {
      const PastSizes& p = of_[star.ring[i]].sizes;
      around += residual(star.ring[i], frame);
      along += p.along;
      across += p.across;
      for (std::size_t k = 0; k < 3; ++k) axis[k] += p.axis[k];
    }
    for (unsigned i = 0; i < star.parallelograms; ++i)
      corners += residual(star.parallelogram[i].c, frame);
    const auto average = [&](std::int64_t sum) {
      return static_cast<int>(sum * part(star.ring_size) >> 16);
    };
    return {residual(gate.a, frame),
            residual(gate.b, frame),
            residual(gate.c, frame),
            mean(around, star.ring_size),
            mean(corners, star.parallelograms),
            average(along),
            average(across),
            {average(axis[0]), average(axis[1]), average(axis[2])},
            &of_[gate.a].sizes,
            &of_[gate.b].sizes,
            &of_[gate.c].sizes};
  }

  /// What the corrected prediction of v missed, in the frame, and what that of parallelograms did.
  void remember(std::uint32_t v, const Surroundings& at, const Vector& corrected,
                const Vector& plain) {
    const Vector r = clamp(shifted(corrected, -(at.frame.finer + coarser_)), 0x7fffffff);
    const Surroundings::Sizes sizes = at.sizes(plain);
    Vertex& p = of_[v];
    for (std::size_t i = 0; i < 3; ++i) {
      p.residual[i] = static_cast<std::int32_t>(r[i]);
      p.sizes.axis[i] = static_cast<std::int16_t>(at.size(plain[i]));
    }
    p.sizes.along = static_cast<std::int16_t>(sizes.along);
    p.sizes.across = static_cast<std::int16_t>(sizes.across);
  }
  /// Nothing, but that sizes are usual ones.
  void remember(std::uint32_t v, int size) {
    const auto s = static_cast<std::int16_t>(size);
    of_[v] = {{}, {s, s, {s, s, s}}};
  }

 private:
  struct Vertex {
    std::array<std::int32_t, 3> residual;  ///< in units of 2^coarser_
    PastSizes sizes;
  };

  Vector residual(std::uint32_t v, const Frame& frame) const {
    const std::array<std::int32_t, 3>& r = of_[v].residual;
    return clamp(shifted(Vector{{r[0], r[1], r[2]}}, frame.finer + coarser_), Frame::most);
  }

  std::vector<Vertex> of_;
  int coarser_;
};

}  // namespace clers::internal::mixed

#endif
