// What a mean of parallelograms misses, learned as a linear function of what is known around: a
// normalised LMS filter (Widrow and Hoff), along the normal and across it.
#ifndef CLERS_CODEC_ATTRIBUTES_MIXED_CORRECTION_H
#define CLERS_CODEC_ATTRIBUTES_MIXED_CORRECTION_H

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "codec/attributes/fixed_point.h"
#include "codec/attributes/vector.h"
#include "codec/entropy/mixer.h"

namespace clers::internal::mixed {

class Correction {
 public:
  static constexpr unsigned features = 16;

  /// Sets feature i, a vector in a frame.
  void set(unsigned i, const Vector& f) {
    const Vector v = clamp(f >> coarser, most);
    x_[i] = static_cast<std::int16_t>(v[0]);
    y_[i] = static_cast<std::int16_t>(v[1]);
    z_[i] = static_cast<std::int16_t>(v[2]);
  }
  void clear() { x_ = y_ = z_ = {}; }

  /// What is learned of vertices of a class, 0 .. 2, as a vector in the frame; n is the normal in
  /// units of 2^-14, or zero.
  Vector predict(unsigned of_class, const Vector& n) {
    class_ = of_class;
    normal_ = n;
    for (unsigned i = 0; i < features; ++i)
      n_[i] = static_cast<std::int16_t>((x_[i] * static_cast<int>(n[0]) +
                                         y_[i] * static_cast<int>(n[1]) +
                                         z_[i] * static_cast<int>(n[2])) >>
                                        14);
    const std::int32_t* const across = across_[class_].data();
    const Vector t = {{mixer::dot(x_.data(), across, features),
                       mixer::dot(y_.data(), across, features),
                       mixer::dot(z_.data(), across, features)}};
    const std::int64_t along = mixer::dot(n_.data(), along_[class_].data(), features);
    const std::int64_t excess = along - (dot(t, n) >> 14);
    return (t + (n * excess >> 14)) >> (12 - coarser);
  }

  /// The frame's vector that should have been predicted less the one that was; most_n and most_t
  /// are the most that is believed of it, along the normal and across.
  void learn(const Vector& error, std::int64_t most_n, std::int64_t most_t) {
    const std::int64_t n = dot(error, normal_) >> 14;
    const Vector t = clamp(error - (normal_ * n >> 14), most_t);
    std::uint32_t all = 0, along = 0;
    for (unsigned i = 0; i < features; ++i) {
      all += static_cast<std::uint32_t>(x_[i] * x_[i]) + static_cast<std::uint32_t>(y_[i] * y_[i]) +
             static_cast<std::uint32_t>(z_[i] * z_[i]);
      along += static_cast<std::uint32_t>(n_[i] * n_[i]);
    }
    const std::uint32_t across = all > along ? all - along : 0;
    const auto rate = [](std::uint32_t power) {
      return static_cast<std::int64_t>(
          mu * fixed::inverse(40, std::uint64_t(power) + least_power) >> 20);
    };
    const auto step = [](std::int64_t e, std::int64_t by) {
      return static_cast<std::int16_t>(std::clamp<std::int64_t>(e * by >> 20, -32767, 32767));
    };
    const std::int64_t across_rate = rate(across);
    std::int32_t* const w = across_[class_].data();
    mixer::train<6>(x_.data(), w, features, step(t[0], across_rate));
    mixer::train<6>(y_.data(), w, features, step(t[1], across_rate));
    mixer::train<6>(z_.data(), w, features, step(t[2], across_rate));
    mixer::train<6>(n_.data(), along_[class_].data(), features,
                    step(std::clamp(n, -most_n, most_n), rate(along)));
  }

 private:
  static constexpr int coarser = 9;  ///< features are in units of 2^9 of the frame's
  static constexpr std::int64_t most = 8191;
  static constexpr std::uint64_t mu = 1342177;  ///< .04 * 2^(28 + 6 - 9)
  static constexpr std::uint32_t least_power = 1 << 16;

  alignas(16) std::array<std::int16_t, features> x_ = {}, y_ = {}, z_ = {}, n_ = {};
  alignas(16) std::array<std::int32_t, features> across_[3] = {}, along_[3] = {};
  unsigned class_ = 0;
  Vector normal_;
};

}  // namespace clers::internal::mixed

#endif
