// Meshes are encoded one by one; what names their vertices follows.
#include <algorithm>
#include <cstring>
#include <utility>

#include "codec/base/guarded.h"
#include "codec/gltf/gltf.h"
#include "codec/gltf/write_files.h"
#include <clers/decode.h>
#include <clers/encode.h>

namespace clers::gltf {
namespace {

/// What is asked for attributes that a mesh has.
std::vector<AttributePrecision> precisions_of(const Mesh& mesh, const EncodeOptions& how) {
  std::vector<AttributePrecision> some;
  for (const AttributePrecision& asked : how.precisions)
    if (std::any_of(mesh.attributes.begin(), mesh.attributes.end(),
                    [&](const Attribute& a) { return a.name == asked.name; }))
      some.push_back(asked);
  return some;
}

Expected<Done> check_precisions(const Scene& scene, const EncodeOptions& how) {
  for (const AttributePrecision& asked : how.precisions) {
    const auto has = [&](const Mesh& mesh) {
      return std::any_of(mesh.attributes.begin(), mesh.attributes.end(),
                         [&](const Attribute& a) { return a.name == asked.name; });
    };
    if (std::none_of(scene.meshes.begin(), scene.meshes.end(), has))
      return fail(ErrorCode::bad_option,
                  "attribute '" + asked.name + "': there is none of that name");
  }
  return Done{};
}

Expected<Compressed> compressed(const Scene& given, std::span<const Order> orders,
                                const EncodeOptions& how, const WriteOptions& options) {
  if (auto ok = check_precisions(given, how); !ok) return Failure{ok.error()};
  Compressed result;
  Scene scene = given;
  std::vector<std::vector<std::byte>> files;
  std::vector<std::vector<std::uint32_t>> numbers;
  for (std::size_t i = 0; i < scene.meshes.size(); ++i) {
    Mesh& mesh = scene.meshes[i];
    mesh.name.clear();  // the JSON has it
    EncodeOptions one = how;
    one.precisions = precisions_of(mesh, how);
    if (i < orders.size() && how.order == Order::free) one.order = orders[i];
    auto encoded = encode(mesh, one);
    if (!encoded) return Failure{encoded.error()};
    auto decoded = decode(encoded->bytes);
    if (!decoded) return Failure{decoded.error()};
    mesh = std::move(decoded->front());
    files.push_back(std::move(encoded->bytes));
    const std::vector<std::uint32_t>& before = encoded->permutations[0].vertices;
    numbers.emplace_back(before.size());
    for (std::uint32_t v = 0; v < before.size(); ++v) numbers.back()[before[v]] = v;
    result.report.push_back(std::move(encoded->report[0]));
    for (Warning& warning : encoded->warnings) {
      warning.mesh = i;
      result.warnings.push_back(std::move(warning));
    }
  }
  for (Array& array : scene.arrays) {
    if (!array.vertices_of || *array.vertices_of >= numbers.size()) continue;
    const std::vector<std::uint32_t>& of_mesh = numbers[*array.vertices_of];
    for (std::size_t at = 0; at + sizeof(std::uint32_t) <= array.data.size();
         at += sizeof(std::uint32_t)) {
      std::uint32_t v = 0;
      std::memcpy(&v, array.data.data() + at, sizeof v);
      if (v >= of_mesh.size())
        return fail(ErrorCode::inconsistent_mesh, "an array has vertex " + std::to_string(v));
      std::memcpy(array.data.data() + at, &of_mesh[v], sizeof v);
    }
  }
  auto written = write_files(scene, files, options);
  if (!written) return Failure{written.error()};
  result.written = std::move(*written);
  return result;
}

}  // namespace

Expected<Compressed> write_compressed(const Scene& scene, std::span<const Order> orders,
                                      const EncodeOptions& how, const WriteOptions& options) {
  return internal::guarded("write a glTF", [&] { return compressed(scene, orders, how, options); });
}

}  // namespace clers::gltf
