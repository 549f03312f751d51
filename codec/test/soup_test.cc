// Any faces survive: random soups of few vertices and many faces have every kind of degeneracy.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cstdlib>
#include <random>

#include "codec/compare.h"
#include "codec/inspect.h"
#include "codec/test/attribute.h"
#include "codec/test/round_trip.h"
#include "corpus/generate.h"

namespace clers::internal {
namespace {

using Random = std::mt19937_64;

std::uint32_t below(Random& random, std::uint32_t n) {
  return static_cast<std::uint32_t>(random() % n);
}

/// Faces of up to `most` corners on random vertices, some of them repeated whole or reversed.
Mesh random_soup(Random& random, std::uint32_t vertices, std::uint32_t faces, std::uint32_t most) {
  Mesh mesh;
  mesh.vertex_count = vertices;
  std::vector<std::vector<std::uint32_t>> all;
  for (std::uint32_t f = 0; f < faces; ++f) {
    std::vector<std::uint32_t> face;
    const std::uint32_t kind = below(random, 10);
    if (kind == 0 && f > 0) {
      face = all[below(random, f)];
      if (below(random, 2)) std::reverse(face.begin(), face.end());
    } else {
      const std::uint32_t size = most == 3   ? 3
                                 : kind == 1 ? below(random, most + 1)
                                             : 3 + below(random, most - 2);
      for (std::uint32_t j = 0; j < size; ++j) face.push_back(below(random, vertices));
    }
    mesh.corners.insert(mesh.corners.end(), face.begin(), face.end());
    if (most != 3) mesh.face_sizes.push_back(static_cast<std::uint32_t>(face.size()));
    all.push_back(face);
  }
  // Values tell vertices apart, and are decoded along whatever surface becomes of the faces.
  std::vector<std::uint16_t> values(2 * std::size_t(vertices));
  for (std::uint16_t& value : values) value = static_cast<std::uint16_t>(random());
  mesh.attributes = {test::attribute(position_name, Domain::vertex, Scalar::uint16, 2, values)};
  return mesh;
}

unsigned long_runs() {
  const char* n = std::getenv("CLERS_LONG");
  return n ? static_cast<unsigned>(std::strtoul(n, nullptr, 10)) : 1;
}

TEST(Soup, SmallOnesSurvive) {
  const unsigned count = 5000 * long_runs();
  for (unsigned i = 0; i < count; ++i) {
    Random random(i);
    const std::uint32_t vertices = 1 + below(random, 9), most = i % 2 ? 3 : 6;
    const Mesh mesh = random_soup(random, vertices, below(random, 14), most);
    round_trip(std::span(&mesh, 1));
    round_trip(std::span(&mesh, 1), default_level, Order::keep);
    if (::testing::Test::HasFailure()) {
      std::string text = "seed " + std::to_string(i) + ":";
      std::size_t c = 0;
      for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        text += " (";
        for (std::uint32_t j = 0; j < size_of_face(mesh, f); ++j)
          text += " " + std::to_string(mesh.corners[c++]);
        text += " )";
      }
      FAIL() << text;
    }
  }
}

TEST(Soup, LargerOnesSurvive) {
  for (unsigned i = 0; i < 100 * long_runs(); ++i) {
    Random random(i);
    const std::uint32_t vertices = 10 + below(random, 1000), most = i % 2 ? 3 : 8;
    const Mesh mesh = random_soup(random, vertices, 1000, most);
    round_trip(std::span(&mesh, 1));
    round_trip(std::span(&mesh, 1), default_level, Order::keep);
    ASSERT_FALSE(::testing::Test::HasFailure()) << "seed " << i;
  }
}

}  // namespace
}  // namespace clers::internal
