#include "codec/pieces/assembly.h"

#include <cstring>
#include <string>

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

Expected<Done> put_piece(const PiecePlace& place, const Mesh& piece, Mesh& whole) {
  const auto corners = std::span(whole.corners)
                           .subspan(static_cast<std::size_t>(place.first_corner),
                                    static_cast<std::size_t>(place.corners));
  std::copy(piece.corners.begin(), piece.corners.end(), corners.begin());
  auto numbers = number_piece(place, corners);
  if (!numbers) return Failure{numbers.error()};
  if (!whole.face_sizes.empty()) {
    std::uint32_t* size = whole.face_sizes.data() + place.first_face;
    if (piece.triangles_only())
      std::fill_n(size, piece.face_count(), 3u);
    else
      std::copy(piece.face_sizes.begin(), piece.face_sizes.end(), size);
  }
  for (std::size_t k = 0; k < piece.attributes.size(); ++k) {
    const Attribute& from = piece.attributes[k];
    std::byte* to = whole.attributes[k].data.data();
    const std::size_t stride = from.stride();
    if (from.domain != Domain::vertex) {
      const std::uint64_t first =
          from.domain == Domain::face ? place.first_face : place.first_corner;
      std::copy(from.data.begin(), from.data.end(), to + first * stride);
      continue;
    }
    to += place.first_vertex * stride;
    for (std::size_t v = 0; v < piece.vertex_count; ++v) {
      if (v < numbers->size() && (*numbers)[v] < place.first_vertex) continue;
      std::memcpy(to, from.data.data() + v * stride, stride);
      to += stride;
    }
  }
  return Done{};
}

}  // namespace clers::internal
