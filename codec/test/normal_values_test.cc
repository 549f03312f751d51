// Normals come back, whatever they are and whatever they lie on; formulas cost next to nothing; and
// no bytes harm.
#include "codec/attributes/normal_values.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "codec/attributes/normal_values_decoder.h"
#include "codec/attributes/normal_values_encoder.h"
#include "codec/base/portable.h"
#include "codec/entropy/lanes.h"
#include "codec/entropy/stream.h"
#include "codec/numbers/number_encoder.h"
#include "codec/test/attribute.h"
#include "codec/test/coded_surfaces.h"
#include "corpus/generate.h"
#include "corpus/random.h"

namespace clers::internal {
namespace {

using test::attribute;
using test::coded;

/// A surface of values, and where its vertices are.
struct Ground {
  CodedArrays arrays;
  std::size_t values;
  Attribute position;
  std::vector<std::uint32_t> vertex_of = {}, vertex_at = {};

  ValueSurface along() const { return {arrays.view(), vertex_of, &position, vertex_at}; }
};

enum class Places { rough, flat, one, extreme };

Attribute positions(std::size_t vertices, Places kind) {
  corpus::Random random(vertices);
  std::vector<double> all;
  for (std::size_t i = 0; i < 3 * vertices; ++i) {
    double x = double(random.below(1 << 20)) / 1024;
    if (kind == Places::flat && i % 3 == 2) x = 1;
    if (kind == Places::one) x = -7;
    if (kind == Places::extreme) x = std::bit_cast<double>(random.next());
    all.push_back(x);
  }
  return attribute(position_name, Domain::vertex, Scalar::float64, 3, all);
}

std::vector<Ground> grounds() {
  std::vector<Ground> all;
  unsigned kind = 0;
  const auto surfaces = test::coded_surfaces();
  for (std::size_t i = 0; i < surfaces.size(); i += i < 9 ? 1 : 19) {
    const CodedArrays& arrays = surfaces[i];
    const std::size_t vertices = arrays.introduced_by.size();
    // Some values in no triangle.
    const std::size_t values = vertices + kind % 3;
    all.push_back({arrays, values, positions(values, Places(kind++ % 4))});
    if (kind % 3 != 0) continue;
    // Values at other vertices, two at each; then corners that have others again.
    Ground wedges = all.back();
    wedges.position = positions(values / 2 + 1, Places::rough);
    for (std::uint32_t v = 0; v < values; ++v) wedges.vertex_of.push_back(v / 2);
    all.push_back(wedges);
    for (std::size_t h = 0; h < arrays.corners.size(); ++h)
      wedges.vertex_at.push_back(static_cast<std::uint32_t>(h % (values / 2 + 1)));
    all.push_back(wedges);
    wedges.arrays.twins.clear();
    all.push_back(wedges);
  }
  return all;
}

/// Numbers of each kind, and rows of them.
struct Rows {
  Numbers numbers;
  std::vector<std::int64_t> rows;
};

Rows directions(const std::vector<Vector3>& vectors, unsigned bits) {
  Rows all = {octahedral_numbers(Scalar::float32, bits), {}};
  const OctahedralGrid grid(bits);
  for (const Vector3& v : vectors)
    for (const auto k : grid.integers(grid.nearest(grid.project(v)))) all.rows.push_back(k);
  return all;
}

template <class T>
Rows numbered(const std::vector<T>& numbers, bool words) {
  const Attribute a = attribute("normal", Domain::vertex, scalar_of<T>(), 3, numbers);
  auto ways = number_for_lines(a.data, a.scalar, 3, 5);
  NumberedValues& way = words ? ways.front() : ways.back();
  if (way.numbers.narrow()) way.wide.assign(way.narrow.begin(), way.narrow.end());
  return {way.numbers, way.wide};
}

std::vector<Vector3> vectors(std::size_t count, std::uint64_t seed) {
  corpus::Random random(seed);
  std::vector<Vector3> all(count);
  for (Vector3& v : all) {
    do
      for (double& x : v) x = double(random.below(2001)) / 1000 - 1;
    while (dot(v, v) < 1e-3);
    const double length = std::sqrt(dot(v, v));
    for (double& x : v) x /= length;
    if (random.chance(20)) v = {0, 0, random.chance(50) ? 1. : -1.};
  }
  return all;
}

/// Directions, words, decimals, all bits; of integers too.
std::vector<Rows> rows_of(std::size_t count, std::uint64_t seed) {
  corpus::Random random(seed);
  std::vector<Rows> all;
  const auto some = vectors(count, seed);
  for (const unsigned bits : {2u, 10u, 20u}) all.push_back(directions(some, bits));
  std::vector<float> exact, decimals, any;
  std::vector<double> doubles;
  std::vector<std::int16_t> integers;
  for (const Vector3& v : some)
    for (const double x : v) {
      exact.push_back(static_cast<float>(x));
      decimals.push_back(static_cast<float>(std::floor(x * 1000 + .5) / 1000));
      any.push_back(std::bit_cast<float>(static_cast<std::uint32_t>(random.next())));
      doubles.push_back(std::bit_cast<double>(random.next()));
      integers.push_back(static_cast<std::int16_t>(random.next()));
    }
  all.push_back(numbered(exact, true));
  all.push_back(numbered(decimals, false));
  all.push_back(numbered(any, true));
  all.push_back(numbered(doubles, true));
  all.push_back(numbered(integers, true));
  return all;
}

template <class Int>
void expect_to_come_back(const Rows& given, const ValueSurface& along) {
  ASSERT_TRUE(may_be_normals(given.numbers, along));
  const std::vector<Int> rows(given.rows.begin(), given.rows.end());
  for (const int level : {5, 9}) {
    const Bytes bytes = encode_normals<Int>(rows, given.numbers, along, level);
    std::vector<Int> back(rows.size(), -1);
    const auto decoded = decode_normals<Int>(bytes, 0, given.numbers, along, std::span<Int>(back));
    ASSERT_TRUE(decoded.ok()) << describe(decoded.error());
    EXPECT_EQ(back, rows);
  }
}

TEST(NormalValues, ComeBack) {
  std::uint64_t seed = 0;
  for (const Ground& ground : grounds()) {
    const auto all = rows_of(ground.values, ++seed);
    const Rows& rows = all[seed % all.size()];
    if (rows.numbers.narrow())
      expect_to_come_back<std::int32_t>(rows, ground.along());
    else
      expect_to_come_back<std::int64_t>(rows, ground.along());
  }
}

TEST(NormalValues, ComeBackByEveryModel) {
  const DoublePrecision doubles;
  const Ground ground = {coded(corpus::icosphere(1)), 44, positions(44, Places::rough)};
  for (const Rows& given : rows_of(ground.values, 3))
    for (std::uint32_t number = 0; number < normal_models; ++number) {
      const NormalModel model = normal_model(number);
      ASSERT_EQ(number_of(model), number);
      if (!model.fits(given.numbers)) continue;
      const ValueSurface along = ground.along();
      const FormulaNormals formula(along, ground.values, model.formula);
      auto rows = given.rows;
      Bytes bytes(1, static_cast<std::byte>(number));
      if (model.quick) {
        LaneEncoder coder;
        code_normals_quickly(coder, given.numbers, formula, along, std::span(rows));
        coder.finish(bytes);
      } else {
        put_bytes(bytes, encode_stream([&](EncodeTo& coder) {
                    code_normals(coder, model, given.numbers, formula, along, std::span(rows),
                                 ground.values);
                  }));
      }
      EXPECT_EQ(rows, given.rows);
      std::vector<std::int64_t> back(rows.size(), -1);
      const auto decoded =
          decode_normals<std::int64_t>(bytes, 0, given.numbers, along, std::span(back));
      ASSERT_TRUE(decoded.ok()) << number << ": " << describe(decoded.error());
      ASSERT_EQ(back, rows) << number;
    }
}

/// Positions of a bumpy sphere, in coded order.
Ground sphere() {
  Ground ground = {coded(corpus::icosphere(4)), 2562, {}};
  corpus::Random random(4);
  std::vector<double> all;
  // A vertex of the coded mesh lies beside its neighbours: walk once and move out from them.
  for (std::size_t v = 0; v < ground.values; ++v)
    for (int c = 0; c < 3; ++c) all.push_back(double(random.below(1000)));
  const auto& corners = ground.arrays.corners;
  for (int round = 0; round < 30; ++round)
    for (std::size_t h = 0; h < corners.size(); ++h)
      for (std::size_t c = 0; c < 3; ++c) {
        double& x = all[3 * corners[h] + c];
        x += (all[3 * corners[h - h % 3 + (h + 1) % 3] + c] - x) * .2;
      }
  ground.position = attribute(position_name, Domain::vertex, Scalar::float64, 3, all);
  return ground;
}

TEST(NormalValues, FormulasCostNextToNothing) {
  const DoublePrecision doubles;
  const Ground ground = sphere();
  const ValueSurface along = ground.along();
  for (std::uint32_t number = 0; number < normal_formulas; ++number) {
    const NormalFormula formula = normal_formula(number);
    if (!formula.is_one() || formula.around != NormalSum::value) continue;
    const FormulaNormals normals(along, ground.values, formula);
    std::vector<float> exact;
    std::vector<Vector3> all;
    for (std::uint32_t v = 0; v < ground.values; ++v) {
      Vector3 n;
      ASSERT_TRUE(normals.at(v, n));
      all.push_back(n);
      for (const double x : n) exact.push_back(static_cast<float>(x));
    }
    const Rows words = numbered(exact, true);
    EXPECT_LT(encode_normals<std::int64_t>(words.rows, words.numbers, along, 9).size(), 100u)
        << number;
    if (!formula.unit) continue;
    const Rows points = directions(all, 12);
    const Bytes bytes = encode_normals<std::int64_t>(points.rows, points.numbers, along, 9);
    EXPECT_LT(bytes.size(), 60u) << number;
    EXPECT_EQ(normal_model(std::to_integer<std::uint32_t>(bytes[0])).formula, formula);
  }
}

TEST(NormalValues, FacesTurnedForCodingAreNoticed) {
  // Half of the normals are on the other side: all of one component.
  Ground ground = sphere();
  const std::size_t values = ground.values;
  auto& a = ground.arrays;
  const auto corners = static_cast<std::uint32_t>(a.corners.size());
  for (std::uint32_t h = 0; h < corners; ++h)
    a.corners.push_back(a.corners[h] + static_cast<std::uint32_t>(values));
  for (std::uint32_t h = 0; h < corners; ++h)
    a.twins.push_back(HalfEdge(a.twins[h].index() + corners));
  a.introduced_by.resize(2 * values);
  find_introducing(a.corners, a.introduced_by);
  ground.values *= 2;
  const Bytes once = ground.position.data;
  ground.position.data.insert(ground.position.data.end(), once.begin(), once.end());
  const DoublePrecision doubles;
  const ValueSurface along = ground.along();
  const FormulaNormals formula(along, ground.values, {});
  std::vector<Vector3> all(ground.values);
  for (std::uint32_t v = 0; v < ground.values; ++v) {
    ASSERT_TRUE(formula.at(v, all[v]));
    if (v >= values)
      for (double& x : all[v]) x = -x;
  }
  const Rows points = directions(all, 12);
  EXPECT_LT(encode_normals<std::int64_t>(points.rows, points.numbers, along, 9).size(), 120u);
}

TEST(NormalValues, CornersOfAFaceFollowTheFirst) {
  // Flat shading: each corner has a value, and those of a face are the same, not quite the
  // formula's.
  const DoublePrecision doubles;
  Ground ground = {coded(corpus::loose_triangles(700)), 2100, positions(2100, Places::rough)};
  const ValueSurface along = ground.along();
  const FormulaNormals formula(along, ground.values, {});
  corpus::Random random(8);
  std::vector<Vector3> all(ground.values);
  const auto& corners = ground.arrays.corners;
  for (std::size_t h = 0; h < corners.size(); h += 3) {
    Vector3 n;
    ASSERT_TRUE(formula.at(corners[h], n));
    for (double& x : n) x += double(random.below(33)) / 1024;
    for (std::size_t i = 0; i < 3; ++i) all[corners[h + i]] = n;
  }
  const Rows points = directions(all, 10);
  const std::size_t bytes =
      encode_normals<std::int64_t>(points.rows, points.numbers, along, 9).size();
  EXPECT_LT(8 * bytes, 700u * 11);
  expect_to_come_back<std::int32_t>(points, along);
}

TEST(NormalValues, AreaNoneAndPlacesTogether) {
  const DoublePrecision doubles;
  // Two triangles at one edge whose ends are there twice, and one without area.
  const std::vector<float> places = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 2, 0, 0};
  Ground ground = {{}, 7, attribute(position_name, Domain::vertex, Scalar::float32, 3, places)};
  ground.arrays.corners = {0, 1, 2, 4, 3, 5, 0, 1, 6};
  ground.arrays.introduced_by.resize(7);
  find_introducing(ground.arrays.corners, ground.arrays.introduced_by);
  const ValueSurface along = ground.along();
  EXPECT_TRUE(FormulaNormals::has_places(ground.position));
  Vector3 n;
  const FormulaNormals alone(along, 8, {NormalWeight::area, NormalSum::value});
  ASSERT_TRUE(alone.at(0, n));
  EXPECT_EQ(n, (Vector3{0, 0, 1}));
  EXPECT_FALSE(alone.at(6, n));  // no area
  EXPECT_FALSE(alone.at(7, n));  // no triangle
  const FormulaNormals together(along, 8, {NormalWeight::area, NormalSum::place});
  ASSERT_TRUE(together.at(3, n));
  EXPECT_EQ(n[1], n[2]);
  EXPECT_EQ(n[0], 0);
  EXPECT_NEAR(n[1], std::sqrt(.5), 1e-15);
  const FormulaNormals sums(along, 8, {NormalWeight::angle, NormalSum::place, true, false});
  ASSERT_TRUE(sums.at(0, n));
  EXPECT_NEAR(n[2], -std::acos(0.), 1e-15);
}

TEST(NormalValues, NoBytesHarm) {
  corpus::Random random(5);
  const auto all_grounds = grounds();
  for (std::size_t g = 0; g < all_grounds.size(); g += 23) {
    const Ground& ground = all_grounds[g];
    const int level = g % 2 == 0 ? 5 : 9;
    for (const Rows& given : rows_of(ground.values, g)) {
      const Bytes bytes =
          encode_normals<std::int64_t>(given.rows, given.numbers, ground.along(), level);
      std::size_t refused = 0;
      for (int round = 0; round < 20; ++round) {
        Bytes hostile = bytes;
        if (round % 2 == 1)
          hostile.resize(random.below(static_cast<std::uint32_t>(bytes.size())));
        else
          for (int i = 0; i <= round; ++i)
            hostile[random.below(static_cast<std::uint32_t>(bytes.size()))] ^=
                static_cast<std::byte>(1 << random.below(8));
        std::vector<std::int64_t> back(given.rows.size());
        const auto decoded = decode_normals<std::int64_t>(hostile, 0, given.numbers, ground.along(),
                                                          std::span<std::int64_t>(back));
        if (!decoded) {
          ++refused;
          EXPECT_TRUE(decoded.error().code == ErrorCode::invalid ||
                      decoded.error().code == ErrorCode::truncated);
          continue;
        }
        const std::size_t width = given.numbers.axes.size();
        for (std::size_t i = 0; i < back.size(); ++i) {
          ASSERT_GE(back[i], 0);
          ASSERT_LE(static_cast<std::uint64_t>(back[i]), given.numbers.axes[i % width].top);
        }
      }
      EXPECT_GT(refused, 5u);
    }
  }
}

TEST(NormalValues, OthersAreRefused) {
  Ground ground = {coded(corpus::tetrahedron()), 4, positions(4, Places::rough)};
  const Rows rows = directions(vectors(4, 1), 10);
  EXPECT_TRUE(may_be_normals(rows.numbers, ground.along()));
  ValueSurface nowhere = ground.along();
  nowhere.position = nullptr;
  EXPECT_FALSE(may_be_normals(rows.numbers, nowhere));
  std::vector<std::int64_t> back(rows.rows.size());
  EXPECT_FALSE(decode_normals<std::int64_t>({}, 0, rows.numbers, nowhere, std::span(back)).ok());
  ground.position.components = 2;
  EXPECT_FALSE(may_be_normals(rows.numbers, ground.along()));
  ground.position.components = 3;
  Numbers wide = numbered(std::vector<float>(12, 1), true).numbers;
  wide.scalar = Scalar::int32;
  EXPECT_FALSE(may_be_normals(wide, ground.along()));
  Bytes none;
  EXPECT_TRUE(
      decode_normals<std::int64_t>(none, 0, rows.numbers, ground.along(), std::span<std::int64_t>())
          .ok());
  put_u8(none, 0);
  EXPECT_FALSE(
      decode_normals<std::int64_t>(none, 0, rows.numbers, ground.along(), std::span<std::int64_t>())
          .ok());
}

}  // namespace
}  // namespace clers::internal
