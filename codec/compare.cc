#include "codec/compare.h"

#include <algorithm>
#include <cstring>
#include <numeric>
#include <optional>
#include <span>
#include <tuple>
#include <utility>

// Two meshes are the same when a bijection of vertices carries the faces of one, as a multiset of
// cycles, onto those of the other, and every value with them. Finding it is graph isomorphism;
// meshes make it easy nearly always:
//
//   1. Colour the vertices by their values. In most files positions differ, so every colour is
//   alone
//      in its class and the bijection is forced.
//   2. Otherwise refine: a vertex's new colour is its old one and the multiset of the faces around
//      it, each read as a cycle of colours from that vertex on.
//   3. Where classes stay larger than one vertex, guess the image of a single corner. Across an
//   edge
//      of two faces there is no choice, so the guess decides a whole sheet; branch at what remains.
//
// Colours are hashes, functions of what an isomorphism keeps: differing histograms prove a
// difference, whatever collides. Equality is proved at the end, on the bits themselves.

namespace clers {
namespace {

using Colour = std::uint64_t;
using Index = std::uint32_t;
constexpr Index none = 0xffffffffu;

/// The finaliser of splitmix64 (Steele, Lea and Flood 2014): a bijection of 64 bits that mixes all.
constexpr Colour mix(Colour x) {
  x += 0x9e3779b97f4a7c15u;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}
constexpr Colour combine(Colour a, Colour b) {
  return mix(a ^ (mix(b) * 3));
}

// The base of the polynomial by which cycles are hashed, and its inverse modulo 2^64.
constexpr Colour base = 0xd1342543de82ef95u;
constexpr Colour base_inverse = [] {
  Colour x = 1;
  for (int i = 0; i < 6; ++i) x *= 2 - base * x;  // Newton doubles the right bits: 1, 2, .. 64
  return x;
}();
static_assert(base * base_inverse == 1);

const char* name(Domain domain) {
  return domain == Domain::vertex ? "vertex" : domain == Domain::corner ? "corner" : "face";
}

/// A mesh with what the comparison knows of it.
struct Side {
  const Mesh& mesh;
  std::vector<const Attribute*> attributes;  ///< in an order that both sides share
  std::vector<Index> face_begin;             ///< first corner of each face; empty: triangles
  std::vector<Colour> colour;                ///< of each vertex
  std::vector<Colour> corner_value;          ///< hash of each corner's values; empty: has none
  std::vector<Colour> face_value;            ///< hash of each face's values; empty: has none

  Index faces() const { return static_cast<Index>(mesh.face_count()); }
  Index corners() const { return static_cast<Index>(mesh.corners.size()); }
  Index begin(Index f) const { return face_begin.empty() ? 3 * f : face_begin[f]; }
  Index size(Index f) const { return face_begin.empty() ? 3 : mesh.face_sizes[f]; }
  Index vertex(Index c) const { return mesh.corners[c]; }
  Colour value_of_corner(Index c) const { return corner_value.empty() ? 0 : corner_value[c]; }
  Colour value_of_face(Index f) const { return face_value.empty() ? 0 : face_value[f]; }

  /// Is the value of element i of a domain here, bit for bit, that of element j there?
  bool equal_values(Domain domain, Index i, const Side& other, Index j) const {
    return compare_values(domain, i, other, j) == 0;
  }
  int compare_values(Domain domain, Index i, const Side& other, Index j) const {
    for (std::size_t k = 0; k < attributes.size(); ++k) {
      if (attributes[k]->domain != domain) continue;
      const std::size_t stride = attributes[k]->stride();
      const int order = std::memcmp(attributes[k]->data.data() + i * stride,
                                    other.attributes[k]->data.data() + j * stride, stride);
      if (order != 0) return order;
    }
    return 0;
  }
};

std::size_t domain_size(const Mesh& mesh, Domain domain) {
  switch (domain) {
    case Domain::vertex: return mesh.vertex_count;
    case Domain::corner: return mesh.corners.size();
    case Domain::face: return mesh.face_count();
  }
  return 0;
}

/// What keeps a mesh from being compared, or nothing.
std::string objection(const Mesh& mesh) {
  if (mesh.corners.size() >= none) return "has too many corners to compare";
  if (mesh.triangles_only() ? mesh.corners.size() % 3 != 0
                            : std::accumulate(mesh.face_sizes.begin(), mesh.face_sizes.end(),
                                              std::uint64_t{0}) != mesh.corners.size())
    return "has face sizes that do not add up to its corners";
  for (const Index v : mesh.corners)
    if (v >= mesh.vertex_count) return "uses vertex " + std::to_string(v) + ", which it lacks";
  for (const Attribute& a : mesh.attributes)
    if (a.data.size() != domain_size(mesh, a.domain) * a.stride())
      return "has an attribute '" + a.name + "' of the wrong size";
  return {};
}

std::string title(const Attribute& a) {
  static constexpr const char* scalars[scalar_count] = {"int8",    "uint8",  "int16", "uint16",
                                                        "int32",   "uint32", "int64", "uint64",
                                                        "float32", "float64"};
  return std::string(name(a.domain)) + " attribute '" + a.name + "' (" +
         std::to_string(a.components) + " " + scalars[static_cast<unsigned>(a.scalar)] + ")";
}

auto key(const Attribute& a) {
  return std::tie(a.domain, a.name, a.scalar, a.components);
}

Side make_side(const Mesh& mesh) {
  Side side{mesh, {}, {}, {}, {}, {}};
  for (const Attribute& a : mesh.attributes) side.attributes.push_back(&a);
  std::stable_sort(side.attributes.begin(), side.attributes.end(),
                   [](const Attribute* a, const Attribute* b) { return key(*a) < key(*b); });
  if (!mesh.triangles_only()) {
    side.face_begin.resize(mesh.face_sizes.size());
    std::exclusive_scan(mesh.face_sizes.begin(), mesh.face_sizes.end(), side.face_begin.begin(),
                        Index{0});
  }
  side.colour.assign(mesh.vertex_count, 0);
  for (std::size_t k = 0; k < side.attributes.size(); ++k) {
    const Attribute& a = *side.attributes[k];
    const std::size_t count = domain_size(mesh, a.domain), stride = a.stride();
    std::vector<Colour>& target = a.domain == Domain::vertex   ? side.colour
                                  : a.domain == Domain::corner ? side.corner_value
                                                               : side.face_value;
    target.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
      Colour h = combine(target[i], k);
      for (std::size_t at = 0; at < stride; at += sizeof(Colour)) {
        Colour word = 0;
        std::memcpy(&word, a.data.data() + i * stride + at, std::min(sizeof word, stride - at));
        h = combine(h, word);
      }
      target[i] = h;
    }
  }
  return side;
}

/// Calls visit(corner, hash) for each corner of a face with the hash of the face's cycle read from
/// that corner on; all of them in time linear in the face.
template <class Visit>
void each_rotation(const Side& side, Index f, Visit visit) {
  const Index begin = side.begin(f), n = side.size(f);
  const Colour tail = combine(side.value_of_face(f), n);
  const auto token = [&](Index c) {
    return mix(side.colour[side.vertex(c)] + 5 * side.value_of_corner(c));
  };
  Colour sum = 0, power = 1;  // sum of token(begin + j) * base^j, and base^(n-1)
  for (Index j = 0; j < n; ++j) {
    power = j == 0 ? 1 : power * base;
    sum += token(begin + j) * power;
  }
  for (Index j = 0; j < n; ++j) {
    visit(begin + j, mix(sum ^ tail));
    const Colour first = token(begin + j);
    sum = (sum - first) * base_inverse + first * power;
  }
}

/// One round of refinement: every vertex looks at its faces.
void refine(Side& side) {
  std::vector<Colour> around(side.colour.size());
  for (Index f = 0; f < side.faces(); ++f)
    each_rotation(side, f, [&](Index c, Colour h) { around[side.vertex(c)] += h; });
  for (std::size_t v = 0; v < around.size(); ++v)
    side.colour[v] = combine(side.colour[v], around[v]);
}

/// Colours every vertex by the colours of its whole component, too: what refinement would learn
/// only after as many rounds as the component is wide.
void refine_by_component(Side& side) {
  std::vector<Index> root(side.colour.size());
  std::iota(root.begin(), root.end(), Index{0});
  const auto find = [&](Index v) {
    while (root[v] != v) v = root[v] = root[root[v]];
    return v;
  };
  for (Index f = 0; f < side.faces(); ++f)
    for (Index j = 1; j < side.size(f); ++j) {
      const Index a = find(side.vertex(side.begin(f))), b = find(side.vertex(side.begin(f) + j));
      root[std::max(a, b)] = std::min(a, b);
    }
  std::vector<Colour> total(side.colour.size());
  for (Index v = 0; v < root.size(); ++v) total[find(v)] += mix(side.colour[v]);
  for (Index v = 0; v < root.size(); ++v) side.colour[v] = combine(side.colour[v], total[find(v)]);
}

/// Elements sorted by colour.
using Classes = std::vector<std::pair<Colour, Index>>;

Classes classes(const std::vector<Colour>& colours) {
  Classes sorted(colours.size());
  for (std::size_t i = 0; i < colours.size(); ++i) sorted[i] = {colours[i], static_cast<Index>(i)};
  std::sort(sorted.begin(), sorted.end());
  return sorted;
}

std::vector<Colour> face_colours(const Side& side) {
  std::vector<Colour> colours(side.faces());
  for (Index f = 0; f < side.faces(); ++f) {
    Colour sum = combine(side.value_of_face(f), side.size(f));
    each_rotation(side, f, [&](Index, Colour h) { sum += h; });
    colours[f] = mix(sum);
  }
  return colours;
}

std::size_t count_classes(const Classes& sorted) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < sorted.size(); ++i)
    count += i == 0 || sorted[i].first != sorted[i - 1].first;
  return count;
}

/// Compares histograms; where they differ, says by which element. Both have the same size.
std::optional<std::string> histograms_differ(const Classes& a, const Classes& b,
                                             const std::string& element, const std::string& what) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i].first == b[i].first) continue;
    const bool in_first = a[i].first < b[i].first;  // the smaller colour lacks a partner
    return element + " " + std::to_string((in_first ? a : b)[i].second) + " of the " +
           (in_first ? "first" : "second") + " mesh has no counterpart with " + what;
  }
  return std::nullopt;
}

/// Step 3: depth-first search for a bijection that keeps colours, by propagation across edges.
/// Components are independent: once one is matched it stays so, because a component of the second
/// mesh that could have served another one equally is isomorphic to what the other gets.
class Search {
 public:
  Search(const Side& a, const Side& b)
      : sides_{{a, Star(a)}, {b, Star(b)}},
        image_(a.colour.size(), none),
        origin_(b.colour.size(), none),
        matched_a_(a.faces()),
        matched_b_(b.faces()),
        budget_(40 * std::uint64_t{a.corners()} + (1u << 25)) {}

  /// same: image() is complete (up to a collision of hashes). different: no bijection exists.
  Verdict run(const Classes& faces_a, const Classes& faces_b) {
    // Rarest faces first, for few guesses. Both lists have the same histogram.
    struct Group {
      std::size_t begin, end;
    };
    std::vector<Group> groups;
    for (std::size_t i = 0, j; i < faces_a.size(); i = j) {
      for (j = i; j < faces_a.size() && faces_a[j].first == faces_a[i].first;) ++j;
      groups.push_back({i, j});
    }
    std::stable_sort(groups.begin(), groups.end(), [](const Group& x, const Group& y) {
      return x.end - x.begin < y.end - y.begin;
    });
    for (Group& group : groups)
      for (std::size_t i = group.begin; i < group.end; ++i) {
        const Index f = faces_a[i].second;
        if (matched_a_[f] || sides_[0].side.size(f) == 0) continue;
        Choice root{sides_[0].side.begin(f)};
        while (group.begin < group.end && matched_b_[faces_b[group.begin].second]) ++group.begin;
        for (std::size_t k = group.begin; k < group.end; ++k) {
          const Index g = faces_b[k].second;
          if (!matched_b_[g]) root.faces.push_back(g);
          if (root.faces.size() == 4096) break;
        }
        const bool all = root.faces.size() < 4096;
        const Verdict verdict = match_component(std::move(root));
        if (verdict == Verdict::different && !all) return Verdict::undecided;
        if (verdict != Verdict::same) {
          failed_ = f;
          return verdict;
        }
      }
    match_isolated();
    return Verdict::same;
  }

  const std::vector<Index>& image() const { return image_; }
  Index failed_face() const { return failed_; }

 private:
  /// The corners at each vertex, sorted by the vertex that follows in the face.
  struct Star {
    std::vector<Index> face;   ///< of each corner; empty: triangles
    std::vector<Index> begin;  ///< of each vertex in corners
    std::vector<Index> corner;

    explicit Star(const Side& side) {
      const Index n = static_cast<Index>(side.colour.size());
      if (!side.face_begin.empty()) {
        face.resize(side.corners());
        for (Index f = 0; f < side.faces(); ++f)
          std::fill_n(face.begin() + side.begin(f), side.size(f), f);
      }
      // Radix sort by (vertex, next vertex).
      std::vector<Index> by_next(side.corners());
      corner.resize(side.corners());
      const auto sort_by = [&](auto vertex_of, const Index* from, Index* to) {
        begin.assign(n + 1, 0);
        for (Index c = 0; c < side.corners(); ++c) ++begin[vertex_of(c)];
        std::exclusive_scan(begin.begin(), begin.end(), begin.begin(), Index{0});
        for (Index i = 0; i < side.corners(); ++i) {
          const Index c = from == nullptr ? i : from[i];
          to[begin[vertex_of(c)]++] = c;
        }
      };
      sort_by([&](Index c) { return side.vertex(next(side, c)); }, nullptr, by_next.data());
      sort_by([&](Index c) { return side.vertex(c); }, by_next.data(), corner.data());
      std::rotate(begin.begin(), begin.end() - 1,
                  begin.end());  // the scatter moved each to its end
      begin[0] = 0;
    }
    Index face_of(Index c) const { return face.empty() ? c / 3 : face[c]; }
    Index next(const Side& side, Index c) const {
      const Index f = face_of(c), first = side.begin(f);
      return c + 1 == first + side.size(f) ? first : c + 1;
    }
    std::span<const Index> at(Index v) const {
      return {corner.data() + begin[v], corner.data() + begin[v + 1]};
    }
    /// The corners at u whose face runs on to v.
    std::span<const Index> along(const Side& side, Index u, Index v) const {
      const auto all = at(u);
      const auto low = std::partition_point(
          all.begin(), all.end(), [&](Index c) { return side.vertex(next(side, c)) < v; });
      auto high = low;
      while (high != all.end() && side.vertex(next(side, *high)) == v) ++high;
      return {low, high};
    }
  };

  struct Located {
    const Side& side;
    Star star;
    Index next(Index c) const { return star.next(side, c); }
  };

  /// A guess: where a corner of the first mesh goes, and what to undo when it was wrong.
  struct Choice {
    Index corner;
    std::vector<Index> faces;  ///< of the second mesh that the corner's face may become
    Index image = none;        ///< or the vertex of the second mesh around which they lie
    std::size_t at = 0;        ///< next face, or next corner around `image`
    Index rotation = 0;
    std::size_t vertices = 0, matches = 0, cursor = 0;
  };

  /// The next corner of the second mesh to try.
  std::optional<Index> next_candidate(Choice& choice) const {
    if (choice.image != none) {
      const auto around = sides_[1].star.at(choice.image);
      while (choice.at < around.size()) {
        const Index c = around[choice.at++];
        if (!matched_b_[sides_[1].star.face_of(c)]) return c;
      }
      return std::nullopt;
    }
    while (choice.at < choice.faces.size()) {
      const Index g = choice.faces[choice.at];
      if (choice.rotation < sides_[1].side.size(g))
        return sides_[1].side.begin(g) + choice.rotation++;
      choice.rotation = 0;
      ++choice.at;
    }
    return std::nullopt;
  }

  Verdict match_component(Choice root) {
    vertices_.clear();
    matches_.clear();
    cursor_ = 0;
    std::vector<Choice> choices;
    choices.push_back(std::move(root));
    for (;;) {
      // Take the next candidate of the last choice that has one.
      std::optional<Index> candidate;
      while (!choices.empty()) {
        undo(choices.back());
        candidate = next_candidate(choices.back());
        if (candidate) break;
        choices.pop_back();
      }
      if (choices.empty()) return Verdict::different;
      queue_.clear();
      bool ok = match(choices.back().corner, *candidate);
      // Follow it as far as it is forced, and guess again where it leaves a choice.
      while (ok) {
        ok = propagate();
        if (work_ > budget_) return Verdict::undecided;
        if (!ok) break;
        std::optional<Choice> more = next_choice();
        if (!more) return Verdict::same;
        candidate = next_candidate(*more);
        choices.push_back(std::move(*more));
        ok = candidate && match(choices.back().corner, *candidate);
      }
    }
  }

  void undo(const Choice& choice) {
    for (; vertices_.size() > choice.vertices; vertices_.pop_back()) {
      origin_[image_[vertices_.back()]] = none;
      image_[vertices_.back()] = none;
    }
    for (; matches_.size() > choice.matches; matches_.pop_back()) {
      matched_a_[matches_.back().first] = false;
      matched_b_[matches_.back().second] = false;
    }
    cursor_ = choice.cursor;
  }

  /// A face not matched yet at a vertex that is: it lies across a vertex or edge of several sheets.
  std::optional<Choice> next_choice() {
    for (; cursor_ < vertices_.size(); ++cursor_)
      for (const Index c : sides_[0].star.at(vertices_[cursor_])) {
        ++work_;
        if (matched_a_[sides_[0].star.face_of(c)]) continue;
        Choice choice{c, {}, image_[vertices_[cursor_]]};
        choice.vertices = vertices_.size();
        choice.matches = matches_.size();
        choice.cursor = cursor_;
        return choice;
      }
    return std::nullopt;
  }

  bool match(Index ca, Index cb) {
    const Side &a = sides_[0].side, &b = sides_[1].side;
    const Index fa = sides_[0].star.face_of(ca), fb = sides_[1].star.face_of(cb);
    if (a.size(fa) != b.size(fb) || a.value_of_face(fa) != b.value_of_face(fb)) return false;
    matched_a_[fa] = matched_b_[fb] = true;
    matches_.push_back({fa, fb});
    queue_.push_back(fa);
    for (Index j = 0; j < a.size(fa); ++j) {
      ++work_;
      const Index u = a.vertex(ca), v = b.vertex(cb);
      if (a.value_of_corner(ca) != b.value_of_corner(cb) || a.colour[u] != b.colour[v])
        return false;
      if (image_[u] == none && origin_[v] == none) {
        image_[u] = v;
        origin_[v] = u;
        vertices_.push_back(u);
      } else if (image_[u] != v) {
        return false;
      }
      ca = sides_[0].next(ca);
      cb = sides_[1].next(cb);
    }
    return true;
  }

  bool propagate() {
    const Side& a = sides_[0].side;
    while (!queue_.empty()) {
      const Index f = queue_.back();
      queue_.pop_back();
      for (Index j = 0; j < a.size(f); ++j) {
        const Index c = a.begin(f) + j;
        const Index u = a.vertex(c), v = a.vertex(sides_[0].next(c));
        if (!match_along(u, v) || !match_along(v, u)) return false;
        if (work_ > budget_) return true;
      }
    }
    return true;
  }

  /// Both ends of an edge are matched: match the faces along it as far as there is no choice.
  bool match_along(Index u, Index v) {
    const auto unmatched = [this](const Located& l, const std::vector<bool>& matched, Index from,
                                  Index to, Classes& out) {
      out.clear();
      for (const Index c : l.star.along(l.side, from, to)) {
        ++work_;
        if (!matched[l.star.face_of(c)]) out.push_back({0, c});
      }
    };
    unmatched(sides_[0], matched_a_, u, v, along_a_);
    unmatched(sides_[1], matched_b_, image_[u], image_[v], along_b_);
    if (along_a_.size() != along_b_.size()) return false;
    if (along_a_.empty()) return true;
    if (along_a_.size() == 1) return match(along_a_[0].second, along_b_[0].second);

    // An edge of many faces. Those that differ in what is known of them are no choice.
    for (auto& [h, c] : along_a_) h = known(sides_[0], c, image_);
    for (auto& [h, c] : along_b_) h = known(sides_[1], c, {});
    std::sort(along_a_.begin(), along_a_.end());
    std::sort(along_b_.begin(), along_b_.end());
    for (std::size_t i = 0, j; i < along_a_.size(); i = j) {
      for (j = i; j < along_a_.size() && along_a_[j].first == along_a_[i].first; ++j)
        if (along_b_[j].first != along_a_[j].first) return false;
      if (j < along_b_.size() && along_b_[j].first == along_a_[i].first) return false;
      // Equal faces without an unknown vertex may be paired at will.
      if (j - i > 1 && has_unknown(along_a_[i].second)) continue;
      for (std::size_t k = i; k < j; ++k) {
        const Index ca = along_a_[k].second, cb = along_b_[k].second;
        const bool done_a = matched_a_[sides_[0].star.face_of(ca)];
        const bool done_b = matched_b_[sides_[1].star.face_of(cb)];
        if (done_a != done_b || (!done_a && !match(ca, cb))) return false;
      }
    }
    return true;
  }

  /// Hash of a face read from a corner on, with the vertices that are matched known by number.
  Colour known(const Located& l, Index c, std::span<const Index> image) {
    const Index n = l.side.size(l.star.face_of(c));
    Colour h = combine(n, l.side.value_of_face(l.star.face_of(c)));
    for (Index j = 0; j < n; ++j, c = l.next(c)) {
      ++work_;
      const Index v = l.side.vertex(c);
      const Index b = !image.empty() ? image[v] : origin_[v] == none ? none : v;
      h = combine(h, b == none ? l.side.colour[v] : mix(b));
      h = combine(h, l.side.value_of_corner(c));
    }
    return h;
  }

  bool has_unknown(Index c) const {
    const Index f = sides_[0].star.face_of(c);
    for (Index j = 0; j < sides_[0].side.size(f); ++j)
      if (image_[sides_[0].side.vertex(sides_[0].side.begin(f) + j)] == none) return true;
    return false;
  }

  /// Vertices that no face uses have nothing but their colour.
  void match_isolated() {
    Classes rest_a, rest_b;
    for (Index v = 0; v < image_.size(); ++v) {
      if (image_[v] == none) rest_a.push_back({sides_[0].side.colour[v], v});
      if (origin_[v] == none) rest_b.push_back({sides_[1].side.colour[v], v});
    }
    std::sort(rest_a.begin(), rest_a.end());
    std::sort(rest_b.begin(), rest_b.end());
    for (std::size_t i = 0; i < rest_a.size(); ++i) image_[rest_a[i].second] = rest_b[i].second;
  }

  Located sides_[2];
  std::vector<Index> image_, origin_;             // vertices of the first -> second, and back
  std::vector<bool> matched_a_, matched_b_;       // faces
  std::vector<Index> vertices_;                   // matched in this component, in order
  std::vector<std::pair<Index, Index>> matches_;  // faces matched in this component, in order
  std::size_t cursor_ = 0;                        // vertices_ before it have no unmatched face
  std::vector<Index> queue_;                      // faces whose edges are to be followed
  Classes along_a_, along_b_;                     // of match_along
  std::uint64_t work_ = 0, budget_;
  Index failed_ = none;
};

/// Where the least rotation of a face's cycle starts, vertices numbered by `number`, ties broken by
/// the corners' bits. Linear: two candidates race, and the loser skips what it shared.
template <class Number>
Index least_rotation(const Side& side, Index f, Number number) {
  const Index begin = side.begin(f), n = side.size(f);
  const auto corner = [&](Index j) { return begin + (j >= n ? j - n : j); };
  Index i = 0, j = 1, k = 0;
  while (i < n && j < n && k < n) {
    const Index x = corner(i + k), y = corner(j + k);
    const Index nx = number(side.vertex(x)), ny = number(side.vertex(y));
    const int order =
        nx != ny ? (nx < ny ? -1 : 1) : side.compare_values(Domain::corner, x, side, y);
    if (order == 0) {
      ++k;
      continue;
    }
    (order > 0 ? i : j) += k + 1;
    if (i == j) ++j;
    k = 0;
  }
  return std::min(i, j);
}

/// Proves, value by value, that a bijection of vertices carries one mesh onto the other. Returns
/// what fails.
std::optional<std::string> check(const Side& a, const Side& b, const std::vector<Index>& image) {
  std::vector<bool> hit(image.size());
  for (Index v = 0; v < image.size(); ++v) {
    if (image[v] >= image.size() || hit[image[v]]) return "the renumbering is no bijection";
    hit[image[v]] = true;
    if (!a.equal_values(Domain::vertex, v, b, image[v]))
      return "vertex " + std::to_string(v) + " of the first mesh has other values";
  }
  const auto by_image = [&](Index v) { return image[v]; };
  const auto as_is = [](Index v) { return v; };
  const auto cycles = [](const Side& side, auto number, std::vector<Index>& start) {
    start.resize(side.faces());
    std::vector<Colour> hashes(side.faces());
    for (Index f = 0; f < side.faces(); ++f) {
      const Index n = side.size(f), begin = side.begin(f);
      start[f] = least_rotation(side, f, number);
      Colour h = combine(n, side.value_of_face(f));
      for (Index j = 0; j < n; ++j) {
        const Index c = begin + (start[f] + j < n ? start[f] + j : start[f] + j - n);
        h = combine(combine(h, number(side.vertex(c))), side.value_of_corner(c));
      }
      hashes[f] = h;
    }
    return classes(hashes);
  };
  std::vector<Index> start_a, start_b;
  const Classes faces_a = cycles(a, by_image, start_a);
  const Classes faces_b = cycles(b, as_is, start_b);
  if (auto what = histograms_differ(faces_a, faces_b, "face", "the same vertices and values"))
    return what;

  const auto equal = [&](Index f, Index g) {
    const Index n = a.size(f);
    if (n != b.size(g) || !a.equal_values(Domain::face, f, b, g)) return false;
    for (Index j = 0; j < n; ++j) {
      const Index x = a.begin(f) + (start_a[f] + j) % n, y = b.begin(g) + (start_b[g] + j) % n;
      if (image[a.vertex(x)] != b.vertex(y) || !a.equal_values(Domain::corner, x, b, y))
        return false;
    }
    return true;
  };
  // Faces of one hash are duplicates of each other, and pair off in order, unless hashes collide.
  for (std::size_t i = 0; i < faces_a.size(); ++i)
    if (!equal(faces_a[i].second, faces_b[i].second))
      return "face " + std::to_string(faces_a[i].second) + " of the first mesh has other values";
  return std::nullopt;
}

Comparison differ(std::string what) {
  return {Verdict::different, std::move(what)};
}

std::string two_counts(const char* what, std::uint64_t a, std::uint64_t b) {
  return std::string(what) + ": " + std::to_string(a) + " and " + std::to_string(b);
}

}  // namespace

Comparison compare(const Mesh& a, const Mesh& b) {
  if (const std::string what = objection(a); !what.empty())
    return {Verdict::undecided, "the first mesh " + what};
  if (const std::string what = objection(b); !what.empty())
    return {Verdict::undecided, "the second mesh " + what};
  if (a.vertex_count != b.vertex_count)
    return differ(two_counts("vertices", a.vertex_count, b.vertex_count));
  if (a.face_count() != b.face_count())
    return differ(two_counts("faces", a.face_count(), b.face_count()));
  if (a.corners.size() != b.corners.size())
    return differ(two_counts("corners", a.corners.size(), b.corners.size()));

  Side first = make_side(a), second = make_side(b);
  for (std::size_t k = 0; k < std::max(first.attributes.size(), second.attributes.size()); ++k) {
    const Attribute* x = k < first.attributes.size() ? first.attributes[k] : nullptr;
    const Attribute* y = k < second.attributes.size() ? second.attributes[k] : nullptr;
    if (x != nullptr && y != nullptr && key(*x) == key(*y)) continue;
    const bool in_first = y == nullptr || (x != nullptr && key(*x) < key(*y));
    return differ(title(in_first ? *x : *y) + " is only in the " + (in_first ? "first" : "second") +
                  " mesh");
  }

  // Steps 1 and 2. Rounds are free for small meshes and few for large ones, which the search serves
  // better than a round for every ring of faces.
  Classes vertices_a = classes(first.colour), vertices_b = classes(second.colour);
  if (auto what = histograms_differ(vertices_a, vertices_b, "vertex", "the same values"))
    return differ(std::move(*what));
  std::size_t count = count_classes(vertices_a);
  std::uint64_t effort = 0;
  bool by_component = false;
  while (count < vertices_a.size()) {
    effort += a.corners.size() + a.vertex_count;
    const bool last = effort > (1u << 24);
    refine(first);
    refine(second);
    if (last && !by_component) {
      refine_by_component(first);
      refine_by_component(second);
      by_component = true;
    }
    vertices_a = classes(first.colour);
    vertices_b = classes(second.colour);
    if (auto what = histograms_differ(vertices_a, vertices_b, "vertex",
                                      "the same values and neighbourhood"))
      return differ(std::move(*what));
    const std::size_t before = std::exchange(count, count_classes(vertices_a));
    if (last) break;
    if (count == before) {
      if (by_component) break;
      refine_by_component(first);
      refine_by_component(second);
      by_component = true;
    }
  }

  if (count == vertices_a.size()) {
    // Colours are the same and each is alone: no other bijection can be.
    std::vector<Index> image(vertices_a.size());
    for (std::size_t i = 0; i < image.size(); ++i)
      image[vertices_a[i].second] = vertices_b[i].second;
    if (auto what = check(first, second, image)) return differ(std::move(*what));
    return {Verdict::same, {}};
  }

  const Classes faces_a = classes(face_colours(first)), faces_b = classes(face_colours(second));
  if (auto what = histograms_differ(faces_a, faces_b, "face", "the same values and neighbourhood"))
    return differ(std::move(*what));
  Search search(first, second);
  switch (search.run(faces_a, faces_b)) {
    case Verdict::different:
      return differ("no face of the second mesh is connected as face " +
                    std::to_string(search.failed_face()) + " of the first");
    case Verdict::undecided: return {Verdict::undecided, "too many renumberings to try"};
    case Verdict::same: break;
  }
  if (auto what = check(first, second, search.image())) return {Verdict::undecided, *what};
  return {Verdict::same, {}};
}

}  // namespace clers
