#include "codec/cli/progress.h"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>

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

}  // namespace

Progress::Progress(std::string subject, bool wanted)
    : subject_(std::move(subject)),
      wanted_(wanted && draws_on_stderr()),
      next_(Clock::now() + 500ms) {}

void Progress::show(std::string_view stage, double done) {
  if (!wanted_) return;
  const Clock::time_point now = Clock::now();
  if (now < next_) return;
  next_ = now + 100ms;
  constexpr int cells = 30;
  const int full = static_cast<int>(std::clamp(done, 0.0, 1.0) * cells);
  std::string line = fmt::format("[{:#<{}}{:.<{}}] {:3.0f}% {}  {}", "", full, "", cells - full,
                                 100 * done, stage, subject_);
  line.resize(
      std::min(line.size(), columns_of_stderr() - 1));  // a line that wraps cannot be erased
  std::fputs(("\r\033[K" + line).c_str(), stderr);
  std::fflush(stderr);
  drawn_ = true;
}

void Progress::clear() {
  if (!drawn_) return;
  std::fputs("\r\033[K", stderr);
  std::fflush(stderr);
  drawn_ = false;
}

std::function<void(std::string_view, double)> Progress::callback() {
  if (!wanted_) return {};
  return [this](std::string_view stage, double done) { show(stage, done); };
}

}  // namespace clers::cli
