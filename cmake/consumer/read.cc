// A mesh file in memory, read by clers::io, and a scene, by clers::gltf.
#include <string_view>

#include <clers/gltf.h>
#include <clers/io.h>

int main() {
  constexpr std::string_view file = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  const auto read = clers::io::read(std::as_bytes(std::span(file)), clers::io::Format::off);
  constexpr std::string_view scene = "{\"asset\":{\"version\":\"2.0\"}}";
  const auto as_read = clers::gltf::read(std::as_bytes(std::span(scene)), {});
  if (!as_read || !clers::gltf::write(as_read->scene)) return 1;
  return read && read->meshes[0].face_count() == 1 && read->meshes[0].position() ? 0 : 1;
}
