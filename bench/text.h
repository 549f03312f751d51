// Words that the tables share.
#ifndef CLERS_BENCH_TEXT_H
#define CLERS_BENCH_TEXT_H

#include <cstdio>
#include <string>

#include "bench/result.h"

namespace clers::bench {

template <class... T>
std::string format(const char* pattern, T... values) {
  char line[256];
  std::snprintf(line, sizeof line, pattern, values...);
  return line;
}

// What ratios are taken of; 0 where it is not known.
inline double size_of_file(const Result& r) {
  return double(r.trial.bytes);
}
inline double size_of_positions(const Result& r) {
  return double(r.trial.position_bytes);
}
inline double encode_speed(const Result& r) {
  return r.encode_mtri_s();
}
inline double decode_speed(const Result& r) {
  return r.decode_mtri_s();
}

/// draco-cl7: cl7; file-xz9e: xz9e
inline std::string short_name(const std::string& codec) {
  return codec.substr(codec.find('-') + 1);
}

}  // namespace clers::bench

#endif
