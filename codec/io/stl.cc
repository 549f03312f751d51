// Triangles without vertices: corners at one place become one vertex.
// Source: 3D Systems, StereoLithography Interface Specification, 1989.
#include <algorithm>
#include <bit>
#include <cctype>
#include <cstring>

#include "codec/io/formats.h"
#include "codec/io/numbers.h"
#include "codec/io/weld.h"

namespace clers::io {

namespace {

constexpr std::size_t header_size = 80, start_size = 84, triangle_size = 50;

std::uint32_t little_u32(const char* from) {
  std::uint32_t value = 0;
  for (unsigned i = 0; i < 4; ++i)
    value |= std::uint32_t{static_cast<unsigned char>(from[i])} << (8 * i);
  return value;
}

void add_binary(Output& out, float value) {
  out.little(std::bit_cast<std::uint32_t>(value));
}

bool same_word(std::string_view a, std::string_view lower_case) {
  return std::equal(a.begin(), a.end(), lower_case.begin(), lower_case.end(), [](char x, char y) {
    return std::tolower(static_cast<unsigned char>(x)) == y;
  });
}

// Corners' positions -> a mesh of the positions that differ.
Mesh welded_mesh(Attribute positions, Notes& notes) {
  const Welded welded = weld(positions.data, positions.stride());
  Mesh mesh;
  mesh.vertex_count = static_cast<std::uint32_t>(welded.first.size());
  Attribute a{position_name, Domain::vertex, positions.scalar, 3, {}};
  a.data.resize(mesh.vertex_count * a.stride());
  for (std::size_t v = 0; v < welded.first.size(); ++v)
    std::memcpy(a.data.data() + v * a.stride(),
                positions.data.data() + welded.first[v] * a.stride(), a.stride());
  note_line(notes, counted(welded.number.size(), "corner", "corners") + " became " +
                       counted(mesh.vertex_count, "vertex", "vertices") + " by equal positions");
  mesh.corners = welded.number;
  mesh.attributes.push_back(std::move(a));
  return mesh;
}

void note_normals(Notes& notes, std::uint64_t normals) {
  if (normals)
    note_line(notes, counted(normals, "facet normal was", "facet normals were") + " left out");
}

// Too many corners to number, or not.
Expected<Done> check_count(std::uint64_t triangles) {
  if (triangles < 0xffffffffu / 3) return Done{};
  return fail(ErrorCode::too_large,
              "expected fewer than 1431655765 triangles, found " + std::to_string(triangles));
}

Expected<ReadResult> read_binary(std::string_view file) {
  if (file.size() < start_size)
    return fail(ErrorCode::malformed, Place::byte, file.size(),
                "expected 84 bytes before the first triangle, or text that begins with 'solid'");
  const std::uint32_t triangles = little_u32(file.data() + header_size);
  const std::size_t room = (file.size() - start_size) / triangle_size;
  if (triangles > room)
    return fail(ErrorCode::malformed, Place::byte, header_size,
                "expected a number of triangles that fits the file, of which it holds " +
                    std::to_string(room) + ", found " + std::to_string(triangles));
  if (Expected<Done> few = check_count(triangles); !few) return Failure<Error>{few.error()};

  // A triangle: normal, three corners, 16 bits for anything.
  Attribute positions{{}, Domain::corner, Scalar::float32, 3, {}};
  positions.data.resize(std::size_t{triangles} * 36);
  std::uint64_t normals = 0, other_bytes = 0;
  std::byte* to = positions.data.data();
  for (const char* t = file.data() + start_size;
       to != positions.data.data() + positions.data.size(); t += triangle_size) {
    normals += std::any_of(t, t + 12, [](char c) { return c != 0; });
    other_bytes += t[48] != 0 || t[49] != 0;
    for (const char* from = t + 12; from != t + 48; from += 4, to += 4) {
      const std::uint32_t bits = little_u32(from);
      std::memcpy(to, &bits, sizeof bits);
    }
  }
  ReadResult result;
  result.meshes.push_back(welded_mesh(std::move(positions), result.notes));
  note_normals(result.notes, normals);
  if (other_bytes)
    note_line(result.notes, "the attribute bytes of " +
                                counted(other_bytes, "triangle", "triangles") + " were left out");
  if (const std::size_t rest = file.size() - start_size - triangles * triangle_size)
    note_line(result.notes, counted(rest, "byte", "bytes") + " after the last triangle " +
                                (rest == 1 ? "was" : "were") + " left out");
  return result;
}

class TextReader {
 public:
  explicit TextReader(std::string_view file) : text_(file) {}

  Expected<ReadResult> read() {
    do {
      if (Expected<Done> done = solid(); !done) return Failure<Error>{done.error()};
    } while (!text_.at_end());
    if (Expected<Done> few = check_count(positions_.size() / 9); !few)
      return Failure<Error>{few.error()};
    ReadResult result;
    result.meshes.push_back(welded_mesh(positions_.take({}, Domain::corner, 3), result.notes));
    note_normals(result.notes, normals_);
    if (solids_ == 1)
      result.meshes[0].name = std::move(name_);
    else
      note_line(result.notes, std::to_string(solids_) + " solids became one mesh");
    return result;
  }

 private:
  // solid NAME, facets, endsolid NAME
  Expected<Done> solid() {
    if (!words({"solid"})) return text_.expected("'solid'");
    name_ = text_.rest_of_line();
    ++solids_;
    for (;;) {
      text_.skip_space();
      const Text before = text_;
      if (same_word(text_.token(), "endsolid")) break;
      text_ = before;
      if (Expected<Done> done = facet(); !done) return done;
    }
    text_.rest_of_line();
    return Done{};
  }

  // facet normal N outer loop vertex A vertex B vertex C endloop endfacet
  Expected<Done> facet() {
    if (!words({"facet", "normal"})) return text_.expected("'facet normal' or 'endsolid'");
    bool normal = false;
    for (unsigned i = 0; i < 3; ++i) {
      double n = 0;
      text_.skip_space();
      if (!text_.number(n)) return text_.expected("a component of the normal");
      normal = normal || n != 0;
    }
    normals_ += normal;
    if (!words({"outer", "loop"})) return text_.expected("'outer loop'");
    for (unsigned corner = 0; corner < 3; ++corner) {
      if (!words({"vertex"})) return text_.expected("'vertex'");
      for (unsigned i = 0; i < 3; ++i) {
        text_.skip_space();
        if (!positions_.read(text_)) return text_.expected("a coordinate");
      }
    }
    if (!words({"endloop"})) return text_.expected("'endloop' after three vertices");
    if (!words({"endfacet"})) return text_.expected("'endfacet'");
    return Done{};
  }

  bool words(std::initializer_list<std::string_view> lower_case) {
    for (const std::string_view word : lower_case) {
      text_.skip_space();
      const Text before = text_;
      if (same_word(text_.token(), word)) continue;
      text_ = before;
      return false;
    }
    return true;
  }

  Text text_;
  Numbers positions_;
  std::uint64_t normals_ = 0, solids_ = 0;
  std::string name_;
};

// Text begins with "solid", but so do the headers of some binary files: these tell by their size.
bool is_binary(std::string_view file) {
  if (file.size() >= start_size &&
      file.size() - start_size ==
          std::uint64_t{little_u32(file.data() + header_size)} * triangle_size)
    return true;
  Text text(file);
  text.skip_space();
  return !same_word(text.token(), "solid");
}

}  // namespace

Expected<ReadResult> read_stl(std::string_view file) {
  return is_binary(file) ? read_binary(file) : TextReader(file).read();
}

Expected<Done> write_stl(const Mesh& mesh, Encoding encoding, Output& out, Notes& notes) {
  for (std::size_t f = 0; f < mesh.face_sizes.size(); ++f)
    if (mesh.face_sizes[f] != 3)
      return fail(ErrorCode::unsupported, Place::face, f,
                  "expected 3 corners, which is what STL holds, found " +
                      std::to_string(mesh.face_sizes[f]));
  const Attribute* position = mesh.position();
  const bool is_float =
      position && (position->scalar == Scalar::float32 || position->scalar == Scalar::float64);
  if (mesh.vertex_count > 0 && (!is_float || position->components != 3))
    return fail(ErrorCode::unsupported, "expected positions with 3 floating point components");
  if (Expected<Done> few = check_count(mesh.face_count()); !few) return few;

  Attribute narrow{position_name, Domain::vertex, Scalar::float32, 3, {}};
  std::uint64_t rounded = 0;
  if (position && position->scalar == Scalar::float64) {
    narrow.data.resize(position->data.size() / 2);
    for (std::size_t i = 0; i < narrow.data.size() / sizeof(float); ++i) {
      double wide;
      std::memcpy(&wide, position->data.data() + i * sizeof wide, sizeof wide);
      const auto value = static_cast<float>(wide);
      rounded += std::bit_cast<std::uint64_t>(static_cast<double>(value)) !=
                 std::bit_cast<std::uint64_t>(wide);
      std::memcpy(narrow.data.data() + i * sizeof value, &value, sizeof value);
    }
  } else if (position) {
    narrow.data = position->data;
  }
  if (rounded)
    note_line(notes,
              counted(rounded, "coordinate was", "coordinates were") + " rounded to float32");
  for (const Attribute& a : mesh.attributes)
    if (&a != position) note_left_out(notes, a);
  std::vector<bool> used(mesh.vertex_count);
  for (const std::uint32_t v : mesh.corners) used[v] = true;
  if (const auto unused = std::count(used.begin(), used.end(), false))
    note_line(notes, counted(static_cast<std::uint64_t>(unused), "vertex", "vertices") +
                         " of no face " + (unused == 1 ? "was" : "were") + " left out");

  // Normals are derived from the corners, so that zeros, which the format allows, say as much.
  const std::size_t triangles = mesh.face_count();
  if (encoding == Encoding::text) {
    std::string name = mesh.name;
    std::replace_if(
        name.begin(), name.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
    note_lost_nans(notes, narrow);
    out << "solid" << (name.empty() ? "" : " ") << name << '\n';
    for (std::size_t f = 0; f < triangles; ++f) {
      out << "facet normal 0 0 0\nouter loop\n";
      for (std::size_t c = 3 * f; c < 3 * f + 3; ++c) {
        out << "vertex";
        for (std::size_t i = 0; i < 3; ++i) {
          out << ' ';
          print(out, narrow, std::size_t{3} * mesh.corners[c] + i);
        }
        out << '\n';
      }
      out << "endloop\nendfacet\n";
    }
    out << "endsolid" << (name.empty() ? "" : " ") << name << '\n';
    return Done{};
  }
  if (!mesh.name.empty()) note_line(notes, "the name " + quoted(mesh.name) + " was left out");
  for (std::size_t i = 0; i < header_size; ++i) out << '\0';
  out.little(static_cast<std::uint32_t>(triangles));
  for (std::size_t f = 0; f < triangles; ++f) {
    for (unsigned i = 0; i < 3; ++i) add_binary(out, 0.0f);
    for (std::size_t c = 3 * f; c < 3 * f + 3; ++c) {
      for (std::size_t i = 0; i < 3; ++i) {
        float value;
        std::memcpy(&value,
                    narrow.data.data() + (std::size_t{3} * mesh.corners[c] + i) * sizeof value,
                    sizeof value);
        add_binary(out, value);
      }
    }
    out.little(std::uint16_t{0});
  }
  return Done{};
}

}  // namespace clers::io
