#include "codec/cut.h"

#include <algorithm>
#include <bit>
#include <deque>
#include <numeric>
#include <optional>
#include <span>
#include <utility>

#include "codec/edges.h"

namespace clers {
namespace {

constexpr std::uint32_t none = HalfEdge::null_index;

/// Sets of faces that are glued, each face turned or not relative to its set.
class Orientation {
 public:
  explicit Orientation(std::uint32_t faces) : parent_(faces), turned_(faces), size_(faces, 1) {
    std::iota(parent_.begin(), parent_.end(), 0u);
  }

  struct Place {
    std::uint32_t set;
    bool turned;
  };
  Place find(std::uint32_t f) {
    bool turned = false;
    while (parent_[f] != f) {  // path halving: f hangs below its grandparent now
      const std::uint32_t p = parent_[f];
      turned_[f] ^= turned_[p];
      parent_[f] = parent_[p];
      turned ^= turned_[f];
      f = parent_[f];
    }
    return {f, turned};
  }

  /// Makes g turned relative to f as told, unless it is known to be otherwise.
  bool unite(std::uint32_t f, std::uint32_t g, bool turn) {
    Place a = find(f), b = find(g);
    if (a.set == b.set) return (a.turned != b.turned) == turn;
    const bool relative = (a.turned != b.turned) != turn;
    if (size_[a.set] < size_[b.set]) std::swap(a, b);
    parent_[b.set] = a.set;
    turned_[b.set] = relative;
    size_[a.set] += size_[b.set];
    return true;
  }

  /// Whether some set has as many turned faces as others.
  bool tied() {
    std::vector<std::int64_t> surplus(parent_.size());
    for (std::uint32_t f = 0; f < parent_.size(); ++f) {
      const Place p = find(f);
      surplus[p.set] += p.turned ? 1 : -1;
    }
    for (std::uint32_t f = 0; f < parent_.size(); ++f)
      if (parent_[f] == f && surplus[f] == 0) return true;
    return false;
  }

  /// Which faces to turn: the fewer of each set; if it is a tie, not the first in `order`.
  std::vector<bool> turned(std::span<const std::uint32_t> order) {
    const std::uint32_t faces = static_cast<std::uint32_t>(parent_.size());
    std::vector<std::uint32_t> count(faces);
    std::vector<bool> result(faces), first_turned(faces), reached(faces);
    for (const std::uint32_t f : order) {
      const Place p = find(f);
      result[f] = p.turned;
      count[p.set] += p.turned;
      if (!reached[p.set]) first_turned[p.set] = p.turned;
      reached[p.set] = true;
    }
    for (std::uint32_t f = 0; f < faces; ++f) {
      const std::uint32_t set = find(f).set;
      const std::uint64_t twice = 2 * std::uint64_t(count[set]);
      if (twice > size_[set] || (twice == size_[set] && first_turned[set])) result[f] = !result[f];
    }
    return result;
  }

 private:
  std::vector<std::uint32_t> parent_;
  std::vector<std::uint8_t> turned_;  ///< relative to the parent; 0 at a root
  std::vector<std::uint32_t> size_;   ///< of the set, at its root
};

/// The finaliser of splitmix64 (Steele, Lea and Flood 2014).
std::uint64_t mix(std::uint64_t x) {
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

/// Colours, numbers for faces and vertices that depend on how they hang together and not on their
/// order: so that the same mesh in another order is cut the same way, as far as it has no
/// symmetries.
class Refinement {
 public:
  explicit Refinement(const Faces& faces, std::vector<std::uint64_t> vertex_colours)
      : faces_(faces), vertex(std::move(vertex_colours)), face(faces.count()) {
    colour_faces();
  }

  /// Colours of what is up to `rounds` faces away come in.
  void refine(int rounds) {
    for (; rounds > 0; --rounds) {
      std::vector<std::uint64_t> around(vertex.size());
      each_side([&](std::uint32_t f, std::uint32_t v, std::uint32_t w) {
        around[v] += mix(face[f] + vertex[w]);
      });
      for (std::size_t v = 0; v < vertex.size(); ++v) vertex[v] = mix(vertex[v] * 5 + around[v]);
      colour_faces();
    }
  }

  /// Refines until all faces look different, or no more do, or patience ends.
  void refine() {
    std::size_t different = 0;
    for (int rounds = 4; rounds <= 16; rounds *= 2) {
      refine(rounds);
      std::vector<std::uint64_t> sorted = face;
      std::sort(sorted.begin(), sorted.end());
      const auto end = std::unique(sorted.begin(), sorted.end());
      const std::size_t now = static_cast<std::size_t>(end - sorted.begin());
      if (now == face.size() || now == different) return;
      different = now;
    }
  }

 private:
  /// Calls visit(face, vertex, next vertex).
  template <class Visit>
  void each_side(Visit visit) const {
    for (std::uint32_t f = 0; f < faces_.count(); ++f) {
      const auto cycle = faces_.cycle(f);
      for (std::size_t j = 0, before = cycle.size() - 1; j < cycle.size(); before = j++)
        visit(f, cycle[before], cycle[j]);
    }
  }
  void colour_faces() {
    for (std::uint32_t f = 0; f < faces_.count(); ++f) face[f] = faces_.size(f);
    each_side([&](std::uint32_t f, std::uint32_t v, std::uint32_t w) {
      face[f] += mix(vertex[v] * 3 + mix(vertex[w]));
    });
    for (std::uint64_t& colour : face) colour = mix(colour);
  }

  const Faces& faces_;

 public:
  std::vector<std::uint64_t> vertex, face;
};

/// Faces by their colours, those of one colour in their order; all_different becomes false if there
/// are such.
std::vector<std::uint32_t> by_colour(std::span<const std::uint64_t> colours, bool& all_different) {
  std::vector<std::pair<std::uint64_t, std::uint32_t>> keyed(colours.size());
  for (std::uint32_t f = 0; f < keyed.size(); ++f) keyed[f] = {colours[f], f};
  std::sort(keyed.begin(), keyed.end());
  std::vector<std::uint32_t> faces(keyed.size());
  for (std::size_t i = 0; i < faces.size(); ++i) {
    faces[i] = keyed[i].second;
    if (i > 0 && keyed[i].first == keyed[i - 1].first) all_different = false;
  }
  return faces;
}

/// Which three vertices follow each other in some face: a hash table with open addressing.
class CornerSet {
 public:
  void fill(const Faces& faces) {
    slots_.assign(std::bit_ceil(2 * faces.org.size() + 1), 0);
    for (std::uint32_t h = 0; h < faces.org.size(); ++h) {
      const std::uint64_t k = key(faces.org[faces.prev(h)], faces.org[h], faces.org[faces.next(h)]);
      std::size_t i = k & (slots_.size() - 1);
      while (slots_[i] != 0 && slots_[i] != k) i = (i + 1) & (slots_.size() - 1);
      slots_[i] = k;
    }
  }
  bool has(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    const std::uint64_t k = key(a, b, c);
    std::size_t i = k & (slots_.size() - 1);
    while (slots_[i] != 0 && slots_[i] != k) i = (i + 1) & (slots_.size() - 1);
    return slots_[i] == k;
  }

 private:
  /// Collisions of 64 bits would only make a cut worse.
  static std::uint64_t key(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    const auto [low, high] = std::minmax(a, c);
    return mix((std::uint64_t(low) << 32 | high) + mix(b + 1)) | 1;
  }
  std::vector<std::uint64_t> slots_;
};

class Cutter {
 public:
  Cutter(const Faces& faces, std::uint32_t vertex_count, Handles handles)
      : faces_(faces),
        vertices_(vertex_count),
        handles_(handles),
        colours_(faces, std::vector<std::uint64_t>(vertex_count, 1)),
        orientation_(faces.count()),
        across_(faces.org.size(), none),
        edge_(faces.org.size()),
        next_(faces.org.size(), none) {}

  /// The only cut there is: no edge has more than two faces, every component has an orientation,
  /// and it is clear which faces are the fewer to turn. Nothing if there are several.
  std::optional<CutSurface> forced() {
    if (handles_ == Handles::cut) return std::nullopt;
    list_sides();
    for (const Edge& e : edges_)
      if (e.crowded) return std::nullopt;
    std::vector<std::uint32_t> seeds(faces_.count());
    std::iota(seeds.begin(), seeds.end(), 0u);
    std::vector<bool> reached(faces_.count());
    for (const std::uint32_t seed : seeds)
      if (!reached[seed]) grow(seed, reached);
    for (const Edge& e : edges_)
      if (next_[e.first] != none && across_[e.first] == none) return std::nullopt;
    if (orientation_.tied()) return std::nullopt;

    CutSurface result;
    result.order_free = true;
    result.turned = orientation_.turned(seeds);
    turn(result);
    split_vertices(result);
    result.faces = std::move(seeds);
    result.first_corners.resize(faces_.count());
    if (!faces_.triangles())
      for (std::uint32_t f = 0; f < faces_.count(); ++f) result.sizes.push_back(faces_.size(f));
    return result;
  }

  /// One of several cuts, chosen by colours.
  CutSurface chosen() {
    colours_.refine();
    list_sides();
    corners_.fill(faces_);
    const std::vector<std::uint32_t> seeds = by_colour(colours_.face, all_different_);
    std::vector<bool> reached(faces_.count());
    for (const std::uint32_t seed : seeds)
      if (!reached[seed]) grow(seed, reached);
    CutSurface result;
    result.turned = orientation_.turned(seeds);
    zip(seeds, result.turned);
    turn(result);
    split_vertices(result);
    return arranged(std::move(result));
  }

 private:
  bool same_direction(std::uint32_t g, std::uint32_t h) const {
    return faces_.org[g] == faces_.org[h];
  }

  /// Chains the sides of every edge by colour, then by file order.
  void list_sides() {
    std::vector<std::uint32_t> sorted;
    for_each_edge(faces_, vertices_, [&](std::span<const std::uint32_t> sides) {
      sorted.assign(sides.begin(), sides.end());
      if (sides.size() > 2)
        std::stable_sort(sorted.begin(), sorted.end(), [&](std::uint32_t g, std::uint32_t h) {
          return colours_.face[faces_.face(g)] < colours_.face[faces_.face(h)];
        });
      const std::uint32_t edge = static_cast<std::uint32_t>(edges_.size());
      edges_.push_back({sorted[0], sides.size() > 2 || handles_ == Handles::cut});
      for (std::size_t i = 0; i < sorted.size(); ++i) {
        edge_[sorted[i]] = edge;
        if (i + 1 < sorted.size()) next_[sorted[i]] = sorted[i + 1];
      }
    });
  }

  std::uint32_t first_side(std::uint32_t f) {
    std::uint32_t best = faces_.begin(f);
    for (std::uint32_t h = best + 1; h < faces_.end(f); ++h) {
      const std::uint64_t c = colours_.vertex[faces_.org[h]],
                          least = colours_.vertex[faces_.org[best]];
      if (c == least) all_different_ = false;
      if (c < least) best = h;
    }
    return best;
  }

  /// Glues what can be reached from a face by breadth, across edges of two faces first.
  void grow(std::uint32_t seed, std::vector<bool>& reached) {
    std::deque<std::uint32_t> near = {first_side(seed)}, far;  // by which to enter faces
    reached[seed] = true;
    while (!near.empty() || !far.empty()) {
      std::deque<std::uint32_t>& entries = near.empty() ? far : near;
      const std::uint32_t entry = entries.front();
      entries.pop_front();
      std::uint32_t h = entry;
      do {
        const std::uint32_t g = across_[h] == none ? partner(h) : none;
        if (g != none && orientation_.unite(faces_.face(g), faces_.face(h), same_direction(g, h))) {
          glue(g, h);
          if (!reached[faces_.face(g)]) {
            reached[faces_.face(g)] = true;
            (edges_[edge_[h]].crowded ? far : near).push_back(g);
          }
        }
        h = faces_.next(h);
      } while (h != entry);
    }
  }

  void glue(std::uint32_t g, std::uint32_t h) {
    across_[g] = h;
    across_[h] = g;
  }

  /// The side to glue to h: the other one of an edge of two. Of more, one of another surface, best
  /// one that need not be turned and is no face on the same vertices. None if one of the same
  /// surface suits better: it is zipped later, or else would make a handle, which costs more than
  /// the copies of two vertices.
  std::uint32_t partner(std::uint32_t h) {
    constexpr unsigned patience = 8;
    Edge& edge = edges_[edge_[h]];
    if (!edge.crowded) return edge.first == h ? next_[h] : edge.first;
    std::uint32_t best = none;
    unsigned best_worth = 0, seen = 0;
    const Orientation::Place here = orientation_.find(faces_.face(h));
    std::uint32_t* link = &edge.first;
    while (*link != none && seen < patience) {
      const std::uint32_t g = *link;
      if (across_[g] != none) {
        *link = next_[g];  // glued, and never looked at again
        continue;
      }
      link = &next_[g];
      ++seen;
      if (faces_.face(g) == faces_.face(h)) continue;
      const Orientation::Place there = orientation_.find(faces_.face(g));
      const bool turn = same_direction(g, h), together = there.set == here.set;
      if (together && (there.turned != here.turned) != turn) continue;
      const unsigned worth =
          1u + together + (turn ? 0u : 2u) + 4 * straightness(g, h) + (alike(g, h) ? 0u : 16u);
      if (worth > best_worth) {
        best_worth = worth;
        best = together ? none : g;
      }
    }
    return best;
  }

  /// Zips (errata: the seventh operator) what lies beside each other on the boundary, at edges of
  /// more than two faces: this closes a fan and makes no handle.
  void zip(std::span<const std::uint32_t> order, const std::vector<bool>& turned) {
    constexpr unsigned patience = 64;
    std::deque<std::uint32_t> work;
    for (const std::uint32_t f : order) {
      const std::uint32_t first = first_side(f);
      std::uint32_t h = first;
      do {
        if (across_[h] == none && edges_[edge_[h]].crowded) work.push_back(h);
        h = faces_.next(h);
      } while (h != first);
    }
    // Sides as they run in the surface, where those of turned faces run backwards.
    const auto next = [&](std::uint32_t h) {
      return turned[faces_.face(h)] ? faces_.prev(h) : faces_.next(h);
    };
    const auto prev = [&](std::uint32_t h) {
      return turned[faces_.face(h)] ? faces_.next(h) : faces_.prev(h);
    };
    // The boundary side that follows h, or comes before it.
    const auto beside = [&](std::uint32_t h, auto step) {
      std::uint32_t e = step(h);
      for (unsigned i = 0; i < patience && across_[e] != none; ++i) e = step(across_[e]);
      return across_[e] == none ? e : h;
    };
    while (!work.empty()) {
      const std::uint32_t h = work.front();
      work.pop_front();
      if (across_[h] != none) continue;
      const std::uint32_t after = beside(h, next), before = beside(h, prev);
      const auto fits = [&](std::uint32_t g) {
        return g != h && edge_[g] == edge_[h] && !alike(g, h);
      };
      // The better one, if at both ends there is one.
      std::uint32_t g = fits(after) ? after : before;
      if (fits(before) && straightness(before, h) > straightness(g, h)) g = before;
      if (!fits(g)) continue;
      glue(g, h);
      for (const std::uint32_t e : {after, before, beside(g, next), beside(g, prev)})
        if (across_[e] == none && edges_[edge_[e]].crowded) work.push_back(e);
    }
  }

  /// 2 less the ends of an edge at which another face lies between these two, as faces of one cell
  /// do: in a grid of cubes, 2 across an edge and 0 round a corner.
  unsigned straightness(std::uint32_t g, std::uint32_t h) const {
    const auto away = [&](std::uint32_t side, std::uint32_t end) {
      return faces_
          .org[faces_.org[side] == end ? faces_.prev(side) : faces_.next(faces_.next(side))];
    };
    unsigned straight = 2;
    for (const std::uint32_t end : {faces_.org[h], faces_.org[faces_.next(h)]})
      straight -= corners_.has(away(g, end), end, away(h, end));
    return straight;
  }

  /// Two triangles on the same vertices, or polygons that begin alike at this edge.
  bool alike(std::uint32_t g, std::uint32_t h) const {
    const std::uint32_t after_g = faces_.org[faces_.next(faces_.next(g))];
    return same_direction(g, h) ? after_g == faces_.org[faces_.next(faces_.next(h))]
                                : after_g == faces_.org[faces_.prev(h)];
  }

  /// Half-edge h of the input in the output, where turned faces run backwards.
  std::uint32_t turned_side(std::uint32_t h, const std::vector<bool>& turned) const {
    const std::uint32_t f = faces_.face(h);
    return turned[f] ? faces_.begin(f) + faces_.end(f) - 1 - h : h;
  }

  void turn(CutSurface& result) const {
    result.corners.assign(faces_.org.begin(), faces_.org.end());
    for (std::uint32_t f = 0; f < faces_.count(); ++f)
      if (result.turned[f])
        std::reverse(result.corners.begin() + faces_.begin(f) + 1,
                     result.corners.begin() + faces_.end(f));
    result.twins.resize(across_.size());
    for (std::uint32_t h = 0; h < across_.size(); ++h)
      if (across_[h] != none)
        result.twins[turned_side(h, result.turned)] =
            HalfEdge(turned_side(across_[h], result.turned));
  }

  /// Gives every fan of corners a vertex of its own.
  void split_vertices(CutSurface& result) const {
    std::vector<std::uint32_t> fan(result.corners.size(), none);
    for (std::uint32_t start = 0; start < fan.size(); ++start) {
      if (fan[start] != none) continue;
      const std::uint32_t v = static_cast<std::uint32_t>(result.point.size());
      result.point.push_back(result.corners[start]);
      std::uint32_t h = start;
      do {
        fan[h] = v;
        h = result.twins[faces_.prev(h)].index();
      } while (h != none && h != start);
      if (h == start) continue;
      for (h = result.twins[start].index(); h != none;) {
        const std::uint32_t corner = faces_.next(h);
        fan[corner] = v;
        h = result.twins[corner].index();
      }
    }
    result.corners = std::move(fan);
  }

  /// Puts faces in the order of the colours that they have once cut, each from its least corner on.
  CutSurface arranged(CutSurface from) {
    Faces cut_faces = faces_;
    cut_faces.org = from.corners;
    std::vector<std::uint64_t> start(from.point.size());
    for (std::size_t v = 0; v < start.size(); ++v) start[v] = colours_.vertex[from.point[v]];
    Refinement colours(cut_faces, std::move(start));
    colours.refine(2);
    std::vector<std::uint64_t> together(vertices_);  // what the copies of a vertex look like
    for (std::size_t v = 0; v < from.point.size(); ++v)
      together[from.point[v]] += colours.vertex[v];
    for (std::size_t v = 0; v < from.point.size(); ++v)
      colours.vertex[v] = mix(colours.vertex[v] * 3 + together[from.point[v]]);
    colours.refine(2);

    CutSurface to;
    to.point = std::move(from.point);
    to.turned = std::move(from.turned);
    to.faces = by_colour(colours.face, all_different_);
    std::vector<std::uint32_t> side(from.corners.size());
    to.corners.reserve(side.size());
    for (const std::uint32_t f : to.faces) {
      const std::uint32_t begin = faces_.begin(f), size = faces_.size(f);
      if (!faces_.triangles()) to.sizes.push_back(size);
      std::uint32_t first = begin;
      for (std::uint32_t h = begin + 1; h < begin + size; ++h) {
        const std::uint64_t c = colours.vertex[from.corners[h]],
                            least = colours.vertex[from.corners[first]];
        if (c == least) all_different_ = false;
        if (c < least) first = h;
      }
      to.first_corners.push_back(first - begin);
      for (std::uint32_t j = 0, h = first; j < size; ++j, h = faces_.next(h)) {
        side[h] = static_cast<std::uint32_t>(to.corners.size());
        to.corners.push_back(from.corners[h]);
      }
    }
    to.twins.resize(side.size());
    for (std::uint32_t h = 0; h < side.size(); ++h)
      if (from.twins[h]) to.twins[side[h]] = HalfEdge(side[from.twins[h].index()]);
    to.order_free = all_different_;
    return to;
  }

  struct Edge {
    std::uint32_t first;  ///< of its sides
    bool crowded;         ///< of more than two faces, or treated so
  };

  const Faces& faces_;
  std::uint32_t vertices_;
  Handles handles_;
  Refinement colours_;
  Orientation orientation_;
  std::vector<std::uint32_t> across_;  ///< what a half-edge is glued to
  std::vector<std::uint32_t> edge_;    ///< of each half-edge
  std::vector<std::uint32_t> next_;    ///< side of the same edge
  std::vector<Edge> edges_;
  CornerSet corners_;
  bool all_different_ = true;  ///< no choice fell to the order of the faces so far
};

}  // namespace

CutSurface cut(const Faces& faces, std::uint32_t vertex_count, Handles handles) {
  if (auto only = Cutter(faces, vertex_count, handles).forced()) return std::move(*only);
  return Cutter(faces, vertex_count, handles).chosen();
}

}  // namespace clers
