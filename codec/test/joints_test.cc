// Joints and their weights come back, whatever they are and whatever they lie on, whole and one by
// one; no bytes do harm; and what a neighbour has takes next to nothing.
#include "codec/attributes/joints.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "codec/attributes/weights.h"
#include "codec/decode.h"
#include "codec/encode.h"
#include "codec/file/container.h"
#include "codec/numbers/number_encoder.h"
#include "codec/test/attribute.h"
#include "codec/test/coded_surfaces.h"
#include "codec/test/decoding.h"
#include "codec/test/round_trip.h"
#include "corpus/generate.h"
#include "corpus/random.h"

namespace clers::internal {
namespace {

using test::attribute;

std::vector<Axis> axes_of(const std::vector<std::int32_t>& rows, std::size_t width) {
  std::vector<Axis> axes(width);
  for (std::size_t i = 0; i < rows.size(); ++i)
    axes[i % width].top = std::max(axes[i % width].top, static_cast<std::uint64_t>(rows[i]));
  return axes;
}

void check(const std::vector<std::int32_t>& rows, std::span<const Axis> axes,
           const ValueSurface& along, corpus::Random& random) {
  ASSERT_TRUE(may_be_joints(axes));
  const Bytes bytes = encode_joints(rows, axes, along);
  std::vector<std::int32_t> out(rows.size());
  for (std::int32_t& x : out) x = static_cast<std::int32_t>(random.next());
  const auto done = decode_joints(bytes, 0, axes, along, out);
  ASSERT_TRUE(done.ok()) << done.error().what;
  ASSERT_EQ(out, rows);
  for (unsigned i = 0; i < 8 && !bytes.empty(); ++i) {
    Bytes changed = bytes;
    if (i < 6)
      changed[random.below(static_cast<std::uint32_t>(bytes.size()))] ^=
          static_cast<std::byte>(1 + random.below(255));
    else if (i == 6)
      changed.resize(random.below(static_cast<std::uint32_t>(bytes.size())));
    else
      changed.push_back(static_cast<std::byte>(random.below(256)));
    const auto result = decode_joints(changed, 5, axes, along, out);
    for (std::size_t k = 0; result.ok() && k < out.size(); ++k) {
      ASSERT_GE(out[k], 0);
      ASSERT_LE(static_cast<std::uint64_t>(out[k]), axes[k % axes.size()].top);
    }
  }
}

TEST(Joints, ComeBack) {
  corpus::Random random(1);
  unsigned kind = 0;
  for (const CodedArrays& s : test::coded_surfaces()) {
    if (kind++ % 3 != 0) continue;
    ValueSurface along{s.view()};
    const std::size_t count = s.introduced_by.size() + random.below(3), width = 2 + random.below(5);
    std::vector<std::uint32_t> vertex_of(count);
    for (std::uint32_t& v : vertex_of) v = random.below(static_cast<std::uint32_t>(count));
    if (random.chance(50)) along.vertex_of = vertex_of;
    if (random.chance(20)) along.surface.twins = {};
    // A few joints, in any order; all of 16 bits; and none but 0.
    const std::uint32_t few = 1 + random.below(6);
    for (const std::uint32_t joints : {few, 65536u, 1u}) {
      std::vector<std::int32_t> rows;
      for (std::size_t i = 0; i < count * width; ++i)
        rows.push_back(static_cast<std::int32_t>(random.below(joints)));
      check(rows, axes_of(rows, width), along, random);
    }
  }
  std::vector<std::int32_t> rows = {0, 65535, 65535, 0, 0, 65535, 7, 7};
  check(rows, axes_of(rows, 2), {}, random);
}

TEST(Joints, OthersAreRefused) {
  const std::vector<Axis> one(1), wide(2, Axis{65536}), two(2);
  EXPECT_FALSE(may_be_joints(one));
  EXPECT_FALSE(may_be_joints(wide));
  EXPECT_FALSE(may_be_joints(std::vector<Axis>(17)));
  std::vector<std::int32_t> out(4);
  EXPECT_FALSE(decode_joints({}, 0, wide, {}, out).ok());
  EXPECT_FALSE(decode_joints({}, 0, two, {}, out).ok());
  out.assign(1 << 20, 0);
  EXPECT_FALSE(decode_joints(Bytes(8), 0, two, {}, out).ok());  // more than they can say
  out.clear();
  EXPECT_TRUE(decode_joints({}, 0, two, {}, out).ok());
  EXPECT_FALSE(decode_joints(Bytes(1), 0, two, {}, out).ok());
}

/// The skin of a torus with bones around it, four at each vertex, in ascending order.
struct Skin {
  std::vector<std::uint8_t> joints;
  std::vector<float> weights;
};
Skin skin_of(std::uint32_t around, std::uint32_t across, std::uint32_t bones) {
  Skin skin;
  for (std::uint32_t v = 0; v < around * across; ++v) {
    const double i = v / across, j = v % across,
                 place = 1 + i * bones / around + .4 * std::sin(.31 * i + .47 * j),
                 rest = place - std::floor(place);
    std::array<std::pair<double, std::uint32_t>, 4> all;
    double sum = 0;
    for (std::uint32_t k = 0; k < 4; ++k) {
      const double off = rest + 1 - k;  // from the bone before to the second after
      const double near = off * off + .1;
      all[k] = {1 / (near * near), (static_cast<std::uint32_t>(place) + bones + k - 1) % bones};
      sum += all[k].first;
    }
    std::sort(all.begin(), all.end(), [](auto a, auto b) { return a.second < b.second; });
    for (const auto& [weight, joint] : all) {
      skin.weights.push_back(static_cast<float>(weight / sum));
      skin.joints.push_back(static_cast<std::uint8_t>(joint));
    }
  }
  return skin;
}

TEST(Joints, OfNeighboursCostNextToNothing) {
  constexpr std::uint32_t around = 120, across = 30;
  const Mesh mesh = corpus::torus(around, across);
  auto twins = find_twins({mesh.corners, mesh.face_sizes}, mesh.vertex_count);
  ASSERT_TRUE(twins.ok());
  const auto coded = encode_connectivity({mesh.corners, *twins, mesh.vertex_count}, 5);
  ASSERT_TRUE(coded.ok());
  const CodedArrays surface = test::decoded(coded->bytes);
  const Skin skin = skin_of(around, across, 24);
  std::vector<std::int32_t> rows;
  for (const std::uint32_t v : coded->vertices)
    for (std::size_t c = 0; c < 4; ++c) rows.push_back(skin.joints[4 * v + c]);
  const std::vector<Axis> axes = axes_of(rows, 4);
  EXPECT_TRUE(look_like_joints(rows, axes, {surface.view()}));
  EXPECT_LT(8 * encode_joints(rows, axes, {surface.view()}).size(), rows.size() / 4 * 3 / 2);
  corpus::Random random(3);
  for (std::int32_t& x : rows) x = static_cast<std::int32_t>(random.below(24));
  EXPECT_FALSE(look_like_joints(rows, axes, {surface.view()}));
}

Mesh skinned_torus() {
  Mesh mesh = corpus::torus(48, 20);
  const Skin skin = skin_of(48, 20, 9);
  mesh.attributes.push_back(
      attribute("WEIGHTS_0", Domain::vertex, Scalar::float32, 4, skin.weights));
  mesh.attributes.push_back(attribute("JOINTS_0", Domain::vertex, Scalar::uint8, 4, skin.joints));
  return mesh;
}

/// Every corner has a vertex of its own.
Mesh unindexed(const Mesh& mesh) {
  Mesh out;
  out.vertex_count = static_cast<std::uint32_t>(mesh.corners.size());
  for (std::uint32_t c = 0; c < out.vertex_count; ++c) out.corners.push_back(c);
  for (const Attribute& a : mesh.attributes) {
    Attribute b{a.name, a.domain, a.scalar, a.components, {}};
    for (const std::uint32_t v : mesh.corners) {
      const auto bytes = value(a, v);
      b.data.insert(b.data.end(), bytes.begin(), bytes.end());
    }
    out.attributes.push_back(std::move(b));
  }
  return out;
}

const AttributeInfo& info_of(const MeshInfo& info, const std::string& name) {
  return *std::find_if(info.attributes.begin(), info.attributes.end(),
                       [&](const AttributeInfo& a) { return a.name == name; });
}

/// Whole, with threads, and each attribute alone.
void expect_skin_comes_back(const Mesh& mesh, const EncodeOptions& options) {
  const auto encoded = encode(mesh, options);
  ASSERT_TRUE(encoded.ok()) << describe(encoded.error());
  const MeshInfo& info = encoded->report[0];
  EXPECT_EQ(info_of(info, "JOINTS_0").coder, "joints");
  EXPECT_EQ(info_of(info, "WEIGHTS_0").coder, "skin");
  for (const unsigned threads : {1u, 3u}) {
    DecodeOptions decoding;
    decoding.threads = threads;
    const auto decoded = decode(encoded->bytes, decoding);
    ASSERT_TRUE(decoded.ok()) << describe(decoded.error());
    expect_permuted(mesh, (*decoded)[0], encoded->permutations[0]);
    for (const Attribute& a : (*decoded)[0].attributes) {
      std::vector<std::byte> data(a.data.size());
      const AttributeTarget target{a.name, a.domain, a.scalar, a.components, data};
      const auto ok = test::decode_into(encoded->bytes, {.attributes = std::span(&target, 1)});
      ASSERT_TRUE(ok.ok()) << describe(ok.error());
      EXPECT_EQ(data, a.data) << a.name;
    }
  }
}

TEST(Skin, ComesBackWholeAndAlone) {
  const Mesh mesh = skinned_torus();
  expect_skin_comes_back(mesh, {});
  EncodeOptions pieces;
  pieces.piece_faces = 400;
  expect_skin_comes_back(mesh, pieces);
}

TEST(Skin, OfWeldedVertices) {
  const Mesh mesh = unindexed(skinned_torus());
  expect_skin_comes_back(mesh, {});
  const auto encoded = encode(mesh);
  ASSERT_TRUE(encoded.ok());
  EXPECT_GT(encoded->report[0].welded_vertices, 0u);
}

TEST(Skin, SavesWhatJointsSay) {
  // The same joints in another order from vertex to vertex.
  Mesh with = skinned_torus();
  corpus::Random random(6);
  for (std::size_t v = 0; v < with.vertex_count; ++v) {
    const std::size_t by = random.below(4);
    for (Attribute& a : with.attributes) {
      const auto row = a.data.begin() + static_cast<std::ptrdiff_t>(v * a.stride());
      std::rotate(row, row + static_cast<std::ptrdiff_t>(by * a.stride() / 4),
                  row + static_cast<std::ptrdiff_t>(a.stride()));
    }
  }
  Mesh without = with;
  without.attributes.back().name = "joints";
  EncodeOptions options;
  options.precisions = {{"WEIGHTS_0", Precision::of_bits(10)}};
  const auto one = encode(with, options), other = encode(without, options);
  ASSERT_TRUE(one.ok() && other.ok());
  const auto bytes = [](const Encoded& e) { return info_of(e.report[0], "WEIGHTS_0").bytes; };
  EXPECT_LT(4 * bytes(*one), 3 * bytes(*other));
}

TEST(Skin, NeedsJointsThatFit) {
  // Others than these: of another number of components, of floats, of faces, missing.
  for (unsigned kind = 0; kind < 4; ++kind) {
    Mesh mesh = skinned_torus();
    Attribute& joints = mesh.attributes.back();
    if (kind == 0) {
      joints.components = 2;
      joints.data.resize(joints.data.size() / 2);
    } else if (kind == 1) {
      joints = attribute("JOINTS_0", Domain::vertex, Scalar::float32, 4,
                         std::vector<float>(4 * std::size_t(mesh.vertex_count), 1));
    } else if (kind == 2) {
      joints = attribute("JOINTS_0", Domain::face, Scalar::uint8, 4,
                         std::vector<std::uint8_t>(4 * mesh.face_count(), 1));
    } else {
      mesh.attributes.pop_back();
    }
    const auto encoded = encode(mesh);
    ASSERT_TRUE(encoded.ok());
    EXPECT_NE(info_of(encoded->report[0], "WEIGHTS_0").coder, "skin");
    const auto decoded = decode(encoded->bytes);
    ASSERT_TRUE(decoded.ok());
    expect_permuted(mesh, (*decoded)[0], encoded->permutations[0]);
  }
}

TEST(Skin, QuantisedJointsAreNone) {
  EncodeOptions options;
  options.precisions = {{"WEIGHTS_0", Precision::of_bits(8)}};
  const auto encoded = encode(skinned_torus(), options);
  ASSERT_TRUE(encoded.ok()) << describe(encoded.error());
  EXPECT_EQ(info_of(encoded->report[0], "WEIGHTS_0").coder, "skin");
  EXPECT_TRUE(decode(encoded->bytes).ok());
  options.precisions.push_back({"JOINTS_0", Precision::of_step(3)});
  const auto other = encode(skinned_torus(), options);
  ASSERT_TRUE(other.ok()) << describe(other.error());
  EXPECT_NE(info_of(other->report[0], "WEIGHTS_0").coder, "skin");
}

/// The sections of a file, of which `change` changes payloads, with right checksums.
template <class Change>
Bytes changed(std::span<const std::byte> bytes, Change change) {
  ContainerReader in(bytes);
  EXPECT_TRUE(in.open().ok());
  ContainerWriter out(5);
  for (;;) {
    const auto section = in.next();
    EXPECT_TRUE(section.ok());
    if (section->kind == SectionKind::end) return out.finish(1);
    Bytes payload(section->payload.begin(), section->payload.end());
    change(section->kind, payload);
    out.section(section->kind, payload);
  }
}

TEST(Skin, NeedsItsJointsInTheFile) {
  const auto encoded = encode(skinned_torus());
  ASSERT_TRUE(encoded.ok());
  const auto rename = [](std::string_view from, char to) {
    return [=](SectionKind kind, Bytes& payload) {
      const auto name = std::as_bytes(std::span(from));
      const auto at = std::search(payload.begin(), payload.end(), name.begin(), name.end());
      if (kind == SectionKind::attribute && at != payload.end()) at[7] = std::byte(to);
    };
  };
  const std::string what = "weights of joints that are not there";
  for (const auto& bytes : {changed(encoded->bytes, rename("JOINTS_0", '1')),
                            changed(encoded->bytes, rename("WEIGHTS_0", 'X'))}) {
    const auto decoded = decode(bytes);
    ASSERT_FALSE(decoded.ok());
    EXPECT_NE(decoded.error().what.find(what), std::string::npos) << decoded.error().what;
  }
}

TEST(Skin, NoBytesHarm) {
  corpus::Random random(5);
  for (const Mesh& mesh : {skinned_torus(), unindexed(skinned_torus())}) {
    const auto encoded = encode(mesh);
    ASSERT_TRUE(encoded.ok());
    for (unsigned i = 0; i < 150; ++i) {
      const Bytes bytes = changed(encoded->bytes, [&](SectionKind kind, Bytes& payload) {
        const auto size = static_cast<std::uint32_t>(payload.size());
        if (kind != SectionKind::attribute || random.chance(50)) return;
        if (random.chance(10)) return payload.resize(random.below(size));
        payload[random.below(random.chance(50) ? std::min(size, 40u) : size)] ^=
            static_cast<std::byte>(1 + random.below(255));
      });
      const auto decoded = decode(bytes);
      if (!decoded) continue;
      for (const Attribute& a : (*decoded)[0].attributes)
        EXPECT_EQ(a.data.size(), a.stride() * (*decoded)[0].value_count(a.domain));
    }
  }
}

}  // namespace
}  // namespace clers::internal
