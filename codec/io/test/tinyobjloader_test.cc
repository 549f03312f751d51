// Another reader of OBJ agrees, where it can: it counts the corners of a face in a byte.
#include <filesystem>
#include <random>

#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#endif
#define TINYOBJLOADER_IMPLEMENTATION
#define TINYOBJLOADER_USE_DOUBLE
#include <tiny_obj_loader.h>
#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "codec/io/test/meshes.h"

namespace clers::io {
namespace {

void compare_with_other_reader(const std::string& file) {
  tinyobj::ObjReaderConfig config;
  config.triangulate = false;
  config.vertex_color = false;
  tinyobj::ObjReader reader;
  ASSERT_TRUE(reader.ParseFromString(file, "", config)) << reader.Error();
  const Mesh mesh = must_read(file, Format::obj).meshes[0];

  const tinyobj::attrib_t& attrib = reader.GetAttrib();
  ASSERT_EQ(mesh.vertex_count, attrib.vertices.size() / 3);
  const Attribute& position = *mesh.position();
  for (std::size_t i = 0; i < attrib.vertices.size(); ++i) {
    double value = 0;
    if (position.scalar == Scalar::float32) {
      float narrow;
      std::memcpy(&narrow, position.data.data() + i * sizeof narrow, sizeof narrow);
      if (std::isfinite(narrow)) {  // others it does not read
        ASSERT_EQ(narrow, static_cast<float>(attrib.vertices[i])) << i;
      }
      continue;
    }
    std::memcpy(&value, position.data.data() + i * sizeof value, sizeof value);
    // It adds digit by digit, and so may be off by some units in the last place.
    ASSERT_NEAR(value, attrib.vertices[i], std::abs(value) * 1e-14) << i;
  }

  const Attribute* texcoord = nullptr;
  for (const Attribute& a : mesh.attributes)
    if (a.name == "texcoord") texcoord = &a;
  std::size_t corner = 0, face = 0;
  for (const tinyobj::shape_t& shape : reader.GetShapes()) {
    for (const auto size : shape.mesh.num_face_vertices) {
      ASSERT_EQ(size, mesh.triangles_only() ? 3 : mesh.face_sizes[face]) << face;
      ++face;
    }
    for (const tinyobj::index_t& index : shape.mesh.indices) {
      ASSERT_EQ(mesh.corners[corner], static_cast<std::uint32_t>(index.vertex_index));
      if (texcoord && texcoord->scalar == Scalar::float32) {
        const std::uint32_t value = texcoord->indices[corner];
        ASSERT_EQ(value, static_cast<std::uint32_t>(index.texcoord_index));
        if (value == no_value) {
          ++corner;
          continue;
        }
        float u;
        std::memcpy(&u, texcoord->data.data() + value * texcoord->stride(), sizeof u);
        ASSERT_EQ(u, static_cast<float>(
                         attrib.texcoords[2 * static_cast<std::size_t>(index.texcoord_index)]));
      }
      ++corner;
    }
  }
  ASSERT_EQ(corner, mesh.corners.size());
}

TEST(TinyObjLoader, AgreesOnRandomFiles) {
  std::mt19937 random(1);
  for (int i = 0; i < 200; ++i) {
    std::ostringstream file;
    file.precision(9);
    const auto vertices = static_cast<unsigned>(3 + random() % 20);
    for (unsigned v = 0; v < vertices; ++v) {
      file << "v";
      for (int c = 0; c < 3; ++c) file << ' ' << static_cast<float>(random()) * 1e-6f;
      file << "\nvt " << static_cast<float>(random() % 1000) / 1000 << " 0\n";
    }
    for (unsigned f = 0; f < 20; ++f) {
      file << "f";
      const auto size = static_cast<unsigned>(3 + random() % 5);
      for (unsigned c = 0; c < size; ++c) {
        const auto v = static_cast<int>(random() % vertices);
        const int index = random() % 2 ? v + 1 : v - static_cast<int>(vertices);
        file << ' ' << index << '/' << index;
      }
      file << '\n';
    }
    ASSERT_NO_FATAL_FAILURE(compare_with_other_reader(file.str())) << file.str();
  }
}

TEST(TinyObjLoader, AgreesOnTheCorpus) {
  const char* directory = std::getenv("CLERS_CORPUS");
  if (!directory) GTEST_SKIP() << "CLERS_CORPUS is not set";
  for (const auto& entry : std::filesystem::directory_iterator(directory)) {
    if (entry.path().extension() != ".obj") continue;
    SCOPED_TRACE(entry.path().filename().string());
    std::ifstream in(entry.path(), std::ios::binary);
    std::ostringstream file;
    file << in.rdbuf();
    ASSERT_NO_FATAL_FAILURE(compare_with_other_reader(file.str()));
  }
}

}  // namespace
}  // namespace clers::io
