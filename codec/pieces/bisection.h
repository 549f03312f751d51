// Partitioning a graph so that few of its edges are cut. Knows no mesh.
#ifndef CLERS_CODEC_PIECES_BISECTION_H
#define CLERS_CODEC_PIECES_BISECTION_H

#include <cstdint>
#include <span>
#include <vector>

namespace clers::internal {

/// Nodes and edges with weights. An edge is two arcs.
struct Graph {
  struct Arc {
    std::uint32_t to, weight;
  };
  std::vector<std::uint32_t> weights;      ///< of the nodes
  std::vector<Arc> arcs;                   ///< node after node
  std::vector<std::uint32_t> begin = {0};  ///< of each node in `arcs`, and one past the last

  std::uint32_t count() const { return static_cast<std::uint32_t>(weights.size()); }
  std::span<const Arc> around(std::uint32_t node) const {
    return std::span(arcs).subspan(begin[node], begin[node + 1] - begin[node]);
  }
};

/// The part of each node, 0 .. parts - 1, such that parts weigh about the same (4 % more or less,
/// as far as nodes allow) and few edges run between them. The graph is halved again and again: of
/// several halvings, each improved by moves across (Fiduccia and Mattheyses, 1982), the one that
/// cuts least is taken; in the end parts exchange nodes in pairs. A part may be empty where single
/// nodes weigh much. The result depends on the numbers of nodes, and is better where neighbours
/// have near ones. Cost: n log n for each doubling of the parts. Throws std::bad_alloc only.
std::vector<std::uint32_t> partition_graph(const Graph& graph, std::uint32_t parts);

}  // namespace clers::internal

#endif
