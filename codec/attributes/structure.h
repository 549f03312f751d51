// Which element of a mesh has which value of an attribute: those that are missing, seams, wedges
// and values that are shared, one after the other in a stream that both directions go through. And
// the surface that the values are coded along then.
#ifndef CLERS_CODEC_ATTRIBUTES_STRUCTURE_H
#define CLERS_CODEC_ATTRIBUTES_STRUCTURE_H

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "codec/attributes/coded_faces.h"
#include "codec/attributes/missing.h"
#include "codec/attributes/seams.h"
#include "codec/attributes/sharing.h"
#include "codec/attributes/sharing_guess.h"
#include "codec/attributes/structure_format.h"
#include "codec/attributes/value_surface.h"
#include "codec/attributes/wedges.h"
#include "codec/mesh.h"

namespace clers::internal {

/// Which value each element has, and what attributes after this one may use.
struct ValueStructure {
  std::vector<std::uint32_t> value_of;  ///< of each element: a coded value, or no_value
  Seams seams;                          ///< of half-edges; empty: corners have no structure
};

/// The arrays of a ValueSurface.
struct ValueArrays {
  CodedArrays surface;
  std::vector<std::uint32_t> vertex_of;
  std::vector<std::uint32_t> vertex_at;  ///< of each corner, where a value is at several vertices

  ValueSurface view(const Attribute* position) const {
    return {surface.view(), vertex_of, position, vertex_at};
  }
};

/// The surface of the values of corners that all have one, in order of first use along it; false if
/// they are others.
inline bool make_whole_value_surface(const CodedFaces& faces, const ValueStructure& structure,
                                     ValueArrays& out) {
  const CodedSurface& whole = faces.surface;
  const std::size_t half_edges = whole.corners.size(), values = out.vertex_of.size();
  out.surface.corners.resize(half_edges);
  out.surface.twins.resize(whole.twins.size());
  std::uint32_t used = 0;
  bool elsewhere = false;
  for (std::size_t h = 0; h < half_edges; ++h) {
    const std::uint32_t c = faces.corner(h), value = structure.value_of[c];
    if (value >= used) {
      if (value != used || used == values) return false;
      out.vertex_of[used] = faces.corners[c];
      out.surface.introduced_by[used++] = static_cast<std::uint32_t>(h / 3);
    }
    out.surface.corners[h] = value;
    elsewhere |= out.vertex_of[value] != whole.corners[h];
  }
  const bool seams = !structure.seams.empty();
  for (std::size_t h = 0; h < whole.twins.size(); ++h)
    out.surface.twins[h] = seams && structure.seams[h] ? HalfEdge() : whole.twins[h];
  if (used < values)
    for (std::size_t c = structure.value_of.size(); c-- > 0;)
      if (const std::uint32_t value = structure.value_of[c]; value >= used && value < values)
        out.vertex_of[value] = faces.corners[c];
  if (elsewhere) out.vertex_at.assign(whole.corners.begin(), whole.corners.end());
  return true;
}

/// The surface of the values that elements of vertices or corners have; of faces, none. Cost:
/// linear; memory: value_surface_memory.
inline ValueArrays make_value_surface(const CodedFaces& faces, Domain domain,
                                      const ValueStructure& structure, std::size_t values) {
  ValueArrays out;
  if (domain == Domain::face) return out;
  out.surface.introduced_by.resize(values, CodedSurface::nothing);
  out.vertex_of.resize(values);
  if (domain == Domain::corner && make_whole_value_surface(faces, structure, out)) return out;
  out.surface.corners.clear();
  out.surface.twins.clear();
  const CodedSurface& whole = faces.surface;
  const auto value = [&](std::size_t h) {
    return structure
        .value_of[domain == Domain::corner ? faces.corner(h) : std::size_t(whole.corners[h])];
  };
  out.surface.corners.reserve(whole.corners.size());
  out.surface.twins.reserve(whole.twins.size());
  // Where triangles are left out, those after them get other numbers.
  std::vector<std::uint32_t> number;
  const auto is_left_out = [&](std::size_t t) {
    return value(3 * t) == no_value || value(3 * t + 1) == no_value || value(3 * t + 2) == no_value;
  };
  for (std::size_t t = 0; t < whole.corners.size() / 3; ++t) {
    const auto now = static_cast<std::uint32_t>(out.surface.corners.size() / 3);
    const bool left_out = is_left_out(t);
    if (left_out && number.empty()) {
      number.reserve(whole.corners.size() / 3);
      for (std::uint32_t s = 0; s < t; ++s) number.push_back(s);
    }
    if (left_out || !number.empty()) number.push_back(left_out ? no_value : now);
    if (!left_out)
      for (std::size_t i = 0; i < 3; ++i) out.surface.corners.push_back(value(3 * t + i));
  }
  for (std::size_t h = 0; h < whole.twins.size(); ++h) {
    if (!number.empty() && number[h / 3] == no_value) continue;
    HalfEdge twin = whole.twins[h];
    if (twin && !structure.seams.empty() && structure.seams[h]) twin = HalfEdge();
    if (twin && !number.empty()) {
      const std::uint32_t t = number[left(twin).index()];
      twin = t == no_value ? HalfEdge() : half_edge(Face(t), corner(twin));
    }
    out.surface.twins.push_back(twin);
  }
  find_introducing(out.surface.corners, out.surface.introduced_by);
  for (std::size_t e = structure.value_of.size(); e-- > 0;)
    if (structure.value_of[e] != no_value)
      out.vertex_of[structure.value_of[e]] = domain == Domain::corner ? faces.corners[e]
                                             : faces.place_of.empty()
                                                 ? static_cast<std::uint32_t>(e)
                                                 : faces.place_of[e];
  bool elsewhere = false;
  for (std::size_t h = 0; h < whole.corners.size(); ++h)
    elsewhere |= value(h) != no_value && out.vertex_of[value(h)] != whole.corners[h];
  if (!elsewhere) return out;
  out.vertex_at.reserve(out.surface.corners.size());
  for (std::size_t h = 0; h < whole.corners.size(); ++h)
    if (!is_left_out(h / 3)) out.vertex_at.push_back(whole.corners[h]);
  return out;
}
inline std::uint64_t value_surface_memory(std::uint64_t half_edges, bool twins,
                                          std::uint64_t values) {
  return half_edges * (8 + (twins ? sizeof(HalfEdge) : 0)) + half_edges / 3 * 4 + 8 * values;
}

/// What code_structure asks who decodes, who knows nothing.
struct UnknownElements {
  bool same(std::uint32_t, std::uint32_t) const { return false; }
  std::vector<std::uint32_t> share(std::uint32_t count, std::vector<std::uint32_t>) const {
    return std::vector<std::uint32_t>(count);
  }
};

/// Codes the structure that a header announces. value_of has an entry an element: an encoder gives
/// those that are missing as no_value, and both get which value each has.
///
/// `elements` are what who encodes knows: same(e, f) tells whether two elements have one value;
/// share(count, list) takes elements that have the values so far, one each, and returns the numbers
/// of these as SharingCoder has them, if they are listed. False: there are not as many values as
/// announced; an encoder announces as many as there are numbers.
template <class Coder, class Elements>
bool code_structure(Coder& coder, const StructureHeader& header, const CodedFaces& faces,
                    Domain domain, const Seams* beside, Elements& elements,
                    ValueStructure& structure) {
  std::vector<std::uint32_t>& value_of = structure.value_of;
  if (header.missing)
    MissingCoder().code(coder, faces, domain, value_of);
  else
    for (std::uint32_t& value : value_of) value = unassigned;
  const std::uint64_t used = header.values - header.unused;
  const bool listed = header.sharing == Sharing::listed;
  const auto same = [&](std::uint32_t e, std::uint32_t f) { return elements.same(e, f); };
  std::uint32_t count = 0;
  std::vector<std::uint32_t> list;
  if (domain == Domain::corner) {
    if (!faces.surface.twins.empty())
      structure.seams =
          SeamCoder(faces, header.missing ? std::span(value_of) : std::span<std::uint32_t>(),
                    beside)
              .code(coder, same);
    WedgeCoder wedges(faces, structure.seams, value_of, listed ? value_of.size() : used);
    if (!wedges.code(coder, same)) return false;
    count = wedges.count();
    list = wedges.take_corners();
  } else {
    for (std::uint32_t e = 0; e < value_of.size(); ++e) {
      if (value_of[e] == no_value) continue;
      value_of[e] = count++;
      if constexpr (Coder::encodes) list.push_back(e);
    }
  }
  if (!listed && !Coder::encodes) return count == used;
  std::vector<std::uint32_t> numbers = elements.share(count, std::move(list));
  if (!listed) return true;
  SharingCoder sharing;
  const CodedFaces none;
  SharingGuess guess(domain == Domain::corner ? faces : none, value_of, numbers);
  if (!sharing.code(coder, numbers, used, guess)) return false;
  for (std::uint32_t& value : value_of)
    if (value != no_value) value = numbers[value];
  return Coder::encodes || sharing.count() == used;
}

/// Bytes that this takes besides what structure.value_of holds; its seams included.
inline std::uint64_t structure_memory(const StructureHeader& header, Domain domain,
                                      std::uint64_t elements, std::uint64_t vertices,
                                      std::uint64_t half_edges) {
  const bool listed = header.sharing == Sharing::listed;
  const std::uint64_t count = listed ? elements : std::min(header.values, elements);
  std::uint64_t most = header.missing && domain == Domain::corner ? vertices : 0;
  if (domain == Domain::corner)
    most = std::max({most, SeamCoder::memory(vertices, half_edges),
                     seams_memory(half_edges) + WedgeCoder::memory(vertices, elements, count)});
  if (listed)
    most = std::max(most, seams_memory(half_edges) + 4 * count +
                              SharingCoder::memory(count, header.values) +
                              (domain == Domain::corner ? SharingGuess::memory(half_edges) : 0));
  return most;
}

}  // namespace clers::internal

#endif
