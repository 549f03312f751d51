// How exact values shall be, in a word of the command line, and how exact they are.
#ifndef CLERS_CODEC_CLI_PRECISION_H
#define CLERS_CODEC_CLI_PRECISION_H

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "codec/info.h"
#include "codec/precision.h"
#include "codec/verdict.h"

namespace clers::cli {

/// What parse_precision takes, as a part of a sentence: of positions, and of other attributes,
/// which may be directions.
extern const char precision_words[];
extern const char attribute_precision_words[];

/// "lossless", "q14", "step0.01", "error0.001", "grid:0,0,0:0.01", "oct10", "recompute0.5".
std::optional<Precision> parse_precision(std::string_view text);

/// "0.000499", "0.0621 degrees".
std::string in_words(double error, ErrorMeasure measure);

/// The attributes that came back changed, and by how much in any of the meshes.
std::vector<FoundError> largest_errors(std::span<const MeshInfo> meshes);

/// Adds what was found in one more mesh.
void add(std::vector<FoundError>& sum, const FoundError& found);

/// "'position' is off by 0.000499 at most".
std::string off_by(const FoundError& found);

}  // namespace clers::cli

#endif
