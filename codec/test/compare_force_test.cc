// Comparisons against all permutations of the vertices of tiny meshes.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "codec/compare.h"
#include "codec/test/shuffled.h"

namespace clers::internal {
namespace {

using test::attribute;
using test::Index;
using test::shuffled;
using test::size_of_face;

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

/// A face as the greatest of its rotations, corners as (vertex, number of its values); its own
/// values last.
using Cycle = std::vector<std::pair<Index, Index>>;

/// Numbers for values, the same in both meshes.
using Numbers = std::map<std::string, Index>;

std::vector<Cycle> cycles(const Mesh& m, Numbers& numbers) {
  const auto number = [&](Domain domain, std::size_t i) {
    return numbers.emplace(value(m, domain, i), static_cast<Index>(numbers.size())).first->second;
  };
  std::vector<Cycle> all;
  for (std::size_t f = 0, at = 0; f < m.face_count(); at += size_of_face(m, f), ++f) {
    Cycle cycle;
    for (std::size_t c = at; c < at + size_of_face(m, f); ++c)
      cycle.push_back({m.corners[c], number(Domain::corner, c)});
    cycle.push_back({0, number(Domain::face, f)});
    all.push_back(cycle);
  }
  return all;
}

/// The cycles when vertices are renumbered, in one order that does not depend on how they are.
std::vector<Cycle> renumbered(std::vector<Cycle> all, const std::vector<Index>& to) {
  for (Cycle& cycle : all) {
    for (auto c = cycle.begin(); c + 1 != cycle.end(); ++c) c->first = to[c->first];
    Cycle best = cycle;
    for (std::size_t j = 0; j + 1 < cycle.size(); ++j) {
      std::rotate(cycle.begin(), cycle.begin() + 1, cycle.end() - 1);
      best = std::max(best, cycle);
    }
    cycle = best;
  }
  std::sort(all.begin(), all.end());
  return all;
}

Verdict verdict(const Mesh& a, const Mesh& b) {
  const auto found = compare(a, b);
  EXPECT_TRUE(found.ok());
  return found ? found->verdict : Verdict::undecided;
}

bool same_by_force(const Mesh& a, const Mesh& b) {
  if (a.vertex_count != b.vertex_count || a.face_count() != b.face_count()) return false;
  std::vector<Index> to(a.vertex_count);
  std::iota(to.begin(), to.end(), 0u);
  Numbers numbers;
  const std::vector<Cycle> from = cycles(a, numbers), goal = renumbered(cycles(b, numbers), to);
  // A vertex can only become one with as many corners and its values.
  const auto look = [](const Mesh& m, Index v) {
    return value(m, Domain::vertex, v) +
           std::to_string(std::count(m.corners.begin(), m.corners.end(), v));
  };
  std::vector<std::string> looks_a, looks_b;
  for (Index v = 0; v < a.vertex_count; ++v) {
    looks_a.push_back(look(a, v));
    looks_b.push_back(look(b, v));
  }
  do {
    bool alike = true;
    for (Index v = 0; v < a.vertex_count && alike; ++v) alike = looks_a[v] == looks_b[to[v]];
    if (alike && renumbered(from, to) == goal) return true;
  } while (std::next_permutation(to.begin(), to.end()));
  return false;
}

/// Few different values, in some domains.
void add_values(Mesh& m, std::mt19937& random) {
  const auto below = [&](unsigned n) { return static_cast<Index>(random() % n); };
  const unsigned values = 1 + below(3);
  const auto add = [&](const char* name, Domain domain, std::size_t count) {
    std::vector<std::uint8_t> v(count);
    for (auto& x : v) x = static_cast<std::uint8_t>(below(values));
    m.attributes.push_back(attribute(name, domain, Scalar::uint8, 1, v));
  };
  if (below(2) == 0) add("v", Domain::vertex, m.vertex_count);
  if (below(3) == 0) add("c", Domain::corner, m.corners.size());
  if (below(3) == 0) add("f", Domain::face, m.face_count());
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
  add_values(m, random);
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

RC_GTEST_PROP(CompareByForce, AgreesWithAllPermutations, ()) {
  std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
  for (int round = 0; round < 100; ++round) {
    const Mesh a = random_soup(random);
    Mesh b = shuffled(a, random);
    for (unsigned k = static_cast<unsigned>(random() % 3); k > 0; --k) change(b, random);
    const bool expected = same_by_force(a, b);
    const auto found = compare(a, b);
    RC_ASSERT(found.ok());
    RC_ASSERT(found->verdict == (expected ? Verdict::same : Verdict::different));
    RC_ASSERT(found->what.empty() == expected);
  }
}

/// Up to 7 vertices in components that are alike, or nearly: sheets, solids, pinched vertices,
/// books.
Mesh random_components(std::mt19937& random) {
  static const std::vector<std::vector<std::vector<Index>>> parts = {
      {{0, 1, 2}},
      {{0, 1, 2}, {0, 2, 1}},
      {{0, 1, 2}, {0, 1, 2}},
      {{0, 1, 2, 3}},
      {{0, 1, 2}, {2, 1, 3}},
      {{0, 1, 2}, {1, 2, 3}},  // against each other
      {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}},
      {{0, 1, 2}, {0, 3, 4}},  // pinched
      {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}},
      {{0, 1}, {1, 0}},
      {{0, 1}},
      {{0, 0, 1}},
      {{0}},
  };
  Mesh m;
  for (std::size_t kind = random(); m.vertex_count < 7; kind = random() % 2 ? kind : random()) {
    Index vertices = 0;
    for (const auto& face : parts[kind % parts.size()])
      for (const Index v : face) vertices = std::max(vertices, v + 1);
    if (m.vertex_count + vertices > 7) break;
    for (const auto& face : parts[kind % parts.size()]) {
      m.face_sizes.push_back(static_cast<Index>(face.size()));
      for (const Index v : face) m.corners.push_back(m.vertex_count + v);
    }
    m.vertex_count += vertices;
  }
  add_values(m, random);
  return m;
}

RC_GTEST_PROP(CompareByForce, AgreesOnComponents, ()) {
  std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
  for (int round = 0; round < 10; ++round) {
    const Mesh a = random_components(random);
    Mesh b = shuffled(a, random);
    for (unsigned k = static_cast<unsigned>(random() % 3); k > 0; --k) change(b, random);
    const Verdict expected = same_by_force(a, b) ? Verdict::same : Verdict::different;
    RC_ASSERT(verdict(a, b) == expected);
    RC_ASSERT(verdict(b, a) == expected);
  }
}

/// Up to 7 vertices, many alike: one face again and again, books, hubs of pinches, doubled meshes,
/// all triples. Some faces left out or turned, so that not all are.
Mesh random_crowd(std::mt19937& random) {
  const auto below = [&](unsigned n) { return static_cast<Index>(random() % n); };
  Mesh m;
  const auto add = [&](std::initializer_list<Index> face) {
    for (const Index v : face) {
      m.corners.push_back(v);
      m.vertex_count = std::max(m.vertex_count, v + 1);
    }
  };
  switch (below(5)) {
    case 0:
      for (Index f = 1 + below(6); f > 0; --f) add({0, 1, 2});
      break;
    case 1:
      for (Index page = 2 + below(5); page > 1; --page) add({0, 1, page});
      break;
    case 2:
      for (Index pinch = 1 + below(3); pinch > 0; --pinch) add({0, 2 * pinch - 1, 2 * pinch});
      break;
    case 3:
      for (Index k = 3 + below(4), f = 0; f < k; ++f) add({0, 1 + f, 1 + (f + 1) % k});
      break;
    default:
      for (Index n = 4 + below(3), i = 0; i < n; ++i)
        for (Index j = i + 1; j < n; ++j)
          for (Index k = j + 1; k < n; ++k) add({i, j, k});
  }
  if (below(2) == 0) m.corners.insert(m.corners.end(), m.corners.begin(), m.corners.end());
  for (Index changes = below(3); changes > 0 && m.corners.size() > 3; --changes) {
    const auto face = m.corners.begin() + std::ptrdiff_t(3 * below(Index(m.corners.size() / 3)));
    if (below(2) == 0)
      m.corners.erase(face, face + 3);
    else
      std::swap(face[0], face[1]);
  }
  if (below(4) == 0) add_values(m, random);
  return m;
}

RC_GTEST_PROP(CompareByForce, AgreesOnCrowds, ()) {
  std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
  for (int round = 0; round < 10; ++round) {
    const Mesh a = random_crowd(random);
    Mesh b = shuffled(a, random);
    for (unsigned k = static_cast<unsigned>(random() % 3); k > 0; --k) change(b, random);
    const Verdict expected = same_by_force(a, b) ? Verdict::same : Verdict::different;
    RC_ASSERT(verdict(a, b) == expected);
    RC_ASSERT(verdict(b, a) == expected);
  }
}

// ---- All meshes of a few faces.

struct Tiny {
  Index vertices = 0;
  std::vector<std::vector<Index>> faces = {};
  Index marks = 0;  ///< a bit for each vertex

  Mesh mesh() const {
    Mesh m;
    m.vertex_count = vertices;
    for (const auto& face : faces) {
      m.face_sizes.push_back(static_cast<Index>(face.size()));
      m.corners.insert(m.corners.end(), face.begin(), face.end());
    }
    std::vector<std::uint8_t> bits;
    for (Index v = 0; v < vertices; ++v) bits.push_back(marks >> v & 1);
    m.attributes.push_back(attribute("mark", Domain::vertex, Scalar::uint8, 1, bits));
    return m;
  }

  /// The least of all renumberings: marks, then faces.
  std::pair<Index, std::vector<std::vector<Index>>> least() const {
    std::vector<Index> to(vertices);
    std::iota(to.begin(), to.end(), 0u);
    std::pair<Index, std::vector<std::vector<Index>>> best = {~0u, {}};
    do {
      std::pair<Index, std::vector<std::vector<Index>>> found = {0, faces};
      for (Index v = 0; v < vertices; ++v) found.first |= (marks >> v & 1) << to[v];
      for (auto& face : found.second) {
        for (Index& v : face) v = to[v];
        std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
      }
      std::sort(found.second.begin(), found.second.end());
      best = std::min(best, found);
    } while (std::next_permutation(to.begin(), to.end()));
    return best;
  }
};

/// Cycles of different vertices, the least first.
std::vector<std::vector<Index>> all_cycles(Index vertices, std::size_t least, std::size_t most) {
  std::vector<std::vector<Index>> all, open = {{}};
  for (std::size_t size = 1; size <= most; ++size) {
    std::vector<std::vector<Index>> longer;
    for (const auto& cycle : open)
      for (Index v = cycle.empty() ? 0 : cycle[0] + 1; v < vertices; ++v)
        if (std::find(cycle.begin(), cycle.end(), v) == cycle.end()) {
          longer.push_back(cycle);
          longer.back().push_back(v);
        }
    open = std::move(longer);
    if (size >= least) all.insert(all.end(), open.begin(), open.end());
  }
  return all;
}

/// Calls visit with every multiset of up to `most` of the cycles.
template <class Visit>
void each_choice(const std::vector<std::vector<Index>>& cycles, std::size_t from, std::size_t most,
                 Tiny& mesh, const Visit& visit) {
  visit(mesh);
  if (mesh.faces.size() == most) return;
  for (std::size_t i = from; i < cycles.size(); ++i) {
    mesh.faces.push_back(cycles[i]);
    each_choice(cycles, i, most, mesh, visit);
    mesh.faces.pop_back();
  }
}

/// Every mesh is the same as one of its kind, and as no other. Returns how many kinds there are.
std::size_t kinds(Index vertices, std::size_t least, std::size_t most, std::size_t faces,
                  bool marks) {
  std::map<std::pair<Index, std::vector<std::vector<Index>>>, Mesh> known;
  Tiny tiny{vertices};
  for (Index bits = 0; bits < (marks ? 1u << vertices : 1u); ++bits) {
    tiny.marks = bits;
    each_choice(all_cycles(vertices, least, most), 0, faces, tiny, [&](const Tiny& each) {
      const Mesh mesh = each.mesh();
      const auto own = each.least();
      known.emplace(own, mesh);
      for (const auto& [key, other] : known)
        EXPECT_EQ(verdict(mesh, other), key == own ? Verdict::same : Verdict::different);
    });
  }
  return known.size();
}

// How many kinds there are follows from Burnside's lemma, too: the mean number of multisets of
// cycles that a permutation of the vertices keeps.
TEST(CompareByForce, AllMeshesOfFewTriangles) {
  EXPECT_EQ(kinds(4, 3, 3, 4, false), 34u);
  EXPECT_EQ(kinds(5, 3, 3, 3, false), 24u);
  EXPECT_EQ(kinds(6, 3, 3, 2, false), 8u);
}
TEST(CompareByForce, AllMeshesOfFewPolygons) {
  EXPECT_EQ(kinds(4, 1, 4, 3, false), 166u);
}
TEST(CompareByForce, AllMeshesWithValuesOfVertices) {
  EXPECT_EQ(kinds(4, 3, 3, 2, true), 51u);
}

}  // namespace
}  // namespace clers::internal
