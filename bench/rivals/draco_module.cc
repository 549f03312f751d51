// What the module with the distribution's Draco shows to the program that loads it.
#include "bench/rivals/draco.h"

extern "C" [[gnu::visibility("default")]] void clers_bench_draco_module(
    std::vector<clers::bench::CodecEntry>& codecs, std::string& version) {
  codecs = clers::bench::draco_codecs();
  version = clers::bench::draco_version() + " (the distribution's shared library)";
}
