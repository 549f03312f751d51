#include "bench/fidelity.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>

#include "codec/compare.h"

namespace clers::bench {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

std::vector<Triangle> canonical(const std::vector<std::uint32_t>& corners,
                                const std::vector<std::uint32_t>* origin) {
  std::vector<Triangle> triangles(corners.size() / 3);
  for (std::size_t f = 0; f < triangles.size(); ++f) {
    Triangle& t = triangles[f];
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t v = corners[3 * f + i];
      if (origin && v >= origin->size())
        throw CodecFailure("gives a vertex index that is out of range");
      t[i] = origin ? (*origin)[v] : v;
    }
    // A triangle that uses its smallest vertex twice has two rotations that start with it.
    Triangle best = t;
    for (int turn = 0; turn < 2; ++turn) {
      std::rotate(t.begin(), t.begin() + 1, t.end());
      best = std::min(best, t);
    }
    t = best;
  }
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

std::uint64_t missing(const std::vector<Triangle>& from, const std::vector<Triangle>& in) {
  std::uint64_t count = 0;
  auto other = in.begin();
  for (const Triangle& t : from) {
    while (other != in.end() && *other < t) ++other;
    if (other != in.end() && *other == t) {
      ++other;
    } else {
      ++count;
    }
  }
  return count;
}

std::uint64_t positions_off(const Input& input, const Output& output, Mode mode) {
  if (mode == Mode::connectivity) return 0;
  if (output.positions.size() != 3 * output.origin.size())
    throw CodecFailure("gives another number of positions than of vertices");
  double allowed = 0;
  if (const int b = bits(mode)) {
    // Half a step, and what the rival's float arithmetic may round away.
    float largest = 0;
    for (const float x : input.positions) largest = std::max(largest, std::abs(x));
    const double step = grid_of(input, b).step;
    allowed = 0.5005 * step + 2.0 * largest * std::numeric_limits<float>::epsilon();
  }
  std::uint64_t off = 0;
  for (std::size_t v = 0; v < output.origin.size(); ++v) {
    const float* is = &output.positions[3 * v];
    const float* was = &input.positions[3 * std::size_t(output.origin[v])];
    if (mode == Mode::lossless) {
      off += std::memcmp(is, was, 3 * sizeof(float)) != 0;
    } else {
      bool near = true;
      for (int k = 0; k < 3; ++k) near &= std::abs(double(is[k]) - double(was[k])) <= allowed;
      off += !near;
    }
  }
  return off;
}

// Bit for bit, polygons and all attributes, up to the order of vertices and faces.
Fidelity check_file(const std::vector<Mesh>& before, const std::vector<Mesh>& after) {
  if (before.size() != after.size()) throw CodecFailure("gives another number of meshes");
  for (std::size_t m = 0; m < before.size(); ++m) {
    const auto compared = compare(before[m], after[m]);
    if (!compared) throw CodecFailure(describe(compared.error()));
    if (compared->verdict != Verdict::same) throw CodecFailure("other values: " + compared->what);
  }
  return {};
}

}  // namespace

Fidelity check(const Input& input, const Output& output, Mode mode) {
  if (mode == Mode::file) return check_file(input.file.meshes, output.meshes);
  std::vector<std::uint32_t> copies(input.vertex_count, 0);
  for (const std::uint32_t v : output.origin) {
    if (v >= input.vertex_count) throw CodecFailure("gives a vertex that was not in the input");
    ++copies[v];
  }
  const std::vector<Triangle> before = canonical(input.triangles, nullptr);
  const std::vector<Triangle> after = canonical(output.triangles, &output.origin);
  Fidelity f;
  f.triangles_lost = missing(before, after);
  f.triangles_added = missing(after, before);
  for (const std::uint32_t n : copies) {
    f.vertices_lost += n == 0;
    f.vertices_added += n > 1 ? n - 1 : 0;
  }
  f.positions_off = positions_off(input, output, mode);
  return f;
}

Grid grid_of(const Input& input, int bits) {
  Grid grid{};
  float high[3];
  for (std::size_t k = 0; k < 3; ++k)
    grid.origin[k] = high[k] = input.positions.empty() ? 0 : input.positions[k];
  for (std::size_t i = 0; i < input.positions.size(); ++i) {
    grid.origin[i % 3] = std::min(grid.origin[i % 3], input.positions[i]);
    high[i % 3] = std::max(high[i % 3], input.positions[i]);
  }
  for (int k = 0; k < 3; ++k) grid.side = std::max(grid.side, high[k] - grid.origin[k]);
  if (grid.side == 0) grid.side = 1;
  grid.step = grid.side / static_cast<float>((1 << bits) - 1);
  return grid;
}

std::vector<std::uint16_t> on_grid(const std::vector<float>& positions, const Grid& grid) {
  std::vector<std::uint16_t> numbers(positions.size());
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const float at = std::floor((positions[i] - grid.origin[i % 3]) / grid.step + 0.5f);
    if (!(at >= 0 && at <= 65535)) throw CodecFailure("is not finite: no grid holds it");
    numbers[i] = static_cast<std::uint16_t>(at);
  }
  return numbers;
}

std::vector<float> off_grid(const std::vector<std::uint16_t>& numbers, const Grid& grid) {
  std::vector<float> positions(numbers.size());
  for (std::size_t i = 0; i < numbers.size(); ++i)
    positions[i] = grid.origin[i % 3] + static_cast<float>(numbers[i]) * grid.step;
  return positions;
}

}  // namespace clers::bench
