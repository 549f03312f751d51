// Points and directions of space, computed to the same bits everywhere: operations that are rounded
// correctly, and a sine made of them.
#ifndef CLERS_TOPOLOGY_FIGURES_VECTOR_H
#define CLERS_TOPOLOGY_FIGURES_VECTOR_H

#include <array>
#include <cmath>
#include <numbers>

namespace clers::figures {

using Vector = std::array<double, 3>;

inline Vector operator+(const Vector& a, const Vector& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
inline Vector operator-(const Vector& a, const Vector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline Vector operator*(double k, const Vector& a) {
  return {k * a[0], k * a[1], k * a[2]};
}
inline double dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline double length(const Vector& a) {
  return std::sqrt(dot(a, a));
}
inline Vector unit(const Vector& a) {
  const double l = length(a);
  return l == 0 ? a : (1 / l) * a;
}

/// The sine of pi x, by its series; libraries differ in the last bit.
inline double sin_pi(double x) {
  x -= 2 * std::floor(x / 2 + 0.5);
  if (x > 0.5) x = 1 - x;
  if (x < -0.5) x = -1 - x;
  const double angle = std::numbers::pi * x, square = angle * angle;
  double sum = 1;
  for (int k = 20; k > 0; k -= 2) sum = 1 - square / (k * (k + 1)) * sum;
  return angle * sum;
}
inline double cos_pi(double x) {
  return sin_pi(x + 0.5);
}

}  // namespace clers::figures

#endif
