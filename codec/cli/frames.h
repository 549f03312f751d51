// A sequence of meshes, a file each.
#ifndef CLERS_CODEC_CLI_FRAMES_H
#define CLERS_CODEC_CLI_FRAMES_H

#include <optional>
#include <string>

#include "codec/cli/commands.h"
#include "codec/cli/files.h"
#include "codec/mesh.h"

namespace clers::cli {

/// Writes frame-0001.ply and so on into a directory, if the options name one.
class Frames {
 public:
  Frames(const Options& options, io::Format format, io::Encoding encoding)
      : options_(options), format_(format), encoding_(encoding), inputs_(ids_of(options.inputs)) {}

  /// Makes the directory if it is missing.
  Outcome<Done> open();
  /// False if the file could not be written; `failure` says why.
  bool add(const Mesh& mesh);
  const std::optional<Stop>& failure() const { return failure_; }

 private:
  Outcome<Done> write(const Mesh& mesh);

  const Options& options_;
  io::Format format_;
  io::Encoding encoding_;
  FileIds inputs_;
  unsigned count_ = 0;
  std::optional<Stop> failure_;
};

}  // namespace clers::cli

#endif
