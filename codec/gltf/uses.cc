// Keys of an animation: a value for each time, which may be several elements (glTF 2.0, 3.11).
#include "codec/gltf/uses.h"

#include <utility>

namespace clers::gltf {
namespace {

class UseReader {
 public:
  UseReader(const Layout& layout, const Json& document)
      : layout_(layout), document_(document), uses(layout.accessors.size()) {}

  Expected<Done> run() {
    if (auto ok = each("animations", &UseReader::animation); !ok) return ok;
    if (auto ok = each("skins", &UseReader::skin); !ok) return ok;
    return each("nodes", &UseReader::node);
  }

 private:
  const Layout& layout_;
  const Json& document_;

 public:
  std::vector<Use> uses;

 private:
  Expected<Done> each(const char* key, std::string (UseReader::*read)(const Json&)) {
    return read_each(document_, key, [&](const Json& json) { return (this->*read)(json); });
  }

  /// The accessor that a member names; none if there is no such member. Sets `fault`.
  std::size_t accessor(const Json& json, const char* key, std::string& fault) const {
    const Json* index = json.find(key);
    if (index == nullptr) return none;
    const auto n = integer(*index);
    if (n && *n < layout_.accessors.size()) return static_cast<std::size_t>(*n);
    if (fault.empty()) fault = std::string(key) + ": no such accessor";
    return none;
  }

  void use(std::size_t accessor, std::string name, std::uint64_t each = 1) {
    if (accessor != none && uses[accessor].name.empty()) uses[accessor] = {std::move(name), each};
  }

  /// What the channels of samplers move.
  static std::vector<std::string> paths_of(const Json& animation, std::size_t samplers) {
    std::vector<std::string> paths(samplers);
    if (const Json* channels = animation.find("channels"))
      for (const Json& channel : channels->items) {
        const Json *index = channel.find("sampler"), *target = channel.find("target");
        if (index == nullptr || target == nullptr) continue;
        const auto sampler = integer(*index);
        const Json* path = target->find("path");
        if (sampler && *sampler < samplers && path != nullptr && path->is(Json::Kind::string) &&
            path->text.size() < 64)
          paths[static_cast<std::size_t>(*sampler)] = " " + path->text;
      }
    return paths;
  }

  std::string animation(const Json& json) {
    const Json* samplers = json.find("samplers");
    if (samplers == nullptr) return {};
    std::string fault;
    const std::vector<std::string> paths = paths_of(json, samplers->items.size());
    for (std::size_t i = 0; i < samplers->items.size(); ++i) {
      const std::size_t input = accessor(samplers->items[i], "input", fault),
                        output = accessor(samplers->items[i], "output", fault);
      if (!fault.empty()) return fault;
      use(input, "animation times");
      if (output == none) continue;
      const std::uint64_t times = input == none ? 0 : layout_.accessors[input].count,
                          values = layout_.accessors[output].count;
      use(output, "animation" + paths[i], times > 0 && values % times == 0 ? values / times : 1);
    }
    return {};
  }

  std::string skin(const Json& json) {
    std::string fault;
    use(accessor(json, "inverseBindMatrices", fault), "inverse bind matrices");
    return fault;
  }

  std::string node(const Json& json) {
    const Json* extensions = json.find("extensions");
    const Json* instances =
        extensions == nullptr ? nullptr : extensions->find("EXT_mesh_gpu_instancing");
    const Json* attributes = instances == nullptr ? nullptr : instances->find("attributes");
    std::string fault;
    if (attributes != nullptr)
      for (const std::string& key : attributes->keys)
        use(accessor(*attributes, key.c_str(), fault), "instances");
    return fault;
  }
};

}  // namespace

Expected<std::vector<Use>> other_uses(const Layout& layout, const Json& document) {
  UseReader reader(layout, document);
  if (auto ok = reader.run(); !ok) return Failure{ok.error()};
  return std::move(reader.uses);
}

}  // namespace clers::gltf
