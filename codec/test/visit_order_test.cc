// The order of visit, by its definition: what is across from two known triangles comes next.
#include "codec/attributes/visit_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <deque>
#include <vector>

#include "codec/test/coded_surfaces.h"

namespace clers::internal {
namespace {

/// codec/format-values.md, Order of visit, word by word.
class Definition {
 public:
  explicit Definition(const CodedSurface& s)
      : s_(s), known_(s.introduced_by.size()), waited_(s.introduced_by.size()) {
    for_each_introduced(s, [&](std::uint32_t t, unsigned i) {
      if (known_[s_.corners[3 * std::size_t(t) + i]]) return;
      visit(half_edge(Face(t), i));
      while (!two_.empty() || !one_.empty()) {
        std::deque<HalfEdge>& queue = two_.empty() ? one_ : two_;
        const HalfEdge h = queue.front();
        queue.pop_front();
        if (known_[vertex(h)]) continue;
        EXPECT_TRUE(has_parallelogram(h));
        visit(h);
      }
    });
  }

  std::vector<HalfEdge> order;

 private:
  std::uint32_t vertex(HalfEdge h) const { return s_.corners[h.index()]; }
  bool knows(HalfEdge h) const { return known_[vertex(h)]; }
  HalfEdge across(HalfEdge h) const { return s_.twins[h.index()]; }

  /// Whether all of a, b, c are known where v is predicted at a + b - c.
  bool has_parallelogram(HalfEdge h) const {
    const HalfEdge over = across(lnext(h));
    return over && knows(lnext(h)) && knows(lprev(h)) && knows(lprev(over));
  }

  void wait(HalfEdge x) {
    if (knows(x)) return;
    const int n = ++waited_[vertex(x)];
    if (n == 1) one_.push_back(x);
    if (n == 2) two_.push_back(x);
  }
  void look_across(HalfEdge side) {
    if (across(side)) wait(lprev(across(side)));
  }

  void visit(HalfEdge first) {
    order.push_back(first);
    known_[vertex(first)] = true;
    if (!knows(lnext(first)) || !knows(lprev(first))) return;
    look_across(lnext(first));
    HalfEdge side = lprev(first);
    while (across(side)) {
      const HalfEdge h = across(side);
      if (h == first) return;
      side = lprev(h);
      if (!knows(side)) {
        wait(side);
        break;
      }
      look_across(lnext(h));
    }
    for (side = first; across(side);) {
      side = lnext(across(side));
      if (!knows(lnext(side))) return wait(lnext(side));
      look_across(lnext(side));
    }
  }

  const CodedSurface s_;
  std::vector<bool> known_;
  std::vector<int> waited_;
  std::deque<HalfEdge> one_, two_;
};

TEST(VisitOrder, IsThatOfTheFormat) {
  for (const CodedArrays& arrays : test::coded_surfaces()) {
    const CodedSurface s = arrays.view();
    const Definition definition(s);
    std::vector<HalfEdge> order;
    std::vector<bool> known(s.introduced_by.size());
    for_each_by_parallelograms(s, [&](HalfEdge h, const Visited& visited) {
      for (std::uint32_t u = 0; u < known.size(); ++u) ASSERT_EQ(visited(u), known[u]);
      known[s.corners[h.index()]] = true;
      order.push_back(h);
    });
    ASSERT_EQ(order, definition.order);
  }
}

TEST(VisitOrder, HasEachVertexOnce) {
  for (const CodedArrays& arrays : test::coded_surfaces()) {
    const CodedSurface s = arrays.view();
    std::vector<std::uint32_t> introduced, visited;
    for_each_introduced(s, [&](std::uint32_t t, unsigned i) {
      introduced.push_back(s.corners[3 * std::size_t(t) + i]);
    });
    for_each_by_parallelograms(
        s, [&](HalfEdge h, const Visited&) { visited.push_back(s.corners[h.index()]); });
    std::sort(introduced.begin(), introduced.end());
    std::sort(visited.begin(), visited.end());
    ASSERT_EQ(visited, introduced);
  }
}

}  // namespace
}  // namespace clers::internal
