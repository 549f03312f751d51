#include "codec/aside_curves.h"

#include <gtest/gtest.h>

#include <deque>
#include <random>
#include <vector>

namespace clers {
namespace {

/// Labels of vertices from the end of the gate to its origin.
using Labels = std::deque<std::uint32_t>;

/// The walk of Edgebreaker as far as curves go, at random, with curves written out.
class Walk {
 public:
  explicit Walk(unsigned seed) : random_(seed) { begin(); }

  void step() {
    const unsigned what = static_cast<unsigned>(random_() % 16);
    if (what < 6 || gate_.size() < 3) {
      gate_.push_back(++last_);  // C
    } else if (what < 8) {
      gate_.pop_back();  // L
    } else if (what < 10) {
      gate_.pop_front();  // R
    } else if (what < 13) {
      part();
    } else if (what < 15) {
      join();
    } else {
      end();
    }
  }

  void check() {
    for (const std::uint32_t label : gate_) ASSERT_EQ(curves_.find(label), AsideCurves::none);
    for (std::size_t i = 0; i < aside_.size(); ++i)
      for (const std::uint32_t label : aside_[i]) ASSERT_EQ(curves_.find(label), i);
  }

  std::size_t joins = 0, deepest = 0;

 private:
  void begin() {
    gate_.clear();
    for (int i = 0; i < 3; ++i) gate_.push_back(++last_);
  }

  /// An S whose vertex is on the gate's curve: what is behind it is put aside.
  void part() {
    const auto at = gate_.begin() + static_cast<std::ptrdiff_t>(1 + random_() % (gate_.size() - 2));
    aside_.emplace_back(at, gate_.end());
    curves_.put(0, HalfEdge(), *at, gate_.back());
    gate_.erase(at, gate_.end());
    gate_.push_back(++last_);
    deepest = std::max(deepest, aside_.size());
  }

  /// One whose vertex is on a curve put aside: all of that gets labels anew.
  void join() {
    if (aside_.empty()) return;
    const std::size_t i = random_() % aside_.size();
    if (aside_[i].empty()) return;
    curves_[i].joined = true;
    for (std::size_t k = 0; k <= aside_[i].size(); ++k) gate_.push_back(++last_);
    aside_[i].clear();
    ++joins;
  }

  void end() {
    do {
      if (curves_.empty()) return begin();
      gate_ = aside_.back();
      aside_.pop_back();
    } while (curves_.take().joined);
  }

  std::mt19937 random_;
  AsideCurves curves_;
  Labels gate_;
  std::vector<Labels> aside_;
  std::uint32_t last_ = 0;
};

TEST(AsideCurves, KnowWhichCurveAVertexIsOn) {
  std::size_t joins = 0, deepest = 0;
  for (unsigned seed = 0; seed < 300; ++seed) {
    Walk walk(seed);
    for (int i = 0; i < 200; ++i) {
      walk.step();
      ASSERT_NO_FATAL_FAILURE(walk.check()) << "seed " << seed << ", step " << i;
    }
    joins += walk.joins;
    deepest = std::max(deepest, walk.deepest);
  }
  EXPECT_GT(joins, 1000u);
  EXPECT_GT(deepest, 8u);
}

}  // namespace
}  // namespace clers
