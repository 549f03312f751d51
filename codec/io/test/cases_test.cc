// Small files as programs write them, each for a kind: all that is read of it, what is said, and
// how it is written back, against expected.txt beside them. The files are after public reports of
// people who met such files.
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include "codec/io/test/meshes.h"

namespace clers::io {
namespace {

namespace fs = std::filesystem;

std::string load(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

// Text in quotes, a line.
std::string shown(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    constexpr char digits[] = "0123456789abcdef";
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= ' ' && byte < 0x7f && c != '"' && c != '\\')
      out += c;
    else
      out += {'\\', 'x', digits[byte / 16], digits[byte % 16]};
  }
  return out + '"';
}

std::string value(const Attribute& a, std::size_t i) {
  const auto as = [&]<class T>(T v) -> std::string {
    std::memcpy(&v, a.data.data() + i * sizeof v, sizeof v);
    if constexpr (std::is_floating_point_v<T>)
      if (std::isnan(v)) return std::signbit(v) ? "-nan" : "nan";
    char text[64];
    if constexpr (sizeof(T) == 1)
      return std::to_string(static_cast<int>(v));
    else
      return {text, std::to_chars(text, text + sizeof text, v).ptr};
  };
  switch (a.scalar) {
    case Scalar::int8: return as(std::int8_t{});
    case Scalar::uint8: return as(std::uint8_t{});
    case Scalar::int16: return as(std::int16_t{});
    case Scalar::uint16: return as(std::uint16_t{});
    case Scalar::int32: return as(std::int32_t{});
    case Scalar::uint32: return as(std::uint32_t{});
    case Scalar::int64: return as(std::int64_t{});
    case Scalar::uint64: return as(std::uint64_t{});
    case Scalar::float32: return as(float{});
    case Scalar::float64: return as(double{});
  }
  return {};
}

std::string shown(const Mesh& mesh) {
  static constexpr const char* domains[] = {"vertex", "corner", "face"};
  static constexpr const char* scalars[] = {"int8",   "uint8", "int16",  "uint16",  "int32",
                                            "uint32", "int64", "uint64", "float32", "float64"};
  std::string out = std::to_string(mesh.vertex_count) + " vertices, faces";
  std::size_t c = 0;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    for (std::uint32_t i = 0; i < (mesh.triangles_only() ? 3 : mesh.face_sizes[f]); ++i)
      out += ' ' + std::to_string(mesh.corners[c++]);
    out += ',';
  }
  out += '\n';
  for (const Attribute& a : mesh.attributes) {
    out += std::string(domains[static_cast<unsigned>(a.domain)]) + ' ' + shown(a.name) + ' ' +
           scalars[static_cast<unsigned>(a.scalar)] + ':';
    for (std::size_t i = 0; i < a.data.size() / size_of(a.scalar); ++i)
      out += (i > 0 && i % a.components == 0 ? ", " : " ") + value(a, i);
    if (!a.indices.empty()) out += " by";
    for (const std::uint32_t i : a.indices) out += i == no_value ? " -" : ' ' + std::to_string(i);
    out += '\n';
  }
  if (!mesh.name.empty()) out += "name " + shown(mesh.name) + '\n';
  for (const MetadataEntry& e : mesh.metadata) out += e.key + ' ' + shown(e.value) + '\n';
  return out;
}

std::string shown(const Notes& notes) {
  std::string out;
  for (const Note& n : notes)
    out += (n.kind == Note::Kind::loss ? "loss: " : "remark: ") + n.text + '\n';
  return out;
}

std::string told_of(const fs::path& path) {
  const std::string file = load(path);
  const Format format = *format_of(path.extension().string());
  const Expected<ReadResult> read = clers::io::read(bytes_of(file), format);
  if (!read) return "refused: " + describe(read.error()) + '\n';
  std::string out = shown(read->meshes[0]) + shown(read->notes);
  const auto source = source_of(read->meshes[0]);
  EXPECT_TRUE(source && source->format == format) << path;
  const bool text = source && source->encoding == Encoding::text;
  const WriteResult back =
      must_write(read->meshes[0], format,
                 format == Format::ply || text ? std::optional(Encoding::text) : std::nullopt);
  const std::string notes = shown(back.notes);
  if (!notes.empty()) out += "written back:\n" + notes;
  if (format == Format::ply) {  // names
    std::istringstream lines(text_of(back.bytes));
    for (std::string line; std::getline(lines, line) && line != "end_header";)
      if (!line.starts_with("ply") && !line.starts_with("format")) out += "  " + shown(line) + '\n';
  } else if (format != Format::stl) {
    const std::string written = text_of(back.bytes);
    out += "  " + shown(written.substr(0, written.find("\nv "))) + '\n';
  }
  // What was written reads as what was read, but for what it says of the file.
  if (format != Format::stl) {
    const Mesh again = must_read(back.bytes, format).meshes[0];
    EXPECT_TRUE(same(again, read->meshes[0])) << path;
    EXPECT_EQ(metadata_of(again, "comment"), metadata_of(read->meshes[0], "comment")) << path;
    EXPECT_EQ(metadata_of(again, "ply.properties"), metadata_of(read->meshes[0], "ply.properties"))
        << path;
  }
  return out;
}

TEST(Cases, AreReadAndToldAsTheyShould) {
  std::map<std::string, std::string> expected;
  std::istringstream lines(load(fs::path(CLERS_IO_CASES) / "expected.txt"));
  std::string name;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("== "))
      name = line.substr(3);
    else
      expected[name] += line + '\n';
  }
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(CLERS_IO_CASES))
    if (format_of(entry.path().filename().string())) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  EXPECT_EQ(files.size(), expected.size());
  const char* record = std::getenv("CLERS_RECORD_CASES");  // a file: what it says now
  std::ofstream out;
  if (record) out.open(record, std::ios::binary);
  for (const fs::path& file : files) {
    const std::string told = told_of(file);
    EXPECT_EQ(told, expected[file.filename().string()]) << file;
    if (record) out << "== " << file.filename().string() << '\n' << told;
  }
}

}  // namespace
}  // namespace clers::io
