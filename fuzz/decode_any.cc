// Any bytes are a file that decodes to valid meshes, or a named error.
//
// Checksums would stop nearly every mutation at the door, so the mutator mends them.
#include <xxhash.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <span>
#include <vector>

#include "codec/decode.h"
#include "codec/decoder.h"
#include "codec/encode.h"
#include "codec/gltf/gltf.h"
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

/// What a Decoder gives of a mesh in parts is what decode gave.
void check_parts(const clers::Decoder& decoder, std::size_t index, const clers::MeshInfo& info,
                 const clers::Mesh& mesh) {
  require(info.vertices == mesh.vertex_count && info.faces == mesh.face_count() &&
          info.corners == mesh.corners.size() && info.attributes.size() == mesh.attributes.size() &&
          info.name == mesh.name);
  require(!info.triangles_only || mesh.triangles_only());
  std::vector<std::uint32_t> corners(mesh.corners.size()), sizes(mesh.face_count()),
      opposites(corners.size());
  std::vector<std::vector<std::byte>> values;
  std::vector<clers::AttributeTarget> targets;
  for (const clers::AttributeInfo& a : info.attributes) {
    values.emplace_back(static_cast<std::size_t>(a.count * (a.value_size() + 1)));
    targets.push_back({a.name, a.domain, a.scalar, a.components, values.back(),
                       static_cast<std::size_t>(a.value_size() + 1)});
  }
  const auto may_fail = [](const clers::Expected<clers::Done>& done) {
    require(done.ok() || done.error().limited == clers::Limited::memory);
    return done.ok();
  };
  if (may_fail(decoder.decode_into(index, {.corners = corners,
                                           .face_sizes = sizes,
                                           .opposites = opposites,
                                           .attributes = targets}))) {
    require(corners == mesh.corners);
    for (std::size_t f = 0; f < sizes.size(); ++f)
      require(sizes[f] == (mesh.triangles_only() ? 3 : mesh.face_sizes[f]));
    for (std::uint32_t h = 0; h < opposites.size(); ++h)
      require(opposites[h] == clers::MeshTarget::no_opposite ||
              (opposites[h] < opposites.size() && opposites[opposites[h]] == h));
  }
  std::fill(corners.begin(), corners.end(), 0);
  const auto alone = decoder.decode_into(index, {.corners = corners});
  require(alone.ok() == mesh.triangles_only() || corners.empty() ||
          (!alone.ok() && alone.error().limited == clers::Limited::memory));
  require(!alone.ok() || corners == mesh.corners);
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const clers::DecodeOptions options;  // the limits that every user has
  const auto bytes = std::as_bytes(std::span(data, size));
  auto meshes = clers::decode(bytes, options);
  std::size_t faces = 0;
  const auto decoder = clers::Decoder::open(bytes, options);
  clers::Expected<clers::Done> in_pieces = clers::Done{};
  for (std::size_t i = 0; decoder && in_pieces && i < decoder->piece_count(); ++i) {
    const auto piece = decoder->decode_piece(i);
    if (!piece) {
      in_pieces = clers::Failure{piece.error()};
      break;
    }
    check(piece->mesh);
    for (const clers::SharedVertex& v : piece->seam)
      require(v.vertex < piece->mesh.vertex_count && v.number < piece->first_vertex);
    faces += piece->mesh.face_count();
  }
  const auto scene = clers::decode_scene(bytes, options);
  if (scene) {
    require(meshes.ok() && meshes->size() == scene->meshes.size());
    const auto written = clers::gltf::write(*scene);
    require(written.ok() || written.error().code != clers::ErrorCode::internal);
  } else {
    require(scene.error().code != clers::ErrorCode::internal);
  }
  if (!meshes) {
    require(meshes.error().code != clers::ErrorCode::internal);
    require(!clers::describe(meshes.error()).empty());
    return 0;
  }
  require(decoder.ok() && in_pieces.ok());
  const auto known = decoder->info();
  // What is besides meshes may be wrong, which only who looks at it sees.
  require(known.ok() || !scene.ok());
  if (!known) return 0;
  require(known->meshes.size() == meshes->size());
  for (std::size_t i = 0; i < meshes->size(); ++i) {
    check((*meshes)[i]);
    check_parts(*decoder, i, known->meshes[i], (*meshes)[i]);
    faces -= (*meshes)[i].face_count();
  }
  require(faces == 0);
  // Measuring takes more memory than decoding.
  const auto info = clers::inspect(bytes);
  require(info.ok() || info.error().limited == clers::Limited::memory || !scene.ok());
  return 0;
}
