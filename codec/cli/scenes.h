// Scenes in files of several formats: a mesh file is one that has nothing but meshes.
#ifndef CLERS_CODEC_CLI_SCENES_H
#define CLERS_CODEC_CLI_SCENES_H

#include <string>
#include <vector>

#include "codec/cli/files.h"
#include "codec/cli/formats.h"
#include "codec/cli/outcome.h"
#include "codec/order.h"
#include "codec/scene.h"

namespace clers::cli {

struct SceneFile {
  Scene scene;
  std::vector<Order> orders;  ///< as encode() takes them
  io::Notes notes;
};

/// Reads a file that is in memory, and from beside `path` those that it names.
Outcome<SceneFile> parse_scene(const std::string& path, std::span<const std::byte> bytes,
                               Format format);

/// What a scene is besides its meshes, as a part of a sentence: "3 arrays and a document"; "" if it
/// is nothing.
std::string besides_meshes(const Scene& scene);

/// How a glTF at a path is written: standard output takes one file.
gltf::WriteOptions options_for(gltf::Form form, const std::string& path);

/// The files of a scene that is a glTF. `path`: where it goes.
Outcome<gltf::Written> write_scene(const Scene& scene, gltf::Form form, const std::string& path);

/// Where a file that a scene at `path` names goes.
std::string beside(const std::string& path, const std::string& name);

}  // namespace clers::cli

#endif
