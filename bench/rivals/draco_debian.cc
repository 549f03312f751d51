// Two Dracos have the same symbols and cannot be linked into one program; the shared one is in a
// module that is loaded with its names kept to itself.
#include "bench/rivals/draco_debian.h"

#include <dlfcn.h>

namespace clers::bench {
namespace {

using Entry = void(std::vector<CodecEntry>&, std::string&);

struct Module {
  std::vector<CodecEntry> codecs;
  std::string version = "not built";

  Module() {
#ifdef CLERS_BENCH_DRACO_MODULE
    // Never closed: codecs made by it live as long as the program.
    void* handle = dlopen(CLERS_BENCH_DRACO_MODULE, RTLD_NOW | RTLD_LOCAL);
    void* entry = handle ? dlsym(handle, "clers_bench_draco_module") : nullptr;
    if (entry) {
      reinterpret_cast<Entry*>(entry)(codecs, version);
    } else {
      version = std::string("not loaded: ") + dlerror();
    }
#endif
  }
};

const Module& module() {
  static const Module loaded;
  return loaded;
}

}  // namespace

std::vector<CodecEntry> draco_debian_codecs() {
  return module().codecs;
}
std::string draco_debian_version() {
  return module().version;
}

}  // namespace clers::bench
