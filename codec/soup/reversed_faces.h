// Faces that were reversed so that their component is oriented: which they are, coded as runs in
// the order of the coded faces. Decoding reverses them again. Knows faces only as cycles of
// corners. codec/format.md, Reversed faces.
#ifndef CLERS_CODEC_SOUP_REVERSED_FACES_H
#define CLERS_CODEC_SOUP_REVERSED_FACES_H

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "codec/base/faces.h"
#include "codec/entropy/stream.h"
#include "codec/order.h"

namespace clers::internal {

/// A maximal sequence of reversed faces.
struct ReversedRun {
  std::uint32_t first;
  std::uint32_t count;  ///< at least 1
};

/// The number of faces in the runs.
inline std::uint64_t count_reversed(std::span<const ReversedRun> runs) {
  std::uint64_t faces = 0;
  for (const ReversedRun& run : runs) faces += run.count;
  return faces;
}

/// Codes runs in their order, each by the faces since the run before and by its length. A coder
/// that decodes fills them in. Returns what is wrong with them as runs of `faces` faces; empty:
/// nothing.
template <class Coder>
std::string code_reversed(Coder& coder, std::span<ReversedRun> runs, std::uint64_t faces) {
  NumberModel between, length;
  std::uint32_t end = 0;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    ReversedRun& run = runs[i];
    const std::uint32_t gap = between.code(coder, run.first - end);
    const std::uint32_t more = length.code(coder, run.count - 1);
    run = {end + gap, more + 1};
    if (run.first < end || (i > 0 && run.first == end) || run.first >= faces || run.count == 0 ||
        run.count > faces - run.first)
      return "a run of reversed faces is out of order or beyond all faces";
    end = run.first + run.count;
  }
  return {};
}

/// The runs of the faces `reversed`, in the order of the coded faces. `order` has the corners that
/// reversed faces begin with, and then those of the input that they are. `faces`: before or after.
inline std::vector<ReversedRun> reversed_runs(const Faces& faces,
                                              std::span<const std::uint32_t> reversed,
                                              Permutation& order) {
  std::vector<ReversedRun> runs;
  if (reversed.empty()) return runs;
  std::vector<bool> is_reversed(faces.count());
  for (const std::uint32_t f : reversed) is_reversed[f] = true;
  for (std::uint32_t i = 0, end = 0; i < order.faces.size(); ++i) {
    const std::uint32_t f = order.faces[i];
    if (!is_reversed[f]) continue;
    std::uint32_t& first = order.first_corners[i];
    if (first > 0) first = faces.size(f) - first;
    if (runs.empty() || i != end) runs.push_back({i, 0});
    ++runs.back().count;
    end = i + 1;
  }
  return runs;
}

inline EncodedStream encode_reversed(std::vector<ReversedRun> runs, std::uint64_t faces) {
  return {{runs.size()},
          encode_stream([&](EncodeTo& coder) { code_reversed(coder, std::span(runs), faces); })};
}

/// What a mesh says of its reversed faces before it is decoded.
struct ReversedHeader {
  std::uint64_t runs = 0;
  Stream stream;

  void read(ByteReader& in) { stream = read_stream(in, {&runs}); }
  /// Why a surface of so many faces cannot have them; empty: it can.
  std::string fault(std::uint64_t faces) const {
    if (runs > 0 && runs <= faces) return {};
    return std::to_string(runs) + " runs of reversed faces among " + std::to_string(faces);
  }
  std::uint64_t memory() const { return sizeof(ReversedRun) * runs; }
};

/// Precondition: no fault. Error: invalid.
inline Expected<std::vector<ReversedRun>> decode_reversed(const ReversedHeader& header,
                                                          std::uint64_t faces) {
  std::vector<ReversedRun> runs(static_cast<std::size_t>(header.runs));
  auto ok = decode_stream(header.stream, "the reversed faces", [&](DecodeFrom& coder) {
    return code_reversed(coder, std::span(runs), faces);
  });
  if (!ok) return Failure{ok.error()};
  return runs;
}

/// Calls visit(begin, size) with the first corner of each face in the runs. `sizes` empty:
/// triangles.
template <class Visit>
void for_each_in_runs(std::span<const std::uint32_t> sizes, std::span<const ReversedRun> runs,
                      Visit visit) {
  std::size_t face = 0, begin = 0;
  const auto size = [&](std::size_t f) { return sizes.empty() ? std::size_t(3) : sizes[f]; };
  for (const ReversedRun& run : runs) {
    for (; face < run.first; ++face) begin += size(face);
    for (; face < std::size_t(run.first) + run.count; begin += size(face++))
      visit(begin, size(face));
  }
}

/// Reverses faces, each from its first corner on.
inline void reverse_runs(std::span<std::uint32_t> corners, std::span<const std::uint32_t> sizes,
                         std::span<const ReversedRun> runs) {
  for_each_in_runs(sizes, runs, [&](std::size_t begin, std::size_t size) {
    const auto cycle = corners.subspan(begin, size);
    std::reverse(cycle.begin() + 1, cycle.end());
  });
}

/// The same of what corners have, so many bytes each.
inline void reverse_runs(std::span<std::byte> values, std::size_t width,
                         std::span<const std::uint32_t> sizes, std::span<const ReversedRun> runs) {
  for_each_in_runs(sizes, runs, [&](std::size_t begin, std::size_t size) {
    std::byte* const cycle = values.data() + begin * width;
    for (std::size_t i = 1, j = size - 1; i < j; ++i, --j)
      std::swap_ranges(cycle + i * width, cycle + (i + 1) * width, cycle + j * width);
  });
}

}  // namespace clers::internal

#endif
