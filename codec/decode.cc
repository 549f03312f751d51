// A file opened for one call.
#include "codec/decode.h"

#include "codec/base/guarded.h"
#include "codec/file/decode_meshes.h"
#include "codec/file/open_file.h"

namespace CLERS_VISIBLE clers {

using namespace internal;

Expected<std::vector<Mesh>> decode(std::span<const std::byte> bytes, const DecodeOptions& options) {
  return guarded("decode", [&]() -> Expected<std::vector<Mesh>> {
    auto file = open_file(bytes, options.limits);
    if (!file) return Failure{file.error()};
    auto meshes = decode_meshes(file->meshes, Values::decode, options, file->budget);
    if (meshes && options.progress) options.progress("done", 1.0);
    return meshes;
  });
}

Expected<Scene> decode_scene(std::span<const std::byte> bytes, const DecodeOptions& options) {
  return guarded("decode", [&]() -> Expected<Scene> {
    auto file = open_file(bytes, options.limits);
    if (!file) return Failure{file.error()};
    Scene scene;
    if (auto ok = decode(file->scene, file->budget, scene); !ok) return Failure{ok.error()};
    auto meshes = decode_meshes(file->meshes, Values::decode, options, file->budget);
    if (!meshes) return Failure{meshes.error()};
    scene.meshes = std::move(*meshes);
    if (auto ok = check_vertices(file->scene, scene); !ok) return Failure{ok.error()};
    if (options.progress) options.progress("done", 1.0);
    return scene;
  });
}

}  // namespace clers
