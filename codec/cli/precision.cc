// A word, and numbers behind it.
#include "codec/cli/precision.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
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

/// A number that is finite and more than 0.
std::optional<double> parsed_size(std::string_view text) {
  const auto size = parsed<double>(text);
  return size && *size > 0 && std::isfinite(*size) ? size : std::nullopt;
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
    if (!x || !std::isfinite(*x)) return std::nullopt;
    origin.push_back(*x);
    if (comma == rest.npos) break;
    rest.remove_prefix(comma + 1);
  }
  const auto step = parsed_size(text.substr(colon + 1));
  if (!step) return std::nullopt;
  return Precision::on_grid(std::move(origin), *step);
}

}  // namespace

const char precision_words[] =
    "lossless, q1 to q30, step<size>, error<size> or grid:<origin>:<step>";
const char attribute_precision_words[] =
    "lossless, q1 to q30, step<size>, error<size>, grid:<origin>:<step>, oct2 to oct20 or "
    "recompute<degrees>";

std::optional<Precision> parse_precision(std::string_view text) {
  if (text == "lossless") return Precision::lossless();
  if (take(text, "grid:")) return parse_grid(text);
  if (take(text, "step")) {
    const auto size = parsed_size(text);
    return size ? std::optional(Precision::of_step(*size)) : std::nullopt;
  }
  if (take(text, "error")) {
    const auto size = parsed_size(text);
    return size ? std::optional(Precision::of_error(*size)) : std::nullopt;
  }
  if (take(text, "recompute")) {
    const auto degrees = parsed_size(text);
    return degrees && *degrees <= 180 ? std::optional(Precision::recomputed(*degrees))
                                      : std::nullopt;
  }
  if (take(text, "oct")) {
    const auto bits = parsed<int>(text);
    return bits && *bits >= min_direction_bits && *bits <= max_direction_bits
               ? std::optional(Precision::of_directions(*bits))
               : std::nullopt;
  }
  if (!take(text, "q")) return std::nullopt;
  const auto bits = parsed<int>(text);
  return bits && *bits >= min_bits && *bits <= max_bits ? std::optional(Precision::of_bits(*bits))
                                                        : std::nullopt;
}

std::string in_words(double error, ErrorMeasure measure) {
  if (measure == ErrorMeasure::difference) return fmt::format("{:.4g}", error);
  return fmt::format("{:.4g} degrees", error);
}

std::vector<FoundError> largest_errors(std::span<const MeshInfo> meshes) {
  std::vector<FoundError> sum;
  for (const MeshInfo& mesh : meshes)
    for (const AttributeInfo& a : mesh.attributes)
      if (a.error > 0) add(sum, {a.name, a.domain, a.error, a.measure});
  return sum;
}

void add(std::vector<FoundError>& sum, const FoundError& found) {
  const auto same = std::find_if(sum.begin(), sum.end(), [&](const FoundError& other) {
    return other.attribute == found.attribute && other.domain == found.domain &&
           other.measure == found.measure;
  });
  if (same == sum.end()) return sum.push_back(found);
  same->error = std::max(same->error, found.error);
}

std::string off_by(const FoundError& found) {
  return fmt::format("'{}' is off by {} at most", found.attribute,
                     in_words(found.error, found.measure));
}

}  // namespace clers::cli
