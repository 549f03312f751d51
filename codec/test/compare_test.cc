#include "codec/compare.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>
#include <random>

#include "codec/test/shuffled.h"
#include "corpus/generate.h"

namespace clers::internal {
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
  const auto found = compare(a, b);
  EXPECT_TRUE(found.ok());
  return found ? found->verdict : Verdict::undecided;
}

TEST(Compare, ShuffledMeshesAreTheSame) {
  std::mt19937 random(1);
  for (const bool closed : {false, true})
    for (const bool positions : {false, true}) {
      const Mesh m = grid(9, 14, closed, positions);
      const auto found = compare(m, shuffled(m, random));
      ASSERT_TRUE(found.ok());
      EXPECT_EQ(found->verdict, Verdict::same) << found->what;
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

// Meshes whose vertices look alike in great number when they have no positions.
Mesh equal_faces(Index n) {
  Mesh m;
  m.vertex_count = 3;
  for (Index f = 0; f < n; ++f) m.corners.insert(m.corners.end(), {0, 1, 2});
  return m;
}

Mesh hub(Index pinches) {
  Mesh m;
  m.vertex_count = 1 + 2 * pinches;
  for (Index k = 0; k < pinches; ++k) m.corners.insert(m.corners.end(), {0, 1 + 2 * k, 2 + 2 * k});
  return m;
}

Mesh triples(Index n) {
  Mesh m;
  m.vertex_count = n;
  for (Index i = 0; i < n; ++i)
    for (Index j = i + 1; j < n; ++j)
      for (Index k = j + 1; k < n; ++k) m.corners.insert(m.corners.end(), {i, j, k});
  return m;
}

Mesh doubled(Mesh m) {
  m.corners.reserve(2 * m.corners.size());
  m.corners.insert(m.corners.end(), m.corners.begin(), m.corners.end());
  return m;
}

/// Every face again, the other way round.
Mesh both_ways(Mesh m) {
  const std::size_t n = m.corners.size();
  for (std::size_t c = 0; c < n; c += 3)
    for (const std::size_t k : {0u, 2u, 1u}) m.corners.push_back(m.corners[c + k]);
  return m;
}

Mesh bare(Mesh m) {
  m.attributes.clear();
  return m;
}

std::vector<Mesh> crowds(Index size) {
  const Index side = static_cast<Index>(std::sqrt(size / 2.0)) + 3;
  Index n = 4;
  while (n * (n - 1) * (n - 2) / 6 < size) ++n;
  return {equal_faces(size),
          bare(corpus::book(size)),
          hub(size),
          bare(corpus::fan(size)),
          triples(n),
          doubled(triples(n)),
          doubled(grid(side, side, false, false)),
          doubled(grid(side, side, true, false)),
          both_ways(grid(side, side + 1, true, false)),
          bare(corpus::copies(corpus::tetrahedron(), size / 4)),
          bare(corpus::copies(corpus::book(5), size / 5)),
          bare(corpus::copies(corpus::moebius_strip(5, 1), size / 10)),
          bare(corpus::loose_triangles(size)),
          bare(corpus::chessboard(side))};
}

TEST(Compare, DecidesWhereManyVerticesLookAlike) {
  std::mt19937 random(11);
  for (const Index size : {24u, 300u, 16000u}) {
    int kind = -1;
    for (const Mesh& m : crowds(size)) {
      SCOPED_TRACE(testing::Message() << "kind " << ++kind << " of " << m.face_count() << " faces");
      ASSERT_EQ(verdict(m, shuffled(m, random)), Verdict::same);
      Mesh other = shuffled(m, random);
      std::swap(other.corners[0],
                other.corners[1]);  // where vertices are not shared it is the same
      ASSERT_NE(verdict(m, other), Verdict::undecided);
      other.corners[0] = other.corners[1];
      ASSERT_EQ(verdict(m, other), Verdict::different);
      // A value that is another, of a vertex, a corner or a face.
      for (const Domain domain : {Domain::vertex, Domain::corner, Domain::face}) {
        Mesh valued = m;
        valued.attributes = {attribute("mark", domain, Scalar::uint8, 1,
                                       std::vector<std::uint8_t>(m.value_count(domain), 7))};
        Mesh marked = shuffled(valued, random);
        ASSERT_EQ(verdict(valued, marked), Verdict::same);
        marked.attributes[0].data.back() = std::byte{8};
        ASSERT_EQ(verdict(valued, marked), Verdict::different);
        if (size > 1000) break;
      }
    }
  }
}

TEST(Compare, TellsApartWhatOnlyAFarLookDoes) {
  // One face turned in a mesh of two-sided sheets, and one pinch at another place: local histograms
  // differ in few vertices only.
  std::mt19937 random(12);
  const Mesh m = both_ways(grid(40, 50, true, false));
  Mesh other = m;
  std::swap(other.corners[300], other.corners[301]);
  EXPECT_EQ(verdict(m, shuffled(other, random)), Verdict::different);
  EXPECT_EQ(verdict(other, shuffled(other, random)), Verdict::same);
  // Strips of the same triangles, one with its end five faces longer and the other shorter.
  const auto two_strips = [](Index a, Index b) {
    const Mesh parts[] = {corpus::strip(a), corpus::strip(b)};
    return bare(corpus::disjoint_union(parts));
  };
  EXPECT_EQ(verdict(two_strips(3000, 5000), shuffled(two_strips(3000, 5000), random)),
            Verdict::same);
  EXPECT_EQ(verdict(two_strips(3000, 5000), two_strips(3005, 4995)), Verdict::different);
}

TEST(Compare, StopsWhereOnlyEveryRenumberingWouldTell) {
  // Tori that look the same from everywhere, of two shapes, with fins that all meet at one vertex:
  // four and four, or five and three. A search tries all their orders in vain.
  const auto tori = [](Index wide, Index square) {
    Mesh m;
    m.vertex_count = 1;
    for (Index k = 0; k < wide + square; ++k) {
      const Mesh torus = k < wide ? grid(4, 9, true, false) : grid(6, 6, true, false);
      for (std::size_t c = 0; c < torus.corners.size(); ++c) {
        m.corners.push_back(m.vertex_count + torus.corners[c]);
        if (c % 6 == 2) {
          const Index u = m.corners[m.corners.size() - 3], v = m.corners[m.corners.size() - 2];
          m.corners.insert(m.corners.end(), {0, u, v});
        }
      }
      m.vertex_count += torus.vertex_count;
    }
    return m;
  };
  std::mt19937 random(14);
  const auto found = compare(tori(4, 4), shuffled(tori(5, 3), random));
  ASSERT_TRUE(found.ok());
  EXPECT_EQ(found->verdict, Verdict::undecided);
  EXPECT_FALSE(found->what.empty());
  EXPECT_EQ(verdict(tori(4, 4), shuffled(tori(4, 4), random)), Verdict::same);
}

TEST(Compare, AttributesInGreatNumberTakeLinearTime) {
  // Quadratic would be 10^9 steps and more for each comparison of two faces or vertices.
  Mesh m = grid(1, 1, false, false);
  for (int k = 0; k < 50'000; ++k)
    m.attributes.push_back(
        attribute("a" + std::to_string(k), static_cast<Domain>(k % 3), Scalar::uint8, 1,
                  std::vector<std::uint8_t>(m.value_count(static_cast<Domain>(k % 3)), 1)));
  std::mt19937 random(13);
  Mesh other = shuffled(m, random);
  EXPECT_EQ(verdict(m, other), Verdict::same);
  other.attributes[25'000].data[0] = std::byte{2};
  EXPECT_EQ(verdict(m, other), Verdict::different);
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

TEST(Compare, MeshesThatAreNoneAreErrors) {
  const Mesh good = grid(2, 2, false, true);
  const auto expect_wrong = [&](const Mesh& broken, const std::string& what) {
    for (const bool first : {true, false}) {
      const auto found = first ? compare(broken, good) : compare(good, broken);
      ASSERT_FALSE(found.ok()) << what;
      EXPECT_EQ(found.error().code, ErrorCode::inconsistent_mesh);
      EXPECT_NE(found.error().what.find(what), std::string::npos) << found.error().what;
    }
  };
  Mesh broken = good;
  broken.corners[0] = 99;
  expect_wrong(broken, "uses vertex 99, expected one below 9");
  broken = good;
  broken.attributes[0].data.pop_back();
  expect_wrong(broken, "107 bytes of values of 'position', expected 9 times 12");
  broken = good;
  broken.attributes[0].domain = static_cast<Domain>(3);
  expect_wrong(broken, "domain 3, expected 0 to 2");
  broken = good;
  broken.attributes[0].scalar = static_cast<Scalar>(255);
  expect_wrong(broken, "scalar 255, expected 0 to 9");
  broken = good;
  broken.face_sizes = {3};
  expect_wrong(broken, "face sizes");
}

}  // namespace
}  // namespace clers::internal
