// A word, and numbers behind it.
#include "codec/cli/precision.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <utility>

namespace clers::cli {
namespace {

template <class T>
std::optional<T> parsed(std::string_view text) {
  T number{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

/// Takes a word off the front.
bool take(std::string_view& text, std::string_view word) {
  if (!text.starts_with(word)) return false;
  text.remove_prefix(word.size());
  return true;
}

std::optional<Precision> parse_grid(std::string_view text) {
  const std::size_t colon = text.find(':');
  if (colon == text.npos) return std::nullopt;
  std::vector<double> origin;
  for (std::string_view rest = text.substr(0, colon);;) {
    const std::size_t comma = rest.find(',');
    const auto x = parsed<double>(rest.substr(0, comma));
    if (!x) return std::nullopt;
    origin.push_back(*x);
    if (comma == rest.npos) break;
    rest.remove_prefix(comma + 1);
  }
  const auto step = parsed<double>(text.substr(colon + 1));
  if (!step) return std::nullopt;
  return Precision::on_grid(std::move(origin), *step);
}

}  // namespace

const char precision_words[] =
    "lossless, q1 to q30, step<size>, error<size> or grid:<origin>:<step>";

std::optional<Precision> parse_precision(std::string_view text) {
  if (text == "lossless") return Precision::lossless();
  if (take(text, "grid:")) return parse_grid(text);
  if (take(text, "step")) {
    const auto size = parsed<double>(text);
    return size ? std::optional(Precision::of_step(*size)) : std::nullopt;
  }
  if (take(text, "error")) {
    const auto size = parsed<double>(text);
    return size ? std::optional(Precision::of_error(*size)) : std::nullopt;
  }
  if (!take(text, "q")) return std::nullopt;
  const auto bits = parsed<int>(text);
  return bits ? std::optional(Precision::of_bits(*bits)) : std::nullopt;
}

std::vector<FoundError> largest_errors(std::span<const MeshInfo> meshes) {
  std::vector<FoundError> sum;
  for (const MeshInfo& mesh : meshes)
    for (const AttributeInfo& a : mesh.attributes)
      if (a.error > 0) add(sum, {a.name, a.domain, a.error});
  return sum;
}

void add(std::vector<FoundError>& sum, const FoundError& found) {
  const auto same = std::find_if(sum.begin(), sum.end(), [&](const FoundError& other) {
    return other.attribute == found.attribute && other.domain == found.domain;
  });
  if (same == sum.end()) return sum.push_back(found);
  same->error = std::max(same->error, found.error);
}

std::string off_by(const FoundError& found) {
  return fmt::format("'{}' is off by {:.4g} at most", found.attribute, found.error);
}

}  // namespace clers::cli
