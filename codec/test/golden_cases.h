// What golden_test encodes: every kind of mesh, attribute and option at least once.
#ifndef CLERS_CODEC_TEST_GOLDEN_CASES_H
#define CLERS_CODEC_TEST_GOLDEN_CASES_H

#include <string>
#include <vector>

#include "codec/encode.h"
#include "codec/mesh.h"

namespace clers::test {

struct GoldenCase {
  std::string name;  ///< unique, without tabs
  std::vector<Mesh> meshes;
  EncodeOptions options;
};

/// The same everywhere: made of integers, and of floats that are multiples of 1/1024.
std::vector<GoldenCase> golden_cases();

}  // namespace clers::test

#endif
