// What the document of a scene says besides its glTF: the member "CLERS" at its end.
#ifndef CLERS_CODEC_GLTF_MARKS_H
#define CLERS_CODEC_GLTF_MARKS_H

#include <cstdint>
#include <vector>

#include "codec/gltf/gltf.h"
#include "codec/gltf/json.h"
#include <clers/error.h>

namespace clers::gltf {

inline constexpr char marks_key[] = "CLERS";

inline constexpr std::uint64_t style_count = 5;

struct Marks {
  Form form = Form::glb;
  std::vector<std::uint64_t> empty;   ///< buffers without bytes
  std::vector<std::uint64_t> odd;     ///< runs, see make_plan
  std::vector<std::uint64_t> chunks;  ///< types of unknown chunks of a .glb
  std::uint64_t style = 0;            ///< how numbers are written: a Style of bounds.h
  std::vector<std::uint64_t> loose;   ///< accessors whose bounds are not true
};

/// Adds them as the last member.
void put_marks(const Marks& marks, Json& document);
/// Takes them off. Errors: unsupported, if there are none; malformed.
Expected<Marks> take_marks(Json& document);

/// The numbers as a list of which of `count` things. Those above are left out.
std::vector<bool> as_set(const std::vector<std::uint64_t>& numbers, std::size_t count);
std::vector<std::uint64_t> as_list(const std::vector<bool>& set);

}  // namespace clers::gltf

#endif
