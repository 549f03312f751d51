#include "corpus/random_gluing.h"

#include <cstddef>
#include <utility>

#include "corpus/build.h"
#include "corpus/random.h"

namespace clers::corpus {
namespace {

// Corners that have become one vertex. A corner has two sides, so a class is a path or a ring of
// corners: one fan, whatever is glued.
class Vertices {
 public:
  explicit Vertices(std::uint32_t corners) : parent_(corners), members_(corners) {
    for (std::uint32_t c = 0; c < corners; ++c) {
      parent_[c] = c;
      members_[c].push_back(c);
    }
  }

  std::uint32_t of(std::uint32_t corner) {
    while (parent_[corner] != corner) corner = parent_[corner] = parent_[parent_[corner]];
    return corner;
  }

  /// Precondition: a and b are representatives.
  void unite(std::uint32_t a, std::uint32_t b) {
    if (a == b) return;
    if (members_[a].size() > members_[b].size()) std::swap(a, b);
    parent_[a] = b;
    members_[b].insert(members_[b].end(), members_[a].begin(), members_[a].end());
    members_[a] = {};
  }

  /// Whether some face has corners in both. Precondition: a and b are different representatives.
  bool share_a_face(std::uint32_t a, std::uint32_t b) {
    if (members_[a].size() > members_[b].size()) std::swap(a, b);
    for (const std::uint32_t c : members_[a])
      if (of(next_corner(c)) == b || of(prev_corner(c)) == b) return true;
    return false;
  }

 private:
  std::vector<std::uint32_t> parent_;
  std::vector<std::vector<std::uint32_t>> members_;
};

class Gluer {
 public:
  Gluer(std::uint32_t triangles, bool loops)
      : loops_(loops),
        twin_(std::size_t{3} * triangles, no_twin),
        next_(twin_.size()),
        prev_(twin_.size()),
        slot_(twin_.size()),
        vertices_(3 * triangles) {}

  std::uint32_t free_edges() const { return static_cast<std::uint32_t>(free_.size()); }
  std::uint32_t random_free(Random& random) const { return free_[random.below(free_edges())]; }
  std::uint32_t next(std::uint32_t h) const { return next_[h]; }

  void add_triangle(std::uint32_t f) {
    for (std::uint32_t h = 3 * f; h < 3 * f + 3; ++h) {
      next_[h] = next_corner(h);
      prev_[h] = prev_corner(h);
      slot_[h] = free_edges();
      free_.push_back(h);
    }
  }

  // Glues two boundary edges, unless they are one or that makes a loop where none may be.
  bool glue(std::uint32_t h, std::uint32_t t) {
    if (h == t) return false;
    std::uint32_t from = vertices_.of(h), to = vertices_.of(next_corner(h));
    const std::uint32_t t_from = vertices_.of(t), t_to = vertices_.of(next_corner(t));
    if (!loops_) {
      // Both ends are united: from with t_to, to with t_from.
      if (from != t_to && vertices_.share_a_face(from, t_to)) return false;
      if (to != t_from && vertices_.share_a_face(to, t_from)) return false;
    }
    vertices_.unite(from, t_to);
    vertices_.unite(vertices_.of(to), vertices_.of(t_from));
    twin_[h] = t;
    twin_[t] = h;
    // The curve before h goes on after t and the other way round; right for neighbours too. A curve
    // of one edge just disappears.
    const bool alone = next_[h] == h, t_alone = next_[t] == t;
    const std::uint32_t before_h = prev_[h], after_h = next_[h];
    const std::uint32_t before_t = prev_[t], after_t = next_[t];
    if (!alone) link(before_h, t_alone ? after_h : after_t);
    if (!t_alone) link(before_t, alone ? after_t : after_h);
    release(h);
    release(t);
    return true;
  }

  Gluing result() && {
    Gluing out;
    out.twin = std::move(twin_);
    out.org.resize(out.twin.size());
    std::vector<std::uint32_t> number(out.twin.size(), no_twin);
    for (std::uint32_t h = 0; h < out.org.size(); ++h) {
      std::uint32_t& vertex = number[vertices_.of(h)];
      if (vertex == no_twin) vertex = out.vertex_count++;
      out.org[h] = vertex;
    }
    return out;
  }

 private:
  void link(std::uint32_t h, std::uint32_t t) {
    next_[h] = t;
    prev_[t] = h;
  }

  void release(std::uint32_t h) {
    const std::uint32_t last = free_.back();
    free_[slot_[h]] = last;
    slot_[last] = slot_[h];
    free_.pop_back();
  }

  bool loops_;
  std::vector<std::uint32_t> twin_;
  std::vector<std::uint32_t> next_, prev_;  // along boundary curves, of boundary half-edges
  std::vector<std::uint32_t> free_, slot_;  // boundary half-edges, and where each is in that list
  Vertices vertices_;
};

}  // namespace

Gluing random_gluing(std::uint32_t triangles, std::uint64_t seed, const GluingOptions& options) {
  Random random(seed);
  Gluer gluer(triangles, options.loops);
  const auto keep =
      static_cast<std::uint32_t>(std::uint64_t{3} * triangles * options.boundary / 100);
  const auto close = [&] {
    const std::uint32_t h = gluer.random_free(random);
    const std::uint32_t t = random.chance(options.zips) ? gluer.next(h) : gluer.random_free(random);
    return gluer.glue(h, t);
  };

  for (std::uint32_t f = 0; f < triangles; ++f) {
    // Some are closed early, or all vertices would lie on the boundary till the end.
    if (gluer.free_edges() > keep + 2 && random.chance(30)) close();
    const bool apart = gluer.free_edges() == 0 || random.chance(options.apart);
    const std::uint32_t base = apart ? no_twin : gluer.random_free(random);
    gluer.add_triangle(f);
    if (!apart) gluer.glue(3 * f + random.below(3), base);
  }
  // Without loops, what is left may not be gluable: a run of failures says so.
  std::uint32_t failures = 0;
  while (gluer.free_edges() >= keep + 2 && failures < 4 * gluer.free_edges() + 100)
    failures = close() ? 0 : failures + 1;
  return std::move(gluer).result();
}

}  // namespace clers::corpus
