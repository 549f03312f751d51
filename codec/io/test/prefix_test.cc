// Files that are cut or damaged anywhere: an error that says where, or a mesh that holds together.
#include <random>

#include "codec/io/test/meshes.h"

namespace clers::io {
namespace {

Mesh sample() {
  Mesh mesh;
  mesh.vertex_count = 5;
  mesh.corners = {0, 1, 2, 0, 2, 3, 4};
  mesh.face_sizes = {3, 4};
  mesh.name = "sample";
  mesh.attributes = {
      attribute<float>("position", Domain::vertex, 3,
                       {0, .1f, -2, 1e-9f, 4, 5, 6, 7, 8, 9, 1e20f, 11, 12, 13, 14}),
      attribute<float>("normal", Domain::vertex, 3, std::vector<float>(15, .5f)),
      attribute<std::uint8_t>("color", Domain::vertex, 4, std::vector<std::uint8_t>(20, 200)),
      attribute<float>("texcoord", Domain::corner, 2, std::vector<float>(14, .25f)),
      attribute<std::uint8_t>("color", Domain::face, 3, {1, 2, 3, 4, 5, 6}),
      attribute<double>("my value", Domain::face, 2, {1, 2, 3, 4}),
  };
  return mesh;
}

struct Sample {
  Format format;
  std::vector<std::byte> file;
};

std::vector<Sample> samples() {
  Mesh triangles = sample();
  triangles.corners = {0, 1, 2, 2, 3, 4};
  triangles.face_sizes.clear();
  std::erase_if(triangles.attributes,
                [](const Attribute& a) { return a.domain == Domain::corner; });
  std::vector<Sample> list;
  for (const Encoding encoding : {Encoding::text, Encoding::binary}) {
    list.push_back({Format::ply, must_write(sample(), Format::ply, encoding).bytes});
    list.push_back({Format::stl, must_write(triangles, Format::stl, encoding).bytes});
  }
  list.push_back({Format::obj, must_write(sample(), Format::obj).bytes});
  list.push_back({Format::off, must_write(sample(), Format::off).bytes});
  list.push_back(
      {Format::ply, bytes_of("ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\n"
                             "element tristrips 1\nproperty list int int vertex_index\n"
                             "element edge 1\nproperty int a\nend_header\n1 2 3 4\n"
                             "6 0 1 2 -1 1 2\n7\n")});
  return list;
}

void read_and_check(const std::vector<std::byte>& file, Format format) {
  // Of the exact size, for sanitizers to see a read past the end.
  const std::vector<std::byte> exact(file.begin(), file.end());
  const Expected<ReadResult> result = read(exact, format);
  if (!result) {
    ASSERT_FALSE(result.error().what.empty());
    return;
  }
  for (const Mesh& mesh : result->meshes) {
    std::size_t corners = 0;
    for (const std::uint32_t size : mesh.face_sizes) corners += size;
    ASSERT_EQ(mesh.corners.size(), mesh.triangles_only() ? 3 * mesh.face_count() : corners);
    for (const std::uint32_t v : mesh.corners) ASSERT_LT(v, mesh.vertex_count);
    const std::size_t counts[] = {mesh.vertex_count, mesh.corners.size(), mesh.face_count()};
    for (const Attribute& a : mesh.attributes) {
      const std::size_t count = counts[static_cast<unsigned>(a.domain)];
      ASSERT_EQ(a.data.size() % a.stride(), 0u) << a.name;
      ASSERT_EQ(a.indices.empty() ? a.value_count() : a.indices.size(), count) << a.name;
      for (const std::uint32_t i : a.indices)
        ASSERT_TRUE(i == no_value || i < a.value_count()) << a.name;
    }
  }
}

TEST(Damaged, EveryPrefix) {
  for (const auto& [format, file] : samples())
    for (std::size_t size = 0; size <= file.size(); ++size)
      read_and_check({file.begin(), file.begin() + static_cast<std::ptrdiff_t>(size)}, format);
}

TEST(Damaged, EveryByteChanged) {
  for (auto& [format, file] : samples())
    for (std::byte& byte : file) {
      const std::byte before = byte;
      for (const unsigned value : {0u, 9u, 10u, 32u, 45u, 48u, 57u, 127u, 255u}) {
        byte = static_cast<std::byte>(value);
        read_and_check(file, format);
      }
      byte = before;
    }
}

TEST(Damaged, PiecesRemovedDoubledAndSwapped) {
  std::mt19937 random(1);
  for (const Sample& sample : samples())
    for (int i = 0; i < 2000; ++i) {
      const std::vector<std::byte>& file = sample.file;
      const auto place = [&] {
        return file.begin() + static_cast<std::ptrdiff_t>(random() % file.size());
      };
      auto a = place(), b = place(), c = place();
      std::vector<std::byte> changed(file.begin(), a);
      changed.insert(changed.end(), std::min(b, c), std::max(b, c));
      changed.insert(changed.end(), c, file.end());
      read_and_check(changed, sample.format);
    }
}

}  // namespace
}  // namespace clers::io
