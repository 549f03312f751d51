#include "codec/decode.h"

#include <new>
#include <utility>

#include "codec/mesh_reader.h"

namespace clers {
namespace {

Expected<Mesh> decode_mesh(const MeshSections& sections) {
  Mesh mesh;
  mesh.name = sections.name;
  mesh.vertex_count = static_cast<std::uint32_t>(sections.vertices);
  mesh.corners.resize(3 * std::size_t(sections.connectivity.faces));
  auto counts = decode_connectivity(sections.connectivity_bytes, sections.connectivity_at,
                                    sections.connectivity, mesh.corners);
  if (!counts) return Failure{counts.error()};
  for (const MeshSections::AttributeSection& a : sections.attributes) {
    auto attribute = decode_attribute(a.bytes, a.at, a.header, a.count, mesh.corners);
    if (!attribute) return Failure{attribute.error()};
    mesh.attributes.push_back(std::move(*attribute));
  }
  for (const TurnedRun& run : sections.turned)
    for (std::size_t f = run.first; f < std::size_t(run.first) + run.count; ++f)
      std::swap(mesh.corners[3 * f + 1], mesh.corners[3 * f + 2]);
  return mesh;
}

}  // namespace

Expected<std::vector<Mesh>> decode(std::span<const std::byte> bytes,
                                   const DecodeOptions& options) try {
  ContainerReader file(bytes);
  auto sections = read_meshes(file, options.limits);
  if (!sections) return Failure{sections.error()};
  std::vector<Mesh> meshes;
  for (std::size_t i = 0; i < sections->size(); ++i) {
    if (options.progress)
      options.progress("decode", static_cast<double>(i) / static_cast<double>(sections->size()));
    auto mesh = decode_mesh((*sections)[i]);
    if (!mesh) {
      Error error = mesh.error();
      if (sections->size() > 1) error.what += " (mesh " + std::to_string(i) + ")";
      return Failure{error};
    }
    meshes.push_back(std::move(*mesh));
  }
  if (options.progress) options.progress("done", 1.0);
  return meshes;
} catch (const std::bad_alloc&) {
  return fail(ErrorCode::out_of_memory, "not enough memory to decode");
}

}  // namespace clers
