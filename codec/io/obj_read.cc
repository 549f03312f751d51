// Reads OBJ.
#include <algorithm>
#include <array>
#include <cstring>
#include <set>

#include "codec/io/formats.h"
#include "codec/io/numbers.h"
#include "codec/io/obj_states.h"

namespace clers::io {

namespace {

constexpr std::uint32_t none = 0xffffffffu;

// Statements that are not read, by what they are about.
struct Subject {
  std::string_view one, many;
  std::string_view keywords;  // between spaces
};
constexpr Subject subjects[] = {
    {"merging group", "merging groups", " mg "},
    {"texture map", "texture maps", " usemap maplib "},
    {"line", "lines", " l "},
    {"point", "points", " p "},
    {"statement of free forms", "statements of free forms",
     " vp deg bmat step cstype curv curv2 surf parm trim hole scrv sp end con bsp bzp cdc cdp "
     "res "},
    {"display attribute", "display attributes",
     " bevel lod c_interp d_interp ctech stech shadow_obj trace_obj "},
    {"call", "calls", " call csh "},
};
constexpr std::size_t unknown = std::size(subjects);

std::size_t subject_of(std::string_view keyword) {
  std::size_t i = 0;
  const std::string word = ' ' + std::string(keyword) + ' ';
  while (i < unknown && subjects[i].keywords.find(word) == std::string_view::npos) ++i;
  return i;
}

// The values of one kind (v, vt or vn), and what the corners of the faces use of them.
struct Values {
  std::string_view noun, nouns;
  unsigned stride = 3;  // numbers a value has at most
  Numbers numbers = {};
  std::uint32_t count = 0;
  std::uint64_t largest = 0;             // of the indices used, from 0
  const char* largest_at = nullptr;      // where in the file
  std::vector<std::uint32_t> used = {};  // by each corner, up to the last that uses one
  std::uint64_t indices = 0;             // that faces give
  std::uint64_t zeros = 0;               // of them, which say that there is none
  const char* before_any_at = nullptr;   // counts back from no value
};

class Reader {
 public:
  explicit Reader(std::string_view file)
      : text_(file, {.comments = true, .continuations = true, .kept = &comments_}) {}

  Expected<ReadResult> read() {
    for (; !text_.at_end(); text_.next_line())
      if (Expected<Done> done = statement(); !done) return Failure<Error>{done.error()};
    if (unknown_at_ && positions_.count == 0 && face_sizes_.empty())
      return text_.malformed(unknown_at_, "expected a statement such as 'v' or 'f', found " +
                                              quoted(Text({unknown_at_, text_.at()}).token()));
    // A face may come before its vertices, so that only now the indices can be judged.
    for (const Values& v : values_) {
      if (&v != &positions_ && v.count == 0) continue;  // none are there to be used
      if (v.before_any_at)
        return text_.malformed(v.before_any_at, "expected " + std::string(v.noun) +
                                                    " index from 1, found one that "
                                                    "counts back from the first");
      if (v.largest_at && v.largest >= v.count)
        return text_.malformed(v.largest_at, "expected " + std::string(v.noun) +
                                                 " index of at most " + std::to_string(v.count) +
                                                 ", found " + std::to_string(v.largest + 1) +
                                                 swallowed());
    }
    return finish();
  }

 private:
  Expected<Done> statement() {
    const char* where = text_.at();
    const std::string_view keyword = text_.token();
    if (keyword == "v") return vertex();
    if (keyword == "f" || keyword == "fo") return face();  // fo: of the 1990s
    if (keyword == "vt") return texture_coordinate();
    if (keyword == "vn") return vertex_normal();
    if (const std::size_t state = obj_state_of(keyword); state < obj_states.size()) {
      states_[state].begin(words(), face_sizes_.size());
      return Done{};
    }
    if (keyword == "mtllib") {
      libraries_.append(libraries_.empty() ? "" : "\n").append(words());
      return Done{};
    }
    const std::size_t subject = subject_of(keyword);
    if (subject == unknown) {
      if (std::any_of(keyword.begin(), keyword.end(), [](char c) { return c >= 0 && c < ' '; }))
        return text_.malformed(where,
                               "expected a statement such as 'v' or 'f', found " + quoted(keyword));
      if (!unknown_at_) unknown_at_ = where;
    }
    words();
    ++left_out_[subject];
    if (subject == unknown) unknown_statements_.insert(std::string(keyword));
    return Done{};
  }

  // The rest of a statement, in which '#' begins no comment. A backslash goes on here as it does
  // everywhere; where a name ends in one by chance, what it swallows is noted.
  std::string words() {
    std::string rest(text_.rest_of_line());
    while (rest.ends_with('\\') && text_.remaining() > 0) {
      text_.skip_line_end();
      const std::string_view line = text_.rest_of_line();
      if (swallowed_++ == 0) first_swallowed_ = line;
      rest.back() = ' ';
      rest += line;
    }
    return rest;
  }

  // What may be why something is missing.
  std::string swallowed() const {
    if (swallowed_ == 0) return {};
    return " (but " + quoted(first_swallowed_) +
           " is part of a name, since the line before it ends in a backslash)";
  }

  // Coordinates, then nothing, a weight, or a colour without or with alpha.
  Expected<Done> vertex() {
    if (!count(positions_)) return too_many("vertices");
    for (unsigned i = 0; i < 3; ++i)
      if (!positions_.numbers.read(text_)) return text_.expected("a coordinate");
    if (text_.at_line_end()) return Done{};

    const std::size_t extra = text_.tokens_on_line();
    const bool color = extra == 3 || extra == 4;
    if (color && color_components_ == 0) color_components_ = static_cast<unsigned>(extra);
    const bool keep = color && extra == color_components_;
    if (!keep) ++(color ? odd_colors_ : extra == 1 ? weights_ : odd_numbers_);
    double left_out_number = 0;
    for (std::size_t i = 0; i < extra; ++i)
      if (!(keep ? color_numbers_.read(text_) : text_.number(left_out_number)))
        return text_.expected("a number");
    if (!keep) return Done{};
    colored_.resize(positions_.count - 1, no_value);
    colored_.push_back(colors_++);
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
    do {
      text_.skip_blanks();
      const char* where = text_.at();
      for (std::size_t kind = 0; kind < values_.size(); ++kind) {
        std::int64_t index = 0;
        bool given = (kind == 0 || text_.character('/')) && text_.digits(index);
        if (kind == 0 && !given) return text_.expected("a vertex index");
        if (kind > 0 && given && index == 0) {
          ++values_[kind].zeros;
          given = false;
        }
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
    return Done{};
  }

  // What the corner that is read uses. False if the index cannot be one.
  bool use(Values& values, bool given, std::int64_t index, const char* where) {
    if (!given) return true;
    const std::size_t corner = positions_.used.size() - (&values == &positions_ ? 0 : 1);
    ++values.indices;
    if (index < 0 && values.count == 0) {
      if (!values.before_any_at) values.before_any_at = where;
      index = 1;
    }
    if (index < 0) index += std::int64_t{values.count} + 1;
    if (index <= 0) return false;
    const auto from_0 = static_cast<std::uint64_t>(index - 1);
    if (from_0 >= values.largest) {
      values.largest = from_0;
      values.largest_at = where;
    }
    values.used.resize(corner, no_value);
    values.used.push_back(static_cast<std::uint32_t>(from_0));
    return true;
  }

  ReadResult finish() {
    Mesh mesh;
    mesh.vertex_count = positions_.count;
    mesh.corners = std::move(positions_.used);
    const std::size_t faces = face_sizes_.size();
    set_face_sizes(mesh, std::move(face_sizes_));
    mesh.attributes.push_back(positions_.numbers.take(position_name, Domain::vertex, 3));
    add_colors(mesh);
    add_by_corner(mesh, texcoords_, "texcoord", texcoord_components_);
    add_by_corner(mesh, normals_, "normal", 3);
    add_states(mesh, faces);

    note_left_out(notes_, weights_, "vertex weight", "vertex weights");
    note_left_out(notes_, odd_numbers_, "vertex's further numbers", "vertices' further numbers",
                  "neither a weight nor a colour");
    for (std::size_t i = 0; i < unknown; ++i)
      note_left_out(notes_, left_out_[i], subjects[i].one, subjects[i].many);
    note_left_out(notes_, left_out_[unknown], "statement", "statements",
                  "unknown: " + some(unknown_statements_));
    note_left_out(
        notes_, swallowed_, "line", "lines",
        "part of a name before it, which ends in a backslash, such as " + quoted(first_swallowed_));
    if (comments_.count() > 0) set_metadata(mesh, comment_key, comments_.take());
    ReadResult result;
    result.meshes.push_back(std::move(mesh));
    result.notes = std::move(notes_);
    return result;
  }

  // Bytes, if all of them are 255ths.
  void add_colors(Mesh& mesh) {
    note_left_out(notes_, odd_colors_, "vertex colour", "vertex colours",
                  "with fewer or more components than the first");
    if (color_components_ == 0) return;
    mesh.attributes.push_back(
        of_255ths(color_numbers_.take("color", Domain::vertex, color_components_)));
    if (colors_ == mesh.vertex_count) return;
    colored_.resize(mesh.vertex_count, no_value);
    mesh.attributes.back().indices = std::move(colored_);
  }

  // The values of the corners, as the file shares them.
  void add_by_corner(Mesh& mesh, Values& values, std::string name, unsigned components) {
    note_left_out(notes_, values.zeros, "index 0", "indices 0",
                  "of " + std::string(values.nouns) + ", which count from 1");
    if (values.count == 0)
      return note_left_out(notes_, values.indices, "index", "indices",
                           "of " + std::string(values.nouns) + ", of which there are none");
    if (mesh.corners.empty())
      return note_left_out(notes_, values.count, values.noun.substr(2), values.nouns,
                           "there are no faces to use them");
    const Attribute from = values.numbers.take({}, Domain::corner, values.stride);
    Attribute a{
        std::move(name), Domain::corner, from.scalar, static_cast<std::uint8_t>(components), {}};
    a.data.resize(values.count * a.stride());
    for (std::size_t i = 0; i < values.count; ++i)
      std::memcpy(a.data.data() + i * a.stride(), from.data.data() + i * from.stride(), a.stride());
    values.used.resize(mesh.corners.size(), no_value);
    a.indices = std::move(values.used);
    mesh.attributes.push_back(std::move(a));
  }

  void add_states(Mesh& mesh, std::size_t faces) {
    for (std::size_t i = 0; i < obj_states.size(); ++i) {
      const std::vector<std::string>& names = states_[i].names();
      if (i == obj_object && names.size() == 1 && !names[0].empty())
        mesh.name = names[0];
      else if (!names.empty())
        states_[i].add_to(mesh, obj_states[i], faces);
    }
    if (!libraries_.empty()) set_metadata(mesh, obj_libraries_key, std::move(libraries_));
  }

  Comments comments_;
  Text text_;
  std::array<Values, 3> values_{Values{"a vertex", "vertices"},
                                Values{"a texture coordinate", "texture coordinates"},
                                Values{"a normal", "normals"}};
  Values &positions_ = values_[0], &texcoords_ = values_[1], &normals_ = values_[2];
  unsigned texcoord_components_ = 0;
  std::vector<std::uint32_t> face_sizes_;
  Numbers color_numbers_;
  unsigned color_components_ = 0;
  std::vector<std::uint32_t> colored_;  // the colour of each vertex, up to the last that has one
  std::uint32_t colors_ = 0;
  std::uint64_t odd_colors_ = 0, weights_ = 0, odd_numbers_ = 0;
  std::array<ObjNames, obj_states.size()> states_;
  std::string libraries_;
  std::array<std::uint64_t, unknown + 1> left_out_{};
  std::set<std::string> unknown_statements_;  // by their keywords
  const char* unknown_at_ = nullptr;          // the first
  std::uint64_t swallowed_ = 0;
  std::string_view first_swallowed_;
  Notes notes_;
};

}  // namespace

Expected<ReadResult> read_obj(std::string_view file) {
  return Reader(file).read();
}

}  // namespace clers::io
