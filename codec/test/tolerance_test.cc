// Comparisons within a tolerance: against all permutations of tiny meshes, and of rounded ones.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <vector>

#include "codec/base/difference.h"
#include "codec/compare.h"
#include "codec/test/shuffled.h"
#include "corpus/generate.h"

namespace clers::internal {
namespace {

using namespace corpus;
using test::attribute;
using test::Index;
using test::shuffled;
using test::size_of_face;

constexpr char uv[] = "uv", weight[] = "weight";

Index below(Index n, std::mt19937& random) {
  return static_cast<Index>(random() % n);
}

Attribute floats(const char* name, Domain domain, std::uint8_t components,
                 const std::vector<float>& values) {
  return attribute(name, domain, Scalar::float32, components, values);
}

std::vector<float> values_of(const Attribute& a) {
  std::vector<float> values(a.data.size() / sizeof(float));
  if (!values.empty()) std::memcpy(values.data(), a.data.data(), a.data.size());
  return values;
}

Mesh with_positions(Mesh mesh, double scale, std::mt19937& random) {
  std::vector<float> values(3 * mesh.vertex_count);
  for (float& x : values)
    x = static_cast<float>(std::uniform_real_distribution<double>(0, scale)(random));
  mesh.attributes = {floats(position_name, Domain::vertex, 3, values)};
  return mesh;
}

/// Each number moved to the nearest multiple of a step, halves by the direction that is given.
Mesh rounded(Mesh mesh, float step, bool halves_up) {
  for (Attribute& a : mesh.attributes) {
    std::vector<float> values = values_of(a);
    for (float& x : values)
      x = step * (halves_up ? std::floor(x / step + .5f) : std::ceil(x / step - .5f));
    a = floats(a.name.c_str(), a.domain, a.components, values);
  }
  return mesh;
}

double largest_difference(const Attribute& a, const Attribute& b) {
  return difference(a.scalar, a.data.data(), b.data.data(), a.data.size() / size_of(a.scalar));
}

TEST(Tolerance, RoundedMeshesAreTheSameWithinTheirError) {
  std::mt19937 random(1);
  std::vector<Mesh> meshes = {grid(7, 9), torus(8, 6), icosphere(2), random_soup(30, 60, 5, 3),
                              add_fins(grid(6, 6), 4, 2)};
  for (Mesh& bare : meshes)
    for (const double scale : {3., 40.}) {
      Mesh mesh = with_positions(bare, scale, random);
      std::vector<float> corner(2 * mesh.corners.size()), face(mesh.face_count());
      for (auto* values : {&corner, &face})
        for (float& x : *values) x = static_cast<float>(below(1000, random)) / 37;
      mesh.attributes.push_back(floats(uv, Domain::corner, 2, corner));
      mesh.attributes.push_back(floats(weight, Domain::face, 1, face));
      const Mesh moved = rounded(mesh, .25f, true);
      std::vector<Tolerance> tolerances;
      for (std::size_t k = 0; k < mesh.attributes.size(); ++k)
        tolerances.push_back({mesh.attributes[k].name,
                              largest_difference(mesh.attributes[k], moved.attributes[k]),
                              {}});
      const Mesh other = shuffled(moved, random);
      for (const bool swapped : {false, true}) {
        const auto found = compare(swapped ? other : mesh, swapped ? mesh : other, tolerances);
        ASSERT_TRUE(found.ok());
        ASSERT_EQ(found->verdict, Verdict::same) << found->what;
        ASSERT_EQ(found->errors.size(), 3u);
        for (const FoundError& error : found->errors)
          for (const Tolerance& t : tolerances)
            if (t.name == error.attribute) {
              EXPECT_LE(error.error, t.error);
            }
      }
      // No two positions are near each other, so their renumbering is the only one, and so is the
      // error.
      if (scale == 40 && bare.face_sizes.empty()) {
        tolerances[0].error = std::nextafter(tolerances[0].error, 0);
        const auto found = compare(mesh, other, tolerances);
        ASSERT_TRUE(found.ok());
        EXPECT_EQ(found->verdict, Verdict::different);
      }
    }
}

TEST(Tolerance, HalfWayBetweenTwoPoints) {
  std::mt19937 random(5);
  Mesh mesh = grid(12, 12);
  std::vector<float> places;
  for (Index v = 0; v < mesh.vertex_count; ++v)
    for (const Index x : {v % 13, v / 13, below(50, random)})
      places.push_back(static_cast<float>(x));
  mesh.attributes = {floats(position_name, Domain::vertex, 3, places)};
  const Tolerance one[] = {{position_name, 1, {}}};
  for (const bool up : {false, true}) {
    const auto found = compare(mesh, shuffled(rounded(mesh, 2, up), random), one);
    ASSERT_TRUE(found.ok());
    ASSERT_EQ(found->verdict, Verdict::same) << found->what;
    EXPECT_EQ(found->errors.at(0).error, 1);
  }
}

TEST(Tolerance, AllOtherAttributesAreComparedAsBits) {
  std::mt19937 random(3);
  Mesh mesh = with_positions(grid(4, 4), 10, random);
  mesh.attributes.push_back(floats(uv, Domain::vertex, 1, std::vector<float>(25, 0.f)));
  Mesh other = mesh;
  other.attributes[1] = floats(uv, Domain::vertex, 1, std::vector<float>(25, -0.f));
  const Tolerance places[] = {{position_name, .1, {}}};
  EXPECT_EQ(compare(mesh, other, places)->verdict, Verdict::different);
  const Tolerance faces[] = {{uv, 0, Domain::face}};
  EXPECT_EQ(compare(mesh, other, faces)->verdict, Verdict::different);
  const Tolerance values[] = {{uv, 0, {}}};
  const auto found = compare(mesh, other, values);
  EXPECT_EQ(found->verdict, Verdict::same) << found->what;
  EXPECT_EQ(found->errors.at(0).error, 0);
}

TEST(Tolerance, NanAndInfinity) {
  constexpr float nan = std::numeric_limits<float>::quiet_NaN(),
                  inf = std::numeric_limits<float>::infinity();
  Mesh mesh;
  mesh.vertex_count = 4;
  const auto with = [&](std::vector<float> values) {
    Mesh out = mesh;
    out.attributes = {floats(weight, Domain::vertex, 1, values)};
    return out;
  };
  const Tolerance any[] = {{weight, std::numeric_limits<double>::max(), {}}};
  const auto verdict = [&](std::vector<float> a, std::vector<float> b) {
    return compare(with(a), with(b), any)->verdict;
  };
  EXPECT_EQ(verdict({nan, inf, -inf, 1}, {2, -inf, inf, -nan}), Verdict::same);
  EXPECT_EQ(verdict({nan, inf, -inf, 1}, {2, 3, inf, nan}), Verdict::different);
  EXPECT_EQ(verdict({inf, inf, -inf, 1}, {inf, -inf, -inf, 1}), Verdict::different);
  EXPECT_EQ(verdict({nan, nan, 1, 1}, {nan, 1, 1, 1}), Verdict::different);
}

TEST(Tolerance, SixtyFourBitIntegers) {
  Mesh a, b;
  a.vertex_count = b.vertex_count = 2;
  const std::vector<std::int64_t> x = {std::numeric_limits<std::int64_t>::min(), 9007199254740993},
                                  y = {9007199254740995, std::numeric_limits<std::int64_t>::min()};
  a.attributes = {attribute(weight, Domain::vertex, Scalar::int64, 1, x)};
  b.attributes = {attribute(weight, Domain::vertex, Scalar::int64, 1, y)};
  const Tolerance one[] = {{weight, 1, {}}}, two[] = {{weight, 2, {}}};
  EXPECT_EQ(compare(a, b, one)->verdict, Verdict::different);
  EXPECT_EQ(compare(a, b, two)->verdict, Verdict::same);
}

TEST(Tolerance, ItMustBeANumber) {
  const Mesh mesh = tetrahedron();
  for (const double wrong : {-1., std::nan(""), std::numeric_limits<double>::infinity()}) {
    const Tolerance tolerance[] = {{position_name, wrong, {}}};
    const auto found = compare(mesh, mesh, tolerance);
    ASSERT_FALSE(found.ok());
    EXPECT_EQ(found.error().code, ErrorCode::bad_option);
  }
}

/// Whether some renumbering of vertices and pairing of faces keeps all within the tolerance.
bool agree(const Mesh& a, const Mesh& b, double tolerance) {
  const auto near = [&](std::size_t k, std::size_t i, std::size_t j) {
    const Attribute &x = a.attributes[k], &y = b.attributes[k];
    return difference(x.scalar, x.data.data() + i * x.stride(), y.data.data() + j * y.stride(),
                      x.components) <= tolerance;
  };
  std::vector<Index> to(a.vertex_count), faces(a.face_count());
  std::iota(to.begin(), to.end(), 0u);
  do {
    bool good = true;
    for (Index v = 0; good && v < to.size(); ++v) good = near(0, v, to[v]);
    if (!good) continue;
    std::iota(faces.begin(), faces.end(), 0u);
    do {
      good = true;
      for (Index f = 0; good && f < faces.size(); ++f) {
        bool turned = false;
        for (Index turn = 0; turn < 3 && !turned; ++turn) {
          turned = near(2, f, faces[f]);
          for (Index j = 0; turned && j < 3; ++j) {
            const Index c = 3 * f + j, d = 3 * faces[f] + (j + turn) % 3;
            turned = to[a.corners[c]] == b.corners[d] && near(1, c, d);
          }
        }
        good = turned;
      }
      if (good) return true;
    } while (std::next_permutation(faces.begin(), faces.end()));
  } while (std::next_permutation(to.begin(), to.end()));
  return false;
}

RC_GTEST_PROP(Tolerance, AsAllPermutationsSay, ()) {
  std::mt19937 random(*rc::gen::arbitrary<unsigned>());
  Mesh a;
  a.vertex_count = 1 + below(4, random);
  const Index faces = below(4, random), spread = 1 + below(6, random);
  for (Index c = 0; c < 3 * faces; ++c) a.corners.push_back(below(a.vertex_count, random));
  const auto some = [&](std::size_t count, Index n) {
    std::vector<float> values(count);
    for (float& x : values) x = static_cast<float>(below(n, random));
    return values;
  };
  a.attributes = {floats("a", Domain::vertex, 1, some(a.vertex_count, spread)),
                  floats("b", Domain::corner, 1, some(a.corners.size(), 1 + below(3, random))),
                  floats("c", Domain::face, 1, some(faces, 1 + below(3, random)))};
  Mesh b = shuffled(a, random);
  std::sort(b.attributes.begin(), b.attributes.end(),
            [](const Attribute& x, const Attribute& y) { return x.name < y.name; });
  for (Attribute& attribute : b.attributes) {
    std::vector<float> values = values_of(attribute);
    for (float& x : values)
      x += static_cast<float>(below(5, random) == 0 ? int(below(5, random)) - 2 : 0);
    attribute = floats(attribute.name.c_str(), attribute.domain, 1, values);
  }
  const Tolerance tolerances[] = {{"a", 1, {}}, {"b", 1, {}}, {"c", 1, {}}};
  const auto found = compare(a, b, tolerances);
  RC_ASSERT(found.ok());
  const bool same = agree(a, b, 1);
  RC_CLASSIFY(found->verdict == Verdict::undecided);
  RC_CLASSIFY(same);
  if (found->verdict == Verdict::same) {
    RC_ASSERT(same);
    for (const FoundError& error : found->errors) RC_ASSERT(error.error <= 1);
  }
  if (found->verdict == Verdict::different) RC_ASSERT(!same);
}

/// What shuffled() does to vertices alone, said as a renumbering.
TEST(Tolerance, OfARenumberingThatIsGiven) {
  std::mt19937 random(8);
  const Mesh mesh = with_positions(icosphere(1), 5, random);
  Permutation order;
  order.vertices.resize(mesh.vertex_count);
  order.faces.resize(mesh.face_count());
  std::iota(order.vertices.begin(), order.vertices.end(), 0u);
  std::iota(order.faces.begin(), order.faces.end(), 0u);
  std::shuffle(order.vertices.begin(), order.vertices.end(), random);
  std::shuffle(order.faces.begin(), order.faces.end(), random);
  std::vector<Index> number(mesh.vertex_count);
  for (Index v = 0; v < mesh.vertex_count; ++v) number[order.vertices[v]] = v;
  Mesh other;
  other.vertex_count = mesh.vertex_count;
  for (const Index f : order.faces) {
    order.first_corners.push_back(below(3, random));
    for (Index j = 0; j < 3; ++j)
      other.corners.push_back(number[mesh.corners[3 * f + (order.first_corners.back() + j) % 3]]);
  }
  const std::vector<float> places = values_of(mesh.attributes[0]);
  std::vector<float> moved;
  for (const Index v : order.vertices)
    for (Index c = 0; c < 3; ++c) moved.push_back(places[3 * v + c] + (v == 7 && c == 1 ? .5f : 0));
  other.attributes = {floats(position_name, Domain::vertex, 3, moved)};
  // A tolerance by which any vertex may be any other.
  const Tolerance wide[] = {{position_name, 5, {}}}, narrow[] = {{position_name, .25, {}}};
  const auto found = compare(mesh, other, wide, order);
  ASSERT_TRUE(found.ok());
  EXPECT_EQ(found->verdict, Verdict::same) << found->what;
  EXPECT_EQ(found->errors.at(0).error, .5);
  EXPECT_EQ(compare(mesh, other, narrow, order)->verdict, Verdict::different);

  Permutation wrong = order;
  std::swap(wrong.faces[0], wrong.faces[1]);
  EXPECT_EQ(compare(mesh, other, wide, wrong)->verdict, Verdict::different);
  wrong = order;
  wrong.vertices[0] = wrong.vertices[1];
  EXPECT_EQ(compare(mesh, other, wide, wrong).error().code, ErrorCode::bad_option);
  wrong = order;
  wrong.first_corners[4] = 3;
  EXPECT_EQ(compare(mesh, other, wide, wrong).error().code, ErrorCode::bad_option);
  wrong = order;
  wrong.faces.pop_back();
  EXPECT_EQ(compare(mesh, other, wide, wrong).error().code, ErrorCode::bad_option);
}

}  // namespace
}  // namespace clers::internal
