// Colours of a comparison: hashes of what a renumbering keeps, and elements in classes by them.
//
// Different colours prove a difference. Equal ones prove nothing. Knows no mesh.
#ifndef CLERS_CODEC_COMPARISON_COLOURS_H
#define CLERS_CODEC_COMPARISON_COLOURS_H

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace clers::internal {

using Colour = std::uint64_t;

/// The finaliser of splitmix64 (Steele, Lea and Flood 2014): a bijection of 64 bits that mixes all.
constexpr Colour mix(Colour x) {
  x += 0x9e3779b97f4a7c15u;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

/// The colour of an ordered pair.
constexpr Colour combine(Colour a, Colour b) {
  return mix(a ^ (mix(b) * 3));
}

/// Elements sorted by colour, then by number.
using Classes = std::vector<std::pair<Colour, std::uint32_t>>;

Classes classes(const std::vector<Colour>& colours);
std::size_t count_classes(const Classes& sorted);

/// How often each colour occurs, compared; where that differs, says by which element: "`element` 7
/// of the first mesh has no counterpart with `what`". Precondition: both have the same size.
std::optional<std::string> histograms_differ(const Classes& a, const Classes& b,
                                             const std::string& element, const std::string& what);

}  // namespace clers::internal

#endif
