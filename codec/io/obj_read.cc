#include <algorithm>
#include <array>
#include <cstring>

#include "codec/io/formats.h"
#include "codec/io/numbers.h"

namespace clers::io {

namespace {

constexpr std::uint32_t none = 0xffffffffu;

// Statements that are not read; how many there are goes to the notes.
constexpr std::string_view left_out[] = {
    "o",      "g",        "s",        "mg",         "usemtl", "mtllib",   "usemap",
    "maplib", "l",        "p",        "fo",         "vp",     "deg",      "bmat",
    "step",   "cstype",   "curv",     "curv2",      "surf",   "parm",     "trim",
    "hole",   "scrv",     "sp",       "end",        "con",    "bevel",    "lod",
    "call",   "csh",      "ctech",    "res",        "bsp",    "bzp",      "cdc",
    "cdp",    "c_interp", "d_interp", "shadow_obj", "stech",  "trace_obj"};

// The values of one kind (v, vt or vn), and what the corners of the faces use of them.
struct Values {
  std::string_view noun, nouns;
  unsigned stride = 3;  // numbers a value has at most
  Numbers numbers = {};
  std::uint32_t count = 0;
  std::uint64_t largest = 0;             // of the indices used, from 0
  const char* largest_at = nullptr;      // where in the file
  std::vector<std::uint32_t> used = {};  // by each corner, while all faces use some
  std::uint64_t faces_without = 0;
};

class Reader {
 public:
  explicit Reader(std::string_view file) : text_(file, {.comments = true, .continuations = true}) {}

  Expected<ReadResult> read() {
    for (; !text_.at_end(); text_.next_line())
      if (Expected<Done> done = statement(); !done) return Failure<Error>{done.error()};
    // A face may come before its vertices, so that only now the indices can be judged.
    for (const Values& v : values_)
      if (v.largest_at && v.largest >= v.count)
        return text_.malformed(v.largest_at, "expected " + std::string(v.noun) +
                                                 " index of at most " + std::to_string(v.count) +
                                                 ", found " + std::to_string(v.largest + 1));
    return finish();
  }

 private:
  Expected<Done> statement() {
    const char* where = text_.at();
    const std::string_view keyword = text_.token();
    if (keyword == "v") return vertex();
    if (keyword == "f") return face();
    if (keyword == "vt") return texture_coordinate();
    if (keyword == "vn") return vertex_normal();
    const auto* found = std::find(std::begin(left_out), std::end(left_out), keyword);
    if (found == std::end(left_out))
      return text_.malformed(where,
                             "expected a statement such as 'v' or 'f', found " + quoted(keyword));
    ++left_out_[static_cast<std::size_t>(found - left_out)];
    if (keyword == "o") name_ = text_.rest_of_line();
    return Done{};
  }

  // Coordinates, then nothing, a weight, or a colour without or with alpha.
  Expected<Done> vertex() {
    if (!count(positions_)) return too_many("vertices");
    for (unsigned i = 0; i < 3; ++i)
      if (!positions_.numbers.read(text_)) return text_.expected("a coordinate");
    if (text_.at_line_end()) return Done{};

    const std::size_t extra = text_.tokens_on_line();
    if (extra != 1 && extra != 3 && extra != 4)
      return text_.malformed(text_.at(),
                             "expected 3, 4, 6 or 7 numbers, found " + std::to_string(3 + extra));
    weights_ += extra == 1;
    colors_ += extra != 1;
    if (color_components_ == 0 && positions_.count == 1 && extra != 1)
      color_components_ = static_cast<unsigned>(extra);
    const bool keep = extra == color_components_ &&
                      color_numbers_.size() == extra * (std::size_t{positions_.count} - 1);
    double left_out_number = 0;
    for (std::size_t i = 0; i < extra; ++i)
      if (!(keep ? color_numbers_.read(text_) : text_.number(left_out_number)))
        return text_.expected("a number");
    return Done{};
  }

  // One to three numbers; those that are missing are 0.
  Expected<Done> texture_coordinate() {
    if (!count(texcoords_)) return too_many("texture coordinates");
    unsigned n = 0;
    for (; n < 3 && (n == 0 || !text_.at_line_end()); ++n)
      if (!texcoords_.numbers.read(text_)) return text_.expected("a texture coordinate");
    texcoord_components_ = std::max(texcoord_components_, n);
    for (; n < 3; ++n) texcoords_.numbers.push_zero();
    return end_line();
  }

  Expected<Done> vertex_normal() {
    if (!count(normals_)) return too_many("normals");
    for (unsigned i = 0; i < 3; ++i)
      if (!normals_.numbers.read(text_)) return text_.expected("a component of a normal");
    return end_line();
  }

  Expected<Done> end_line() {
    if (!text_.at_line_end()) return text_.expected("the end of the line");
    return Done{};
  }

  static bool count(Values& values) { return ++values.count < none; }
  Failure<Error> too_many(std::string what) {
    return fail(ErrorCode::too_large, Place::line, text_.line_of(text_.at()),
                "expected fewer than 4294967295 " + what);
  }

  Expected<Done> face() {
    std::uint32_t size = 0;
    std::array<bool, 3> all_have{true, true, true};
    do {
      text_.skip_blanks();
      const char* where = text_.at();
      for (std::size_t kind = 0; kind < values_.size(); ++kind) {
        std::int64_t index = 0;
        const bool given = (kind == 0 || text_.character('/')) && text_.digits(index);
        if (kind == 0 && !given) return text_.expected("a vertex index");
        all_have[kind] = all_have[kind] && given;
        if (!use(values_[kind], given, index, where))
          return text_.malformed(where, "expected " + std::string(values_[kind].noun) +
                                            " index from 1, or from -1 down to -" +
                                            std::to_string(values_[kind].count) + ", found " +
                                            std::to_string(index));
      }
      if (!text_.at_token_end())
        return text_.malformed(where, "expected a corner such as 1, 1/2, 1//3 or 1/2/3");
      ++size;
    } while (!text_.at_line_end());
    face_sizes_.push_back(size);
    for (std::size_t kind = 1; kind < values_.size(); ++kind) {
      if (all_have[kind]) continue;
      ++values_[kind].faces_without;
      values_[kind].used = {};
    }
    return Done{};
  }

  // False if the index cannot be one.
  static bool use(Values& values, bool given, std::int64_t index, const char* where) {
    if (!given) return true;
    if (index < 0) index += std::int64_t{values.count} + 1;
    if (index <= 0) return false;
    const auto from_0 = static_cast<std::uint64_t>(index - 1);
    if (from_0 >= values.largest) {
      values.largest = from_0;
      values.largest_at = where;
    }
    if (values.faces_without == 0) values.used.push_back(static_cast<std::uint32_t>(from_0));
    return true;
  }

  ReadResult finish() {
    Mesh mesh;
    mesh.vertex_count = positions_.count;
    mesh.corners = std::move(positions_.used);
    const std::size_t faces = face_sizes_.size();
    set_face_sizes(mesh, std::move(face_sizes_));
    mesh.attributes.push_back(positions_.numbers.take(position_name, Domain::vertex, 3));
    if (color_components_ > 0 &&
        color_numbers_.size() == std::size_t{color_components_} * mesh.vertex_count)
      mesh.attributes.push_back(color_numbers_.take("color", Domain::vertex, color_components_));
    else if (colors_)
      note(counted(colors_, "vertex colour was", "vertex colours were") +
           " left out: not every vertex has one with as many components");
    add_by_corner(mesh, texcoords_, "texcoord", texcoord_components_, faces);
    add_by_corner(mesh, normals_, "normal", 3, faces);

    if (weights_) note(counted(weights_, "vertex weight was", "vertex weights were") + " left out");
    for (std::size_t i = 0; i < left_out_.size(); ++i) {
      if (left_out_[i] == 0) continue;
      if (left_out[i] == "o" && left_out_[i] == 1)
        mesh.name = std::move(name_);
      else
        note(counted(left_out_[i], "statement ", "statements ") + quoted(left_out[i]) +
             (left_out_[i] == 1 ? " was" : " were") + " left out");
    }
    ReadResult result;
    result.meshes.push_back(std::move(mesh));
    result.notes = std::move(notes_);
    return result;
  }

  // Gives every corner the value it uses, if all faces use some.
  void add_by_corner(Mesh& mesh, Values& values, std::string name, unsigned components,
                     std::size_t faces) {
    if (values.count == 0) return;
    if (faces == 0 || values.faces_without > 0) {
      note(counted(values.count, values.noun.substr(2), values.nouns) +
           (values.count == 1 ? " was" : " were") +
           " left out: " + std::to_string(values.faces_without) + " of " +
           counted(faces, "face has", "faces have") + " none");
      return;
    }
    const Attribute from = values.numbers.take({}, Domain::corner, values.stride);
    Attribute a{
        std::move(name), Domain::corner, from.scalar, static_cast<std::uint8_t>(components), {}};
    a.data.resize(values.used.size() * a.stride());
    std::vector<bool> used(values.count);
    for (std::size_t c = 0; c < values.used.size(); ++c) {
      std::memcpy(a.data.data() + c * a.stride(), from.data.data() + values.used[c] * from.stride(),
                  a.stride());
      used[values.used[c]] = true;
    }
    mesh.attributes.push_back(std::move(a));
    if (const auto unused = static_cast<std::uint64_t>(std::count(used.begin(), used.end(), false)))
      note(counted(unused, values.noun.substr(2), values.nouns) + (unused == 1 ? " is" : " are") +
           " used by no face and left out");
  }

  void note(std::string line) { note_line(notes_, std::move(line)); }

  Text text_;
  std::array<Values, 3> values_{Values{"a vertex", "vertices"},
                                Values{"a texture coordinate", "texture coordinates"},
                                Values{"a normal", "normals"}};
  Values &positions_ = values_[0], &texcoords_ = values_[1], &normals_ = values_[2];
  unsigned texcoord_components_ = 0;
  std::vector<std::uint32_t> face_sizes_;
  Numbers color_numbers_;
  unsigned color_components_ = 0;
  std::uint64_t colors_ = 0, weights_ = 0;
  std::array<std::uint64_t, std::size(left_out)> left_out_{};
  std::string name_;
  Notes notes_;
};

}  // namespace

Expected<ReadResult> read_obj(std::string_view file) {
  // Some programs write the zero that ends a string in C.
  const std::string_view text = file.substr(0, file.find_last_not_of('\0') + 1);
  Expected<ReadResult> result = Reader(text).read();
  if (const std::size_t zeros = file.size() - text.size(); zeros > 0 && result)
    note_line(result->notes, counted(zeros, "zero byte", "zero bytes") +
                                 " at the end of the file " + (zeros == 1 ? "was" : "were") +
                                 " left out");
  return result;
}

}  // namespace clers::io
