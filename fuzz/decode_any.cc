// Any bytes are a file that decodes to valid meshes, or a named error.
#include <cstdint>
#include <cstdlib>
#include <span>

#include "codec/decode.h"
#include "codec/encode.h"
#include "codec/inspect.h"

namespace {

void require(bool yes) {
  if (!yes) std::abort();
}

void check(const clers::Mesh& mesh) {
  require(mesh.corners.size() % 3 == 0);
  for (std::size_t i = 0; i < mesh.corners.size(); ++i)
    require(mesh.corners[i] < mesh.vertex_count);
  for (const clers::Attribute& a : mesh.attributes) {
    const std::size_t count = a.domain == clers::Domain::vertex   ? mesh.vertex_count
                              : a.domain == clers::Domain::corner ? mesh.corners.size()
                                                                  : mesh.face_count();
    require(a.data.size() == count * a.stride());
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  clers::DecodeOptions options;
  options.limits.memory = std::uint64_t(64) << 20;
  options.limits.faces = 1u << 20;
  const auto bytes = std::as_bytes(std::span(data, size));
  auto meshes = clers::decode(bytes, options);
  if (!meshes) {
    require(meshes.error().code != clers::ErrorCode::internal);
    require(!clers::describe(meshes.error()).empty());
    return 0;
  }
  for (const clers::Mesh& mesh : *meshes) check(mesh);
  require(clers::inspect(bytes).ok());
  return 0;
}
