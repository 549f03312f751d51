// Named values come back, whatever they are and whatever they lie on; and no bytes harm.
#include "codec/attributes/named_values.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "codec/attributes/named_values_decoder.h"
#include "codec/attributes/named_values_encoder.h"
#include "codec/entropy/stream.h"
#include "codec/test/coded_surfaces.h"
#include "corpus/generate.h"
#include "corpus/random.h"

namespace clers::internal {
namespace {

using test::coded;

/// A surface, and how many values there are on it.
struct Ground {
  CodedArrays arrays;
  std::size_t values;
  Domain domain = Domain::vertex;
};

std::vector<Ground> grounds() {
  std::vector<Ground> all;
  for (const Mesh& mesh :
       {corpus::icosphere(2), corpus::punch_holes(corpus::torus(20, 15), 12, 1),
        corpus::copies(corpus::icosphere(1), 3), corpus::single_triangle(), corpus::fan(300)}) {
    all.push_back({coded(mesh), mesh.vertex_count});
    all.push_back({all.back().arrays, mesh.vertex_count + 7});  // some in no triangle
  }
  // Stitched: several vertices made one, with the twins of before.
  Ground stitched = all[2];
  stitched.values = 100;
  for (std::uint32_t& v : stitched.arrays.corners) v = (v * 7 + 3) % 100;
  stitched.arrays.introduced_by.assign(100, 0);
  find_introducing(stitched.arrays.corners, stitched.arrays.introduced_by);
  all.push_back(stitched);
  // One by one, without twins, some vertices twice in a triangle.
  corpus::Random random(1);
  Ground raw;
  for (int i = 0; i < 300; ++i) raw.arrays.corners.push_back(random.below(90));
  raw.arrays.introduced_by.assign(95, 0);
  find_introducing(raw.arrays.corners, raw.arrays.introduced_by);
  raw.values = 99;
  all.push_back(raw);
  // Corners; without twins; and where polygons have others than their triangles.
  for (std::size_t i = 0, n = all.size(); i < n; i += 3) {
    Ground corners = all[i];
    corners.domain = Domain::corner;
    corners.values = corners.arrays.corners.size();
    all.push_back(corners);
    corners.arrays.twins.clear();
    all.push_back(corners);
    --corners.values;
    all.push_back(corners);
    corners.domain = Domain::face;
    all.push_back(corners);
  }
  // None: as of faces.
  for (const std::size_t values : {std::size_t(0), std::size_t(1), std::size_t(500)})
    all.push_back({{}, values, Domain::face});
  return all;
}

/// Rough, smooth, few, constant, all extremes.
template <class Int>
std::vector<Int> rows_on(const Ground& ground, std::span<const Axis> axes, unsigned kind,
                         std::uint64_t seed) {
  corpus::Random random(seed);
  std::vector<Int> rows(ground.values * axes.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Axis& axis = axes[i % axes.size()];
    const std::size_t v = i / axes.size();
    std::uint64_t x = 0;
    if (kind == 0) x = random.next() % (axis.top + 1);
    if (kind == 1)
      x = axis.top / 2 + std::min<std::uint64_t>(axis.top / 2, v / 4 + random.below(3));
    if (kind == 2) x = v / 5 % 3 * (axis.top / 3);
    if (kind == 3) x = axis.top;
    if (kind == 4) x = random.chance(50) ? axis.top : 0;
    if (!axis.palette.empty()) x = axis.palette[x % axis.palette.size()];
    rows[i] = static_cast<Int>(x);
  }
  return rows;
}
constexpr unsigned kinds = 5;

template <class Int>
void expect_to_come_back(const Ground& ground, const std::vector<Axis>& axes, unsigned kind) {
  if (axes.size() * ground.values > 6000) return;
  auto rows = rows_on<Int>(ground, axes, kind, axes.size() + kind);
  const auto given = rows;
  const Bytes bytes =
      encode_named_values<Int>({rows, axes}, ValueSurface{ground.arrays.view()}, ground.domain);
  EXPECT_EQ(rows, given);
  std::vector<Int> back(rows.size(), std::numeric_limits<Int>::min());
  const auto decoded = decode_named_values<Int>(bytes, 0, axes, ValueSurface{ground.arrays.view()},
                                                std::span<Int>(back), ground.domain);
  ASSERT_TRUE(decoded.ok()) << describe(decoded.error());
  EXPECT_EQ(back, given);
}

std::vector<std::vector<Axis>> all_axes(std::uint64_t most) {
  std::vector<std::vector<Axis>> all = {
      {Axis{0}},
      {Axis{1}},
      {Axis{most}},
      {Axis{most, 1, {0, 1, 5, most - 1, most}}},
      {Axis{255}, Axis{255}, Axis{255}, Axis{0}},
      {Axis{most}, Axis{most}, Axis{most}},
      {Axis{18, 1, {0, 3, 18}}, Axis{0, 1, {0}}, Axis{most}, Axis{1000}},
  };
  all.emplace_back(255, Axis{65535});
  return all;
}

TEST(NamedValues, ComeBack) {
  const auto narrow = all_axes(most_narrow), wide = all_axes(most_wide);
  unsigned kind = 0;  // not all with all: each comes with each in turn
  for (const Ground& ground : grounds())
    for (std::size_t i = 0; i < narrow.size(); ++i) {
      expect_to_come_back<std::int32_t>(ground, narrow[i], kind++ % kinds);
      expect_to_come_back<std::int64_t>(ground, wide[i], kind++ % kinds);
    }
}

TEST(NamedValues, ComeBackByEveryModel) {
  for (const Ground& ground : grounds())
    for (const std::uint64_t top : {std::uint64_t(100), most_wide})
      for (std::uint32_t number = 0; number < named_models; ++number) {
        if (ground.values > 600) break;
        const NamedModel model = named_model(number);
        EXPECT_EQ(number_of(model), number);
        ASSERT_TRUE(model.fits(3) || model.predictor == NamedPredictor::symbol);
        if (!model.fits(3)) continue;
        const std::vector<Axis> axes(3, Axis{top});
        const std::vector<std::uint64_t> tops(3, top);
        auto rows = rows_on<std::int64_t>(ground, axes, number % kinds, number);
        const auto given = rows;
        const auto visit = [&](auto& coder, std::span<std::int64_t> values) {
          NamedValueCoder<std::int64_t, std::remove_reference_t<decltype(coder)>> coded(
              coder, model, tops, values);
          return for_each_nearby(
              ground.domain, ValueSurface{ground.arrays.view()}, ground.values, ground.values,
              [&](std::uint32_t v, const Nearby& nearby) { return coded.code(v, nearby); });
        };
        const Bytes bytes = encode_stream([&](EncodeTo& coder) { visit(coder, rows); });
        std::vector<std::int64_t> back(rows.size(), -1);
        const auto decoded = decode_stream({bytes, 0}, "values", [&](DecodeFrom& coder) {
          return std::string(visit(coder, back) ? "" : "beyond");
        });
        ASSERT_TRUE(decoded.ok()) << number;
        ASSERT_EQ(back, given) << number;
      }
}

TEST(NamedValues, WhatIsAroundAndBeforeSaves) {
  // A colour on a sphere: the same change of brightness in all three, mostly.
  const Ground ground{coded(corpus::icosphere(4)), 2562};
  const std::vector<Axis> axes(3, Axis{255});
  std::vector<std::int32_t> rows(3 * ground.values);
  corpus::Random random(1);
  // Smooth along the surface: a mean of what is known, and a little more.
  const auto nearby_mean = [&](const Nearby& n, std::size_t c) {
    std::int32_t sum = 0;
    for (std::size_t i = 0; i < n.count; ++i) sum += rows[3 * n.around[i] + c];
    const auto count = std::int32_t(n.count);
    return count ? (sum + count / 2) / count : 128;
  };
  for_each_with_nearby(
      ValueSurface{ground.arrays.view()}, ground.values, ground.values,
      [&](std::uint32_t v, const Nearby& n) {
        const auto light = std::int32_t(random.below(17)) - 8;
        for (std::size_t c = 0; c < 3; ++c)
          rows[3 * v + c] =
              std::clamp(nearby_mean(n, c) + light + std::int32_t(random.below(3)) - 1, 0, 255);
        return true;
      });
  const Bytes bytes =
      encode_named_values<std::int32_t>({rows, axes}, ValueSurface{ground.arrays.view()});
  // log2(17) and twice log2(3) at most are 7.3 bits.
  EXPECT_LT(8 * bytes.size(), ground.values * 9);
  const NamedModel model = named_model(std::to_integer<std::uint32_t>(bytes[0]));
  EXPECT_EQ(model.predictor, NamedPredictor::mean);
  EXPECT_EQ(model.relation, Relation::green);
  // The same row everywhere costs next to nothing.
  for (std::size_t i = 3; i < rows.size(); ++i) rows[i] = rows[i - 3];
  EXPECT_LT(
      encode_named_values<std::int32_t>({rows, axes}, ValueSurface{ground.arrays.view()}).size(),
      40u);
}

TEST(NamedValues, ComponentsThatAreTheSameAroundSave) {
  // Columns of a wall: x is the same down each, y is rough.
  const Ground ground{coded(corpus::grid(40, 30)), 41 * 31};
  const std::vector<Axis> axes(2, Axis{(1u << 24) - 1});
  std::vector<std::int32_t> rows(2 * ground.values, -1);
  corpus::Random random(2);
  for_each_with_nearby(ValueSurface{ground.arrays.view()}, ground.values, ground.values,
                       [&](std::uint32_t v, const Nearby& n) {
                         const bool same = n.count > 0 && random.chance(80);
                         rows[2 * v] = same ? rows[2 * n.around[random.below(2) % n.count]]
                                            : std::int32_t(random.below(1u << 24));
                         rows[2 * v + 1] = std::int32_t(random.below(1u << 24));
                         return true;
                       });
  const Bytes bytes =
      encode_named_values<std::int32_t>({rows, axes}, ValueSurface{ground.arrays.view()});
  EXPECT_EQ(named_model(std::to_integer<std::uint32_t>(bytes[0])).repeats, Repeats::components);
  EXPECT_LT(8 * bytes.size(), ground.values * (24 + 6 + 2 + 3));
}

TEST(NamedValues, CornersOfOneVertexShareItsValue) {
  Ground ground{coded(corpus::icosphere(3)), 0, Domain::corner};
  ground.values = ground.arrays.corners.size();
  const std::vector<Axis> axes(2, Axis{4095});
  // Two charts: a value for each vertex and half of the faces.
  std::vector<std::int32_t> rows;
  for (std::size_t h = 0; h < ground.values; ++h) {
    corpus::Random random(2 * ground.arrays.corners[h] + (2 * h < ground.values));
    for (int c = 0; c < 2; ++c) rows.push_back(std::int32_t(random.below(4096)));
  }
  const Bytes bytes = encode_named_values<std::int32_t>(
      {rows, axes}, ValueSurface{ground.arrays.view()}, ground.domain);
  EXPECT_EQ(named_model(std::to_integer<std::uint32_t>(bytes[0])).repeats, Repeats::values);
  // 642 vertices, and a tenth of them twice.
  EXPECT_LT(8 * bytes.size(), 642 * 11 / 10 * 24 + ground.values * 2);
  Ground by_number = ground;
  by_number.domain = Domain::face;
  EXPECT_GT(encode_named_values<std::int32_t>({rows, axes}, ValueSurface{by_number.arrays.view()},
                                              by_number.domain)
                .size(),
            2 * bytes.size());
}

TEST(NamedValues, NoBytesHarm) {
  corpus::Random random(9);
  for (const Ground& ground : grounds()) {
    if (ground.values == 0) continue;
    for (const auto& axes : all_axes(most_wide)) {
      if (axes.size() > 10) continue;
      auto rows = rows_on<std::int64_t>(ground, axes, random.below(kinds), random.next());
      const Bytes bytes = encode_named_values<std::int64_t>(
          {rows, axes}, ValueSurface{ground.arrays.view()}, ground.domain);
      std::size_t refused = 0;
      for (int round = 0; round < 20; ++round) {
        Bytes hostile = bytes;
        if (round % 2)
          hostile.resize(random.below(std::uint32_t(bytes.size())));
        else
          for (int i = 0; i <= round; ++i)
            hostile[random.below(std::uint32_t(bytes.size()))] = std::byte(random.below(256));
        std::vector<std::int64_t> back(rows.size(), -1);
        const auto decoded =
            decode_named_values<std::int64_t>(hostile, 3, axes, ValueSurface{ground.arrays.view()},
                                              std::span<std::int64_t>(back), ground.domain);
        refused += !decoded.ok();
        if (decoded.ok())
          for (std::size_t i = 0; i < back.size(); ++i) {
            const Axis& axis = axes[i % axes.size()];
            ASSERT_GE(back[i], 0);
            ASSERT_LE(std::uint64_t(back[i]), axis.top);
            ASSERT_TRUE(axis.palette.empty() ||
                        std::binary_search(axis.palette.begin(), axis.palette.end(),
                                           std::uint64_t(back[i])));
          }
      }
      EXPECT_GE(refused, 10u);  // all that are too short
      Bytes longer = bytes;
      longer.push_back(std::byte(0));
      std::vector<std::int64_t> back(rows.size());
      EXPECT_FALSE(decode_named_values<std::int64_t>(longer, 0, axes,
                                                     ValueSurface{ground.arrays.view()},
                                                     std::span<std::int64_t>(back), ground.domain)
                       .ok());
    }
  }
}

TEST(NamedValues, WhatIsNotAModelIsRefused) {
  const std::vector<Axis> axes(2, Axis{5});
  std::vector<std::int32_t> back(8);
  const auto refused = [&](const Bytes& bytes) {
    const auto decoded =
        decode_named_values<std::int32_t>(bytes, 11, axes, {}, std::span<std::int32_t>(back));
    return !decoded.ok() && decoded.error().code != ErrorCode::internal && decoded.error().at >= 11;
  };
  EXPECT_TRUE(refused({}));
  EXPECT_TRUE(refused({std::byte(named_models), std::byte(0), std::byte(1)}));
  const auto byte_of = [](NamedModel model) { return std::byte(number_of(model)); };
  EXPECT_TRUE(refused({byte_of({NamedPredictor::before, Relation::green, Repeats::none}),
                       std::byte(0), std::byte(1)}));
  EXPECT_TRUE(refused({byte_of({NamedPredictor::symbol, Relation::sum, Repeats::values}),
                       std::byte(0), std::byte(1)}));
  back.clear();
  EXPECT_TRUE(refused({std::byte(0)}));
  EXPECT_FALSE(refused({}));
}

}  // namespace
}  // namespace clers::internal
