// Which values are known when one is coded, and near it: what named values are predicted from. It
// knows the surface, and no integers.
#ifndef CLERS_CODEC_ATTRIBUTES_KNOWN_VALUES_H
#define CLERS_CODEC_ATTRIBUTES_KNOWN_VALUES_H

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "codec/attributes/last_at_vertex.h"
#include "codec/attributes/parallelograms.h"
#include "codec/attributes/value_surface.h"
#include "codec/base/portable.h"
#include "codec/connectivity/coded_surface.h"
#include "codec/mesh.h"
#include "topology/ids.h"

namespace clers::internal {

/// What is known near a value.
struct Nearby {
  static constexpr std::uint32_t none = 0xffffffffu;
  static constexpr std::size_t most = 12;

  std::array<std::uint32_t, most> around =
      {};  ///< neighbours, first those of the gate: the first few
  std::size_t count = 0;
  std::uint32_t a = none, b = none, c = none;  ///< of the gate's parallelogram, a + b - c, or none
  std::uint32_t before = none;                 ///< the value coded before
  std::uint32_t same = none;                   ///< that coded last at the same vertex

  void add(std::uint32_t u) {
    for (std::size_t i = 0; i < count; ++i)
      if (around[i] == u) return;
    if (count < most) around[count++] = u;
  }
};

/// Calls visit(v, nearby) for each of `values` values, or `most` of them: of vertices in the order
/// of introduction, then of those in no triangle. Where there is no surface that is the order of
/// their numbers, and of others only the one before is known. Without twins only the triangle that
/// introduces a vertex is looked at. It ends with the first visit that returns false, and says so.
/// Cost: linear.
template <class Visit>
bool for_each_with_nearby(const ValueSurface& along, std::size_t values, std::size_t most,
                          Visit visit) {
  const CodedSurface& surface = along.surface;
  std::vector<bool> known(values);
  LastAtVertex last(along.vertex_of);
  std::uint32_t before = Nearby::none;
  std::size_t left = std::min(most, values);
  const auto at = [&](HalfEdge h) { return surface.corners[h.index()]; };
  const auto twin = [&](HalfEdge h) { return surface.twins[h.index()]; };
  Nearby nearby;
  const auto go_to = [&](std::uint32_t v) {
    nearby.before = before;
    nearby.same = last(v);
    known[v] = true;
    last.coded(v);
    before = v;
    --left;
    return visit(v, static_cast<const Nearby&>(nearby));
  };
  const auto look_around = [&](HalfEdge first) {
    const auto add = [&](HalfEdge h) {
      const std::uint32_t u = at(h);
      if (u != at(first) && known[u]) nearby.add(u);
    };
    add(lnext(first));
    add(lprev(first));
    if (surface.twins.empty()) return;
    const HalfEdge across = twin(lnext(first));
    if (across && nearby.count == 2 && known[at(lprev(across))]) {
      nearby.a = nearby.around[0];
      nearby.b = nearby.around[1];
      nearby.c = at(lprev(across));
    }
    HalfEdge h = twin(lprev(first));
    for (; h && h != first; h = twin(lprev(h))) add(lprev(h));
    if (h) return;
    for (h = twin(first); h; h = twin(lnext(h))) add(lprev(h));
  };
  const auto triangles = static_cast<std::uint32_t>(surface.corners.size() / 3);
  for (std::uint32_t t = 0; t < triangles && left > 0; ++t)
    for (unsigned corner = 0; corner < 3 && left > 0; ++corner) {
      const HalfEdge first = half_edge(Face(t), corner);
      const std::uint32_t v = at(first);
      if (surface.introduced_by[v] != t || known[v]) continue;
      nearby.count = 0;
      nearby.a = nearby.b = nearby.c = Nearby::none;
      look_around(first);
      if (!go_to(v)) return false;
    }
  for (std::size_t v = 0; v < values && left > 0; ++v) {
    if (known[v]) continue;
    nearby.count = 0;
    nearby.a = nearby.b = nearby.c = Nearby::none;
    if (!go_to(static_cast<std::uint32_t>(v))) return false;
  }
  return true;
}

/// The same, where no more is looked at than the triangle that introduces a value and those across
/// its sides: what is known of a, b, across a-b, across b-v and across v-a, in this order.
template <class Visit>
bool for_each_with_gate(const ValueSurface& along, std::size_t values, Visit visit) {
  const CodedSurface& surface = along.surface;
  const std::uint32_t* const corners = surface.corners.data();
  const HalfEdge* const twins = surface.twins.empty() ? nullptr : surface.twins.data();
  std::vector<std::uint8_t> known(values);
  LastAtVertex last(along.vertex_of);
  std::uint32_t before = Nearby::none;
  bool valid = true;
  Nearby nearby;
  const auto go_to = [&](std::uint32_t v) CLERS_INLINE_LAMBDA {
    nearby.before = before;
    nearby.same = last(v);
    known[v] = 1;
    last.coded(v);
    before = v;
    valid = visit(v, static_cast<const Nearby&>(nearby));
  };
  for_each_introduced(surface, [&](std::uint32_t t, unsigned i) CLERS_INLINE_LAMBDA {
    const std::uint32_t h = 3 * t + i, next = next_in(h), previous = previous_in(h);
    const std::uint32_t v = corners[h];
    if (!valid) return;
    nearby.count = 0;
    const auto add = [&](std::uint32_t u) CLERS_INLINE_LAMBDA {
      nearby.around[nearby.count] = u;
      nearby.count += known[u];
    };
    add(corners[next]);
    add(corners[previous]);
    if (twins != nullptr) {
      if (const HalfEdge out = twins[next]) add(corners[previous_in(out.index())]);
      if (const HalfEdge out = twins[previous]) add(corners[previous_in(out.index())]);
      if (const HalfEdge out = twins[h]) add(corners[previous_in(out.index())]);
    }
    go_to(v);
  });
  nearby.count = 0;
  for (std::size_t v = 0; v < values && valid; ++v)
    if (!known[v]) go_to(static_cast<std::uint32_t>(v));
  return valid;
}

/// The same for values of corners, in their order. surface.corners are the vertices that they are
/// at; where twins are there too, they are those of triangles, and values are as many as corners.
/// Nearby are values at the same vertex: across the side from the corner to the next, across the
/// one that ends there, the last two; if there is none, those of the triangle so far. The gate's
/// parallelogram ends at the last corner of a triangle, across a seam or not. Cost: linear.
template <class Visit>
bool for_each_corner_with_nearby(const CodedSurface& surface, std::size_t most, Visit visit) {
  const std::span<const std::uint32_t> corners = surface.corners;
  std::uint32_t vertices = 0;
  for (const std::uint32_t v : corners) vertices = std::max(vertices, v + 1);
  std::vector<std::array<std::uint32_t, 2>> last(vertices, {Nearby::none, Nearby::none});
  Nearby nearby;
  const std::size_t end = std::min(most, corners.size());
  for (std::size_t h = 0; h < end; ++h) {
    const auto i = static_cast<std::uint32_t>(h);
    auto& at_vertex = last[corners[h]];
    nearby.count = 0;
    nearby.a = nearby.b = nearby.c = Nearby::none;
    if (!surface.twins.empty()) {
      const HalfEdge after = surface.twins[h], before = surface.twins[lprev(HalfEdge(i)).index()];
      if (after && lnext(after).index() < i) nearby.add(lnext(after).index());
      if (before && before.index() < i) nearby.add(before.index());
    }
    for (const std::uint32_t u : at_vertex)
      if (u != Nearby::none) nearby.add(u);
    if (!surface.twins.empty()) {
      for (std::uint32_t u = i - i % 3; nearby.count < 2 && at_vertex[0] == Nearby::none && u < i;
           ++u)
        nearby.add(u);
      const HalfEdge across = surface.twins[h - h % 3];
      if (h % 3 == 2 && across && lprev(across).index() < i) {
        nearby.a = i - 2;
        nearby.b = i - 1;
        nearby.c = lprev(across).index();
      }
    }
    nearby.before = h > 0 ? i - 1 : Nearby::none;
    at_vertex = {i, at_vertex[0]};
    if (!visit(i, static_cast<const Nearby&>(nearby))) return false;
  }
  return true;
}

/// What lies where: values of vertices along their surface, of corners at its vertices if they are
/// as many as its corners are, and others by number.
template <class Visit>
bool for_each_nearby(Domain domain, const ValueSurface& along, std::size_t values, std::size_t most,
                     Visit visit) {
  if (domain == Domain::corner && along.surface.corners.size() == values)
    return for_each_corner_with_nearby(along.surface, most, visit);
  return for_each_with_nearby(domain == Domain::vertex ? along : ValueSurface(), values, most,
                              visit);
}

/// What for_each_nearby allocates. Precondition: vertices of corners are below so many.
inline std::uint64_t known_values_memory(std::uint64_t values, std::uint64_t vertices) {
  return values + 8 * vertices;
}

}  // namespace clers::internal

#endif
