// The header of a PLY file: its elements and their properties.
#include <algorithm>
#include <set>
#include <utility>

#include "codec/io/ply.h"
#include "codec/io/text.h"

namespace clers::io::ply {

namespace {

std::optional<Scalar> scalar_of(std::string_view type) {
  constexpr struct {
    std::string_view name, other_name;
    Scalar scalar;
  } types[] = {
      {"char", "int8", Scalar::int8},        {"uchar", "uint8", Scalar::uint8},
      {"short", "int16", Scalar::int16},     {"ushort", "uint16", Scalar::uint16},
      {"int", "int32", Scalar::int32},       {"uint", "uint32", Scalar::uint32},
      {"float", "float32", Scalar::float32}, {"double", "float64", Scalar::float64},
  };
  for (const auto& t : types)
    if (type == t.name || type == t.other_name) return t.scalar;
  return std::nullopt;
}

// Reads the header line by line into `header`.
class HeaderReader {
 public:
  explicit HeaderReader(std::string_view file) : file_(file), text_(file) {}

  Expected<Header> read() {
    if (text_.token() != "ply" || !text_.at_line_end())
      return text_.malformed(file_.data(), "expected the line 'ply'");
    const std::string_view rest = file_.substr(text_.offset());
    // Where lines end in CR alone, an LF behind the last one is the first byte of the body.
    const bool bare_cr = rest.starts_with('\r') && !rest.starts_with("\r\n");
    const bool lf_cr = rest.starts_with("\n\r") && !rest.starts_with("\n\r\n");
    text_.next_line();
    for (;;) {
      line_ = text_.at();
      Expected<bool> more = line();
      if (!more) return Failure<Error>{more.error()};
      if (!text_.at_line_end()) return text_.expected("the end of the line");
      if (!*more && bare_cr && text_.remaining() > 0)
        text_.skip(1);
      else
        text_.next_line();
      if (!*more && lf_cr && file_.substr(text_.offset()).starts_with('\r')) text_.skip(1);
      if (!*more) break;
    }
    header_.size = text_.offset();
    return std::move(header_);
  }

 private:
  // False after the last.
  Expected<bool> line() {
    constexpr std::string_view keywords =
        "'element', 'property', 'comment', 'obj_info' or 'end_header'";
    if (text_.at_end()) return text_.expected(keywords);
    line_ = text_.at();
    const std::string_view keyword = text_.token();
    if (keyword == "comment") return comment();
    if (keyword == "obj_info") {
      header_.obj_infos.add(text_.raw_rest_of_line());
      return true;
    }
    if (keyword == "format") return format();
    if (!has_format_) return malformed("expected the line 'format ...' before all but comments");
    if (keyword == "element") return element();
    if (keyword == "property") return property();
    if (keyword == "end_header") return end();
    return malformed("expected " + std::string(keywords) + ", found " + quoted(keyword));
  }

  Expected<bool> format() {
    if (has_format_) return malformed("a second line 'format'");
    has_format_ = true;
    const std::string_view name = text_.token();
    if (name == "ascii") {
      header_.format = Format::text;
    } else if (name == "binary_little_endian") {
      header_.format = Format::little_endian;
    } else if (name == "binary_big_endian") {
      header_.format = Format::big_endian;
    } else {
      return malformed("expected format ascii, binary_little_endian or binary_big_endian, found " +
                       quoted(name));
    }
    if (const std::string_view version = text_.token(); version != "1.0")
      return malformed("expected version 1.0, found " + quoted(version));
    return true;
  }

  // A claim that does not fit its place is a comment like any other.
  Expected<bool> comment() {
    const std::string_view raw = text_.raw_rest_of_line();
    const std::string_view text = Text(raw).rest_of_line();
    const auto after = [&](std::string_view start) {
      return text.starts_with(start) && text.substr(start.size()).starts_with(' ')
                 ? std::optional(text.substr(start.size()))
                 : std::nullopt;
    };
    if (const auto rest = after(attribute_comment); rest && !header_.elements.empty()) {
      Text words(*rest);
      std::uint8_t components = 0;
      if (words.integer(components) && components > 0) {
        if (auto name = percent_decoded(words.token()); name && words.at_line_end()) {
          Element& e = header_.elements.back();
          e.claims.push_back({e.properties.size(), components, std::move(*name)});
          return true;
        }
      }
    }
    if (const auto rest = after(mesh_comment)) {
      Text words(*rest);
      if (auto name = percent_decoded(words.token()); name && words.at_line_end()) {
        header_.mesh_name = std::move(*name);
        return true;
      }
    }
    header_.comments.add(raw);
    return true;
  }

  Expected<bool> element() {
    if (Expected<Done> done = end_element(); !done) return Failure<Error>{done.error()};
    Element e;
    e.name = text_.token();
    if (e.name.empty()) return text_.expected("the name of the element");
    if (!text_.integer(e.count)) return text_.expected("the number of entries");
    if (!elements_.insert(e.name).second) return malformed("a second element " + quoted(e.name));
    if (e.name == "vertex" && e.count >= Header::vertex_limit)
      return fail(ErrorCode::too_large, Place::line, text_.line_of(line_),
                  "expected fewer than 4294967295 vertices");
    header_.elements.push_back(std::move(e));
    element_line_ = line_;
    properties_.clear();
    return true;
  }

  Expected<bool> property() {
    if (header_.elements.empty()) return malformed("expected an element before its properties");
    Element& e = header_.elements.back();
    Property p;
    std::string_view type = text_.token();
    if (type == "list") {
      const std::string_view count_type = text_.token();
      p.count_type = scalar_of(count_type);
      if (!p.count_type || is_float(*p.count_type))
        return malformed("expected an integer type for the lengths of lists, found " +
                         quoted(count_type));
      type = text_.token();
    }
    const std::optional<Scalar> scalar = scalar_of(type);
    if (!scalar) return malformed("expected a type such as 'float', found " + quoted(type));
    p.type = *scalar;
    p.name = text_.token();
    if (p.name.empty()) return text_.expected("the name of the property");
    if (!properties_.insert(p.name).second) return malformed("a second property " + quoted(p.name));

    if (holds_faces(e) && names_indices(p.name) && !has_indices(e)) {
      if (!p.count_type || is_float(p.type))
        return malformed("expected " + quoted(p.name) + " to be a list of integers");
      p.meaning = e.name == "tristrips" ? Meaning::strip_index : Meaning::index;
    }
    e.properties.push_back(std::move(p));
    return true;
  }

  Expected<bool> end() {
    if (Expected<Done> done = end_element(); !done) return Failure<Error>{done.error()};
    if (!elements_.contains("vertex")) return malformed("expected an element 'vertex' before here");
    return false;
  }

  // Entries without properties take no bytes, so that any number of them would do.
  Expected<Done> end_element() {
    if (header_.elements.empty()) return Done{};
    const Element& e = header_.elements.back();
    if (e.count > 0 && e.properties.empty())
      return text_.malformed(
          element_line_, "expected element " + quoted(e.name) + " with entries to have properties");
    if (e.count > 0 && holds_faces(e) && !has_indices(e))
      return text_.malformed(element_line_, "expected element " + quoted(e.name) +
                                                " to have a list vertex_indices or vertex_index");
    if (e.count > 0 && holds_faces(e) && std::exchange(has_faces_, true))
      return fail(ErrorCode::unsupported, Place::line, text_.line_of(element_line_),
                  "a file with both faces and triangle strips");
    return Done{};
  }

  static bool holds_faces(const Element& e) { return e.name == "face" || e.name == "tristrips"; }
  static bool has_indices(const Element& e) {
    return std::any_of(e.properties.begin(), e.properties.end(),
                       [](const Property& p) { return p.meaning != Meaning::value; });
  }

  Failure<Error> malformed(std::string what) { return text_.malformed(line_, std::move(what)); }

  std::string_view file_;
  Text text_;
  const char* line_ = nullptr;          // where the current line begins
  const char* element_line_ = nullptr;  // and that of the current element
  Header header_;
  bool has_format_ = false;
  bool has_faces_ = false;
  std::set<std::string> elements_;
  std::set<std::string> properties_;  // of the current element
};

}  // namespace

std::string percent_encoded(std::string_view name) {
  constexpr char digits[] = "0123456789ABCDEF";
  std::string text;
  for (const char c : name) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte > ' ' && byte < 0x7f && c != '%')
      text += c;
    else
      text += {'%', digits[byte / 16], digits[byte % 16]};
  }
  return text;
}

std::optional<std::string> percent_decoded(std::string_view text) {
  std::string name;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '%') {
      name += text[i];
      continue;
    }
    unsigned byte = 0;
    if (text.size() - i < 3) return std::nullopt;
    const char* end = text.data() + i + 3;
    if (std::from_chars(text.data() + i + 1, end, byte, 16).ptr != end) return std::nullopt;
    name += static_cast<char>(byte);
    i += 2;
  }
  return name;
}

std::uint32_t Header::vertex_count() const {
  for (const Element& e : elements)
    if (e.name == "vertex") return static_cast<std::uint32_t>(e.count);
  return 0;
}

Expected<Header> read_header(std::string_view file) {
  return HeaderReader(file).read();
}

}  // namespace clers::io::ply
