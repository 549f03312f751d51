// Arrays go the way of attributes that no face has; bytes are packed where that helps.
#include "codec/file/scene_encoder.h"

#include <cstring>
#include <string>
#include <utility>
#include <vector>

#include "codec/attributes/attribute_encoder.h"
#include "codec/base/utf8.h"
#include "codec/entropy/bytes.h"
#include "codec/entropy/zstd_frame.h"
#include "codec/file/metadata.h"
#include "codec/numbers/quantise.h"

namespace clers::internal {
namespace {

/// Texts and small bytes are worth all effort; large ones mostly are pictures, which are packed.
constexpr std::size_t small_bytes = 1 << 20;

Expected<Bytes> packed(std::span<const std::byte> bytes) {
  Bytes payload;
  put_varint(payload, bytes.size());
  auto frame = pack_frame(bytes, bytes.size() <= small_bytes ? 19 : 9);
  if (!frame) return frame;
  const bool helps = frame->size() < bytes.size();
  put_u8(payload, helps);
  put_bytes(payload, helps ? std::span<const std::byte>(*frame) : bytes);
  return payload;
}

std::string fault_of(const Array& a, std::span<const Mesh> meshes) {
  if (!is_utf8(a.name) || a.name.size() > 255)
    return "a name that is not UTF-8 of 255 bytes at most";
  if (static_cast<unsigned>(a.scalar) >= scalar_count) return "no type of scalar";
  if (a.components == 0) return "values of 0 components";
  if (a.data.size() % a.stride() != 0 || a.value_count() > 0xffffffffu)
    return std::to_string(a.data.size()) + " bytes of values of " + std::to_string(a.stride());
  if (!a.vertices_of) return {};
  if (*a.vertices_of >= meshes.size())
    return "vertices of mesh " + std::to_string(*a.vertices_of) + ", there are " +
           std::to_string(meshes.size());
  if (a.scalar != Scalar::uint32 || a.components != 1)
    return "vertices that are not single numbers of 32 bits";
  const std::uint32_t vertices = meshes[*a.vertices_of].vertex_count;
  for (std::size_t at = 0; at < a.data.size(); at += sizeof(std::uint32_t)) {
    std::uint32_t v = 0;
    std::memcpy(&v, a.data.data() + at, sizeof v);
    if (v >= vertices)
      return "vertex " + std::to_string(v) + ", expected one below " + std::to_string(vertices);
  }
  return {};
}

/// Moves the values of an array to a grid, if that is asked for.
Expected<AttributePlan> move_to_grid(Attribute& values, const EncodeOptions& options) {
  Precision precision;
  for (const AttributePrecision& asked : options.precisions)
    if (asked.name == values.name && !asked.domain) precision = asked.precision;
  if (precision.kind == Precision::Kind::recomputed ||
      precision.kind == Precision::Kind::directions)
    return fail(ErrorCode::bad_option,
                "array '" + values.name + "' has numbers, which are no directions");
  precision.or_directions = false;
  auto quantised = quantise(AttributeView(values), precision, true);
  if (!quantised) return Failure{quantised.error()};
  if (quantised->plan.error > 0) values.data = std::move(quantised->values);
  return std::move(quantised->plan);
}

/// Vertices as they are numbered in the file.
std::vector<std::byte> renumbered(std::vector<std::byte> data, const Permutation& permutation) {
  std::vector<std::uint32_t> number(permutation.vertices.size());
  for (std::uint32_t i = 0; i < number.size(); ++i) number[permutation.vertices[i]] = i;
  for (std::size_t at = 0; at < data.size(); at += sizeof(std::uint32_t)) {
    std::uint32_t v = 0;
    std::memcpy(&v, data.data() + at, sizeof v);
    std::memcpy(data.data() + at, &number[v], sizeof v);
  }
  return data;
}

}  // namespace

Expected<Done> check_scene(const Scene& scene) {
  const auto refuse = [](std::string what) {
    return fail(ErrorCode::inconsistent_mesh, std::move(what));
  };
  for (std::size_t i = 0; i < scene.arrays.size(); ++i)
    if (std::string what = fault_of(scene.arrays[i], scene.meshes); !what.empty())
      return refuse("array " + std::to_string(i) + " has " + what);
  for (std::size_t i = 0; i < scene.blobs.size(); ++i)
    if (const std::string& name = scene.blobs[i].name; !is_utf8(name) || name.size() > 255)
      return refuse("blob " + std::to_string(i) +
                    " has a name that is not UTF-8 of 255 bytes at most");
  if (std::string what = metadata_fault(scene.metadata); !what.empty())
    return refuse(std::move(what));
  return Done{};
}

Expected<Done> put_before_meshes(const Scene& scene, ContainerWriter& out, SceneInfo& info) {
  if (!scene.document.empty()) {
    const auto payload = packed(std::as_bytes(std::span(scene.document)));
    if (!payload) return Failure{payload.error()};
    info.document_size = scene.document.size();
    info.document_bytes = payload->size();
    out.section(SectionKind::document, *payload);
  }
  if (!scene.metadata.empty()) {
    const auto payload = encode_metadata(scene.metadata);
    if (!payload) return Failure{payload.error()};
    info.metadata_bytes = payload->size();
    out.section(SectionKind::metadata, *payload);
  }
  return Done{};
}

Expected<Done> put_after_meshes(const Scene& scene, std::span<const Permutation> permutations,
                                const EncodeOptions& options, ContainerWriter& out,
                                SceneInfo& info) {
  for (const Array& array : scene.arrays) {
    Attribute values{array.name, Domain::face, array.scalar, array.components, array.data};
    if (array.vertices_of)
      values.data = renumbered(std::move(values.data), permutations[*array.vertices_of]);
    Expected<AttributePlan> plan = AttributePlan{};
    if (!array.vertices_of) plan = move_to_grid(values, options);
    if (!plan) return Failure{plan.error()};
    const auto coded =
        encode_attribute(values, StructureHeader{}, ValueSurface{}, options.level, *plan);
    if (!coded) return Failure{coded.error()};
    Bytes payload;
    put_varint(payload, array.value_count());
    put_varint(payload, array.vertices_of ? *array.vertices_of + 1 : 0);
    put_bytes(payload, coded->bytes);
    out.section(SectionKind::array, payload);
    info.array_bytes += payload.size();
    ArrayInfo what{array.name,     array.scalar,        array.components,  array.value_count(),
                   payload.size(), coded->info.numbers, coded->info.coder, {}};
    if (array.vertices_of) what.vertices_of = *array.vertices_of;
    what.error = coded->info.error;
    info.arrays.push_back(std::move(what));
  }
  for (const Blob& blob : scene.blobs) {
    Bytes payload;
    put_u8(payload, static_cast<std::uint32_t>(blob.name.size()));
    put_bytes(payload, std::as_bytes(std::span(blob.name)));
    const auto bytes = packed(blob.bytes);
    if (!bytes) return Failure{bytes.error()};
    put_bytes(payload, *bytes);
    out.section(SectionKind::blob, payload);
    info.blob_bytes += payload.size();
    info.blobs.push_back({blob.name, blob.bytes.size(), payload.size()});
  }
  return Done{};
}

}  // namespace clers::internal
