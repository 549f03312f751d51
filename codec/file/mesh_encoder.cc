#include "codec/file/mesh_encoder.h"

#include <algorithm>
#include <cstring>
#include <numeric>
#include <optional>
#include <string>
#include <utility>

#include "codec/attributes/attribute_encoder.h"
#include "codec/base/check.h"
#include "codec/base/parallel.h"
#include "codec/base/utf8.h"
#include "codec/file/file_order.h"
#include "codec/file/mesh_features.h"
#include "codec/file/metadata.h"
#include "codec/soup/adjacency.h"
#include "codec/soup/degenerate_faces.h"
#include "codec/soup/duplicates.h"
#include "codec/soup/folded_faces.h"
#include "codec/soup/raw_faces.h"
#include "codec/soup/surface_encoder.h"

namespace clers::internal {
namespace {

std::uint32_t size_of_face(const Mesh& mesh, std::size_t f) {
  return mesh.triangles_only() ? 3 : mesh.face_sizes[f];
}

std::size_t face_of_corner(const Mesh& mesh, std::size_t h) {
  if (mesh.triangles_only()) return h / 3;
  std::size_t f = 0;
  while (h >= mesh.face_sizes[f]) h -= mesh.face_sizes[f++];
  return f;
}

/// First corner of each face; empty for triangles.
std::vector<std::uint32_t> begins_of(const Mesh& mesh) {
  std::vector<std::uint32_t> begins;
  begins.reserve(mesh.face_sizes.size());
  std::uint32_t begin = 0;
  for (const std::uint32_t size : mesh.face_sizes) {
    begins.push_back(begin);
    begin += size;
  }
  return begins;
}

/// Refuses meshes whose arrays disagree.
Expected<Done> check_arrays(const Mesh& mesh) {
  if (mesh.triangles_only()) {
    if (mesh.corners.size() % 3 != 0)
      return fail(ErrorCode::inconsistent_mesh,
                  std::to_string(mesh.corners.size()) + " corners, expected a multiple of 3");
  } else {
    std::uint64_t corners = 0;
    for (const std::uint32_t size : mesh.face_sizes) corners += size;
    if (corners != mesh.corners.size())
      return fail(ErrorCode::inconsistent_mesh,
                  "faces of " + std::to_string(corners) + " corners in all, but " +
                      std::to_string(mesh.corners.size()) + " corners are given");
  }
  if (mesh.corners.size() > max_corners || mesh.face_count() > max_corners)
    return fail(ErrorCode::too_large, std::to_string(mesh.face_count()) + " faces of " +
                                          std::to_string(mesh.corners.size()) +
                                          " corners, expected at most " +
                                          std::to_string(max_corners));
  std::uint32_t largest = 0;
  for (const std::uint32_t v : mesh.corners) largest = std::max(largest, v);
  if (!mesh.corners.empty() && largest >= mesh.vertex_count) {
    std::size_t h = 0;
    while (mesh.corners[h] < mesh.vertex_count) ++h;
    return fail(ErrorCode::inconsistent_mesh, Place::face, face_of_corner(mesh, h),
                "has vertex " + std::to_string(mesh.corners[h]) + ", expected one below " +
                    std::to_string(mesh.vertex_count));
  }
  if (!is_utf8(mesh.name))
    return fail(ErrorCode::inconsistent_mesh, "the name of the mesh is not UTF-8");
  if (std::string what = metadata_fault(mesh.metadata); !what.empty())
    return fail(ErrorCode::inconsistent_mesh, std::move(what));
  for (const Attribute& a : mesh.attributes) {
    if (!is_utf8(a.name))
      return fail(ErrorCode::inconsistent_mesh, "an attribute's name is not UTF-8");
    if (a.name.size() > 255)
      return fail(ErrorCode::inconsistent_mesh, "an attribute's name is longer than 255 bytes");
    if (const std::string defect = kind_defect(a); !defect.empty())
      return fail(ErrorCode::inconsistent_mesh, "attribute \"" + a.name + "\" has " + defect);
    if (a.data.size() != mesh.value_count(a.domain) * a.stride())
      return fail(ErrorCode::inconsistent_mesh,
                  "attribute \"" + a.name + "\" has " + std::to_string(a.data.size()) +
                      " bytes of values, expected " + std::to_string(mesh.value_count(a.domain)) +
                      " times " + std::to_string(a.stride()));
  }
  return Done{};
}

constexpr std::uint32_t none = 0xffffffffu;

class MeshEncoder {
 public:
  MeshEncoder(const Mesh& mesh, const EncodeOptions& options)
      : mesh_(mesh), options_(options), corners_(mesh.corners), sizes_(mesh.face_sizes) {
    if (std::all_of(sizes_.begin(), sizes_.end(), [](std::uint32_t n) { return n == 3; }))
      sizes_ = {};
  }

  template <class Progress>
  Expected<Done> run(unsigned threads, const Progress& progress) {
    progress("connectivity", 0.0);
    set_loose_aside();
    auto coded = encode_surface(
        corners_, sizes_, mesh_.vertex_count, options_.level,
        mesh_.attributes.empty() && loose_.empty() ? Wanted::nothing : Wanted::surface,
        [&] { return plain_bytes() < 3 * mesh_.face_count() / 2; });
    if (!coded) return Failure{coded.error()};
    Bytes payload, kept_order;
    CodedArrays surface;
    std::optional<Bytes> plain;
    const bool keep = options_.order == Order::keep;
    if (coded->given_up) {
      plain = plain_payload(mesh_.face_count());
    } else {
      number(*coded);
      surface = std::move(coded->surface);
      const Bytes loose = code_loose(surface.corners);
      payload = surface_payload(*coded, loose);
      if (keep) {
        progress("order", 0.3);
        kept_order = encode_order(mesh_, order(), in_coded_order(mesh_, order()));
      }
      if (keep || coded->copies > 0) plain = plain_if_smaller(payload.size() + kept_order.size());
    }
    describe(*coded);
    if (plain) {
      payload = std::move(*plain);
      kept_order.clear();
      surface.corners = fan_triangles(mesh_.corners, mesh_.face_sizes);
      surface.introduced_by.resize(mesh_.vertex_count);
      find_introducing(surface.corners, surface.introduced_by);
      set_identity(mesh_, order());
      info().cuts = {};
      info().clers = {};
      info().polygon_bytes = info().stitching_bytes = 0;
    }
    info().connectivity_bytes = payload.size() + kept_order.size();
    info().order_bytes = kept_order.size();
    put(SectionKind::mesh, std::move(payload));
    if (!mesh_.name.empty()) {
      const auto name = std::as_bytes(std::span(mesh_.name));
      put(SectionKind::name, Bytes(name.begin(), name.end()));
    }
    if (!kept_order.empty()) put(SectionKind::order, std::move(kept_order));
    if (auto ok = attributes(surface.view(), threads, progress); !ok) return ok;
    if (keep) set_identity(mesh_, order());
    return Done{};
  }

  /// What the options do not allow to keep.
  Expected<Done> refuse() {
    set_loose_aside();
    if (options_.on_degenerate == OnOddity::error && !loose_.empty()) {
      const std::uint32_t size = size_of_face(mesh_, loose_[0]);
      return fail(ErrorCode::degenerate_face, Place::face, loose_[0],
                  size < 3 ? "has " + std::to_string(size) + " corners, expected 3 at least"
                           : "uses a vertex twice");
    }
    if (options_.on_duplicate == OnOddity::error) {
      const auto duplicates = duplicate_faces(mesh_);
      if (!duplicates.empty())
        return fail(ErrorCode::duplicate_face, Place::face, duplicates[0].second,
                    "has the same vertices as face " + std::to_string(duplicates[0].first));
    }
    if (options_.on_nonmanifold == OnOddity::error) {
      const auto kept = [&](Error e) {
        if (e.place == Place::face && !kept_.empty()) e.at = kept_[e.at];
        return Failure{e};
      };
      const Faces faces(corners_, sizes_);
      const auto twins = find_twins(faces, mesh_.vertex_count);
      if (!twins) return kept(twins.error());
      const std::uint32_t v = vertex_of_several_fans(faces, *twins, mesh_.vertex_count);
      if (v != none)
        return fail(ErrorCode::nonmanifold_vertex, Place::vertex, v,
                    "its faces form more than one fan, expected one");
    }
    return Done{};
  }

  EncodedMesh result;

 private:
  Permutation& order() { return result.order; }
  MeshInfo& info() { return result.info; }
  void put(SectionKind kind, Bytes payload) {
    result.sections.push_back({kind, std::move(payload)});
  }

  static void put_stream(Bytes& out, const Bytes& stream) {
    put_varint(out, stream.size());
    put_bytes(out, stream);
  }

  Bytes surface_payload(const EncodedSurface& coded, const Bytes& loose) const {
    Bytes payload;
    put_u8(payload, coded.features | (folded_ > 0 ? feature::folded : 0) |
                        (loose_.size() > folded_ ? feature::degenerate : 0));
    put_varint(payload, mesh_.vertex_count - surface_vertices_);
    if (coded.features & feature::reversed) {
      put_varint(payload, coded.runs.size());
      put_stream(payload, coded.turned);
    }
    if (coded.features & feature::polygons) {
      put_varint(payload, mesh_.face_count() - loose_.size() - coded.repeated_faces);
      put_stream(payload, coded.polygons);
    }
    if (coded.features & feature::copies) {
      put_varint(payload, coded.copies);
      put_stream(payload, coded.stitches);
    }
    if (coded.features & feature::repeats) {
      put_varint(payload, coded.repeated_faces);
      put_varint(payload, coded.repeated_corners);
      put_stream(payload, coded.repeats);
    }
    put_bytes(payload, loose);
    put_bytes(payload, coded.connectivity);
    return payload;
  }

  /// The faces one by one, in the order of the input, if that takes less than so many bytes.
  std::optional<Bytes> plain_if_smaller(std::size_t bytes) const {
    // Never seen to take less than a bit a corner but for a few.
    if (8 * bytes < mesh_.corners.size() / 2) return std::nullopt;
    if (mesh_.face_count() > 16 * plain_sample && plain_bytes() > bytes) return std::nullopt;
    Bytes plain = plain_payload(mesh_.face_count());
    return plain.size() < bytes ? std::optional(std::move(plain)) : std::nullopt;
  }

  /// About how many bytes the faces one by one take, by the first of them.
  std::size_t plain_bytes() const {
    const std::size_t faces = mesh_.face_count(), sample = std::min(faces, plain_sample);
    return sample == 0 ? 0 : plain_payload(sample).size() * faces / sample;
  }
  static constexpr std::size_t plain_sample = 1024;

  /// The first faces one by one, as they stand in the input.
  Bytes plain_payload(std::size_t faces) const {
    rans::Encoder stream;
    EncodeTo coder(stream);
    RawFaceModel model(mesh_.vertex_count);
    std::vector<std::uint32_t> face;
    for (std::size_t f = 0, begin = 0; f < faces; ++f) {
      const std::uint32_t size = size_of_face(mesh_, f);
      const auto cycle = std::span(mesh_.corners).subspan(begin, size);
      face.assign(cycle.begin(), cycle.end());
      begin += size;
      model.code_size(coder, size);
      model.code_corners(coder, face);
    }
    Bytes payload;
    put_u8(payload, feature::raw);
    put_varint(payload, mesh_.vertex_count);
    put_varint(payload, mesh_.face_count());
    put_varint(payload, mesh_.corners.size());
    stream.finish(payload);
    return payload;
  }

  /// Whether each triangle has three vertices: what most meshes are, told without a table.
  static bool no_vertex_twice(std::span<const std::uint32_t> corners) {
    bool all = true;
    for (std::size_t h = 0; h < corners.size(); h += 3) {
      const std::uint32_t a = corners[h], b = corners[h + 1], c = corners[h + 2];
      all &= a != b && b != c && c != a;
    }
    return all;
  }

  /// Parts faces that a surface can have from those that it cannot: fewer than three corners, or a
  /// vertex twice.
  void set_loose_aside() {
    if (mesh_.triangles_only() && no_vertex_twice(mesh_.corners)) return;
    const std::size_t faces = mesh_.face_count();
    std::vector<std::uint32_t> last_face(mesh_.vertex_count, none);
    begins_ = begins_of(mesh_);
    std::size_t begin = 0;
    for (std::size_t f = 0; f < faces; ++f) {
      const std::uint32_t size = size_of_face(mesh_, f);
      bool is_loose = size < 3;
      for (std::size_t h = begin; h < begin + size; ++h) {
        const std::uint32_t v = mesh_.corners[h];
        is_loose |= last_face[v] == f;
        last_face[v] = static_cast<std::uint32_t>(f);
      }
      if (is_loose) loose_.push_back(static_cast<std::uint32_t>(f));
      begin += size;
    }
    if (loose_.empty()) return;
    kept_.reserve(faces - loose_.size());
    std::size_t next = 0;
    for (std::uint32_t f = 0; f < faces; ++f) {
      if (next < loose_.size() && loose_[next] == f) {
        ++next;
        continue;
      }
      kept_.push_back(f);
      const auto cycle = cycle_of(f);
      kept_corners_.insert(kept_corners_.end(), cycle.begin(), cycle.end());
      kept_sizes_.push_back(size_of_face(mesh_, f));
    }
    corners_ = kept_corners_;
    sizes_ = kept_sizes_;
    if (std::all_of(sizes_.begin(), sizes_.end(), [](std::uint32_t n) { return n == 3; }))
      sizes_ = {};
  }

  std::span<const std::uint32_t> cycle_of(std::uint32_t f) const {
    const std::size_t begin = mesh_.triangles_only() ? 3 * std::size_t(f) : begins_[f];
    return std::span<const std::uint32_t>(mesh_.corners).subspan(begin, size_of_face(mesh_, f));
  }

  void number(EncodedSurface& coded) {
    order() = std::move(coded.order);
    surface_vertices_ = static_cast<std::uint32_t>(order().vertices.size());
    if (surface_vertices_ < mesh_.vertex_count) {
      std::vector<bool> used(mesh_.vertex_count);
      for (const std::uint32_t v : order().vertices) used[v] = true;
      for (std::uint32_t v = 0; v < mesh_.vertex_count; ++v)
        if (!used[v]) order().vertices.push_back(v);
    }
    if (!kept_.empty())
      for (std::uint32_t& f : order().faces) f = kept_[f];
  }

  /// Appends the faces that are not on the surface to the order(). Returns what stands in the mesh
  /// section for them.
  Bytes code_loose(std::span<const std::uint32_t> triangles) {
    Bytes out;
    if (loose_.empty()) return out;
    std::vector<std::uint32_t> number(mesh_.vertex_count);
    for (std::uint32_t i = 0; i < order().vertices.size(); ++i) number[order().vertices[i]] = i;
    const std::vector<std::uint32_t> others = code_folded(triangles, number, out);
    if (!others.empty()) code_others(others, triangles, number, out);
    return out;
  }

  /// Appends triangles on two vertices of an edge. Returns what else is loose.
  std::vector<std::uint32_t> code_folded(std::span<const std::uint32_t> triangles,
                                         std::span<const std::uint32_t> number, Bytes& out) {
    std::vector<TwoVertexFace> candidates;
    std::vector<std::uint32_t> others;
    for (const std::uint32_t f : loose_) {
      const auto c = cycle_of(f);
      const bool two = c.size() == 3 && (c[0] != c[1] || c[1] != c[2]);
      if (!two) {
        others.push_back(f);
        continue;
      }
      const std::uint32_t a = number[c[0]], b = number[c[c[0] == c[1] ? 2 : 1]];
      if (std::max(a, b) < surface_vertices_)
        candidates.push_back({std::min(a, b), std::max(a, b), f});
      else
        others.push_back(f);
    }
    rans::Encoder stream;
    EncodeTo coder(stream);
    FoldedModel model;
    std::uint64_t count = 0;
    const auto visit = [&](std::uint32_t f, std::uint32_t h) {
      const auto c = cycle_of(f);
      const auto n = [&](std::uint32_t j) { return number[c[j % 3]]; };
      // The corner after which the face is (a, a, b) or (a, b, b).
      const std::uint32_t a = triangles[h];
      std::uint32_t first = 0;
      while (n(first) != a || n(first + 2) == a) ++first;
      model.code(coder, {h, n(first + 1) == a});
      order().faces.push_back(f);
      order().first_corners.push_back(first);
      ++count;
    };
    const auto left = find_folds(candidates, surface_vertices_, triangles, visit);
    others.insert(others.end(), left.begin(), left.end());
    std::sort(others.begin(), others.end());
    folded_ = count;
    if (count == 0) return others;
    Bytes bytes;
    stream.finish(bytes);
    put_varint(out, count);
    put_stream(out, bytes);
    loose_bytes_ += bytes.size();
    return others;
  }

  void code_others(std::span<const std::uint32_t> others, std::span<const std::uint32_t> triangles,
                   std::span<const std::uint32_t> number, Bytes& out) {
    std::vector<std::uint32_t> corners;
    struct Loose {
      std::uint32_t face, rotation;
      std::size_t begin, size;
    };
    std::vector<Loose> faces;
    for (const std::uint32_t f : others) {
      const std::size_t begin = corners.size();
      for (const std::uint32_t v : cycle_of(f)) corners.push_back(number[v]);
      const std::span<std::uint32_t> cycle = std::span(corners).subspan(begin);
      const std::uint32_t rotation = least_rotation(cycle);
      std::rotate(cycle.begin(), cycle.begin() + rotation, cycle.end());
      faces.push_back({f, rotation, begin, cycle.size()});
    }
    const auto cycle = [&](const Loose& l) { return std::span(corners).subspan(l.begin, l.size); };
    std::stable_sort(faces.begin(), faces.end(), [&](const Loose& a, const Loose& b) {
      const auto x = cycle(a), y = cycle(b);
      return std::lexicographical_compare(x.begin(), x.end(), y.begin(), y.end());
    });

    rans::Encoder stream;
    EncodeTo coder(stream);
    DegenerateFaceModel model(triangles, surface_vertices_, mesh_.vertex_count);
    for (const Loose& l : faces) {
      model.code_size(coder, static_cast<std::uint32_t>(l.size));
      model.code_corners(coder, cycle(l));
      order().faces.push_back(l.face);
      order().first_corners.push_back(l.rotation);
    }
    Bytes bytes;
    stream.finish(bytes);
    put_varint(out, faces.size());
    put_varint(out, corners.size());
    put_stream(out, bytes);
    loose_bytes_ += bytes.size();
  }

  std::uint64_t used_vertices() const {
    if (loose_.empty() && surface_vertices_ > 0) return surface_vertices_;
    std::vector<bool> used(mesh_.vertex_count);
    for (const std::uint32_t v : mesh_.corners) used[v] = true;
    return static_cast<std::uint64_t>(std::count(used.begin(), used.end(), true));
  }

  void describe(const EncodedSurface& coded) {
    info().name = mesh_.name;
    info().cuts = {coded.turned_faces, coded.copies, coded.repeated_faces, loose_.size()};
    info().clers = in_word_order(coded.counts.symbols);
    info().polygon_bytes = coded.polygons.size();
    info().stitching_bytes =
        coded.turned.size() + coded.stitches.size() + coded.repeats.size() + loose_bytes_;
    MeshShape& shape = info().shape;
    shape.vertices = mesh_.vertex_count;
    shape.faces = mesh_.face_count();
    shape.triangles = mesh_.corners.size() - 2 * mesh_.face_count();
    shape.components = coded.counts.components;
    shape.boundary_curves = coded.counts.boundary_curves;
    shape.genus = coded.counts.handles;
    shape.isolated_vertices = mesh_.vertex_count - used_vertices();
  }

  template <class Progress>
  Expected<Done> attributes(const CodedSurface& surface, unsigned threads,
                            const Progress& progress) {
    const std::size_t count = mesh_.attributes.size();
    std::vector<Expected<Bytes>> coded(count,
                                       fail(ErrorCode::internal, "an attribute is not encoded"));
    for_each_item(count, threads, [&](std::size_t i, unsigned worker) {
      const Attribute& a = mesh_.attributes[i];
      if (worker == 0)
        progress(a.name, 0.4 + 0.6 * static_cast<double>(i) / static_cast<double>(count));
      coded[i] = encode_attribute(in_coded_order(a, mesh_, result.order), surface, options_.level);
    });
    const Attribute* const position = mesh_.position();
    for (std::size_t i = 0; i < count; ++i) {
      if (!coded[i]) return Failure{coded[i].error()};
      const Attribute& a = mesh_.attributes[i];
      const std::size_t bytes = coded[i]->size();
      info().attributes.push_back(
          {a.name, a.domain, a.scalar, a.components, mesh_.value_count(a.domain), bytes});
      (&a == position ? info().position_bytes : info().attribute_bytes) += bytes;
      put(SectionKind::attribute, std::move(*coded[i]));
    }
    return Done{};
  }

  const Mesh& mesh_;
  const EncodeOptions& options_;
  std::span<const std::uint32_t> corners_, sizes_;  ///< of the faces of the surface
  std::vector<std::uint32_t> begins_;               ///< first corner of each face, if not triangles
  std::vector<std::uint32_t> loose_, kept_;         ///< faces; nothing kept: all are
  std::vector<std::uint32_t> kept_corners_, kept_sizes_;
  std::uint32_t surface_vertices_ = 0;
  std::uint64_t folded_ = 0;  ///< of the loose faces
  std::size_t loose_bytes_ = 0;
};

}  // namespace

Expected<Done> check(const Mesh& mesh, const EncodeOptions& options) {
  if (auto ok = check_arrays(mesh); !ok) return ok;
  if (options.on_nonmanifold == OnOddity::keep && options.on_degenerate == OnOddity::keep &&
      options.on_duplicate == OnOddity::keep)
    return Done{};
  return MeshEncoder(mesh, options).refuse();
}

CodedFaces in_coded_order(const Mesh& mesh, const Permutation& order) {
  CodedFaces result;
  const std::vector<std::uint32_t> begins = begins_of(mesh);
  std::vector<std::uint32_t> number(mesh.vertex_count);
  for (std::uint32_t i = 0; i < order.vertices.size(); ++i) number[order.vertices[i]] = i;
  result.corners.reserve(mesh.corners.size());
  for (std::uint32_t i = 0; i < order.faces.size(); ++i) {
    const std::uint32_t f = order.faces[i], size = size_of_face(mesh, f);
    const std::size_t begin = begins.empty() ? 3 * std::size_t(f) : begins[f];
    std::uint32_t j = order.first_corners[i];
    for (std::uint32_t k = 0; k < size; ++k, j = j + 1 == size ? 0 : j + 1)
      result.corners.push_back(number[mesh.corners[begin + j]]);
    if (!mesh.triangles_only()) result.sizes.push_back(size);
  }
  return result;
}

Bytes encode_order(const Mesh& mesh, const Permutation& order, const CodedFaces& coded) {
  FileOrder file;
  file.vertices = order.vertices;
  file.faces.resize(order.faces.size());
  file.first_corners.resize(order.faces.size());
  for (std::uint32_t i = 0; i < order.faces.size(); ++i) {
    const std::uint32_t f = order.faces[i], size = size_of_face(mesh, f);
    file.faces[f] = i;
    file.first_corners[f] = size == 0 ? 0 : (size - order.first_corners[i]) % size;
  }
  rans::Encoder stream;
  EncodeTo coder(stream);
  FileOrderCoder({coded.corners, coded.sizes}, mesh.vertex_count).code(coder, file);
  Bytes bytes;
  stream.finish(bytes);
  return bytes;
}

Attribute in_coded_order(const Attribute& a, const Mesh& mesh, const Permutation& order) {
  Attribute result = a;
  const std::size_t stride = a.stride();
  std::byte* to = result.data.data();
  const auto copy = [&](std::size_t from) {
    std::memcpy(to, a.data.data() + from * stride, stride);
    to += stride;
  };
  switch (a.domain) {
    case Domain::vertex:
      for (const std::uint32_t v : order.vertices) copy(v);
      break;
    case Domain::face:
      for (const std::uint32_t f : order.faces) copy(f);
      break;
    case Domain::corner: {
      const std::vector<std::uint32_t> begins = begins_of(mesh);
      for (std::size_t i = 0; i < order.faces.size(); ++i) {
        const std::uint32_t f = order.faces[i], size = size_of_face(mesh, f);
        const std::size_t begin = begins.empty() ? 3 * std::size_t(f) : begins[f];
        std::uint32_t j = order.first_corners[i];
        for (std::uint32_t k = 0; k < size; ++k, j = j + 1 == size ? 0 : j + 1) copy(begin + j);
      }
      break;
    }
  }
  return result;
}

void set_identity(const Mesh& mesh, Permutation& order) {
  order.vertices.resize(mesh.vertex_count);
  order.faces.resize(mesh.face_count());
  std::iota(order.vertices.begin(), order.vertices.end(), 0u);
  std::iota(order.faces.begin(), order.faces.end(), 0u);
  order.first_corners.assign(mesh.face_count(), 0);
}

Expected<EncodedMesh> encode_mesh(const Mesh& mesh, const EncodeOptions& options, unsigned threads,
                                  const Progress& progress) {
  MeshEncoder encoder(mesh, options);
  if (auto ok = encoder.run(threads, progress); !ok) return Failure{ok.error()};
  return std::move(encoder.result);
}

}  // namespace clers::internal
