// Any bytes are a file that decodes to valid meshes, or a named error.
//
// Checksums would stop nearly every mutation at the door, so the mutator mends them.
#include <xxhash.h>

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <span>
#include <vector>

#include "codec/decode.h"
#include "codec/encode.h"
#include "codec/inspect.h"

namespace {

void require(bool yes) {
  if (!yes) std::abort();
}

void check(const clers::Mesh& mesh) {
  std::size_t corners = 3 * mesh.face_count();
  if (!mesh.triangles_only()) {
    corners = 0;
    for (const std::uint32_t size : mesh.face_sizes) corners += size;
  }
  require(mesh.corners.size() == corners);
  for (const std::uint32_t v : mesh.corners) require(v < mesh.vertex_count);
  for (const clers::Attribute& a : mesh.attributes) {
    const std::size_t count = a.domain == clers::Domain::vertex   ? mesh.vertex_count
                              : a.domain == clers::Domain::corner ? mesh.corners.size()
                                                                  : mesh.face_count();
    require(a.data.size() == count * a.stride());
  }
}

/// Makes the checksums right, section by section, as far as lengths lead.
void mend_checksums(std::uint8_t* data, std::size_t size) {
  constexpr std::size_t header = 7;
  if (size < header) return;
  std::memcpy(data, "CLERS", 5);
  std::uint32_t check = XXH32(data, header, 0);
  for (std::size_t start = header; start + 6 <= size;) {
    std::size_t at = start + 1;
    std::uint64_t length = 0;
    for (unsigned shift = 0; at < size && shift < 63; shift += 7) {
      length |= std::uint64_t(data[at] & 127) << shift;
      if (!(data[at++] & 128)) break;
    }
    if (size - at < 4 || length > size - at - 4) return;
    const std::size_t end = at + static_cast<std::size_t>(length);
    check = XXH32(data + start, end - start, check);
    for (unsigned i = 0; i < 4; ++i) data[end + i] = static_cast<std::uint8_t>(check >> (8 * i));
    start = end + 4;
  }
}

}  // namespace

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most)
    __attribute__((weak));

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t most, unsigned) {
  if (LLVMFuzzerMutate) size = LLVMFuzzerMutate(data, size, most);  // there is none in a replay
  mend_checksums(data, size);
  return size;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const clers::DecodeOptions options;  // the limits that every user has
  const auto bytes = std::as_bytes(std::span(data, size));
  auto meshes = clers::decode(bytes, options);
  std::size_t faces = 0;
  const auto in_pieces = clers::decode_pieces(
      bytes,
      [&](clers::Piece piece) {
        check(piece.mesh);
        for (const clers::SharedVertex& v : piece.seam)
          require(v.vertex < piece.mesh.vertex_count && v.number < piece.first_vertex);
        faces += piece.mesh.face_count();
      },
      options);
  if (!meshes) {
    require(meshes.error().code != clers::ErrorCode::internal);
    require(!clers::describe(meshes.error()).empty());
    return 0;
  }
  require(in_pieces.ok());
  for (const clers::Mesh& mesh : *meshes) {
    check(mesh);
    faces -= mesh.face_count();
  }
  require(faces == 0);
  if (meshes->size() == 1) {
    std::vector<std::uint32_t> corners(meshes->front().corners.size());
    const auto into = clers::decode_into(bytes, corners, {}, options);
    require(into.ok() == meshes->front().triangles_only());
    require(!into.ok() || corners == meshes->front().corners);
  }
  // Measuring takes more memory than decoding.
  const auto info = clers::inspect(bytes);
  require(info.ok() || info.error().limited == clers::Limited::memory);
  return 0;
}
