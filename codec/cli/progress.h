// A progress bar for long work.
#ifndef CLERS_CODEC_CLI_PROGRESS_H
#define CLERS_CODEC_CLI_PROGRESS_H

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <span>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

namespace clers::cli {

/// One stage of the work on a file.
struct Stage {
  const char* name;
  double share;  ///< of the time that all take; any unit
};

/// Draws a bar on stderr once the work has taken half a second, if stderr is a terminal; erases it
/// when it goes, so that nothing of it stays beside what is printed.
///
/// A thread of its own draws, since much of the work reports nothing while it goes on: the bar then
/// moves by the time that the stage is expected to take, ever slower once that is used up.
class Progress {
 public:
  Progress(std::string subject, std::span<const Stage> plan, bool wanted);
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress();

  /// The stage before is done, the next of the plan begins.
  void next();
  /// The share of this stage's work that is done, 0..1.
  void show(double done);
  /// Erases the bar, until the next stage: before anything is printed.
  void hide();

  /// As a callback for the codec, which lives as long as this; empty if nothing is drawn.
  std::function<void(std::string_view, double)> callback();

 private:
  using Clock = std::chrono::steady_clock;

  void draw_until_stopped();
  double share_done(Clock::time_point now) const;
  void draw(Clock::time_point now);
  void erase();

  std::string subject_;
  std::span<const Stage> plan_;
  std::mutex mutex_;
  std::condition_variable stopped_;
  bool stop_ = false, hidden_ = true, drawn_ = false;
  std::size_t stage_ = 0;            ///< how many have begun
  double pace_ = 0.1;                ///< seconds that a unit of the plan takes here
  double reported_ = 0, shown_ = 0;  ///< of this stage; of the whole, so that it never falls
  Clock::time_point start_, stage_start_, reported_at_;
  std::thread drawer_;
};

}  // namespace clers::cli

#endif
