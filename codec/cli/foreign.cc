// The only file that knows which of these libraries there are: CLERS_WITH_DRACO,
// CLERS_WITH_MESHOPT.
#include "codec/cli/foreign.h"

#include <utility>

#include "codec/cli/files.h"
#ifdef CLERS_WITH_DRACO
#include "codec/draco/draco.h"
#endif
#ifdef CLERS_WITH_MESHOPT
#include "codec/meshopt/meshopt.h"
#endif

namespace clers::cli {

#ifdef CLERS_WITH_DRACO

Outcome<SceneFile> parse_drc(const std::string& path, std::span<const std::byte> bytes) {
  auto read = draco::read(bytes);
  if (!read) return stop(input_name(path), read.error());
  SceneFile file;
  file.scene.meshes.push_back(std::move(read->mesh));
  for (const std::string& note : read->notes)
    file.notes.push_back({io::Note::Kind::remark, 1, "what Draco lost", note});
  return file;
}

#else

Outcome<SceneFile> parse_drc(const std::string& path, std::span<const std::byte>) {
  return stop(Exit::input, input_name(path) +
                               ": this is a Draco file, and this program was built without Draco "
                               "(CLERS_DRACO)");
}

#endif

gltf::Decoders foreign_decoders() {
  gltf::Decoders decoders;
#ifdef CLERS_WITH_DRACO
  decoders.draco = draco::decode_for_gltf;
#endif
#ifdef CLERS_WITH_MESHOPT
  decoders.meshopt = meshopt::decode_for_gltf;
#endif
  return decoders;
}

std::string missing_decoders() {
  std::string lines;
#ifndef CLERS_WITH_DRACO
  lines += "Built without Draco: no .drc, and KHR_draco_mesh_compression is not decoded.\n";
#endif
#ifndef CLERS_WITH_MESHOPT
  lines += "Built without meshoptimizer: EXT_meshopt_compression is not decoded.\n";
#endif
  return lines;
}

}  // namespace clers::cli
