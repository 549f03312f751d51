// A line on standard error that says how far the work is.
#include "codec/cli/progress.h"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <system_error>

#include "codec/cli/printable.h"

namespace clers::cli {
namespace {

using namespace std::chrono_literals;

bool draws_on_stderr() {
  const char* term = std::getenv("TERM");
  return ::isatty(STDERR_FILENO) && term != nullptr && std::string_view(term) != "dumb";
}

std::size_t columns_of_stderr() {
  winsize size = {};
  return ::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
}

/// The share that is done after `x` of the expected time: x, until most of it is gone.
double expected_share(double x) {
  constexpr double bend = 0.7;
  return x < bend ? x : 1 - (1 - bend) * (1 - bend) / (x + 1 - 2 * bend);
}

double seconds(std::chrono::steady_clock::duration d) {
  return std::chrono::duration<double>(d).count();
}

}  // namespace

Progress::Progress(std::string subject, std::span<const Stage> plan, bool wanted)
    : subject_(printable(subject)), plan_(plan), start_(Clock::now()) {
  if (!wanted || !draws_on_stderr()) return;
  try {
    drawer_ = std::thread([this] { draw_until_stopped(); });
  } catch (const std::system_error&) {  // no thread to be had: no bar either
  }
}

Progress::~Progress() {
  if (!drawer_.joinable()) return;
  {
    const std::lock_guard lock(mutex_);
    stop_ = true;
    erase();
  }
  stopped_.notify_one();
  drawer_.join();
}

void Progress::next() {
  if (!drawer_.joinable()) return;
  const std::lock_guard lock(mutex_);
  const Clock::time_point now = Clock::now();
  double planned = 0;
  for (std::size_t i = 0; i < stage_; ++i) planned += plan_[i].share;
  if (planned > 0) pace_ = seconds(now - start_) / planned;
  stage_ = std::min(stage_ + 1, plan_.size());
  stage_start_ = reported_at_ = now;
  reported_ = 0;
  hidden_ = false;
}

void Progress::show(double done) {
  if (!drawer_.joinable()) return;
  const std::lock_guard lock(mutex_);
  reported_ = std::clamp(done, reported_, 1.0);
  reported_at_ = Clock::now();
}

void Progress::hide() {
  if (!drawer_.joinable()) return;
  const std::lock_guard lock(mutex_);
  hidden_ = true;
  erase();
}

std::function<void(std::string_view, double)> Progress::callback() {
  if (!drawer_.joinable()) return {};
  return [this](std::string_view, double done) { show(done); };
}

void Progress::draw_until_stopped() {
  std::unique_lock lock(mutex_);
  stopped_.wait_for(lock, 500ms, [this] { return stop_; });
  while (!stop_) {
    if (!hidden_) draw(Clock::now());
    stopped_.wait_for(lock, 100ms, [this] { return stop_; });
  }
}

double Progress::share_done(Clock::time_point now) const {
  double before = 0, all = 0;
  for (std::size_t i = 0; i < plan_.size(); ++i) {
    all += plan_[i].share;
    if (i + 1 < stage_) before += plan_[i].share;
  }
  const double planned = plan_[stage_ - 1].share;
  // What the stage has reported says more about its length than the plan, once it is not too
  // little.
  const double length =
      reported_ > 0.1 ? seconds(reported_at_ - stage_start_) / reported_ : planned * pace_;
  const double rest = std::max(1e-6, length * (1 - reported_));
  const double stage =
      reported_ + (1 - reported_) * expected_share(seconds(now - reported_at_) / rest);
  return all > 0 ? (before + stage * planned) / all : 0;
}

void Progress::draw(Clock::time_point now) {
  shown_ = std::clamp(share_done(now), shown_, 1.0);
  const std::size_t columns = columns_of_stderr();
  const std::size_t cells = std::clamp<std::size_t>(columns / 3, 8, 30);
  const auto full = static_cast<std::size_t>(shown_ * static_cast<double>(cells));
  const std::string line =
      fmt::format("[{:#<{}}{:.<{}}] {:3.0f}% {}  {}", "", full, "", cells - full, 100 * shown_,
                  plan_[stage_ - 1].name, subject_);
  // A line that wraps cannot be erased.
  fmt::print(stderr, "\r\033[K{}", fitting(line, columns - 1));
  std::fflush(stderr);
  drawn_ = true;
}

void Progress::erase() {
  if (!drawn_) return;
  std::fputs("\r\033[K", stderr);
  std::fflush(stderr);
  drawn_ = false;
}

}  // namespace clers::cli
