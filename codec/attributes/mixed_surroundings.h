// Where what is known around a vertex is, in a frame: the means that predict it. It knows no
// statistics.
#ifndef CLERS_CODEC_ATTRIBUTES_MIXED_SURROUNDINGS_H
#define CLERS_CODEC_ATTRIBUTES_MIXED_SURROUNDINGS_H

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "codec/attributes/fixed_point.h"
#include "codec/attributes/mixed_covariance.h"
#include "codec/attributes/mixed_space.h"
#include "codec/attributes/mixed_star.h"
#include "codec/attributes/vector.h"

namespace clers::internal::mixed {

/// 65536 / n, 0 < n <= Star::most_ring.
inline std::int64_t part(unsigned n) {
  static constexpr auto parts = [] {
    std::array<std::uint16_t, Star::most_ring + 1> p = {};
    for (unsigned i = 2; i < p.size(); ++i) p[i] = static_cast<std::uint16_t>(65536 / i);
    return p;
  }();
  return n == 1 ? 65536 : parts[n];
}

/// A sum of n over n, rounded down.
inline Vector mean(const Vector& sum, unsigned n) {
  return sum * part(n) >> 16;
}

/// Points of a lattice.
template <class Int>
class Points {
 public:
  Points(const Space& space, const Int* rows) : space_(&space), rows_(rows) {}
  Vector operator()(std::uint32_t v) const { return space_->point(rows_ + 3 * std::size_t(v)); }

 private:
  const Space* space_;
  const Int* rows_;
};

class Surroundings {
 public:
  explicit Surroundings(int least_size) : least_size_(least_size) {}

  Frame frame;
  Vector normal;  ///< in units of 2^-14; or zero
  AxisOrder order = {};
  unsigned count = 0;                      ///< parallelograms
  Vector ends[Star::most_parallelograms];  ///< of them
  Vector mean_end, ring, lines, line_a, line_b;
  Vector a, b, c;  ///< the gate
  bool has_lines = false;
  int edge = 0;   ///< log2 of the gate's sides, in coordinates
  int reach = 0;  ///< log2 of the distance from the mean of lines to that of ends

  /// Precondition: the star has a parallelogram.
  template <class Int>
  void look(const Points<Int>& point, const Star& star) {
    const Star::Parallelogram& gate = star.parallelogram[0];
    const Vector at_a = point(gate.a), at_b = point(gate.b), at_c = point(gate.c);
    const std::int64_t longest = std::max(
        {largest(at_b - at_a), largest(at_c - at_a), largest(at_c - at_b), std::int64_t(1)});
    frame.origin = at_a;
    frame.finer =
        Frame::edge_bits - static_cast<int>(std::bit_width(static_cast<std::uint64_t>(longest)));
    a = {};
    b = frame.place(at_b);
    c = frame.place(at_c);
    // Of a third of the squares.
    const std::uint64_t squares = square(b) + square(c) + square(b - c);
    edge = (fixed::log2(squares) + 8 * fixed::octave - 406) / 2 - frame.octaves();

    count = star.parallelograms;
    Vector sum, normals;
    for (unsigned i = 0; i < count; ++i) {
      const Star::Parallelogram& p = star.parallelogram[i];
      const Vector x = point(p.a), y = point(p.b), z = point(p.c);
      ends[i] = frame.place(x + y - z);
      sum += ends[i];
      normals += cross(frame.scaled(x - z) >> 4, frame.scaled(y - z) >> 4);
    }
    mean_end = mean(sum, count);
    set_normal(normals);
    look_along_ring(point, star);
    reach = size(lines - mean_end);
  }

  /// Where nothing is known but a place.
  void look_nowhere(const Vector& origin, int finer) {
    frame = {origin, finer};
    normal = {};
  }

  /// log2, in 1/256, of lengths, in coordinates.
  int size(std::int64_t d) const {
    return measured(fixed::log2(static_cast<std::uint64_t>(size_of(d))));
  }
  int size(const Vector& d) const {
    const Vector near = clamp(d, Frame::most);
    return measured(fixed::log2(static_cast<std::uint64_t>(dot(near, near))) / 2);
  }
  /// Of a vector along the normal, and across it, where it is that of either coordinate.
  struct Sizes {
    int along, across;
  };
  Sizes sizes(const Vector& d) const {
    const Vector near = clamp(d, Frame::most);
    const std::int64_t n = dot(near, normal) >> 14;
    const std::int64_t rest = std::max<std::int64_t>(dot(near, near) - n * n, 0);
    return {size(n), measured(fixed::log2(static_cast<std::uint64_t>(rest)) / 2 - 128)};
  }
  /// A length in the frame that is about 2^(size/256) coordinates.
  std::int64_t length(int size) const {
    return static_cast<std::int64_t>(
        fixed::exp2(std::clamp(size + frame.octaves(), 0, 28 * fixed::octave)) >> 16);
  }

 private:
  static std::uint64_t square(const Vector& d) {
    const Vector less = d >> 4;
    return static_cast<std::uint64_t>(dot(less, less));
  }
  int measured(int log) const { return std::max(log - frame.octaves(), least_size_); }

  void set_normal(const Vector& sum) {
    const std::int64_t size = largest(sum);
    normal = {};
    if (size != 0) {
      const Vector n =
          shifted(sum, 15 - static_cast<int>(std::bit_width(static_cast<std::uint64_t>(size))));
      normal = n * fixed::inverse_root(static_cast<std::uint64_t>(dot(n, n))) >> 16;
    }
    order = axis_order(normal);
  }

  template <class Int>
  void look_along_ring(const Points<Int>& point, const Star& star) {
    Vector places[Star::most_ring], sum;
    for (unsigned i = 0; i < star.ring_size; ++i) {
      places[i] = frame.place(point(star.ring[i]));
      sum += places[i];
    }
    ring = mean(sum, star.ring_size);
    has_lines = star.lines != 0;
    lines = line_a = line_b = mean_end;
    if (!has_lines) return;
    Vector all;
    for (unsigned i = 0; i < star.lines; ++i) {
      const Star::Line& l = star.line[i];
      const Vector w = frame.place(point(l.w[0])) + frame.place(point(l.w[1]));
      const Vector end = places[l.at] * 2 - (w >> 1);
      all += end;
      if (star.ring[l.at] == star.parallelogram[0].a) line_a = end;
      if (star.ring[l.at] == star.parallelogram[0].b) line_b = end;
    }
    lines = mean(all, star.lines);
  }

  int least_size_;
};

}  // namespace clers::internal::mixed

#endif
