// Attributes of given values, for tests.
#ifndef CLERS_CODEC_TEST_ATTRIBUTE_H
#define CLERS_CODEC_TEST_ATTRIBUTE_H

#include <cstdint>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

#include "codec/mesh.h"

namespace clers::internal::test {

template <class T>
Attribute attribute(std::string name, Domain domain, Scalar scalar, unsigned components,
                    const std::vector<T>& values) {
  Attribute a{std::move(name), domain, scalar, static_cast<std::uint8_t>(components), {}};
  a.data.resize(values.size() * sizeof(T));
  if (!values.empty()) std::memcpy(a.data.data(), values.data(), a.data.size());
  return a;
}

}  // namespace clers::internal::test

#endif
