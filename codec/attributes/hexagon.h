// From where values are predicted without twins: along the order alone in which triangles are
// coded. It knows the surface, but neither values nor bytes.
#ifndef CLERS_CODEC_ATTRIBUTES_HEXAGON_H
#define CLERS_CODEC_ATTRIBUTES_HEXAGON_H

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "codec/base/lanes.h"
#include "codec/base/portable.h"
#include "codec/connectivity/coded_surface.h"

namespace clers::internal {

/// From where values are predicted. The numbers are the file format's.
enum class OrderPredictor : std::uint8_t {
  previous = 0,       ///< from the value before
  parallelogram = 1,  ///< across the gate
  hexagon = 2,        ///< also from the triangle that is coded next
};
inline constexpr unsigned order_predictors = 3;

/// A value is predicted at from + (to - origin) >> halving. All are numbers of vertices.
template <class Lanes>
struct Step {
  Lanes from, to, origin, halving;
};

/// The corners of three triangles in coded order.
template <class Lanes>
struct ThreeTriangles {
  std::array<Lanes, 3> before, face, next;
};

/// The step to v, if `usual` of it. Triangles are coded such that the gate of one mostly is a side
/// of the one before. So from a new tip v we see, without twins, the corner across its gate; and if
/// the next triangle's tip is there already, that as well:
///
///          v-----x        face = a b v, c is corner 0 or 1 of the face before,
///         / \   /         x corner 2 of the next face
///        a===b
///         \ /             parallelogram      v = a + (b - c)
///          c              the next one       v = a + (x - b)
///                         both               v = a + (x - c) / 2
///
/// Both is their mean, where b cancels out: in a hexagon around b, which is what most rings are
/// like, c to x is a diameter and a to v the side along it. Where the next triangle is on the other
/// side, a and b change places. With neither, v is halfway from a to b; at b, if not looked ahead,
/// which is better where values repeat.
///
/// Vertices mostly are numbered in the order of their introduction. Where they are not, one that
/// has a greater number than v counts as not there. A corner that is taken for c or x and is
/// another predicts worse, no more.
template <class Lanes>
CLERS_ALWAYS_INLINE Step<Lanes> step_to(Lanes v, const ThreeTriangles<Lanes>& t, Lanes look_ahead) {
  const Lanes a = t.face[0], b = t.face[1], x = t.next[2];
  const Lanes right = equal(a, t.before[2]), left = equal(b, t.before[2]);
  const Lanes c = select(right, t.before[0], t.before[1]);
  const Lanes has_c = (right | left) & less(c, v);
  const Lanes at_v = equal(t.next[0], v), turned = equal(t.next[1], v);
  const Lanes has_x = (at_v | turned) & less(x, v) & look_ahead;
  const Lanes swapped = (a ^ b) & turned & has_x;
  const Lanes from = a ^ swapped, pivot = b ^ swapped;
  return {from, select(has_x, x, b), select(has_c, c, select(has_x, pivot, a)),
          (has_c ^ has_x ^ Lanes::all(~0u)) & look_ahead & Lanes::all(1)};
}

/// Whether step_to is for v: it is a tip, and both ends of the gate are there.
template <class Lanes>
CLERS_ALWAYS_INLINE Lanes usual(Lanes v, const ThreeTriangles<Lanes>& t) {
  return equal(t.face[2], v) & less(t.face[0], v) & less(t.face[1], v);
}

/// Steps to vertices of consecutive numbers.
class Steps {
 public:
  static constexpr std::size_t most = 256;

  Steps(const CodedSurface& surface, OrderPredictor predictor)
      : surface_(surface), predictor_(predictor) {}

  /// Finds the steps to vertices v .. v + count - 1. Preconditions: v > 0, count <= most. All lead
  /// from vertices with lesser numbers, whatever the corners are.
  void find(std::uint32_t v, std::size_t count) {
    std::size_t i = 0;
#if CLERS_SSE2
    for (; i + 4 <= count; i += 4) find_four(v + static_cast<std::uint32_t>(i), i);
#endif
    for (; i < count; ++i) find_one(v + static_cast<std::uint32_t>(i), i);
  }
  /// The step to vertex v + i.
  Step<std::uint32_t> operator[](std::size_t i) const {
    return {from_[i], to_[i], origin_[i], halving_[i]};
  }

 private:
  /// Whether a triangle has one before it and one after it; those that have not are no loss.
  bool within(std::uint32_t t) const {
    return std::uint64_t(t - 1u) + 2 < surface_.corners.size() / 3;
  }
  std::uint32_t introducing(std::uint32_t v) const {
    return v < surface_.introduced_by.size() ? surface_.introduced_by[v] : CodedSurface::nothing;
  }
  const std::uint32_t* face(std::uint32_t t) const {
    return surface_.corners.data() + 3 * std::size_t(t);
  }
  std::uint32_t look_ahead() const {
    return predictor_ == OrderPredictor::hexagon ? 0xffffffffu : 0;
  }

  void put(std::size_t i, std::uint32_t from, std::uint32_t to, std::uint32_t origin,
           std::uint32_t halving) {
    from_[i] = from;
    to_[i] = to;
    origin_[i] = origin;
    halving_[i] = halving;
  }

  void find_one(std::uint32_t v, std::size_t i) {
    std::uint32_t near = v - 1;
    const std::uint32_t t = introducing(v);
    if (predictor_ != OrderPredictor::previous && t != CodedSurface::nothing) {
      const std::uint32_t* f = face(t);
      if (within(t)) {
        ThreeTriangles<OneLane> three;
        for (std::size_t j = 0; j < 3; ++j) {
          three.before[j] = {*(f - 3 + j)};
          three.face[j] = {f[j]};
          three.next[j] = {f[3 + j]};
        }
        if (usual(OneLane{v}, three).v != 0) {
          const Step<OneLane> s = step_to(OneLane{v}, three, OneLane{look_ahead()});
          return put(i, s.from.v, s.to.v, s.origin.v, s.halving.v);
        }
      }
      for (std::size_t j = 0; j < 3; ++j)
        if (f[j] < v) near = f[j];
    }
    put(i, near, near, near, 0);
  }

#if CLERS_SSE2
  CLERS_ALWAYS_INLINE void find_four(std::uint32_t v, std::size_t i) {
    std::uint32_t t[4];
    bool all_within = predictor_ != OrderPredictor::previous;
    for (std::uint32_t j = 0; j < 4; ++j) {
      t[j] = introducing(v + j);
      all_within &= within(t[j]);
    }
    unsigned found = 0;
    if (all_within) {
      const std::uint32_t *f0 = face(t[0]), *f1 = face(t[1]), *f2 = face(t[2]), *f3 = face(t[3]);
      FourLanes low[4] = {FourLanes::load(f0 - 3), FourLanes::load(f1 - 3), FourLanes::load(f2 - 3),
                          FourLanes::load(f3 - 3)};
      FourLanes high[4] = {FourLanes::load(f0 + 2), FourLanes::load(f1 + 2),
                           FourLanes::load(f2 + 2), FourLanes::load(f3 + 2)};
      transpose(low);
      transpose(high);
      const std::uint32_t second[4] = {f0[1], f1[1], f2[1], f3[1]}, count[4] = {0, 1, 2, 3};
      const ThreeTriangles<FourLanes> three = {{low[0], low[1], low[2]},
                                               {low[3], FourLanes::load(second), high[0]},
                                               {high[1], high[2], high[3]}};
      const FourLanes at = FourLanes::all(v) + FourLanes::load(count);
      const Step<FourLanes> s = step_to(at, three, FourLanes::all(look_ahead()));
      s.from.store(&from_[i]);
      s.to.store(&to_[i]);
      s.origin.store(&origin_[i]);
      s.halving.store(&halving_[i]);
      found = usual(at, three).bits();
    }
    if (found == 15) return;
    for (std::uint32_t j = 0; j < 4; ++j)
      if ((found >> j & 1) == 0) find_one(v + j, i + j);
  }
#endif

  CodedSurface surface_;
  OrderPredictor predictor_;
  std::array<std::uint32_t, most> from_, to_, origin_, halving_;
};

/// Calls visit(v, step) for vertices begin .. end - 1 in the order of their numbers; not for the
/// first of all, which nothing is known of.
template <class Visit>
CLERS_ALWAYS_INLINE void for_each_step(Steps& steps, std::size_t begin, std::size_t end,
                                       Visit visit) {
  for (std::size_t v = begin == 0 ? 1 : begin; v < end;) {
    const std::size_t count = std::min(end - v, Steps::most);
    steps.find(static_cast<std::uint32_t>(v), count);
    for (std::size_t i = 0; i < count; ++i) visit(v + i, steps[i]);
    v += count;
  }
}

}  // namespace clers::internal

#endif
