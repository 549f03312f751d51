// A mesh file in memory, read by clers::io.
#include <string_view>

#include <clers/io.h>

int main() {
  constexpr std::string_view file = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  const auto read = clers::io::read(std::as_bytes(std::span(file)), clers::io::Format::off);
  return read && read->meshes[0].face_count() == 1 && read->meshes[0].position() ? 0 : 1;
}
