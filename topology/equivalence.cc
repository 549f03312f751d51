// Half-edges that may correspond are found by hashes of what is around them; walking shows which
// do.
#include "topology/equivalence.h"

#include <algorithm>
#include <span>
#include <tuple>
#include <utility>

namespace CLERS_VISIBLE clers {
namespace {

std::uint64_t mix(std::uint64_t seed, std::uint64_t x) {
  x = (seed ^ x) * 0x9e3779b97f4a7c15u;
  return x ^ (x >> 29);
}

/// What a half-edge sees around its face; equal for half-edges that correspond.
std::uint64_t look(const Surface& s, HalfEdge h) {
  std::uint64_t key = 0;
  for (const HalfEdge side : {h, lnext(h), lprev(h)}) {
    key = mix(key, s.degree(s.org(side)));
    key = mix(key, (s.is_boundary(side) ? 1u : 0u) + (s.is_boundary(s.org(side)) ? 2u : 0u));
  }
  return key;
}

struct Entry {
  Component component;
  std::uint64_t key;
  HalfEdge h;
};

/// A component: its half-edges by their looks, and a digest of those.
struct Part {
  std::span<const Entry> entries;
  std::uint64_t digest = 0;
  Characteristic counts;
};

std::vector<Entry> entries_of(const Surface& s) {
  std::vector<Entry> entries;
  entries.reserve(3 * static_cast<std::size_t>(s.characteristic().f));
  for (const Face f : s.faces())
    for (const HalfEdge h : s.star(f)) entries.push_back({s.component(f), look(s, h), h});
  std::sort(entries.begin(), entries.end(), [](const Entry& x, const Entry& y) {
    return std::tie(x.component, x.key, x.h) < std::tie(y.component, y.key, y.h);
  });
  return entries;
}

std::vector<Part> parts_of(const Surface& s, std::span<const Entry> entries) {
  std::vector<Part> parts;
  for (std::size_t begin = 0, end = 0; begin < entries.size(); begin = end) {
    const Component k = entries[begin].component;
    Part part;
    for (; end < entries.size() && entries[end].component == k; ++end)
      part.digest = mix(part.digest, entries[end].key);
    part.entries = entries.subspan(begin, end - begin);
    part.counts = s.characteristic(k);
    parts.push_back(part);
  }
  return parts;
}

/// The half-edges that look as the fewest do.
std::span<const Entry> rarest(std::span<const Entry> entries) {
  std::span<const Entry> best = entries;
  for (std::size_t begin = 0, end = 0; begin < entries.size(); begin = end) {
    while (end < entries.size() && entries[end].key == entries[begin].key) ++end;
    if (end - begin < best.size()) best = entries.subspan(begin, end - begin);
  }
  return best;
}

class Matcher {
 public:
  Matcher(const Surface& a, const Surface& b) : a_(a), b_(b) {
    map_.half_edges.resize(a.half_edge_limit());
    map_.vertices.resize(a.vertex_limit());
  }

  /// Extends the correspondence to the component of `a` on which `root` goes to `image`, if it can.
  bool extend(HalfEdge root, HalfEdge image) {
    visited_.clear();
    put(root, image);
    for (std::size_t i = 0; i < visited_.size(); ++i) {
      const HalfEdge h = visited_[i], t = a_.sym(h), t_image = b_.sym(map_.half_edges[h.index()]);
      const bool fits = bool(t) == bool(t_image) && (!t || !map_.half_edges[t.index()] ||
                                                     map_.half_edges[t.index()] == t_image);
      if (!fits) {
        for (const HalfEdge v : visited_) map_.half_edges[v.index()] = HalfEdge();
        return false;
      }
      if (t && !map_.half_edges[t.index()]) put(t, t_image);
    }
    // As many faces on both sides, each reached: a covering of one sheet, so vertices fit too.
    for (const HalfEdge h : visited_)
      map_.vertices[a_.org(h).index()] = b_.org(map_.half_edges[h.index()]);
    return true;
  }

  bool match(const Part& part, const Part& other) {
    if (part.digest != other.digest || part.counts != other.counts) return false;
    const Entry& root = rarest(part.entries).front();
    const auto less = [](const Entry& x, const Entry& y) { return x.key < y.key; };
    const auto [begin, end] =
        std::equal_range(other.entries.begin(), other.entries.end(), root, less);
    return std::any_of(begin, end, [&](const Entry& image) { return extend(root.h, image.h); });
  }

  Correspondence take() { return std::move(map_); }

 private:
  void put(HalfEdge h, HalfEdge image) {
    for (unsigned i = 0; i < 3; ++i, h = lnext(h), image = lnext(image)) {
      map_.half_edges[h.index()] = image;
      visited_.push_back(h);
    }
  }

  const Surface& a_;
  const Surface& b_;
  Correspondence map_;
  std::vector<HalfEdge> visited_;
};

}  // namespace

std::optional<Correspondence> equivalent(const Surface& a, const Surface& b) {
  if (a.characteristic() != b.characteristic()) return std::nullopt;
  const std::vector<Entry> a_entries = entries_of(a), b_entries = entries_of(b);
  std::vector<Part> a_parts = parts_of(a, a_entries), b_parts = parts_of(b, b_entries);
  const auto less = [](const Part& x, const Part& y) { return x.digest < y.digest; };
  std::stable_sort(a_parts.begin(), a_parts.end(), less);
  std::stable_sort(b_parts.begin(), b_parts.end(), less);

  // Equivalence is transitive: the first partner that fits is as good as any.
  Matcher matcher(a, b);
  for (std::size_t i = 0; i < a_parts.size(); ++i) {
    std::size_t j = i;
    while (j < b_parts.size() && !matcher.match(a_parts[i], b_parts[j])) {
      if (b_parts[j].digest > a_parts[i].digest) return std::nullopt;
      ++j;
    }
    if (j == b_parts.size()) return std::nullopt;
    std::swap(b_parts[i], b_parts[j]);
  }
  return matcher.take();
}

bool homeomorphic(const Surface& a, const Surface& b) {
  const auto classes = [](const Surface& s) {
    std::vector<std::pair<std::int64_t, std::int64_t>> sorted;
    for (const Component k : s.components())
      sorted.emplace_back(s.characteristic(k).b, s.characteristic(k).g);
    std::sort(sorted.begin(), sorted.end());
    return sorted;
  };
  return classes(a) == classes(b);
}

}  // namespace clers
