// sin x cos y + sin y cos z + sin z cos x = 0 by marching tetrahedra (Doi and Koide 1991) on the
// Freudenthal subdivision of a cubic lattice: the level set of a piecewise linear function on a
// triangulated 3-manifold is a surface whatever the samples' signs, with its boundary in that of
// the box.
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "corpus/build.h"
#include "corpus/generate.h"

namespace clers::corpus {
namespace {

// Samples are integers, so that signs and with them the topology are the same on every machine.
using Sample = std::int64_t;

struct Wave {
  Sample sine, cosine;
};

std::vector<Wave> one_period(std::uint32_t resolution) {
  const double unit = 1 << 20;
  std::vector<Wave> wave(resolution);
  for (std::uint32_t i = 0; i < resolution; ++i) {
    const double angle = 6.283185307179586 * i / resolution;
    wave[i] = {std::llround(unit * std::sin(angle)), std::llround(unit * std::cos(angle))};
  }
  return wave;
}

// Corners of a cube are numbered by their bits zyx. The six tetrahedra of the paths 0 -> 7, each
// listed with positive volume.
constexpr std::array<std::array<unsigned, 4>, 6> tetrahedra = {{
    {0, 1, 3, 7},
    {0, 2, 6, 7},
    {0, 4, 5, 7},
    {0, 5, 1, 7},
    {0, 3, 2, 7},
    {0, 6, 4, 7},
}};

// One layer of lattice points: samples, and the surface's vertices on the seven lattice edges that
// go up from each point, by the bits zyx of their direction (entry 0 is not used).
struct Layer {
  std::vector<Sample> samples;
  std::vector<std::array<std::uint32_t, 8>> crossings;
};

class Marcher {
 public:
  Marcher(std::array<std::uint32_t, 3> cells, std::uint32_t resolution, Ends ends)
      : resolution_(resolution), ends_(ends), wave_(one_period(resolution)) {
    for (std::size_t k = 0; k < 3; ++k) {
      cubes_[k] = cells[k] * resolution + (ends == Ends::capped ? 2 : 0);
      lattice_[k] = cubes_[k] + (ends == Ends::periodic ? 0 : 1);
    }
  }

  Mesh run() {
    Layer first = layer(0), below = first, above;
    for (std::uint32_t z = 0; z < cubes_[2]; ++z) {
      const bool wraps = z + 1 == lattice_[2];
      above = wraps ? std::move(first) : layer(z + 1);
      for (std::uint32_t y = 0; y < cubes_[1]; ++y)
        for (std::uint32_t x = 0; x < cubes_[0]; ++x) march({x, y, z}, below, above);
      if (z == 0 && ends_ == Ends::periodic) first = below;  // with the vertices made so far
      std::swap(below, above);
    }
    return make_mesh(points_, std::move(corners_));
  }

 private:
  std::size_t index(std::uint32_t x, std::uint32_t y) const {
    return std::size_t{y % lattice_[1]} * lattice_[0] + x % lattice_[0];
  }

  Layer layer(std::uint32_t z) const {
    Layer out;
    out.samples.resize(std::size_t{lattice_[0]} * lattice_[1]);
    out.crossings.assign(out.samples.size(), {none, none, none, none, none, none, none, none});
    for (std::uint32_t y = 0; y < lattice_[1]; ++y)
      for (std::uint32_t x = 0; x < lattice_[0]; ++x) out.samples[index(x, y)] = sample(x, y, z);
    return out;
  }

  // Positive inside. A capped box is surrounded by one layer of points outside.
  Sample sample(std::uint32_t x, std::uint32_t y, std::uint32_t z) const {
    if (ends_ == Ends::capped) {
      if (x == 0 || y == 0 || z == 0 || x == cubes_[0] || y == cubes_[1] || z == cubes_[2])
        return far_outside;
      --x, --y, --z;
    }
    const Wave &a = wave_[x % resolution_], &b = wave_[y % resolution_],
               &c = wave_[z % resolution_];
    return a.sine * b.cosine + b.sine * c.cosine + c.sine * a.cosine;
  }

  struct Cube {
    std::array<std::uint32_t, 3> at;
    std::array<Sample, 8> samples;
    std::array<std::array<std::uint32_t, 8>*, 8> crossings;

    bool inside(unsigned corner) const { return samples[corner] > 0; }
  };

  void march(std::array<std::uint32_t, 3> at, Layer& below, Layer& above) {
    Cube cube{at, {}, {}};
    unsigned inside = 0;
    for (unsigned k = 0; k < 8; ++k) {
      Layer& side = k & 4 ? above : below;
      const std::size_t i = index(at[0] + (k & 1), at[1] + (k >> 1 & 1));
      cube.samples[k] = side.samples[i];
      cube.crossings[k] = &side.crossings[i];
      inside += cube.inside(k);
    }
    if (inside == 0 || inside == 8) return;
    for (const std::array<unsigned, 4>& t : tetrahedra) cut(cube, t);
  }

  // Triangles between the inner and the outer corners of the tetrahedron t, seen counterclockwise
  // from outside. `order` lists the corners evenly permuted, the inner ones (or a lone outer one)
  // first.
  void cut(const Cube& cube, const std::array<unsigned, 4>& t) {
    static constexpr std::array<std::array<unsigned, 4>, 16> order = {{
        {},
        {0, 1, 2, 3},
        {1, 0, 3, 2},
        {0, 1, 2, 3},  //
        {2, 3, 0, 1},
        {0, 2, 3, 1},
        {1, 2, 0, 3},
        {3, 2, 1, 0},  //
        {3, 2, 1, 0},
        {0, 3, 1, 2},
        {1, 3, 2, 0},
        {2, 3, 0, 1},  //
        {2, 3, 0, 1},
        {1, 0, 3, 2},
        {0, 1, 2, 3},
        {},
    }};
    unsigned mask = 0;
    for (unsigned k = 0; k < 4; ++k) mask |= unsigned{cube.inside(t[k])} << k;
    if (mask == 0 || mask == 15) return;
    const std::array<unsigned, 4>& o = order[mask];
    const unsigned i = t[o[0]], j = t[o[1]], k = t[o[2]], l = t[o[3]];
    if (std::popcount(mask) == 2) {
      add_quad(corners_, {crossing(cube, i, k), crossing(cube, i, l), crossing(cube, j, l),
                          crossing(cube, j, k)});
    } else if (cube.inside(i)) {
      corners_.insert(corners_.end(),
                      {crossing(cube, i, j), crossing(cube, i, k), crossing(cube, i, l)});
    } else {
      corners_.insert(corners_.end(),
                      {crossing(cube, i, j), crossing(cube, i, l), crossing(cube, i, k)});
    }
  }

  // The surface's vertex between two corners of a cube, one of which lies above the other in every
  // coordinate.
  std::uint32_t crossing(const Cube& cube, unsigned a, unsigned b) {
    if (a > b) std::swap(a, b);
    std::uint32_t& vertex = (*cube.crossings[a])[a ^ b];
    if (vertex != none) return vertex;
    const auto from = static_cast<double>(cube.samples[a]);
    double share = from / (from - static_cast<double>(cube.samples[b]));
    // Vertices stay apart even where a sample is zero.
    share = share < 0.1 ? 0.1 : share > 0.9 ? 0.9 : share;
    std::array<double, 3> p;
    for (unsigned k = 0; k < 3; ++k)
      p[k] = (cube.at[k] + (a >> k & 1) + share * ((a ^ b) >> k & 1)) / resolution_;
    return vertex = points_.add(p[0], p[1], p[2]);
  }

  static constexpr std::uint32_t none = 0xffffffffu;
  static constexpr Sample far_outside = -(Sample{1} << 50);  // so that the walls are flat

  std::uint32_t resolution_;
  Ends ends_;
  std::vector<Wave> wave_;
  std::array<std::uint32_t, 3> cubes_, lattice_;
  Points points_;
  std::vector<std::uint32_t> corners_;
};

}  // namespace

Mesh gyroid(std::uint32_t x, std::uint32_t y, std::uint32_t z, std::uint32_t resolution,
            Ends ends) {
  return Marcher({x, y, z}, resolution, ends).run();
}

}  // namespace clers::corpus
