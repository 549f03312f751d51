// Members that say the usual are left out.
#include "codec/gltf/marks.h"

#include <utility>

namespace clers::gltf {
namespace {

void put(Json& to, const char* key, const std::vector<std::uint64_t>& list) {
  if (list.empty()) return;
  Json json{Json::Kind::array};
  for (const std::uint64_t n : list) json.items.push_back(Json::number(n));
  to.add(key, std::move(json));
}

}  // namespace

void put_marks(const Marks& marks, Json& document) {
  Json json{Json::Kind::object};
  if (marks.form == Form::gltf) json.add("form", Json::string("gltf"));
  put(json, "empty", marks.empty);
  put(json, "odd", marks.odd);
  put(json, "chunks", marks.chunks);
  if (marks.style != 0) json.add("style", Json::number(marks.style));
  put(json, "loose", marks.loose);
  document.add(marks_key, std::move(json));
}

Expected<Marks> take_marks(Json& document) {
  const Json* json = document.find(marks_key);
  if (json == nullptr || !json->is(Json::Kind::object) || document.keys.back() != marks_key)
    return fail(ErrorCode::unsupported, "this was not made of a glTF");
  Marks marks;
  bool good = true;
  const auto numbers = [&](const Json& list, std::vector<std::uint64_t>& to) {
    for (const Json& item : list.items) {
      const auto n = integer(item);
      good = good && n;
      to.push_back(n.value_or(0));
    }
  };
  for (std::size_t i = 0; i < json->keys.size(); ++i) {
    const std::string& key = json->keys[i];
    const Json& value = json->items[i];
    if (key == "form" && value.text == "gltf") {
      marks.form = Form::gltf;
    } else if (key == "empty") {
      numbers(value, marks.empty);
    } else if (key == "odd") {
      numbers(value, marks.odd);
    } else if (key == "chunks") {
      numbers(value, marks.chunks);
    } else if (key == "style") {
      const auto n = integer(value);
      good = good && n && *n < style_count;
      marks.style = n.value_or(0);
    } else if (key == "loose") {
      numbers(value, marks.loose);
    } else {
      good = false;
    }
  }
  if (!good) return fail(ErrorCode::malformed, "glTF: CLERS says what is not known");
  document.keys.pop_back();
  document.items.pop_back();
  return marks;
}

std::vector<bool> as_set(const std::vector<std::uint64_t>& numbers, std::size_t count) {
  std::vector<bool> set(count);
  for (const std::uint64_t n : numbers)
    if (n < count) set[static_cast<std::size_t>(n)] = true;
  return set;
}

std::vector<std::uint64_t> as_list(const std::vector<bool>& set) {
  std::vector<std::uint64_t> list;
  for (std::size_t i = 0; i < set.size(); ++i)
    if (set[i]) list.push_back(i);
  return list;
}

}  // namespace clers::gltf
