// The library asserts what it is given: all of it is checked here.
#include "codec/meshopt/meshopt.h"

#include <meshoptimizer.h>

#include <string>

#include "codec/base/guarded.h"

namespace clers {
namespace CLERS_VISIBLE meshopt {
namespace {

/// No stream is shorter: a block of 256 vertices takes 4 bytes for each byte of one, a triangle one
/// byte.
constexpr std::size_t most_times = 64;

Failure<Error> wrong(std::string what) {
  return fail(ErrorCode::malformed, "EXT_meshopt_compression: " + std::move(what));
}

Expected<std::vector<std::byte>> decode(std::span<const std::byte> bytes, std::size_t count,
                                        std::size_t stride, std::string_view mode,
                                        std::string_view filter) {
  const bool attributes = mode == "ATTRIBUTES", triangles = mode == "TRIANGLES";
  if (!attributes && !triangles && mode != "INDICES")
    return fail(ErrorCode::unsupported,
                "EXT_meshopt_compression: no mode '" + std::string(mode) + "' is known");
  if (attributes ? stride == 0 || stride > 256 || stride % 4 != 0 : stride != 2 && stride != 4)
    return wrong("byteStride " + std::to_string(stride));
  if (triangles && count % 3 != 0)
    return wrong("triangles of " + std::to_string(count) + " indices");
  if (count > bytes.size() * most_times / stride)
    return wrong(std::to_string(bytes.size()) + " bytes cannot hold " + std::to_string(count) +
                 " elements");
  const bool plain = filter == "NONE", octahedral = filter == "OCTAHEDRAL",
             quaternion = filter == "QUATERNION", exponential = filter == "EXPONENTIAL";
  if (!plain && !octahedral && !quaternion && !exponential)
    return fail(ErrorCode::unsupported,
                "EXT_meshopt_compression: no filter '" + std::string(filter) + "' is known");
  if (!plain && !attributes) return wrong("indices with a filter");
  if ((octahedral && stride != 4 && stride != 8) || (quaternion && stride != 8))
    return wrong("byteStride " + std::to_string(stride) + " with this filter");

  std::vector<std::byte> values(count * stride);
  const auto* from = reinterpret_cast<const unsigned char*>(bytes.data());
  const int fault =
      attributes  ? meshopt_decodeVertexBuffer(values.data(), count, stride, from, bytes.size())
      : triangles ? meshopt_decodeIndexBuffer(values.data(), count, stride, from, bytes.size())
                  : meshopt_decodeIndexSequence(values.data(), count, stride, from, bytes.size());
  if (fault != 0) return wrong("meshoptimizer cannot decode it");
  if (octahedral) meshopt_decodeFilterOct(values.data(), count, stride);
  if (quaternion) meshopt_decodeFilterQuat(values.data(), count, stride);
  if (exponential) meshopt_decodeFilterExp(values.data(), count, stride);
  return values;
}

}  // namespace

Expected<std::vector<std::byte>> decode_for_gltf(std::span<const std::byte> bytes,
                                                 std::size_t count, std::size_t stride,
                                                 std::string_view mode, std::string_view filter) {
  return internal::guarded("decode a bufferView",
                           [&] { return decode(bytes, count, stride, mode, filter); });
}

}  // namespace meshopt
}  // namespace clers
