// What info and check say: as text for people, as JSON for programs.
#ifndef CLERS_CODEC_CLI_REPORT_H
#define CLERS_CODEC_CLI_REPORT_H

#include <cstdint>
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

/// 1234567 -> "1,234,567".
std::string grouped(std::uint64_t n);
/// "1 face", "1,234 faces".
std::string counted(std::uint64_t n, const char* one, const char* more);

/// One file in detail.
std::string info_text(const std::string& file, const Inspection& found);
std::string check_text(const std::string& file, std::span<const Measured> meshes);

/// Several files, a line each below a heading.
std::string info_heading();
std::string info_line(const std::string& file, const Inspection& found);
std::string check_heading();
std::string check_line(const std::string& file, std::span<const Measured> meshes);

/// One file as JSON, and a list of such; without a line end.
std::string info_json(const std::string& file, const Inspection& found);
std::string check_json(const std::string& file, std::span<const Measured> meshes);
std::string json_list(std::span<const std::string> files);

}  // namespace clers::cli

#endif
