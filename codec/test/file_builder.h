// Files made section by section, for tests of what a decoder refuses.
#ifndef CLERS_CODEC_TEST_FILE_BUILDER_H
#define CLERS_CODEC_TEST_FILE_BUILDER_H

#include <zstd.h>

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "codec/entropy/bytes.h"
#include "codec/file/container.h"
#include "codec/file/mesh_features.h"
#include "codec/mesh.h"

namespace clers::internal::test {

/// Appends to a payload.
class Payload {
 public:
  Payload& u8(std::uint32_t v) { return put_u8(bytes, v), *this; }
  Payload& varint(std::uint64_t v) { return put_varint(bytes, v), *this; }
  Payload& raw(std::span<const std::byte> v) { return put_bytes(bytes, v), *this; }
  Payload& text(std::string_view v) { return raw(std::as_bytes(std::span(v))); }
  Payload& stream(std::span<const std::byte> v) { return varint(v.size()).raw(v); }

  Bytes bytes;
};

class FileBuilder {
 public:
  explicit FileBuilder(int level = 5) : out_(level) {}
  FileBuilder& section(SectionKind kind, const Payload& payload) {
    meshes_ += kind == SectionKind::mesh && !in_pieces_;
    return out_.section(kind, payload.bytes), *this;
  }
  /// Meshes that follow are pieces of one.
  FileBuilder& pieces(std::uint64_t n) {
    section(SectionKind::pieces, Payload().varint(n));
    ++meshes_;
    in_pieces_ = true;
    return *this;
  }
  Bytes finish() { return out_.finish(meshes_); }

 private:
  ContainerWriter out_;
  std::uint64_t meshes_ = 0;
  bool in_pieces_ = false;
};

inline Bytes zstd_frame(std::span<const std::byte> data) {
  Bytes out(ZSTD_compressBound(data.size()));
  out.resize(ZSTD_compress(out.data(), out.size(), data.data(), data.size(), 1));
  return out;
}

/// An attribute without a prediction, whose planes of bytes are these.
inline Payload attribute_section(std::string_view name, Domain domain, Scalar scalar,
                                 unsigned components, std::span<const std::byte> frame) {
  Payload p;
  p.u8(static_cast<std::uint32_t>(name.size())).text(name);
  p.u8(static_cast<std::uint32_t>(domain)).u8(static_cast<std::uint32_t>(scalar));
  return std::move(p.u8(components).u8(0).u8(0).raw(frame));  // words, predicted from nothing
}

/// Faces one by one, in a stream that need not hold them.
inline Payload raw_mesh(std::uint64_t vertices, std::uint64_t faces, std::uint64_t corners,
                        std::size_t stream_bytes = 2) {
  Bytes stream(stream_bytes);
  stream[stream_bytes - 1] = std::byte{1};  // the state 256, when there are two
  return std::move(
      Payload().u8(feature::raw).varint(vertices).varint(faces).varint(corners).raw(stream));
}

/// The tetrahedron of format.md, and vertices without a face.
inline Payload tetrahedron_mesh(std::uint64_t others = 0) {
  Payload p;
  p.u8(0).varint(others).u8(4).u8(0).u8(0).u8(0x23);
  return std::move(p.u8(0).u8(0x41));
}

}  // namespace clers::internal::test

#endif
