// What other codecs compressed, read where this program was built with their libraries.
#ifndef CLERS_CODEC_CLI_FOREIGN_H
#define CLERS_CODEC_CLI_FOREIGN_H

#include <span>
#include <string>

#include "codec/cli/scenes.h"

namespace clers::cli {

/// A file of Draco's.
Outcome<SceneFile> parse_drc(const std::string& path, std::span<const std::byte> bytes);

/// What gltf::read() decodes.
gltf::Decoders foreign_decoders();

/// For the help: a line for each of these that this program is without.
std::string missing_decoders();

}  // namespace clers::cli

#endif
