// What commands do with one file: they read it, make something of it, and write that.
#ifndef CLERS_CODEC_CLI_JOB_H
#define CLERS_CODEC_CLI_JOB_H

#include <chrono>
#include <span>
#include <string>
#include <vector>

#include "codec/cli/commands.h"
#include "codec/cli/destination.h"
#include "codec/cli/files.h"
#include "codec/cli/progress.h"
#include "codec/cli/scenes.h"

namespace clers::cli {

/// The format that is given or that a file's name has. `option` would give it.
Outcome<Format> format_for(const std::string& path, std::optional<Format> given,
                           const char* option);

/// What was left out, as a part of a sentence.
struct Losses {
  std::string what;         ///< "665 texture coordinates and 3 materials"; "" if nothing
  const char* are = "are";  ///< or "is"
};
Losses losses(const io::Notes& notes);

/// One input of a command.
class Job {
 public:
  /// `subject`: what the progress bar calls it.
  Job(const Options& options, std::string input, std::string subject, std::span<const Stage> plan)
      : options_(options),
        input_(std::move(input)),
        progress_(std::move(subject), plan, !options.quiet) {}

  const std::string& input() const { return input_; }
  std::string name() const { return input_name(input_); }  ///< for messages
  Progress& progress() { return progress_; }

  Outcome<Bytes> read() { return read(input_); }
  /// The format of the input, a mesh file or a scene; or what it is instead, by its name.
  Outcome<Format> mesh_format() const { return mesh_format(input_); }
  /// Reads and parses a mesh file or a scene, `read` and parsed being a stage each.
  Outcome<SceneFile> read_scene() { return read_scene(input_); }
  Outcome<SceneFile> read_scene(const std::string& path);
  /// All of a .clers file, or the piece that is asked for.
  Outcome<Scene> decode(std::span<const std::byte> bytes);

  /// Why the input is not accepted as a .clers file.
  Failure<Stop> not_accepted(const Error& error) const;

  /// Prints what was not carried over, or in another form.
  void note(const std::string& file, const io::Notes& notes);
  void note(const std::string& file, const std::string& text, bool is_loss);

  /// Writes the output and says how it went: sizes, unless `results` say more. Removes the input if
  /// that is asked for and nothing of it is lost.
  Outcome<Done> save(const std::string& output, std::span<const std::byte> bytes,
                     const std::vector<std::string>& results = {});

 private:
  using Clock = std::chrono::steady_clock;

  Outcome<Format> mesh_format(const std::string& path) const;
  Outcome<Bytes> read(const std::string& path);
  std::string sizes_and_time(const std::string& output, std::size_t size) const;

  const Options& options_;
  std::string input_;
  Progress progress_;
  Clock::time_point start_ = Clock::now();
  std::size_t bytes_read_ = 0;
  bool whole_ = true;  ///< nothing was left out so far
};

}  // namespace clers::cli

#endif
