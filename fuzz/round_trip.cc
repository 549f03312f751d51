// Any faces are coded and come back, twice to the same bytes; what comes back of a manifold is
// coded to them too.
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <span>

#include "codec/compare.h"
#include "codec/decode.h"
#include "codec/encode.h"
#include "codec/inspect.h"

namespace {

void require(bool yes) {
  if (!yes) std::abort();
}

/// A strip grown at random boundary edges: manifold, but for double edges.
void grow(std::span<const std::uint8_t> in, std::size_t faces, clers::Mesh& mesh) {
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
}

/// One byte: vertices. One: level. One: what kind of faces, whether to keep the order, how many
/// faces a piece if it is not whole. Then a byte a corner, or one a step of growth. The same bytes
/// are bits of positions too; in pieces no two vertices lie at one place, for pieces are made by
/// places.
clers::Mesh mesh_from(std::span<const std::uint8_t> in, clers::EncodeOptions& options) {
  clers::Mesh mesh;
  if (in.size() < 4) return mesh;
  mesh.vertex_count = in[0] % 64 + 1u;
  options.level = in[1] % 9 + 1;
  const unsigned kind = in[2] & 3;
  if (in[2] & 4) options.order = clers::Order::keep;
  constexpr std::uint32_t pieces[] = {0, 1, 2, 5, 20, 50, 100, 200};
  if (const std::uint32_t most = pieces[in[2] >> 3 & 7]; most > 0) options.piece_faces = most;
  const std::size_t axis = in[2] % 3u;
  in = in.subspan(3);
  const std::size_t faces = std::min<std::size_t>(in.size() / 4, 400);
  if (kind == 0) {
    grow(in, faces, mesh);
  } else {
    for (std::size_t i = 0, f = 0; f < faces; ++f) {
      const std::uint32_t size = kind == 1 ? 3u : in[i] >> 6 == 3 ? in[i] % 7u : 3u + in[i] % 2u;
      if (kind != 1) mesh.face_sizes.push_back(size);
      for (std::uint32_t j = 0; j < size; ++j, i = (i + 1) % in.size())
        mesh.corners.push_back((in[i] & 63) % mesh.vertex_count);
    }
  }
  clers::Attribute position{"position", clers::Domain::vertex, clers::Scalar::float32, 3, {}};
  position.data.resize(12 * std::size_t(mesh.vertex_count));
  for (std::size_t i = 0; i < position.data.size() && !in.empty(); ++i)
    position.data[i] = static_cast<std::byte>(in[i % in.size()] * (i / in.size() + 1));
  if (options.piece_faces)
    for (std::uint32_t v = 0; v < mesh.vertex_count; ++v)
      std::memcpy(position.data.data() + 12 * std::size_t(v) + 4 * axis, &v, 4);
  mesh.attributes.push_back(std::move(position));
  clers::Attribute mark{"mark", clers::Domain::corner, clers::Scalar::uint8, 1, {}};
  for (std::size_t i = 0; i < mesh.corners.size(); ++i)
    mark.data.push_back(static_cast<std::byte>(i));
  mesh.attributes.push_back(std::move(mark));
  return mesh;
}

/// `out` is `in` with its elements in another order.
void check(const clers::Mesh& in, const clers::Mesh& out, const clers::Permutation& order) {
  require(out.corners.size() == in.corners.size() && out.face_count() == in.face_count());
  const auto size = [&](const clers::Mesh& m, std::size_t f) {
    return m.triangles_only() ? 3 : m.face_sizes[f];
  };
  std::vector<std::size_t> begin(in.face_count() + 1);
  for (std::size_t f = 0; f < in.face_count(); ++f) begin[f + 1] = begin[f] + size(in, f);
  std::size_t corner = 0;
  for (std::size_t i = 0; i < out.face_count(); ++i) {
    const std::uint32_t f = order.faces[i], n = size(in, f);
    require(size(out, i) == n);
    for (std::uint32_t j = 0; j < n; ++j, ++corner) {
      const std::size_t from = begin[f] + (order.first_corners[i] + j) % n;
      require(order.vertices[out.corners[corner]] == in.corners[from]);
      require(out.attributes[1].data[corner] == in.attributes[1].data[from]);
    }
  }
  for (std::uint32_t v = 0; v < in.vertex_count; ++v)
    require(std::memcmp(out.attributes[0].data.data() + 12 * std::size_t(v),
                        in.attributes[0].data.data() + 12 * std::size_t(order.vertices[v]),
                        12) == 0);
}

/// On a grid: within the error that is stated, which is that found.
void check_quantised(const clers::Mesh& mesh, clers::EncodeOptions options, int bits) {
  options.precisions = {{clers::position_name, clers::Precision::of_bits(bits)}};
  const auto coded = clers::encode(mesh, options);
  if (!coded) return require(coded.error().code == clers::ErrorCode::not_on_grid);
  const auto out = clers::decode(coded->bytes);
  require(out.ok() && out->size() == 1);
  const double error = coded->report[0].attributes[0].error;
  const clers::Tolerance tolerances[] = {{clers::position_name, error}};
  const auto compared = clers::compare(mesh, out->front(), std::span(tolerances, error > 0 ? 1 : 0),
                                       coded->permutations[0]);
  require(compared.ok() && compared->verdict == clers::Verdict::same);
  require(error == 0 || compared->errors[0].error == error);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  clers::EncodeOptions options;
  const clers::Mesh mesh = mesh_from(std::span(data, size), options);
  if (mesh.attributes.empty()) return 0;
  const auto coded = clers::encode(std::span(&mesh, 1), options);
  require(coded.ok());
  const auto out = clers::decode(coded->bytes);
  require(out.ok() && out->size() == 1);
  check(mesh, out->front(), coded->permutations[0]);
  check_quantised(mesh, options, 1 + static_cast<int>(size % 30));
  options.threads = 2;
  const auto by_two = clers::encode(std::span(&mesh, 1), options);
  require(by_two.ok() && by_two->bytes == coded->bytes);
  const auto compared = clers::compare(mesh, out->front());
  require(compared.ok() && compared->verdict != clers::Verdict::different);
  if (options.order == clers::Order::keep) require(out->front().corners == mesh.corners);
  const auto shape = clers::measure(mesh);
  require(shape.ok());
  if (shape->nonmanifold_edges + shape->nonmanifold_vertices + shape->misoriented_edges +
          shape->degenerate_faces >
      0)
    return 0;
  const auto from_decoded = clers::encode(*out, options);
  require(from_decoded.ok() && from_decoded->bytes == coded->bytes);
  return 0;
}
