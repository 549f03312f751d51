#include "codec/partition.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <numeric>
#include <optional>

#include "codec/attribute_format.h"
#include "codec/faces.h"
#include "codec/parallel.h"

namespace clers {
namespace {

/// Where vertices lie: numbers that sort like their coordinates.
class Places {
 public:
  Places(const Mesh& mesh, const Faces& faces) {
    const Attribute* position = mesh.position();
    if (!position) {
      set_distances(faces, mesh.vertex_count);
      return;
    }
    for (unsigned c = 0; c < std::min<unsigned>(position->components, 3); ++c)
      with_word(position->scalar, [&](auto word) {
        axes_.push_back(ordered<decltype(word)>(*position, c, mesh.vertex_count));
      });
  }

  unsigned axes() const { return static_cast<unsigned>(axes_.size()); }
  std::uint32_t at(unsigned axis, std::uint32_t v) const { return axes_[axis][v]; }
  bool less(std::uint32_t v, std::uint32_t w) const {
    for (const auto& axis : axes_)
      if (axis[v] != axis[w]) return axis[v] < axis[w];
    return false;
  }
  /// The same for vertices at the same place, and spread over all numbers.
  std::uint32_t hash(std::uint32_t v) const {
    std::uint32_t h = 0;
    for (const auto& axis : axes_) {
      h = (h ^ axis[v]) * 0x9e3779b1u;
      h ^= h >> 15;
    }
    return h * 0x85ebca6bu;
  }

 private:
  template <class U>
  static std::vector<std::uint32_t> ordered(const Attribute& position, unsigned component,
                                            std::uint32_t count) {
    const bool is_signed = position.scalar == Scalar::int8 || position.scalar == Scalar::int16 ||
                           position.scalar == Scalar::int32 || position.scalar == Scalar::int64;
    const std::byte* from = position.data.data() + component * sizeof(U);
    std::vector<std::uint32_t> result(count);
    std::vector<U> wide(sizeof(U) > 4 ? count : 0);
    for (std::uint32_t v = 0; v < count; ++v, from += position.stride()) {
      U key;
      std::memcpy(&key, from, sizeof(U));
      if (is_float(position.scalar))
        key = to_ordered(key);
      else if (is_signed)
        key = static_cast<U>(key ^ U(1) << (8 * sizeof(U) - 1));
      if constexpr (sizeof(U) > 4)
        wide[v] = key;
      else
        result[v] = key;
    }
    if constexpr (sizeof(U) > 4) {
      std::vector<U> all = wide;
      std::sort(all.begin(), all.end());
      all.erase(std::unique(all.begin(), all.end()), all.end());
      for (std::uint32_t v = 0; v < count; ++v)
        result[v] = static_cast<std::uint32_t>(std::lower_bound(all.begin(), all.end(), wide[v]) -
                                               all.begin());
    }
    return result;
  }

  /// For a mesh that does not say where it lies: how many faces away are three vertices that are
  /// far from each other?
  void set_distances(const Faces& faces, std::uint32_t count) {
    std::vector<std::uint32_t> begin(std::size_t(count) + 1), around(faces.org.size());
    for (const std::uint32_t v : faces.org) ++begin[v];
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    for (std::uint32_t h = 0; h < faces.org.size(); ++h)
      around[--begin[faces.org[h]]] = faces.face(h);
    std::uint32_t from = 0;
    std::vector<std::uint32_t> nearest(count, unknown);
    for (unsigned axis = 0; axis < 3; ++axis) {
      std::vector<std::uint32_t> distance(count, unknown), queue;
      std::vector<bool> met(faces.count());
      queue.reserve(count);
      const auto reach = [&](std::uint32_t v, std::uint32_t d) {
        if (distance[v] != unknown) return;
        distance[v] = d;
        queue.push_back(v);
      };
      for (std::uint32_t i = 0, other = 0; i < count; ++i) {
        // Components follow each other in space.
        if (i == queue.size()) {
          while (i > 0 && distance[other] != unknown) ++other;
          reach(i == 0 ? from : other, i == 0 ? 0 : distance[queue.back()] + 2);
        }
        const std::uint32_t v = queue[i];
        for (std::uint32_t k = begin[v]; k < begin[v + 1]; ++k) {
          if (met[around[k]]) continue;
          met[around[k]] = true;
          for (const std::uint32_t w : faces.cycle(around[k])) reach(w, distance[v] + 1);
        }
      }
      for (const std::uint32_t v : queue) {
        nearest[v] = std::min(nearest[v], distance[v]);
        if (nearest[v] > nearest[from]) from = v;
      }
      axes_.push_back(std::move(distance));
    }
  }

  static constexpr std::uint32_t unknown = 0xffffffffu;

  std::vector<std::vector<std::uint32_t>> axes_;
};

/// A tree of halvings. It is grown on a sample of the vertices, chosen by their places.
class Tree {
 public:
  Tree(const Places& places, const Faces& faces, std::uint32_t vertex_count, std::uint32_t leaves)
      : places_(places) {
    // 64 vertices a leaf, and some 2^16 in all, tell quite well where the middle is.
    const std::uint64_t enough = std::max<std::uint64_t>(1u << 16, 64 * std::uint64_t(leaves));
    while (vertex_count >> shift_ > enough) ++shift_;
    Sample all;
    std::vector<bool> chosen(vertex_count);
    for (std::uint32_t v = 0; v < vertex_count; ++v)
      if (shift_ == 0 || places.hash(v) >> (32 - shift_) == 0) {
        chosen[v] = true;
        all.vertices.push_back(v);
      }
    // Their edges tell where a plane cuts.
    for (std::uint32_t f = 0; f < faces.count(); ++f) {
      const auto cycle = faces.cycle(f);
      for (std::size_t j = 0; j < cycle.size(); ++j) {
        const std::uint32_t v = cycle[j], w = cycle[j + 1 == cycle.size() ? 0 : j + 1];
        if (chosen[v] || chosen[w]) all.edges.push_back({v, w});
      }
    }
    grow(std::move(all), leaves);
  }

  std::uint32_t leaves() const { return leaves_; }

  /// The leaf, counted from the left, where a vertex lies.
  std::uint32_t leaf(std::uint32_t v) const {
    std::uint32_t i = 0;
    while (nodes_[i].axis != none)
      i = places_.at(nodes_[i].axis, v) <= nodes_[i].most ? i + 1 : nodes_[i].right;
    return nodes_[i].right;
  }

 private:
  static constexpr std::uint32_t none = 0xffffffffu;

  struct Sample {
    std::vector<std::uint32_t> vertices;
    std::vector<std::array<std::uint32_t, 2>> edges;
  };
  struct Node {
    std::uint32_t axis = none;  ///< none: a leaf
    std::uint32_t most = 0;     ///< what lies at most here is left of it, in the node that follows
    std::uint32_t right = 0;    ///< the other node; of a leaf: its number
  };
  struct Cut {
    std::uint32_t axis = none, most = 0;
    std::size_t edges = 0;
  };

  void grow(Sample sample, std::uint32_t leaves) {
    const std::size_t node = nodes_.size();
    nodes_.emplace_back();
    const Cut cut = leaves > 1 ? best_cut(sample, leaves) : Cut{};
    if (cut.axis == none) {
      nodes_[node].right = leaves_++;
      return;
    }
    Sample left;
    const auto is_left = [&](std::uint32_t v) { return places_.at(cut.axis, v) <= cut.most; };
    const auto right_vertices = std::stable_partition(
        sample.vertices.begin(), sample.vertices.end(), [&](auto v) { return !is_left(v); });
    left.vertices.assign(right_vertices, sample.vertices.end());
    sample.vertices.erase(right_vertices, sample.vertices.end());
    const auto keep = [&](Sample& part, bool side) {
      part.edges.erase(std::remove_if(part.edges.begin(), part.edges.end(),
                                      [&](const auto& e) {
                                        return is_left(e[0]) != side || is_left(e[1]) != side;
                                      }),
                       part.edges.end());
    };
    left.edges = sample.edges;
    keep(left, true);
    keep(sample, false);
    nodes_[node].axis = cut.axis;
    nodes_[node].most = cut.most;
    grow(std::move(left), leaves / 2);
    nodes_[node].right = static_cast<std::uint32_t>(nodes_.size());
    grow(std::move(sample), leaves - leaves / 2);
  }

  /// The plane across an axis that cuts the fewest edges, the first such axis, of those that leave
  /// the right shares on both sides.
  Cut best_cut(const Sample& sample, std::uint32_t leaves) const {
    Cut best;
    std::vector<std::uint32_t> keys(sample.vertices.size());
    for (std::uint32_t axis = 0; axis < places_.axes(); ++axis) {
      for (std::size_t i = 0; i < keys.size(); ++i) keys[i] = places_.at(axis, sample.vertices[i]);
      if (keys.size() < 2) break;
      const auto middle =
          keys.begin() + static_cast<std::ptrdiff_t>((keys.size() - 1) * (leaves / 2) / leaves);
      std::nth_element(keys.begin(), middle, keys.end());
      Cut cut{axis, *middle, 0};
      // What lies at one place cannot be parted: then less goes to the left, or this cannot be
      // done.
      if (*std::max_element(middle, keys.end()) == cut.most) {
        const auto below =
            std::partition(keys.begin(), middle, [&](std::uint32_t k) { return k < cut.most; });
        if (below == keys.begin()) continue;
        cut.most = *std::max_element(keys.begin(), below);
      }
      for (const auto& [v, w] : sample.edges)
        cut.edges += (places_.at(axis, v) <= cut.most) != (places_.at(axis, w) <= cut.most);
      if (best.axis == none || cut.edges < best.edges) best = cut;
    }
    return best;
  }

  const Places& places_;
  unsigned shift_ = 0;  ///< one vertex in 2^shift_ is in the sample
  std::uint32_t leaves_ = 0;
  std::vector<Node> nodes_;
};

/// For each vertex the least one of its component, if that has at most `most` vertices; else
/// itself.
std::vector<std::uint32_t> places_of_components(const Places& places, const Faces& faces,
                                                std::uint32_t vertex_count, std::uint32_t most) {
  std::vector<std::uint32_t> parent(vertex_count);
  std::iota(parent.begin(), parent.end(), 0u);
  const auto root = [&](std::uint32_t v) {
    while (parent[v] != v) v = parent[v] = parent[parent[v]];
    return v;
  };
  for (std::uint32_t f = 0; f < faces.count(); ++f) {
    const auto cycle = faces.cycle(f);
    if (cycle.empty()) continue;
    std::uint32_t a = root(cycle[0]);
    for (const std::uint32_t v : cycle.subspan(1)) {
      const std::uint32_t b = root(v);
      if (a < b)
        parent[b] = a;
      else
        a = parent[a] = b;
    }
  }
  std::vector<std::uint32_t> size(vertex_count), least(vertex_count);
  for (std::uint32_t v = 0; v < vertex_count; ++v) {
    const std::uint32_t r = parent[v] = root(v);
    if (size[r]++ == 0 || places.less(v, least[r])) least[r] = v;
  }
  for (std::uint32_t v = 0; v < vertex_count; ++v)
    parent[v] = size[parent[v]] <= most ? least[parent[v]] : v;
  return parent;
}

/// The number that most of them are, the greatest such one. Reorders them.
std::uint32_t most_frequent(std::span<std::uint32_t> all) {
  if (all.size() == 3)
    return all[0] == all[1] || all[0] == all[2] ? all[0]
           : all[1] == all[2]                   ? all[1]
                                                : *std::max_element(all.begin(), all.end());
  std::sort(all.begin(), all.end());
  std::uint32_t best = 0;
  std::size_t times = 0;
  for (auto i = all.begin(); i != all.end();) {
    const auto end = std::upper_bound(i, all.end(), *i);
    if (static_cast<std::size_t>(end - i) >= times) {
      times = static_cast<std::size_t>(end - i);
      best = *i;
    }
    i = end;
  }
  return best;
}

/// A face at a vertex, between two others.
struct Wedge {
  std::uint32_t vertex, face, before, after;
};

/// The wedges near the faces of several vertices' parts, by vertex.
std::vector<Wedge> wedges_near(const Faces& faces, std::uint32_t vertex_count,
                               std::span<const std::uint32_t> mixed_faces) {
  std::vector<bool> near(vertex_count);
  for (const std::uint32_t f : mixed_faces)
    for (const std::uint32_t v : faces.cycle(f)) near[v] = true;
  std::vector<std::uint32_t> around;
  for (std::uint32_t f = 0; f < faces.count(); ++f)
    for (const std::uint32_t v : faces.cycle(f))
      if (near[v]) {
        around.push_back(f);
        break;
      }
  std::vector<Wedge> wedges;
  for (const std::uint32_t f : around)
    for (std::uint32_t h = faces.begin(f); h < faces.end(f); ++h)
      if (near[faces.org[h]])
        wedges.push_back({faces.org[h], f, faces.org[faces.prev(h)], faces.org[faces.next(h)]});
  std::stable_sort(wedges.begin(), wedges.end(),
                   [](const Wedge& a, const Wedge& b) { return a.vertex < b.vertex; });
  return wedges;
}

/// Do the faces of a piece around a vertex form several fans? `around` are its wedges.
bool is_pinched(std::span<const Wedge> around, std::span<const std::uint32_t> piece) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> ends;  // piece, other end of an edge
  for (const Wedge& w : around) {
    ends.emplace_back(piece[w.face], w.before);
    ends.emplace_back(piece[w.face], w.after);
  }
  std::sort(ends.begin(), ends.end());
  for (std::size_t i = 0; i < ends.size();) {
    const std::uint32_t p = ends[i].first;
    std::size_t sides = 0, inner = 0;
    for (; i < ends.size() && ends[i].first == p; ++i, ++sides)
      inner += sides > 0 && ends[i] == ends[i - 1];
    if (sides / 2 > inner + 1) return true;
  }
  return false;
}

/// Where the faces of a piece around a vertex form several fans, the piece would have to be cut:
/// all faces there go to the piece that has most of them. `piece` has one for each face.
void mend_pinches(const Faces& faces, std::uint32_t vertex_count,
                  std::span<const std::uint32_t> mixed_faces, std::span<std::uint32_t> piece) {
  const std::vector<Wedge> wedges = wedges_near(faces, vertex_count, mixed_faces);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> moves;
  std::vector<std::uint32_t> pieces;
  // Mending one may make another, more rarely each time.
  for (unsigned round = 0; round < 8; ++round) {
    moves.clear();
    for (std::size_t i = 0, end; i < wedges.size(); i = end) {
      for (end = i; end < wedges.size() && wedges[end].vertex == wedges[i].vertex;) ++end;
      const auto around = std::span(wedges).subspan(i, end - i);
      pieces.clear();
      for (const Wedge& w : around) pieces.push_back(piece[w.face]);
      if (std::all_of(pieces.begin(), pieces.end(),
                      [&](std::uint32_t p) { return p == pieces[0]; }) ||
          !is_pinched(around, piece))
        continue;
      const std::uint32_t to = most_frequent(pieces);
      for (const Wedge& w : around) moves.emplace_back(w.face, to);
    }
    if (moves.empty()) return;
    std::sort(moves.begin(), moves.end());  // the greatest of a face comes last
    for (const auto& [face, to] : moves) piece[face] = to;
  }
}

}  // namespace

Partition partition(const Mesh& mesh, std::uint32_t piece_faces, unsigned threads) {
  const Faces faces(mesh.corners, mesh.face_sizes);
  const std::uint32_t count = faces.count(), pieces = (count + piece_faces - 1) / piece_faces;
  std::vector<std::uint32_t> piece(mesh.vertex_count);
  std::uint32_t leaves = 1;
  constexpr std::uint32_t block = 1u << 16;
  const auto in_blocks = [&](std::uint32_t n, const auto& work) {
    for_each_item(n / block + 1, threads, [&](std::size_t i, unsigned) {
      const std::uint32_t begin = static_cast<std::uint32_t>(i * block);
      work(i, begin, begin + std::min(block, n - begin));
    });
  };
  if (pieces > 1) {
    const Places places(mesh, faces);
    std::optional<Tree> tree;
    std::vector<std::uint32_t> least;
    for_each_item(2, threads, [&](std::size_t i, unsigned) {
      if (i == 0)
        least =
            places_of_components(places, faces, mesh.vertex_count, mesh.vertex_count / pieces / 8);
      else
        tree.emplace(places, faces, mesh.vertex_count, pieces);
    });
    leaves = tree->leaves();
    in_blocks(mesh.vertex_count, [&](std::size_t, std::uint32_t begin, std::uint32_t end) {
      for (std::uint32_t v = begin; v < end; ++v) piece[v] = tree->leaf(least[v]);
    });
  }

  std::vector<std::uint32_t> of_face(count), size(leaves), mixed;
  std::vector<std::vector<std::uint32_t>> mixed_in(count / block + 1);
  in_blocks(count, [&](std::size_t i, std::uint32_t begin, std::uint32_t end) {
    std::vector<std::uint32_t> corners;
    for (std::uint32_t f = begin; f < end; ++f) {
      corners.clear();
      for (const std::uint32_t v : faces.cycle(f)) corners.push_back(piece[v]);
      of_face[f] = most_frequent(corners);
      if (std::any_of(corners.begin(), corners.end(),
                      [&](std::uint32_t p) { return p != of_face[f]; }))
        mixed_in[i].push_back(f);
    }
  });
  for (const auto& part : mixed_in) mixed.insert(mixed.end(), part.begin(), part.end());
  mend_pinches(faces, mesh.vertex_count, mixed, of_face);
  for (const std::uint32_t p : of_face) ++size[p];
  Partition result;
  std::vector<std::uint32_t> next(leaves);
  for (std::uint32_t i = 0, begin = 0; i < leaves; ++i) {
    next[i] = begin;
    begin += size[i];
    if (size[i] > 0) result.begin.push_back(begin);
  }
  result.faces.resize(count);
  for (std::uint32_t f = 0; f < count; ++f) result.faces[next[of_face[f]]++] = f;
  return result;
}

}  // namespace clers
