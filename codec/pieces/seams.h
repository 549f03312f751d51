// The seam of a piece: which of its vertices are vertices of pieces before it. Knows vertices by
// their numbers in the piece and in the mesh, and nothing of faces. codec/format.md, Pieces.
//
// Along a seam the boundary vertices of both pieces were finished one after the other, in opposite
// directions. So numbers run up in one piece and down in the other, and what is coded are runs:
//
//     this piece        12 -- 13 -- 14 -- 15 -- 16 -- 17
//     pieces before     96 -- 95 -- 94 -- 93    31 -- 30       two runs, both down
#ifndef CLERS_CODEC_PIECES_SEAMS_H
#define CLERS_CODEC_PIECES_SEAMS_H

#include <algorithm>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "codec/entropy/stream.h"
#include "codec/piece.h"

namespace clers::internal {

/// Vertices first, first + 1 .. of a piece are global, global + 1 .. of the mesh, or down from
/// there.
struct SeamRun {
  std::uint32_t first = 0;
  std::uint32_t global = 0;
  std::uint32_t count = 1;  ///< at least 1
  bool down = true;

  std::uint32_t global_at(std::uint32_t i) const { return down ? global - i : global + i; }
};

/// Codes runs in their order.
class SeamModel {
 public:
  /// What is decoded may be anywhere.
  template <class Coder>
  SeamRun code(Coder& coder, SeamRun run) {
    run.first = end_ + between_.code(coder, run.first - end_);
    run.global = code_from(coder, jump_, next_, run.global);
    run.count = 1 + length_.code(coder, run.count - 1);
    run.down = run.count == 1 || coder.bit(down_, run.down);
    end_ = run.first + run.count;
    next_ = run.global_at(run.count);
    return run;
  }

 private:
  NumberModel between_, jump_, length_;
  BitModel down_;
  std::uint32_t end_ = 0, next_ = 0;  ///< what would go on the run before
};

/// The runs of a seam. `numbers[v]` is the number of vertex v in the mesh; those of the seam are
/// below `first_own`.
inline std::vector<SeamRun> seam_runs(std::span<const std::uint32_t> numbers,
                                      std::uint32_t first_own) {
  std::vector<SeamRun> runs;
  const auto shared = [&](std::size_t v) { return v < numbers.size() && numbers[v] < first_own; };
  for (std::size_t v = 0; v < numbers.size();) {
    if (!shared(v)) {
      ++v;
      continue;
    }
    SeamRun run{static_cast<std::uint32_t>(v), numbers[v], 1, true};
    if (shared(v + 1)) run.down = numbers[v + 1] != numbers[v] + 1;
    while (shared(++v) && numbers[v] == run.global_at(run.count)) ++run.count;
    if (run.count == 1) run.down = true;
    runs.push_back(run);
  }
  return runs;
}

/// The seam of a piece, `shared` vertices: as seam_runs() finds it.
inline Bytes encode_seam(std::uint64_t shared, std::span<const std::uint32_t> numbers,
                         std::uint32_t first_own) {
  Bytes out;
  put_varint(out, shared);
  put_bytes(out, encode_stream([&](EncodeTo& coder) {
              SeamModel model;
              for (const SeamRun& run : seam_runs(numbers, first_own)) model.code(coder, run);
            }));
  return out;
}

/// What a seam says before it is decoded. The stream is all that follows.
struct SeamHeader {
  std::uint64_t shared = 0;  ///< vertices
  Stream stream;

  void read(ByteReader& in) {
    shared = in.varint();
    const std::uint64_t at = in.offset();
    stream = {in.take(in.left()), at};
  }
};

/// The vertices of pieces before, in the order of the piece, of which `vertices` can be among them.
/// There are `before` vertices in those pieces. Error: invalid. Memory besides the result: 4 bytes
/// each.
inline Expected<std::vector<SharedVertex>> decode_seam(const SeamHeader& header,
                                                       std::uint64_t vertices,
                                                       std::uint64_t before) {
  std::vector<SharedVertex> seam;
  if (header.shared == 0) return seam;
  seam.reserve(static_cast<std::size_t>(header.shared));
  auto ok = decode_stream(header.stream, "the seam", [&](DecodeFrom& coder) -> std::string {
    SeamModel model;
    std::uint64_t end = 0;
    while (seam.size() < header.shared) {
      const SeamRun run = model.code(coder, {});
      const std::uint64_t left = header.shared - seam.size();
      const bool fits = run.count > 0 && run.count <= left && run.first >= end &&
                        run.first < vertices && run.count <= vertices - run.first &&
                        run.global < before &&
                        run.count - 1 <= (run.down ? run.global : before - 1 - run.global);
      if (!fits) return "a seam is out of order or has no such vertex";
      for (std::uint32_t i = 0; i < run.count; ++i)
        seam.push_back({run.first + i, run.global_at(i)});
      end = std::uint64_t(run.first) + run.count;
    }
    return {};
  });
  if (!ok) return Failure{ok.error()};
  std::vector<std::uint32_t> numbers;
  numbers.reserve(seam.size());
  for (const SharedVertex& v : seam) numbers.push_back(v.number);
  std::sort(numbers.begin(), numbers.end());
  if (std::adjacent_find(numbers.begin(), numbers.end()) != numbers.end())
    return fail(ErrorCode::invalid, Place::byte, header.stream.at, "a seam has a vertex twice");
  return seam;
}

}  // namespace clers::internal

#endif
