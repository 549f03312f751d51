#include "topology/figures/rabbit.h"

#include <algorithm>
#include <array>
#include <map>

namespace clers::figures {
namespace {

/// An ellipsoid of revolution.
struct Part {
  Vector centre, axis;
  double along, across;  // half its axes
};

/// Left and right alike.
constexpr std::array<Part, 12> parts{{
    {{-0.15, 0, 0.62}, {1, 0, 0.25}, 0.80, 0.50},         // body
    {{0.40, 0, 0.88}, {0.5, 0, 1}, 0.42, 0.33},           // neck
    {{0.66, 0, 1.24}, {1, 0, -0.35}, 0.40, 0.31},         // head
    {{0.33, 0.27, 1.84}, {-0.10, 0.09, 1}, 0.56, 0.125},  // ears
    {{0.33, -0.27, 1.84}, {-0.10, -0.09, 1}, 0.56, 0.125},
    {{-0.40, 0.32, 0.42}, {1, 0, 0.6}, 0.40, 0.28},  // haunches
    {{-0.40, -0.32, 0.42}, {1, 0, 0.6}, 0.40, 0.28},
    {{-0.12, 0.31, 0.13}, {1, 0.1, 0}, 0.32, 0.15},  // feet
    {{-0.12, -0.31, 0.13}, {1, -0.1, 0}, 0.32, 0.15},
    {{0.58, 0.26, 0.32}, {0.05, 0, -1}, 0.36, 0.14},  // fore legs
    {{0.58, -0.26, 0.32}, {0.05, 0, -1}, 0.36, 0.14},
    {{-0.98, 0, 0.55}, {1, 0, 0}, 0.17, 0.17},  // tail
}};

/// Cubes of the domain, from one corner of a box to the other.
struct Box {
  std::array<int, 3> from, to;
};
constexpr std::array<Box, 10> boxes{{
    {{-3, -1, 1}, {2, 1, 2}},  // body
    {{-2, -1, 3}, {3, 1, 3}},
    {{1, -1, 4}, {3, 1, 4}},  // head
    {{1, 1, 5}, {1, 1, 7}},   // ears
    {{1, -1, 5}, {1, -1, 7}},
    {{-1, 1, 0}, {0, 1, 0}},  // feet
    {{-1, -1, 0}, {0, -1, 0}},
    {{2, 1, 0}, {2, 1, 0}},  // fore legs
    {{2, -1, 0}, {2, -1, 0}},
    {{-4, 0, 1}, {-4, 0, 1}},  // tail
}};
constexpr double side = 0.29;

}  // namespace

Rabbit::Potential Rabbit::potential(const Vector& p) {
  // Far from the others a part is its ellipsoid: with f = (1 + q)^-4 the value is q - 1.
  double sum = 0;
  Vector slope{};
  for (const Part& part : parts) {
    const Vector d = p - part.centre, axis = unit(part.axis);
    const double t = dot(d, axis), a = 1 / (part.along * part.along),
                 b = 1 / (part.across * part.across);
    const double near = 1 / (1 + b * dot(d, d) + (a - b) * t * t);
    const double square = near * near, f = square * square;
    sum += f;
    slope = slope - 8 * f * near * (b * d + ((a - b) * t) * axis);
  }
  const double root = std::sqrt(std::sqrt(sum));
  return {1 / root - 2, (-0.25 / (root * sum)) * slope};
}

Vector Rabbit::project(Vector p) {
  for (int step = 0; step < 60; ++step) {
    const Potential at = potential(p);
    const double steep = dot(at.gradient, at.gradient);
    if (std::fabs(at.value) < 1e-12 || steep < 1e-12) break;
    Vector move = (-at.value / steep) * at.gradient;
    constexpr double far = 0.05;
    if (const double l = length(move); l > far) move = (far / l) * move;
    p = p + move;
  }
  return p;
}

Rabbit::Cubes Rabbit::cubes() {
  Cubes cubes;
  constexpr int reach = 10;
  using Cell = std::array<int, 3>;
  // The middle of cell 0 is at y = 0, and the rabbit stands on its sides.
  const auto corner = [&](const Cell& c) {
    return Vector{side * (c[0] - 0.5), side * (c[1] - 0.5), side * c[2]};
  };
  const auto inside = [&](const Cell& c) {
    return std::any_of(boxes.begin(), boxes.end(), [&](const Box& box) {
      for (std::size_t i = 0; i < 3; ++i)
        if (c[i] < box.from[i] || c[i] > box.to[i]) return false;
      return true;
    });
  };
  std::map<Cell, std::uint32_t> ids;
  const auto id = [&](const Cell& c) {
    const auto [place, added] = ids.try_emplace(c, static_cast<std::uint32_t>(cubes.at.size()));
    if (added) cubes.at.push_back(project(corner(c)));
    return place->second;
  };
  for (int x = -reach; x < reach; ++x)
    for (int y = -reach; y < reach; ++y)
      for (int z = -reach; z < reach; ++z) {
        const Cell cell{x, y, z};
        if (!inside(cell)) continue;
        for (std::size_t axis = 0; axis < 3; ++axis)
          for (const int way : {0, 1}) {
            Cell beyond = cell;
            beyond[axis] += 2 * way - 1;
            if (inside(beyond)) continue;
            // Around the axis if this is the far side, else against it.
            for (int i = 0; i < 4; ++i) {
              const int k = way == 1 ? i : 3 - i;
              Cell c = cell;
              c[axis] += way;
              c[(axis + 1) % 3] += (k == 1 || k == 2) ? 1 : 0;
              c[(axis + 2) % 3] += k >= 2 ? 1 : 0;
              cubes.quads.push_back(id(c));
            }
          }
      }
  return cubes;
}

}  // namespace clers::figures
