// A Decoder as an object of C, and what it knows without decoding.
#include <algorithm>
#include <cstdint>
#include <memory>
#include <utility>

#include "bindings/c/decoder.h"
#include "codec/options.h"

namespace clers::internal {
namespace {

static_assert(CLERS_NONE == MeshTarget::no_opposite);
static_assert(CLERS_AT_CORNER == static_cast<int>(Place::corner) &&
              CLERS_AT_BYTE == static_cast<int>(Place::byte));
static_assert(CLERS_LIMITED_BY_MEMORY == static_cast<int>(Limited::memory));
static_assert(CLERS_ANGLE == static_cast<int>(ErrorMeasure::angle));
static_assert(CLERS_BAD_OPTION == static_cast<int>(ErrorCode::bad_option) &&
              CLERS_INVALID == static_cast<int>(ErrorCode::invalid) &&
              CLERS_OUT_OF_MEMORY == static_cast<int>(ErrorCode::out_of_memory) &&
              CLERS_UNSUPPORTED == static_cast<int>(ErrorCode::unsupported) &&
              CLERS_INTERNAL == static_cast<int>(ErrorCode::internal));

Expected<DecodeOptions> options_of(const clers_decode_options* given) {
  const auto taken = taken_or_default(given, "clers_decode_options");
  if (!taken) return Failure{taken.error()};
  DecodeOptions options;
  if (taken->max_meshes != 0) options.limits.meshes = taken->max_meshes;
  if (taken->max_vertices != 0) options.limits.vertices = taken->max_vertices;
  if (taken->max_faces != 0) options.limits.faces = taken->max_faces;
  if (taken->max_memory != 0) options.limits.memory = taken->max_memory;
  options.threads = taken->threads == CLERS_EVERY_CORE ? 0 : std::max(taken->threads, 1u);
  return options;
}

Expected<std::unique_ptr<clers_decoder>> open(const void* bytes, std::size_t size,
                                              const clers_decode_options* given) {
  if (bytes == nullptr && size > 0) return bad_option("no bytes of a file");
  auto options = options_of(given);
  if (!options) return Failure{options.error()};
  auto decoder = Decoder::open(bytes_of(bytes, size), std::move(*options));
  if (!decoder) return Failure{decoder.error()};
  auto info = decoder->info();
  if (!info) return Failure{info.error()};
  std::vector<std::size_t> first_pieces;
  std::size_t pieces = 0;
  for (const MeshInfo& mesh : info->meshes) {
    first_pieces.push_back(pieces);
    pieces += static_cast<std::size_t>(mesh.pieces);
  }
  return std::make_unique<clers_decoder>(
      clers_decoder{std::move(*decoder), std::move(*info), std::move(first_pieces)});
}

std::uint64_t elements(const MeshInfo& mesh, Domain domain) {
  return domain == Domain::vertex   ? mesh.vertices
         : domain == Domain::corner ? mesh.corners
                                    : mesh.faces;
}

}  // namespace
}  // namespace clers::internal

using namespace clers::internal;
using clers::Done;
using clers::Expected;
using clers::Failure;

clers_code clers_open(const void* bytes, std::size_t size, const clers_decode_options* options,
                      clers_decoder** decoder, clers_error* error) {
  if (decoder != nullptr) *decoder = nullptr;
  return guarded_for_c(error, [&]() -> Expected<Done> {
    if (decoder == nullptr) return bad_option("no room for a decoder");
    auto opened = open(bytes, size, options);
    if (!opened) return Failure{opened.error()};
    *decoder = opened->release();
    return Done{};
  });
}

void clers_close(clers_decoder* decoder) {
  delete decoder;
}

clers_code clers_inspect(const clers_decoder* decoder, clers_file_info* info, clers_error* error) {
  return guarded_for_c(error, [&]() -> Expected<Done> {
    if (decoder == nullptr) return bad_option("no decoder");
    const clers::FileInfo& file = decoder->info;
    return give({0, file.meshes.size(), decoder->decoder.piece_count(), file.total_bytes,
                 file.format_major, file.format_minor, file.level},
                info, "clers_file_info");
  });
}

clers_code clers_inspect_mesh(const clers_decoder* decoder, std::size_t mesh, clers_mesh_info* info,
                              clers_error* error) {
  return guarded_for_c(error, [&]() -> Expected<Done> {
    const auto found = mesh_info(decoder, mesh);
    if (!found) return Failure{found.error()};
    const clers::MeshInfo& m = **found;
    return give({0, m.name.c_str(), m.vertices, m.faces, m.corners, m.attributes.size(),
                 decoder->first_pieces[mesh], m.pieces, m.triangles_only,
                 m.connectivity_bytes + m.polygon_bytes + m.stitching_bytes + m.order_bytes,
                 m.position_bytes + m.attribute_bytes},
                info, "clers_mesh_info");
  });
}

clers_code clers_inspect_attribute(const clers_decoder* decoder, std::size_t mesh,
                                   std::size_t attribute, clers_attribute_info* info,
                                   clers_error* error) {
  return guarded_for_c(error, [&]() -> Expected<Done> {
    const auto in = mesh_info(decoder, mesh);
    if (!in) return Failure{in.error()};
    const auto found = attribute_info(**in, attribute);
    if (!found) return Failure{found.error()};
    const clers::AttributeInfo& a = **found;
    return give({0, a.name.c_str(), static_cast<std::int32_t>(a.domain),
                 static_cast<std::int32_t>(a.scalar), a.components, elements(**in, a.domain),
                 a.value_size(), a.bytes, a.error, static_cast<std::int32_t>(a.measure)},
                info, "clers_attribute_info");
  });
}

clers_code clers_inspect_piece(const clers_decoder* decoder, std::size_t piece,
                               clers_piece_info* info, clers_error* error) {
  return guarded_for_c(error, [&]() -> Expected<Done> {
    if (decoder == nullptr) return bad_option("no decoder");
    const auto found = decoder->decoder.piece_info(piece);
    if (!found) return Failure{found.error()};
    return give({0, found->mesh_index, found->index, found->vertices, found->faces, found->corners,
                 found->first_vertex, found->first_face, found->triangles_only},
                info, "clers_piece_info");
  });
}
