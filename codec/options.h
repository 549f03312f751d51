// What encoding and decoding can be asked for.
#ifndef CLERS_CODEC_OPTIONS_H
#define CLERS_CODEC_OPTIONS_H

#include <cstdint>
#include <functional>
#include <string_view>

#include "codec/limits.h"
#include "codec/order.h"

namespace clers {

inline constexpr int min_level = 1, max_level = 9, default_level = 5;

/// For EncodeOptions::piece_faces.
inline constexpr std::uint32_t most_faces_whole = 1u << 20, default_piece_faces = 1u << 18,
                               never_in_pieces = 0xffffffffu;

/// What to do with faces that most programs do not expect.
enum class OnOddity : std::uint8_t {
  keep,   ///< they come back as they were
  error,  ///< encoding fails and names the first
};

struct EncodeOptions {
  int level = default_level;  ///< 1 fastest .. 9 smallest

  /// A mesh of more faces is coded in pieces of about so many, which decode alone: in less memory,
  /// and by several threads. 0: in pieces of at most about default_piece_faces, if it has positions
  /// and more than most_faces_whole faces.
  std::uint32_t piece_faces = 0;
  unsigned threads = 1;  ///< over meshes and pieces, or the attributes of a single one; 0: one a
                         ///< core. They make no difference to the bytes

  Order order = Order::free;
  OnOddity on_nonmanifold = OnOddity::keep;  ///< edges of more than two faces or of two that run
                                             ///< the same way, vertices of several fans
  OnOddity on_degenerate = OnOddity::keep;   ///< faces that repeat a vertex, or have under three
  OnOddity on_duplicate = OnOddity::keep;    ///< faces on the same vertices as an earlier one

  /// Called now and then with the name of the stage and the share of the whole work that is done,
  /// 0..1, never decreasing; from the calling thread. May be empty. What it throws ends the work
  /// and passes through.
  std::function<void(std::string_view stage, double done)> progress;
};

struct DecodeOptions {
  Limits limits;
  std::function<void(std::string_view stage, double done)> progress;  ///< as in EncodeOptions
  unsigned threads = 1;  ///< over meshes and pieces, or the attributes of a single one; 0: one a
                         ///< core. They make no difference to the result, errors included
};

}  // namespace clers

#endif
