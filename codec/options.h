// What encoding and decoding can be asked for.
#ifndef CLERS_CODEC_OPTIONS_H
#define CLERS_CODEC_OPTIONS_H

#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include <clers/limits.h>
#include <clers/order.h>
#include <clers/precision.h>
#include <clers/topology/export.h>

namespace CLERS_VISIBLE clers {

inline constexpr int min_level = 1, max_level = 9, default_level = 5;

/// What to do with faces that many programs do not expect.
enum class DefectPolicy : std::uint8_t {
  keep,    ///< encode them: they come back as they are
  reject,  ///< fail, and name the first
};

/// For EncodeOptions::piece_faces: more than any mesh has.
inline constexpr std::uint32_t never_in_pieces = 0xffffffffu;
/// What is done if piece_faces is not set: meshes with positions and more faces than the first
/// number are coded in pieces of at most about the second.
inline constexpr std::uint32_t most_faces_whole = 1u << 20, default_piece_faces = 1u << 18;

struct EncodeOptions {
  /// 1 fastest .. 9 smallest. Of connectivity levels 1 and 2 are alike, 3 and 4, 5 to 8. Values are
  /// predicted along the order of triangles at 1 to 4; from 5 on from all that is known around
  /// them, in contexts of how far off others were; from 7 on positions also in an order in which
  /// more is known; at 9 also by many predictions mixed. From 5 on several ways are tried, and that
  /// which takes least is kept.
  int level = default_level;

  /// A mesh of more faces than this, at least 1, is coded in pieces of about this many, each of
  /// which decodes alone: in less memory, and several at a time. Not set: most_faces_whole.
  std::optional<std::uint32_t> piece_faces = {};

  /// Work on meshes and pieces, or on the attributes of a mesh that is alone. 0: one a core. The
  /// bytes do not depend on it.
  unsigned threads = 1;

  /// How exactly the values of attributes come back. What is not named here is lossless. Errors:
  /// bad_option where no mesh has such an attribute, where one is named twice, and for numbers out
  /// of their range.
  std::vector<AttributePrecision> precisions = {};

  Order order = Order::free;
  DefectPolicy on_nonmanifold = DefectPolicy::keep;  ///< an edge of more than two faces, or of two
                                                     ///< that run along it the same way; a vertex
                                                     ///< whose faces form more than one fan
  DefectPolicy on_degenerate = DefectPolicy::keep;   ///< a face that repeats a vertex, or has fewer
                                                     ///< than three
  DefectPolicy on_duplicate = DefectPolicy::keep;    ///< a face on the same vertices as another

  /// If not empty, called from the calling thread with the name of the stage and the share of the
  /// work that is done, 0 to 1, never decreasing. What it throws ends the work and passes through.
  std::function<void(std::string_view stage, double done)> progress = {};

  /// What is asked for an attribute.
  Precision precision_of(std::string_view name, Domain domain = Domain::vertex) const {
    for (const AttributePrecision& asked : precisions)
      if (asked.name == name && (!asked.domain || asked.domain == domain)) return asked.precision;
    return {};
  }
};

struct DecodeOptions {
  Limits limits = {};
  std::function<void(std::string_view stage, double done)> progress = {};  ///< as in EncodeOptions
  unsigned threads = 1;  ///< as in EncodeOptions; neither results nor errors depend on it
};

}  // namespace clers

#endif
