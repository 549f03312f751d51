// Triangles without vertices: corners at one place become one vertex.
// Source: 3D Systems, StereoLithography Interface Specification, 1989.
#include <algorithm>
#include <bit>
#include <cctype>
#include <cmath>
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

struct Vector {
  double x = 0, y = 0, z = 0;
};

// The unit vector that three corners (9 numbers) span, in float64; 0 0 0 if they span none.
Vector normal_of(const float* p) {
  const auto at = [&](unsigned i) { return static_cast<double>(p[i]); };
  const Vector a{at(3) - at(0), at(4) - at(1), at(5) - at(2)};
  const Vector b{at(6) - at(0), at(7) - at(1), at(8) - at(2)};
  const Vector n{a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
  const double length = std::sqrt(n.x * n.x + n.y * n.y + n.z * n.z);
  if (!(length > 0) || std::isinf(length)) return {};
  return {n.x / length + 0.0, n.y / length + 0.0, n.z / length + 0.0};  // + 0.0: no -0.0
}

// What the normals of a file say that its corners do not say too.
class Normals {
 public:
  void add(const double* normal, const float* corners) {
    ++facets_;
    if (normal[0] == 0 && normal[1] == 0 && normal[2] == 0) return;  // "find it yourself"
    ++all_;
    const Vector n = normal_of(corners);
    constexpr double most = 1e-3;  // files have few digits
    if (!(std::fabs(n.x - normal[0]) <= most && std::fabs(n.y - normal[1]) <= most &&
          std::fabs(n.z - normal[2]) <= most))
      ++others_;
  }
  std::uint64_t facets() const { return facets_; }
  void note(Notes& notes) const {
    note_left_out(notes, others_, "facet normal", "facet normals",
                  "not the normals of the corners");
    if (all_ > others_)
      note_remark(notes, all_ - others_, counted(all_ - others_, "facet normal", "facet normals"),
                  "came from the corners and will again");
  }

 private:
  std::uint64_t facets_ = 0, all_ = 0, others_ = 0;
};

// Corners' positions -> a mesh of the positions that differ. 0.0 and -0.0 are one place; the vertex
// has the signs of its first corner.
template <class T>
std::uint64_t clear_signs_of_zeros(std::vector<std::byte>& values) {
  std::uint64_t cleared = 0;
  for (std::size_t i = 0; i < values.size(); i += sizeof(T)) {
    T value;
    std::memcpy(&value, values.data() + i, sizeof value);
    if (value != 0 || !std::signbit(value)) continue;
    value = 0;
    std::memcpy(values.data() + i, &value, sizeof value);
    ++cleared;
  }
  return cleared;
}

Mesh welded_mesh(Attribute positions, Notes& notes) {
  const bool wide = positions.scalar == Scalar::float64;
  std::vector<std::byte> places = positions.data;
  const std::uint64_t signs =
      wide ? clear_signs_of_zeros<double>(places) : clear_signs_of_zeros<float>(places);
  const std::size_t stride = positions.stride();
  const Welded welded = weld(places, stride);
  Mesh mesh;
  mesh.vertex_count = static_cast<std::uint32_t>(welded.first.size());
  Attribute a{position_name, Domain::vertex, positions.scalar, 3, {}};
  a.data.resize(mesh.vertex_count * a.stride());
  for (std::size_t v = 0; v < welded.first.size(); ++v)
    std::memcpy(a.data.data() + v * stride, positions.data.data() + welded.first[v] * stride,
                stride);
  note_remark(notes, welded.number.size(), counted(welded.number.size(), "corner", "corners"),
              "became " + counted(mesh.vertex_count, "vertex", "vertices") + " by equal positions");
  if (signs > 0) {
    std::uint64_t changed = 0;
    const std::size_t size = size_of(positions.scalar);
    for (std::size_t c = 0; c < welded.number.size(); ++c)
      for (std::size_t i = 0; i < stride; i += size)
        changed += std::memcmp(positions.data.data() + c * stride + i,
                               a.data.data() + welded.number[c] * stride + i, size) != 0;
    if (changed > 0)
      notes.push_back({Note::Kind::loss, changed,
                       "the " + std::string(changed == 1 ? "sign" : "signs") + " of " +
                           counted(changed, "zero", "zeros"),
                       "the " + std::string(changed == 1 ? "sign" : "signs") + " of " +
                           counted(changed, "zero", "zeros") +
                           " changed: another corner of the vertex has the other one"});
  }
  mesh.corners = welded.number;
  mesh.attributes.push_back(std::move(a));
  return mesh;
}

// Too many corners to number, or not.
Expected<Done> check_count(std::uint64_t triangles) {
  if (triangles < 0xffffffffu / 3) return Done{};
  return fail(ErrorCode::too_large,
              "expected fewer than 1431655765 triangles, found " + std::to_string(triangles));
}

// The number of triangles, where the file's size leaves no doubt of it: a count of 0 or 2^32 - 1,
// which stands there until a program knows better, or too small a one before whole triangles.
Expected<std::uint32_t> count_of(std::string_view file, Notes& notes) {
  const std::uint32_t said = little_u32(file.data() + header_size);
  const std::size_t rest = file.size() - start_size, room = rest / triangle_size;
  if (Expected<Done> few = check_count(room); !few && said > 0xffffffffu / 3)
    return Failure<Error>{few.error()};
  const bool whole = rest % triangle_size == 0 && room > 0;
  if (whole && said != room && (said < room || said == 0xffffffffu)) {
    note_remark(notes, room, counted(room, "triangle", "triangles"),
                "fill the file, although it says " + std::to_string(said));
    return static_cast<std::uint32_t>(room);
  }
  if (said > room || (said == 0 && room > 0))
    return fail(ErrorCode::malformed, Place::byte, header_size,
                "expected a number of triangles that fits the file, of which it holds " +
                    std::to_string(room) + ", found " + std::to_string(said));
  return said;
}

Expected<ReadResult> read_binary(std::string_view file) {
  ReadResult result;
  const bool no_count = file.size() == header_size;
  if (file.size() < start_size && !no_count)
    return fail(ErrorCode::malformed, Place::byte, file.size(),
                "expected 84 bytes before the first triangle, or text that begins with 'solid'");
  if (no_count)
    note_remark(result.notes, 1, "the number of triangles", "is missing, and so are triangles");
  const Expected<std::uint32_t> triangles = no_count ? 0u : count_of(file, result.notes);
  if (!triangles) return Failure<Error>{triangles.error()};
  if (Expected<Done> few = check_count(*triangles); !few) return Failure<Error>{few.error()};

  // A triangle: normal, three corners, 16 bits for anything, such as a colour.
  Attribute positions{{}, Domain::corner, Scalar::float32, 3, {}};
  positions.data.resize(std::size_t{*triangles} * 36);
  Normals normals;
  Attribute bits{std::string(stl_bits_name), Domain::face, Scalar::uint16, 1, {}};
  bits.data.resize(std::size_t{*triangles} * 2);
  bool any_bits = false;
  std::byte* to = positions.data.data();
  std::byte* bits_to = bits.data.data();
  const char* t = file.data() + std::min(start_size, file.size());
  for (; to != positions.data.data() + positions.data.size(); t += triangle_size) {
    float numbers[12];
    for (unsigned i = 0; i < 12; ++i)
      numbers[i] = std::bit_cast<float>(little_u32(t + std::size_t{4} * i));
    const double normal[] = {numbers[0], numbers[1], numbers[2]};
    normals.add(normal, numbers + 3);
    const auto both = static_cast<std::uint16_t>(static_cast<unsigned char>(t[48]) |
                                                 static_cast<unsigned char>(t[49]) << 8);
    any_bits |= both != 0;
    std::memcpy(bits_to, &both, sizeof both);
    bits_to += sizeof both;
    std::memcpy(to, numbers + 3, 36);
    to += 36;
  }
  Mesh mesh = welded_mesh(std::move(positions), result.notes);
  const std::string_view header = file.substr(0, header_size);
  if (const std::size_t last = header.find_last_not_of('\0'); last != header.npos)
    set_metadata(mesh, header_key, std::string(header.substr(0, last + 1)));
  if (any_bits) mesh.attributes.push_back(std::move(bits));
  set_metadata(mesh, source_key, "stl binary");
  result.meshes.push_back(std::move(mesh));
  normals.note(result.notes);
  note_left_out(result.notes, static_cast<std::uint64_t>(file.data() + file.size() - t), "byte",
                "bytes", "after the last triangle");
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
    set_metadata(result.meshes[0], source_key, "stl ascii");
    normals_.note(result.notes);
    if (names_.size() == 1)
      result.meshes[0].name = std::move(names_[0]);
    else
      note_left_out(result.notes, names_.size(), "solid", "solids", "they became one mesh");
    note_left_out(result.notes, colors_, "colour", "colours");
    if (open_)
      result.notes.push_back({Note::Kind::loss, 1, "line endsolid",
                              "the line endsolid is missing: the file may be cut short"});
    return result;
  }

 private:
  // solid NAME, facets, endsolid NAME; the first line may be missing.
  Expected<Done> solid() {
    const Text start = text_;
    const bool named = words({"solid"});
    if (!named && !(names_.empty() && words({"facet"}))) return text_.expected("'solid'");
    if (!named) text_ = start;
    names_.emplace_back(named ? text_.rest_of_line() : std::string_view());
    for (;;) {
      text_.skip_space();
      const Text before = text_;
      // Some programs write the name without a blank.
      if (same_word(text_.token().substr(0, 8), "endsolid")) break;
      text_ = before;
      if (ends("solid")) break;
      if (text_.at_end() && normals_.facets() > 0) {
        open_ = named;
        break;
      }
      if (color()) continue;
      if (Expected<Done> done = facet(); !done) return done;
    }
    text_.rest_of_line();
    return Done{};
  }

  // facet normal N outer loop vertex A vertex B vertex C endloop endfacet
  Expected<Done> facet() {
    if (!words({"facet", "normal"})) return text_.expected("'facet normal' or 'endsolid'");
    double normal[3];
    for (double& n : normal) {
      text_.skip_space();
      if (!text_.number(n)) return text_.expected("a component of the normal");
    }
    color();
    if (!words({"outer", "loop"})) return text_.expected("'outer loop'");
    float corners[9];
    for (unsigned corner = 0; corner < 3; ++corner) {
      color();
      if (!words({"vertex"})) return text_.expected("'vertex'");
      for (unsigned i = 0; i < 3; ++i) {
        text_.skip_space();
        if (!positions_.read(text_)) return text_.expected("a coordinate");
        corners[3 * corner + i] = static_cast<float>(positions_.last());
      }
    }
    normals_.add(normal, corners);
    color();
    if (!ends("loop")) return text_.expected("'endloop' after three vertices");
    color();
    if (!ends("facet")) return text_.expected("'endfacet'");
    return Done{};
  }

  // A line or the rest of one, which no specification knows: color R G B, or one number.
  bool color() {
    Text ahead = text_;
    ahead.skip_space();
    const std::string_view word = ahead.token();
    if (!same_word(word, "color") && !same_word(word, "colour")) return false;
    ahead.rest_of_line();
    text_ = ahead;
    ++colors_;
    return true;
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

  // "endloop", which some programs write as two words.
  bool ends(std::string_view what) {
    text_.skip_space();
    const Text before = text_;
    if (words({"end" + std::string(what)}) || words({"end", what})) return true;
    text_ = before;
    return false;
  }

  Text text_;
  Numbers positions_;
  Normals normals_;
  std::uint64_t colors_ = 0;
  bool open_ = false;  // the last solid has no end
  std::vector<std::string> names_;
};

// Text begins with "solid", but so do the headers of some binary files: these are known by their
// size, or by what follows, of which the number of triangles at least is no text.
bool is_binary(std::string_view file, std::string_view without_padding) {
  if (file.size() >= start_size &&
      file.size() - start_size ==
          std::uint64_t{little_u32(file.data() + header_size)} * triangle_size)
    return true;
  Text text(without_padding);
  text.skip_space();
  const std::string_view word = text.token();
  if (!same_word(word, "solid") && !same_word(word, "facet")) return true;
  if (file.size() == header_size && file.find_first_of("\r\n") == file.npos) return true;
  const std::string_view start = without_padding.substr(0, 512);
  return std::any_of(start.begin(), start.end(),
                     [](char c) { return c >= 0 && c < ' ' && !(c >= '\t' && c <= '\r'); });
}

// Polygons as fans, faces of fewer corners left out; what attributes of faces and corners would
// need is not kept.
std::vector<std::uint32_t> triangles_of(const Mesh& mesh, Notes& notes) {
  if (mesh.triangles_only()) return mesh.corners;
  std::vector<std::uint32_t> corners;
  std::uint64_t polygons = 0, made = 0, small = 0;
  std::size_t first = 0;
  for (const std::uint32_t size : mesh.face_sizes) {
    polygons += size > 3;
    small += size < 3;
    if (size > 3) made += size - 2;
    for (std::uint32_t i = 2; i < size; ++i)
      corners.insert(corners.end(),
                     {mesh.corners[first], mesh.corners[first + i - 1], mesh.corners[first + i]});
    first += size;
  }
  if (polygons)
    note_remark(notes, polygons, counted(polygons, "polygon", "polygons"),
                "became " + counted(made, "triangle", "triangles"));
  note_left_out(notes, small, "face of fewer than three corners",
                "faces of fewer than three corners");
  return corners;
}

}  // namespace

Expected<ReadResult> read_stl(std::string_view file) {
  const std::string_view text = without_padding(file);
  if (is_binary(file, text)) return read_binary(file);
  Expected<ReadResult> result = TextReader(text).read();
  if (result) note_padding(result->notes, file.size() - text.size());
  return result;
}

Expected<Done> write_stl(const Mesh& mesh, Encoding encoding, Output& out, Notes& notes) {
  const Attribute* position = mesh.position();
  if (mesh.vertex_count > 0 &&
      (!position || !is_float(position->scalar) || position->components != 3))
    return fail(ErrorCode::unsupported, "expected positions with 3 floating point components");
  const std::vector<std::uint32_t> corners = triangles_of(mesh, notes);
  const std::size_t triangles = corners.size() / 3;
  if (Expected<Done> few = check_count(triangles); !few) return few;

  Attribute narrow{position_name, Domain::vertex, Scalar::float32, 3, {}};
  std::uint64_t rounded = 0, infinite = 0;
  if (position && position->scalar == Scalar::float64) {
    narrow.data.resize(position->data.size() / 2);
    for (std::size_t i = 0; i < narrow.data.size() / sizeof(float); ++i) {
      double wide;
      std::memcpy(&wide, position->data.data() + i * sizeof wide, sizeof wide);
      const auto value = static_cast<float>(wide);
      const bool same = std::bit_cast<std::uint64_t>(static_cast<double>(value)) ==
                        std::bit_cast<std::uint64_t>(wide);
      if (!same) ++(std::isinf(value) ? infinite : rounded);
      std::memcpy(narrow.data.data() + i * sizeof value, &value, sizeof value);
    }
  } else if (position) {
    narrow.data = position->data;
  }
  const auto lost = [&](std::uint64_t count, const char* one, const char* many) {
    if (count == 0) return;
    const std::string what = counted(count, "coordinate", "coordinates");
    notes.push_back({Note::Kind::loss, count, what, what + (count == 1 ? one : many)});
  };
  lost(rounded, " was rounded to float32", " were rounded to float32");
  lost(infinite, " is too large for float32 and became infinite",
       " are too large for float32 and became infinite");
  const Attribute* bits = find(mesh, stl_bits_name, Domain::face);
  if (bits && (encoding == Encoding::text || bits->scalar != Scalar::uint16 ||
               bits->components != 1 || !mesh.triangles_only()))
    bits = nullptr;
  for (const Attribute& a : mesh.attributes)
    if (&a != position && &a != bits) note_left_out(notes, a);
  std::vector<bool> used(mesh.vertex_count);
  for (const std::uint32_t v : corners) used[v] = true;
  note_left_out(notes, static_cast<std::uint64_t>(std::count(used.begin(), used.end(), false)),
                "vertex of no face", "vertices of no face");

  const auto coordinate = [&](std::size_t corner, unsigned i) {
    float value;
    std::memcpy(&value, narrow.data.data() + (std::size_t{3} * corners[corner] + i) * sizeof value,
                sizeof value);
    return value;
  };
  const auto normal = [&](std::size_t triangle) {
    float p[9];
    for (unsigned i = 0; i < 9; ++i) p[i] = coordinate(3 * triangle + i / 3, i % 3);
    return normal_of(p);
  };
  if (encoding == Encoding::text) {
    note_metadata_left_out(notes, mesh, {});
    note_lost_nans(notes, narrow);
    std::string name = mesh.name;
    std::replace_if(
        name.begin(), name.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
    out << "solid" << (name.empty() ? "" : " ") << name << '\n';
    for (std::size_t f = 0; f < triangles; ++f) {
      const Vector n = normal(f);
      out << "facet normal";
      for (const double x : {n.x, n.y, n.z}) {
        out << ' ';
        out.number(static_cast<float>(x));
      }
      out << "\nouter loop\n";
      for (std::size_t c = 3 * f; c < 3 * f + 3; ++c) {
        out << "vertex";
        for (std::size_t i = 0; i < 3; ++i) {
          out << ' ';
          print(out, narrow, std::size_t{3} * corners[c] + i);
        }
        out << '\n';
      }
      out << "endloop\nendfacet\n";
    }
    out << "endsolid" << (name.empty() ? "" : " ") << name << '\n';
    return Done{};
  }
  if (!mesh.name.empty()) note_left_out(notes, 1, "the name " + quoted(mesh.name), {});
  note_metadata_left_out(notes, mesh, {header_key});
  const std::string* header = metadata(mesh, header_key);
  for (std::size_t i = 0; i < header_size; ++i)
    out << (header && i < header->size() ? (*header)[i] : '\0');
  out.little(static_cast<std::uint32_t>(triangles));
  for (std::size_t f = 0; f < triangles; ++f) {
    const Vector n = normal(f);
    for (const double x : {n.x, n.y, n.z}) add_binary(out, static_cast<float>(x));
    for (std::size_t c = 3 * f; c < 3 * f + 3; ++c)
      for (unsigned i = 0; i < 3; ++i) add_binary(out, coordinate(c, i));
    std::uint16_t both = 0;
    if (bits) std::memcpy(&both, bits->data.data() + f * sizeof both, sizeof both);
    out.little(both);
  }
  return Done{};
}

}  // namespace clers::io
