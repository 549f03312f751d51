// What info and check say: as text for people, as JSON for programs.
#ifndef CLERS_CODEC_CLI_REPORT_H
#define CLERS_CODEC_CLI_REPORT_H

#include <span>
#include <string>
#include <vector>

#include "codec/inspect.h"

namespace clers::cli {

/// One mesh of a mesh file, measured.
struct Measured {
  std::string name;
  MeshShape shape;
};

std::string info_text(const std::string& file, const FileInfo& info);
std::string info_json(const std::string& file, const FileInfo& info);
std::string check_text(const std::string& file, std::span<const Measured> meshes);
std::string check_json(const std::string& file, std::span<const Measured> meshes);

}  // namespace clers::cli

#endif
