#include "bench/result.h"

#include <algorithm>

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

std::vector<std::string> groups_of(const Result& r) {
  std::vector<std::string> groups;
  if (r.draco_connectivity < 500) return groups;
  if (!r.manifold) {
    if (r.triangles >= 2000) groups.push_back(not_manifold);
    return groups;
  }
  groups.push_back(group_names[0]);
  if (r.mesh.find("components-plant") == std::string::npos) groups.push_back(group_names[1]);
  for (const char* part : {"bunny", "igea", "horse", "pizza", "boot", "rocker", "st-helens",
                           "teeth", "armadillo", "turbine"})
    if (r.mesh.find(part) != std::string::npos) {
      groups.push_back(group_names[2]);
      break;
    }
  return groups;
}

bool in_group(const Result& r, const std::string& group) {
  const std::vector<std::string> groups = groups_of(r);
  return std::find(groups.begin(), groups.end(), group) != groups.end();
}

}  // namespace clers::bench
