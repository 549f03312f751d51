#include "codec/decode.h"

#include <new>
#include <utility>

#include "codec/mesh_decoder.h"

namespace clers {
namespace {

Expected<Mesh> decode_mesh(const MeshSections& sections) {
  auto decoded = decode_faces(sections);
  if (!decoded) return Failure{decoded.error()};
  Mesh& mesh = decoded->mesh;
  const std::span<const std::uint32_t> triangles =
      decoded->all_on_surface ? mesh.corners : decoded->triangles;
  for (const MeshSections::AttributeSection& a : sections.attributes) {
    auto attribute = decode_attribute(a.bytes, a.at, a.header, a.count, triangles);
    if (!attribute) return Failure{attribute.error()};
    mesh.attributes.push_back(std::move(*attribute));
  }
  turn_back(mesh, decoded->turned);
  if (auto ok = restore_order(sections, mesh); !ok) return Failure{ok.error()};
  return std::move(mesh);
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
