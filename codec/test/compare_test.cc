#include "codec/compare.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>

#include "codec/test/shuffled.h"
#include "corpus/generate.h"

namespace clers {
namespace {

using test::attribute;
using test::Index;
using test::shuffled;

/// A grid of quadrilaterals cut in two, closed to a torus or open, with or without positions.
Mesh grid(Index rows, Index columns, bool closed, bool positions) {
  Mesh m;
  const Index r = closed ? rows : rows + 1, c = closed ? columns : columns + 1;
  m.vertex_count = r * c;
  const auto at = [&](Index i, Index j) { return (i % r) * c + j % c; };
  for (Index i = 0; i < rows; ++i)
    for (Index j = 0; j < columns; ++j)
      for (const Index v :
           {at(i, j), at(i, j + 1), at(i + 1, j + 1), at(i, j), at(i + 1, j + 1), at(i + 1, j)})
        m.corners.push_back(v);
  if (positions) {
    std::vector<float> p;
    for (Index v = 0; v < m.vertex_count; ++v)
      for (const float x : {float(v / c), float(v % c), 0.25f * float((v * 7) % 5)}) p.push_back(x);
    m.attributes.push_back(attribute(position_name, Domain::vertex, Scalar::float32, 3, p));
  }
  return m;
}

Verdict verdict(const Mesh& a, const Mesh& b) {
  return compare(a, b).verdict;
}

TEST(Compare, ShuffledMeshesAreTheSame) {
  std::mt19937 random(1);
  for (const bool closed : {false, true})
    for (const bool positions : {false, true}) {
      const Mesh m = grid(9, 14, closed, positions);
      const Comparison found = compare(m, shuffled(m, random));
      EXPECT_EQ(found.verdict, Verdict::same) << found.what;
    }
}

TEST(Compare, OneBitOfAValueMatters) {
  std::mt19937 random(2);
  const Mesh m = grid(5, 6, false, true);
  for (std::size_t bit = 0; bit < 96; ++bit) {
    Mesh other = shuffled(m, random);
    other.attributes[0].data[12 * 7 + bit / 8] ^= std::byte(1u << (bit % 8));
    EXPECT_EQ(verdict(m, other), Verdict::different) << bit;
  }
}

TEST(Compare, ZerosAndNotNumbersCompareByBits) {
  Mesh m;
  m.vertex_count = 3;
  m.corners = {0, 1, 2};
  const float nan = std::nanf("1");
  m.attributes.push_back(attribute<float>("position", Domain::vertex, Scalar::float32, 1,
                                          {0.0f, nan, std::numeric_limits<float>::infinity()}));
  EXPECT_EQ(verdict(m, m), Verdict::same);
  Mesh negative_zero = m, other_nan = m;
  negative_zero.attributes[0].data[3] = std::byte{0x80};
  other_nan.attributes[0].data[4] ^= std::byte{1};
  EXPECT_EQ(verdict(m, negative_zero), Verdict::different);
  EXPECT_EQ(verdict(m, other_nan), Verdict::different);
}

TEST(Compare, OrientationMatters) {
  for (const bool positions : {false, true}) {
    const Mesh m = grid(4, 5, false, positions);
    Mesh flipped = m;
    std::swap(flipped.corners[30], flipped.corners[31]);
    EXPECT_EQ(verdict(m, flipped), Verdict::different);
  }
  // As a whole, too, even without positions: the grid's diagonals make it chiral.
  const Mesh m = grid(4, 5, false, false);
  Mesh mirrored = m;
  for (std::size_t c = 0; c < mirrored.corners.size(); c += 3)
    std::swap(mirrored.corners[c], mirrored.corners[c + 1]);
  EXPECT_EQ(verdict(m, mirrored), Verdict::different);
}

TEST(Compare, AVertexSplitInPlaceMatters) {
  std::mt19937 random(3);
  // Two triangles at an edge, against the same two with one end of the edge doubled in place, and
  // an isolated vertex in the first to keep the counts.
  Mesh shared;
  shared.vertex_count = 5;
  shared.corners = {0, 1, 2, 2, 1, 3};
  shared.attributes.push_back(
      attribute<float>("position", Domain::vertex, Scalar::float32, 1, {0, 1, 2, 3, 2}));
  Mesh split = shared;
  split.corners = {0, 1, 2, 4, 1, 3};
  EXPECT_EQ(verdict(shared, shuffled(shared, random)), Verdict::same);
  EXPECT_EQ(verdict(split, shuffled(split, random)), Verdict::same);
  EXPECT_EQ(verdict(shared, split), Verdict::different);
}

TEST(Compare, SwappedValuesMatter) {
  std::mt19937 random(4);
  for (const Domain domain : {Domain::vertex, Domain::corner, Domain::face}) {
    Mesh m = grid(3, 4, false, true);
    const std::size_t count = domain == Domain::vertex   ? m.vertex_count
                              : domain == Domain::corner ? m.corners.size()
                                                         : m.face_count();
    std::vector<std::int16_t> values(count);
    std::iota(values.begin(), values.end(), std::int16_t{0});
    m.attributes.push_back(attribute("extra", domain, Scalar::int16, 1, values));
    EXPECT_EQ(verdict(m, shuffled(m, random)), Verdict::same);
    std::swap(values[3], values[7]);
    Mesh other = m;
    other.attributes[1] = attribute("extra", domain, Scalar::int16, 1, values);
    EXPECT_EQ(verdict(m, other), Verdict::different);
  }
}

TEST(Compare, AttributesAreMatchedByNameTypeAndDomain) {
  const Mesh m = grid(2, 2, false, true);
  Mesh renamed = m, retyped = m, none = m;
  renamed.attributes[0].name = "colour";
  retyped.attributes[0].scalar = Scalar::uint32;
  none.attributes.clear();
  for (const Mesh& other : {renamed, retyped, none}) {
    EXPECT_EQ(verdict(m, other), Verdict::different);
    EXPECT_EQ(verdict(other, m), Verdict::different);
  }
  Mesh named = m;
  named.name = "grid";
  EXPECT_EQ(verdict(m, named), Verdict::same);
}

TEST(Compare, ManyEqualComponents) {
  std::mt19937 random(5);
  const Mesh m = corpus::copies(grid(2, 3, true, false), 300);
  EXPECT_EQ(verdict(m, shuffled(m, random)), Verdict::same);
}

TEST(Compare, RegularToriOfDifferentShape) {
  // Every vertex of each has six neighbours, so refinement sees nothing.
  std::mt19937 random(6);
  const Mesh a = grid(4, 9, true, false), b = grid(6, 6, true, false);
  EXPECT_EQ(verdict(a, b), Verdict::different);
  const Mesh two[] = {a, a, b, a};
  const auto union_of = [&](int first) {
    return corpus::disjoint_union(std::span(two).subspan(static_cast<std::size_t>(first), 2));
  };
  EXPECT_EQ(verdict(union_of(1), shuffled(union_of(2), random)), Verdict::same);
  EXPECT_EQ(verdict(union_of(0), union_of(1)), Verdict::different);
}

TEST(Compare, EqualComponentsOfEveryKind) {
  std::mt19937 random(9);
  const Mesh kinds[] = {corpus::tetrahedron(),
                        corpus::glued_pair(),
                        corpus::single_triangle(),
                        corpus::strip(3),
                        corpus::book(3),
                        corpus::chessboard(2),
                        corpus::moebius_strip(5, 1),
                        corpus::torus(3, 3)};
  for (const Mesh& kind : kinds) {
    const Mesh m = corpus::copies(kind, 200);
    EXPECT_EQ(verdict(m, shuffled(m, random)), Verdict::same);
    Mesh bare = m;
    bare.attributes.clear();
    EXPECT_EQ(verdict(bare, shuffled(bare, random)), Verdict::same);
  }
  std::vector<Mesh> all;
  for (int k = 0; k < 50; ++k) all.insert(all.end(), std::begin(kinds), std::end(kinds));
  const Mesh mixed = corpus::disjoint_union(all);
  EXPECT_EQ(verdict(mixed, shuffled(mixed, random)), Verdict::same);
}

TEST(Compare, ComponentsThatOnlyASearchTellsApart) {
  // Two kinds that refinement sees no difference between, each in a row, the rows the other way
  // round in the other mesh: whoever pairs off in order tries each with all of the wrong kind.
  std::mt19937 random(10);
  const auto rows = [](int n, const Mesh& a, int m, const Mesh& b) {
    std::vector<Mesh> all(static_cast<std::size_t>(n), a);
    all.resize(static_cast<std::size_t>(n + m), b);
    return corpus::disjoint_union(all);
  };
  const Mesh a = grid(4, 9, true, false), b = grid(6, 6, true, false);
  EXPECT_EQ(verdict(rows(60, a, 60, b), rows(60, b, 60, a)), Verdict::same);
  EXPECT_EQ(verdict(rows(60, a, 60, b), shuffled(rows(60, a, 60, b), random)), Verdict::same);
  EXPECT_EQ(verdict(rows(61, a, 59, b), rows(61, b, 59, a)), Verdict::different);
  EXPECT_EQ(verdict(rows(20, a, 20, b), shuffled(rows(19, a, 21, b), random)), Verdict::different);
}

TEST(Compare, SheetsThatMeetAtAVertexOrAnEdge) {
  std::mt19937 random(7);
  Mesh fans;  // twelve triangles of one vertex, four on each of three edges
  for (Index k = 0; k < 12; ++k) fans.corners.insert(fans.corners.end(), {0, 1 + k % 3, 4 + k});
  fans.vertex_count = 16;
  EXPECT_EQ(verdict(fans, shuffled(fans, random)), Verdict::same);
  Mesh uneven = fans;
  uneven.corners[1] = 2;
  EXPECT_EQ(verdict(fans, uneven), Verdict::different);
  Mesh doubled = fans;
  doubled.corners.insert(doubled.corners.end(), fans.corners.begin(), fans.corners.end());
  EXPECT_EQ(verdict(doubled, shuffled(doubled, random)), Verdict::same);
}

TEST(Compare, FacesOfManyCornersTakeLinearTime) {
  std::mt19937 random(8);
  Mesh m;
  m.vertex_count = 2;
  m.face_sizes = {200'000, 100'000};
  m.corners.assign(300'000, 0);
  m.corners[77] = 1;
  EXPECT_EQ(verdict(m, shuffled(m, random)), Verdict::same);
  Mesh other = m;
  other.corners[77] = 0;
  other.corners[250'000] = 1;
  EXPECT_EQ(verdict(m, other), Verdict::different);
}

TEST(Compare, EmptyMeshes) {
  EXPECT_EQ(verdict({}, {}), Verdict::same);
  Mesh isolated;
  isolated.vertex_count = 3;
  EXPECT_EQ(verdict(isolated, isolated), Verdict::same);
  EXPECT_EQ(verdict(isolated, {}), Verdict::different);
}

TEST(Compare, MeshesThatAreNoneAreNotJudged) {
  Mesh m = grid(2, 2, false, true), broken = m;
  broken.corners[0] = 99;
  EXPECT_EQ(verdict(m, broken), Verdict::undecided);
  broken = m;
  broken.attributes[0].data.pop_back();
  EXPECT_EQ(verdict(broken, m), Verdict::undecided);
}

}  // namespace
}  // namespace clers
