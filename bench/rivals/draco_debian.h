// The distribution's binary of Draco: a second row beside the one built with our flags.
#ifndef CLERS_BENCH_RIVALS_DRACO_DEBIAN_H
#define CLERS_BENCH_RIVALS_DRACO_DEBIAN_H

#include <string>
#include <vector>

#include "bench/codec.h"

namespace clers::bench {

/// draco-debian-standard, ...: as draco_codecs(). Empty if the module was not built.
std::vector<CodecEntry> draco_debian_codecs();
std::string draco_debian_version();

}  // namespace clers::bench

#endif
