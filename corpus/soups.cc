#include <vector>

#include "corpus/build.h"
#include "corpus/generate.h"
#include "corpus/random.h"

namespace clers::corpus {

Mesh random_soup(std::uint32_t vertices, std::uint32_t faces, std::uint32_t max_polygon,
                 std::uint64_t seed) {
  Random random(seed);
  Points points(vertices);
  for (std::uint32_t v = 0; v < vertices; ++v) {
    const std::uint32_t x = random.below(1024), y = random.below(1024), z = random.below(1024);
    points.add(x, y, z);
  }

  std::vector<std::uint32_t> corners, sizes, starts;
  for (std::uint32_t f = 0; f < faces; ++f) {
    starts.push_back(static_cast<std::uint32_t>(corners.size()));
    // By chance alone large soups would have no equal faces.
    if (f > 0 && random.chance(15)) {
      const std::uint32_t old = random.below(f), size = sizes[old], first = random.below(size);
      const std::uint32_t step =
          random.chance(50) ? 1 : size - 1;  // the same or the other way round
      for (std::uint32_t i = 0; i < size; ++i)
        corners.push_back(corners[starts[old] + (first + i * step) % size]);
      sizes.push_back(size);
      continue;
    }
    sizes.push_back(3 + random.below(max_polygon - 2));
    for (std::uint32_t i = 0; i < sizes.back(); ++i) {
      const bool again = i > 0 && random.chance(5);
      corners.push_back(again ? corners.back() : random.below(vertices));
    }
  }
  Mesh mesh = make_mesh(points, std::move(corners));
  if (max_polygon > 3) mesh.face_sizes = std::move(sizes);
  return mesh;
}

Mesh fan(std::uint32_t n) {
  Mesh tube = cylinder(n, 1);  // its bottom ring, coned
  Points points(std::size_t{n} + 1);
  points.add(0, 0, 0);
  const std::vector<Point> ring = points_of(tube);
  std::vector<std::uint32_t> corners;
  for (std::uint32_t i = 0; i < n; ++i) {
    points.add(ring[2 * i][0], ring[2 * i][1], 0);
    corners.insert(corners.end(), {0, 1 + i, 1 + (i + 1) % n});
  }
  return make_mesh(points, std::move(corners));
}

Mesh book(std::uint32_t n) {
  Points points;
  points.add(0, 0, 0);
  points.add(0, 0, 1);
  std::vector<std::uint32_t> corners;
  for (std::uint32_t i = 0; i < n; ++i)
    corners.insert(corners.end(), {0, 1, points.add(1, i, 0.5)});
  return make_mesh(points, std::move(corners));
}

Mesh same_triangle(std::uint32_t n) {
  Mesh mesh = single_triangle();
  mesh.corners.resize(std::size_t{3} * n);
  for (std::size_t c = 0; c < mesh.corners.size(); ++c)
    mesh.corners[c] = static_cast<std::uint32_t>(c % 3);
  return mesh;
}

Mesh all_triples(std::uint32_t n) {
  Points points(n);
  std::vector<std::uint32_t> corners;
  for (std::uint32_t i = 0; i < n; ++i) {
    points.add(i, double(i) * i, i % 7);
    for (std::uint32_t j = i + 1; j < n; ++j)
      for (std::uint32_t k = j + 1; k < n; ++k) corners.insert(corners.end(), {i, j, k});
  }
  return make_mesh(points, std::move(corners));
}

Mesh pinched_hub(std::uint32_t n) {
  Points points(std::size_t{2} * n + 1);
  points.add(0, 0, 0);
  std::vector<std::uint32_t> corners;
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t a = points.add(1, i, 0), b = points.add(1, i, 1);
    corners.insert(corners.end(), {0, a, b});
  }
  return make_mesh(points, std::move(corners));
}

Mesh chessboard(std::uint32_t size) {
  Mesh board = grid(size, size);
  std::vector<std::uint32_t> black;
  for (std::uint32_t i = 0; i < size; ++i)
    for (std::uint32_t j = i % 2; j < size; j += 2) {
      const auto field = board.corners.begin() + 6 * (std::ptrdiff_t{i} * size + j);
      black.insert(black.end(), field, field + 6);
    }
  board.corners = std::move(black);
  return board;
}

//  1---3---5
//  | \ | \ | \.
//  0---2---4---6
Mesh strip(std::uint32_t n) {
  Points points(std::size_t{n} + 2);
  for (std::uint32_t v = 0; v < n + 2; ++v) points.add(v / 2, v % 2, 0);
  std::vector<std::uint32_t> corners;
  for (std::uint32_t f = 0; f < n; ++f)
    corners.insert(corners.end(), {f, f + 1 + (f + 1) % 2, f + 1 + f % 2});
  return make_mesh(points, std::move(corners));
}

Mesh loose_triangles(std::uint32_t n) {
  Points points(std::size_t{3} * n);
  std::vector<std::uint32_t> corners;
  for (std::uint32_t i = 0; i < n; ++i)
    corners.insert(corners.end(),
                   {points.add(i, 0, 0), points.add(i + 0.5, 0, 0), points.add(i, 1, 0)});
  return make_mesh(points, std::move(corners));
}

}  // namespace clers::corpus
