// KHR_draco_mesh_compression: a primitive says which view has it, and which unique ids of Draco its
// attributes are; its accessors have no place until they get one here.
#include <algorithm>
#include <cstring>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "codec/gltf/extension_format.h"
#include "codec/gltf/foreign.h"
#include "codec/gltf/views.h"

namespace clers::gltf {
namespace {

constexpr char draco_name[] = "KHR_draco_mesh_compression";
constexpr std::uint64_t mode_strip = 5;

/// Values as an accessor has them. False if an integer does not fit, or where one of the two has
/// floats.
bool convert(const Attribute& from, Scalar to, std::vector<std::byte>& out) {
  if (from.scalar == to) {
    out = from.data;
    return true;
  }
  if (is_float(from.scalar) || is_float(to)) return false;
  const std::size_t count = from.data.size() / size_of(from.scalar);
  out.resize(count * size_of(to));
  return with_type(from.scalar, [&](auto source) {
    return with_type(to, [&](auto target) {
      using S = decltype(source);
      using T = decltype(target);
      for (std::size_t i = 0; i < count; ++i) {
        std::memcpy(&source, from.data.data() + i * sizeof(S), sizeof(S));
        target = static_cast<T>(source);
        if (static_cast<S>(target) != source || (target < T{}) != (source < S{})) return false;
        std::memcpy(out.data() + i * sizeof(T), &target, sizeof(T));
      }
      return true;
    });
  });
}

class DracoExpander {
 public:
  DracoExpander(Json& document, Buffers& buffers, const decltype(Decoders::draco)& decode)
      : document_(document), buffers_(buffers), decode_(decode) {}

  Expected<Done> run(const std::vector<bool>& empty) {
    auto layout = read_layout(document_, empty);
    if (!layout) return Failure{layout.error()};
    layout_ = std::move(*layout);
    std::size_t p = 0;
    for (Json& mesh : document_.find("meshes")->items)
      if (Json* primitives = mesh.find("primitives"))
        for (Json& primitive : primitives->items)
          if (auto ok = take(layout_.primitives[p++], primitive); !ok) return ok;
    if (views_.empty()) views_.push_back({std::vector<std::byte>(4)});  // for what is left behind
    std::vector<std::size_t> places;
    for (const auto& [view, mesh] : meshes_)
      if (!empty[layout_.views[view].buffer]) places.push_back(view);
    const auto numbers = exchange_views(layout_, places, std::move(views_), document_, buffers_);
    for (std::size_t k = 0; k < owners_.size(); ++k) {
      Json& accessor = document_.find("accessors")->items[owners_[k]];
      accessor.remove("byteOffset");
      accessor.keys.insert(accessor.keys.begin(), view_key);
      accessor.items.insert(accessor.items.begin(), Json::number(numbers[k]));
    }
    remove_word(document_, "extensionsUsed", draco_name);
    remove_word(document_, "extensionsRequired", draco_name);
    return Done{};
  }

  std::string remark() const {
    std::string text = std::string(draco_name) + " of " + std::to_string(count_) +
                       (count_ == 1 ? " primitive was" : " primitives were") + " decoded";
    if (plain_ > 0) text += ", " + std::to_string(plain_) + " by the plain values beside it";
    std::string bits;
    for (const std::string& one : quantised_) bits += (bits.empty() ? "" : ", ") + one;
    if (!bits.empty()) text += "; what Draco quantised stays so: " + bits;
    return text;
  }

 private:
  /// Takes the extension off a primitive, if there is one, and makes views of what it has.
  Expected<Done> take(const Primitive& primitive, Json& json) {
    const Json* extensions = json.find("extensions");
    const Json* found = extensions == nullptr ? nullptr : extensions->find(draco_name);
    if (found == nullptr) return Done{};
    const auto wrong = [&](std::string what) {
      return malformed("meshes", primitive.mesh, std::string(draco_name) + ": " + std::move(what));
    };
    std::string fault;
    const std::uint64_t view = member(*found, view_key, ~std::uint64_t(0), fault);
    if (!fault.empty() || view >= layout_.views.size()) return wrong("no such bufferView");
    const Json *ids = found->find(attributes_key), *attributes = json.find(attributes_key);
    if (ids == nullptr || attributes == nullptr) return wrong("no attributes");
    if (primitive.mode != mode_triangles && primitive.mode != mode_strip)
      return wrong("mode " + std::to_string(primitive.mode));
    if (primitive.indices == none) return wrong("a primitive without indices");
    ++count_;
    Wanted wanted;
    for (std::size_t i = 0; i < ids->keys.size(); ++i) {
      const Json* accessor = attributes->find(ids->keys[i]);
      const auto id = integer(ids->items[i]),
                 number = accessor == nullptr ? std::nullopt : integer(*accessor);
      if (!id || !number) return wrong(ids->keys[i] + " is no attribute");
      if (needs_values(static_cast<std::size_t>(*number)))
        wanted.push_back({static_cast<std::size_t>(*number), ids->keys[i], std::to_string(*id)});
    }
    const std::size_t at = static_cast<std::size_t>(view);
    if (wanted.empty() && !needs_values(primitive.indices)) {
      meshes_.emplace(at, std::nullopt);  // decoded by nobody, and gone all the same
      ++plain_;
    } else if (auto ok = fill(at, wanted, primitive, json); !ok) {
      return ok;
    }
    remove_extension(json, draco_name);
    return Done{};
  }

  bool needs_values(std::size_t accessor) const {
    return document_.find("accessors")->items[accessor].find(view_key) == nullptr;
  }

  struct Attributes {
    std::size_t accessor;
    std::string name, id;
  };
  using Wanted = std::vector<Attributes>;

  /// The mesh in a view, decoded once.
  Expected<const Mesh*> mesh_in(std::size_t view) {
    std::optional<Mesh>& mesh = meshes_[view];
    if (mesh) return &*mesh;
    const View& at = layout_.views[view];
    if (at.offset + at.length > buffers_[at.buffer].size())
      return malformed("bufferViews", view, "has no bytes");
    auto decoded = decode_(
        std::span(buffers_[at.buffer])
            .subspan(static_cast<std::size_t>(at.offset), static_cast<std::size_t>(at.length)));
    if (!decoded) {
      Error error = decoded.error();
      error.what = "glTF: bufferViews[" + std::to_string(view) + "]: " + error.what;
      return Failure{std::move(error)};
    }
    mesh = std::move(*decoded);
    return &*mesh;
  }

  Expected<Done> fill(std::size_t view, const Wanted& wanted, const Primitive& primitive,
                      Json& json) {
    const auto decoded = mesh_in(view);
    if (!decoded) return Failure{decoded.error()};
    const Mesh& mesh = **decoded;
    for (const Attributes& one : wanted)
      if (auto ok = fill_attribute(view, mesh, one); !ok) return ok;
    if (!needs_values(primitive.indices)) return Done{};
    if (primitive.mode == mode_strip)  // Draco has triangles all the same
      *json.find("mode") = Json::number(mode_triangles);
    return fill_indices(view, mesh, primitive.indices);
  }

  /// Is the accessor to be filled, or was it by another primitive? An error if from another view.
  Expected<bool> claim(std::size_t accessor, std::size_t view) {
    const auto [owner, fresh] = from_.emplace(accessor, view);
    if (owner->second != view)
      return malformed("accessors", accessor, "has values of two meshes of Draco");
    return fresh;
  }

  Expected<Done> fill_attribute(std::size_t view, const Mesh& mesh, const Attributes& one) {
    const auto fresh = claim(one.accessor, view);
    if (!fresh) return Failure{fresh.error()};
    if (!*fresh) return Done{};
    const auto wrong = [&](std::string what) {
      return malformed("accessors", one.accessor, "of " + one.name + ", by Draco: " + what);
    };
    const auto found = std::find_if(mesh.attributes.begin(), mesh.attributes.end(),
                                    [&](const Attribute& a) { return a.name == one.id; });
    if (found == mesh.attributes.end()) return wrong("no attribute has id " + one.id);
    Run run = layout_.runs[layout_.accessors[one.accessor].base];
    if (run.count != mesh.vertex_count || found->components != run.components())
      return wrong("has " + std::to_string(mesh.vertex_count) + " values of " +
                   std::to_string(found->components) + " components");
    std::vector<std::byte> values;
    if (!convert(*found, run.scalar, values))
      return wrong(std::string("has values of ") + name(found->scalar) + " that are none of " +
                   name(run.scalar));
    run.buffer = 0;
    run.start = 0;
    run.stride = (run.size() + 3) / 4 * 4;
    Buffers buffer(1, std::vector<std::byte>(static_cast<std::size_t>(run.count * run.stride)));
    if (run.count > 0) scatter(run, values, buffer);
    add_view(one.accessor,
             {std::move(buffer[0]), run.stride == run.size() ? 0 : run.stride, target_vertices});
    for (const MetadataEntry& said : mesh.metadata)
      if (said.key == one.id) quantised_.insert(one.name + " " + said.value);
    return Done{};
  }

  Expected<Done> fill_indices(std::size_t view, const Mesh& mesh, std::size_t accessor) {
    const auto fresh = claim(accessor, view);
    if (!fresh) return Failure{fresh.error()};
    if (!*fresh) return Done{};
    Run run = layout_.runs[layout_.accessors[accessor].base];
    const std::uint64_t most = (std::uint64_t(1) << (8 * size_of(run.scalar))) - 1;
    if (mesh.vertex_count > most)
      return malformed("accessors", accessor,
                       std::to_string(mesh.vertex_count) + " vertices of Draco, more than indices");
    run.buffer = 0;
    run.start = 0;
    run.stride = run.size();
    run.count = mesh.corners.size();
    Buffers buffer(1, std::vector<std::byte>(packed_size(run)));
    scatter_indices(run, mesh.corners, buffer);
    // Draco drops degenerate triangles, and not all programs say so.
    *document_.find("accessors")->items[accessor].find("count") = Json::number(run.count);
    add_view(accessor, {std::move(buffer[0]), 0, target_indices});
    return Done{};
  }

  void add_view(std::size_t accessor, NewView view) {
    views_.push_back(std::move(view));
    owners_.push_back(accessor);
  }

  Json& document_;
  Buffers& buffers_;
  const decltype(Decoders::draco)& decode_;
  Layout layout_;
  std::map<std::size_t, std::optional<Mesh>> meshes_;  ///< of views
  std::map<std::size_t, std::size_t> from_;            ///< views, of accessors
  std::vector<NewView> views_;
  std::vector<std::size_t> owners_;  ///< accessors of the new views
  std::set<std::string> quantised_;
  std::size_t count_ = 0, plain_ = 0;  ///< primitives
};

bool is_used(const Json& document) {
  const Json* meshes = document.find("meshes");
  if (meshes == nullptr) return false;
  for (const Json& mesh : meshes->items)
    if (const Json* primitives = mesh.find("primitives"))
      for (const Json& primitive : primitives->items)
        if (const Json* extensions = primitive.find("extensions");
            extensions != nullptr && extensions->find(draco_name) != nullptr)
          return true;
  return false;
}

}  // namespace

Expected<Done> decode_draco(Json& document, Buffers& buffers, const std::vector<bool>& empty,
                            const decltype(Decoders::draco)& decode,
                            std::vector<std::string>& remarks) {
  if (!is_used(document)) return Done{};
  if (!decode) {
    remarks.push_back(kept_compressed(draco_name));
    return Done{};
  }
  DracoExpander expander(document, buffers, decode);
  if (auto ok = expander.run(empty); !ok) return ok;
  remarks.push_back(expander.remark());
  return Done{};
}

}  // namespace clers::gltf
