// A progress bar for long work.
#ifndef CLERS_CODEC_CLI_PROGRESS_H
#define CLERS_CODEC_CLI_PROGRESS_H

#include <chrono>
#include <functional>
#include <string>
#include <string_view>

namespace clers::cli {

/// Draws a bar on stderr once the work has taken half a second, if stderr is a terminal; erases it
/// when it goes, so that nothing of it stays beside what is printed.
class Progress {
 public:
  Progress(std::string subject, bool wanted);
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress() { clear(); }

  /// `done`: the share of the stage's work that is done, 0..1.
  void show(std::string_view stage, double done);
  void clear();

  /// As a callback for the codec, which lives as long as this.
  std::function<void(std::string_view, double)> callback();

 private:
  using Clock = std::chrono::steady_clock;

  std::string subject_;
  bool wanted_, drawn_ = false;
  Clock::time_point next_;  ///< nothing is drawn before
};

}  // namespace clers::cli

#endif
