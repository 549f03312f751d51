#include "codec/pieces/bisection.h"

#include <algorithm>
#include <numeric>
#include <queue>
#include <tuple>
#include <utility>

#include "codec/base/no_index.h"

namespace clers::internal {
namespace {

using Nodes = std::vector<std::uint32_t>;

std::uint64_t weight_of(const Graph& graph) {
  return std::accumulate(graph.weights.begin(), graph.weights.end(), std::uint64_t(0));
}

/// What is left of a graph of some of its nodes, numbered in their order. `number` has `no_index`
/// for each node of the graph, before and after.
Graph subgraph(const Graph& graph, std::span<const std::uint32_t> nodes, Nodes& number) {
  Graph result;
  for (const std::uint32_t n : nodes) {
    number[n] = result.count();
    result.weights.push_back(graph.weights[n]);
  }
  for (const std::uint32_t n : nodes) {
    for (const Graph::Arc& arc : graph.around(n))
      if (number[arc.to] != no_index) result.arcs.push_back({number[arc.to], arc.weight});
    result.begin.push_back(static_cast<std::uint32_t>(result.arcs.size()));
  }
  for (const std::uint32_t n : nodes) number[n] = no_index;
  return result;
}

/// The nodes of a graph on two sides.
class Bisection {
 public:
  /// The left side should weigh `left`, give or take `slack`.
  Bisection(const Graph& graph, std::uint64_t left, std::uint64_t slack)
      : graph_(graph),
        left_(left),
        slack_(slack),
        while_moving_(slack),
        locked_(graph.count()),
        gain_(graph.count()) {
    for (const std::uint32_t w : graph.weights)
      while_moving_ = std::max<std::uint64_t>(while_moving_, w);
  }

  /// The first nodes of those given to the left, as many as it takes.
  void begin(std::span<const std::uint32_t> order) {
    std::vector<std::uint8_t> side(graph_.count(), 1);
    std::uint64_t weight = 0;
    for (const std::uint32_t n : order) {
      if (off(weight + graph_.weights[n]) > off(weight)) break;
      weight += graph_.weights[n];
      side[n] = 0;
    }
    begin(std::move(side));
  }

  void begin(std::vector<std::uint8_t> side) {
    side_ = std::move(side);
    weight_ = cut_ = 0;
    for (std::uint32_t n = 0; n < graph_.count(); ++n) {
      if (side_[n]) continue;
      weight_ += graph_.weights[n];
      for (const Graph::Arc& arc : graph_.around(n)) cut_ += side_[arc.to] ? arc.weight : 0;
    }
  }

  /// Moves nodes across until that helps no more.
  void improve() {
    for (unsigned round = 0; round < most_rounds && pass(); ++round) {
    }
  }

  std::uint64_t cut() const { return cut_; }
  /// What the left side weighs too much or too little, beyond what it may.
  std::uint64_t excess() const { return excess(weight_); }
  const std::vector<std::uint8_t>& side() const { return side_; }

 private:
  static constexpr unsigned most_rounds = 3;

  struct Candidate {
    std::int64_t gain;
    std::uint32_t node;
    bool operator<(const Candidate& other) const {
      return gain != other.gain ? gain < other.gain : node > other.node;
    }
  };

  std::uint64_t off(std::uint64_t weight) const {
    return weight > left_ ? weight - left_ : left_ - weight;
  }
  std::uint64_t excess(std::uint64_t weight) const {
    return off(weight) - std::min(off(weight), slack_);
  }
  std::uint64_t weight_after(std::uint32_t n) const {
    return side_[n] ? weight_ + graph_.weights[n] : weight_ - graph_.weights[n];
  }
  void move(std::uint32_t n) {
    weight_ = weight_after(n);
    side_[n] ^= 1;
  }

  /// Moves a node at most once, the best first, even where that cuts more for a while; then undoes
  /// what came after the best moment. Was anything gained?
  bool pass() {
    std::priority_queue<Candidate> queue[2];
    for (std::uint32_t n = 0; n < graph_.count(); ++n) {
      gain_[n] = 0;
      bool on_cut = graph_.around(n).empty();
      for (const Graph::Arc& arc : graph_.around(n)) {
        const bool across = side_[n] != side_[arc.to];
        gain_[n] += across ? std::int64_t(arc.weight) : -std::int64_t(arc.weight);
        on_cut = on_cut || across;
      }
      locked_[n] = false;
      // Those inside come into question when a neighbour moves, unless there is too much here.
      if (on_cut || excess() > 0) queue[side_[n]].push({gain_[n], n});
    }
    const auto state = [&] { return std::tuple(excess(), cut_, off(weight_)); };
    auto best = state();
    std::size_t best_moves = 0;
    Nodes moved;
    const std::size_t patience = 50 + graph_.count() / 32;
    while (moved.size() < best_moves + patience) {
      const Candidate* next = nullptr;
      for (auto& candidates : queue) {
        while (!candidates.empty()) {
          const auto [gain, n] = candidates.top();
          const std::uint64_t then = off(weight_after(n));
          if (!locked_[n] && gain == gain_[n] && (then <= while_moving_ || then < off(weight_)))
            break;
          candidates.pop();
        }
        if (!candidates.empty() && (!next || next->gain < candidates.top().gain))
          next = &candidates.top();
      }
      if (!next) break;
      const std::uint32_t n = next->node;
      cut_ = static_cast<std::uint64_t>(static_cast<std::int64_t>(cut_) - gain_[n]);
      move(n);
      locked_[n] = true;
      moved.push_back(n);
      for (const Graph::Arc& arc : graph_.around(n)) {
        const std::int64_t change = 2 * std::int64_t(arc.weight);
        gain_[arc.to] += side_[n] == side_[arc.to] ? -change : change;
        if (!locked_[arc.to]) queue[side_[arc.to]].push({gain_[arc.to], arc.to});
      }
      if (state() < best) {
        best = state();
        best_moves = moved.size();
      }
    }
    for (; moved.size() > best_moves; moved.pop_back()) move(moved.back());
    cut_ = std::get<1>(best);
    return best_moves > 0;
  }

  const Graph& graph_;
  std::uint64_t left_, slack_;
  std::uint64_t while_moving_;  ///< what sides may be off by before all is done: a node at least
  std::uint64_t weight_ = 0, cut_ = 0;  ///< of the left side, and what runs across
  std::vector<std::uint8_t> side_, locked_;
  std::vector<std::int64_t> gain_;  ///< how much less is cut if the node moves
};

/// All nodes by their distance from one; components follow each other.
Nodes by_distance(const Graph& graph, std::uint32_t from) {
  Nodes order;
  std::vector<bool> met(graph.count());
  const auto reach = [&](std::uint32_t n) {
    if (met[n]) return;
    met[n] = true;
    order.push_back(n);
  };
  reach(from);
  for (std::uint32_t i = 0, other = 0; i < graph.count(); ++i) {
    while (i == order.size()) reach(other++);
    for (const Graph::Arc& arc : graph.around(order[i])) reach(arc.to);
  }
  return order;
}

/// What parts may weigh more or less than they should.
std::uint64_t slack(std::uint64_t part) {
  return part / 25;
}

/// The side of each node such that the left one has its share of the parts.
std::vector<std::uint8_t> bisect(const Graph& graph, std::uint32_t left_parts,
                                 std::uint32_t parts) {
  const std::uint64_t weight = weight_of(graph);
  Bisection bisection(graph, weight * left_parts / parts, slack(weight / parts));
  std::vector<std::uint8_t> side;
  std::pair<std::uint64_t, std::uint64_t> least;
  const auto try_from = [&](std::span<const std::uint32_t> order) {
    bisection.begin(order);
    bisection.improve();
    const std::pair found(bisection.excess(), bisection.cut());
    if (!side.empty() && found >= least) return;
    least = found;
    side = bisection.side();
  };
  Nodes order(graph.count());
  std::iota(order.begin(), order.end(), 0u);
  try_from(order);
  // Large graphs take long, and have long been cut well when they have become small.
  const std::uint32_t starts = std::clamp((1u << 15) / graph.count(), 1u, 12u);
  for (std::uint32_t i = 0; i < starts; ++i) {
    // What is farthest from anywhere is an end of the graph.
    const auto from = static_cast<std::uint32_t>(std::uint64_t(graph.count()) * i / starts);
    order = by_distance(graph, from);
    if (i % 2 == 0) order = by_distance(graph, order.back());
    try_from(order);
  }
  return side;
}

void part(const Graph& graph, std::span<const std::uint32_t> names, std::uint32_t first,
          std::uint32_t parts, Nodes& result) {
  if (parts == 1 || graph.count() == 0) {
    for (const std::uint32_t n : names) result[n] = first;
    return;
  }
  const std::vector<std::uint8_t> side = bisect(graph, parts / 2, parts);
  for (const bool right : {false, true}) {
    Nodes nodes, names_there, number(graph.count(), no_index);
    for (std::uint32_t n = 0; n < graph.count(); ++n)
      if (side[n] == right) {
        nodes.push_back(n);
        names_there.push_back(names[n]);
      }
    part(subgraph(graph, nodes, number), names_there, right ? first + parts / 2 : first,
         right ? parts - parts / 2 : parts / 2, result);
  }
}

/// Halving after halving has cut where a look at all parts would not: lets each two neighbours
/// exchange nodes.
void exchange(const Graph& graph, std::uint32_t parts, Nodes& part_of) {
  const std::uint64_t most = weight_of(graph) / parts;
  std::vector<Nodes> nodes_of(parts);
  for (std::uint32_t n = 0; n < graph.count(); ++n) nodes_of[part_of[n]].push_back(n);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> neighbours;
  for (std::uint32_t n = 0; n < graph.count(); ++n)
    for (const Graph::Arc& arc : graph.around(n))
      if (part_of[n] < part_of[arc.to]) neighbours.emplace_back(part_of[n], part_of[arc.to]);
  std::sort(neighbours.begin(), neighbours.end());
  neighbours.erase(std::unique(neighbours.begin(), neighbours.end()), neighbours.end());
  Nodes number(graph.count(), no_index), both;
  for (const auto& [a, b] : neighbours) {
    both.clear();
    std::merge(nodes_of[a].begin(), nodes_of[a].end(), nodes_of[b].begin(), nodes_of[b].end(),
               std::back_inserter(both));
    const Graph pair = subgraph(graph, both, number);
    std::vector<std::uint8_t> side;
    for (const std::uint32_t n : both) side.push_back(part_of[n] == b);
    Bisection bisection(pair, weight_of(pair) / 2, slack(most));
    bisection.begin(std::move(side));
    bisection.improve();
    nodes_of[a].clear();
    nodes_of[b].clear();
    for (std::uint32_t i = 0; i < both.size(); ++i) {
      part_of[both[i]] = bisection.side()[i] ? b : a;
      nodes_of[part_of[both[i]]].push_back(both[i]);
    }
  }
}

}  // namespace

std::vector<std::uint32_t> partition_graph(const Graph& graph, std::uint32_t parts) {
  Nodes result(graph.count()), names(graph.count());
  std::iota(names.begin(), names.end(), 0u);
  part(graph, names, 0, parts, result);
  for (unsigned round = 0; round < 2; ++round) exchange(graph, parts, result);
  return result;
}

}  // namespace clers::internal
