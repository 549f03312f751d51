#include "codec/connectivity/curve_index.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "codec/connectivity/sequences.h"
#include "codec/connectivity/waiting_curves.h"
#include "corpus/random.h"

namespace clers::internal {
namespace {

using Node = Sequences::Node;

/// Trees and the sequences that they must be, written out.
class Pair {
 public:
  explicit Pair(std::uint64_t seed) : random_(seed) {}

  void step() {
    switch (random_.below(6)) {
      case 0:
      case 1: {
        const std::uint32_t places = 1 + random_.below(4);
        const Node n = sequences_.make(places);
        trees_.push_back(n);
        written_.push_back(std::vector<Node>(places, n));
        break;
      }
      case 2: {
        if (trees_.size() < 2) break;
        const std::size_t i = any(), j = any();
        if (i == j) break;
        trees_[i] = sequences_.join(trees_[i], trees_[j]);
        written_[i].insert(written_[i].end(), written_[j].begin(), written_[j].end());
        erase(j);
        break;
      }
      case 3: {
        if (trees_.empty()) break;
        const std::size_t i = any();
        const std::uint32_t k = random_.below(static_cast<std::uint32_t>(written_[i].size()));
        const Node n = trees_[i] = sequences_.find(trees_[i], k);
        ASSERT_EQ(n, written_[i][k]);
        const bool after = random_.chance(50);
        const auto first = std::find(written_[i].begin(), written_[i].end(), n);
        const auto cut = after ? first + sequences_.places(n) : first;
        const Node part = after ? sequences_.cut_after(n) : sequences_.cut_before(n);
        ASSERT_EQ(part == 0, cut == (after ? written_[i].end() : written_[i].begin()));
        if (part == 0) break;
        std::vector<Node> other(cut, written_[i].end());
        written_[i].erase(cut, written_[i].end());
        if (!after) written_[i].swap(other);
        trees_.push_back(part);
        written_.push_back(other);
        break;
      }
      case 4: {
        if (trees_.empty()) break;
        const std::size_t i = any();
        const Node n = written_[i][random_.below(static_cast<std::uint32_t>(written_[i].size()))];
        sequences_.set_name(trees_[i], 7);
        trees_[i] = sequences_.to_root(n);
        ASSERT_EQ(sequences_.name(n), 7u);
        ASSERT_EQ(sequences_.before(n),
                  static_cast<std::uint32_t>(std::find(written_[i].begin(), written_[i].end(), n) -
                                             written_[i].begin()));
        break;
      }
      default:
        if (trees_.empty() || !random_.chance(20)) break;
        const std::size_t i = any();
        sequences_.release(trees_[i]);
        erase(i);
    }
  }

  void check() {
    for (std::size_t i = 0; i < trees_.size(); ++i) {
      ASSERT_EQ(sequences_.length(trees_[i]), written_[i].size());
      for (std::uint32_t k = 0; k < written_[i].size(); ++k) {
        trees_[i] = sequences_.find(trees_[i], k);
        ASSERT_EQ(trees_[i], written_[i][k]);
      }
    }
  }

 private:
  std::size_t any() { return random_.below(static_cast<std::uint32_t>(trees_.size())); }
  void erase(std::size_t i) {
    trees_.erase(trees_.begin() + static_cast<std::ptrdiff_t>(i));
    written_.erase(written_.begin() + static_cast<std::ptrdiff_t>(i));
  }

  corpus::Random random_;
  Sequences sequences_;
  std::vector<Node> trees_;
  std::vector<std::vector<Node>> written_;  ///< a node for each of its places
};

TEST(Sequences, AreWhatWasJoinedAndCut) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    Pair pair(seed);
    for (int i = 0; i < 300; ++i) {
      ASSERT_NO_FATAL_FAILURE(pair.step()) << "seed " << seed << ", step " << i;
      if (i % 10 != 0) continue;
      ASSERT_NO_FATAL_FAILURE(pair.check()) << "seed " << seed << ", step " << i;
    }
  }
}

TEST(WaitingCurves, AreTakenByRecency) {
  corpus::Random random(1);
  WaitingCurves waiting;
  std::vector<std::uint32_t> written, tickets;
  for (std::uint32_t i = 1; i < 5000; ++i) {
    if (written.empty() || random.chance(i < 3000 ? 60 : 40)) {
      written.push_back(i);
      tickets.push_back(waiting.put(i));
      continue;
    }
    const std::uint32_t recency = random.below(static_cast<std::uint32_t>(written.size()));
    const auto at = static_cast<std::ptrdiff_t>(written.size() - 1 - recency);
    ASSERT_EQ(waiting.recency(tickets[static_cast<std::size_t>(at)]), recency);
    ASSERT_EQ(waiting.take(recency), written[static_cast<std::size_t>(at)]);
    written.erase(written.begin() + at);
    tickets.erase(tickets.begin() + at);
    ASSERT_EQ(waiting.size(), written.size());
  }
}

/// Curves of a front at random, written out, a vertex at place 0 first.
using Vertices = std::vector<std::uint32_t>;

class Curves {
 public:
  explicit Curves(std::uint64_t seed)
      : random_(seed), links_(1u << 14), index_(links_.data(), links_.size()) {
    fresh();
  }

  void step() {
    switch (random_.below(12)) {
      case 0:
      case 1:
      case 2: gate_.push_back(made_++), relink(gate_); break;
      case 3:
      case 4: gate_.insert(gate_.begin(), made_++), relink(gate_); break;
      case 5:
      case 6:
      case 7:
        if (gate_.size() > 3) gate_.erase(gate_.begin()), relink(gate_);
        break;
      case 8:
        pending_.push_back(gate_);
        fresh();
        break;
      case 9:
        if (pending_.empty()) break;
        gate_.erase(gate_.begin());
        gate_.insert(gate_.begin(), pending_.back().begin(), pending_.back().end());
        pending_.pop_back();
        relink(gate_);
        break;
      case 10: split(); break;
      default: join();
    }
  }

  std::size_t longest = 0;

 private:
  void fresh() {
    gate_.clear();
    for (int i = 0; i < 3; ++i) gate_.push_back(made_++);
    relink(gate_);
  }
  /// Links of the vertices on a curve; that of y is of no use to anybody.
  void relink(const Vertices& curve) {
    for (std::size_t i = 0; i + 1 < curve.size(); ++i) links_[curve[i]].prev = curve[i + 1];
    links_[curve.back()].prev = 0xffffffffu;
    longest = std::max(longest, curve.size());
  }
  CurveIndex::Curve gather() {
    CurveIndex::Curve c = index_.gather(gate_.front(), gate_.back());
    EXPECT_EQ(index_.length(c), gate_.size());
    for (std::uint32_t k = 0; k < gate_.size(); ++k) EXPECT_EQ(index_.vertex(c, k), gate_[k]);
    const std::uint32_t k = random_.below(static_cast<std::uint32_t>(gate_.size()));
    const auto [found, place] = index_.place(gate_[k]);
    EXPECT_EQ(place, k);
    EXPECT_EQ(index_.name(found), 0u);
    return found;
  }
  void split() {
    if (gate_.size() < 5) return;
    const std::uint32_t d = 2 + random_.below(static_cast<std::uint32_t>(gate_.size() - 4));
    const CurveIndex::Curve ring = index_.split_off(gather(), d);
    index_.set_name(ring, made_);
    rings_.push_back({Vertices(gate_.begin() + 1, gate_.begin() + 1 + d), made_});
    gate_.erase(gate_.begin(), gate_.begin() + 1 + d);
    const Vertices& r = rings_.back().vertices;
    relink(r);
    links_[r.back()].prev = r.front();
    relink(gate_);
  }
  void join() {
    if (rings_.empty()) return;
    const std::size_t i = random_.below(static_cast<std::uint32_t>(rings_.size()));
    Vertices& r = rings_[i].vertices;
    const std::uint32_t k = random_.below(static_cast<std::uint32_t>(r.size()));
    const CurveIndex::Curve gate = gather();
    const auto [ring, place] = index_.place(r[k]);
    ASSERT_EQ(index_.length(ring), r.size());
    ASSERT_EQ(index_.name(ring), rings_[i].name);
    ASSERT_EQ(place, k);
    index_.join(gate, ring, k);
    std::rotate(r.begin(), r.begin() + (k + 1) % static_cast<std::uint32_t>(r.size()), r.end());
    gate_.erase(gate_.begin());
    gate_.insert(gate_.begin(), r.begin(), r.end());
    rings_.erase(rings_.begin() + static_cast<std::ptrdiff_t>(i));
    relink(gate_);
  }

  struct Ring {
    Vertices vertices;
    std::uint32_t name;
  };
  corpus::Random random_;
  std::vector<FrontLink> links_;
  CurveIndex index_;
  Vertices gate_;
  std::vector<Vertices> pending_;
  std::vector<Ring> rings_;
  std::uint32_t made_ = 1;
};

TEST(CurveIndex, KnowsWhatIsWhere) {
  std::size_t longest = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    Curves curves(seed);
    for (int i = 0; i < 3000 && !::testing::Test::HasFailure(); ++i) curves.step();
    ASSERT_FALSE(HasFailure()) << "seed " << seed;
    longest = std::max(longest, curves.longest);
  }
  EXPECT_GT(longest, 200u);
}

}  // namespace
}  // namespace clers::internal
