// Between what headers say and what Draco allocates for it stand four classes that are Draco's own,
// but ask first. Which bits values had is in the attributes before their transforms, which only
// these classes show.
#include "codec/draco/decoded.h"

#include <draco/compression/mesh/mesh_edgebreaker_decoder.h>
#include <draco/compression/mesh/mesh_sequential_decoder.h>
#include <draco/compression/point_cloud/point_cloud_kd_tree_decoder.h>
#include <draco/compression/point_cloud/point_cloud_sequential_decoder.h>
#include <draco/core/varint_decoding.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include "codec/base/budget.h"

namespace clers::draco {
namespace {

/// By measurement of the decoder's heap, and of the mesh that is made of what it returns.
constexpr std::uint64_t bytes_a_face = 200, bytes_a_corner_attribute = 8, copies_of_values = 4;

struct Counts {
  std::uint64_t faces = 0, points = 0;
};

/// A number as headers have it: 32 bits, since some version of the format in groups of 7.
std::uint32_t number(::draco::DecoderBuffer& in, bool packed) {
  std::uint32_t n = 0;
  const bool ok = packed ? ::draco::DecodeVarint(&n, &in) : in.Decode(&n);
  return ok ? n : 0;  // what is cut off Draco finds
}

/// What follows the metadata, read ahead.
Counts counts_of(const ::draco::MeshEdgebreakerDecoder& decoder, ::draco::DecoderBuffer in) {
  const std::uint16_t version = decoder.bitstream_version();
  const bool packed = version >= DRACO_BITSTREAM_VERSION(2, 0);
  if (version < DRACO_BITSTREAM_VERSION(2, 2)) number(in, packed);  // vertices besides
  const std::uint64_t vertices = number(in, packed);
  return {number(in, packed), vertices};
}
Counts counts_of(const ::draco::MeshSequentialDecoder& decoder, ::draco::DecoderBuffer in) {
  const bool packed = decoder.bitstream_version() >= DRACO_BITSTREAM_VERSION(2, 2);
  const std::uint64_t faces = number(in, packed);
  return {faces, number(in, packed)};
}
Counts counts_of(const ::draco::PointCloudDecoder&, ::draco::DecoderBuffer in) {
  return {0, number(in, false)};
}

Failure<Error> beyond(const char* what, std::uint64_t found, std::uint64_t most, Limited limited) {
  auto failure = fail(ErrorCode::limit, std::to_string(found) + " " + what + ", the limit is " +
                                            std::to_string(most));
  failure.error.limited = limited;
  failure.error.needed = found;
  return failure;
}

template <class Base>
class Asking : public Base {
 public:
  Asking(const Limits& limits, internal::Budget budget) : limits_(limits), budget_(budget) {}

  std::optional<Error> refused;

 protected:
  bool DecodeGeometryData() override {
    const Counts counts = counts_of(*this, *this->buffer());
    if (counts.faces > limits_.faces)
      return refuse(beyond("faces", counts.faces, limits_.faces, Limited::faces));
    if (counts.points > limits_.vertices)
      return refuse(beyond("vertices", counts.points, limits_.vertices, Limited::vertices));
    faces_ = counts.faces;
    if (auto ok = budget_.take(counts.faces * bytes_a_face + counts.points * 8); !ok)
      return refuse(Failure{ok.error()});
    return Base::DecodeGeometryData();
  }

  /// All attributes are there now, and none of their values.
  bool DecodeAllAttributes() override {
    const ::draco::PointCloud& points = *this->point_cloud();
    std::uint64_t bytes = 0;
    for (std::int32_t i = 0; i < points.num_attributes(); ++i) {
      const std::uint64_t stride =
          std::max<std::uint64_t>(std::uint64_t(points.attribute(i)->byte_stride()),
                                  4u * points.attribute(i)->num_components());
      bytes +=
          points.num_points() * stride * copies_of_values + faces_ * 3 * bytes_a_corner_attribute;
    }
    if (auto ok = budget_.take(bytes); !ok) return refuse(Failure{ok.error()});
    return Base::DecodeAllAttributes();
  }

 private:
  bool refuse(Failure<Error> failure) {
    refused = std::move(failure.error);
    return false;
  }

  const Limits& limits_;
  internal::Budget budget_;
  std::uint64_t faces_ = 0;
};

/// To how many bits an attribute is quantised, by its values before they were made floats again.
unsigned bits_of(const ::draco::PointAttribute* quantised) {
  const ::draco::AttributeTransformData* transform =
      quantised == nullptr ? nullptr : quantised->GetAttributeTransformData();
  if (transform == nullptr) return 0;
  const auto type = transform->transform_type();
  if (type != ::draco::ATTRIBUTE_QUANTIZATION_TRANSFORM &&
      type != ::draco::ATTRIBUTE_OCTAHEDRON_TRANSFORM)
    return 0;
  const auto bits = transform->GetParameterValue<std::int32_t>(0);  // both begin with it
  return bits > 0 && bits <= 32 ? static_cast<unsigned>(bits) : 0;
}

template <class Base, class Geometry>
Expected<Decoded> run(::draco::DecoderBuffer& buffer, const Limits& limits, std::size_t size) {
  Asking<Base> decoder(limits, internal::Budget(limits, size));
  auto geometry = std::make_unique<Geometry>();
  const ::draco::DecoderOptions how;
  const ::draco::Status status = decoder.Decode(how, &buffer, geometry.get());
  if (decoder.refused) return Failure{std::move(*decoder.refused)};
  if (!status.ok())
    return fail(ErrorCode::malformed, Place::byte, std::uint64_t(buffer.decoded_size()),
                "Draco cannot decode it: " + status.error_msg_string());
  Decoded decoded;
  if constexpr (std::is_same_v<Geometry, ::draco::Mesh>) decoded.mesh = geometry.get();
  decoded.edgebreaker = std::is_same_v<Base, ::draco::MeshEdgebreakerDecoder>;
  decoded.tree = std::is_same_v<Base, ::draco::PointCloudKdTreeDecoder>;
  decoded.left = static_cast<std::size_t>(std::max<std::int64_t>(0, buffer.remaining_size()));
  for (std::int32_t i = 0; i < geometry->num_attributes(); ++i)
    decoded.bits.push_back(bits_of(decoder.GetPortableAttribute(i)));
  decoded.points = std::move(geometry);
  return decoded;
}

/// Does it hold together?
bool is_sound(const Decoded& decoded) {
  const ::draco::PointCloud& points = *decoded.points;
  const std::uint32_t count = points.num_points();
  for (std::int32_t i = 0; i < points.num_attributes(); ++i) {
    const ::draco::PointAttribute& a = *points.attribute(i);
    const std::uint64_t stride = std::uint64_t(a.byte_stride());
    const std::uint64_t value =
        std::uint64_t(::draco::DataTypeLength(a.data_type())) * a.num_components();
    if (a.buffer() == nullptr || value == 0 || a.data_type() == ::draco::DT_INVALID ||
        a.byte_offset() < 0 || stride < value ||
        std::uint64_t(a.byte_offset()) + a.size() * stride > a.buffer()->data_size())
      return false;
    if (a.is_mapping_identity()) {
      if (count > a.size()) return false;
      continue;
    }
    if (a.indices_map_size() < count) return false;
    for (::draco::PointIndex p(0); p < count; ++p)
      if (a.mapped_index(p).value() >= a.size()) return false;
  }
  if (decoded.mesh != nullptr)
    for (::draco::FaceIndex f(0); f < decoded.mesh->num_faces(); ++f)
      for (const ::draco::PointIndex& p : decoded.mesh->face(f))
        if (p.value() >= count) return false;
  return true;
}

Expected<Decoded> decode(std::span<const std::byte> bytes, const Limits& limits) {
  ::draco::DecoderBuffer buffer;
  buffer.Init(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  ::draco::DecoderBuffer ahead = buffer;
  ::draco::DracoHeader header;
  if (!::draco::PointCloudDecoder::DecodeHeader(&ahead, &header).ok())
    return fail(ErrorCode::malformed, Place::byte, 0, "expected the header of a Draco file");
  const bool points = header.encoder_type == ::draco::POINT_CLOUD;
  switch (header.encoder_method) {
    case ::draco::MESH_SEQUENTIAL_ENCODING:  // the same number as POINT_CLOUD_SEQUENTIAL_ENCODING
      return points
                 ? run<::draco::PointCloudSequentialDecoder, ::draco::PointCloud>(buffer, limits,
                                                                                  bytes.size())
                 : run<::draco::MeshSequentialDecoder, ::draco::Mesh>(buffer, limits, bytes.size());
    case ::draco::MESH_EDGEBREAKER_ENCODING:  // the same number as POINT_CLOUD_KD_TREE_ENCODING
      return points ? run<::draco::PointCloudKdTreeDecoder, ::draco::PointCloud>(buffer, limits,
                                                                                 bytes.size())
                    : run<::draco::MeshEdgebreakerDecoder, ::draco::Mesh>(buffer, limits,
                                                                          bytes.size());
    default: break;
  }
  return fail(ErrorCode::unsupported,
              "method " + std::to_string(header.encoder_method) + " of Draco, expected 0 or 1");
}

}  // namespace

Expected<Decoded> decode_checked(std::span<const std::byte> bytes, const Limits& limits) {
  auto decoded = decode(bytes, limits);
  if (decoded && !is_sound(*decoded))
    return fail(ErrorCode::malformed, "Draco decodes values that lie nowhere");
  return decoded;
}

}  // namespace clers::draco
