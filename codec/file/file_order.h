// The order that vertices, faces and first corners had in the input, where it is kept: a stream,
// and the section of it. Knows the faces of a decoded mesh. codec/format.md, Order.
//
// Faces of a file mostly follow their neighbours, so the order is coded as a walk over the decoded
// mesh: across which side of a face before the next one is, and with which corner it begins. Its
// new vertices mostly have the next number, or one that continues a grid.
#ifndef CLERS_CODEC_FILE_FILE_ORDER_H
#define CLERS_CODEC_FILE_FILE_ORDER_H

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "codec/base/faces.h"
#include "codec/base/no_index.h"
#include "codec/entropy/stream.h"
#include "codec/file/permutation.h"
#include "codec/order.h"
#include "codec/soup/edges.h"

namespace clers::internal {

/// Where everything of a decoded mesh belongs in the input.
struct FileOrder {
  std::vector<std::uint32_t> faces;          ///< faces[old] = new
  std::vector<std::uint32_t> first_corners;  ///< of each old face: the corner in the new one that
                                             ///< comes first
  std::vector<std::uint32_t> vertices;       ///< vertices[new] = old
};

class FileOrderCoder {
 public:
  /// `faces` are those of the decoded mesh. Cost: linear.
  FileOrderCoder(Faces faces, std::uint32_t vertex_count)
      : faces_(std::move(faces)),
        vertex_count_(vertex_count),
        around_(faces_.org.size()),
        done_(faces_.count()),
        number_taken_(vertex_count) {
    for_each_edge(faces_, vertex_count, [&](std::span<const std::uint32_t> sides) {
      for (std::size_t i = 0; i < sides.size(); ++i)
        around_[sides[i]] = sides[(i + 1) % sides.size()];
    });
  }

  /// Bytes that coding takes at most, the faces and the order not counted.
  static std::uint64_t memory(std::uint64_t corners, std::uint64_t faces, std::uint64_t vertices) {
    constexpr std::uint64_t each = sizeof(std::uint32_t);
    return each * corners + (faces + vertices) / 8 + 16 +
           std::max(edges_memory(corners, vertices), each * vertices);
  }

  /// A coder that decodes fills in the order. False: what was decoded is no order.
  template <class Coder>
  bool code(Coder& coder, FileOrder& order) {
    constexpr bool decoding = !Coder::encodes;
    const std::uint32_t count = faces_.count();
    if constexpr (decoding) {
      order.faces.assign(count, no_index);
      order.first_corners.assign(count, 0);
      order.vertices.assign(vertex_count_, no_index);
    }
    known_.assign(vertex_count_, no_index);
    for (std::uint32_t j = 0; j < count; ++j) {
      const Step step = code_face(coder, order, j);
      if (step.face >= count || done_[step.face]) return false;
      const std::uint32_t size = faces_.size(step.face), begin = faces_.begin(step.face);
      order.faces[j] = step.face;
      done_[step.face] = true;
      if (size == 0) continue;
      const std::uint32_t entry = step.entry == no_index ? 0 : step.entry - begin;
      const std::uint32_t turn =
          first_[step.slot].code(coder, (order.first_corners[j] + size - entry % size) % size);
      if (turn >= size) return false;
      order.first_corners[j] = (turn + entry) % size;
      for (std::uint32_t i = 0; i < size; ++i) {
        const std::uint32_t v = faces_.org[begin + (order.first_corners[j] + i) % size];
        if (known_[v] != no_index) continue;
        const std::uint32_t number = code_vertex(coder, step.entry, order.vertices[v]);
        if (number >= vertex_count_ || number_taken_[number]) return false;
        known_[v] = order.vertices[v] = number;
        number_taken_[number] = true;
        last_ = number;
        highest_ = std::max(highest_, number + 1);
      }
    }
    if constexpr (decoding) {
      // Vertices that no face has kept their order.
      std::uint32_t number = 0;
      for (std::uint32_t& v : order.vertices) {
        if (v != no_index) continue;
        while (number_taken_[number]) ++number;
        v = number++;
      }
    }
    return true;
  }

 private:
  static constexpr unsigned sides_looked_at = 4, slots = 3 * sides_looked_at + 2;

  struct Step {
    std::uint32_t face = no_index;
    std::uint32_t entry = no_index;  ///< its side that another face led across
    unsigned slot = slots;           ///< which guess was right; slots: none
  };

  template <class Coder>
  Step code_face(Coder& coder, const FileOrder& order, std::uint32_t j) {
    tried_ = 0;
    Step found;
    const auto is_it = [&](std::uint32_t face, std::uint32_t entry, unsigned slot) {
      const auto end = tried_faces_.begin() + tried_;
      if (std::find(tried_faces_.begin(), end, face) != end) return false;
      tried_faces_[tried_++] = face;
      BitModel& model = guess_[before_[0]][before_[1]][slot];
      if (!coder.bit(model, order.faces[j] == face)) return false;
      found = {face, entry, slot};
      return true;
    };
    if (j > 0 && !guess(is_it, order, j)) {
      while (done_[first_left_]) ++first_left_;
      found.face = first_left_ + far_face_.code(coder, order.faces[j] - first_left_);
    } else if (j == 0) {
      found.face = far_face_.code(coder, order.faces[j]);
    }
    before_[1] = before_[0];
    before_[0] = found.slot;
    return found;
  }

  /// Faces that may come next, the likely ones first.
  template <class IsIt>
  bool guess(IsIt is_it, const FileOrder& order, std::uint32_t j) {
    const std::uint32_t last = order.faces[j - 1];
    if (across(is_it, order, j - 1, 0)) return true;
    if (last + 1 < faces_.count() && !done_[last + 1] && is_it(last + 1, no_index, slots - 2))
      return true;
    if (last > 0 && !done_[last - 1] && is_it(last - 1, no_index, slots - 1)) return true;
    if (j > 1 && across(is_it, order, j - 2, sides_looked_at)) return true;
    // The earliest face that has a neighbour left: where the next row begins.
    while (oldest_ < j && !has_neighbour_left(order.faces[oldest_])) ++oldest_;
    return oldest_ < j && across(is_it, order, oldest_, 2 * sides_looked_at);
  }

  /// Neighbours of old face i, across its sides in their old order.
  template <class IsIt>
  bool across(IsIt is_it, const FileOrder& order, std::uint32_t i, unsigned slot) {
    const std::uint32_t f = order.faces[i], size = faces_.size(f);
    for (std::uint32_t s = 0; s < std::min(size, sides_looked_at); ++s) {
      const std::uint32_t g = neighbour(faces_.begin(f) + (order.first_corners[i] + s) % size);
      if (g != no_index && is_it(faces_.face(g), g, slot + s)) return true;
    }
    return false;
  }

  /// The next side of the same edge whose face is left, among a few.
  std::uint32_t neighbour(std::uint32_t h) const {
    std::uint32_t g = around_[h];
    for (unsigned i = 0; i < 4 && g != h; ++i, g = around_[g])
      if (!done_[faces_.face(g)]) return g;
    return no_index;
  }
  bool has_neighbour_left(std::uint32_t f) const {
    const std::uint32_t begin = faces_.begin(f), size = std::min(faces_.size(f), sides_looked_at);
    for (std::uint32_t h = begin; h < begin + size; ++h)
      if (neighbour(h) != no_index) return true;
    return false;
  }

  template <class Coder>
  std::uint32_t code_vertex(Coder& coder, std::uint32_t entry, std::uint32_t value) {
    const std::uint32_t guesses[] = {highest_, last_ + 1, parallelogram(entry)};
    for (unsigned i = 0; i < 3; ++i) {
      if (guesses[i] >= vertex_count_ || number_taken_[guesses[i]] ||
          std::find(guesses, guesses + i, guesses[i]) != guesses + i)
        continue;
      if (coder.bit(number_[vertex_before_][i], value == guesses[i])) {
        vertex_before_ = i;
        return guesses[i];
      }
    }
    vertex_before_ = 3;
    return code_from(coder, far_vertex_, last_, value);
  }

  /// a + b - c by old numbers: c is the corner behind the side that leads here, in a face before.
  std::uint32_t parallelogram(std::uint32_t entry) const {
    if (entry == no_index) return no_index;
    std::uint32_t g = around_[entry];
    for (unsigned i = 0; i < 4 && !done_before(g, entry); ++i) g = around_[g];
    if (!done_before(g, entry)) return no_index;
    const std::uint32_t a = known_[faces_.org[g]], b = known_[faces_.org[faces_.next(g)]],
                        c = known_[faces_.org[faces_.prev(g)]];
    return a == no_index || b == no_index || c == no_index ? no_index : a + b - c;
  }
  bool done_before(std::uint32_t g, std::uint32_t entry) const {
    return done_[faces_.face(g)] && faces_.face(g) != faces_.face(entry);
  }

  Faces faces_;
  std::uint32_t vertex_count_;
  std::vector<std::uint32_t> around_;  ///< the next side of the same edge, in a ring
  std::vector<bool> done_;             ///< new faces
  std::vector<bool> number_taken_;
  std::vector<std::uint32_t> known_;  ///< old numbers of new vertices, so far
  std::uint32_t first_left_ = 0;      ///< no new face before it is left
  std::uint32_t oldest_ = 0;          ///< no old face before it has a neighbour left
  std::uint32_t last_ = no_index, highest_ = 0;
  std::array<std::uint32_t, slots> tried_faces_{};
  unsigned tried_ = 0;
  unsigned before_[2] = {slots, slots};
  unsigned vertex_before_ = 0;
  BitModel guess_[slots + 1][slots + 1][slots];
  NumberModel first_[slots + 1];
  NumberModel far_face_, far_vertex_;
  BitModel number_[4][3];
};

/// The order of the input, where `order` is that of the coded mesh. `faces`: of the input.
inline Bytes encode_order(const Cycles& faces, const Permutation& order) {
  FileOrder file;
  file.vertices = order.vertices;
  file.faces = inverse(order.faces);
  file.first_corners.resize(order.faces.size());
  for (std::uint32_t i = 0; i < order.faces.size(); ++i) {
    const std::uint32_t f = order.faces[i], first = order.first_corners[i];
    file.first_corners[f] = first == 0 ? 0 : faces.size(f) - first;
  }
  const PermutedFaces coded = permuted(faces, order);
  return encode_stream([&](EncodeTo& coder) {
    FileOrderCoder({coded.corners, coded.sizes}, static_cast<std::uint32_t>(order.vertices.size()))
        .code(coder, file);
  });
}

/// Brings a decoded mesh into the order of the input, values too. Error: invalid.
inline Expected<Done> restore_order(const Stream& stream, Mesh& mesh) {
  const Faces faces(mesh.corners, mesh.face_sizes);
  FileOrder file;
  auto ok = decode_stream(stream, "the orders", [&](DecodeFrom& coder) {
    return FileOrderCoder(faces, mesh.vertex_count).code(coder, file)
               ? std::string()
               : "the order names a face or a vertex twice, or none";
  });
  if (!ok) return ok;
  const Permutation order{inverse(std::exchange(file.vertices, {})), std::move(file.faces),
                          std::move(file.first_corners)};
  PermutedFaces restored = permuted(faces, order);
  for (Attribute& a : mesh.attributes) {
    if (a.indices.empty()) {
      a.data = permuted_elements(a.data.data(), a.stride(), a.stride(), a.domain, faces, order);
    } else {
      const auto indices = std::as_writable_bytes(std::span(a.indices));
      const auto moved = permuted_elements(indices.data(), sizeof(std::uint32_t),
                                           sizeof(std::uint32_t), a.domain, faces, order);
      std::copy(moved.begin(), moved.end(), indices.begin());
    }
  }
  mesh.corners = std::move(restored.corners);
  mesh.face_sizes = std::move(restored.sizes);
  return ok;
}

/// Bytes that restore_order takes besides the mesh; `sizes`: has it any? `values`: the most that
/// the elements of an attribute of it take.
inline std::uint64_t restoring_memory(std::uint64_t corners, std::uint64_t faces,
                                      std::uint64_t vertices, bool sizes, std::uint64_t values) {
  constexpr std::uint64_t each = sizeof(std::uint32_t);
  const std::uint64_t view = Faces::memory(corners, faces, sizes),
                      order = each * (2 * faces + vertices),
                      restored = each * (corners + (sizes ? faces : 0));
  return view + order +
         std::max(view + FileOrderCoder::memory(corners, faces, vertices),
                  restored + std::max(each * vertices, values));
}

}  // namespace clers::internal

#endif
