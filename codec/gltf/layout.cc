// Object by object, and every number against what it is an index or an end of.
#include "codec/gltf/layout.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

namespace clers::gltf {
namespace {

constexpr std::uint64_t most = std::uint64_t(1) << 53;  ///< that JSON's numbers say exactly

std::optional<Scalar> scalar_of(std::uint64_t component_type) {
  switch (component_type) {
    case 5120: return Scalar::int8;
    case 5121: return Scalar::uint8;
    case 5122: return Scalar::int16;
    case 5123: return Scalar::uint16;
    case 5124: return Scalar::int32;  // of extensions, as 5130
    case 5125: return Scalar::uint32;
    case 5126: return Scalar::float32;
    case 5130: return Scalar::float64;
    default: return std::nullopt;
  }
}

struct Type {
  const char* name;
  std::uint8_t columns, rows;
};
constexpr Type types[] = {{"SCALAR", 1, 1}, {"VEC2", 1, 2}, {"VEC3", 1, 3}, {"VEC4", 1, 4},
                          {"MAT2", 2, 2},   {"MAT3", 3, 3}, {"MAT4", 4, 4}};

/// Extensions of primitives that name no vertex but by attributes and indices.
constexpr std::string_view harmless[] = {"KHR_materials_variants", "EXT_mesh_features",
                                         "EXT_structural_metadata", "CESIUM_primitive_outline"};

class LayoutReader {
 public:
  LayoutReader(const Json& document, const std::vector<bool>& empty)
      : document_(document), empty_(empty) {}

  Expected<Done> run() {
    if (auto ok = each("buffers", &LayoutReader::buffer); !ok) return ok;
    if (auto ok = each("bufferViews", &LayoutReader::view); !ok) return ok;
    if (auto ok = each("accessors", &LayoutReader::accessor); !ok) return ok;
    return each("meshes", &LayoutReader::mesh);
  }

  Layout layout;

 private:
  Expected<Done> each(const char* key, std::string (LayoutReader::*read)(const Json&)) {
    return read_each(document_, key, [&](const Json& json) { return (this->*read)(json); });
  }

  std::string buffer(const Json& json) {
    std::string fault;
    const std::uint64_t size = member(json, "byteLength", most, fault);
    layout.buffers.push_back(size);
    if (fault.empty() && size == most) fault = "no byteLength";
    return fault;
  }

  std::string view(const Json& json) {
    std::string fault;
    View view;
    const std::uint64_t buffer = member(json, "buffer", most, fault);
    view.offset = member(json, "byteOffset", 0, fault);
    view.length = member(json, "byteLength", most, fault);
    view.stride = member(json, "byteStride", 0, fault);
    const Json* extensions = json.find("extensions");
    view.extended = extensions != nullptr && !extensions->items.empty();
    if (!fault.empty()) return fault;
    if (buffer >= layout.buffers.size()) return "no such buffer";
    view.buffer = static_cast<std::size_t>(buffer);
    const std::uint64_t size = layout.buffers[view.buffer];
    if (view.offset > size || view.length > size - view.offset)
      return "goes beyond the end of buffer " + std::to_string(buffer);
    layout.views.push_back(view);
    return {};
  }

  /// Puts a run where its view and offset say.
  std::string place(const Json& json, Run run) {
    std::string fault;
    const std::uint64_t index = member(json, "bufferView", most, fault);
    const std::uint64_t offset = member(json, "byteOffset", 0, fault);
    if (!fault.empty()) return fault;
    if (index != most) {
      if (index >= layout.views.size()) return "no such bufferView";
      const View& view = layout.views[static_cast<std::size_t>(index)];
      if (run.stride == 0) run.stride = view.stride != 0 ? view.stride : run.size();
      if (offset > view.length) return "goes beyond the end of its bufferView";
      run.start = view.offset + offset;
      run.buffer = view.buffer;
      const std::uint64_t room = view.length - offset;
      if (run.count > 0 && (run.size() > room || run.count - 1 > (room - run.size()) / run.stride))
        return "goes beyond the end of its bufferView";
      if (!empty_[view.buffer]) run.view = static_cast<std::size_t>(index);
    }
    layout.runs.push_back(run);
    return {};
  }

  /// Sets the types of a run.
  static std::string type(const Json& json, std::string_view name, Run& run) {
    std::string fault;
    const auto scalar = scalar_of(member(json, "componentType", 0, fault));
    if (!fault.empty()) return fault;
    if (!scalar) return "no componentType that is known";
    const auto* found = std::find_if(std::begin(types), std::end(types),
                                     [&](const Type& t) { return t.name == name; });
    if (found == std::end(types)) return "no type that is known";
    run.scalar = *scalar;
    run.columns = found->columns;
    run.rows = found->rows;
    run.column = static_cast<std::uint32_t>(run.rows * size_of(run.scalar));
    if (run.columns > 1) run.column = (run.column + 3) / 4 * 4;
    return {};
  }

  std::string accessor(const Json& json) {
    std::string fault;
    Accessor accessor;
    accessor.count = member(json, "count", most, fault);
    if (fault.empty() && accessor.count > 0xffffffffu) fault = "no count of at most 2^32 - 1";
    const Json* name = json.find("type");
    if (!fault.empty()) return fault;
    Run run;
    run.count = accessor.count;
    if (name == nullptr || !name->is(Json::Kind::string)) return "no type";
    if (fault = type(json, name->text, run); !fault.empty()) return fault;
    accessor.base = layout.runs.size();
    if (fault = place(json, run); !fault.empty()) return fault;
    if (const Json* sparse = json.find("sparse")) {
      if (!sparse->is(Json::Kind::object)) return "sparse is no object";
      fault = sparse_part(*sparse, accessor, run);
    }
    layout.accessors.push_back(accessor);
    return fault;
  }

  std::string sparse_part(const Json& json, Accessor& accessor, Run values) {
    std::string fault;
    values.count = member(json, "count", most, fault);
    const Json *at = json.find("indices"), *to = json.find("values");
    if (!fault.empty()) return "sparse: " + fault;
    if (values.count > accessor.count) return "sparse: more values than the accessor has";
    if (at == nullptr || to == nullptr || !at->is(Json::Kind::object) ||
        !to->is(Json::Kind::object))
      return "sparse: no indices and values";
    Run indices;
    indices.count = values.count;
    if (fault = type(*at, "SCALAR", indices); !fault.empty()) return "sparse indices: " + fault;
    if (is_float(indices.scalar)) return "sparse indices that are no integers";
    // These lie packed, whatever a stride says.
    indices.stride = indices.size();
    values.stride = values.size();
    accessor.indices = layout.runs.size();
    if (fault = place(*at, indices); !fault.empty()) return "sparse indices: " + fault;
    accessor.values = layout.runs.size();
    if (fault = place(*to, values); !fault.empty()) return "sparse values: " + fault;
    return {};
  }

  std::string mesh(const Json& json) {
    const std::size_t index = layout.mesh_names.size();
    const Json* name = json.find("name");
    layout.mesh_names.push_back(name != nullptr && name->is(Json::Kind::string) ? name->text : "");
    const Json* primitives = json.find("primitives");
    if (primitives == nullptr) return {};
    if (!primitives->is(Json::Kind::array)) return "primitives are no array";
    for (std::size_t i = 0; i < primitives->items.size(); ++i) {
      Primitive p;
      p.mesh = index;
      if (std::string fault = primitive(primitives->items[i], p); !fault.empty())
        return "primitives[" + std::to_string(i) + "]: " + fault;
      layout.primitives.push_back(std::move(p));
    }
    return {};
  }

  std::string vertices(const Json& json, Primitive& p, bool target) const {
    if (!json.is(Json::Kind::object)) return "attributes are no object";
    for (std::size_t i = 0; i < json.items.size(); ++i) {
      const auto index = integer(json.items[i]);
      if (!index || *index >= layout.accessors.size()) return json.keys[i] + ": no such accessor";
      p.vertices.push_back({json.keys[i], static_cast<std::size_t>(*index), target});
    }
    return {};
  }

  std::string primitive(const Json& json, Primitive& p) const {
    if (!json.is(Json::Kind::object)) return "is no object";
    std::string fault;
    p.mode = member(json, "mode", mode_triangles, fault);
    if (!fault.empty()) return fault;
    if (p.mode > last_mode) return "no mode that is known";
    if (const Json* attributes = json.find("attributes"))
      if (fault = vertices(*attributes, p, false); !fault.empty()) return fault;
    if (const Json* targets = json.find("targets"))
      for (const Json& target : targets->items)
        if (fault = vertices(target, p, true); !fault.empty()) return "targets: " + fault;
    if (fault = index_member(json, "indices", p.indices); !fault.empty()) return fault;
    if (const Json* extensions = json.find("extensions"))
      for (std::size_t i = 0; i < extensions->keys.size(); ++i) {
        const bool known = std::find(std::begin(harmless), std::end(harmless),
                                     extensions->keys[i]) != std::end(harmless);
        p.opaque = p.opaque || !known;
        std::size_t indices = none;
        if (extensions->keys[i] != "CESIUM_primitive_outline") continue;
        if (fault = index_member(extensions->items[i], "indices", indices); !fault.empty())
          return fault;
        if (indices != none) p.other_indices.push_back(indices);
      }
    return {};
  }

  std::string index_member(const Json& json, const char* key, std::size_t& accessor) const {
    std::string fault;
    const std::uint64_t index = member(json, key, most, fault);
    if (!fault.empty() || index == most) return fault;
    if (index >= layout.accessors.size()) return std::string(key) + ": no such accessor";
    const Run& run = layout.runs[layout.accessors[static_cast<std::size_t>(index)].base];
    if (run.components() != 1 || is_float(run.scalar))
      return std::string(key) + " that are no single integers";
    accessor = static_cast<std::size_t>(index);
    return {};
  }

  const Json& document_;
  const std::vector<bool>& empty_;
};

}  // namespace

Failure<Error> malformed(std::string where, std::size_t index, std::string what) {
  return fail(ErrorCode::malformed,
              "glTF: " + std::move(where) + "[" + std::to_string(index) + "]: " + std::move(what));
}

Expected<const std::vector<Json>*> list_of(const Json& document, const char* key) {
  static const std::vector<Json> nothing;
  const Json* list = document.find(key);
  if (list == nullptr) return &nothing;
  if (!list->is(Json::Kind::array))
    return fail(ErrorCode::malformed, std::string("glTF: ") + key + " is no array");
  for (std::size_t i = 0; i < list->items.size(); ++i)
    if (!list->items[i].is(Json::Kind::object)) return malformed(key, i, "is no object");
  return &list->items;
}

std::uint64_t member(const Json& object, const char* key, std::uint64_t otherwise,
                     std::string& fault) {
  const Json* json = object.find(key);
  if (json == nullptr) return otherwise;
  const auto n = integer(*json);
  if (!n || *n >= most) {
    if (fault.empty()) fault = std::string(key) + " is no number of a size or place";
    return otherwise;
  }
  return *n;
}

Expected<Layout> read_layout(const Json& document, const std::vector<bool>& empty) {
  LayoutReader reader(document, empty);
  if (auto ok = reader.run(); !ok) return Failure{ok.error()};
  return std::move(reader.layout);
}

}  // namespace clers::gltf
