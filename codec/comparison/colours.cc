// Classes by sorting.
#include "codec/comparison/colours.h"

#include <algorithm>

namespace clers::internal {

Classes classes(const std::vector<Colour>& colours) {
  Classes sorted(colours.size());
  for (std::size_t i = 0; i < colours.size(); ++i)
    sorted[i] = {colours[i], static_cast<std::uint32_t>(i)};
  std::sort(sorted.begin(), sorted.end());
  return sorted;
}

std::size_t count_classes(const Classes& sorted) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < sorted.size(); ++i)
    count += i == 0 || sorted[i].first != sorted[i - 1].first;
  return count;
}

std::optional<std::string> histograms_differ(const Classes& a, const Classes& b,
                                             const std::string& element, const std::string& what) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i].first == b[i].first) continue;
    const bool in_first = a[i].first < b[i].first;  // the smaller colour lacks a partner
    return element + " " + std::to_string((in_first ? a : b)[i].second) + " of the " +
           (in_first ? "first" : "second") + " mesh has no counterpart with " + what;
  }
  return std::nullopt;
}

}  // namespace clers::internal
