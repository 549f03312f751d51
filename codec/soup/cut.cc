// Doubled sheets, then regions by orientation, then crowded edges, then zips; last, vertices by
// fan.
#include "codec/soup/cut.h"

#include <algorithm>
#include <bit>
#include <span>
#include <utility>

#include "codec/base/disjoint_sets.h"
#include "codec/base/no_index.h"

namespace clers::internal {
namespace {

/// Which regions to reverse, of regions that are glued, each the equal or the opposite of the
/// others of its set: the fewer faces of each set; if it is a tie, not the first region.
std::vector<bool> fewer_faces(SignedSets& regions, std::span<const std::uint32_t> faces_of) {
  const std::uint32_t count = regions.count();
  std::vector<std::uint64_t> opposite(count);  // faces, of each set
  std::vector<bool> result(count), first(count), reached(count);
  for (std::uint32_t r = 0; r < count; ++r) {
    const SignedSets::Member m = regions.find(r);
    result[r] = m.opposite;
    if (m.opposite) opposite[m.set] += faces_of[r];
    if (!reached[m.set]) first[m.set] = m.opposite;
    reached[m.set] = true;
  }
  for (std::uint32_t r = 0; r < count; ++r) {
    const std::uint32_t set = regions.find(r).set;
    const std::uint64_t twice = 2 * opposite[set];
    if (twice > regions.weight(set) || (twice == regions.weight(set) && first[set]))
      result[r] = !result[r];
  }
  return result;
}

/// Which three vertices follow each other in some face: a hash table with open addressing.
class CornerSet {
 public:
  bool empty() const { return slots_.empty(); }

  /// Those with a marked vertex in the middle.
  void fill(const Faces& faces, const std::vector<bool>& marked) {
    std::vector<std::uint32_t> keys;
    for (std::uint32_t h = 0; h < faces.org.size(); ++h)
      if (marked[faces.org[h]])
        keys.push_back(key(faces.org[faces.prev(h)], faces.org[h], faces.org[faces.next(h)]));
    slots_.assign(std::bit_ceil(2 * keys.size() + 1), 0);
    for (const std::uint32_t k : keys) slots_[place(k)] = k;
  }
  bool has(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    return slots_[place(key(a, b, c))] != 0;
  }

 private:
  /// Where the key is or would be.
  std::size_t place(std::uint32_t key) const {
    std::size_t i = key & (slots_.size() - 1);
    while (slots_[i] != 0 && slots_[i] != key) i = (i + 1) & (slots_.size() - 1);
    return i;
  }
  /// Collisions would only make a cut worse.
  static std::uint32_t key(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    const auto [low, high] = std::minmax(a, c);
    const std::uint64_t x = (std::uint64_t(low) << 32 | high) * 0x9e3779b97f4a7c15u +
                            std::uint64_t(b) * 0xd6e8feb86659fd93u;
    return static_cast<std::uint32_t>((x ^ (x >> 29)) * 0xbf58476d1ce4e5b9u >> 32) | 1;
  }
  std::vector<std::uint32_t> slots_;  ///< 0: free
};

class Cutter {
 public:
  Cutter(const Faces& faces, std::uint32_t vertex_count, Adjacency& adjacency)
      : faces_(faces),
        vertices_(vertex_count),
        edges_(adjacency),
        sides_(adjacency.sides),
        twins_(adjacency.twins),
        region_(faces.count(), no_index),
        edge_(faces.org.size(), no_index) {}

  /// Completes the twins. Returns the faces to reverse.
  std::vector<std::uint32_t> run() {
    for (std::uint32_t e = 0; e < edges_.edges(); ++e) glue_doubles(e);
    std::uint32_t open = 0;
    bool against = false;  // a side that runs the same way as the other one of its edge
    for (std::uint32_t e = 0; e < edges_.edges(); ++e) {
      against |= !is_crowded(e);
      for (const std::uint32_t h : edges_.edge(e))
        if (!twins_[h]) {
          edge_[h] = e;
          ++open;
        }
    }
    // What regions there are is not worth finding out where few sides could be joined to others.
    const bool crowded = open > 0, join = open > faces_.count() / 32;
    if (against || join) {
      for (const std::uint32_t h : sides_)
        if (!twins_[h]) flood(faces_.face(h));
      for (std::uint32_t e = 0; e < edges_.edges(); ++e) {
        const auto side = edges_.edge(e);
        if (!is_crowded(e) && unite(side[0], side[1])) glue(side[0], side[1]);
      }
    }
    if (join) join_regions();
    region_reversed_ = fewer_faces(orientation_, faces_of_);
    if (crowded) zip();

    std::vector<std::uint32_t> reversed;
    if (std::find(region_reversed_.begin(), region_reversed_.end(), true) !=
        region_reversed_.end()) {
      for (std::uint32_t f = 0; f < region_.size(); ++f)
        if (is_reversed(f)) reversed.push_back(f);
    }
    return reversed;
  }

 private:
  bool is_crowded(std::uint32_t e) const { return edges_.edge(e).size() > 2; }
  /// A side of an edge of more than two faces that is not glued.
  bool is_open(std::uint32_t h) const {
    return !twins_[h] && edge_[h] != no_index && is_crowded(edge_[h]);
  }
  std::uint32_t region(std::uint32_t h) const { return region_[faces_.face(h)]; }
  bool is_reversed(std::uint32_t f) const {
    return region_[f] != no_index && region_reversed_[region_[f]];
  }

  bool same_direction(std::uint32_t g, std::uint32_t h) const {
    return faces_.org[g] == faces_.org[h];
  }
  bool unite(std::uint32_t g, std::uint32_t h) {
    return orientation_.unite(region(g), region(h), same_direction(g, h));
  }
  void glue(std::uint32_t g, std::uint32_t h) {
    twins_[g] = HalfEdge(h);
    twins_[h] = HalfEdge(g);
  }

  /// Where all faces at an edge are on the same two triples of vertices, as where a surface was
  /// doubled, they are glued in the order of the faces: one sheet after the other.
  void glue_doubles(std::uint32_t e) {
    if (!is_crowded(e)) return;
    const auto sides = edges_.edge(e);
    const std::uint32_t one = faces_.beyond(sides[0]);
    std::uint32_t other = no_index;
    for (const std::uint32_t h : sides.subspan(1)) {
      const std::uint32_t x = faces_.beyond(h);
      if (x == one || x == other) continue;
      if (other != no_index) return;
      other = x;
    }
    // Those of `one` that wait for a side, and where to look for it: by direction.
    waiting_[0].clear();
    waiting_[1].clear();
    for (const std::uint32_t h : sides)
      if (faces_.beyond(h) == one) waiting_[same_direction(h, sides[0])].push_back(h);
    std::size_t next[2] = {0, 0};
    for (const std::uint32_t g : sides) {
      if (faces_.beyond(g) == one) continue;
      const bool direction = !same_direction(g, sides[0]);
      if (next[direction] < waiting_[direction].size())
        glue(g, waiting_[direction][next[direction]++]);
    }
  }

  /// Makes a region of what is connected with a face.
  void flood(std::uint32_t seed) {
    if (region_[seed] != no_index) return;
    const std::uint32_t r = static_cast<std::uint32_t>(faces_of_.size());
    std::uint32_t count = 0;
    stack_.push_back(seed);
    region_[seed] = r;
    while (!stack_.empty()) {
      const std::uint32_t f = stack_.back();
      stack_.pop_back();
      ++count;
      for (std::uint32_t h = faces_.begin(f); h < faces_.end(f); ++h) {
        if (!twins_[h]) continue;
        const std::uint32_t g = faces_.face(twins_[h].index());
        if (region_[g] != no_index) continue;
        region_[g] = r;
        stack_.push_back(g);
      }
    }
    faces_of_.push_back(count);
    orientation_.add(count);
  }

  void mark_corners() {
    std::vector<bool> marked(vertices_);
    for (std::uint32_t e = 0; e < edges_.edges(); ++e) {
      if (!is_crowded(e)) continue;
      const std::uint32_t h = edges_.edge(e)[0];
      marked[faces_.org[h]] = marked[faces_.org[faces_.next(h)]] = true;
    }
    corners_.fill(faces_, marked);
  }

  /// Glues sides of crowded edges where that joins two surfaces, which grow by breadth: what is
  /// glued at one edge says what is best at the next.
  void join_regions() {
    const std::uint32_t regions = static_cast<std::uint32_t>(faces_of_.size());
    std::vector<std::uint32_t> end(regions + std::size_t(1)), open;
    for (const std::uint32_t h : sides_)
      if (is_open(h)) ++end[region(h)];
    for (std::uint32_t r = 0, sum = 0; r <= regions; ++r) end[r] = sum += end[r];
    open.resize(end[regions]);
    for (std::size_t i = sides_.size(); i-- > 0;)
      if (is_open(sides_[i])) open[--end[region(sides_[i])]] = sides_[i];
    open_.assign(edges_.edges(), no_index);
    next_open_.assign(sides_.size(), no_index);
    for (std::uint32_t i = static_cast<std::uint32_t>(sides_.size()); i-- > 0;)
      if (is_open(sides_[i])) {
        next_open_[i] = open_[edge_[sides_[i]]];
        open_[edge_[sides_[i]]] = i;
      }
    std::vector<bool> reached(regions);
    std::vector<std::uint32_t> queue;
    queue.reserve(regions);
    for (std::uint32_t seed = 0; seed < regions; ++seed) {
      if (reached[seed]) continue;
      std::size_t next = queue.size();
      reached[seed] = true;
      queue.push_back(seed);
      for (; next < queue.size(); ++next) {
        const std::uint32_t r = queue[next];
        for (std::uint32_t i = end[r]; i < end[r + 1]; ++i) {
          const std::uint32_t h = open[i], g = twins_[h] ? no_index : partner(h);
          if (g == no_index) continue;
          unite(g, h);
          glue(g, h);
          if (reached[region(g)]) continue;
          reached[region(g)] = true;
          queue.push_back(region(g));
        }
      }
    }
  }

  /// The side to glue to h, of those of its edge: one of another surface that needs no reversal,
  /// best one that is no face on the same vertices. None if one of the same surface suits better:
  /// it is zipped later, or else would make a handle, which costs more than the copies of two
  /// vertices.
  std::uint32_t partner(std::uint32_t h) {
    constexpr unsigned patience = 8;
    struct Candidate {
      std::uint32_t side;
      bool together;
    };
    Candidate candidates[patience];
    unsigned count = 0, seen = 0;
    bool other_vertices = false;  // than those of the face
    const SignedSets::Member here = orientation_.find(region(h));
    std::uint32_t* link = &open_[edge_[h]];
    while (*link != no_index && seen < patience) {
      const std::uint32_t g = sides_[*link];
      if (twins_[g]) {
        *link = next_open_[*link];  // glued, and never looked at again
        continue;
      }
      link = &next_open_[*link];
      ++seen;
      if (faces_.face(g) == faces_.face(h)) continue;
      const bool unlike = !alike(g, h);
      if (other_vertices && !unlike) continue;
      const SignedSets::Member there = orientation_.find(region(g));
      if (same_direction(g, h) != (there.opposite != here.opposite)) continue;
      if (unlike && !other_vertices) count = 0;
      other_vertices = unlike;
      candidates[count++] = {g, there.set == here.set};
    }
    if (count == 1) return candidates[0].together ? no_index : candidates[0].side;
    std::uint32_t best = no_index;
    unsigned best_worth = 0;
    for (unsigned i = 0; i < count; ++i) {
      const auto [g, together] = candidates[i];
      const unsigned worth = 1u + together + 4 * straightness(g, h);
      if (worth > best_worth) {
        best_worth = worth;
        best = together ? no_index : g;
      }
    }
    return best;
  }

  /// Zips (CAGD 2010, §5.1.1) what is side by side on the boundary, at crowded edges: this closes
  /// a fan and makes no handle.
  void zip() {
    constexpr unsigned patience = 64;
    std::vector<std::uint32_t> work;
    for (const std::uint32_t h : sides_)
      if (is_open(h)) work.push_back(h);
    // Sides as they run in the surface, where those of reversed faces run backwards.
    const auto next = [&](std::uint32_t h) {
      return is_reversed(faces_.face(h)) ? faces_.prev(h) : faces_.next(h);
    };
    const auto prev = [&](std::uint32_t h) {
      return is_reversed(faces_.face(h)) ? faces_.next(h) : faces_.prev(h);
    };
    // The boundary side that follows h, or comes before it.
    const auto beside = [&](std::uint32_t h, auto step) {
      std::uint32_t e = step(h);
      for (unsigned i = 0; i < patience && twins_[e]; ++i) e = step(twins_[e].index());
      return twins_[e] ? h : e;
    };
    for (std::size_t i = 0; i < work.size(); ++i) {
      const std::uint32_t h = work[i];
      if (twins_[h]) continue;
      const std::uint32_t after = beside(h, next), before = beside(h, prev);
      const auto fits = [&](std::uint32_t g) {
        return g != h && edge_[g] == edge_[h] && !alike(g, h);
      };
      // The better one, if at both ends there is one.
      std::uint32_t g = fits(after) ? after : before;
      if (g != before && fits(before) && straightness(before, h) > straightness(g, h)) g = before;
      if (!fits(g)) continue;
      glue(g, h);
      for (const std::uint32_t e : {after, before, beside(g, next), beside(g, prev)})
        if (is_open(e)) work.push_back(e);
    }
  }

  /// 2 less the ends of an edge at which another face is between these two, as faces of one cell
  /// do: in a grid of cubes, 2 across an edge and 0 round a corner.
  unsigned straightness(std::uint32_t g, std::uint32_t h) {
    if (corners_.empty()) mark_corners();
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

  const Faces& faces_;
  const std::uint32_t vertices_;
  const Adjacency& edges_;                   ///< the defective ones
  const std::vector<std::uint32_t>& sides_;  ///< of them
  std::vector<HalfEdge>& twins_;
  std::vector<std::uint32_t> region_;            ///< of each face, where it has a defective edge
  std::vector<std::uint32_t> faces_of_;          ///< each region: how many
  std::vector<std::uint32_t> edge_;              ///< of each half-edge, if defective
  std::vector<std::uint32_t> open_, next_open_;  ///< sides of each edge that are not glued: a list
  std::vector<std::uint32_t> stack_, waiting_[2];
  std::vector<bool> region_reversed_;
  SignedSets orientation_;  ///< of regions, weighing their faces
  CornerSet corners_;
};

/// Makes faces run backwards from their corner 0 on.
void reverse(const Faces& faces, std::span<const std::uint32_t> reversed, CutSurface& surface) {
  std::vector<bool> is_reversed(faces.count());
  for (const std::uint32_t f : reversed) is_reversed[f] = true;
  const auto now = [&](std::uint32_t h) {
    const std::uint32_t f = faces.face(h);
    return is_reversed[f] ? faces.begin(f) + faces.end(f) - 1 - h : h;
  };
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
  for (const std::uint32_t f : reversed)
    for (std::uint32_t h = faces.begin(f); h < faces.end(f); ++h) {
      const HalfEdge g = surface.twins[h];
      pairs.push_back({now(h), g ? now(g.index()) : no_index});
    }
  for (const std::uint32_t f : reversed)
    std::reverse(surface.corners.begin() + faces.begin(f) + 1,
                 surface.corners.begin() + faces.end(f));
  for (const auto& [h, g] : pairs) {
    surface.twins[h] = HalfEdge(g);
    if (g != no_index) surface.twins[g] = HalfEdge(h);
  }
}

/// Gives every fan of some vertices a vertex of its own; the first keeps the number.
class FanSplitter {
 public:
  FanSplitter(const Faces& faces, std::uint32_t vertex_count, CutSurface& surface)
      : faces_(faces), vertices_(vertex_count), surface_(surface), seen_(vertex_count) {}

  /// Of all vertices.
  void split_all() {
    std::vector<bool> done(surface_.corners.size());
    for (std::uint32_t h = 0; h < done.size(); ++h)
      if (!done[h]) number(h, [&](std::uint32_t corner) { done[corner] = true; });
  }

  /// Of those where a boundary begins twice, and the ends of defective edges. A vertex at which
  /// closed fans touch, which no edge shows, is not among them.
  void split_at(std::span<const std::uint32_t> defects) {
    std::vector<bool> bounds(vertices_), chosen(vertices_);
    bool any = false;
    const auto choose = [&](std::uint32_t v) { chosen[v] = any = true; };
    for (const std::uint32_t h : defects) choose(faces_.org[h]);
    for (std::uint32_t h = 0; h < surface_.twins.size(); ++h) {
      if (surface_.twins[h]) continue;
      const std::uint32_t v = surface_.corners[h];
      if (bounds[v]) choose(v);
      bounds[v] = true;
    }
    if (!any) return;
    std::vector<std::uint32_t> corners;
    for (std::uint32_t h = 0; h < surface_.corners.size(); ++h)
      if (chosen[surface_.corners[h]]) corners.push_back(h);
    // A corner whose number was changed, or whose fan was the first, is done.
    std::vector<bool> done(surface_.corners.size());
    for (const std::uint32_t h : corners)
      if (!done[h]) number(h, [&](std::uint32_t corner) { done[corner] = true; });
  }

 private:
  /// Numbers the fan of a corner.
  template <class Visit>
  void number(std::uint32_t start, Visit visit) {
    std::vector<std::uint32_t>& corners = surface_.corners;
    const std::vector<HalfEdge>& twins = surface_.twins;
    std::uint32_t v = corners[start];
    if (seen_[v]) {
      surface_.copied.push_back(v);
      v = vertices_ + static_cast<std::uint32_t>(surface_.copied.size() - 1);
    } else {
      seen_[v] = true;
    }
    const auto take = [&](std::uint32_t corner) {
      corners[corner] = v;
      visit(corner);
    };
    std::uint32_t h = start;
    do {
      take(h);
      h = twins[faces_.prev(h)].index();
    } while (h != no_index && h != start);
    if (h == start) return;
    for (h = twins[start].index(); h != no_index;) {
      const std::uint32_t corner = faces_.next(h);
      take(corner);
      h = twins[corner].index();
    }
  }

  const Faces& faces_;
  const std::uint32_t vertices_;
  CutSurface& surface_;
  std::vector<bool> seen_;  ///< vertices of which a fan has the number
};

}  // namespace

CutSurface cut(const Faces& faces, std::uint32_t vertex_count, Adjacency adjacency, Fans fans) {
  CutSurface surface;
  surface.corners.assign(faces.org.begin(), faces.org.end());
  std::vector<std::uint32_t> defects;
  if (adjacency.edges() > 0) surface.reversed = Cutter(faces, vertex_count, adjacency).run();
  surface.twins = std::move(adjacency.twins);
  for (const std::uint32_t h : adjacency.sides) {
    defects.push_back(h);
    defects.push_back(faces.next(h));
  }
  if (!surface.reversed.empty()) reverse(faces, surface.reversed, surface);
  FanSplitter splitter(faces, vertex_count, surface);
  fans == Fans::all ? splitter.split_all() : splitter.split_at(defects);
  return surface;
}

}  // namespace clers::internal
