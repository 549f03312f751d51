#include <cmath>
#include <cstddef>
#include <tuple>
#include <utility>
#include <vector>

#include "corpus/build.h"
#include "corpus/generate.h"

namespace clers::corpus {
namespace {

struct Turn {
  double cosine, sine;
};

// n equal steps of a full turn.
std::vector<Turn> turns(std::uint32_t n) {
  std::vector<Turn> table(n);
  for (std::uint32_t i = 0; i < n; ++i) {
    const double angle = 6.283185307179586 * i / n;
    table[i] = {std::cos(angle), std::sin(angle)};
  }
  return table;
}

// Quadrilaterals between columns of rows+1 vertices, column by column; `vertex` maps (column, row),
// where column may be `columns`, to an index, and so decides what is glued to what.
template <class VertexAt>
std::vector<std::uint32_t> weave(std::uint32_t columns, std::uint32_t rows, VertexAt vertex) {
  std::vector<std::uint32_t> corners;
  corners.reserve(std::size_t{6} * columns * rows);
  for (std::uint32_t i = 0; i < columns; ++i)
    for (std::uint32_t j = 0; j < rows; ++j)
      add_quad(corners, {vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
  return corners;
}

void add_on_sphere(Points& points, double x, double y, double z) {
  const double length = std::sqrt(x * x + y * y + z * z);
  points.add(x / length, y / length, z / length);
}

// Splits every triangle in four; the new vertices go to the sphere.
//
//          2
//         / \            m[k] is the middle of the edge from corner k
//      m2/___\m1         to corner k+1.
//       / \ / \.
//      0---m0--1
std::pair<Points, std::vector<std::uint32_t>> quadrisect(
    Points points, const std::vector<std::uint32_t>& corners) {
  const std::vector<std::uint32_t> twin = twins_of(corners, points.size());
  std::vector<std::uint32_t> middle(corners.size());
  for (std::uint32_t h = 0; h < corners.size(); ++h) {
    if (twin[h] < h) {
      middle[h] = middle[twin[h]];
      continue;
    }
    const Point a = points.list()[corners[h]], b = points.list()[corners[next_corner(h)]];
    middle[h] = points.size();
    add_on_sphere(points, double{a[0]} + b[0], double{a[1]} + b[1], double{a[2]} + b[2]);
  }
  std::vector<std::uint32_t> split;
  split.reserve(4 * corners.size());
  for (std::size_t f = 0; f < corners.size(); f += 3) {
    for (std::size_t k = 0; k < 3; ++k)
      split.insert(split.end(), {corners[f + k], middle[f + k], middle[f + (k + 2) % 3]});
    split.insert(split.end(), {middle[f], middle[f + 1], middle[f + 2]});
  }
  return {std::move(points), std::move(split)};
}

}  // namespace

Mesh single_triangle() {
  Points points;
  points.add(0, 0, 0);
  points.add(1, 0, 0);
  points.add(0, 1, 0);
  return make_mesh(points, {0, 1, 2});
}

Mesh glued_pair() {
  Mesh mesh = single_triangle();
  mesh.corners = {0, 1, 2, 0, 2, 1};
  return mesh;
}

Mesh tetrahedron() {
  Points points;
  points.add(1, 1, 1);
  points.add(1, -1, -1);
  points.add(-1, 1, -1);
  points.add(-1, -1, 1);
  return make_mesh(points, {0, 1, 2, 0, 2, 3, 0, 3, 1, 1, 3, 2});
}

Mesh icosphere(unsigned level) {
  Points points;
  const double golden = (1 + std::sqrt(5.0)) / 2;
  for (const double one : {1.0, -1.0})
    for (const double phi : {golden, -golden}) {
      add_on_sphere(points, 0, one, phi);
      add_on_sphere(points, one, phi, 0);
      add_on_sphere(points, phi, 0, one);
    }
  std::vector<std::uint32_t> corners;
  const auto near = [&](std::uint32_t a, std::uint32_t b) {
    const Point p = points.list()[a], q = points.list()[b];
    return a != b && p[0] * q[0] + p[1] * q[1] + p[2] * q[2] > 0.4f;
  };
  const auto outward = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    const Point p = points.list()[a], q = points.list()[b], r = points.list()[c];
    return p[0] * (q[1] * r[2] - q[2] * r[1]) + p[1] * (q[2] * r[0] - q[0] * r[2]) +
               p[2] * (q[0] * r[1] - q[1] * r[0]) >
           0;
  };
  for (std::uint32_t a = 0; a < 12; ++a)
    for (std::uint32_t b = a + 1; b < 12; ++b)
      for (std::uint32_t c = a + 1; c < 12; ++c)
        if (near(a, b) && near(b, c) && near(c, a) && outward(a, b, c))
          corners.insert(corners.end(), {a, b, c});

  for (unsigned i = 0; i < level; ++i)
    std::tie(points, corners) = quadrisect(std::move(points), corners);
  return make_mesh(points, std::move(corners));
}

Mesh torus(std::uint32_t around, std::uint32_t across) {
  Points points(std::size_t{around} * across);
  const std::vector<Turn> u = turns(around), v = turns(across);
  for (const Turn& a : u)
    for (const Turn& b : v) {
      const double radius = 1 + 0.4 * b.cosine;
      points.add(radius * a.cosine, radius * a.sine, 0.4 * b.sine);
    }
  return make_mesh(points, weave(around, across, [=](std::uint32_t i, std::uint32_t j) {
                     return (i == around ? 0 : i) * across + (j == across ? 0 : j);
                   }));
}

Mesh grid(std::uint32_t columns, std::uint32_t rows) {
  Points points((std::size_t{columns} + 1) * (rows + 1));
  for (std::uint32_t i = 0; i <= columns; ++i)
    for (std::uint32_t j = 0; j <= rows; ++j) points.add(i, j, 0);
  return make_mesh(points, weave(columns, rows, [=](std::uint32_t i, std::uint32_t j) {
                     return i * (rows + 1) + j;
                   }));
}

Mesh cylinder(std::uint32_t around, std::uint32_t rows) {
  Points points(std::size_t{around} * (rows + 1));
  const double step = 6.283185307179586 / around;  // quadrilaterals come out nearly square
  for (const Turn& a : turns(around))
    for (std::uint32_t j = 0; j <= rows; ++j) points.add(a.cosine, a.sine, step * j);
  return make_mesh(points, weave(around, rows, [=](std::uint32_t i, std::uint32_t j) {
                     return (i == around ? 0 : i) * (rows + 1) + j;
                   }));
}

Mesh moebius_strip(std::uint32_t around, std::uint32_t rows) {
  Points points(std::size_t{around} * (rows + 1));
  const std::vector<Turn> whole = turns(around), half = turns(2 * around);
  for (std::uint32_t i = 0; i < around; ++i)
    for (std::uint32_t j = 0; j <= rows; ++j) {
      const double width = 0.8 * j / rows - 0.4;
      const double radius = 1 + width * half[i].cosine;
      points.add(radius * whole[i].cosine, radius * whole[i].sine, width * half[i].sine);
    }
  return make_mesh(points, weave(around, rows, [=](std::uint32_t i, std::uint32_t j) {
                     return i == around ? rows - j : i * (rows + 1) + j;
                   }));
}

}  // namespace clers::corpus
