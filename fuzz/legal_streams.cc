// Bytes choose the symbols and answers of a legal stream. It decodes to the surface that its
// symbols say, which is coded and comes back, and from there to the same bytes.
#include "codec/test/legal_streams.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <utility>
#include <vector>

#include "codec/connectivity/connectivity.h"
#include "codec/test/coded_surface.h"
#include "codec/test/correspondence.h"

namespace {

using clers::HalfEdge;

void require(bool yes) {
  if (!yes) std::abort();
}

struct Surface {
  std::vector<std::uint32_t> corners;
  std::vector<HalfEdge> twins;
  std::uint32_t vertices = 0;
};

Surface decoded(std::span<const std::byte> bytes) {
  const auto header = clers::internal::read_connectivity_header(bytes, 0);
  require(header.ok());
  Surface s;
  s.vertices = header->vertices;
  s.corners.resize(3 * std::size_t(header->faces));
  s.twins.resize(s.corners.size());
  std::vector<std::uint32_t> introduced_by(s.vertices);
  require(clers::internal::decode_connectivity(bytes, 0, *header, s.corners, s.twins, introduced_by)
              .ok());
  require(clers::internal::fault_of({s.corners, s.twins, introduced_by}).empty());
  return s;
}

clers::internal::EncodedConnectivity encoded(const Surface& s, int level) {
  std::vector<HalfEdge> twins = s.twins;
  auto coded = clers::internal::encode_connectivity({s.corners, twins, s.vertices}, level);
  require(coded.ok());
  return std::move(*coded);
}

}  // namespace

/// One byte: level. Then choices, a byte each or more where there is more to choose from.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < 2) return 0;
  const int level = data[0] % 9 + 1;
  std::size_t next = 1;
  const auto byte = [&] { return next < size ? data[next++] : std::uint8_t(0); };
  const auto choose = [&](std::uint32_t n) {
    std::uint32_t value = byte();
    for (std::uint32_t reach = 256; reach < n; reach <<= 8) value = value << 8 | byte();
    return value % n;
  };
  const auto faces = static_cast<std::uint32_t>(std::min<std::size_t>(size, 4096));
  const clers::internal::LegalStream stream = clers::internal::legal_stream(faces, choose);
  const Surface in = decoded(stream.bytes);
  require(in.vertices == stream.vertices && in.corners == stream.corners &&
          in.twins == stream.twins);

  const clers::internal::EncodedConnectivity coded = encoded(in, level);
  const Surface out = decoded(coded.bytes);
  require(
      clers::internal::difference_of(in.corners, in.twins, coded, out.corners, out.twins).empty());
  require(encoded(out, level).bytes == coded.bytes);
  return 0;
}
