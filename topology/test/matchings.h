// Every way to glue a few triangles.
#ifndef CLERS_TOPOLOGY_TEST_MATCHINGS_H
#define CLERS_TOPOLOGY_TEST_MATCHINGS_H

#include <cstdint>
#include <utility>
#include <vector>

namespace clers::test {

/// Pairs of half-edges to be glued; no half-edge twice.
using Matching = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

namespace matchings {
template <class Visit>
void extend(std::vector<bool>& used, std::uint32_t from, Matching& pairs, Visit& visit) {
  while (from < used.size() && used[from]) ++from;
  if (from == used.size()) {
    visit(std::as_const(pairs));
    return;
  }
  used[from] = true;
  extend(used, from + 1, pairs, visit);
  for (std::uint32_t other = from + 1; other < used.size(); ++other) {
    if (used[other]) continue;
    used[other] = true;
    pairs.emplace_back(from, other);
    extend(used, from + 1, pairs, visit);
    pairs.pop_back();
    used[other] = false;
  }
  used[from] = false;
}
}  // namespace matchings

/// Calls visit with every partial matching of the half-edges of so many triangles: 4, 76, 2620 and
/// 140152 of one to four.
template <class Visit>
void for_each_matching(std::uint32_t faces, Visit visit) {
  std::vector<bool> used(3 * std::size_t{faces});
  Matching pairs;
  matchings::extend(used, 0, pairs, visit);
}

}  // namespace clers::test

#endif
