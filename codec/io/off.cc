// Source: Geomview manual, "OFF Files". Lines matter here: each vertex and each face has its own,
// which is what files look like, and the only way to tell colours of three and of four numbers
// apart.
#include <algorithm>
#include <cmath>
#include <cstring>

#include "codec/io/formats.h"
#include "codec/io/numbers.h"

namespace clers::io {

namespace {

// [ST][C][N][4][n]OFF: what the lines of vertices have besides x y z.
struct Kind {
  bool texcoords = false, colors = false, normals = false, unsupported = false;
};

std::optional<Kind> kind_of(std::string_view keyword) {
  Kind kind;
  const auto skip = [&](std::string_view prefix) {
    const bool found = keyword.starts_with(prefix);
    if (found) keyword.remove_prefix(prefix.size());
    return found;
  };
  kind.texcoords = skip("ST");
  kind.colors = skip("C");
  kind.normals = skip("N");
  const bool homogeneous = skip("4"), any_dimension = skip("n");
  kind.unsupported = homogeneous || any_dimension;
  return keyword == "OFF" ? std::optional(kind) : std::nullopt;
}

// Colours of the vertices or of the faces. Whole numbers up to 255 are bytes if all are.
class Colors {
 public:
  bool read(Text& text, std::size_t components) {
    if (components == 0) {
      ++none_;
      return true;
    }
    ++(components == 3 ? three_ : components == 4 ? four_ : indexed_);
    for (std::size_t i = 0; i < components; ++i) {
      text.skip_blanks();
      Text before = text;
      std::uint8_t byte = 0;
      all_bytes_ = before.integer(byte) && all_bytes_;
      if (!numbers_.read(text)) return false;
    }
    return true;
  }

  void add_to(Mesh& mesh, Domain domain, Notes& notes) {
    const std::uint64_t colored = three_ + four_ + indexed_;
    if (colored == 0) return;
    if (none_ > 0 || std::max(three_, four_) != colored) {
      note_line(notes, counted(colored, "colour was", "colours were") +
                           " left out: not all faces or vertices have one with as many components");
      return;
    }
    Attribute a = numbers_.take("color", domain, three_ ? 3 : 4);
    if (all_bytes_) {
      // Whole numbers up to 255 are float32.
      std::vector<std::byte> bytes(a.data.size() / sizeof(float));
      for (std::size_t i = 0; i < bytes.size(); ++i) {
        float value;
        std::memcpy(&value, a.data.data() + i * sizeof value, sizeof value);
        bytes[i] = static_cast<std::byte>(value);
      }
      a.scalar = Scalar::uint8;
      a.data = std::move(bytes);
    }
    mesh.attributes.push_back(std::move(a));
  }

 private:
  Numbers numbers_;
  bool all_bytes_ = true;
  std::uint64_t none_ = 0, three_ = 0, four_ = 0, indexed_ = 0;
};

class Reader {
 public:
  explicit Reader(std::string_view file) : text_(file, {.comments = true}) {}

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
    vertex_colors_.add_to(mesh_, Domain::vertex, result.notes);
    if (kind_.texcoords) mesh_.attributes.push_back(texcoords_.take("texcoord", Domain::vertex, 2));
    face_colors_.add_to(mesh_, Domain::face, result.notes);
    set_face_sizes(mesh_, std::move(face_sizes_));
    result.meshes.push_back(std::move(mesh_));
    return result;
  }

 private:
  Expected<Done> header() {
    text_.skip_space();
    const char* where = text_.at();
    const std::string_view keyword = text_.token();
    const std::optional<Kind> kind = kind_of(keyword);
    if (!kind)
      return text_.malformed(where,
                             "expected OFF, COFF, NOFF, STOFF or such, found " + quoted(keyword));
    kind_ = *kind;
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

  Expected<Done> vertex() {
    text_.skip_space();
    if (!read(positions_, 3)) return text_.expected("a coordinate");
    if (kind_.normals && !read(normals_, 3)) return text_.expected("a component of a normal");
    if (kind_.colors) {
      const std::size_t left = text_.tokens_on_line(), others = kind_.texcoords ? 2 : 0;
      if (left != 3 + others && left != 4 + others)
        return text_.expected("a colour of 3 or 4 numbers");
      if (!vertex_colors_.read(text_, left - others)) return text_.expected("a number of a colour");
    }
    if (kind_.texcoords && !read(texcoords_, 2)) return text_.expected("a texture coordinate");
    return end_line();
  }

  bool read(Numbers& numbers, unsigned n) {
    for (; n > 0; --n) {
      text_.skip_space();
      if (!numbers.read(text_)) return false;
    }
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

  Text text_;
  Kind kind_;
  std::uint64_t face_count_ = 0;
  Mesh mesh_;
  std::vector<std::uint32_t> face_sizes_;
  Numbers positions_, normals_, texcoords_;
  Colors vertex_colors_, face_colors_;
};

bool is_float(const Attribute& a) {
  return a.scalar == Scalar::float32 || a.scalar == Scalar::float64;
}

const Attribute* color_of(const Mesh& mesh, Domain domain) {
  const Attribute* a = find(mesh, "color", domain);
  return a && (a->components == 3 || a->components == 4) &&
                 (is_float(*a) || a->scalar == Scalar::uint8)
             ? a
             : nullptr;
}

const Attribute* floats_of(const Mesh& mesh, std::string_view name, unsigned components) {
  const Attribute* a = find(mesh, name, Domain::vertex);
  return a && a->components == components && is_float(*a) ? a : nullptr;
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
  for (const Attribute& a : mesh.attributes) {
    const Attribute* kept[] = {position, normal, color, texcoord, face_color};
    if (std::find(std::begin(kept), std::end(kept), &a) == std::end(kept)) {
      note_left_out(notes, a);
      continue;
    }
    note_lost_nans(notes, a);
    if (&a == position && !is_float(a))
      note_line(notes, label(a) + " reads back as floating point");
  }
  if (!mesh.name.empty()) note_line(notes, "the name " + quoted(mesh.name) + " was left out");

  out << (texcoord ? "ST" : "") << (color ? "C" : "") << (normal ? "N" : "") << "OFF\n";
  out.number(mesh.vertex_count);
  out << ' ';
  out.number(mesh.face_count());
  out << " 0\n";
  for (std::size_t v = 0; v < mesh.vertex_count; ++v) {
    print_values(out, *position, v);
    for (const Attribute* a : {normal, color, texcoord}) {
      if (!a) continue;
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
    if (face_color) {
      out << ' ';
      print_values(out, *face_color, f);
    }
    out << '\n';
  }
  return Done{};
}

}  // namespace clers::io
