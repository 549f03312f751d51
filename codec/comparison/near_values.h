// Numbers of two meshes that agree within a tolerance, as colours. Knows one component at a time.
#ifndef CLERS_CODEC_COMPARISON_NEAR_VALUES_H
#define CLERS_CODEC_COMPARISON_NEAR_VALUES_H

#include <cstddef>
#include <vector>

#include "codec/comparison/colours.h"
#include "codec/mesh.h"

namespace clers::internal {

/// Which numbers get the same colour.
enum class Nearness {
  /// All that links of two numbers, one of each mesh and within the tolerance, connect: different
  /// colours prove that one cannot become the other.
  linked,
  /// Each number of the first mesh and the nearest of the second, the lesser or the greater of two
  /// that are as near. Proves nothing, and is right where the second mesh holds what the numbers of
  /// the first were rounded to.
  nearest_or_lesser,
  nearest_or_greater,
};

/// Combines the colour of each element with that of a component of its value. Both attributes have
/// the type of `a`. Cost: two sorts.
void add_near_values(const Attribute& a, const Attribute& b, std::size_t component,
                     double tolerance, Nearness nearness, std::vector<Colour>& colours_a,
                     std::vector<Colour>& colours_b);

}  // namespace clers::internal

#endif
