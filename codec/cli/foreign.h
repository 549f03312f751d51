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

/// For the help: which of these this program is without; "" if it has all.
std::string missing_decoders();

}  // namespace clers::cli

#endif
