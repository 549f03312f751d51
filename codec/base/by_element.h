// Values by index as values of elements.
#ifndef CLERS_CODEC_BASE_BY_ELEMENT_H
#define CLERS_CODEC_BASE_BY_ELEMENT_H

#include <cstddef>
#include <cstring>

#include "codec/mesh.h"

namespace clers::internal {

/// A value for each element, in their order; zeros for those that have none. Precondition: it has
/// indices.
inline Attribute by_element(const Attribute& a) {
  Attribute result{a.name, a.domain, a.scalar, a.components, {}};
  const std::size_t stride = a.stride();
  result.data.resize(a.indices.size() * stride);
  for (std::size_t i = 0; i < a.indices.size(); ++i)
    if (a.indices[i] != no_value)
      std::memcpy(result.data.data() + i * stride, a.data.data() + a.indices[i] * stride, stride);
  return result;
}

}  // namespace clers::internal

#endif
