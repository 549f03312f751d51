// A pass over the faces.
#include "codec/gltf/triangles.h"

#include <algorithm>
#include <cstring>
#include <numeric>
#include <string>

#include "codec/gltf/plan.h"
#include "codec/gltf/values.h"

namespace clers::gltf {
namespace {

Failure<Error> wrong(std::string what) {
  return fail(ErrorCode::inconsistent_mesh, std::move(what));
}

}  // namespace

const Attribute* lists_of(const Mesh& mesh) {
  for (const Attribute& a : mesh.attributes)
    if (a.domain == Domain::face && a.name == list_name) return &a;
  return nullptr;
}

Expected<std::vector<Corners>> part_triangles(const Mesh& mesh) {
  if (!mesh.triangles_only() || mesh.corners.size() % 3 != 0)
    return wrong("faces that are no triangles");
  const Attribute* list_of = lists_of(mesh);
  const std::size_t faces = mesh.face_count();
  if (list_of != nullptr &&
      (list_of->scalar != Scalar::uint32 || list_of->components != 1 || !list_of->indices.empty() ||
       list_of->data.size() != faces * sizeof(std::uint32_t)))
    return wrong("a face attribute '" + std::string(list_name) + "' that says no lists");
  std::vector<Corners> lists(faces > 0);
  for (std::size_t f = 0; f < faces; ++f) {
    std::uint32_t list = 0;
    if (list_of != nullptr) std::memcpy(&list, list_of->data.data() + f * sizeof list, sizeof list);
    // Lists are as many as they have faces at most.
    if (list >= faces) return wrong("a face of list " + std::to_string(list));
    if (list >= lists.size()) lists.resize(std::size_t(list) + 1);
    for (std::size_t c = 3 * f; c < 3 * f + 3; ++c) {
      if (mesh.corners[c] >= mesh.vertex_count) return wrong("a corner without a vertex");
      lists[list].push_back(mesh.corners[c]);
    }
  }
  return lists;
}

Expected<std::vector<std::uint32_t>> vertex_numbers(std::uint32_t vertices,
                                                    const std::vector<Corners>& lists,
                                                    bool in_turn) {
  std::vector<std::uint32_t> numbers(vertices);
  if (!in_turn) {
    std::iota(numbers.begin(), numbers.end(), 0u);
    return numbers;
  }
  if (lists.empty() || lists.back().size() != vertices)
    return wrong("no triangles that have vertices of their own");
  std::vector<bool> known(vertices);
  std::uint32_t next = 0;
  for (const std::uint32_t v : lists.back()) {
    if (known[v]) return wrong("a vertex in two triangles that have vertices of their own");
    known[v] = true;
    numbers[v] = next++;
  }
  return numbers;
}

bool is_values_of(const Attribute& a, const Run& run) {
  return a.domain == Domain::vertex && a.scalar == run.scalar && a.components == run.components() &&
         a.indices.empty() && a.data.size() == packed_size(run);
}

std::vector<std::byte> renumbered(const Attribute& a, const std::vector<std::uint32_t>& numbers) {
  std::vector<std::byte> data(a.data.size());
  const std::size_t size = a.stride();
  for (std::size_t v = 0; v < numbers.size(); ++v)
    std::memcpy(data.data() + numbers[v] * size, a.data.data() + v * size, size);
  return data;
}

}  // namespace clers::gltf
