// Mirror planes and partners, on shapes that have them by construction.
#include "codec/attributes/mirror.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "codec/connectivity/connectivity.h"
#include "codec/soup/adjacency.h"
#include "corpus/generate.h"
#include "corpus/random.h"

namespace clers::internal {
namespace {

template <class Int>
struct Shape {
  CodedArrays arrays;
  std::vector<Int> rows;
  std::array<Axis, 3> axes;

  Lattice<Int> lattice() { return {rows, axes}; }
  std::size_t count() const { return rows.size() / 3; }
};

/// A torus, coded, with integers by what `place` says of its two parameters.
template <class Int, class Place>
Shape<Int> torus(std::uint32_t around, std::uint32_t across, std::uint64_t top, Place place) {
  const Mesh mesh = corpus::torus(around, across);
  auto twins = find_twins({mesh.corners, mesh.face_sizes}, mesh.vertex_count);
  EXPECT_TRUE(twins.ok());
  const auto bytes = encode_connectivity({mesh.corners, *twins, mesh.vertex_count}, 5);
  const auto header = read_connectivity_header(bytes->bytes, 0);
  Shape<Int> shape;
  shape.arrays.corners.resize(mesh.corners.size());
  shape.arrays.twins.resize(mesh.corners.size());
  shape.arrays.introduced_by.resize(mesh.vertex_count);
  EXPECT_TRUE(decode_connectivity(bytes->bytes, 0, *header, shape.arrays.corners,
                                  shape.arrays.twins, shape.arrays.introduced_by)
                  .ok());
  // Which vertex of the mesh each coded one is.
  shape.rows.resize(3 * std::size_t(mesh.vertex_count));
  for (Axis& axis : shape.axes) axis.top = top;
  for (std::uint32_t v = 0; v < mesh.vertex_count; ++v) {
    const std::uint32_t m = bytes->vertices[v];
    const std::array<Int, 3> row = place(m / across, m % across);
    std::copy(row.begin(), row.end(), shape.rows.begin() + 3 * std::ptrdiff_t(v));
  }
  return shape;
}

constexpr std::uint32_t around = 40, across = 30;

/// A torus whose halves are images of each other, rough in the same way; the rest lies on the
/// plane. Where `noise` is, one half is moved by up to as much.
template <class Int>
Shape<Int> mirrored(Int sum, std::uint64_t top, std::uint32_t noise = 0) {
  corpus::Random moved(2);
  return torus<Int>(around, across, top, [&](std::uint32_t i, std::uint32_t j) {
    const std::uint32_t k = std::min(i, around - i);
    corpus::Random rough(k * across + j);
    const std::uint32_t out = std::min(k, around / 2 - k);
    Int x = sum / 2;
    if (out > 0) x = x + Int(20 * out + j + rough.below(8));
    const Int y = Int(30 * k + 2 * j + rough.below(8)), z = Int(25 * std::min(j, across - j) + j);
    if (i > around / 2) x = sum - x;
    std::array<Int, 3> row = {y, x, z};
    if (noise && i > around / 2)
      for (Int& c : row) c += Int(moved.below(noise + 1));
    return row;
  });
}

/// A torus that is its own image after a quarter turn about (sum, sum2) / 2, rough but for that.
Shape<std::int32_t> turned(std::int32_t sum, std::int32_t sum2) {
  return torus<std::int32_t>(around, across, 4095, [&](std::uint32_t i, std::uint32_t j) {
    const std::uint32_t k = i % (around / 4);
    corpus::Random rough(k * across + j);
    // In half steps from the middle, odd where it is between two.
    std::int32_t x = 2 * std::int32_t(60 * (around / 4 - k) + 9 * j + rough.below(8)) + sum % 2;
    std::int32_t y = 2 * std::int32_t(60 * k + 9 * j + rough.below(8)) + sum % 2;
    for (std::uint32_t turns = i / (around / 4); turns > 0; --turns) {
      const std::int32_t before = x;
      x = -y;
      y = before;
    }
    return std::array<std::int32_t, 3>{
        (sum2 + y) / 2, std::int32_t(40 * std::min(j, across - j) + k), (sum + x) / 2};
  });
}

/// A torus with two mirrors at right angles.
Shape<std::int32_t> mirrored_twice() {
  return torus<std::int32_t>(around, across, 4095, [&](std::uint32_t i, std::uint32_t j) {
    const std::uint32_t k = std::min(i, around - i), l = std::min(j, across - j);
    corpus::Random rough(k * across + l);
    const std::uint32_t out = std::min(k, around / 2 - k), off = std::min(l, across / 2 - l);
    const auto x = std::int32_t(out ? 20 * out + 3 * l + rough.below(8) : 0);
    const auto z = std::int32_t(off ? 30 * off + 2 * k + rough.below(8) : 0);
    return std::array<std::int32_t, 3>{1000 + (i > around / 2 ? -x : x),
                                       std::int32_t(40 * k + 5 * l + rough.below(8)),
                                       800 + (j > across / 2 ? -z : z)};
  });
}

struct Met {
  std::size_t guessed = 0, right = 0;
  std::vector<std::uint32_t> guesses, partners;
};

/// Meets the vertices in coded order. Before one is known nobody may look at its row.
template <class Int>
Met meet(const Shape<Int>& shape, const Symmetry& plane) {
  std::vector<Int> rows(shape.rows.size(), Int(-1));
  const CodedSurface surface = shape.arrays.view();
  Mirror<Int> mirror(plane, rows.data(), shape.count(), surface);
  Met met;
  for_each_introduced(surface, [&](std::uint32_t t, unsigned i) {
    const std::uint32_t* c = &surface.corners[3 * std::size_t(t)];
    std::uint32_t guess = mirror.nobody;
    const HalfEdge across_gate = surface.twins[3 * std::size_t(t)];
    if (i == 2 && across_gate) {
      const std::uint32_t o = surface.corners[lprev(across_gate).index()];
      std::array<Int, 3> prediction;
      for (std::size_t k = 0; k < 3; ++k)
        prediction[k] = rows[3 * c[0] + k] + rows[3 * c[1] + k] - rows[3 * o + k];
      guess = mirror.guess(c[0], c[1], prediction.data());
    }
    const std::uint32_t v = c[i];
    const auto row = shape.rows.begin() + 3 * std::ptrdiff_t(v);
    if (guess != mirror.nobody) {
      ++met.guessed;
      met.right += std::equal(
          row, row + 3,
          std::array{mirror.image(guess, 0), mirror.image(guess, 1), mirror.image(guess, 2)}
              .begin());
    }
    met.guesses.push_back(guess);
    std::copy(row, row + 3, rows.begin() + 3 * std::ptrdiff_t(v));
    mirror.known(v, guess);
  });
  for (std::uint32_t v = 0; v < shape.count(); ++v) met.partners.push_back(mirror.partner(v));
  return met;
}

/// Every partner's image is where a vertex is, but for what may be rounded and what was guessed.
template <class Int>
void expect_images(const Shape<Int>& shape, const Symmetry& symmetry, const Met& met) {
  const SymmetryMaps<Int> maps(symmetry);
  std::size_t paired = 0, exactly = 0;
  for (std::uint32_t v = 0; v < shape.count(); ++v) {
    const std::uint32_t w = met.partners[v];
    if (w == Mirror<Int>::nobody) continue;
    ++paired;
    bool is_one = false;
    for (unsigned m = 0; m < maps.count(); ++m) {
      bool same = true;
      for (std::size_t c = 0; c < 3; ++c)
        same = same && maps.image(m, &shape.rows[3 * w], c) == shape.rows[3 * v + c];
      is_one = is_one || same;
    }
    exactly += is_one;
  }
  EXPECT_GT(paired, shape.count() * 9 / 10);
  EXPECT_GT(exactly, paired * 95 / 100);
}

/// Whether the surface has the triangle p q w.
bool has_triangle(const CodedSurface& s, std::uint32_t p, std::uint32_t q, std::uint32_t w) {
  for (std::uint32_t h = 0; h < s.corners.size(); ++h) {
    const HalfEdge g(h);
    if (s.corners[h] == p && s.corners[lnext(g).index()] == q && s.corners[lprev(g).index()] == w)
      return true;
  }
  return false;
}

/// Meets the vertices in coded order, guessed by connectivity.
Met meet_by_triangles(const Shape<std::int32_t>& shape, const Symmetry& symmetry, bool strictly) {
  const CodedSurface s = shape.arrays.view();
  Mirror<std::int32_t> mirror(symmetry, shape.rows.data(), shape.count(), s);
  Met met;
  for_each_introduced(s, [&](std::uint32_t t, unsigned i) {
    const std::uint32_t* c = &s.corners[3 * std::size_t(t)];
    std::uint32_t w = mirror.nobody;
    const HalfEdge over = s.twins[3 * std::size_t(t)];
    if (i == 2 && over) w = mirror.guess(c[0], c[1], s.corners[lprev(over).index()], strictly);
    if (w != mirror.nobody) {
      ++met.guessed;
      std::uint32_t q = mirror.partner(c[0]), p = mirror.partner(c[1]);
      if (symmetry.kind != Symmetry::mirror) std::swap(p, q);  // turns do not reverse
      EXPECT_TRUE(has_triangle(s, p, q, w));
      bool same = true;
      for (std::size_t k = 0; k < 3; ++k)
        same = same && std::abs(mirror.image(w, k) - shape.rows[3 * c[2] + k]) <= 1;
      met.right += same;
    }
    mirror.known(c[i], w);
  });
  return met;
}

TEST(Mirror, GuessesByTheTrianglesOfPartners) {
  // Turned triangles are triangles; mirrored ones are not where all squares are cut alike.
  auto turn = turned(2000, 2000);
  const auto found = find_mirror(turn.lattice());
  ASSERT_TRUE(found && found->kind == Symmetry::quarter_turn);
  const Met by_turn = meet_by_triangles(turn, *found, false);
  EXPECT_GT(by_turn.guessed, turn.count() * 4 / 10);
  EXPECT_GT(by_turn.right, by_turn.guessed * 9 / 10);
  EXPECT_LT(meet_by_triangles(turn, *found, true).guessed, by_turn.guessed);
  const auto mirror = mirrored<std::int32_t>(2000, 4095);
  EXPECT_GT(meet_by_triangles(mirror, {1, 2000}, false).guessed, mirror.count() / 10);
}

TEST(Mirror, FindsThePlaneAndGuessesTheOtherHalf) {
  for (const std::int32_t sum : {2000, 2001}) {
    auto shape = mirrored<std::int32_t>(sum, 4095);
    const auto plane = find_mirror(shape.lattice());
    ASSERT_TRUE(plane);
    EXPECT_EQ(plane->axis, 1u);
    EXPECT_EQ(plane->sum, std::uint64_t(sum));
    const Met met = meet(shape, *plane);
    EXPECT_GT(met.guessed, shape.count() * 4 / 10);
    EXPECT_GT(met.right, met.guessed * 7 / 10);
    for (std::uint32_t v = 0; v < shape.count(); ++v) {
      const std::uint32_t w = met.partners[v];
      ASSERT_NE(w, Mirror<std::int32_t>::nobody);
      EXPECT_EQ(met.partners[w], v);
      const std::int32_t off = shape.rows[3 * v + 1] + shape.rows[3 * w + 1] - sum;
      EXPECT_LE(std::abs(off), 1);
      EXPECT_EQ(shape.rows[3 * v], shape.rows[3 * w]);
      EXPECT_EQ(shape.rows[3 * v + 2], shape.rows[3 * w + 2]);
    }
  }
}

TEST(Mirror, FindsQuarterTurnsAndGuessesThreeQuarters) {
  for (const std::int32_t sum : {2000, 2001}) {
    auto shape = turned(sum, sum + 200);
    const auto found = find_mirror(shape.lattice());
    ASSERT_TRUE(found);
    EXPECT_EQ(found->kind, Symmetry::quarter_turn);
    EXPECT_EQ(found->axis, 2u);
    EXPECT_EQ(found->sum, std::uint64_t(sum));
    EXPECT_EQ(found->sum2, std::uint64_t(sum + 200));
    const Met met = meet(shape, *found);
    EXPECT_GT(met.guessed, shape.count() * 65 / 100);
    EXPECT_GT(met.right, met.guessed * 8 / 10);
    expect_images(shape, *found, met);
  }
}

/// About another place than the middle of all, which is moved by one that has no images.
TEST(Mirror, FindsQuarterTurnsAboutAnyPlace) {
  auto shape = turned(2000, 2200);
  shape.rows[2] = 4000;
  const auto found = find_mirror(shape.lattice());
  ASSERT_TRUE(found);
  EXPECT_EQ(found->kind, Symmetry::quarter_turn);
  EXPECT_EQ(found->axis, 2u);
  EXPECT_EQ(found->sum, 2000u);
  EXPECT_EQ(found->sum2, 2200u);
}

TEST(Mirror, FindsTwoMirrors) {
  auto shape = mirrored_twice();
  const auto found = find_mirror(shape.lattice());
  ASSERT_TRUE(found);
  EXPECT_EQ(found->kind, Symmetry::mirrors);
  EXPECT_EQ(found->axis, 2u);
  EXPECT_EQ(found->sum, 1600u);
  EXPECT_EQ(found->sum2, 2000u);
  const Met met = meet(shape, *found);
  const Met one = meet(shape, Symmetry{0, 2000});
  EXPECT_GT(met.guessed, one.guessed * 5 / 4);
  EXPECT_GT(met.right, one.right * 6 / 5);
  expect_images(shape, *found, met);
  expect_images(shape, Symmetry{2, 1600, Symmetry::half_turn, 2000},
                meet(shape, Symmetry{2, 1600, Symmetry::half_turn, 2000}));
}

TEST(Mirror, MapsAreAGroup) {
  corpus::Random random(4);
  for (std::uint32_t axis = 0; axis < 3; ++axis)
    for (const auto kind :
         {Symmetry::mirror, Symmetry::mirrors, Symmetry::half_turn, Symmetry::quarter_turn}) {
      const SymmetryMaps<std::int64_t> maps({axis, 2 * most_wide, kind, kind ? 4u : 0u});
      EXPECT_EQ(maps.count(), kind == Symmetry::mirror || kind == Symmetry::half_turn ? 1u : 3u);
      for (unsigned m = 0; m < maps.count(); ++m)
        for (int i = 0; i < 20; ++i) {
          std::array<std::int64_t, 3> x, y, z;
          for (std::int64_t& c : x) c = std::int64_t(random.next() % (most_wide + 1));
          for (std::size_t c = 0; c < 3; ++c) y[c] = maps.image(m, x.data(), c);
          for (std::size_t c = 0; c < 3; ++c) z[c] = maps.image(maps.inverse(m), y.data(), c);
          EXPECT_EQ(x, z);
          for (std::size_t c = 0; c < 3; ++c) {
            EXPECT_LE(y[c], 2 * std::int64_t(most_wide));
            EXPECT_GE(y[c], -std::int64_t(most_wide));
            EXPECT_TRUE(maps.moves(m, c) || x[c] == y[c]);
          }
          // Two quarter turns are a half.
          for (std::size_t c = 0; c < 3 && kind == Symmetry::quarter_turn && m == 0; ++c)
            EXPECT_EQ(maps.image(0, y.data(), c), maps.image(1, x.data(), c));
        }
    }
}

TEST(Mirror, IsTheSameForWideIntegers) {
  auto narrow = mirrored<std::int32_t>(2001, 4095);
  auto wide = mirrored<std::int64_t>(2001, 4095);
  const auto plane = find_mirror(wide.lattice());
  ASSERT_TRUE(plane);
  EXPECT_EQ(plane->sum, 2001u);
  const Met a = meet(narrow, *plane), b = meet(wide, *plane);
  EXPECT_EQ(a.guesses, b.guesses);
  EXPECT_EQ(a.partners, b.partners);
}

TEST(Mirror, HalvesThatDifferALittleKeepTheirPartners) {
  auto shape = mirrored<std::int32_t>(2000, 4095, 2);
  const Met met = meet(shape, Symmetry{1, 2000});
  std::size_t paired = 0;
  for (std::uint32_t v = 0; v < shape.count(); ++v)
    paired += met.partners[v] != Mirror<std::int32_t>::nobody && met.partners[v] != v;
  EXPECT_GT(paired, shape.count() * 3 / 10);
}

TEST(Mirror, FindsNoneWhereThereIsNone) {
  corpus::Random random(1);
  const auto rough = torus<std::int32_t>(around, across, 4095, [&](std::uint32_t, std::uint32_t) {
    return std::array<std::int32_t, 3>{std::int32_t(random.below(4096)),
                                       std::int32_t(random.below(4096)),
                                       std::int32_t(random.below(4096))};
  });
  auto copy = rough;
  EXPECT_FALSE(find_mirror(copy.lattice()));
  Shape<std::int32_t> empty;
  EXPECT_FALSE(find_mirror(empty.lattice()));
  empty.rows = {1, 2, 3};
  empty.axes.fill({3});
  EXPECT_FALSE(find_mirror(empty.lattice()));
}

// Were a step of any of these linear, the test would take hours.
TEST(Mirror, TakesLinearTimeWhereAllIsInOnePlaceOrAroundOneVertex) {
  constexpr std::uint32_t n = 1u << 18;
  // Triangles (0, i, i + 1) around vertex 0.
  Shape<std::int64_t> fan;
  fan.arrays.introduced_by.assign(n, 0);
  for (std::uint32_t i = 1; i + 1 < n; ++i) {
    const std::uint32_t h = 3 * (i - 1);
    for (const std::uint32_t v : {0u, i, i + 1}) fan.arrays.corners.push_back(v);
    fan.arrays.introduced_by[i + 1] = i - 1;
    fan.arrays.twins.push_back(i > 1 ? HalfEdge(h - 1) : HalfEdge());
    fan.arrays.twins.push_back(HalfEdge());
    fan.arrays.twins.push_back(i + 2 < n ? HalfEdge(h + 3) : HalfEdge());
  }
  fan.axes.fill({most_wide});
  for (const std::uint64_t spread : {std::uint64_t(1), std::uint64_t(8), most_wide}) {
    corpus::Random random(spread);
    fan.rows.resize(3 * std::size_t(n));
    for (std::int64_t& x : fan.rows) x = std::int64_t(random.next() % spread);
    const Lattice<std::int64_t> lattice = fan.lattice();
    EXPECT_FALSE(find_mirror(lattice));
    for (const auto kind : {Symmetry::mirror, Symmetry::mirrors, Symmetry::quarter_turn}) {
      const Symmetry plane = {2, spread - 1, kind, kind ? spread - 1 : 0};
      Mirror<std::int64_t> mirror(plane, fan.rows.data(), n, fan.arrays.view());
      for (const std::uint32_t v : {0u, 1u}) mirror.known(v);
      for (std::uint32_t v = 2; v < n; ++v) {
        std::array<std::int64_t, 3> prediction;
        for (std::size_t c = 0; c < 3; ++c)
          prediction[c] = v % 2 ? -std::int64_t(most_wide) : 2 * std::int64_t(most_wide);
        const std::uint32_t w = mirror.guess(0, v - 1, prediction.data());
        ASSERT_TRUE(w < v || w == mirror.nobody);
        mirror.known(v, w);
      }
    }
  }
}

TEST(Mirror, WithoutTwinsNobodyIsGuessed) {
  auto shape = mirrored<std::int32_t>(2000, 4095);
  Mirror<std::int32_t> mirror({1, 2000}, shape.rows.data(), shape.count(),
                              {shape.arrays.corners, {}, shape.arrays.introduced_by});
  for (std::uint32_t v = 0; v < shape.count(); ++v) mirror.known(v);
  const std::array<std::int32_t, 3> prediction = {1, 1, 1};
  for (const std::uint32_t t : shape.arrays.introduced_by)
    EXPECT_EQ(mirror.guess(shape.arrays.corners[3 * t], shape.arrays.corners[3 * t + 1],
                           prediction.data()),
              mirror.nobody);
}

TEST(Mirror, BytesComeBackOrAreRefused) {
  const std::array<Axis, 3> axes = {Axis{10}, Axis{most_wide}, Axis{0}};
  const auto read = [&](Bytes bytes) {
    ByteReader in(bytes, 7);
    return read_mirror(in, axes);
  };
  for (const std::optional<Symmetry> given :
       {std::optional<Symmetry>(), std::optional(Symmetry{0, 20}),
        std::optional(Symmetry{1, 2 * most_wide}), std::optional(Symmetry{2, 0}),
        std::optional(Symmetry{0, 7, Symmetry::mirrors, 2 * most_wide}),
        std::optional(Symmetry{2, 0, Symmetry::half_turn, 5}),
        std::optional(Symmetry{0, 20, Symmetry::quarter_turn, 2})}) {
    Bytes bytes;
    put_mirror(bytes, given);
    const auto back = read(bytes);
    ASSERT_TRUE(back.ok());
    ASSERT_EQ(back->has_value(), given.has_value());
    if (given) {
      EXPECT_EQ((*back)->axis, given->axis);
      EXPECT_EQ((*back)->sum, given->sum);
      EXPECT_EQ((*back)->kind, given->kind);
      EXPECT_EQ((*back)->sum2, given->sum2);
    }
    bytes.pop_back();
    ASSERT_FALSE(read(bytes).ok());
    EXPECT_EQ(read(bytes).error().code, ErrorCode::truncated);
  }
  const auto refused = [&](std::uint32_t kind, std::uint64_t sum, std::uint64_t sum2 = 0) {
    Bytes bytes;
    put_u8(bytes, kind);
    put_varint(bytes, sum);
    if (kind > 3) put_varint(bytes, sum2);
    const auto back = read(bytes);
    return !back.ok() && back.error().code == ErrorCode::invalid && back.error().at == 7;
  };
  EXPECT_TRUE(refused(1, 21));
  EXPECT_TRUE(refused(3, 1));
  EXPECT_TRUE(refused(13, 0));
  EXPECT_TRUE(refused(255, 0));
  EXPECT_TRUE(refused(6, 0, 21));
  EXPECT_TRUE(refused(10, 3, 4));
  EXPECT_FALSE(refused(10, 3, 5));
  EXPECT_FALSE(refused(1, 20));
}

}  // namespace
}  // namespace clers::internal
