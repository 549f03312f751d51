// Each piece writes where no other one does.
#include "codec/pieces/assembly.h"

#include <cstring>
#include <string>
#include <tuple>

namespace clers::internal {

std::uint64_t numbering_memory(const PiecePlace& place) {
  constexpr std::uint64_t each = sizeof(std::uint32_t);
  return place.seam.shared * (sizeof(SharedVertex) + each) + each * place.most_used_vertices();
}

Expected<std::vector<SharedVertex>> decode_seam(const PiecePlace& place) {
  return decode_seam(place.seam, place.most_used_vertices(), place.first_vertex);
}

Expected<std::vector<std::uint32_t>> number_piece(const PiecePlace& place,
                                                  std::span<std::uint32_t> corners) {
  auto seam = decode_seam(place);
  if (!seam) return Failure{seam.error()};
  std::vector<std::uint32_t> numbers(static_cast<std::size_t>(place.most_used_vertices()));
  std::uint32_t next = static_cast<std::uint32_t>(place.first_vertex);
  auto shared = seam->begin();
  for (std::uint32_t v = 0; v < numbers.size(); ++v)
    numbers[v] = shared != seam->end() && shared->vertex == v ? shared++->number : next++;
  for (std::uint32_t& v : corners) {
    if (v >= numbers.size())
      return fail(ErrorCode::invalid, Place::byte, place.at,
                  "vertex " + std::to_string(v) + " of a piece of " +
                      std::to_string(place.corners) + " corners");
    v = numbers[v];
  }
  return numbers;
}

namespace {

/// Puts a piece into arrays; `values_of(k)` is one of `count` attributes of the piece, memory for
/// its values, and bytes from one to the next.
template <class ValuesOf>
Expected<Done> put_piece(const PiecePlace& place, const Mesh& piece,
                         std::span<std::uint32_t> corners, std::span<std::uint32_t> sizes,
                         std::size_t count, ValuesOf values_of) {
  std::vector<std::uint32_t> own;
  if (corners.empty()) {
    own = piece.corners;
  } else {
    corners = corners.subspan(static_cast<std::size_t>(place.first_corner),
                              static_cast<std::size_t>(place.corners));
    std::copy(piece.corners.begin(), piece.corners.end(), corners.begin());
  }
  auto numbers = number_piece(place, own.empty() ? corners : std::span(own));
  if (!numbers) return Failure{numbers.error()};
  if (!sizes.empty()) put_sizes(piece, sizes.subspan(static_cast<std::size_t>(place.first_face)));
  for (std::size_t k = 0; k < count; ++k) {
    const auto [attribute, to, step] = values_of(k);
    const Attribute& from = piece.attributes[attribute];
    const std::size_t size = from.stride();
    if (from.domain == Domain::vertex) {
      std::size_t next = static_cast<std::size_t>(place.first_vertex);
      for (std::size_t v = 0; v < piece.vertex_count; ++v) {
        if (v < numbers->size() && (*numbers)[v] < place.first_vertex) continue;
        std::memcpy(to + next++ * step, from.data.data() + v * size, size);
      }
    } else {
      put_values(
          from,
          to + step * static_cast<std::size_t>(from.domain == Domain::face ? place.first_face
                                                                           : place.first_corner),
          step);
    }
  }
  return Done{};
}

}  // namespace

void put_sizes(const Mesh& from, std::span<std::uint32_t> to) {
  if (from.triangles_only())
    std::fill_n(to.begin(), from.face_count(), 3u);
  else
    std::copy(from.face_sizes.begin(), from.face_sizes.end(), to.begin());
}

void put_values(const Attribute& from, std::byte* to, std::size_t step) {
  const std::size_t size = from.stride();
  if (!from.indices.empty()) {
    for (const std::uint32_t i : from.indices) {
      if (i != no_value) std::memcpy(to, from.data.data() + i * size, size);
      to += step;
    }
    return;
  }
  if (step == size) {
    std::copy(from.data.begin(), from.data.end(), to);
    return;
  }
  for (std::size_t at = 0; at < from.data.size(); at += size, to += step)
    std::memcpy(to, from.data.data() + at, size);
}

Expected<Done> put_piece(const PiecePlace& place, const Mesh& piece, Mesh& whole) {
  return put_piece(place, piece, whole.corners, whole.face_sizes, piece.attributes.size(),
                   [&](std::size_t k) {
                     Attribute& a = whole.attributes[k];
                     return std::tuple(k, a.data.data(), a.stride());
                   });
}

Expected<Done> put_piece(const PiecePlace& place, const Mesh& piece, const MeshTarget& whole,
                         std::span<const std::size_t> attribute_of) {
  return put_piece(place, piece, whole.corners, whole.face_sizes, attribute_of.size(),
                   [&](std::size_t k) {
                     const AttributeTarget& a = whole.attributes[k];
                     return std::tuple(attribute_of[k], a.data.data(), a.step());
                   });
}

}  // namespace clers::internal
