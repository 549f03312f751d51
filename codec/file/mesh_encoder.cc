// The sequence of encoding, and its report.
#include "codec/file/mesh_encoder.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "codec/base/check.h"
#include "codec/base/parallel.h"
#include "codec/base/utf8.h"
#include "codec/file/attribute_sums.h"
#include "codec/file/file_order.h"
#include "codec/file/mesh_features.h"
#include "codec/file/metadata.h"
#include "codec/file/value_encoder.h"
#include "codec/file/weld.h"
#include "codec/soup/corner_map.h"
#include "codec/soup/defects.h"
#include "codec/soup/degenerate_faces.h"
#include "codec/soup/folded_faces.h"
#include "codec/soup/raw_faces.h"
#include "codec/soup/regular_faces.h"
#include "codec/soup/surface_encoder.h"

namespace clers::internal {
namespace {

class MeshEncoder {
 public:
  /// `weld` must outlive this; nullptr: vertices stay as they are.
  MeshEncoder(const MeshView& mesh, const EncodeOptions& options,
              std::span<const AttributePlan> plans, const Weld* weld = nullptr)
      : mesh_(mesh),
        options_(options),
        plans_(plans),
        weld_(weld),
        welded_corners_(welded(mesh, weld)),
        vertices_(weld ? weld->count : mesh.vertex_count),
        all_(mesh.corners, mesh.face_sizes),
        faces_(weld ? std::span<const std::uint32_t>(welded_corners_) : mesh.corners,
               mesh.face_sizes),
        regular_(faces_, mesh.face_sizes, vertices_) {}

  template <class Progress>
  Expected<Done> run(unsigned threads, const Progress& progress) {
    auto coded =
        encode_surface(regular_.corners(), regular_.sizes(), vertices_, options_.level, wanted(),
                       [&] { return !weld_ && raw_bytes() < 3 * mesh_.face_count() / 2; });
    if (!coded) return Failure{coded.error()};
    Bytes payload, kept_order;
    CodedArrays surface;
    std::optional<Bytes> raw;
    const bool keep = options_.order == Order::keep;
    if (coded->given_up) {
      raw = raw_payload(all_.count());
    } else {
      number(*coded);
      surface = std::move(coded->surface);
      encode_degenerate_faces(surface.corners, order());
      if (weld_ && !split(*coded, surface.view())) return Done{};
      payload = surface_payload(*coded);
      if (keep) {
        progress("order", 0.3);
        kept_order = encode_order(all_, order());
      }
      if (!weld_ && (keep || !coded->copies.empty()))
        raw = raw_if_smaller(payload.size() + kept_order.size());
    }
    describe(*coded);
    result.has_boundary = coded->given_up || coded->counts.boundary_curves > 0;
    raw_ = raw.has_value();
    if (raw) {
      payload = std::move(*raw);
      kept_order.clear();
      surface.corners = fan_triangles(mesh_.corners, mesh_.face_sizes);
      surface.twins = {};
      surface.introduced_by.resize(mesh_.vertex_count);
      find_introducing(surface.corners, surface.introduced_by);
      order() = identity(mesh_);
      coded->reversed_runs.clear();
      coded->polygons = {};
      result.counts = {};
      info().copied_vertices = info().repeated_faces = info().degenerate_faces = 0;
      info().polygon_bytes = info().stitching_bytes = 0;
      info().triangles_only = false;
    }
    info().connectivity_bytes = payload.size() + kept_order.size();
    info().order_bytes = kept_order.size();
    put(SectionKind::mesh, std::move(payload));
    if (!mesh_.name.empty()) {
      const auto name = std::as_bytes(std::span(mesh_.name));
      put(SectionKind::name, Bytes(name.begin(), name.end()));
    }
    if (!kept_order.empty()) put(SectionKind::order, std::move(kept_order));
    if (auto ok = attributes(*coded, surface.view(), threads, progress); !ok) return ok;
    if (keep) order() = identity(mesh_);
    return Done{};
  }

  EncodedMesh result;  ///< no sections: vertices cannot be welded

 private:
  static std::vector<std::uint32_t> welded(const MeshView& mesh, const Weld* weld) {
    std::vector<std::uint32_t> corners;
    if (weld == nullptr) return corners;
    corners.reserve(mesh.corners.size());
    for (const std::uint32_t v : mesh.corners) corners.push_back(weld->vertex_of[v]);
    return corners;
  }

  Wanted wanted() const {
    if (weld_) return Wanted::surface_with_twins;
    for (const AttributeView a : mesh_.attributes)
      if (a.domain == Domain::corner ||
          (a.domain == Domain::vertex && options_.level >= first_level_with_twins))
        return Wanted::surface_with_twins;
    return mesh_.attributes.empty() && regular_.degenerate().empty() ? Wanted::nothing
                                                                     : Wanted::surface;
  }

  Permutation& order() { return result.order; }
  MeshInfo& info() { return result.info; }
  void put(SectionKind kind, Bytes payload) {
    result.sections.push_back({kind, std::move(payload)});
  }

  Bytes surface_payload(const EncodedSurface& coded) const {
    const std::pair<std::uint32_t, const EncodedStream*> streams[] = {
        {feature::reversed, &coded.reversed}, {feature::polygons, &coded.polygons},
        {feature::copies, &coded.copies},     {feature::repeats, &coded.repeats},
        {feature::folded, &folded_stream_},   {feature::degenerate, &degenerate_stream_},
        {feature::welded, &points_.stream}};
    std::uint32_t features = 0;
    for (const auto& [bit, stream] : streams) features |= stream->empty() ? 0 : bit;
    Bytes payload;
    put_u8(payload, features);
    put_varint(payload, vertices_ - surface_vertices_);
    for (const auto& [bit, stream] : streams)
      if (features & bit) stream->put(payload);
    put_bytes(payload, coded.connectivity);
    return payload;
  }

  /// The faces one by one, if that takes less than so many bytes.
  std::optional<Bytes> raw_if_smaller(std::size_t bytes) const {
    // Never seen to take less than a bit a corner but for a few.
    if (8 * bytes < mesh_.corners.size() / 2) return std::nullopt;
    if (mesh_.face_count() > 16 * raw_sample && raw_bytes() > bytes) return std::nullopt;
    Bytes raw = raw_payload(all_.count());
    return raw.size() < bytes ? std::optional(std::move(raw)) : std::nullopt;
  }

  /// About how many bytes the faces one by one take, by the first of them.
  std::size_t raw_bytes() const {
    const std::size_t faces = mesh_.face_count(), sample = std::min(faces, raw_sample);
    return sample == 0 ? 0
                       : raw_payload(static_cast<std::uint32_t>(sample)).size() * faces / sample;
  }
  static constexpr std::size_t raw_sample = 1024;

  Bytes raw_payload(std::uint32_t faces) const {
    Bytes payload;
    put_u8(payload, feature::raw);
    put_bytes(payload, encode_raw(all_, faces, mesh_.vertex_count));
    return payload;
  }

  void number(EncodedSurface& coded) {
    order() = std::move(coded.order);
    surface_vertices_ = static_cast<std::uint32_t>(order().vertices.size());
    if (surface_vertices_ < vertices_) {
      std::vector<bool> used(vertices_);
      for (const std::uint32_t v : order().vertices) used[v] = true;
      for (std::uint32_t v = 0; v < vertices_; ++v)
        if (!used[v]) order().vertices.push_back(v);
    }
    if (!regular_.degenerate().empty())
      for (std::uint32_t& f : order().faces) f = regular_.in_all(f);
  }

  /// Encodes the faces that no surface can have, beside the triangles of the one there is, and
  /// appends them to the order.
  void encode_degenerate_faces(std::span<const std::uint32_t> triangles, Permutation& order) {
    if (regular_.degenerate().empty()) return;
    std::vector<std::uint32_t> number(vertices_);
    for (std::uint32_t i = 0; i < order.vertices.size(); ++i) number[order.vertices[i]] = i;
    const std::vector<std::uint32_t> others = encode_folded(
        faces_, regular_.degenerate(), number, triangles, surface_vertices_, order, folded_stream_);
    if (!others.empty())
      degenerate_stream_ =
          encode_degenerate(faces_, others, number, triangles, surface_vertices_, vertices_, order);
  }

  void describe(const EncodedSurface& coded) {
    info().name = mesh_.name;
    info().vertices = mesh_.vertex_count;
    info().faces = mesh_.face_count();
    info().corners = mesh_.corners.size();
    info().triangles_only = coded.polygons.empty() && degenerate_stream_.empty();
    info().copied_vertices = coded.copied_vertices;
    info().repeated_faces = coded.repeated_faces;
    info().degenerate_faces = regular_.degenerate().size();
    info().polygon_bytes = coded.polygons.bytes.size();
    info().stitching_bytes = coded.reversed.bytes.size() + coded.copies.bytes.size() +
                             coded.repeats.bytes.size() + folded_stream_.bytes.size() +
                             degenerate_stream_.bytes.size() + points_.stream.bytes.size();
    info().welded_vertices = mesh_.vertex_count - vertices_;
    result.counts = {count_reversed(coded.reversed_runs), in_word_order(coded.counts.symbols)};
  }

  /// The faces in their order, as values are coded along them.
  void find_coded_faces(const EncodedSurface& coded, const CodedSurface& surface) {
    permuted_ = permuted(faces_, order());
    reverse_runs(permuted_.corners, permuted_.sizes, coded.reversed_runs);
    if (!coded.polygons.empty())
      corner_of_ = corners_of_polygons(permuted_.sizes, surface.corners.size());
    else if (raw_ && !permuted_.sizes.empty())
      corner_of_ = corners_of_fans(permuted_.sizes, surface.corners.size());
  }
  CodedFaces coded_faces(const CodedSurface& surface) const {
    return {surface, corner_of_, permuted_.corners, permuted_.sizes, vertices_};
  }

  /// Makes vertices of welded ones, and the order that of vertices. False: that cannot be.
  bool split(const EncodedSurface& coded, const CodedSurface& surface) {
    find_coded_faces(coded, surface);
    std::vector<std::uint32_t> old, isolated, old_of(vertices_);
    std::vector<bool> used(vertices_);
    old.reserve(mesh_.corners.size());
    for_each_corner(all_, order(), [&](std::uint32_t c) { old.push_back(mesh_.corners[c]); });
    reverse_runs(old, permuted_.sizes, coded.reversed_runs);
    for (const std::uint32_t v : welded_corners_) used[v] = true;
    for (std::uint32_t v = 0; v < mesh_.vertex_count; ++v) old_of[weld_->vertex_of[v]] = v;
    for (const std::uint32_t v : order().vertices)
      if (!used[v]) isolated.push_back(old_of[v]);
    points_ = encode_points(coded_faces(surface), old, isolated, mesh_.vertex_count);
    if (points_.stream.empty()) return false;
    order().vertices = points_.vertices;
    return true;
  }

  Expected<Done> attributes(const EncodedSurface& coded, const CodedSurface& surface,
                            unsigned threads, const Progress& progress) {
    bool need_corners = false;
    for (const AttributeView a : mesh_.attributes)
      need_corners |= may_have_structure(a) || may_be_predicted_by_faces(a, options_.level);
    if (need_corners && !weld_) find_coded_faces(coded, surface);
    auto values = encode_values({mesh_, all_, order(), coded.reversed_runs, coded_faces(surface),
                                 weld_ ? &points_.points : nullptr},
                                options_, plans_, threads, progress);
    if (!values) return Failure{values.error()};
    AttributeSums sums(info());
    for (std::size_t i = 0; i < values->size(); ++i) {
      EncodedAttribute& attribute = (*values)[i];
      const std::uint64_t count = attribute.info.count;
      sums.add(i, std::move(attribute.info), count);
      put(SectionKind::attribute, std::move(attribute.bytes));
    }
    return Done{};
  }

  const MeshView mesh_;
  const EncodeOptions& options_;
  const std::span<const AttributePlan> plans_;
  const Weld* const weld_;
  const std::vector<std::uint32_t> welded_corners_;
  const std::uint32_t vertices_;  ///< once welded, if they are
  const Cycles all_;
  const Cycles faces_;  ///< of these
  const RegularFaces regular_;
  std::uint32_t surface_vertices_ = 0;
  bool raw_ = false;  ///< faces are coded one by one
  EncodedStream folded_stream_, degenerate_stream_;
  PermutedFaces permuted_;
  std::vector<std::uint32_t> corner_of_;
  EncodedPoints points_;
};

std::size_t size_of(const EncodedMesh& mesh) {
  std::size_t bytes = 0;
  for (const EncodedSection& section : mesh.sections) bytes += section.payload.size();
  return bytes;
}

/// Vertices that a seam split are on boundaries. What is at one place beside these is left there.
bool may_be_split(const EncodedMesh& mesh, const EncodeOptions& options) {
  return options.level >= first_level_with_twins && mesh.has_boundary;
}

}  // namespace

Expected<Done> check(const MeshView& mesh, const EncodeOptions& options) {
  if (auto ok = check_arrays(mesh); !ok) return ok;
  if (!is_utf8(mesh.name))
    return fail(ErrorCode::inconsistent_mesh, "the name of the mesh is not UTF-8");
  if (std::string what = metadata_fault(mesh.metadata); !what.empty())
    return fail(ErrorCode::inconsistent_mesh, std::move(what));
  for (const AttributeView a : mesh.attributes)
    if (auto ok = check_attribute(a, mesh.value_count(a.domain)); !ok) return ok;
  return refuse_defects(mesh, options);
}

Expected<EncodedMesh> encode_mesh(const MeshView& mesh, const EncodeOptions& options,
                                  std::span<const AttributePlan> plans, unsigned threads,
                                  const Progress& progress) {
  progress("connectivity", 0.0);
  EncodedMesh best;
  {
    MeshEncoder encoder(mesh, options, plans);
    if (auto ok = encoder.run(threads, progress); !ok) return Failure{ok.error()};
    best = std::move(encoder.result);
  }
  if (!may_be_split(best, options)) return best;
  const std::optional<Weld> weld = find_weld(mesh);
  if (!weld) return best;
  MeshEncoder encoder(mesh, options, plans, &*weld);
  if (auto ok = encoder.run(threads, progress); !ok) return Failure{ok.error()};
  EncodedMesh& other = encoder.result;
  if (!other.sections.empty() && size_of(other) < size_of(best)) return std::move(other);
  return best;
}

}  // namespace clers::internal
