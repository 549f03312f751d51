// What the rooms of the codec share, against the slow and obvious way.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

#include "codec/base/disjoint_sets.h"
#include "codec/base/faces.h"
#include "codec/base/least_rotation.h"
#include "topology/buckets.h"

namespace clers::internal {
namespace {

using Numbers = std::vector<std::uint32_t>;

std::uint32_t below(std::uint32_t n) {
  return *rc::gen::inRange<std::uint32_t>(0, n);
}

RC_GTEST_PROP(DisjointSets, LeastOfThoseThatAreConnected, ()) {
  const std::uint32_t n = 1 + below(40);
  DisjointSets sets(n);
  Numbers least(n);
  std::iota(least.begin(), least.end(), 0u);
  for (std::uint32_t i = below(2 * n); i > 0; --i) {
    const std::uint32_t v = below(n), w = below(n);
    sets.unite(v, w);
    const auto [low, high] = std::minmax({least[v], least[w]});
    std::replace(least.begin(), least.end(), high, low);
  }
  for (std::uint32_t v = 0; v < n; ++v) RC_ASSERT(sets.find(v) == least[v]);
  RC_ASSERT(std::move(sets).all() == least);
}

RC_GTEST_PROP(DisjointSets, AllFindsWithoutBeingAsked, ()) {
  const std::uint32_t n = 1 + below(40);
  DisjointSets asked(n), silent(n);
  for (std::uint32_t i = below(2 * n); i > 0; --i) {
    const std::uint32_t v = below(n), w = below(n);
    asked.unite(v, w);
    silent.unite(v, w);
  }
  const Numbers all = std::move(silent).all();
  for (std::uint32_t v = 0; v < n; ++v) RC_ASSERT(all[v] == asked.find(v));
}

RC_GTEST_PROP(SignedSets, EqualsAndOpposites, ()) {
  const std::uint32_t n = 1 + below(30);
  SignedSets sets;
  Numbers set(n), weight(n);
  std::vector<bool> sign(n);
  for (std::uint32_t v = 0; v < n; ++v) {
    weight[v] = below(5);
    sets.add(weight[v]);
    set[v] = v;
  }
  for (std::uint32_t i = below(3 * n); i > 0; --i) {
    const std::uint32_t v = below(n), w = below(n);
    const bool opposites = below(2) == 1, apart = set[v] != set[w];
    RC_ASSERT(sets.unite(v, w, opposites) == (apart || (sign[v] != sign[w]) == opposites));
    if (!apart) continue;
    const bool turn = (sign[v] != sign[w]) != opposites;
    const std::uint32_t from = set[w], to = set[v];
    for (std::uint32_t u = 0; u < n; ++u) {
      if (set[u] != from) continue;
      set[u] = to;
      sign[u] = sign[u] != turn;
    }
  }
  for (std::uint32_t v = 0; v < n; ++v) {
    std::uint64_t sum = 0;
    for (std::uint32_t w = 0; w < n; ++w) {
      const auto a = sets.find(v), b = sets.find(w);
      RC_ASSERT((a.set == b.set) == (set[v] == set[w]));
      if (a.set != b.set) continue;
      RC_ASSERT((a.opposite != b.opposite) == (sign[v] != sign[w]));
      sum += weight[w];
    }
    RC_ASSERT(sets.weight(sets.find(v).set) == sum);
  }
}

RC_GTEST_PROP(Buckets, AreAStableSort, ()) {
  const std::uint32_t n = below(60), keys = 1 + below(12);
  Numbers key(n), items(n);
  for (std::uint32_t& k : key) k = below(keys);
  for (std::uint32_t& i : items) i = below(std::max(n, 1u));
  const auto key_of = [&](std::uint32_t i) { return key[i]; };
  const Buckets listed(items, keys, key_of), counted(n, keys, key_of);
  for (std::uint32_t k = 0; k < keys; ++k) {
    Numbers of_items, of_all;
    std::copy_if(items.begin(), items.end(), std::back_inserter(of_items),
                 [&](std::uint32_t i) { return key[i] == k; });
    for (std::uint32_t i = 0; i < n; ++i)
      if (key[i] == k) of_all.push_back(i);
    RC_ASSERT(std::equal(of_items.begin(), of_items.end(), listed[k].begin(), listed[k].end()));
    RC_ASSERT(std::equal(of_all.begin(), of_all.end(), counted[k].begin(), counted[k].end()));
  }
}

RC_GTEST_PROP(LeastRotation, IsTheFirstOfTheLeast, ()) {
  Numbers cycle(below(12));
  for (std::uint32_t& v : cycle) v = below(3);
  const std::uint32_t n = static_cast<std::uint32_t>(cycle.size());
  const auto rotated = [&](std::uint32_t by) {
    Numbers result = cycle;
    std::rotate(result.begin(), result.begin() + by, result.end());
    return result;
  };
  std::uint32_t best = 0;
  for (std::uint32_t by = 1; by < n; ++by)
    if (rotated(by) < rotated(best)) best = by;
  RC_ASSERT(best == least_rotation(n, [&](std::uint32_t x, std::uint32_t y) {
              return static_cast<int>(cycle[x]) - static_cast<int>(cycle[y]);
            }));
}

RC_GTEST_PROP(Faces, FindTheirCorners, ()) {
  Numbers sizes(below(8)), corners;
  for (std::uint32_t& size : sizes) size = below(6);
  corners.resize(std::accumulate(sizes.begin(), sizes.end(), 0u));
  const Faces faces(corners, sizes);
  if (sizes.empty()) return;
  RC_ASSERT(faces.count() == sizes.size());
  std::uint32_t h = 0;
  for (std::uint32_t f = 0; f < faces.count(); ++f) {
    RC_ASSERT(faces.begin(f) == h);
    RC_ASSERT(faces.size(f) == sizes[f]);
    for (std::uint32_t j = 0; j < sizes[f]; ++j, ++h) {
      RC_ASSERT(faces.face(h) == f);
      RC_ASSERT(faces.next(h) == faces.begin(f) + (j + 1) % sizes[f]);
      RC_ASSERT(faces.prev(faces.next(h)) == h);
    }
  }
}

}  // namespace
}  // namespace clers::internal
