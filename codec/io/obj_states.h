// What statements of an OBJ say of all faces after them: objects, groups, materials, smoothing.
#ifndef CLERS_CODEC_IO_OBJ_STATES_H
#define CLERS_CODEC_IO_OBJ_STATES_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "codec/io/text.h"
#include "codec/mesh.h"

namespace clers::io {

/// As a face attribute: the number of a name among the lines of the metadata. Faces before the
/// first such statement have no value.
struct ObjState {
  std::string_view keyword, attribute, key;
  std::string_view one, many;  ///< for notes
};
inline constexpr std::array<ObjState, 4> obj_states = {{
    {"o", "object", "obj.objects", "object", "objects"},
    {"g", "group", "obj.groups", "group", "groups"},
    {"usemtl", "material", "obj.materials", "material", "materials"},
    {"s", "smoothing", "obj.smoothing", "smoothing group", "smoothing groups"},
}};
inline constexpr std::size_t obj_object = 0;
inline constexpr std::string_view obj_libraries_key = "obj.mtllib";

/// The index of a keyword in obj_states; their count if it is none of them.
std::size_t obj_state_of(std::string_view keyword);

/// The names of one state, and the faces that have them.
class ObjNames {
 public:
  /// From face `face` on.
  void begin(std::string name, std::size_t face);

  const std::vector<std::string>& names() const { return names_; }
  /// The attribute and what its numbers are. Precondition: there are names.
  void add_to(Mesh& mesh, const ObjState& state, std::size_t faces) const;

 private:
  struct Run {
    std::size_t face;
    std::uint32_t name;
  };
  std::vector<std::string> names_;
  std::map<std::string, std::uint32_t, std::less<>> numbers_;
  std::vector<Run> runs_;
};

/// The states of the faces of a mesh that is written, and the order in which statements can say
/// them.
class ObjFaces {
 public:
  explicit ObjFaces(const Mesh& mesh);

  /// Whether statements say this attribute.
  bool says(const Attribute& a) const;

  /// Faces as they are to be written; empty: as they are in the mesh. They are put together by
  /// their names where they are not, since a name that is said twice makes two objects for some
  /// programs.
  const std::vector<std::uint32_t>& order() const { return order_; }

  /// The statements that face `f` needs after those that were written.
  void begin(Output& out, std::size_t f);
  /// Those that no face needs.
  void end(Output& out);

 private:
  using Numbers = std::array<std::uint32_t, obj_states.size()>;
  Numbers of(std::size_t f) const;
  static unsigned said(const Numbers& numbers);
  void put_together(std::size_t faces);
  void say(Output& out, std::size_t state, std::uint32_t number);

  std::array<std::vector<std::string>, obj_states.size()> names_;
  std::array<const Attribute*, obj_states.size()> attributes_{};
  std::array<std::vector<bool>, obj_states.size()> used_;
  std::vector<std::uint32_t> order_;
  Numbers current_;
};

}  // namespace clers::io

#endif
