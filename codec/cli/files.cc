// Files read whole, and written atomically.
#include "codec/cli/files.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <filesystem>
#include <utility>

namespace clers::cli {
namespace {

constexpr std::size_t most_at_once = std::size_t{1} << 30;  // read and write may refuse 2 GiB

Failure<Stop> failed(Exit exit, const std::string& name, int error) {
  if (error == EPIPE) return stop(exit, "");  // who reads has seen enough: no reason to complain
  return stop(exit, name + ": " + std::strerror(error));
}

/// A descriptor that is closed when it goes.
class Descriptor {
 public:
  explicit Descriptor(int fd) : fd_(fd) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() { close(); }

  int get() const { return fd_; }
  /// Some file systems report a failed write only here.
  bool close() { return fd_ < 0 || ::close(std::exchange(fd_, -1)) == 0; }

 private:
  int fd_;
};

/// Sets errno when it fails.
bool write_all(int fd, std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t n = ::write(fd, bytes.data(), std::min(bytes.size(), most_at_once));
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return false;
    if (n == 0) {  // never of a write of some bytes, unless something is broken
      errno = EIO;
      return false;
    }
    bytes = bytes.subspan(static_cast<std::size_t>(n));
  }
  return true;
}

/// Where a path leads through symbolic links, whether or not there is anything: a new file is made
/// where a link leads. Ends at a link that cannot be followed, which opening it then reports.
std::filesystem::path followed(std::filesystem::path path) {
  constexpr int most_links = 40;  // as Linux
  for (int i = 0; i < most_links; ++i) {
    std::error_code none;
    const std::filesystem::path to = std::filesystem::read_symlink(path, none);
    if (none) break;
    path = path.parent_path() / to;  // `to` alone if it is absolute
  }
  return path;
}

std::filesystem::path directory_of(const std::filesystem::path& path) {
  return path.has_parent_path() ? path.parent_path() : std::filesystem::path(".");
}

/// Makes the new name itself survive a crash. Not every file system can; the content is safe
/// anyway.
void sync_directory(const std::filesystem::path& directory) {
  const Descriptor fd(::open(directory.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (fd.get() >= 0) ::fsync(fd.get());
}

// The temporary file that exists under a name, for the handler: a signal must not leave it behind.
char temporary_name[4096];
volatile sig_atomic_t temporary_exists = 0;

extern "C" void remove_temporary(int signal) {
  if (temporary_exists) ::unlink(temporary_name);
  ::signal(signal, SIG_DFL);
  ::raise(signal);
}

/// A new name beside the target, removed again unless it is given up by rename.
class Temporary {
 public:
  explicit Temporary(const std::filesystem::path& directory)
      : path_((directory / unique_name()).string()) {
    if (path_.size() >= sizeof temporary_name) return;
    std::memcpy(temporary_name, path_.c_str(), path_.size() + 1);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP})
      if (::signal(signal, remove_temporary) == SIG_IGN) ::signal(signal, SIG_IGN);
    temporary_exists = 1;
  }
  Temporary(const Temporary&) = delete;
  Temporary& operator=(const Temporary&) = delete;
  ~Temporary() {
    if (!renamed_) ::unlink(path_.c_str());
    temporary_exists = 0;
  }

  const char* path() const { return path_.c_str(); }

  /// Sets errno when it fails.
  bool become(const std::string& target, bool overwrite) {
    // link refuses an existing target, rename would replace it; not every file system can link.
    if (!overwrite && ::link(path(), target.c_str()) == 0) return true;
    if (!overwrite && errno == EEXIST) return false;
    renamed_ = ::rename(path(), target.c_str()) == 0;
    return renamed_;
  }

 private:
  /// Process ids are not enough: containers that share a directory do not share them.
  static std::string unique_name() {
    const auto now = std::chrono::steady_clock::now().time_since_epoch().count();
    return ".clers-" + std::to_string(::getpid()) + "-" + std::to_string(now) + ".tmp";
  }

  std::string path_;
  bool renamed_ = false;
};

/// The file is written without a name and gets one when it is complete, so that not even SIGKILL
/// leaves anything. False when this system cannot do it and nothing has happened; errno otherwise.
bool write_nameless(const std::string& target, const std::filesystem::path& directory,
                    std::span<const std::byte> bytes, bool overwrite, mode_t mode, int& error) {
#ifdef O_TMPFILE
  Descriptor fd(::open(directory.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, mode));
  if (fd.get() < 0) return false;
  if (overwrite) ::fchmod(fd.get(), mode);
  if (!write_all(fd.get(), bytes) || ::fsync(fd.get()) != 0) {
    error = errno;
    return true;
  }
  const std::string self = "/proc/self/fd/" + std::to_string(fd.get());
  const auto link_to = [&](const char* path) {
    return ::linkat(AT_FDCWD, self.c_str(), AT_FDCWD, path, AT_SYMLINK_FOLLOW) == 0;
  };
  if (!overwrite) {
    if (link_to(target.c_str())) return true;
    if (errno != EEXIST) return false;
    error = errno;
    return true;
  }
  Temporary temporary(directory);
  if (!link_to(temporary.path())) return false;
  if (!temporary.become(target, overwrite)) error = errno;
  return true;
#else
  static_cast<void>(target), static_cast<void>(directory), static_cast<void>(bytes);
  static_cast<void>(overwrite), static_cast<void>(mode), static_cast<void>(error);
  return false;
#endif
}

/// The same through a named temporary file. Returns errno, 0 when done.
int write_named(const std::string& target, const std::filesystem::path& directory,
                std::span<const std::byte> bytes, bool overwrite, mode_t mode) {
  Temporary temporary(directory);
  Descriptor fd(::open(temporary.path(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, mode));
  if (fd.get() < 0) return errno;
  if (overwrite) ::fchmod(fd.get(), mode);
  if (!write_all(fd.get(), bytes) || ::fsync(fd.get()) != 0 || !fd.close() ||
      !temporary.become(target, overwrite))
    return errno;
  return 0;
}

}  // namespace

std::string input_name(const std::string& path) {
  return path == "-" ? "standard input" : path;
}

std::string output_name(const std::string& path) {
  return path == "-" ? "standard output" : path;
}

Outcome<Bytes> read_file(const std::string& path) {
  Descriptor opened(path == "-" ? -1 : ::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  const int fd = path == "-" ? STDIN_FILENO : opened.get();
  struct stat status = {};
  if (fd < 0 || ::fstat(fd, &status) != 0) return failed(Exit::input, input_name(path), errno);
  // A byte more than the file has, so that the read that finds the end needs no further room.
  Bytes bytes(S_ISREG(status.st_mode) ? static_cast<std::size_t>(status.st_size) + 1 : 1 << 16);
  std::size_t size = 0;
  for (;;) {
    if (size == bytes.size()) bytes.resize(2 * bytes.size());
    const ssize_t n = ::read(fd, bytes.data() + size, std::min(bytes.size() - size, most_at_once));
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return failed(Exit::input, input_name(path), errno);
    if (n == 0) break;
    size += static_cast<std::size_t>(n);
  }
  bytes.resize(size);
  return bytes;
}

FileIds ids_of(std::span<const std::string> paths) {
  FileIds ids;
  for (const std::string& path : paths) {
    struct stat status = {};
    if (path != "-" && ::stat(path.c_str(), &status) == 0 && S_ISREG(status.st_mode))
      ids.emplace(status.st_dev, status.st_ino);
  }
  return ids;
}

Outcome<Done> remove_input(const std::string& path) {
  if (::unlink(path.c_str()) != 0) return failed(Exit::output, path, errno);
  return Done{};
}

Outcome<Done> check_output(const std::string& path, bool overwrite, const FileIds& inputs) {
  if (path == "-") return Done{};
  struct stat status = {};
  if (::stat(path.c_str(), &status) == 0) {
    if (S_ISDIR(status.st_mode)) return failed(Exit::output, path, EISDIR);
    if (!S_ISREG(status.st_mode)) return Done{};
    if (inputs.contains({status.st_dev, status.st_ino}))
      return stop(Exit::usage,
                  path + ": is an input, which is never overwritten; -o names another output");
    if (!overwrite) return stop(Exit::usage, path + ": exists; -f overwrites it");
    return Done{};
  }
  if (errno != ENOENT) return failed(Exit::output, path, errno);
  const std::filesystem::path directory = directory_of(followed(path));
  if (::stat(directory.c_str(), &status) != 0) return failed(Exit::output, path, errno);
  if (!S_ISDIR(status.st_mode)) return failed(Exit::output, path, ENOTDIR);
  if (::access(directory.c_str(), W_OK | X_OK) != 0) return failed(Exit::output, path, errno);
  return Done{};
}

Outcome<Done> write_file(const std::string& path, std::span<const std::byte> bytes,
                         bool overwrite) {
  if (path == "-") {
    if (!write_all(STDOUT_FILENO, bytes)) return failed(Exit::output, output_name(path), errno);
    return Done{};
  }
  struct stat status = {};
  const bool exists = ::stat(path.c_str(), &status) == 0;
  if (exists && !S_ISREG(status.st_mode)) {
    Descriptor fd(::open(path.c_str(), O_WRONLY | O_CLOEXEC));
    if (fd.get() < 0 || !write_all(fd.get(), bytes) || !fd.close())
      return failed(Exit::output, path, errno);
    return Done{};
  }
  // Through a symbolic link, the file that it leads to is made or replaced, not the link.
  const std::filesystem::path target = followed(path);
  const std::filesystem::path directory = directory_of(target);
  const bool replace = overwrite && exists;
  const mode_t mode = replace ? status.st_mode & 07777 : 0666;

  int error = 0;
  if (!write_nameless(target.string(), directory, bytes, replace, mode, error))
    error = write_named(target.string(), directory, bytes, replace, mode);
  if (error == EEXIST && !overwrite) return stop(Exit::usage, path + ": exists; -f overwrites it");
  if (error != 0) return failed(Exit::output, path, error);
  sync_directory(directory);
  return Done{};
}

Outcome<Done> print(std::string_view text) {
  if (!write_all(STDOUT_FILENO, std::as_bytes(std::span(text))))
    return failed(Exit::output, output_name("-"), errno);
  return Done{};
}

}  // namespace clers::cli
