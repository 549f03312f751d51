#include "codec/soup/distinct_faces.h"

#include <algorithm>
#include <span>

#include "codec/base/no_index.h"

namespace clers::internal {
namespace {

/// A face as it is seen from its least vertex, first towards the lesser of its two neighbours
/// there.
class Cycle {
 public:
  Cycle(const Faces& faces, std::uint32_t side) : faces_(faces), at_(side) {
    // The side joins the least vertex and that neighbour.
    forward_ = faces.org[side] < faces.org[faces.next(side)];
    if (!forward_) at_ = faces.next(side);
  }
  std::uint32_t size() const { return faces_.size(faces_.face(at_)); }

  /// Any total order in which equal cycles are equal.
  int compare(const Cycle& other) const {
    if (size() != other.size()) return size() < other.size() ? -1 : 1;
    std::uint32_t g = at_, h = other.at_;
    for (std::uint32_t i = size(); i > 0; --i) {
      if (faces_.org[g] != faces_.org[h]) return faces_.org[g] < faces_.org[h] ? -1 : 1;
      g = forward_ ? faces_.next(g) : faces_.prev(g);
      h = other.forward_ ? faces_.next(h) : faces_.prev(h);
    }
    return 0;
  }

 private:
  const Faces& faces_;
  std::uint32_t at_;
  bool forward_;
};

/// The side of a face that joins its least vertex and the lesser of that one's neighbours.
std::uint32_t key_side(const Faces& faces, std::uint32_t f) {
  std::uint32_t least = faces.begin(f);
  for (std::uint32_t h = least + 1; h < faces.end(f); ++h)
    if (faces.org[h] < faces.org[least]) least = h;
  const std::uint32_t before = faces.prev(least), after = faces.next(least);
  return faces.org[before] < faces.org[after] ? before : least;
}

/// Keeps those without which most edges of theirs have two faces at most. Elsewhere a surface is
/// folded onto itself: without the face there would be a hole in it.
void keep_doubled(const Faces& faces, const Adjacency& adjacency, std::vector<Repeat>& repeats) {
  std::vector<std::uint32_t> good_sides(faces.count());
  std::vector<bool> repeated(faces.count());
  for (const Repeat& r : repeats) repeated[r.face] = true;
  for (std::uint32_t e = 0; e < adjacency.edges(); ++e) {
    const auto sides = adjacency.edge(e);
    const auto is_repeated = [&](std::uint32_t h) { return repeated[faces.face(h)]; };
    if (std::count_if(sides.begin(), sides.end(), is_repeated) + 2 <
        static_cast<std::ptrdiff_t>(sides.size()))
      continue;
    for (const std::uint32_t h : sides) ++good_sides[faces.face(h)];
  }
  std::erase_if(repeats,
                [&](const Repeat& r) { return 2 * good_sides[r.face] <= faces.size(r.face); });
}

}  // namespace

std::vector<Repeat> find_repeats(const Faces& faces, const Adjacency& adjacency) {
  std::vector<Repeat> repeats;
  struct Key {
    std::uint32_t side, beyond;
  };
  std::vector<Key> keys;
  std::vector<std::uint32_t> key_sides;  // of polygons, as far as they were asked for
  if (!faces.triangles() && adjacency.edges() > 0)
    key_sides.assign(faces.count(), HalfEdge::null_index);
  const auto key_of = [&](std::uint32_t f) {
    if (key_sides[f] == HalfEdge::null_index) key_sides[f] = key_side(faces, f);
    return key_sides[f];
  };
  const auto differ = [&](const Key& a, const Key& b) {
    if (a.beyond != b.beyond) return a.beyond < b.beyond ? -1 : 1;
    return faces.triangles() ? 0 : Cycle(faces, a.side).compare(Cycle(faces, b.side));
  };
  for (std::uint32_t e = 0; e < adjacency.edges(); ++e) {
    keys.clear();
    for (const std::uint32_t h : adjacency.edge(e)) {
      const std::uint32_t x = faces.beyond(h);
      const std::uint32_t a = faces.org[h], b = faces.org[faces.next(h)];
      if (faces.triangles() ? x > a && x > b : key_of(faces.face(h)) == h) keys.push_back({h, x});
    }
    if (keys.size() < 2) continue;
    std::sort(keys.begin(), keys.end(), [&](const Key& a, const Key& b) {
      const int order = differ(a, b);
      return order != 0 ? order < 0 : a.side < b.side;
    });
    for (std::size_t i = 0; i < keys.size();) {
      const std::size_t base = i;
      while (++i < keys.size() && differ(keys[base], keys[i]) == 0)
        repeats.push_back({faces.face(keys[i].side), faces.face(keys[base].side)});
    }
  }
  std::sort(repeats.begin(), repeats.end(),
            [](const Repeat& a, const Repeat& b) { return a.face < b.face; });
  // A few are sooner cut off than left away.
  const auto few = [&] { return repeats.size() < faces.count() / 64; };
  if (!repeats.empty() && !few()) keep_doubled(faces, adjacency, repeats);
  if (few()) repeats.clear();
  return repeats;
}

DistinctFaces::DistinctFaces(const Faces& all, std::span<const Repeat> repeats) {
  const std::size_t count = all.count() - repeats.size();
  faces.reserve(count);
  corners.reserve(all.org.size());
  if (!all.triangles()) sizes.reserve(count);
  auto next = repeats.begin();
  for (std::uint32_t f = 0; f < all.count(); ++f) {
    if (next != repeats.end() && next->face == f) {
      ++next;
      continue;
    }
    const auto cycle = all.cycle(f);
    corners.insert(corners.end(), cycle.begin(), cycle.end());
    if (!all.triangles()) sizes.push_back(all.size(f));
    faces.push_back(f);
  }
}

Adjacency DistinctFaces::adjacency(const Faces& all, Adjacency of_all) const {
  std::vector<std::uint32_t> now(all.org.size(), no_index);  // of each half-edge that stays
  std::uint32_t h = 0;
  for (const std::uint32_t f : faces)
    for (std::uint32_t g = all.begin(f); g < all.end(f); ++g) now[g] = h++;

  Adjacency result;
  std::vector<HalfEdge>& twins = of_all.twins;
  for (std::uint32_t e = 0; e < of_all.edges(); ++e) {
    const std::size_t first = result.sides.size();
    for (const std::uint32_t side : of_all.edge(e))
      if (now[side] != no_index) result.sides.push_back(side);
    const std::size_t left = result.sides.size() - first;
    const bool pair = left == 2 && all.org[result.sides[first]] != all.org[result.sides[first + 1]];
    if (pair) {
      twins[result.sides[first]] = HalfEdge(result.sides[first + 1]);
      twins[result.sides[first + 1]] = HalfEdge(result.sides[first]);
    }
    if (pair || left <= 1)
      result.sides.resize(first);
    else
      result.ends.push_back(static_cast<std::uint32_t>(result.sides.size()));
  }
  for (std::uint32_t& side : result.sides) side = now[side];
  order_defects(result);
  result.twins.reserve(corners.size());
  for (const std::uint32_t f : faces)
    for (std::uint32_t g = all.begin(f); g < all.end(f); ++g)
      result.twins.push_back(HalfEdge(twins[g] ? now[twins[g].index()] : no_index));
  return result;
}

}  // namespace clers::internal
