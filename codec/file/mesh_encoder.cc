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
  MeshEncoder(const MeshView& mesh, const EncodeOptions& options,
              std::span<const AttributePlan> plans)
      : mesh_(mesh),
        options_(options),
        plans_(plans),
        all_(mesh.corners, mesh.face_sizes),
        regular_(all_, mesh.face_sizes, mesh.vertex_count) {}

  template <class Progress>
  Expected<Done> run(unsigned threads, const Progress& progress) {
    auto coded =
        encode_surface(regular_.corners(), regular_.sizes(), mesh_.vertex_count, options_.level,
                       wanted(), [&] { return raw_bytes() < 3 * mesh_.face_count() / 2; });
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
      payload = surface_payload(*coded);
      if (keep) {
        progress("order", 0.3);
        kept_order = encode_order(all_, order());
      }
      if (keep || !coded->copies.empty()) raw = raw_if_smaller(payload.size() + kept_order.size());
    }
    describe(*coded);
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
    if (auto ok = attributes(surface.view(), coded->reversed_runs, !coded->polygons.empty(),
                             threads, progress);
        !ok)
      return ok;
    if (keep) order() = identity(mesh_);
    return Done{};
  }

  EncodedMesh result;

 private:
  Wanted wanted() const {
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
        {feature::folded, &folded_stream_},   {feature::degenerate, &degenerate_stream_}};
    std::uint32_t features = 0;
    for (const auto& [bit, stream] : streams) features |= stream->empty() ? 0 : bit;
    Bytes payload;
    put_u8(payload, features);
    put_varint(payload, mesh_.vertex_count - surface_vertices_);
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
    if (surface_vertices_ < mesh_.vertex_count) {
      std::vector<bool> used(mesh_.vertex_count);
      for (const std::uint32_t v : order().vertices) used[v] = true;
      for (std::uint32_t v = 0; v < mesh_.vertex_count; ++v)
        if (!used[v]) order().vertices.push_back(v);
    }
    if (!regular_.degenerate().empty())
      for (std::uint32_t& f : order().faces) f = regular_.in_all(f);
  }

  /// Encodes the faces that no surface can have, beside the triangles of the one there is, and
  /// appends them to the order.
  void encode_degenerate_faces(std::span<const std::uint32_t> triangles, Permutation& order) {
    if (regular_.degenerate().empty()) return;
    std::vector<std::uint32_t> number(mesh_.vertex_count);
    for (std::uint32_t i = 0; i < order.vertices.size(); ++i) number[order.vertices[i]] = i;
    const std::vector<std::uint32_t> others = encode_folded(
        all_, regular_.degenerate(), number, triangles, surface_vertices_, order, folded_stream_);
    if (!others.empty())
      degenerate_stream_ = encode_degenerate(all_, others, number, triangles, surface_vertices_,
                                             mesh_.vertex_count, order);
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
                             degenerate_stream_.bytes.size();
    result.counts = {count_reversed(coded.reversed_runs), in_word_order(coded.counts.symbols)};
  }

  AttributePlan plan(std::size_t attribute) const {
    return plans_.empty() ? AttributePlan{} : plans_[attribute];
  }

  /// The faces as values are coded along them.
  struct Faces {
    PermutedFaces faces;
    std::vector<std::uint32_t> corner_of;
    CodedFaces view;
  };
  Faces coded_faces(const CodedSurface& surface, std::span<const ReversedRun> reversed,
                    bool polygons) {
    Faces out;
    out.view.surface = surface;
    out.view.vertices = mesh_.vertex_count;
    out.faces = permuted(all_, order());
    reverse_runs(out.faces.corners, out.faces.sizes, reversed);
    if (polygons)
      out.corner_of = corners_of_polygons(out.faces.sizes, surface.corners.size());
    else if (raw_ && !out.faces.sizes.empty())
      out.corner_of = corners_of_fans(out.faces.sizes, surface.corners.size());
    out.view.corner_of = out.corner_of;
    out.view.corners = out.faces.corners;
    out.view.sizes = out.faces.sizes;
    return out;
  }

  template <class Progress>
  Expected<Done> attributes(const CodedSurface& surface, std::span<const ReversedRun> reversed,
                            bool polygons, unsigned threads, const Progress& progress) {
    const std::size_t count = mesh_.attributes.size();
    const auto has_structure = [](const AttributeView& a) {
      return a.domain == Domain::corner || !a.indices.empty();
    };
    const auto permute = [&](const AttributeView& a, const Faces& faces) {
      Attribute moved = permuted(a, all_, order());
      if (a.domain != Domain::corner) return moved;
      if (a.indices.empty())
        reverse_runs(moved.data, a.value_size(), faces.faces.sizes, reversed);
      else
        reverse_runs(moved.indices, faces.faces.sizes, reversed);
      return moved;
    };
    // Which corners share values is found first: seams of one attribute are often those of others.
    // Faces in their new order are needed by these alone.
    Faces faces;
    faces.view.surface = surface;
    faces.view.vertices = mesh_.vertex_count;
    std::vector<Attribute> permuted_ones(count);
    std::vector<std::vector<EncodedStructure>> ways(count);
    const Attribute* position = nullptr;
    Seams beside;
    for (std::size_t i = 0; i < count; ++i) {
      const AttributeView a = mesh_.attributes[i];
      const bool is_position =
          position == nullptr && a.domain == Domain::vertex && a.name == position_name;
      if (has_structure(a) && faces.view.corners.empty())
        faces = coded_faces(surface, reversed, polygons);
      if (!is_position && !has_structure(a)) continue;
      permuted_ones[i] = permute(a, faces);
      if (is_position) position = &permuted_ones[i];
      if (is_position) continue;
      const bool keep = options_.order == Order::keep && !a.indices.empty();
      ways[i] = encode_structures(
          permuted_ones[i], faces.view,
          keep ? kept_numbering(a.indices, a.value_count()) : std::vector<std::uint32_t>(),
          beside.empty() ? nullptr : &beside, options_.level);
      // Where it is left open whether there are any, those after it do without.
      if (a.domain == Domain::corner) beside = ways[i][0].structure.seams;
    }
    std::vector<Expected<EncodedAttribute>> coded(
        count, fail(ErrorCode::internal, "an attribute is not encoded"));
    for_each_item(count, threads, [&](std::size_t i, unsigned worker) {
      const AttributeView a = mesh_.attributes[i];
      if (worker == 0)
        progress(a.name, 0.4 + 0.6 * static_cast<double>(i) / static_cast<double>(count));
      if (ways[i].empty()) {
        const Attribute own = &permuted_ones[i] == position ? Attribute() : permute(a, faces);
        const Attribute& values = &permuted_ones[i] == position ? *position : own;
        coded[i] = encode_attribute(values, {}, {surface, {}, position}, options_.level, plan(i));
      } else {
        coded[i] = encode_attribute(permuted_ones[i], std::move(ways[i]), faces.view, position,
                                    options_.level, plan(i));
      }
    });
    AttributeSums sums(info());
    for (std::size_t i = 0; i < count; ++i) {
      if (!coded[i]) return Failure{coded[i].error()};
      const std::uint64_t values = coded[i]->info.count;
      sums.add(i, std::move(coded[i]->info), values);
      put(SectionKind::attribute, std::move(coded[i]->bytes));
    }
    return Done{};
  }

  const MeshView mesh_;
  const EncodeOptions& options_;
  const std::span<const AttributePlan> plans_;
  const Cycles all_;
  const RegularFaces regular_;
  std::uint32_t surface_vertices_ = 0;
  bool raw_ = false;  ///< faces are coded one by one
  EncodedStream folded_stream_, degenerate_stream_;
};

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
  MeshEncoder encoder(mesh, options, plans);
  if (auto ok = encoder.run(threads, progress); !ok) return Failure{ok.error()};
  return std::move(encoder.result);
}

}  // namespace clers::internal
