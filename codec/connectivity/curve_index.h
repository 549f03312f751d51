// Places along boundary curves: which vertex is so many edges back, and how far back a vertex is.
//
// The front (topology/front.h) knows of each vertex only the one before it. To count along a curve
// takes its length, and handles would make that quadratic: they cut long curves and join them,
// again and again. So what was counted once is kept, in blocks of a few vertices that follow each
// other, and the blocks of a curve in a sequence that can be searched, cut and joined.
//
// Nothing is kept of a curve until a handle asks for it, and C, L, R and S know nothing of this:
// all they do to what is kept is to take vertices off its front (C, S), or to put curves together
// that are kept each for itself. A vertex knows its block. So gather(), which walks a curve from
// its front, jumps where it meets a block that is known, to the end of all that is known with it,
// drops what is in front of the vertex that it met, and walks only where nobody did before.
#ifndef CLERS_CODEC_CONNECTIVITY_CURVE_INDEX_H
#define CLERS_CODEC_CONNECTIVITY_CURVE_INDEX_H

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "codec/connectivity/sequences.h"
#include "topology/front.h"

namespace clers::internal {

/// Curves of a front by place. A curve is counted backwards: place k + 1 is prev of place k. The
/// gate's curve x -> y starts with x and ends with y; a ring has no gate, and starts anywhere.
/// Cost of each operation: O(log n) amortised, and of gather() the vertices made since, once.
/// Memory: 4 bytes a vertex id, 32 bytes for every 32 vertices, and 128 a handle at most.
/// Throws std::bad_alloc only.
class CurveIndex {
 public:
  using Curve = Sequences::Node;  ///< until what follows it is cut or joined

  /// `links` are those of the front. Nothing is allocated before the first gather().
  CurveIndex(const FrontLink* links, std::size_t vertex_ids)
      : links_(links), vertex_ids_(vertex_ids) {}

  /// The curve of a gate. No vertex of it may be on a ring.
  Curve gather(std::uint32_t x, std::uint32_t y) {
    if (block_of_.empty()) block_of_.resize(vertex_ids_);
    Curve curve = 0;
    std::uint32_t v = x;
    for (;;) {
      if (const Sequences::Node known = block_of_[v]) {
        Curve part = starting_with(known, v);
        if (walked_.count > 0 && walked_.count + sequences_.places(part) <= block_size) {
          ends_[part].first = walked_.vertices[0];
          add_walked(part);
        } else {
          curve = put_walked(curve);
        }
        part = sequences_.last(part);
        curve = sequences_.join(curve, part);
        v = ends_[part].last;
      } else {
        walked_.vertices[walked_.count++] = v;
        if (walked_.count == block_size) curve = put_walked(curve);
      }
      if (v == y) return put_walked(curve);
      v = links_[v].prev;
    }
  }

  std::uint32_t length(Curve c) const { return sequences_.length(c); }

  /// The vertex at a place. `c` names the curve afterwards as before.
  std::uint32_t vertex(Curve& c, std::uint32_t place) {
    c = sequences_.find(c, place);
    return walk(ends_[c].first, place - sequences_.before(c));
  }

  /// The curve of a vertex that is on one, and where.
  std::pair<Curve, std::uint32_t> place(std::uint32_t v) {
    const Curve c = sequences_.to_root(block_of_[v]);
    std::uint32_t place = sequences_.before(c);
    for (std::uint32_t u = ends_[c].first; u != v; u = links_[u].prev) ++place;
    return {c, place};
  }

  /// A special S on the gate's curve c glues x to the vertex at place d: the ring of those at 1 ..
  /// d. The others behind it stay the gate's. Before the glue.
  Curve split_off(Curve c, std::uint32_t d) {
    auto [front, rest] = cut(c, d + 1);
    auto [x, ring] = cut(front, 1);
    sequences_.release(x);
    return ring;
  }

  /// A special S on the gate's curve c glues x to the vertex at a place of a ring, which becomes
  /// part of the gate's curve. Before the glue.
  void join(Curve c, Curve ring, std::uint32_t place) {
    auto [x, rest] = cut(c, 1);
    sequences_.release(x);
    auto [before, after] = cut(ring, place + 1);
    sequences_.join(sequences_.join(after, before), rest);
  }

  /// A number that a ring keeps, 0 for the curve of the gate.
  std::uint32_t name(Curve c) const { return sequences_.name(c); }
  void set_name(Curve ring, std::uint32_t name) { sequences_.set_name(ring, name); }

 private:
  static constexpr std::uint32_t block_size = 32;

  struct Ends {
    std::uint32_t first, last;  ///< vertices of a block
  };

  std::uint32_t walk(std::uint32_t v, std::uint32_t steps) const {
    while (steps-- > 0) v = links_[v].prev;
    return v;
  }

  Sequences::Node make(std::uint32_t first) {
    const Sequences::Node n = sequences_.make(0);
    if (n >= ends_.size()) ends_.resize(n + std::size_t(1));
    ends_[n].first = first;
    return n;
  }

  /// What was walked becomes part of the block that is a tree's root.
  void add_walked(Sequences::Node block) {
    for (std::uint32_t i = 0; i < walked_.count; ++i) block_of_[walked_.vertices[i]] = block;
    sequences_.resize(block, sequences_.places(block) + walked_.count);
    walked_.count = 0;
  }

  /// What was walked becomes the end of a curve: part of its last block, or a new one.
  Curve put_walked(Curve curve) {
    if (walked_.count == 0) return curve;
    if (curve) curve = sequences_.last(curve);
    Curve block = curve;
    if (!curve || sequences_.places(curve) + walked_.count > block_size)
      block = make(walked_.vertices[0]);
    ends_[block].last = walked_.vertices[walked_.count - 1];
    add_walked(block);
    return block == curve ? curve : sequences_.join(curve, block);
  }

  /// The vertices in front of v are on this curve no more.
  Sequences::Node starting_with(Sequences::Node block, std::uint32_t v) {
    sequences_.to_root(block);
    sequences_.release(sequences_.cut_before(block));
    if (ends_[block].first == v) return block;
    std::uint32_t left = 1;
    for (std::uint32_t u = v; u != ends_[block].last; u = links_[u].prev) ++left;
    sequences_.resize(block, left);
    ends_[block].first = v;
    return block;
  }

  /// The first k places, and the rest.
  std::pair<Curve, Curve> cut(Curve c, std::uint32_t k) {
    if (k == sequences_.length(c)) return {c, 0};
    c = sequences_.find(c, k);
    const std::uint32_t within = k - sequences_.before(c), places = sequences_.places(c);
    if (within == 0) {
      const Curve first = sequences_.cut_before(c);
      return {first, c};
    }
    // The block that is cut keeps its front.
    const Curve rest = sequences_.cut_after(c);
    const std::uint32_t last = walk(ends_[c].first, within - 1), end = ends_[c].last;
    sequences_.resize(c, within);
    ends_[c].last = last;
    std::uint32_t v = links_[last].prev;
    const Sequences::Node block = make(v);
    sequences_.resize(block, places - within);
    ends_[block].last = end;
    for (block_of_[v] = block; v != end; block_of_[v] = block) v = links_[v].prev;
    return {c, sequences_.join(block, rest)};
  }

  struct Walked {
    std::uint32_t vertices[block_size];
    std::uint32_t count = 0;
  };

  const FrontLink* links_;
  std::size_t vertex_ids_;
  Walked walked_;  ///< by gather(): vertices that follow each other, without a block yet
  Sequences sequences_;
  std::vector<Ends> ends_;                 ///< by block
  std::vector<Sequences::Node> block_of_;  ///< by vertex
};

}  // namespace clers::internal

#endif
