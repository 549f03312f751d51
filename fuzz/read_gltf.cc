// Any bytes as a glTF: what is read can be encoded and written, and reads back the same.
#include <cstdint>
#include <cstdlib>
#include <span>

#include "codec/decode.h"
#include "codec/encode.h"
#include "codec/gltf/gltf.h"

namespace {

namespace gltf = clers::gltf;

void require(bool holds) {
  if (!holds) std::abort();
}

clers::Expected<std::vector<std::byte>> no_file(const std::string&) {
  return clers::fail(clers::ErrorCode::io_failed, "no such file");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto read = gltf::read(std::as_bytes(std::span(data, size)), no_file);
  if (!read) {
    require(read.error().code != clers::ErrorCode::internal && !read.error().what.empty());
    return 0;
  }
  const auto encoded = clers::encode(read->scene, {}, read->orders);
  require(encoded.ok());
  const auto scene = clers::decode_scene(encoded->bytes);
  require(scene.ok() && scene->document == read->scene.document);
  const auto written = gltf::write(*scene, {gltf::Form::gltf, "", true});
  require(written.ok());
  const auto again = gltf::read(written->bytes, no_file);
  require(again.ok() && again->scene.meshes.size() == read->scene.meshes.size());
  return 0;
}
