#include "codec/encode.h"

#include <cstring>
#include <new>

#include "codec/adjacency.h"
#include "codec/attribute.h"
#include "codec/connectivity.h"
#include "codec/container.h"
#include "codec/orientation.h"

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

/// Refuses meshes whose arrays disagree, and those that are not of triangles.
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
    for (std::size_t f = 0; f < mesh.face_sizes.size(); ++f)
      if (mesh.face_sizes[f] != 3)
        return fail(ErrorCode::polygon, Place::face, f,
                    "has " + std::to_string(mesh.face_sizes[f]) + " corners, expected 3");
  }
  if (mesh.face_count() > max_faces)
    return fail(ErrorCode::too_large, std::to_string(mesh.face_count()) +
                                          " faces, expected at most " + std::to_string(max_faces));
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

/// The attribute with its values in the order of the coded mesh.
Attribute permuted(const Attribute& a, const Permutation& order) {
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
      for (std::size_t i = 0; i < order.faces.size(); ++i)
        for (unsigned j = 0; j < 3; ++j)
          copy(3 * std::size_t(order.faces[i]) + (order.first_corners[i] + j) % 3);
      break;
  }
  return result;
}

class MeshEncoder {
 public:
  MeshEncoder(const Mesh& mesh, const EncodeOptions& options, ContainerWriter& out)
      : mesh_(mesh), options_(options), out_(out), corners_(mesh.corners) {}

  /// Writes the mesh's sections. `progress` takes shares of this mesh.
  template <class Progress>
  Expected<Done> run(Progress progress) {
    if (auto ok = check(mesh_); !ok) return ok;
    progress("adjacency", 0.0);
    auto twins = find_twins(mesh_.corners, mesh_.vertex_count);
    if (!twins && twins.error().code == ErrorCode::nonorientable) {
      if (auto ok = turn_faces(); !ok) return ok;
      twins = find_twins(corners_, mesh_.vertex_count);
    }
    if (!twins) return Failure{twins.error()};
    progress("connectivity", 0.2);
    auto coded = encode_connectivity({corners_, *twins, mesh_.vertex_count}, options_.level);
    if (!coded) return Failure{located(coded.error())};
    *twins = {};
    number(*coded);
    describe(*coded);

    Bytes payload;
    put_varint(payload, mesh_.vertex_count - coded->vertices.size());
    put_turned_runs(payload);
    put_bytes(payload, coded->bytes);
    out_.section(SectionKind::mesh, payload);
    info.connectivity_bytes = payload.size();
    if (!mesh_.name.empty()) out_.section(SectionKind::name, std::as_bytes(std::span(mesh_.name)));
    return attributes(coded->gates, progress);
  }

  Permutation order;
  MeshInfo info;

 private:
  /// Gives all faces one orientation; the file says which were turned.
  Expected<Done> turn_faces() {
    auto turned = find_orientation(mesh_.corners);
    if (!turned) return Failure{turned.error()};
    turned_ = std::move(*turned);
    turned_corners_ = mesh_.corners;
    for (std::size_t f = 0; f < turned_.size(); ++f)
      if (turned_[f]) std::swap(turned_corners_[3 * f + 1], turned_corners_[3 * f + 2]);
    corners_ = turned_corners_;
    return Done{};
  }

  /// Faces that a decoder turns back, as runs in the new order.
  void put_turned_runs(Bytes& out) const {
    std::vector<TurnedRun> runs;
    for (std::uint32_t i = 0; i < order.faces.size() && !turned_.empty(); ++i) {
      if (!turned_[order.faces[i]]) continue;
      if (!runs.empty() && runs.back().first + runs.back().count == i)
        ++runs.back().count;
      else
        runs.push_back({i, 1});
    }
    put_varint(out, runs.size());
    std::uint32_t end = 0;
    for (const TurnedRun& run : runs) {
      put_varint(out, run.first - end);
      put_varint(out, run.count);
      end = run.first + run.count;
    }
  }

  /// Names the vertex of several fans, which encoding the connectivity only notices.
  Error located(const Error& error) const {
    if (error.code != ErrorCode::nonmanifold_vertex) return error;
    const auto twins = find_twins(corners_, mesh_.vertex_count);
    const std::uint32_t v = vertex_of_several_fans(corners_, *twins, mesh_.vertex_count);
    if (v == Vertex::null_index)
      return {ErrorCode::internal, Place::nowhere, 0, "the surface could not be built again"};
    return {ErrorCode::nonmanifold_vertex, Place::vertex, v,
            "its faces form more than one fan, expected one"};
  }

  void number(EncodedConnectivity& coded) {
    order.vertices = coded.vertices;
    order.vertices.reserve(mesh_.vertex_count);
    if (coded.vertices.size() < mesh_.vertex_count) {
      std::vector<bool> used(mesh_.vertex_count);
      for (const std::uint32_t v : coded.vertices) used[v] = true;
      for (std::uint32_t v = 0; v < mesh_.vertex_count; ++v)
        if (!used[v]) order.vertices.push_back(v);
    }
    order.faces.reserve(coded.gates.size());
    order.first_corners.reserve(coded.gates.size());
    for (const HalfEdge gate : coded.gates) {
      const std::uint32_t f = left(gate).index(), c = corner(gate);
      order.faces.push_back(f);
      order.first_corners.push_back(turned_.empty() || !turned_[f] ? c : (3 - c) % 3);
    }
  }

  void describe(const EncodedConnectivity& coded) {
    info.name = mesh_.name;
    info.shape.vertices = mesh_.vertex_count;
    info.shape.faces = info.shape.triangles = mesh_.face_count();
    info.shape.components = coded.counts.components;
    info.shape.boundary_curves = coded.counts.boundary_curves;
    info.shape.genus = coded.counts.handles;
    info.shape.isolated_vertices = mesh_.vertex_count - coded.vertices.size();
    info.clers = in_word_order(coded.counts.letters);
  }

  template <class Progress>
  Expected<Done> attributes(std::span<const HalfEdge> gates, Progress progress) {
    if (mesh_.attributes.empty()) return Done{};
    // The coded index buffer, all faces one way round, is needed to predict along it.
    std::vector<std::uint32_t> new_number(mesh_.vertex_count), corners(mesh_.corners.size());
    for (std::uint32_t i = 0; i < order.vertices.size(); ++i) new_number[order.vertices[i]] = i;
    for (std::size_t i = 0; i < gates.size(); ++i) {
      HalfEdge h = gates[i];
      for (unsigned j = 0; j < 3; ++j, h = lnext(h))
        corners[3 * i + j] = new_number[corners_[h.index()]];
    }
    std::size_t done = 0;
    for (const Attribute& a : mesh_.attributes) {
      progress(a.name, 0.4 + 0.6 * static_cast<double>(done++) /
                                 static_cast<double>(mesh_.attributes.size()));
      auto bytes = encode_attribute(permuted(a, order), corners, options_.level);
      if (!bytes) return Failure{bytes.error()};
      out_.section(SectionKind::attribute, *bytes);
      info.attributes.push_back(
          {a.name, a.domain, a.scalar, a.components, values_of(mesh_, a.domain), bytes->size()});
      (&a == mesh_.position() ? info.position_bytes : info.attribute_bytes) += bytes->size();
    }
    return Done{};
  }

  const Mesh& mesh_;
  const EncodeOptions& options_;
  ContainerWriter& out_;
  std::span<const std::uint32_t> corners_;  ///< the mesh's, or turned_corners_
  std::vector<std::uint32_t> turned_corners_;
  std::vector<bool> turned_;  ///< faces; empty: none
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
