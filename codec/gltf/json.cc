// The only file that knows RapidJSON.
#include "codec/gltf/json.h"

#include <rapidjson/error/en.h>
#include <rapidjson/reader.h>
#include <rapidjson/stringbuffer.h>
#include <rapidjson/writer.h>

#include <charconv>
#include <cmath>
#include <utility>

namespace clers::gltf {
namespace {

/// Builds the tree of what the parser meets.
class Builder : public rapidjson::BaseReaderHandler<rapidjson::UTF8<>, Builder> {
 public:
  bool Null() { return put({}); }
  bool Bool(bool b) { return put({Json::Kind::boolean, b ? "true" : "false"}); }
  bool RawNumber(const char* s, rapidjson::SizeType n, bool) {
    return put(Json::number(std::string(s, n)));
  }
  bool String(const char* s, rapidjson::SizeType n, bool) {
    return put(Json::string(std::string(s, n)));
  }
  bool Key(const char* s, rapidjson::SizeType n, bool) {
    open_.back().keys.emplace_back(s, n);
    return true;
  }
  bool StartObject() { return begin(Json::Kind::object); }
  bool EndObject(rapidjson::SizeType) { return end(); }
  bool StartArray() { return begin(Json::Kind::array); }
  bool EndArray(rapidjson::SizeType) { return end(); }

  Json root;

 private:
  bool put(Json value) {
    (open_.empty() ? root : open_.back().items.emplace_back()) = std::move(value);
    return true;
  }
  bool begin(Json::Kind kind) {
    if (open_.size() == most_depth) return false;
    open_.push_back({kind});
    return true;
  }
  bool end() {
    Json done = std::move(open_.back());
    open_.pop_back();
    return put(std::move(done));
  }

  std::vector<Json> open_;
};

/// A number of bytes in memory, which may hold zeros.
struct Text {
  using Ch = char;
  const char *begin, *at, *end;
  Ch Peek() const { return at < end ? *at : '\0'; }
  Ch Take() { return at < end ? *at++ : '\0'; }
  std::size_t Tell() const { return static_cast<std::size_t>(at - begin); }
  // For streams that are written to, which this one is not.
  Ch* PutBegin() { return nullptr; }
  void Put(Ch) {}
  void Flush() {}
  std::size_t PutEnd(Ch*) { return 0; }
};

using Writer = rapidjson::Writer<rapidjson::StringBuffer>;

void put(Writer& out, const Json& json) {
  const auto size = static_cast<rapidjson::SizeType>(json.text.size());
  switch (json.kind) {
    case Json::Kind::null: out.Null(); break;
    case Json::Kind::boolean: out.Bool(json.text == "true"); break;
    case Json::Kind::number:
      out.RawValue(json.text.data(), json.text.size(), rapidjson::kNumberType);
      break;
    case Json::Kind::string: out.String(json.text.data(), size); break;
    case Json::Kind::array:
      out.StartArray();
      for (const Json& item : json.items) put(out, item);
      out.EndArray();
      break;
    case Json::Kind::object:
      out.StartObject();
      for (std::size_t i = 0; i < json.items.size(); ++i) {
        out.Key(json.keys[i].data(), static_cast<rapidjson::SizeType>(json.keys[i].size()));
        put(out, json.items[i]);
      }
      out.EndObject();
      break;
  }
}

/// Half a surrogate pair, which an escape may be and UTF-8 may not, as an escape again.
std::string with_halves_escaped(std::string_view text) {
  constexpr char digits[] = "0123456789abcdef";
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  std::string all;
  all.reserve(text.size());
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (byte(i) != 0xed || i + 2 >= text.size() || byte(i + 1) < 0xa0) {
      all += text[i];
      continue;
    }
    const unsigned code = 0xd000u | (byte(i + 1) & 0x3fu) << 6 | (byte(i + 2) & 0x3fu);
    all += "\\u";
    for (const int shift : {12, 8, 4, 0}) all += digits[code >> shift & 15u];
    i += 2;
  }
  return all;
}

}  // namespace

void Json::remove(std::string_view key) {
  for (std::size_t i = keys.size(); i-- > 0;) {
    if (keys[i] != key) continue;
    keys.erase(keys.begin() + static_cast<std::ptrdiff_t>(i));
    items.erase(items.begin() + static_cast<std::ptrdiff_t>(i));
    return;
  }
}

Expected<Json> parse(std::string_view text) {
  constexpr unsigned how = rapidjson::kParseNumbersAsStringsFlag |
                           rapidjson::kParseValidateEncodingFlag | rapidjson::kParseIterativeFlag;
  Text in{text.data(), text.data(), text.data() + text.size()};
  Builder builder;
  rapidjson::Reader reader;
  const rapidjson::ParseResult result = reader.Parse<how>(in, builder);
  if (result.IsError()) {
    const bool deep = result.Code() == rapidjson::kParseErrorTermination;
    return fail(ErrorCode::malformed, Place::byte, result.Offset(),
                deep ? "JSON is nested deeper than " + std::to_string(most_depth)
                     : std::string("no JSON: ") + rapidjson::GetParseError_En(result.Code()));
  }
  if (in.Tell() < text.size())
    return fail(ErrorCode::malformed, Place::byte, in.Tell(), "a zero in JSON");
  return std::move(builder.root);
}

std::string print(const Json& json) {
  rapidjson::StringBuffer buffer;
  Writer out(buffer);
  put(out, json);
  return with_halves_escaped({buffer.GetString(), buffer.GetSize()});
}

std::optional<double> real(const Json& json) {
  if (!json.is(Json::Kind::number)) return std::nullopt;
  const char *begin = json.text.data(), *end = begin + json.text.size();
  double value = 0;
  const auto [at, error] = std::from_chars(begin, end, value);
  if (at != end || error != std::errc()) return std::nullopt;
  return value;
}

std::optional<std::uint64_t> integer(const Json& json) {
  if (!json.is(Json::Kind::number)) return std::nullopt;
  const char *begin = json.text.data(), *end = begin + json.text.size();
  std::uint64_t n = 0;
  if (const auto [at, error] = std::from_chars(begin, end, n); at == end && error == std::errc())
    return n;
  const auto value = real(json);
  if (!value || !(*value >= 0) || *value > 9007199254740992.0 || std::floor(*value) != *value)
    return std::nullopt;
  return static_cast<std::uint64_t>(*value);
}

}  // namespace clers::gltf
