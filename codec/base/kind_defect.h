// What is wrong with the kind of an attribute. A header alone, since codec/io uses it too: a shared
// library hides what is inside.
#ifndef CLERS_CODEC_BASE_KIND_DEFECT_H
#define CLERS_CODEC_BASE_KIND_DEFECT_H

#include <string>

#include "codec/mesh_view.h"

namespace clers::internal {

/// Says which of the numbers that describe an attribute is out of range ("domain 3, expected 0 to
/// 2"); empty if none is. To be asked before value_size(), which relies on them.
inline std::string kind_defect(const AttributeView& a) {
  const auto out_of_range = [](const char* what, unsigned value, unsigned first, unsigned last) {
    return std::string(what) + " " + std::to_string(value) + ", expected " + std::to_string(first) +
           " to " + std::to_string(last);
  };
  const unsigned domain = static_cast<unsigned>(a.domain), scalar = static_cast<unsigned>(a.scalar);
  if (domain >= domain_count) return out_of_range("domain", domain, 0, domain_count - 1);
  if (scalar >= scalar_count) return out_of_range("scalar", scalar, 0, scalar_count - 1);
  if (a.components == 0) return "0 components, expected 1 to 255";
  return {};
}

}  // namespace clers::internal

#endif
