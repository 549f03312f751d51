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
  bool manifold = false, fanned = false, corner_values = false;
  std::uint64_t draco_connectivity = 0;  ///< bytes draco-valence takes for the mesh; 0: it fails
  bool timed = true;                     ///< false: only bytes can be compared
  Trial trial;                           ///< trial.failure set: nothing else is
  Samples encode_samples, decode_samples;
  Timing encode, decode;  ///< their summaries

  bool failed() const { return !trial.failure.empty(); }
  double bits_per_triangle() const { return 8.0 * double(trial.bytes) / double(triangles); }
  double bits_per_vertex() const { return 8.0 * double(trial.bytes) / double(vertices); }
  double position_bits_per_vertex() const {
    return 8.0 * double(trial.position_bytes) / double(vertices);
  }
  /// 0: not timed.
  double encode_mtri_s() const { return timed ? 1e-6 * double(triangles) / encode.quiet : 0; }
  double decode_mtri_s() const { return timed ? 1e-6 * double(triangles) / decode.quiet : 0; }
  double peak_bytes_per_triangle() const;
  bool ours() const { return codec.rfind("clers", 0) == 0; }
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

/// The row that the best of the rivals makes on a mesh: the least bytes of all that gave every
/// triangle back once, and nothing moved.
inline constexpr const char* least_rival = "least-rival";
Result least_of(const std::vector<Result>& rows);

/// The rivals that ratios are taken to: a fast one, a small one, the best on each mesh.
std::vector<std::string> references(Mode mode);

/// The sets of meshes over which means are taken and that the result's mesh is in. Where headers
/// decide and not coding it is in none: files of less than 1,000 vertices, and otherwise meshes
/// whose connectivity takes Draco less than 500 bytes.
///
/// Connectivity: the irregular ones are scans, isosurfaces and a TIN that no predictor gets much
/// out of. One mesh of 2 229 equal components (the plant) is so far from all others that it bends
/// any mean, so there is one without it. Positions: those with a mirror image, on a coarse grid or
/// in copies are the corpus's luck, so there is a mean without them. Meshes that are not manifold
/// are apart, and have 2 000 triangles or more: what a rival gives back there is often another
/// mesh. Files: those with values of corners are apart.
std::vector<std::string> groups_of(const Result& result);
bool in_group(const Result& result, const std::string& group);

/// The names of a mode's groups, in the order of tables.
inline constexpr const char* not_manifold = "not manifold";
std::vector<std::string> group_names(Mode mode);

void write_json(std::ostream& out, const Setting& setting, const std::vector<Result>& results);

/// The rows of one mesh in one mode, as they come.
void print_rows(std::ostream& out, const Setting& setting, const std::vector<Result>& rows);

/// By mode: geometric means of the ratios to the references by group and class, wins and losses, a
/// line for each mesh.
void print_means(std::ostream& out, const Setting& setting, const std::vector<Result>& results);

}  // namespace clers::bench

#endif
