// The one interface through which the benchmark drives every codec, ours and the rivals.
#ifndef CLERS_BENCH_CODEC_H
#define CLERS_BENCH_CODEC_H

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "bench/input.h"

namespace clers::bench {

/// What is coded. connectivity: triangles alone. q<b>: triangles and positions, on one cubic grid,
/// its side the longest side of the bounding box, 2^b - 1 steps, nearest (Draco's -qp b). lossless:
/// triangles and the bits of float positions. file: all that a mesh file holds.
enum class Mode { connectivity, q11, q14, q16, lossless, file };

inline constexpr Mode all_modes[] = {Mode::connectivity, Mode::q11,      Mode::q14,
                                     Mode::q16,          Mode::lossless, Mode::file};

constexpr const char* name(Mode mode) {
  constexpr const char* names[] = {"connectivity", "q11", "q14", "q16", "lossless", "file"};
  return names[static_cast<int>(mode)];
}

/// Bits of the grid; 0 if there is none.
constexpr int bits(Mode mode) {
  return mode == Mode::q11 ? 11 : mode == Mode::q14 ? 14 : mode == Mode::q16 ? 16 : 0;
}

/// Why a codec could not do it: what() goes into the results.
struct CodecFailure : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// What came back, with the renumbering that the codec claims. The claim is checked, not believed.
struct Output {
  std::vector<std::uint32_t> triangles;  ///< corners, indices of the output's vertices
  std::vector<std::uint32_t> origin;     ///< origin[v]: the input's vertex that v is said to be
  std::vector<float> positions;          ///< 3 for each vertex; empty in mode connectivity
  std::vector<Mesh> meshes;              ///< in mode file, instead of the others
};

/// A codec at work on one mesh in one mode. Every member may throw std::exception.
class Codec {
 public:
  virtual ~Codec() = default;

  /// Converts the input into what the codec's API takes. Not timed, its memory not counted.
  virtual void prepare(const Input& input, Mode mode) = 0;

  /// Timed. Keeps the bytes.
  virtual void encode() = 0;

  /// Size of what encode() made.
  virtual std::size_t bytes() const = 0;

  /// Of these, what the positions take; 0 if it is not known.
  virtual std::size_t position_bytes() const { return 0; }

  /// Timed. Decodes what encode() made and keeps the result.
  virtual void decode() = 0;

  /// Frees the result of decode(). Not timed.
  virtual void discard() = 0;

  /// The result of decode(). Not timed; may run the codec again to follow the vertices.
  virtual Output output() = 0;
};

/// A row of the tables.
struct CodecEntry {
  std::string name;
  std::vector<Mode> modes;
  std::function<std::unique_ptr<Codec>()> make;
  bool timed = true;  ///< false: it works in another process, so that only bytes can be compared
};

}  // namespace clers::bench

#endif
