// A header of 12 bytes, then chunks, each with a header of 8.
#include "codec/gltf/glb.h"

#include "codec/entropy/bytes.h"

namespace clers::gltf {
namespace {

constexpr std::uint32_t magic = 0x46546c67, chunk_json = 0x4e4f534a;  // "glTF", "JSON"
constexpr std::size_t header_size = 12, chunk_header_size = 8;

std::size_t filled(std::size_t size) {
  return (size + 3) / 4 * 4;
}

void put_chunk(internal::Bytes& out, const Chunk& chunk, std::byte fill) {
  const std::size_t size = filled(chunk.bytes.size());
  internal::put_u32(out, static_cast<std::uint32_t>(size));
  internal::put_u32(out, chunk.type);
  internal::put_bytes(out, chunk.bytes);
  out.resize(out.size() + size - chunk.bytes.size(), fill);
}

}  // namespace

bool is_glb(std::span<const std::byte> bytes) {
  return bytes.size() >= 4 && internal::ByteReader(bytes, 0).u32() == magic;
}

Expected<Glb> split(std::span<const std::byte> bytes) {
  internal::ByteReader in(bytes, 0);
  const auto malformed = [&](std::uint64_t at, std::string what) {
    return fail(ErrorCode::malformed, Place::byte, at, std::move(what));
  };
  in.u32();
  const std::uint32_t version = in.u32(), length = in.u32();
  if (!in.ok()) return malformed(bytes.size(), "a .glb ends within its header");
  if (version != 2)
    return fail(ErrorCode::unsupported, Place::byte, 4,
                "a .glb of version " + std::to_string(version) + ", expected 2");
  if (length != bytes.size())
    return malformed(8, "a .glb of " + std::to_string(bytes.size()) + " bytes, its header says " +
                            std::to_string(length));
  Glb glb;
  for (bool first = true; in.left() > 0 || first; first = false) {
    const std::uint64_t at = in.offset();
    const std::uint32_t size = in.u32();
    Chunk chunk{in.u32(), {}};
    chunk.bytes = in.take(size);
    if (!in.ok()) return malformed(at, "a chunk goes beyond the end of the .glb");
    if (!first) {
      glb.others.push_back(chunk);
      continue;
    }
    if (chunk.type != chunk_json) return malformed(at, "expected a chunk of JSON first");
    glb.json = {reinterpret_cast<const char*>(chunk.bytes.data()), chunk.bytes.size()};
  }
  return glb;
}

Expected<std::vector<std::byte>> join(std::string_view json, std::span<const Chunk> others) {
  const Chunk first{chunk_json, std::as_bytes(std::span(json))};
  std::uint64_t size = header_size + chunk_header_size + filled(json.size());
  for (const Chunk& chunk : others) size += chunk_header_size + filled(chunk.bytes.size());
  if (size > 0xffffffffu)
    return fail(ErrorCode::too_large,
                std::to_string(size) + " bytes are more than a .glb can have");
  internal::Bytes out;
  out.reserve(static_cast<std::size_t>(size));
  internal::put_u32(out, magic);
  internal::put_u32(out, 2);
  internal::put_u32(out, static_cast<std::uint32_t>(size));
  put_chunk(out, first, std::byte{' '});
  for (const Chunk& chunk : others) put_chunk(out, chunk, std::byte{0});
  return out;
}

}  // namespace clers::gltf
