// Real meshes, if the directory CLERS_CORPUS names has them: the counts of its MANIFEST.tsv, and
// every mesh through every format that can hold it.
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include "codec/io/test/meshes.h"

namespace clers::io {
namespace {

using Row = std::map<std::string, std::string>;

std::vector<Row> manifest(const std::filesystem::path& file) {
  std::vector<Row> rows;
  std::vector<std::string> columns;
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    std::istringstream cells(line);
    Row row;
    std::size_t i = 0;
    for (std::string cell; std::getline(cells, cell, '\t'); ++i)
      if (columns.size() > i) row[columns[i]] = cell;
    if (row.empty()) {
      std::istringstream names(line);
      for (std::string name; std::getline(names, name, '\t');) columns.push_back(name);
    } else {
      rows.push_back(std::move(row));
    }
  }
  return rows;
}

std::vector<std::byte> load(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return bytes_of(text.str());
}

TEST(Corpus, CountsAreTheManifestsAndFilesReadBack) {
  const char* directory = std::getenv("CLERS_CORPUS");
  if (!directory) GTEST_SKIP() << "CLERS_CORPUS is not set";
  std::size_t read_files = 0;
  for (Row& row : manifest(std::filesystem::path(directory) / "MANIFEST.tsv")) {
    const std::filesystem::path path = std::filesystem::path(directory) / row["name"];
    const std::optional<Format> format = format_of(row["name"]);
    if (!format || !std::filesystem::exists(path)) continue;
    SCOPED_TRACE(row["name"]);
    const Mesh mesh = must_read(load(path), *format).meshes[0];
    ++read_files;
    std::size_t triangles = 0;
    for (std::size_t f = 0; f < mesh.face_count(); ++f)
      triangles += (mesh.triangles_only() ? 3 : mesh.face_sizes[f]) - 2;
    // What scripts/fetch-corpus fetches has the columns of corpus/MANIFEST.tsv.
    const bool ours = row.count("vertices") != 0;
    EXPECT_EQ(std::to_string(mesh.vertex_count), row[ours ? "vertices" : "V"]);
    EXPECT_EQ(std::to_string(triangles), row[ours ? "triangles" : "F"]);
    if (!ours) {
      EXPECT_EQ(std::to_string(mesh.face_count()), row["polygons"]);
    }

    for (const Encoding encoding : {Encoding::text, Encoding::binary})
      EXPECT_TRUE(same(
          must_read(must_write(mesh, Format::ply, encoding).bytes, Format::ply).meshes[0], mesh));
    for (const Format other : {Format::obj, Format::off}) {
      const Mesh back = must_read(must_write(mesh, other).bytes, other).meshes[0];
      EXPECT_EQ(back.corners, mesh.corners);
      EXPECT_EQ(back.face_sizes, mesh.face_sizes);
      EXPECT_EQ(back.position()->scalar, mesh.position()->scalar);
      EXPECT_TRUE(back.position()->data == mesh.position()->data);
    }
  }
  EXPECT_GT(read_files, 0u);
}

}  // namespace
}  // namespace clers::io
