// The system that the numbers of a component are likely to have been written in.
#ifndef CLERS_CODEC_ATTRIBUTES_FIND_SYSTEM_H
#define CLERS_CODEC_ATTRIBUTES_FIND_SYSTEM_H

#include <cstddef>
#include <span>

#include "codec/attributes/number_system.h"

namespace clers::internal {

/// The numbers of one component among those of others.
struct ComponentView {
  std::span<const std::byte> values;
  Scalar scalar;
  std::size_t components, component;

  std::size_t count() const { return values.size() / (components * size_of(scalar)); }
};

/// The system in which a sample of the numbers takes the fewest bits; all of them if they are few.
/// `first` is an N that fits, not the least. Cost: linear in the number of values for types of
/// integers; for floats constant, but for a look whether all are equal.
NumberSystem find_system(const ComponentView& view);

}  // namespace clers::internal

#endif
