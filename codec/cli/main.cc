// The program clers: what must hold whatever the command.
#include <signal.h>

#include <exception>
#include <filesystem>
#include <new>
#include <stdexcept>
#include <string>

#include "codec/cli/command_line.h"
#include "codec/cli/commands.h"

namespace {

using clers::cli::Exit;

/// Errors are values; what is thrown all the same ends the program with a line, not with a core.
Exit failed(const std::string& why, Exit exit) {
  clers::cli::complain(why);
  return exit;
}

Exit run(int argc, char** argv) {
  try {
    return clers::cli::run(argc, argv);
  } catch (const std::bad_alloc&) {
    return failed("not enough memory", Exit::limit);
  } catch (const std::length_error&) {  // a container asked for more than there can be
    return failed("not enough memory", Exit::limit);
  } catch (const std::filesystem::filesystem_error& error) {
    return failed(error.what(), Exit::output);
  } catch (const std::exception& error) {
    return failed(std::string("a fault of clers: ") + error.what(), Exit::input);
  }
}

}  // namespace

int main(int argc, char** argv) {
  // A reader that leaves and a file that grows too large are failed writes, not silent deaths.
  ::signal(SIGPIPE, SIG_IGN);
  ::signal(SIGXFSZ, SIG_IGN);
  return static_cast<int>(run(argc, argv));
}
