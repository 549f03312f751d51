#include "codec/encode.h"

#include <algorithm>
#include <cstring>
#include <new>
#include <numeric>

#include "codec/adjacency.h"
#include "codec/attribute.h"
#include "codec/container.h"
#include "codec/duplicates.h"
#include "codec/file_order.h"
#include "codec/loose_faces.h"
#include "codec/mesh_features.h"
#include "codec/plain_faces.h"
#include "codec/surface_encoder.h"

namespace clers {
namespace {

std::uint64_t values_of(const Mesh& mesh, Domain domain) {
  switch (domain) {
    case Domain::vertex: return mesh.vertex_count;
    case Domain::corner: return mesh.corners.size();
    case Domain::face: return mesh.face_count();
  }
  return 0;
}

/// Refuses meshes whose arrays disagree.
Expected<Done> check(const Mesh& mesh) {
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
  for (const Attribute& a : mesh.attributes) {
    if (a.name.size() > 255)
      return fail(ErrorCode::inconsistent_mesh, "an attribute's name is longer than 255 bytes");
    if (static_cast<unsigned>(a.scalar) >= scalar_count || a.components == 0 ||
        a.data.size() != values_of(mesh, a.domain) * a.stride())
      return fail(ErrorCode::inconsistent_mesh,
                  "attribute \"" + a.name + "\" has " + std::to_string(a.data.size()) +
                      " bytes of values, expected " + std::to_string(values_of(mesh, a.domain)) +
                      " times " + std::to_string(a.stride()));
  }
  return Done{};
}

class MeshEncoder {
 public:
  MeshEncoder(const Mesh& mesh, const EncodeOptions& options, ContainerWriter& out)
      : mesh_(mesh), options_(options), out_(out), corners_(mesh.corners), sizes_(mesh.face_sizes) {
    if (std::all_of(sizes_.begin(), sizes_.end(), [](std::uint32_t n) { return n == 3; }))
      sizes_ = {};
  }

  /// Writes the mesh's sections. `progress` takes shares of this mesh.
  template <class Progress>
  Expected<Done> run(Progress progress) {
    if (auto ok = check(mesh_); !ok) return ok;
    progress("connectivity", 0.0);
    if (auto ok = set_loose_aside(); !ok) return ok;
    if (auto ok = refuse(); !ok) return ok;
    auto coded = encode_surface(corners_, sizes_, mesh_.vertex_count, options_.level);
    if (!coded) return Failure{coded.error()};
    number(*coded);
    const Bytes loose = code_loose(coded->triangles);
    if (auto ok = describe(*coded); !ok) return ok;

    Bytes payload = surface_payload(*coded, loose), kept_order;
    std::vector<std::uint32_t> triangles = std::move(coded->triangles);
    const bool keep = options_.order == Order::keep;
    if (keep || coded->copies > 0) {
      progress("order", 0.3);
      // Where the faces one by one cost less, those it is. Without an order to keep they may stand
      // in either, so that coding what was coded comes to the same.
      const CodedFaces coded_faces = in_coded_order();
      if (keep) kept_order = code_order(coded_faces);
      const auto take_if_smaller = [&](std::span<const std::uint32_t> corners,
                                       std::span<const std::uint32_t> sizes) {
        // Never seen to take less than a bit a corner but for a few.
        const std::size_t so_far = payload.size() + kept_order.size();
        if (8 * so_far < corners.size() / 2) return false;
        Bytes faces = plain_payload(corners, sizes);
        if (faces.size() >= so_far) return false;
        payload = std::move(faces);
        kept_order.clear();
        triangles = fan_triangles(corners, sizes);
        info.cuts = {};
        info.clers = {};
        info.polygon_bytes = info.stitching_bytes = 0;
        return true;
      };
      if (!keep) take_if_smaller(coded_faces.corners, coded_faces.sizes);
      if (take_if_smaller(mesh_.corners, mesh_.face_sizes)) set_identity();
    }
    out_.section(SectionKind::mesh, payload);
    info.connectivity_bytes = payload.size() + kept_order.size();
    info.order_bytes = kept_order.size();
    if (!mesh_.name.empty()) out_.section(SectionKind::name, std::as_bytes(std::span(mesh_.name)));
    if (!kept_order.empty()) out_.section(SectionKind::order, kept_order);
    if (auto ok = attributes(triangles, progress); !ok) return ok;
    if (keep) set_identity();
    return Done{};
  }

  Permutation order;
  MeshInfo info;

 private:
  static void put_stream(Bytes& out, const Bytes& stream) {
    put_varint(out, stream.size());
    put_bytes(out, stream);
  }

  std::uint32_t size_of_face(std::size_t f) const {
    return mesh_.triangles_only() ? 3 : mesh_.face_sizes[f];
  }

  Bytes surface_payload(const EncodedSurface& coded, const Bytes& loose) const {
    Bytes payload;
    put_u8(payload, coded.features | (loose_.empty() ? 0 : feature::loose));
    put_varint(payload, mesh_.vertex_count - surface_vertices_);
    if (coded.features & feature::turned) {
      put_varint(payload, coded.turned_runs);
      put_stream(payload, coded.turned);
    }
    if (coded.features & feature::polygons) {
      put_varint(payload, mesh_.face_count() - loose_.size());
      put_stream(payload, coded.polygons);
    }
    if (coded.features & feature::copies) {
      put_varint(payload, coded.copies);
      put_stream(payload, coded.stitches);
    }
    put_bytes(payload, loose);
    put_bytes(payload, coded.connectivity);
    return payload;
  }

  /// Faces one by one, in the order given. No sizes: triangles.
  Bytes plain_payload(std::span<const std::uint32_t> corners,
                      std::span<const std::uint32_t> sizes) const {
    rans::Encoder stream;
    EncodeTo coder(stream);
    PlainFaceModel model(mesh_.vertex_count);
    std::vector<std::uint32_t> face;
    for (std::size_t f = 0, begin = 0; f < mesh_.face_count(); ++f) {
      const std::uint32_t size = sizes.empty() ? 3 : sizes[f];
      const auto cycle = corners.subspan(begin, size);
      face.assign(cycle.begin(), cycle.end());
      begin += size;
      model.code_size(coder, size);
      model.code_corners(coder, face);
    }
    Bytes payload;
    put_u8(payload, feature::plain);
    put_varint(payload, mesh_.vertex_count);
    put_varint(payload, mesh_.face_count());
    put_varint(payload, corners.size());
    stream.finish(payload);
    return payload;
  }

  /// The mesh as it is decoded, before it is put into the order of the file.
  struct CodedFaces {
    std::vector<std::uint32_t> corners, sizes;
  };
  CodedFaces in_coded_order() const {
    CodedFaces result;
    std::vector<std::uint32_t> number(mesh_.vertex_count);
    for (std::uint32_t i = 0; i < order.vertices.size(); ++i) number[order.vertices[i]] = i;
    result.corners.reserve(mesh_.corners.size());
    for (std::uint32_t i = 0; i < order.faces.size(); ++i) {
      const auto cycle = cycle_of(order.faces[i]);
      const std::size_t size = cycle.size();
      std::size_t j = order.first_corners[i];
      for (std::size_t k = 0; k < size; ++k, j = j + 1 == size ? 0 : j + 1)
        result.corners.push_back(number[cycle[j]]);
      if (!mesh_.triangles_only()) result.sizes.push_back(static_cast<std::uint32_t>(size));
    }
    return result;
  }

  /// The order of the file, told along the decoded mesh.
  Bytes code_order(const CodedFaces& coded) const {
    FileOrder file;
    file.vertices = order.vertices;
    file.faces.resize(order.faces.size());
    file.first_corners.resize(order.faces.size());
    for (std::uint32_t i = 0; i < order.faces.size(); ++i) {
      const std::uint32_t f = order.faces[i], size = size_of_face(f);
      file.faces[f] = i;
      file.first_corners[f] = size == 0 ? 0 : (size - order.first_corners[i]) % size;
    }
    rans::Encoder stream;
    EncodeTo coder(stream);
    FileOrderCoder({coded.corners, coded.sizes}, mesh_.vertex_count).code(coder, file);
    Bytes bytes;
    stream.finish(bytes);
    return bytes;
  }

  void set_identity() {
    order.vertices.resize(mesh_.vertex_count);
    order.faces.resize(mesh_.face_count());
    std::iota(order.vertices.begin(), order.vertices.end(), 0u);
    std::iota(order.faces.begin(), order.faces.end(), 0u);
    order.first_corners.assign(mesh_.face_count(), 0);
  }

  /// Parts faces that a surface can have from those that it cannot: fewer than three corners, or a
  /// vertex twice.
  Expected<Done> set_loose_aside() {
    const std::size_t faces = mesh_.face_count();
    std::vector<std::uint32_t> last_face(mesh_.vertex_count, none);
    if (faces > 0) begins_.reserve(mesh_.triangles_only() ? 0 : faces);
    std::size_t begin = 0;
    for (std::size_t f = 0; f < faces; ++f) {
      const std::uint32_t size = size_of_face(f);
      bool is_loose = size < 3;
      for (std::size_t h = begin; h < begin + size; ++h) {
        const std::uint32_t v = mesh_.corners[h];
        if (v >= mesh_.vertex_count)
          return fail(ErrorCode::inconsistent_mesh, Place::face, f,
                      "has vertex " + std::to_string(v) + ", expected one below " +
                          std::to_string(mesh_.vertex_count));
        is_loose |= last_face[v] == f;
        last_face[v] = static_cast<std::uint32_t>(f);
      }
      if (is_loose) loose_.push_back(static_cast<std::uint32_t>(f));
      if (!mesh_.triangles_only()) begins_.push_back(static_cast<std::uint32_t>(begin));
      begin += size;
    }
    if (loose_.empty()) return Done{};
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
      kept_sizes_.push_back(size_of_face(f));
    }
    corners_ = kept_corners_;
    sizes_ = kept_sizes_;
    if (std::all_of(sizes_.begin(), sizes_.end(), [](std::uint32_t n) { return n == 3; }))
      sizes_ = {};
    return Done{};
  }

  std::span<const std::uint32_t> cycle_of(std::uint32_t f) const {
    const std::size_t begin = mesh_.triangles_only() ? 3 * std::size_t(f) : begins_[f];
    return std::span<const std::uint32_t>(mesh_.corners).subspan(begin, size_of_face(f));
  }

  /// What the options do not allow to keep.
  Expected<Done> refuse() {
    if (options_.on_degenerate == OnOddity::error && !loose_.empty()) {
      const std::uint32_t size = size_of_face(loose_[0]);
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

  void number(EncodedSurface& coded) {
    order = std::move(coded.order);
    surface_vertices_ = static_cast<std::uint32_t>(order.vertices.size());
    if (surface_vertices_ < mesh_.vertex_count) {
      std::vector<bool> used(mesh_.vertex_count);
      for (const std::uint32_t v : order.vertices) used[v] = true;
      for (std::uint32_t v = 0; v < mesh_.vertex_count; ++v)
        if (!used[v]) order.vertices.push_back(v);
    }
    if (!kept_.empty())
      for (std::uint32_t& f : order.faces) f = kept_[f];
  }

  /// Appends the loose faces to the order. Returns what stands in the mesh section for them.
  Bytes code_loose(std::span<const std::uint32_t> triangles) {
    Bytes out;
    if (loose_.empty()) return out;
    std::vector<std::uint32_t> number(mesh_.vertex_count);
    for (std::uint32_t i = 0; i < order.vertices.size(); ++i) number[order.vertices[i]] = i;
    std::vector<std::uint32_t> corners;
    struct Loose {
      std::uint32_t face, rotation;
      std::size_t begin, size;
    };
    std::vector<Loose> faces;
    for (const std::uint32_t f : loose_) {
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
    LooseFaceModel model(triangles, surface_vertices_, mesh_.vertex_count);
    for (const Loose& l : faces) {
      model.code_size(coder, static_cast<std::uint32_t>(l.size));
      model.code_corners(coder, cycle(l));
      order.faces.push_back(l.face);
      order.first_corners.push_back(l.rotation);
    }
    Bytes bytes;
    stream.finish(bytes);
    put_varint(out, faces.size());
    put_varint(out, corners.size());
    put_stream(out, bytes);
    loose_bytes_ = bytes.size();
    return out;
  }

  Expected<Done> describe(const EncodedSurface& coded) {
    info.name = mesh_.name;
    info.cuts = {coded.turned_faces, coded.copies, loose_.size()};
    info.clers = in_word_order(coded.counts.letters);
    info.polygon_bytes = coded.polygons.size();
    info.stitching_bytes = coded.turned.size() + coded.stitches.size() + loose_bytes_;
    if (coded.copies > 0 || coded.turned_faces > 0 || !loose_.empty()) {
      auto shape = measure(mesh_);
      if (!shape) return Failure{shape.error()};
      info.shape = *shape;
      return Done{};
    }
    info.shape.vertices = mesh_.vertex_count;
    info.shape.faces = mesh_.face_count();
    info.shape.triangles = mesh_.corners.size() - 2 * mesh_.face_count();
    info.shape.components = coded.counts.components;
    info.shape.boundary_curves = coded.counts.boundary_curves;
    info.shape.genus = coded.counts.handles;
    info.shape.isolated_vertices = mesh_.vertex_count - surface_vertices_;
    return Done{};
  }

  /// The attribute with its values in the order of the coded mesh.
  Attribute permuted(const Attribute& a) const {
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
      case Domain::corner:
        for (std::size_t i = 0; i < order.faces.size(); ++i) {
          const std::uint32_t f = order.faces[i], size = size_of_face(f);
          const std::size_t begin = mesh_.triangles_only() ? 3 * std::size_t(f) : begins_[f];
          std::uint32_t j = order.first_corners[i];
          for (std::uint32_t k = 0; k < size; ++k, j = j + 1 == size ? 0 : j + 1) copy(begin + j);
        }
        break;
    }
    return result;
  }

  template <class Progress>
  Expected<Done> attributes(std::span<const std::uint32_t> triangles, Progress progress) {
    std::size_t done = 0;
    for (const Attribute& a : mesh_.attributes) {
      progress(a.name, 0.4 + 0.6 * static_cast<double>(done++) /
                                 static_cast<double>(mesh_.attributes.size()));
      auto bytes = encode_attribute(permuted(a), triangles, options_.level);
      if (!bytes) return Failure{bytes.error()};
      out_.section(SectionKind::attribute, *bytes);
      info.attributes.push_back(
          {a.name, a.domain, a.scalar, a.components, values_of(mesh_, a.domain), bytes->size()});
      (&a == mesh_.position() ? info.position_bytes : info.attribute_bytes) += bytes->size();
    }
    return Done{};
  }

  static constexpr std::uint32_t none = 0xffffffffu;

  const Mesh& mesh_;
  const EncodeOptions& options_;
  ContainerWriter& out_;
  std::span<const std::uint32_t> corners_, sizes_;  ///< of the faces of the surface
  std::vector<std::uint32_t> begins_;               ///< first corner of each face, if not triangles
  std::vector<std::uint32_t> loose_, kept_;         ///< faces; nothing kept: all are
  std::vector<std::uint32_t> kept_corners_, kept_sizes_;
  std::uint32_t surface_vertices_ = 0;
  std::size_t loose_bytes_ = 0;
};

}  // namespace

Expected<Encoded> encode(std::span<const Mesh> meshes, const EncodeOptions& options) try {
  if (options.level < min_level || options.level > max_level)
    return fail(ErrorCode::bad_option,
                "level " + std::to_string(options.level) + ", expected 1 to 9");
  ContainerWriter out(options.level);
  Encoded result;
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    MeshEncoder encoder(meshes[i], options, out);
    const auto ok = encoder.run([&](std::string_view stage, double share) {
      if (options.progress)
        options.progress(stage,
                         (static_cast<double>(i) + share) / static_cast<double>(meshes.size()));
    });
    if (!ok) {
      Error error = ok.error();
      if (meshes.size() > 1) error.what += " (mesh " + std::to_string(i) + ")";
      return Failure{error};
    }
    result.permutations.push_back(std::move(encoder.order));
    result.report.push_back(std::move(encoder.info));
  }
  result.bytes = out.finish(meshes.size());
  if (options.progress) options.progress("done", 1.0);
  return result;
} catch (const std::bad_alloc&) {
  return fail(ErrorCode::out_of_memory, "not enough memory to encode");
}

}  // namespace clers
