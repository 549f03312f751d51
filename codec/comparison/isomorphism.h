// Is one component the other one renumbered? Two that are get a bijection of their vertices.
//
// Guess the image of a single corner: across an edge of two faces there is no choice, so the guess
// decides a whole sheet. Where sheets meet in a vertex or edge, guess again, and go back when a
// guess was wrong.
#ifndef CLERS_CODEC_COMPARISON_ISOMORPHISM_H
#define CLERS_CODEC_COMPARISON_ISOMORPHISM_H

#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "codec/comparison/compared_mesh.h"
#include "codec/comparison/components.h"
#include "codec/verdict.h"
#include "topology/buckets.h"

namespace clers::internal {

/// The corners at each vertex, sorted by the vertex that follows in the face.
class Stars {
 public:
  /// Cost: linear (two passes of counting sort).
  explicit Stars(const ComparedMesh& mesh);

  std::span<const std::uint32_t> at(std::uint32_t v) const { return corners_[v]; }
  /// The corners at u whose face runs on to v. Cost: a binary search.
  std::span<const std::uint32_t> along(std::uint32_t u, std::uint32_t v) const;

 private:
  const Faces& faces_;
  Buckets corners_;
};

/// A coloured mesh with its components and stars.
struct Side {
  Side(const ComparedMesh& coloured, const Classes& faces_by_colour)
      : mesh(coloured), components(coloured, faces_by_colour), stars(coloured) {}

  const ComparedMesh& mesh;
  Components components;
  Stars stars;
};

class Isomorphism {
 public:
  /// For components of meshes with as many vertices and faces as this one, and the same attributes.
  /// After `budget` visits of corners, all searches together, it gives up.
  Isomorphism(const ComparedMesh& mesh, std::uint64_t budget);

  /// Component k of `from` and component l of `to`: is there a bijection that keeps faces, cycles
  /// and colours? `same` is true up to collisions of colours; `different` is certain.
  Verdict search(const Side& from, std::uint32_t k, const Side& to, std::uint32_t l);

  /// What the last search found, if it was `same`: vertices of `from` and the vertices they become.
  const std::vector<std::uint32_t>& vertices() const { return vertices_; }
  std::uint32_t image(std::uint32_t v) const { return image_[v]; }

 private:
  using Index = std::uint32_t;

  /// A guess where a corner goes, and the state to go back to when it was wrong.
  struct Choice {
    Index corner = 0;
    std::span<const Index> candidates = {};
    std::size_t at = 0;  ///< the next candidate
    std::size_t vertices = 0, matches = 0, cursor = 0;
  };

  void go_back_to(const Choice& choice);
  Choice first_choice(Index k, Index l);
  std::optional<Choice> next_choice();
  bool match(Index from, Index to);
  bool propagate();
  bool match_along(Index u, Index v);
  template <class Name>
  Colour known(const ComparedMesh& mesh, Index c, Name name);
  bool has_unknown(Index f) const;

  const Side *from_ = nullptr, *to_ = nullptr;
  std::vector<Index> image_, origin_;             // vertices of from_ -> to_, and back
  std::vector<bool> matched_from_, matched_to_;   // faces
  std::vector<Index> vertices_;                   // matched, in order
  std::vector<std::pair<Index, Index>> matches_;  // faces matched, in order
  std::size_t cursor_ = 0;                        // vertices_ before it have no unmatched face
  std::vector<Index> queue_;                      // faces whose edges are to be followed
  std::vector<Index> first_candidates_;
  Classes along_from_, along_to_;  // of match_along
  std::uint64_t work_ = 0, budget_;
};

}  // namespace clers::internal

#endif
