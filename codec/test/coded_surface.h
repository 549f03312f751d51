// What must hold of a coded surface, found without the code that makes one.
#ifndef CLERS_CODEC_TEST_CODED_SURFACE_H
#define CLERS_CODEC_TEST_CODED_SURFACE_H

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "codec/connectivity/coded_surface.h"

namespace clers::internal {

/// What is wrong with a surface without copies, twins included, that connectivity gave; empty:
/// nothing.
inline std::string fault_of(const CodedSurface& surface) {
  const std::span<const std::uint32_t> corners = surface.corners,
                                       introduced_by = surface.introduced_by;
  const std::span<const HalfEdge> twins = surface.twins;
  const auto vertices = static_cast<std::uint32_t>(introduced_by.size());
  const auto triangles = static_cast<std::uint32_t>(corners.size() / 3);
  const auto in = [](const char* what, std::uint32_t t) {
    return std::string(what) + " (triangle " + std::to_string(t) + ")";
  };
  if (twins.size() != corners.size()) return "the twins are not there";
  // The first triangle of each component, by flooding.
  std::vector<bool> begins(triangles), reached(triangles);
  std::vector<std::uint32_t> todo;
  for (std::uint32_t t = 0; t < triangles; ++t) {
    if (reached[t]) continue;
    begins[t] = reached[t] = true;
    todo.push_back(t);
    while (!todo.empty()) {
      const std::size_t h = 3 * std::size_t(todo.back());
      todo.pop_back();
      for (const HalfEdge across : twins.subspan(h, 3)) {
        if (!across || reached[left(across).index()]) continue;
        reached[left(across).index()] = true;
        todo.push_back(left(across).index());
      }
    }
  }
  std::vector<bool> seen(vertices);
  for (std::uint32_t t = 0; t < triangles; ++t) {
    for (unsigned i = 0; i < 3; ++i) {
      const std::uint32_t v = corners[3 * std::size_t(t) + i];
      if (v >= vertices) return in("a vertex beyond all", t);
      if (!seen[v] && introduced_by[v] != t) return in("introduces a vertex and is not named", t);
      if (!seen[v] && i < 2 && !begins[t]) return in("introduces a vertex at its gate", t);
      seen[v] = true;
    }
    const HalfEdge across = twins[3 * std::size_t(t)];
    if (!begins[t] && (!across || left(across).index() >= t)) return in("no triangle before", t);
  }
  for (const bool used : seen)
    if (!used) return "a vertex of no triangle";
  return {};
}

}  // namespace clers::internal

#endif
