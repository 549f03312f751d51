#include "bench/result.h"

#include <algorithm>
#include <initializer_list>

namespace clers::bench {

double Result::peak_bytes_per_triangle() const {
  return double(std::max(trial.encode_peak, trial.decode_peak)) / double(triangles);
}

std::string Setting::rivals() const {
  std::string line;
  for (const auto& [what, version] : versions) {
    if (what == "clers" || what == "draco-debian") continue;
    line += (line.empty() ? "" : ", ") + what + " " + version.substr(0, version.find(' '));
  }
  return line;
}

Result least_of(const std::vector<Result>& rows) {
  Result least;
  for (const Result& r : rows) {
    const Fidelity& f = r.trial.fidelity;
    if (r.ours() || r.failed() || f.triangles_lost + f.triangles_added + f.vertices_added ||
        f.positions_off)
      continue;
    if (least.codec.empty() || r.trial.bytes < least.trial.bytes) least = r;
  }
  if (least.codec.empty()) {
    least = rows.front();
    least.trial = {};
    least.trial.failure = "no rival gives the mesh back";
  }
  least.codec = least_rival;
  least.timed = false;
  return least;
}

std::vector<std::string> references(Mode mode) {
  switch (mode) {
    case Mode::connectivity: return {"draco-standard", "draco-valence", least_rival};
    case Mode::file: return {"file-zstd19", "file-xz9e", least_rival};
    default: return {"draco-cl7", "draco-cl10", least_rival};
  }
}

namespace {

constexpr const char *manifold = "manifold", *without_plant = "manifold without the plant",
                     *irregular = "irregular manifold", *plain = "no mirror, grid, copies",
                     *structured = "mirror, grid or copies", *files = "files",
                     *by_vertex = "no values of corners";

bool named(const Result& r, std::initializer_list<const char*> parts) {
  return std::any_of(parts.begin(), parts.end(),
                     [&](const char* part) { return r.mesh.find(part) != std::string::npos; });
}

}  // namespace

std::vector<std::string> group_names(Mode mode) {
  switch (mode) {
    case Mode::connectivity: return {manifold, without_plant, irregular, not_manifold};
    case Mode::file: return {files, by_vertex};
    default: return {manifold, plain, structured, not_manifold};
  }
}

std::vector<std::string> groups_of(const Result& r) {
  if (r.mode == Mode::file) {
    if (r.vertices < 1000) return {};
    return r.corner_values ? std::vector<std::string>{files}
                           : std::vector<std::string>{files, by_vertex};
  }
  if (r.draco_connectivity < 500) return {};
  if (!r.manifold)
    return r.triangles < 2000 ? std::vector<std::string>{} : std::vector<std::string>{not_manifold};
  std::vector<std::string> groups = {manifold};
  if (r.mode == Mode::connectivity) {
    if (!named(r, {"components-plant"})) groups.push_back(without_plant);
    if (named(r, {"bunny", "igea", "horse", "pizza", "boot", "rocker", "st-helens", "teeth",
                  "armadillo", "turbine"}))
      groups.push_back(irregular);
  } else {
    groups.push_back(named(r, {"teddy", "spot", "beetle", "frog", "tray", "rocker", "st-helens",
                               "components-plant"})
                         ? structured
                         : plain);
  }
  return groups;
}

bool in_group(const Result& r, const std::string& group) {
  const std::vector<std::string> groups = groups_of(r);
  return std::find(groups.begin(), groups.end(), group) != groups.end();
}

}  // namespace clers::bench
