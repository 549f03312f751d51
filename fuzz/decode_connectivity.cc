// Any bytes behind the header of encoded connectivity are a surface, or a named error: what the
// checksums keep from decode_any. What decodes is a manifold that can be coded again.
#include <cstdint>
#include <cstdlib>
#include <span>
#include <vector>

#include "codec/base/budget.h"
#include "codec/connectivity/connectivity.h"
#include "codec/test/coded_surface.h"

namespace {

void require(bool yes) {
  if (!yes) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto bytes = std::as_bytes(std::span(data, size));
  auto header = clers::internal::read_connectivity_header(bytes, 0);
  if (!header) return 0;
  const std::uint64_t corner_count = 3 * std::uint64_t(header->faces);
  const clers::internal::Budget budget({}, size);
  if (!budget.check(corner_count * (2 * sizeof(std::uint32_t) + sizeof(clers::HalfEdge)) +
                    header->vertices * sizeof(std::uint32_t) +
                    clers::internal::connectivity_memory(*header, true)))
    return 0;
  std::vector<std::uint32_t> corners(3 * std::size_t(header->faces)), again(corners.size());
  std::vector<clers::HalfEdge> twins(corners.size());
  std::vector<std::uint32_t> introduced_by(header->vertices);
  auto counts =
      clers::internal::decode_connectivity(bytes, 0, *header, corners, twins, introduced_by);
  auto plain = clers::internal::decode_connectivity(bytes, 0, *header, again);
  require(counts.ok() == plain.ok());
  if (!counts) {
    require(counts.error().code == plain.error().code);
    require(counts.error().code != clers::ErrorCode::internal);
    return 0;
  }
  require(corners == again);
  require(clers::internal::fault_of({corners, twins, introduced_by}).empty());
  const auto dest = [&](clers::HalfEdge h) { return corners[clers::lnext(h).index()]; };
  for (std::uint32_t i = 0; i < corners.size(); ++i) {
    require(corners[i] < header->vertices);
    const clers::HalfEdge h(i), t = twins[i];
    require(corners[i] != dest(h));
    if (!t) continue;
    require(twins[t.index()] == h && corners[t.index()] == dest(h) && dest(t) == corners[i]);
  }
  auto coded = clers::internal::encode_connectivity({corners, twins, header->vertices}, 5);
  require(coded.ok());
  require(coded->gates.size() == header->faces && coded->vertices.size() == header->vertices);
  return 0;
}
