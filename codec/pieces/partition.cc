// Patches within cells as the nodes of a graph; then vertices at which pieces are pinched.
#include "codec/pieces/partition.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "codec/base/disjoint_sets.h"
#include "codec/base/faces.h"
#include "codec/base/no_index.h"
#include "codec/base/parallel.h"
#include "codec/pieces/bisection.h"
#include "codec/pieces/cells.h"
#include "topology/buckets.h"

namespace clers::internal {
namespace {

/// A mesh as a graph: what is connected within a cell is a node, weighing its vertices; what joins
/// two such are the sides of faces that run between them.
struct Patches {
  std::vector<std::uint32_t> node;  ///< of each vertex
  Graph graph;
};

/// Edges of a graph, in any order, each as often as it weighs, as arcs.
void set_arcs(std::vector<std::uint64_t> edges, Graph& graph) {
  std::sort(edges.begin(), edges.end());
  const auto for_each_edge = [&](const auto& visit) {
    for (std::size_t i = 0, j; i < edges.size(); i = j) {
      for (j = i; j < edges.size() && edges[j] == edges[i];) ++j;
      visit(static_cast<std::uint32_t>(edges[i] >> 32), static_cast<std::uint32_t>(edges[i]),
            static_cast<std::uint32_t>(j - i));
    }
  };
  std::vector<std::uint32_t>& begin = graph.begin;
  begin.assign(std::size_t(graph.count()) + 2, 0);
  for_each_edge([&](std::uint32_t a, std::uint32_t b, std::uint32_t) {
    ++begin[a + 2];
    ++begin[b + 2];
  });
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  graph.arcs.resize(begin.back());
  for_each_edge([&](std::uint32_t a, std::uint32_t b, std::uint32_t weight) {
    graph.arcs[begin[a + 1]++] = {b, weight};
    graph.arcs[begin[b + 1]++] = {a, weight};
  });
  begin.pop_back();
}

/// A component of at most `small` vertices is not parted, and goes as a whole where its first node
/// does. All such of a cell are one node, for there may be as many as vertices.
Patches patches_of(const SpatialKeys& places, const Faces& faces,
                   const std::vector<std::uint32_t>& cell, std::uint32_t small) {
  const std::uint32_t vertex_count = static_cast<std::uint32_t>(cell.size());
  DisjointSets vertices(vertex_count);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> across;
  for (std::uint32_t f = 0; f < faces.count(); ++f) {
    const auto cycle = faces.cycle(f);
    if (cycle.empty()) continue;
    const std::size_t before_face = across.size();
    for (std::size_t j = 1; j < cycle.size(); ++j)
      if (cell[cycle[j - 1]] == cell[cycle[j]])
        vertices.unite(cycle[j - 1], cycle[j]);
      else
        across.emplace_back(cycle[j - 1], cycle[j]);
    if (cell[cycle.back()] != cell[cycle.front()])
      across.emplace_back(cycle.back(), cycle.front());
    else if (cycle.size() > 2 && across.size() > before_face)
      vertices.unite(cycle.back(), cycle.front());
  }

  // Nodes are numbered by cell, and there by their least vertices: whatever the order of vertices
  // is. Where those are at one place, they are one node.
  Patches result;
  std::vector<std::uint32_t>& node = result.node;
  node = std::move(vertices).all();
  std::vector<std::uint32_t> least(vertex_count), roots;
  for (std::uint32_t v = 0; v < vertex_count; ++v) {
    const std::uint32_t r = node[v];
    if (r == v) roots.push_back(v);
    if (r == v || places.less(v, least[r])) least[r] = v;
  }
  const auto before = [&](std::uint32_t a, std::uint32_t b) {
    return cell[a] != cell[b] ? cell[a] < cell[b] : places.less(least[a], least[b]);
  };
  std::sort(roots.begin(), roots.end(), before);
  std::vector<std::uint32_t> cell_of, weight, number(roots.size());
  for (std::size_t i = 0; i < roots.size(); ++i) {
    if (i == 0 || before(roots[i - 1], roots[i])) cell_of.push_back(cell[roots[i]]);
    number[i] = static_cast<std::uint32_t>(cell_of.size()) - 1;
  }
  for (std::size_t i = 0; i < roots.size(); ++i) least[roots[i]] = number[i];
  weight.resize(cell_of.size());
  for (std::uint32_t& n : node) ++weight[n = least[n]];

  DisjointSets nodes(cell_of.size());
  std::vector<std::uint64_t> size(cell_of.size());
  for (const auto& [v, w] : across) nodes.unite(node[v], node[w]);
  const std::vector<std::uint32_t> component = std::move(nodes).all();
  for (std::uint32_t n = 0; n < component.size(); ++n) size[component[n]] += weight[n];
  number.resize(cell_of.size());
  std::vector<std::uint32_t>& weights = result.graph.weights;
  std::uint32_t cell_of_small = no_index, of_small = no_index;
  for (std::uint32_t n = 0; n < component.size(); ++n) {
    const std::uint32_t c = component[n];
    const bool is_small = size[c] <= small;
    if (is_small && c != n)
      number[n] = number[c];
    else if (is_small && cell_of[n] == cell_of_small)
      number[n] = of_small;
    else {
      number[n] = static_cast<std::uint32_t>(weights.size());
      weights.push_back(0);
      if (is_small) cell_of_small = cell_of[n], of_small = number[n];
    }
    weights[number[n]] += weight[n];
  }
  for (std::uint32_t& n : node) n = number[n];

  std::vector<std::uint64_t> edges;
  for (const auto& [v, w] : across) {
    const auto [a, b] = std::minmax(node[v], node[w]);
    if (a != b) edges.push_back(std::uint64_t(a) << 32 | b);
  }
  set_arcs(std::move(edges), result.graph);
  return result;
}

/// The piece of each vertex.
std::vector<std::uint32_t> pieces_of_vertices(const MeshView& mesh, const Faces& faces,
                                              std::uint32_t pieces, unsigned threads) {
  // Cells are what pieces are made of: 64 of them make a piece that is round enough, where there
  // are not too many in all.
  const std::uint32_t most = std::clamp((1u << 12) / pieces, 4u, 64u);
  const std::uint32_t each = std::clamp(mesh.vertex_count / pieces / 4, 1u, most);
  Patches patches;
  {
    const SpatialKeys places(mesh);
    patches =
        patches_of(places, faces, cells_of(places, faces, mesh.vertex_count, pieces, each, threads),
                   mesh.vertex_count / pieces / 8);
  }
  const std::vector<std::uint32_t> part = partition_graph(patches.graph, pieces);
  for (std::uint32_t& v : patches.node) v = part[v];
  return std::move(patches.node);
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
  std::vector<std::uint8_t> near(vertex_count);
  for (const std::uint32_t f : mixed_faces)
    for (const std::uint32_t v : faces.cycle(f)) near[v] = 1;
  std::vector<std::uint32_t> around;
  for (std::uint32_t f = 0; f < faces.count(); ++f) {
    const auto cycle = faces.cycle(f);
    if (std::any_of(cycle.begin(), cycle.end(), [&](std::uint32_t v) { return near[v]; }))
      around.push_back(f);
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
void repair_pinched_vertices(const Faces& faces, std::uint32_t vertex_count,
                             std::span<const std::uint32_t> mixed_faces,
                             std::span<std::uint32_t> piece) {
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

Partition partition(const MeshView& mesh, std::uint32_t piece_faces, unsigned threads) {
  const Faces faces(mesh.corners, mesh.face_sizes);
  const std::uint32_t count = faces.count(), pieces = (count + piece_faces - 1) / piece_faces;
  std::vector<std::uint32_t> of_face(count);
  if (pieces > 1) {
    const std::vector<std::uint32_t> piece = pieces_of_vertices(mesh, faces, pieces, threads);
    constexpr std::uint32_t block = 1u << 16;
    std::vector<std::vector<std::uint32_t>> mixed_in(count / block + 1);
    for_each_item(mixed_in.size(), threads, [&](std::size_t i, unsigned) {
      const std::uint32_t begin = static_cast<std::uint32_t>(i * block);
      std::vector<std::uint32_t> corners;
      for (std::uint32_t f = begin; f < begin + std::min(block, count - begin); ++f) {
        const auto cycle = faces.cycle(f);
        if (cycle.empty()) continue;
        of_face[f] = piece[cycle[0]];
        if (std::all_of(cycle.begin() + 1, cycle.end(),
                        [&](std::uint32_t v) { return piece[v] == of_face[f]; }))
          continue;
        corners.clear();
        for (const std::uint32_t v : cycle) corners.push_back(piece[v]);
        of_face[f] = most_frequent(corners);
        mixed_in[i].push_back(f);
      }
    });
    std::vector<std::uint32_t> mixed;
    for (const auto& part : mixed_in) mixed.insert(mixed.end(), part.begin(), part.end());
    repair_pinched_vertices(faces, mesh.vertex_count, mixed, of_face);
  }
  Buckets by_piece(count, pieces, [&](std::uint32_t f) { return of_face[f]; });
  Partition result;
  for (std::uint32_t i = 0; i < pieces; ++i)
    if (const auto size = static_cast<std::uint32_t>(by_piece[i].size()); size > 0)
      result.begin.push_back(result.begin.back() + size);
  result.faces = std::move(by_piece).items();
  return result;
}

}  // namespace clers::internal
