// Source: Geomview manual, "OFF Files". Lines matter here: each vertex and each face has its own,
// which is what files look like, and the only way to distinguish colours of three and of four
// numbers.
#include <algorithm>
#include <cmath>
#include <cstring>

#include "codec/io/formats.h"
#include "codec/io/numbers.h"

namespace clers::io {

namespace {

// What the lines of vertices have besides x y z.
struct Kind {
  bool texcoords = false, colors = false, normals = false, unsupported = false;
  bool colors_first = false;  // before the normals
};

// [ST][C][N][4][n]OFF, as Geomview has it: normals come before colours in a line. MeshLab writes
// [N][C][ST]OFF and colours before normals.
std::optional<Kind> kind_of(std::string_view keyword) {
  Kind kind;
  if (!keyword.ends_with("OFF")) return std::nullopt;
  keyword.remove_suffix(3);
  while (!keyword.empty()) {
    const bool st = keyword.starts_with("ST");
    bool& flag = st                  ? kind.texcoords
                 : keyword[0] == 'C' ? kind.colors
                 : keyword[0] == 'N' ? kind.normals
                                     : kind.unsupported;
    if (flag || (&flag == &kind.unsupported && keyword[0] != '4' && keyword[0] != 'n'))
      return std::nullopt;
    flag = true;
    kind.colors_first = kind.colors_first || (&flag == &kind.colors && kind.normals);
    if (keyword == "4n") return kind;
    keyword.remove_prefix(st ? 2 : 1);
  }
  return kind;
}

// Colours of the vertices or of the faces. Whole numbers up to 255 are bytes if all are.
class Colors {
 public:
  bool read(Text& text, std::size_t components) {
    if (components == 0) {
      numbers_of_.push_back(no_value);
      ++none_;
      return true;
    }
    numbers_of_.push_back(three_ + four_ + indexed_);
    ++(components == 3 ? three_ : components == 4 ? four_ : indexed_);
    for (std::size_t i = 0; i < components; ++i) {
      text.skip_blanks();
      Text before = text;
      std::int32_t whole = 0;
      all_whole_ = before.integer(whole) && all_whole_;
      all_bytes_ = all_whole_ && whole >= 0 && whole <= 255 && all_bytes_;
      text.skip_blanks();
      negative_ = negative_ || (text.remaining() > 0 && *text.at() == '-');
      if (!numbers_.read(text)) return false;
    }
    return true;
  }

  // Of one number each they are indices into a map that the file does not hold.
  void add_to(Mesh& mesh, Domain domain, bool declared, Notes& notes) {
    const std::uint32_t colored = three_ + four_ + indexed_;
    if (colored == 0) return;
    const bool of_vertices = domain == Domain::vertex;
    if (std::max({three_, four_, indexed_}) != colored || (indexed_ > 0 && !all_whole_)) {
      note_left_out(notes, colored, of_vertices ? "vertex colour" : "face colour",
                    of_vertices ? "vertex colours" : "face colours",
                    "they have different numbers of components");
      return;
    }
    // Numbers that the first line does not speak of, some below 0: no colours then.
    const bool normals =
        !declared && negative_ && three_ && of_vertices && !find(mesh, "normal", domain);
    Attribute a = numbers_.take(indexed_  ? color_index
                                : normals ? "normal"
                                          : "color",
                                domain,
                                indexed_ ? 1u
                                : three_ ? 3u
                                         : 4u);
    if (indexed_)
      a = whole<std::int32_t>(a, Scalar::int32);
    else if (all_bytes_)
      a = whole<std::uint8_t>(a, Scalar::uint8);
    if (none_ > 0) a.indices = std::move(numbers_of_);
    mesh.attributes.push_back(std::move(a));
  }

  static constexpr const char* color_index = "color_index";

 private:
  // Whole numbers up to 2^24 are float32, others up to 2^31 float64.
  template <class T>
  static Attribute whole(const Attribute& from, Scalar scalar) {
    Attribute to{from.name, from.domain, scalar, from.components, {}};
    const std::size_t size = size_of(from.scalar), count = from.data.size() / size;
    to.data.resize(count * sizeof(T));
    for (std::size_t i = 0; i < count; ++i) {
      float narrow = 0;
      double wide = 0;
      if (from.scalar == Scalar::float32)
        std::memcpy(&narrow, from.data.data() + i * size, size);
      else
        std::memcpy(&wide, from.data.data() + i * size, size);
      const auto value = static_cast<T>(from.scalar == Scalar::float32 ? narrow : wide);
      std::memcpy(to.data.data() + i * sizeof value, &value, sizeof value);
    }
    return to;
  }

  Numbers numbers_;
  bool all_bytes_ = true, all_whole_ = true, negative_ = false;
  std::vector<std::uint32_t> numbers_of_;  // which colour each has, or none
  std::uint32_t none_ = 0, three_ = 0, four_ = 0, indexed_ = 0;
};

class Reader {
 public:
  explicit Reader(std::string_view file) : text_(file, {.comments = true, .kept = &comments_}) {}

  Expected<ReadResult> read() {
    if (Expected<Done> done = header(); !done) return Failure<Error>{done.error()};
    for (std::uint32_t v = 0; v < mesh_.vertex_count; ++v)
      if (Expected<Done> done = vertex(); !done) return Failure<Error>{done.error()};
    for (std::uint64_t f = 0; f < face_count_; ++f)
      if (Expected<Done> done = face(); !done) return Failure<Error>{done.error()};
    if (!text_.at_end()) return text_.expected("the end of the file after the last face");

    ReadResult result;
    mesh_.attributes.push_back(positions_.take(position_name, Domain::vertex, 3));
    if (kind_.normals) mesh_.attributes.push_back(normals_.take("normal", Domain::vertex, 3));
    vertex_colors_.add_to(mesh_, Domain::vertex, kind_.colors, result.notes);
    if (kind_.texcoords) mesh_.attributes.push_back(texcoords_.take("texcoord", Domain::vertex, 2));
    face_colors_.add_to(mesh_, Domain::face, true, result.notes);
    set_face_sizes(mesh_, std::move(face_sizes_));
    if (comments_.count() > 0) set_metadata(mesh_, comment_key, comments_.take());
    result.meshes.push_back(std::move(mesh_));
    return result;
  }

 private:
  Expected<Done> header() {
    text_.skip_space();
    const char* where = text_.at();
    const Text start = text_;
    std::string_view keyword = text_.token();
    // The word may be missing, and there are files in which the counts follow it without a blank.
    const auto digits = [](std::string_view text) {
      return !text.empty() && text.find_first_not_of("0123456789") == text.npos;
    };
    const std::size_t end = keyword.rfind("OFF") + 3;  // npos + 3 = 2
    const bool missing = digits(keyword), glued = end > 2 && digits(keyword.substr(end));
    if (missing || glued) {
      text_ = start;
      text_.skip(missing ? 0 : end);
      keyword = missing ? "OFF" : keyword.substr(0, end);
    }
    const std::optional<Kind> kind = kind_of(keyword);
    if (!kind)
      return text_.malformed(where,
                             "expected OFF, COFF, NOFF, STOFF or such, found " + quoted(keyword));
    kind_ = *kind;
    says_all_ = keyword != "OFF";
    const bool binary = Text(text_).token() == "BINARY";
    if (kind_.unsupported || binary)
      return fail(ErrorCode::unsupported, Place::line, text_.line_of(where),
                  "expected text of points in 3 dimensions, found " +
                      quoted(std::string(keyword) + (binary ? " BINARY" : "")));
    text_.skip_space();
    where = text_.at();
    std::uint64_t vertices = 0, edges = 0;
    if (!text_.integer(vertices)) return text_.expected("the number of vertices");
    if (!text_.integer(face_count_)) return text_.expected("the number of faces");
    if (!text_.at_line_end() && !text_.integer(edges)) return text_.expected("the number of edges");
    if (Expected<Done> done = end_line(); !done) return done;
    // "0 0 0" for a vertex, "0" for a face, and a line end for all but the last.
    const std::uint64_t left = text_.remaining() + 1;
    if (vertices > left / 6 || face_count_ > (left - 6 * vertices) / 2)
      return text_.malformed(where, "expected " + counted(vertices, "vertex", "vertices") +
                                        " and " + counted(face_count_, "face", "faces") +
                                        ", which " + counted(text_.remaining(), "byte", "bytes") +
                                        " cannot hold");
    if (vertices >= 0xffffffffu)
      return fail(ErrorCode::too_large, Place::line, text_.line_of(where),
                  "expected fewer than 4294967295 vertices");
    mesh_.vertex_count = static_cast<std::uint32_t>(vertices);
    return Done{};
  }

  // A line.
  Expected<Done> vertex() {
    text_.skip_space();
    if (!read(positions_, 3)) return text_.expected("a coordinate");
    if (kind_.normals && !kind_.colors_first && !read(normals_, 3))
      return text_.expected("a component of a normal");
    if (kind_.colors) {
      const std::size_t left = text_.tokens_on_line(),
                        others = (kind_.texcoords ? 2u : 0u) + (kind_.colors_first ? 3u : 0u);
      if (left != 3 + others && left != 4 + others)
        return text_.expected("a colour of 3 or 4 numbers" +
                              std::string(others ? " and what follows it" : ""));
      if (!vertex_colors_.read(text_, left - others)) return text_.expected("a number of a colour");
    }
    if (kind_.normals && kind_.colors_first && !read(normals_, 3))
      return text_.expected("a component of a normal");
    if (kind_.texcoords && !read(texcoords_, 2)) return text_.expected("a texture coordinate");
    return says_all_ ? end_line() : further_numbers();
  }

  // Many programs write colours without saying so in the first line.
  Expected<Done> further_numbers() {
    const std::size_t left = text_.at_line_end() ? 0 : text_.tokens_on_line();
    if (left == 0 || left == 3 || left == 4) {
      if (!vertex_colors_.read(text_, left)) return text_.expected("a number of a colour");
      return Done{};
    }
    return text_.expected("the end of the line, or a colour of 3 or 4 numbers");
  }

  bool read(Numbers& numbers, unsigned n) {
    for (; n > 0; --n)
      if (!numbers.read(text_)) return false;
    return true;
  }

  Expected<Done> face() {
    text_.skip_space();
    std::uint32_t size = 0;
    if (!text_.integer(size)) return text_.expected("the number of corners of a face");
    for (std::uint32_t i = 0; i < size; ++i) {
      std::uint32_t index = 0;
      text_.skip_space();
      const Text before = text_;
      if (!text_.integer(index) || index >= mesh_.vertex_count) {
        text_ = before;
        return text_.expected("a vertex index below " + std::to_string(mesh_.vertex_count));
      }
      mesh_.corners.push_back(index);
    }
    face_sizes_.push_back(size);
    const std::size_t numbers = text_.at_line_end() ? 0 : text_.tokens_on_line();
    if (numbers == 2 || numbers > 4)
      return text_.expected("a colour of 1, 3 or 4 numbers or the end of the line");
    if (!face_colors_.read(text_, numbers)) return text_.expected("a number of a colour");
    return Done{};
  }

  Expected<Done> end_line() {
    if (!text_.at_line_end()) return text_.expected("the end of the line");
    return Done{};
  }

  Comments comments_;
  Text text_;
  Kind kind_;
  bool says_all_ = false;  // whether the first line says all that the lines of vertices have
  std::uint64_t face_count_ = 0;
  Mesh mesh_;
  std::vector<std::uint32_t> face_sizes_;
  Numbers positions_, normals_, texcoords_;
  Colors vertex_colors_, face_colors_;
};

const Attribute* color_of(const Mesh& mesh, Domain domain) {
  const Attribute* a = find(mesh, "color", domain);
  return a && (a->components == 3 || a->components == 4) &&
                 (is_float(a->scalar) || a->scalar == Scalar::uint8)
             ? a
             : nullptr;
}

// Of faces, into a map of colours.
const Attribute* index_of(const Mesh& mesh) {
  const Attribute* a = find(mesh, Colors::color_index, Domain::face);
  return a && a->components == 1 && a->scalar == Scalar::int32 ? a : nullptr;
}

const Attribute* floats_of(const Mesh& mesh, std::string_view name, unsigned components) {
  const Attribute* a = find(mesh, name, Domain::vertex);
  return a && a->components == components && is_float(a->scalar) ? a : nullptr;
}

// Whether print() leaves it without a point or an exponent, like a colour that is a byte.
bool looks_like_a_byte(const Attribute& a, std::size_t index) {
  double value = 0;
  if (a.scalar == Scalar::float32) {
    float narrow = 0;
    std::memcpy(&narrow, a.data.data() + index * sizeof narrow, sizeof narrow);
    value = static_cast<double>(narrow);
  } else if (a.scalar == Scalar::float64) {
    std::memcpy(&value, a.data.data() + index * sizeof value, sizeof value);
  } else {
    return false;
  }
  return value >= 0 && value <= 255 && value == std::floor(value) && !std::signbit(value);
}

void print_values(Output& out, const Attribute& a, std::size_t element) {
  for (std::size_t i = element * a.components; i < (element + 1) * a.components; ++i) {
    if (i > element * a.components) out << ' ';
    print_untyped(out, a, i);
    if (a.name == "color" && looks_like_a_byte(a, i)) out << ".0";
  }
}

}  // namespace

Expected<ReadResult> read_off(std::string_view file) {
  return Reader(file).read();
}

Expected<Done> write_off(const Mesh& mesh, Output& out, Notes& notes) {
  const Attribute* position = mesh.position();
  if (mesh.vertex_count > 0 && (!position || position->components != 3))
    return fail(ErrorCode::unsupported, "expected positions with 3 components");
  const Attribute* normal = floats_of(mesh, "normal", 3);
  const Attribute* color = color_of(mesh, Domain::vertex);
  const Attribute* texcoord = floats_of(mesh, "texcoord", 2);
  const Attribute* face_color = color_of(mesh, Domain::face);
  if (!face_color) face_color = index_of(mesh);
  for (const Attribute& a : mesh.attributes) {
    const Attribute* kept[] = {position, normal, color, texcoord, face_color};
    if (std::find(std::begin(kept), std::end(kept), &a) == std::end(kept)) {
      note_left_out(notes, a);
      continue;
    }
    note_lost_nans(notes, a);
    if (&a == position && !is_float(a.scalar))
      note_remark(notes, 1, label(a), "reads back as floating point");
  }
  if (!mesh.name.empty()) note_left_out(notes, 1, "the name " + quoted(mesh.name), {});
  note_metadata_left_out(notes, mesh, {comment_key});

  // Where the first line says nothing of colours, some vertices may have none.
  const bool some = color && !color->indices.empty();
  const bool says_color = color && (!some || normal || texcoord);
  for (const Attribute* a : {normal, texcoord, says_color ? color : nullptr})
    if (a) note_zeros(notes, *a, missing(*a));
  out << (texcoord ? "ST" : "") << (says_color ? "C" : "") << (normal ? "N" : "") << "OFF\n";
  write_comments(out, mesh);
  out.number(mesh.vertex_count);
  out << ' ';
  out.number(mesh.face_count());
  out << " 0\n";
  for (std::size_t v = 0; v < mesh.vertex_count; ++v) {
    print_values(out, *position, v);
    for (const Attribute* a : {normal, color, texcoord}) {
      if (!a || (a == color && !says_color && a->indices[v] == no_value)) continue;
      out << ' ';
      print_values(out, *a, v);
    }
    out << '\n';
  }
  std::size_t corner = 0;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const std::uint32_t size = face_size(mesh, f);
    out.number(size);
    for (const std::size_t end = corner + size; corner < end; ++corner) {
      out << ' ';
      out.number(mesh.corners[corner]);
    }
    if (face_color && (face_color->indices.empty() || face_color->indices[f] != no_value)) {
      out << ' ';
      print_values(out, *face_color, f);
    }
    out << '\n';
  }
  return Done{};
}

}  // namespace clers::io
