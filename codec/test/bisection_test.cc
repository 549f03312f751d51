#include "codec/pieces/bisection.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>
#include <numeric>

namespace clers::internal {
namespace {

using Edges = std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t>;

Graph graph_of(std::vector<std::uint32_t> weights, const Edges& edges) {
  Graph graph;
  graph.weights = std::move(weights);
  for (std::uint32_t n = 0; n < graph.count(); ++n) {
    for (const auto& [ends, weight] : edges) {
      if (ends.first == n) graph.arcs.push_back({ends.second, weight});
      if (ends.second == n) graph.arcs.push_back({ends.first, weight});
    }
    graph.begin.push_back(static_cast<std::uint32_t>(graph.arcs.size()));
  }
  return graph;
}

std::uint64_t cut(const Edges& edges, const std::vector<std::uint32_t>& part) {
  std::uint64_t sum = 0;
  for (const auto& [ends, weight] : edges)
    sum += part[ends.first] != part[ends.second] ? weight : 0;
  return sum;
}

std::vector<std::uint64_t> weights(const Graph& graph, std::uint32_t parts,
                                   const std::vector<std::uint32_t>& part) {
  std::vector<std::uint64_t> sums(parts);
  for (std::uint32_t n = 0; n < graph.count(); ++n) sums.at(part[n]) += graph.weights[n];
  return sums;
}

TEST(Bisection, NothingAndLittle) {
  EXPECT_TRUE(partition_graph({}, 3).empty());
  EXPECT_EQ(partition_graph(graph_of({5}, {}), 1), std::vector<std::uint32_t>{0});
  EXPECT_LT(partition_graph(graph_of({5}, {}), 4)[0], 4u);
  const auto part = partition_graph(graph_of({1, 1, 1, 1}, {}), 4);
  EXPECT_EQ(std::accumulate(part.begin(), part.end(), 0u), 0u + 1 + 2 + 3);
}

/// Cliques in a ring of single edges, whatever their numbers: it is known which edges to cut.
RC_GTEST_PROP(Bisection, FindsCliques, ()) {
  const std::uint32_t cliques = *rc::gen::inRange(2u, 9u), size = *rc::gen::inRange(4u, 12u);
  std::vector<std::uint32_t> name(cliques * size);
  std::iota(name.begin(), name.end(), 0u);
  for (std::size_t i = name.size() - 1; i > 0; --i)
    std::swap(name[i], name[*rc::gen::inRange<std::size_t>(0, i + 1)]);
  Edges edges;
  const auto join = [&](std::uint32_t a, std::uint32_t b) {
    edges[std::minmax(name[a], name[b])] = 1;
  };
  for (std::uint32_t c = 0; c < cliques; ++c) {
    for (std::uint32_t i = 0; i < size; ++i)
      for (std::uint32_t j = 0; j < i; ++j) join(c * size + i, c * size + j);
    join(c * size, (c + 1) % cliques * size + 1);
  }
  const Graph graph = graph_of(std::vector<std::uint32_t>(name.size(), 7), edges);
  const auto part = partition_graph(graph, cliques);
  RC_ASSERT(cut(edges, part) == cliques);
  for (const std::uint64_t w : weights(graph, cliques, part)) RC_ASSERT(w == 7 * size);
}

/// Two halves of random graphs of ten nodes, beside the best of all halves.
TEST(Bisection, IsNearlyAlwaysTheLeast) {
  std::uint64_t state = 1;
  const auto random = [&](std::uint64_t below) {
    state = state * 6364136223846793005u + 1442695040888963407u;
    return static_cast<std::uint32_t>((state >> 33) % below);
  };
  constexpr std::uint32_t n = 10;
  unsigned least_of_all = 0;
  constexpr unsigned graphs = 300;
  for (unsigned g = 0; g < graphs; ++g) {
    Edges edges;
    for (std::uint32_t a = 0; a < n; ++a)
      for (std::uint32_t b = a + 1; b < n; ++b)
        if (random(10) < 3) edges[{a, b}] = 1 + random(9);
    const Graph graph = graph_of(std::vector<std::uint32_t>(n, 1), edges);
    std::uint64_t least = ~std::uint64_t(0);
    for (std::uint32_t half = 0; half < 1u << n; ++half) {
      if (std::popcount(half) != n / 2) continue;
      std::vector<std::uint32_t> part;
      for (std::uint32_t i = 0; i < n; ++i) part.push_back(half >> i & 1);
      least = std::min(least, cut(edges, part));
    }
    const auto part = partition_graph(graph, 2);
    EXPECT_EQ(weights(graph, 2, part)[0], n / 2);
    const std::uint64_t found = cut(edges, part);
    EXPECT_GE(found, least);
    EXPECT_LE(2 * found, 3 * least);
    least_of_all += found == least;
  }
  EXPECT_GE(least_of_all, graphs * 95 / 100);
}

TEST(Bisection, PartsWeighAboutTheSame) {
  constexpr std::uint32_t side = 60;
  Edges edges;
  std::vector<std::uint32_t> node_weights;
  for (std::uint32_t y = 0; y < side; ++y)
    for (std::uint32_t x = 0; x < side; ++x) {
      node_weights.push_back(90 + (x * 7 + y * 3) % 20);
      if (x > 0) edges[{y * side + x - 1, y * side + x}] = 1;
      if (y > 0) edges[{(y - 1) * side + x, y * side + x}] = 1;
    }
  const Graph graph = graph_of(node_weights, edges);
  const std::uint64_t total = std::accumulate(node_weights.begin(), node_weights.end(), 0u);
  for (const std::uint32_t parts : {2u, 3u, 9u, 16u, 25u}) {
    const auto part = partition_graph(graph, parts);
    for (const std::uint64_t w : weights(graph, parts, part)) {
      EXPECT_GT(w * parts, total * 9 / 10) << parts;
      EXPECT_LT(w * parts, total * 11 / 10) << parts;
    }
    // Squares would be cut least: of `parts` of them each has four sides.
    const double squares = 2.0 * side * (std::sqrt(parts) - 1);
    EXPECT_LE(static_cast<double>(cut(edges, part)), 1.25 * squares + 12) << parts;
  }
}

}  // namespace
}  // namespace clers::internal
