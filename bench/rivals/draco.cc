// Connectivity alone is what MeshEdgebreakerEncoder::EncodeConnectivity() writes: its subclass here
// stops where the attributes begin. Draco's header (11 bytes) and the byte that names the kind of
// traversal are not counted. Encoding includes the building of Draco's corner table; the input is
// a draco::Mesh that is there already, as is Draco's custom.
#include "bench/rivals/draco.h"

#include <draco/compression/decode.h>
#include <draco/compression/encode.h>
#include <draco/compression/mesh/mesh_edgebreaker_decoder.h>
#include <draco/compression/mesh/mesh_edgebreaker_encoder.h>
#include <draco/core/draco_version.h>

#include <array>
#include <utility>

// The distribution's shared library is measured by the same code: bench/rivals/draco_debian.cc.
#ifndef CLERS_BENCH_DRACO_PREFIX
#define CLERS_BENCH_DRACO_PREFIX "draco-"
#endif

namespace clers::bench {
namespace {

struct ConnectivityEncoder : draco::MeshEdgebreakerEncoder {
  std::size_t bytes = 0;

  draco::Status EncodeConnectivity() override {
    const std::size_t before = buffer()->size();
    draco::Status status = draco::MeshEdgebreakerEncoder::EncodeConnectivity();
    bytes = buffer()->size() - before;
    return status;
  }
  bool EncodePointAttributes() override { return true; }
};

struct ConnectivityDecoder : draco::MeshEdgebreakerDecoder {
  bool DecodePointAttributes() override { return true; }
};

constexpr char lost_track[] = "the run that follows the vertices gives other faces";

void require(const draco::Status& status) {
  if (!status.ok()) throw CodecFailure(status.error_msg_string());
}

template <class T>
int add_attribute(draco::Mesh& mesh, draco::GeometryAttribute::Type type, std::int8_t components,
                  draco::DataType scalar, const std::vector<T>& values) {
  draco::PointAttribute attribute;
  const auto count = static_cast<std::uint32_t>(values.size() / std::size_t(components));
  attribute.Init(type, components, scalar, false, count);
  attribute.SetIdentityMapping();
  for (std::uint32_t v = 0; v < count; ++v)
    attribute.SetAttributeValue(draco::AttributeValueIndex(v),
                                values.data() + std::size_t(v) * std::size_t(components));
  return mesh.AddAttribute(std::make_unique<draco::PointAttribute>(std::move(attribute)));
}

std::unique_ptr<draco::Mesh> make_mesh(const Input& input) {
  auto mesh = std::make_unique<draco::Mesh>();
  mesh->set_num_points(input.vertex_count);
  mesh->SetNumFaces(input.triangle_count());
  for (std::uint32_t f = 0; f < input.triangle_count(); ++f) {
    draco::Mesh::Face face;
    for (std::uint32_t i = 0; i < 3; ++i) face[i] = draco::PointIndex(input.triangles[3 * f + i]);
    mesh->SetFace(draco::FaceIndex(f), face);
  }
  add_attribute(*mesh, draco::GeometryAttribute::POSITION, 3, draco::DT_FLOAT32, input.positions);
  return mesh;
}

std::vector<std::uint32_t> faces_of(const draco::Mesh& mesh) {
  std::vector<std::uint32_t> corners;
  corners.reserve(3 * mesh.num_faces());
  for (std::uint32_t f = 0; f < mesh.num_faces(); ++f)
    for (const draco::PointIndex& p : mesh.face(draco::FaceIndex(f))) corners.push_back(p.value());
  return corners;
}

class Draco : public Codec {
 public:
  void prepare(const Input& input, Mode mode) override {
    mode_ = mode;
    vertex_count_ = input.vertex_count;
    mesh_ = make_mesh(input);
  }

  void encode() override {
    buffer_.Clear();
    bytes_ = encode_mesh(*mesh_, buffer_);
  }
  std::size_t bytes() const override { return bytes_; }

  void decode() override {
    decoded_ = std::make_unique<draco::Mesh>();
    draco::DecoderBuffer in;
    in.Init(buffer_.data(), buffer_.size());
    decode_mesh(in, *decoded_);
  }
  void discard() override { decoded_.reset(); }

  // The vertices are followed by an attribute that numbers them, in a second encode of the same
  // connectivity. Its decoder numbers the points otherwise, but faces and corners come in the same
  // order; if they did not, the numbers would not agree where corners meet.
  Output output() override {
    const std::unique_ptr<draco::Mesh> numbered = copy_with_ids();
    draco::EncoderBuffer buffer;
    require(encode_whole(*numbered, buffer));
    draco::DecoderBuffer in;
    in.Init(buffer.data(), buffer.size());
    draco::Mesh witness;
    draco::Decoder decoder;
    require(decoder.DecodeBufferToGeometry(&in, &witness));

    const draco::PointAttribute* ids = nullptr;
    for (int a = 0; a < witness.num_attributes(); ++a)
      if (witness.attribute(a)->attribute_type() == draco::GeometryAttribute::GENERIC)
        ids = witness.attribute(a);
    Output out;
    out.triangles = faces_of(*decoded_);
    const std::vector<std::uint32_t> seen = faces_of(witness);
    if (!ids || out.triangles.size() != seen.size()) throw CodecFailure(lost_track);
    out.origin.assign(decoded_->num_points(), ~0u);
    for (std::size_t c = 0; c < seen.size(); ++c) {
      std::uint32_t id = 0;
      ids->GetMappedValue(draco::PointIndex(seen[c]), &id);
      std::uint32_t& origin = out.origin.at(out.triangles[c]);
      if (origin == ~0u) origin = id;
      if (origin != id) throw CodecFailure(lost_track);
    }
    if (mode_ != Mode::connectivity) {
      const draco::PointAttribute* position =
          decoded_->GetNamedAttribute(draco::GeometryAttribute::POSITION);
      for (draco::PointIndex p(0); p < decoded_->num_points(); ++p) {
        std::array<float, 3> xyz{};
        position->GetMappedValue(p, xyz.data());
        out.positions.insert(out.positions.end(), xyz.begin(), xyz.end());
      }
    }
    return out;
  }

 protected:
  virtual std::size_t encode_mesh(const draco::Mesh& mesh, draco::EncoderBuffer& out) = 0;
  virtual void decode_mesh(draco::DecoderBuffer& in, draco::Mesh& out) = 0;
  virtual draco::Status encode_whole(const draco::Mesh& mesh, draco::EncoderBuffer& out) = 0;

  Mode mode_ = Mode::connectivity;

 private:
  std::unique_ptr<draco::Mesh> copy_with_ids() const {
    auto copy = std::make_unique<draco::Mesh>();
    copy->set_num_points(vertex_count_);
    copy->SetNumFaces(mesh_->num_faces());
    for (draco::FaceIndex f(0); f < mesh_->num_faces(); ++f) copy->SetFace(f, mesh_->face(f));
    auto position = std::make_unique<draco::PointAttribute>();
    position->CopyFrom(*mesh_->attribute(0));
    copy->AddAttribute(std::move(position));
    std::vector<std::uint32_t> ids(vertex_count_);
    for (std::uint32_t v = 0; v < vertex_count_; ++v) ids[v] = v;
    add_attribute(*copy, draco::GeometryAttribute::GENERIC, 1, draco::DT_UINT32, ids);
    return copy;
  }

  std::uint32_t vertex_count_ = 0;
  std::unique_ptr<draco::Mesh> mesh_, decoded_;
  draco::EncoderBuffer buffer_;
  std::size_t bytes_ = 0;
};

class DracoConnectivity : public Draco {
 public:
  explicit DracoConnectivity(int method) : method_(method) {}

 private:
  draco::EncoderOptions options() const {
    draco::EncoderOptions options = draco::EncoderOptions::CreateDefaultOptions();
    options.SetGlobalInt("edgebreaker_method", method_);
    return options;
  }
  std::size_t encode_mesh(const draco::Mesh& mesh, draco::EncoderBuffer& out) override {
    ConnectivityEncoder encoder;
    encoder.SetMesh(mesh);
    require(encoder.Encode(options(), &out));
    return encoder.bytes;
  }
  void decode_mesh(draco::DecoderBuffer& in, draco::Mesh& out) override {
    ConnectivityDecoder decoder;
    require(decoder.Decode(draco::DecoderOptions(), &in, &out));
  }
  draco::Status encode_whole(const draco::Mesh& mesh, draco::EncoderBuffer& out) override {
    draco::MeshEdgebreakerEncoder encoder;
    encoder.SetMesh(mesh);
    return encoder.Encode(options(), &out);
  }

  int method_;
};

class DracoWhole : public Draco {
 public:
  explicit DracoWhole(int level) : level_(level) {}

 private:
  std::size_t encode_mesh(const draco::Mesh& mesh, draco::EncoderBuffer& out) override {
    require(encode_whole(mesh, out));
    return out.size();
  }
  void decode_mesh(draco::DecoderBuffer& in, draco::Mesh& out) override {
    draco::Decoder decoder;
    require(decoder.DecodeBufferToGeometry(&in, &out));
  }
  draco::Status encode_whole(const draco::Mesh& mesh, draco::EncoderBuffer& out) override {
    draco::Encoder encoder;
    encoder.SetSpeedOptions(10 - level_, 10 - level_);
    encoder.SetEncodingMethod(draco::MESH_EDGEBREAKER_ENCODING);
    if (const int b = bits(mode_))
      encoder.SetAttributeQuantization(draco::GeometryAttribute::POSITION, b);
    return encoder.EncodeMeshToBuffer(mesh, &out);
  }

  int level_;
};

}  // namespace

std::vector<CodecEntry> draco_codecs() {
  const std::string prefix = CLERS_BENCH_DRACO_PREFIX;
  const std::vector<Mode> connectivity = {Mode::connectivity};
  const std::vector<Mode> whole = {Mode::q11, Mode::q14, Mode::q16, Mode::lossless};
  std::vector<CodecEntry> entries;
  entries.push_back({prefix + "standard", connectivity, [] {
                       return std::make_unique<DracoConnectivity>(
                           draco::MESH_EDGEBREAKER_STANDARD_ENCODING);
                     }});
  entries.push_back({prefix + "valence", connectivity, [] {
                       return std::make_unique<DracoConnectivity>(
                           draco::MESH_EDGEBREAKER_VALENCE_ENCODING);
                     }});
  for (const int level : {5, 7, 10})
    entries.push_back({prefix + "cl" + std::to_string(level), whole,
                       [level] { return std::make_unique<DracoWhole>(level); }});
  return entries;
}

std::string draco_version() {
  return draco::kDracoVersion;
}

}  // namespace clers::bench
