// What was measured, and how it is put out.
#ifndef CLERS_BENCH_RESULT_H
#define CLERS_BENCH_RESULT_H

#include <iosfwd>
#include <string>
#include <utility>
#include <vector>

#include "bench/timing.h"
#include "bench/trial.h"

namespace clers::bench {

/// One codec on one mesh in one mode.
struct Result {
  std::string mesh, family, codec;
  Mode mode = Mode::connectivity;
  std::uint64_t triangles = 0, vertices = 0;
  bool manifold = false, fanned = false;
  Trial trial;  ///< trial.failure set: nothing else is
  Timing encode, decode;

  bool failed() const { return !trial.failure.empty(); }
  double bits_per_triangle() const { return 8.0 * double(trial.bytes) / double(triangles); }
  double bits_per_vertex() const { return 8.0 * double(trial.bytes) / double(vertices); }
  double encode_mtri_s() const { return 1e-6 * double(triangles) / encode.even; }
  double decode_mtri_s() const { return 1e-6 * double(triangles) / decode.even; }
  double peak_bytes_per_triangle() const;
};

/// Where and with what it was measured.
struct Setting {
  std::string machine, system, compiler, flags;
  std::vector<std::pair<std::string, std::string>> versions;
  Sampling sampling;
};

void write_json(std::ostream& out, const Setting& setting, const std::vector<Result>& results);

/// The rows of one mesh in one mode, as they come.
void print_rows(std::ostream& out, const std::vector<Result>& rows);

/// Geometric means of the ratios to Draco, by class of mesh.
void print_means(std::ostream& out, const std::vector<Result>& results);

}  // namespace clers::bench

#endif
