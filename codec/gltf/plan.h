// What becomes of each run of values: the same for who reads a glTF and who writes it, by its JSON.
#ifndef CLERS_CODEC_GLTF_PLAN_H
#define CLERS_CODEC_GLTF_PLAN_H

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "codec/gltf/layout.h"

namespace clers::gltf {

/// A face attribute that says which of several lists a triangle is from.
inline constexpr char list_name[] = "list";

/// Primitives that are one mesh.
struct MeshPlan {
  struct Slot {
    std::string name;
    std::size_t run;
  };
  std::string name;
  std::uint32_t vertices = 0;
  std::vector<Slot> attributes;
  std::vector<std::size_t> lists;  ///< runs of indices, three a triangle
  bool in_turn = false;  ///< the last list is the vertices 0, 1, 2 .. themselves, three a triangle
  bool keep = false;     ///< the order of vertices and triangles

  std::size_t list_count() const { return lists.size() + in_turn; }
};

/// Runs, one after the other, that are one array.
struct ArrayPlan {
  std::string name;
  Scalar scalar = Scalar::float32;  ///< of the runs; in the scene vertices are Scalar::uint32
  std::uint8_t components = 1;      ///< of a value, which may be several elements of a run
  std::size_t mesh = none;          ///< whose vertices the values are
  std::vector<std::size_t> runs;
};

struct Plan {
  std::vector<MeshPlan> meshes;
  std::vector<ArrayPlan> arrays;
  /// For each run, the first that is the same bytes in the same way: only this has a part in the
  /// plan.
  std::vector<std::size_t> first;
  /// For each run, whether meshes and arrays have its bytes. Those of others stay where they are.
  std::vector<bool> taken;
};

/// `odd`: for each run, whether it is indices that are out of range, or of a sparse part and do not
/// ascend. That takes bytes to see, so it is said in the document. Errors: malformed.
Expected<Plan> make_plan(const Layout& layout, const Json& document, const std::vector<bool>& odd);

}  // namespace clers::gltf

#endif
