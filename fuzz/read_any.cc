// Any bytes as a mesh file: what is read can be written as PLY, binary and text, and reads back
// equal. The first byte picks the format.
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <span>
#include <vector>

#include "codec/io/io.h"

namespace {

using clers::Attribute;
using clers::Domain;
using clers::Mesh;
namespace io = clers::io;

void require(bool holds) {
  if (!holds) std::abort();
}

/// A value for each element, zeros where one is missing: PLY shares none.
std::vector<std::byte> by_element(const Attribute& a) {
  if (a.indices.empty()) return a.data;
  std::vector<std::byte> values(a.indices.size() * a.stride());
  for (std::size_t i = 0; i < a.indices.size(); ++i)
    if (a.indices[i] != clers::no_value)
      std::memcpy(values.data() + i * a.stride(), a.data.data() + a.indices[i] * a.stride(),
                  a.stride());
  return values;
}

bool equal(const Attribute& a, const Attribute& b) {
  return a.name == b.name && a.domain == b.domain && a.scalar == b.scalar &&
         a.components == b.components && by_element(a) == by_element(b);
}

bool equal(const Mesh& a, const Mesh& b) {
  return a.vertex_count == b.vertex_count && a.corners == b.corners &&
         a.face_sizes == b.face_sizes && a.name == b.name &&
         std::equal(a.attributes.begin(), a.attributes.end(), b.attributes.begin(),
                    b.attributes.end(),
                    [](const Attribute& x, const Attribute& y) { return equal(x, y); });
}

void check_consistent(const Mesh& mesh) {
  std::size_t corners = 0;
  for (const std::uint32_t size : mesh.face_sizes) corners += size;
  require(mesh.triangles_only() ? mesh.corners.size() % 3 == 0 : mesh.corners.size() == corners);
  for (const std::uint32_t v : mesh.corners) require(v < mesh.vertex_count);
  const std::size_t counts[] = {mesh.vertex_count, mesh.corners.size(), mesh.face_count()};
  for (const Attribute& a : mesh.attributes) {
    const std::size_t count = counts[static_cast<unsigned>(a.domain)];
    require(a.components > 0 && a.data.size() % a.stride() == 0);
    require((a.indices.empty() ? a.value_count() : a.indices.size()) == count);
    for (const std::uint32_t i : a.indices) require(i == clers::no_value || i < a.value_count());
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  constexpr io::Format formats[] = {io::Format::ply, io::Format::obj, io::Format::off,
                                    io::Format::stl};
  const auto read = io::read(std::as_bytes(std::span(data + 1, size - 1)), formats[data[0] % 4]);
  if (!read) {
    require(!read.error().what.empty());
    return 0;
  }
  require(read->meshes.size() == 1);
  const Mesh& mesh = read->meshes[0];
  check_consistent(mesh);

  const auto binary = io::write(read->meshes, io::Format::ply, io::Encoding::binary);
  if (!binary) {  // only for want of anything to write about the vertices
    require(std::none_of(mesh.attributes.begin(), mesh.attributes.end(),
                         [](const Attribute& a) { return a.domain == Domain::vertex; }));
    return 0;
  }
  const auto again = io::read(binary->bytes, io::Format::ply);
  require(again.ok() && equal(mesh, again->meshes[0]));

  const auto text = io::write(read->meshes, io::Format::ply, io::Encoding::text);
  require(text.ok());
  const auto from_text = io::read(text->bytes, io::Format::ply);
  require(from_text.ok());
  const bool lost_nans = text->notes.size() != binary->notes.size();
  require(lost_nans || equal(mesh, from_text->meshes[0]));
  return 0;
}
