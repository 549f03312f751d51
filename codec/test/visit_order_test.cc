// The order of visit, by its definition: what has the most parallelograms comes next.
#include "codec/attributes/visit_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <vector>

#include "codec/test/coded_surfaces.h"

namespace clers::internal {
namespace {

/// How many sides of triangles with known vertices only each vertex is across from, 2 being many.
/// Known ones have none.
std::vector<unsigned> waiting(const CodedSurface& s, const std::vector<bool>& known) {
  std::vector<unsigned> count(known.size());
  for (std::uint32_t i = 0; i < s.corners.size(); ++i) {
    const HalfEdge h(i), across = s.twins[i];
    if (!across) continue;
    const std::uint32_t x = s.corners[lprev(across).index()];
    bool all = !known[x];
    for (const HalfEdge g : {h, lnext(h), lprev(h)}) all = all && known[s.corners[g.index()]];
    if (all) count[x] = std::min(count[x] + 1, 2u);
  }
  return count;
}

/// With copies a triangle may have been known before the vertex that is walked around, so that
/// what is across from it is not seen.
void check_order(const CodedSurface& s, bool copies) {
  std::vector<std::uint32_t> introduced;
  for_each_introduced(s, [&](std::uint32_t t, unsigned i) {
    introduced.push_back(s.corners[3 * std::size_t(t) + i]);
  });
  std::vector<bool> known(s.introduced_by.size());
  std::vector<std::uint32_t> order;
  // How many were visited when a vertex had its first parallelogram, its second.
  std::vector<std::size_t> since[3];
  for (auto& times : since) times.assign(known.size(), introduced.size());
  for_each_by_parallelograms(s, [&](HalfEdge h, const Visited& visited) {
    const std::uint32_t v = s.corners[h.index()];
    ASSERT_FALSE(known[v]);
    for (std::uint32_t u = 0; u < known.size(); ++u) ASSERT_EQ(visited(u), known[u]);
    if (!copies) {
      const auto count = waiting(s, known);
      const unsigned most = *std::max_element(count.begin(), count.end());
      ASSERT_EQ(count[v], most);
      for (std::uint32_t u = 0; u < known.size(); ++u)
        for (unsigned n = 1; n <= count[u]; ++n) since[n][u] = std::min(since[n][u], order.size());
      for (std::uint32_t u = 0; most > 0 && u < known.size(); ++u)
        ASSERT_TRUE(count[u] < most || since[most][v] <= since[most][u])
            << "not first in first out";
      unsigned found = 0;
      bool at_h = false;
      for_each_parallelogram(s, h, visited, [&](std::uint32_t a, std::uint32_t, std::uint32_t) {
        at_h |= found == 0 && a == s.corners[lnext(h).index()];
        ++found;
      });
      ASSERT_EQ(std::min(found, 2u), count[v]);
      ASSERT_EQ(at_h, most > 0);
      if (most == 0) {
        const auto next = std::find_if(introduced.begin(), introduced.end(),
                                       [&](std::uint32_t u) { return !known[u]; });
        ASSERT_EQ(v, *next);
      }
    }
    known[v] = true;
    order.push_back(v);
  });
  std::sort(order.begin(), order.end());
  std::sort(introduced.begin(), introduced.end());
  ASSERT_EQ(order, introduced);
}

TEST(VisitOrder, TakesWhatHasTheMostParallelograms) {
  const std::vector<CodedArrays> all = test::coded_surfaces();
  // The second half are the first with vertices made one.
  for (std::size_t i = 0; i < all.size(); ++i) check_order(all[i].view(), i >= all.size() / 2);
}

}  // namespace
}  // namespace clers::internal
