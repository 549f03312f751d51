// Runs by where they start; those that reach into each other are looked at together.
#include "codec/gltf/overlaps.h"

#include <algorithm>
#include <map>
#include <tuple>

namespace clers::gltf {
namespace {

/// Whether runs, of which the first starts first, have a part each of one stride.
bool interleaved(const Layout& layout, std::vector<std::size_t> group) {
  const Run& lead = layout.runs[group[0]];
  const std::uint64_t stride = lead.stride;
  const auto offset = [&](std::size_t i) { return (layout.runs[i].start - lead.start) % stride; };
  std::sort(group.begin(), group.end(),
            [&](std::size_t a, std::size_t b) { return offset(a) < offset(b); });
  for (std::size_t i = 0; i < group.size(); ++i) {
    const Run& run = layout.runs[group[i]];
    const std::uint64_t next = i + 1 < group.size() ? offset(group[i + 1]) : stride;
    if (run.stride != stride || offset(group[i]) + run.size() > next) return false;
  }
  return true;
}

}  // namespace

Overlaps find_overlaps(const Layout& layout) {
  const std::vector<Run>& runs = layout.runs;
  Overlaps result{std::vector<std::size_t>(runs.size()), std::vector<bool>(runs.size())};
  using Key = std::tuple<std::size_t, std::uint64_t, std::uint64_t, std::uint64_t, Scalar, unsigned,
                         unsigned>;
  std::map<Key, std::size_t> known;
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const Run& r = runs[i];
    result.first[i] = i;
    if (!r.has_bytes()) continue;
    const auto [other, is_new] =
        known.emplace(Key(r.buffer, r.start, r.stride, r.count, r.scalar, r.columns, r.rows), i);
    result.first[i] = other->second;
    if (is_new) order.push_back(i);
  }
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::tuple(runs[a].buffer, runs[a].start, a) <
           std::tuple(runs[b].buffer, runs[b].start, b);
  });
  for (std::size_t at = 0; at < order.size();) {
    std::vector<std::size_t> group;
    std::uint64_t end = runs[order[at]].end();
    bool extended = false;
    do {
      extended = extended || layout.views[runs[order[at]].view].extended;
      end = std::max(end, runs[order[at]].end());
      group.push_back(order[at++]);
    } while (at < order.size() && runs[order[at]].buffer == runs[group[0]].buffer &&
             runs[order[at]].start < end);
    const bool alone = group.size() == 1 && runs[group[0]].count == 1;
    if (extended || !(alone || interleaved(layout, group)))
      for (const std::size_t i : group) result.fixed[i] = true;
  }
  for (std::size_t i = 0; i < runs.size(); ++i) result.fixed[i] = result.fixed[result.first[i]];
  return result;
}

}  // namespace clers::gltf
