// What undoes the cuts: which vertices of a surface are copies of one vertex of the mesh.
//
// A surface cut along non-manifold edges has the same edges on several sheets. So the copy of a
// vertex mostly is, on another sheet, a neighbour of what its own neighbours are copies of; those
// are tried first.
#ifndef CLERS_CODEC_STITCHING_H
#define CLERS_CODEC_STITCHING_H

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "codec/event_model.h"

namespace clers {

/// Codes the classes of surface vertices, along the faces. The class of a vertex is named by its
/// first member that a face has. Cost: linear; 68 bytes a vertex.
class Stitching {
 public:
  static constexpr std::uint32_t unknown = 0xffffffffu;
  /// Bytes that it takes, the classes not counted.
  static constexpr std::uint64_t memory(std::uint64_t vertices) {
    return vertices * (sizeof(std::uint32_t) + sizeof(Near)) + vertices / 8 + 8;
  }

  /// `corners` are triangles of surface vertices, all below `vertices`.
  Stitching(std::span<const std::uint32_t> corners, std::uint32_t vertices)
      : corners_(corners), turns_(vertices), near_(vertices), done_(vertices) {
    // Around an interior vertex, every neighbour comes next as often as it came before.
    for (std::size_t i = 0; i < corners.size(); i += 3)
      for (unsigned j = 0; j < 3; ++j)
        turns_[corners[i + j]] += corners[i + (j + 1) % 3] - corners[i + (j + 2) % 3];
  }

  /// A Coder that encodes is told all classes; one that decodes fills them in. False: what was
  /// decoded names no class.
  template <class Coder>
  bool code(Coder& coder, std::span<std::uint32_t> classes) {
    for (std::size_t i = 0; i < corners_.size(); i += 3) {
      const std::span<const std::uint32_t> face = corners_.subspan(i, 3);
      for (const std::uint32_t v : face) {
        if (done_[v]) continue;
        gather(face, classes);
        const bool copy = coder.bit(copy_[context(v)], classes[v] != v);
        classes[v] = copy ? code_class(coder, v, classes[v]) : v;
        if (classes[v] == unknown || classes[classes[v]] != classes[v]) return false;
        done_[v] = true;
      }
      for (unsigned j = 0; j < 3; ++j)
        for (unsigned k = 1; k < 3; ++k) near_[classes[face[j]]].add(classes[face[(j + k) % 3]]);
    }
    return true;
  }

 private:
  /// Classes seen beside one, the latest first.
  struct alignas(64) Near {
    std::array<std::uint32_t, 16> at;
    Near() { at.fill(unknown); }
    void add(std::uint32_t c) {
      auto end = std::find(at.begin(), at.end() - 1, c);
      std::copy_backward(at.begin(), end, end + 1);
      at[0] = c;
    }
    bool has(std::uint32_t c) const { return std::find(at.begin(), at.end(), c) != at.end(); }
  };

  /// What is known around the vertex to come: candidates, those beside two known corners first.
  void gather(std::span<const std::uint32_t> face, std::span<const std::uint32_t> classes) {
    known_ = copies_ = shared_ = 0;
    candidates_ = 0;
    std::array<std::uint32_t, 2> corners{};
    for (const std::uint32_t w : face) {
      if (!done_[w] || known_ == 2) continue;
      copies_ += classes[w] != w;
      corners[known_++] = classes[w];
    }
    if (known_ == 2)
      for (const std::uint32_t c : near_[corners[1]].at)
        if (c != unknown && c != corners[0] && near_[corners[0]].has(c))
          candidate_[candidates_++] = c;
    shared_ = candidates_;
    for (unsigned k = known_; k-- > 0;)
      for (const std::uint32_t c : near_[corners[k]].at) {
        const auto end = candidate_.begin() + candidates_;
        if (c != unknown && c != corners[0] && (known_ < 2 || c != corners[1]) &&
            std::find(candidate_.begin(), end, c) == end)
          candidate_[candidates_++] = c;
      }
  }

  unsigned context(std::uint32_t v) const {
    const bool interior = turns_[v] == 0;
    return ((interior * 3 + known_) * 3 + copies_) * 2 + (shared_ > 0);
  }

  template <class Coder>
  std::uint32_t code_class(Coder& coder, std::uint32_t v, std::uint32_t value) {
    for (unsigned i = 0; i < candidates_; ++i) {
      const bool beside_both = i < shared_;
      const unsigned rank = std::min(beside_both ? i : i - shared_, 7u);
      if (coder.bit(taken_[beside_both][turns_[v] == 0][rank], value == candidate_[i])) {
        return last_ = candidate_[i];
      }
    }
    const std::uint32_t c = code_from(coder, far_, last_, value);
    if (c >= done_.size() || !done_[c]) return unknown;
    return last_ = c;
  }

  std::span<const std::uint32_t> corners_;
  std::vector<std::uint32_t> turns_;  ///< 0: interior, as far as a context needs to know
  std::vector<Near> near_;
  std::vector<bool> done_;
  std::array<std::uint32_t, 32> candidate_{};
  unsigned known_ = 0, copies_ = 0, candidates_ = 0, shared_ = 0;
  std::uint32_t last_ = 0;
  BitModel copy_[36];
  BitModel taken_[2][2][8];
  NumberModel far_;
};

/// Numbers of mesh vertices from classes: those that name their class, in their order. Returns how
/// many there are.
inline std::uint32_t number_classes(std::span<std::uint32_t> classes) {
  std::uint32_t count = 0;
  std::vector<std::uint32_t> number(classes.size());
  for (std::uint32_t v = 0; v < classes.size(); ++v)
    if (classes[v] == v) number[v] = count++;
  for (std::uint32_t& c : classes) c = number[c];
  return count;
}

}  // namespace clers

#endif
