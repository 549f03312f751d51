// Integers of vertices come back from the fast coder, whatever they and the surface are, and no
// bytes make it do anything else than return integers in range or an error.
#include "codec/attributes/ordered_integers.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <random>
#include <vector>

#include "codec/connectivity/connectivity.h"
#include "codec/test/coded_arrays.h"
#include "codec/test/polygon_surface.h"
#include "corpus/generate.h"

namespace clers::internal {
namespace {

using Random = std::mt19937_64;

using test::any_triangles;
using test::coded_without_twins;

std::vector<Axis> axes_of(std::vector<std::uint64_t> tops) {
  std::vector<Axis> axes;
  for (const std::uint64_t top : tops) axes.emplace_back().top = top;
  return axes;
}

template <class Int>
std::vector<Int> any_rows(std::size_t count, const std::vector<Axis>& axes, Random& random) {
  std::vector<Int> rows;
  const unsigned mostly = static_cast<unsigned>(random() % 62);
  for (std::size_t v = 0; v < count; ++v)
    for (const Axis& axis : axes) {
      const std::uint64_t small = (random() >> 1) & ((std::uint64_t(1) << mostly) - 1);
      rows.push_back(static_cast<Int>((random() % 8 == 0 ? random() : small) % (axis.top + 1)));
    }
  return rows;
}

/// What bytes decode to; empty if they are refused.
template <class Int>
std::vector<Int> decoded(const Bytes& bytes, std::size_t count, const CodedSurface& surface,
                         const std::vector<Axis>& axes) {
  std::vector<Int> rows(count * axes.size(), Int(-1));
  const Lattice<Int> lattice{rows, axes};
  const auto predictor = decode_residuals(std::span<const std::byte>(bytes), 7, lattice);
  if (!predictor) {
    EXPECT_TRUE(predictor.error().code == ErrorCode::invalid ||
                predictor.error().code == ErrorCode::truncated);
    EXPECT_GE(predictor.error().at, 7u);
    return {};
  }
  const auto done = add_steps(*predictor, surface, 7, lattice);
  if (!done) {
    EXPECT_EQ(done.error().code, ErrorCode::invalid);
    return {};
  }
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_GE(rows[i], 0);
    EXPECT_LE(static_cast<std::uint64_t>(rows[i]), axes[i % axes.size()].top);
  }
  return rows;
}

template <class Int>
Bytes check(const std::vector<Int>& rows, const CodedSurface& surface,
            const std::vector<Axis>& axes) {
  Bytes bytes;
  for (const int level : {1, 3}) {
    bytes = encode_ordered(Lattice<const Int>{rows, axes}, surface, level);
    EXPECT_EQ(decoded<Int>(bytes, rows.size() / axes.size(), surface, axes), rows);
  }
  return bytes;
}

template <class Int>
void check_hostile(const std::vector<Int>& rows, const CodedSurface& surface,
                   const std::vector<Axis>& axes, Random& random) {
  const Bytes bytes = check(rows, surface, axes);
  const std::size_t count = rows.size() / axes.size();
  for (unsigned i = 0; i < 60 && !bytes.empty(); ++i) {
    Bytes other = bytes;
    other[random() % (i % 2 != 0 ? other.size() : std::min<std::size_t>(other.size(), 16))] ^=
        std::byte(1 + random() % 255);
    decoded<Int>(other, count, surface, axes);
    other = bytes;
    other.resize(random() % bytes.size());
    EXPECT_TRUE(decoded<Int>(other, count, surface, axes).empty());
  }
  Bytes more = bytes;
  more.push_back({});
  EXPECT_TRUE(decoded<Int>(more, count, surface, axes).empty());
}

TEST(OrderedIntegers, NothingToSay) {
  const CodedArrays none;
  EXPECT_TRUE(check<std::int32_t>({}, none.view(), axes_of({5, 0})).empty());
  EXPECT_TRUE(check<std::int32_t>({0, 0, 0}, none.view(), axes_of({0})).empty());
  EXPECT_TRUE(check<std::int64_t>({0, 0}, none.view(), axes_of({0, 0})).empty());
  std::vector<std::int32_t> row{0};
  const std::vector<Axis> axes = axes_of({0});
  EXPECT_FALSE(
      decode_residuals(std::span<const std::byte>(Bytes(1)), 0, Lattice<std::int32_t>{row, axes}));
}

TEST(OrderedIntegers, FewAndExtreme) {
  constexpr std::int32_t narrow = static_cast<std::int32_t>(most_narrow);
  constexpr std::int64_t wide = static_cast<std::int64_t>(most_wide);
  const CodedArrays none, sphere = coded_without_twins(corpus::icosphere(1));
  for (const CodedArrays* arrays : {&none, &sphere}) {
    check<std::int32_t>({3}, arrays->view(), axes_of({3}));
    check<std::int32_t>({0}, arrays->view(), axes_of({narrow}));
    check<std::int32_t>({narrow, 0, 0, narrow, narrow, 0}, arrays->view(),
                        axes_of({narrow, narrow}));
    check<std::int64_t>({wide, 0, 0, wide, wide, 0}, arrays->view(), axes_of({wide, wide}));
    Random random(1);
    for (const std::size_t count : {std::size_t(42), std::size_t(50), std::size_t(3000)}) {
      std::vector<std::int32_t> ends;
      std::vector<std::int64_t> far_ends;
      for (std::size_t i = 0; i < 3 * count; ++i) {
        ends.push_back(random() % 2 != 0 ? narrow : 0);
        far_ends.push_back(random() % 2 != 0 ? wide : 0);
      }
      check(ends, arrays->view(), axes_of({narrow, narrow, narrow}));
      check(far_ends, arrays->view(), axes_of({wide, wide, wide}));
    }
  }
}

TEST(OrderedIntegers, EqualValuesTakeNothing) {
  const CodedArrays sphere = coded_without_twins(corpus::icosphere(3));
  const std::size_t count = sphere.introduced_by.size();
  std::vector<std::int32_t> rows(2 * count, 1000);
  EXPECT_LT(check(rows, sphere.view(), axes_of({2000, 2000})).size(), 40u);
  std::fill(rows.begin(), rows.end(), 0);
  EXPECT_LT(check(rows, sphere.view(), axes_of({2000, 2000})).size(), 8u);
}

RC_GTEST_PROP(OrderedIntegers, ComeBack, (std::uint64_t seed)) {
  Random random(seed);
  const std::array<Mesh, 4> meshes = {corpus::icosphere(2), corpus::grid(11, 7),
                                      corpus::loose_triangles(9),
                                      corpus::flip_edges(corpus::icosphere(2), 300, seed)};
  const std::uint32_t vertices = static_cast<std::uint32_t>(1 + random() % 60);
  const CodedArrays arrays = random() % 3 == 0
                                 ? any_triangles(vertices, vertices, random)
                                 : coded_without_twins(meshes[random() % meshes.size()]);
  // Some are isolated: of greater numbers than all in triangles, or among them.
  const std::size_t count = arrays.introduced_by.size() + random() % 5;
  std::vector<std::uint64_t> tops(1 + random() % 7);
  for (std::uint64_t& top : tops) top = (random() & most_narrow) >> random() % 30;
  check_hostile(any_rows<std::int32_t>(count, axes_of(tops), random), arrays.view(), axes_of(tops),
                random);
  for (std::uint64_t& top : tops) top = (random() & most_wide) >> random() % 61;
  check_hostile(any_rows<std::int64_t>(count, axes_of(tops), random), arrays.view(), axes_of(tops),
                random);
}

TEST(OrderedIntegers, PartsThatDiffer) {
  // Even and rough parts of a surface have shares of their own, which is smaller.
  Random random(2);
  const CodedArrays sphere = coded_without_twins(corpus::icosphere(4));
  std::vector<std::int32_t> rows;
  for (std::size_t i = 0; i < 3 * sphere.introduced_by.size(); ++i)
    rows.push_back(static_cast<std::int32_t>(random() % (i / 1200 % 2 != 0 ? 1000 : 3)));
  const std::vector<Axis> axes = axes_of({1000, 1000, 1000});
  const Lattice<const std::int32_t> values{rows, axes};
  EXPECT_LT(encode_ordered(values, sphere.view(), 3).size(),
            encode_ordered(values, sphere.view(), 1).size() * 9 / 10);
  check_hostile(rows, sphere.view(), axes, random);
}

TEST(OrderedIntegers, ManyComponents) {
  Random random(3);
  const CodedArrays sphere = coded_without_twins(corpus::icosphere(1));
  std::vector<std::uint64_t> tops(255);
  for (std::uint64_t& top : tops) top = random() % 9 == 0 ? 0 : random() % 1000;
  check_hostile(any_rows<std::int32_t>(50, axes_of(tops), random), sphere.view(), axes_of(tops),
                random);
}

TEST(OrderedIntegers, AnyBytes) {
  Random random(4);
  const CodedArrays sphere = coded_without_twins(corpus::icosphere(2));
  for (unsigned i = 0; i < 3000; ++i) {
    Bytes bytes(random() % 60);
    for (std::byte& b : bytes) b = std::byte(random() & random() & 0xff);
    if (bytes.size() > 2) {
      bytes[0] = std::byte(random() % 11 | random() % 7 << 4);
      bytes[1] = std::byte(random() % 30);
    }
    decoded<std::int32_t>(bytes, 162, sphere.view(), axes_of({100, 7, most_narrow}));
    decoded<std::int64_t>(bytes, 162, sphere.view(), axes_of({100, most_wide}));
  }
}

TEST(OrderedIntegers, SmoothValuesAreCheap) {
  // Latitude-longitude waves on a regular grid: the hexagon sees through what a slope does.
  const Mesh mesh = corpus::grid(60, 60);
  const CodedArrays arrays = coded_without_twins(mesh);
  std::vector<std::int32_t> rows;
  for (std::size_t v = 0; v < arrays.introduced_by.size(); ++v) rows.push_back(0);
  // A plane over the grid, along a walk over its triangles: corners of a triangle differ by steps.
  std::vector<std::array<std::int32_t, 2>> place(rows.size());
  test::SurfaceCopy consumed = test::surface_of(mesh);
  const auto connectivity = encode_connectivity(consumed.arrays(), 3, Kept::corners_and_twins);
  ASSERT_TRUE(connectivity.ok());
  for (std::size_t v = 0; v < rows.size(); ++v) {
    const std::uint32_t w = connectivity->vertices[v];
    rows[v] = static_cast<std::int32_t>(37 * (w % 61) + 101 * (w / 61));
  }
  const Bytes bytes = check(rows, arrays.view(), axes_of({10000}));
  EXPECT_LT(bytes.size(), rows.size() / 8);
}

}  // namespace
}  // namespace clers::internal
