// Words that somebody may have meant.
#include "codec/cli/words.h"

#include <algorithm>
#include <utility>

namespace clers::cli {
namespace {

/// Optimal string alignment.
std::size_t distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before, last(b.size() + 1), row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    before = std::exchange(last, row);
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (a[i - 1] != b[j - 1])});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        row[j] = std::min(row[j], before[j - 2] + 1);
    }
  }
  return row.back();
}

}  // namespace

std::optional<std::string> closest(std::string_view typed, std::span<const std::string> words) {
  std::optional<std::string> best;
  std::size_t least = 0;
  for (const std::string& word : words) {
    const std::size_t d = distance(typed, word);
    if (3 * d <= word.size() && (!best || d < least)) {
      best = word;
      least = d;
    }
  }
  return best;
}

std::string list(std::span<const std::string> words, const char* last) {
  std::string out;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0) out += i + 1 == words.size() ? std::string(" ") + last + " " : ", ";
    out += words[i];
  }
  return out;
}

}  // namespace clers::cli
