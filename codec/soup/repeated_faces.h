// Faces on the vertices of an earlier face, in the same cycle or in the reversed one: all they need
// is to say which. So a doubled surface is coded once, and its edges are those of one surface.
// Decoding appends them to the faces of the surface. codec/format.md, Mesh.
#ifndef CLERS_CODEC_SOUP_REPEATED_FACES_H
#define CLERS_CODEC_SOUP_REPEATED_FACES_H

#include <algorithm>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "codec/base/faces.h"
#include "codec/entropy/stream.h"
#include "codec/order.h"
#include "codec/soup/reversed_faces.h"

namespace clers::internal {

/// A face that repeats another one.
struct Repeat {
  std::uint32_t face, base;  ///< base: the first face in file order on this cycle
};

/// Codes repeats by ascending base.
class RepeatModel {
 public:
  struct Code {
    std::uint32_t base;  ///< in the order of the coded faces
    bool reversed;       ///< against the coded face, which may be reversed itself
  };
  /// What is decoded may be no face.
  template <class Coder>
  Code code(Coder& coder, Code value) {
    const std::uint32_t step = step_[consecutive_].code(coder, value.base - last_);
    consecutive_ = step == 1;
    last_ += step;
    reversed_ = coder.bit(reversed_model_[reversed_], value.reversed);
    return {last_, reversed_};
  }

 private:
  std::uint32_t last_ = 0;
  bool consecutive_ = false, reversed_ = false;
  NumberModel step_[2];
  BitModel reversed_model_[2];
};

/// Encodes faces of `all` that repeat others, and appends them to the `order`, which has those that
/// do not, of which runs are `reversed`.
inline EncodedStream encode_repeats(const Faces& all, std::span<const Repeat> repeats,
                                    std::span<const ReversedRun> reversed, Permutation& order) {
  const auto distinct = static_cast<std::uint32_t>(order.faces.size());
  std::vector<std::uint32_t> place(all.count());
  for (std::uint32_t i = 0; i < distinct; ++i) place[order.faces[i]] = i;
  std::vector<bool> is_reversed(distinct);
  for (const ReversedRun& run : reversed)
    for (std::uint32_t i = 0; i < run.count; ++i) is_reversed[run.first + i] = true;

  struct Coded {
    RepeatModel::Code code;
    std::uint32_t face, first_corner;
  };
  std::vector<Coded> coded;
  coded.reserve(repeats.size());
  for (const auto& [face, base] : repeats) {
    const std::uint32_t at = place[base], size = all.size(face);
    const auto cycle = all.cycle(face), base_cycle = all.cycle(base);
    const std::uint32_t first = order.first_corners[at];
    const auto begin = static_cast<std::uint32_t>(
        std::find(cycle.begin(), cycle.end(), base_cycle[first]) - cycle.begin());
    const bool same = cycle[(begin + 1) % size] == base_cycle[(first + 1) % size];
    coded.push_back({{at, same == is_reversed[at]}, face, begin});
  }
  std::sort(coded.begin(), coded.end(), [](const Coded& a, const Coded& b) {
    if (a.code.base != b.code.base) return a.code.base < b.code.base;
    return a.code.reversed != b.code.reversed ? b.code.reversed : a.face < b.face;
  });
  std::uint64_t corners = 0;
  Bytes bytes = encode_stream([&](EncodeTo& coder) {
    RepeatModel model;
    for (const Coded& c : coded) {
      model.code(coder, c.code);
      order.faces.push_back(c.face);
      order.first_corners.push_back(c.first_corner);
      corners += all.size(c.face);
    }
  });
  return {{repeats.size(), corners}, std::move(bytes)};
}

/// What a mesh says of its repeated faces before it is decoded.
struct RepeatsHeader {
  std::uint64_t faces = 0, corners = 0;
  Stream stream;

  void read(ByteReader& in) { stream = read_stream(in, {&faces, &corners}); }
  /// Why the stream cannot have them; empty: it can.
  std::string fault() const {
    if (faces > 0 && faces <= stream.max_decisions() && corners / 3 >= faces &&
        corners <= max_corners)
      return {};
    return std::to_string(faces) + " repeated faces of " + std::to_string(corners) +
           " corners cannot be coded in " + std::to_string(stream.bytes.size()) + " bytes";
  }
};

/// Appends the faces that repeat one of the first `bases`, whose corners are there; no sizes:
/// triangles. Precondition: no fault. Error: invalid.
inline Expected<Done> append_repeats(const RepeatsHeader& header, std::uint64_t bases,
                                     std::vector<std::uint32_t>& sizes,
                                     std::vector<std::uint32_t>& corners) {
  return decode_stream(header.stream, "the repeated faces", [&](DecodeFrom& coder) -> std::string {
    RepeatModel model;
    std::uint64_t left = header.corners;
    std::uint32_t face = 0;
    std::size_t begin = 0;  // of the face, in corners
    for (std::uint64_t i = 0; i < header.faces; ++i) {
      const RepeatModel::Code repeat = model.code(coder, {});
      if (repeat.base < face || repeat.base >= bases)
        return "repeated face " + std::to_string(i) + " repeats none";
      for (; face < repeat.base; ++face) begin += sizes.empty() ? 3 : sizes[face];
      const std::uint32_t size = sizes.empty() ? 3 : sizes[face];
      if (size > left) return "more repeated corners than declared";
      left -= size;
      if (!sizes.empty()) sizes.push_back(size);
      corners.push_back(corners[begin]);
      for (std::uint32_t j = 1; j < size; ++j)
        corners.push_back(corners[begin + (repeat.reversed ? size - j : j)]);
    }
    return left == 0 ? "" : "fewer repeated corners than declared";
  });
}

}  // namespace clers::internal

#endif
