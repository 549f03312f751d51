// Any index buffer is coded and comes back, or is refused with a named error; twice the same bytes.
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <span>

#include "codec/compare.h"
#include "codec/decode.h"
#include "codec/encode.h"

namespace {

void require(bool yes) {
  if (!yes) std::abort();
}

/// One byte: vertices. One: level. Then three bytes a face, or for a zero first byte a strip grown
/// at random boundary edges, which is manifold more often. What is left are bits of positions.
clers::Mesh mesh_from(std::span<const std::uint8_t> in, int& level) {
  clers::Mesh mesh;
  if (in.size() < 4) return mesh;
  mesh.vertex_count = in[0] + 3u;
  level = in[1] % 9 + 1;
  const bool grow = in[2] & 1;
  in = in.subspan(3);
  const std::size_t faces = std::min<std::size_t>(in.size() / 4, 400);
  if (grow) {
    std::vector<std::uint32_t> ring = {0, 1, 2};
    std::uint32_t next = 3;
    mesh.corners = {0, 1, 2};
    for (std::size_t f = 0; f < faces; ++f) {
      const std::size_t i = in[f] % ring.size(), n = ring.size();
      const std::uint32_t a = ring[i], b = ring[(i + 1) % n], c = ring[(i + 2) % n];
      if (in[f] & 0x80 && n > 3) {  // close the corner at b
        mesh.corners.insert(mesh.corners.end(), {b, a, c});
        ring.erase(ring.begin() + static_cast<std::ptrdiff_t>((i + 1) % n));
      } else {
        mesh.corners.insert(mesh.corners.end(), {b, a, next});
        ring.insert(ring.begin() + static_cast<std::ptrdiff_t>(i + 1), next++);
      }
    }
    mesh.vertex_count = std::max(mesh.vertex_count, next);
  } else {
    for (std::size_t i = 0; i < 3 * faces; ++i) mesh.corners.push_back(in[i] % mesh.vertex_count);
  }
  clers::Attribute position{"position", clers::Domain::vertex, clers::Scalar::float32, 3, {}};
  position.data.resize(12 * std::size_t(mesh.vertex_count));
  for (std::size_t i = 0; i < position.data.size() && !in.empty(); ++i)
    position.data[i] = static_cast<std::byte>(in[i % in.size()] * (i / in.size() + 1));
  mesh.attributes.push_back(std::move(position));
  return mesh;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  clers::EncodeOptions options;
  const clers::Mesh mesh = mesh_from(std::span(data, size), options.level);
  auto coded = clers::encode(std::span(&mesh, 1), options);
  if (!coded) {
    require(coded.error().code != clers::ErrorCode::internal);
    return 0;
  }
  auto again = clers::encode(std::span(&mesh, 1), options);
  require(again.ok() && again->bytes == coded->bytes);
  auto out = clers::decode(coded->bytes);
  require(out.ok() && out->size() == 1);
  require(clers::compare(mesh, (*out)[0]).verdict != clers::Verdict::different);
  const clers::Permutation& order = coded->permutations[0];
  for (std::size_t i = 0; i < mesh.corners.size(); ++i)
    require(order.vertices[(*out)[0].corners[i]] ==
            mesh.corners[3 * std::size_t(order.faces[i / 3]) +
                         (order.first_corners[i / 3] + i % 3) % 3]);
  for (std::uint32_t v = 0; v < mesh.vertex_count; ++v)
    require(std::memcmp((*out)[0].attributes[0].data.data() + 12 * std::size_t(v),
                        mesh.attributes[0].data.data() + 12 * std::size_t(order.vertices[v]),
                        12) == 0);
  return 0;
}
