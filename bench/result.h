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
  std::uint64_t draco_connectivity = 0;  ///< bytes draco-valence takes for the mesh; 0: it fails
  Trial trial;                           ///< trial.failure set: nothing else is
  Samples encode_samples, decode_samples;
  Timing encode, decode;  ///< their summaries

  bool failed() const { return !trial.failure.empty(); }
  double bits_per_triangle() const { return 8.0 * double(trial.bytes) / double(triangles); }
  double bits_per_vertex() const { return 8.0 * double(trial.bytes) / double(vertices); }
  double encode_mtri_s() const { return 1e-6 * double(triangles) / encode.quiet; }
  double decode_mtri_s() const { return 1e-6 * double(triangles) / decode.quiet; }
  double peak_bytes_per_triangle() const;
};

/// Where and with what it was measured.
struct Setting {
  std::string machine, system, compiler, flags;
  std::vector<std::pair<std::string, std::string>> versions;
  int passes = 1;
  Sampling sampling;  ///< in all passes together

  /// The rivals with their versions on one line, for the heads of tables.
  std::string rivals() const;
};

/// The sets of meshes over which means are taken and that the result's mesh is in. Only meshes
/// whose connectivity takes Draco 500 bytes or more: below, headers decide and not coding.
///
/// The irregular ones are scans, isosurfaces and a TIN that no predictor gets much out of. One mesh
/// of 2 229 equal components (the plant) is so far from all others that it bends any mean, so
/// there is one without it. Meshes that are not manifold are apart, and have 2 000 triangles or
/// more: what a rival gives back there is often another mesh.
std::vector<std::string> groups_of(const Result& result);
bool in_group(const Result& result, const std::string& group);

/// The names of the groups, in the order of tables.
inline constexpr const char* not_manifold = "not manifold";
inline constexpr const char* group_names[] = {"manifold", "manifold without the plant",
                                              "irregular manifold", not_manifold};

void write_json(std::ostream& out, const Setting& setting, const std::vector<Result>& results);

/// The rows of one mesh in one mode, as they come.
void print_rows(std::ostream& out, const Setting& setting, const std::vector<Result>& rows);

/// Geometric means of the ratios to Draco, by class of mesh.
void print_means(std::ostream& out, const Setting& setting, const std::vector<Result>& results);

}  // namespace clers::bench

#endif
