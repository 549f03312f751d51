#include <utility>
#include <vector>

#include "corpus/build.h"
#include "corpus/generate.h"
#include "corpus/random.h"

namespace clers::corpus {
namespace {

// A triangle mesh whose edges can be flipped.
class Flipper {
 public:
  Flipper(std::vector<std::uint32_t>& corners, std::uint32_t vertex_count)
      : corners_(corners), twin_(twins_of(corners, vertex_count)) {}

  //        c                  c
  //       / \                /|\.
  //      / h \              / | \.
  //     a --- b     ->     a  |  b
  //      \ t /              \ | /
  //       \ /                \|/
  //        d                  d
  void try_flip(std::uint32_t h) {
    const std::uint32_t t = twin_[h];
    if (t == no_twin) return;
    const std::uint32_t hn = next_corner(h), hp = prev_corner(h);
    const std::uint32_t tn = next_corner(t), tp = prev_corner(t);
    const std::uint32_t c = corners_[hp], d = corners_[tp];
    // Where a or b has three edges only and none is on a boundary, c d is an edge already.
    if (c == d || adjacent(hp, d)) return;

    // Face of h becomes (d, b, c), face of t becomes (c, a, d); h and t stay twins, now along c d.
    const std::uint32_t bc = twin_[hn], ca = twin_[hp], ad = twin_[tn], db = twin_[tp];
    const std::uint32_t a = corners_[h], b = corners_[t];
    corners_[h] = c, corners_[hn] = d, corners_[hp] = b;
    corners_[t] = d, corners_[tn] = c, corners_[tp] = a;
    join(hn, db), join(hp, bc), join(tn, ca), join(tp, ad);
  }

 private:
  void join(std::uint32_t h, std::uint32_t t) {
    twin_[h] = t;
    if (t != no_twin) twin_[t] = h;
  }

  // Visits the half-edges that leave the origin of h, and at a boundary the one that only arrives;
  // `visit(vertex)` gets the other end and says whether to go on.
  template <class Visit>
  void around(std::uint32_t h, Visit visit) const {
    std::uint32_t e = h;
    do {
      if (!visit(corners_[next_corner(e)])) return;
      const std::uint32_t arriving = prev_corner(e);
      e = twin_[arriving];
      if (e == no_twin) {
        if (!visit(corners_[arriving])) return;
        // The rest of an open star lies on the other side of h.
        for (e = twin_[h]; e != no_twin; e = twin_[next_corner(e)])
          if (!visit(corners_[prev_corner(e)])) return;
        return;
      }
    } while (e != h);
  }

  bool adjacent(std::uint32_t h, std::uint32_t vertex) const {
    bool found = false;
    around(h, [&](std::uint32_t v) { return !(found = v == vertex); });
    return found;
  }

  std::vector<std::uint32_t>& corners_;
  std::vector<std::uint32_t> twin_;
};

}  // namespace

Mesh flip_edges(Mesh mesh, std::uint64_t tries, std::uint64_t seed) {
  if (mesh.corners.empty()) return mesh;
  Flipper flipper(mesh.corners, mesh.vertex_count);
  Random random(seed);
  for (; tries > 0; --tries)
    flipper.try_flip(random.below(static_cast<std::uint32_t>(mesh.corners.size())));
  return mesh;
}

}  // namespace clers::corpus
