#include "codec/compare.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>
#include <numeric>
#include <random>
#include <set>

namespace clers {
namespace {

using Index = std::uint32_t;

template <class T>
Attribute attribute(std::string name, Domain domain, Scalar scalar, unsigned components,
                    const std::vector<T>& values) {
  Attribute a{std::move(name), domain, scalar, static_cast<std::uint8_t>(components), {}};
  a.data.resize(values.size() * sizeof(T));
  if (!values.empty()) std::memcpy(a.data.data(), values.data(), a.data.size());
  return a;
}

Index size_of_face(const Mesh& m, std::size_t f) {
  return m.triangles_only() ? 3 : m.face_sizes[f];
}

/// Renumbers vertices, reorders faces, turns cycles and reorders attributes at random.
Mesh shuffled(const Mesh& m, std::mt19937& random) {
  std::vector<Index> to(m.vertex_count), faces(m.face_count()), begin(m.face_count());
  std::iota(to.begin(), to.end(), 0u);
  std::shuffle(to.begin(), to.end(), random);
  std::iota(faces.begin(), faces.end(), 0u);
  std::shuffle(faces.begin(), faces.end(), random);
  for (Index f = 0, at = 0; f < begin.size(); ++f) {
    begin[f] = at;
    at += size_of_face(m, f);
  }
  std::vector<Index> old_vertex(m.vertex_count), old_corner;
  for (Index v = 0; v < m.vertex_count; ++v) old_vertex[to[v]] = v;
  Mesh out;
  out.vertex_count = m.vertex_count;
  for (const Index f : faces) {
    const Index n = size_of_face(m, f);
    if (!m.triangles_only()) out.face_sizes.push_back(n);
    const Index turn = n == 0 ? 0 : static_cast<Index>(random() % n);
    for (Index j = 0; j < n; ++j) old_corner.push_back(begin[f] + (j + turn) % n);
  }
  for (const Index c : old_corner) out.corners.push_back(to[m.corners[c]]);
  for (const Attribute& a : m.attributes) {
    Attribute moved = a;
    moved.data.clear();
    const auto& old = a.domain == Domain::vertex   ? old_vertex
                      : a.domain == Domain::corner ? old_corner
                                                   : faces;
    for (const Index i : old)
      moved.data.insert(moved.data.end(), a.data.begin() + std::ptrdiff_t(i * a.stride()),
                        a.data.begin() + std::ptrdiff_t((i + 1) * a.stride()));
    out.attributes.push_back(std::move(moved));
  }
  std::shuffle(out.attributes.begin(), out.attributes.end(), random);
  return out;
}

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

Mesh joined(const Mesh& a, const Mesh& b) {  // without attributes
  Mesh m = a;
  m.vertex_count += b.vertex_count;
  for (const Index v : b.corners) m.corners.push_back(v + a.vertex_count);
  return m;
}

Verdict verdict(const Mesh& a, const Mesh& b) {
  return compare(a, b).verdict;
}

// ---- The oracle: all permutations of the vertices of a tiny mesh.

std::string value(const Mesh& m, Domain domain, std::size_t i) {
  std::map<std::string, std::string> by_name;
  for (const Attribute& a : m.attributes)
    if (a.domain == domain)
      by_name[a.name] =
          std::string(reinterpret_cast<const char*>(a.data.data()) + i * a.stride(), a.stride());
  std::string all;
  for (const auto& [name, bits] : by_name) all += name + '=' + bits + ';';
  return all;
}

/// Every face as the greatest of its rotations, under a renumbering.
std::multiset<std::vector<std::string>> cycles(const Mesh& m, const std::vector<Index>& to) {
  std::multiset<std::vector<std::string>> all;
  for (std::size_t f = 0, at = 0; f < m.face_count(); at += size_of_face(m, f), ++f) {
    std::vector<std::string> cycle;
    for (std::size_t c = at; c < at + size_of_face(m, f); ++c)
      cycle.push_back(std::to_string(to[m.corners[c]]) + '/' + value(m, Domain::corner, c));
    std::vector<std::string> best = cycle;
    for (std::size_t j = 0; j < cycle.size(); ++j) {
      std::rotate(cycle.begin(), cycle.begin() + 1, cycle.end());
      best = std::max(best, cycle);
    }
    best.push_back(value(m, Domain::face, f));
    all.insert(best);
  }
  return all;
}

bool same_by_force(const Mesh& a, const Mesh& b) {
  if (a.vertex_count != b.vertex_count || a.face_count() != b.face_count()) return false;
  std::vector<Index> to(a.vertex_count), identity(a.vertex_count);
  std::iota(to.begin(), to.end(), 0u);
  identity = to;
  const auto goal = cycles(b, identity);
  do {
    bool values = true;
    for (Index v = 0; v < a.vertex_count; ++v)
      values = values && value(a, Domain::vertex, v) == value(b, Domain::vertex, to[v]);
    if (values && cycles(a, to) == goal) return true;
  } while (std::next_permutation(to.begin(), to.end()));
  return false;
}

/// A soup of up to 5 vertices: any polygons, duplicates, repeated vertices, isolated vertices.
Mesh random_soup(std::mt19937& random) {
  const auto below = [&](unsigned n) { return static_cast<Index>(random() % n); };
  Mesh m;
  m.vertex_count = 1 + below(5);
  const bool triangles = below(2) == 0;
  for (Index f = below(6); f > 0; --f) {
    const Index n = triangles ? 3 : 1 + below(4);
    if (!triangles) m.face_sizes.push_back(n);
    for (Index j = 0; j < n; ++j) m.corners.push_back(below(m.vertex_count));
  }
  const unsigned values = 1 + below(3);
  const auto add = [&](const char* name, Domain domain, std::size_t count) {
    std::vector<std::uint8_t> v(count);
    for (auto& x : v) x = static_cast<std::uint8_t>(below(values));
    m.attributes.push_back(attribute(name, domain, Scalar::uint8, 1, v));
  };
  if (below(2) == 0) add("v", Domain::vertex, m.vertex_count);
  if (below(3) == 0) add("c", Domain::corner, m.corners.size());
  if (below(3) == 0) add("f", Domain::face, m.face_count());
  return m;
}

/// One small change that may or may not matter.
void change(Mesh& m, std::mt19937& random) {
  const auto below = [&](std::size_t n) { return random() % n; };
  if (!m.corners.empty() && below(2) == 0) {
    if (below(2) == 0)
      m.corners[below(m.corners.size())] = static_cast<Index>(below(m.vertex_count));
    else
      std::swap(m.corners[below(m.corners.size())], m.corners[below(m.corners.size())]);
    return;
  }
  if (m.attributes.empty()) return;
  Attribute& a = m.attributes[below(m.attributes.size())];
  if (a.data.empty()) return;
  std::swap(a.data[below(a.data.size())], a.data[below(a.data.size())]);
}

RC_GTEST_PROP(Compare, AgreesWithAllPermutations, ()) {
  std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
  for (int round = 0; round < 100; ++round) {
    const Mesh a = random_soup(random);
    Mesh b = shuffled(a, random);
    for (unsigned k = static_cast<unsigned>(random() % 3); k > 0; --k) change(b, random);
    const bool expected = same_by_force(a, b);
    const Comparison found = compare(a, b);
    RC_ASSERT(found.verdict == (expected ? Verdict::same : Verdict::different));
    RC_ASSERT(found.what.empty() == expected);
  }
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
  Mesh m = grid(2, 3, true, false), other = m;
  for (int k = 0; k < 300; ++k) m = joined(m, grid(2, 3, true, false));
  EXPECT_EQ(verdict(m, shuffled(m, random)), Verdict::same);
}

TEST(Compare, RegularToriOfDifferentShape) {
  // Every vertex of each has six neighbours, so refinement sees nothing.
  std::mt19937 random(6);
  const Mesh a = grid(4, 9, true, false), b = grid(6, 6, true, false);
  EXPECT_EQ(verdict(a, b), Verdict::different);
  EXPECT_EQ(verdict(joined(a, b), shuffled(joined(b, a), random)), Verdict::same);
  EXPECT_EQ(verdict(joined(a, a), joined(a, b)), Verdict::different);
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
