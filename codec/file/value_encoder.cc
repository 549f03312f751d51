// Positions and the structures of all attributes one by one, then values side by side.
#include "codec/file/value_encoder.h"

#include <cstring>
#include <optional>
#include <string_view>
#include <utility>

#include "codec/attributes/attribute_format.h"
#include "codec/attributes/face_surface.h"
#include "codec/attributes/structure_encoder.h"
#include "codec/base/parallel.h"
#include "codec/file/permutation.h"

namespace clers::internal {
namespace {

/// Elements in the order in which they are coded.
Attribute in_coded_order(const AttributeView& a, const CodedMesh& mesh) {
  Attribute moved = permuted(a, mesh.faces, mesh.order);
  if (a.domain != Domain::corner) return moved;
  if (a.indices.empty())
    reverse_runs(moved.data, a.value_size(), mesh.coded.sizes, mesh.reversed);
  else
    reverse_runs(moved.indices, mesh.coded.sizes, mesh.reversed);
  return moved;
}

/// Makes values of places of those of points that are there, if these are equal.
bool weld(Attribute& a, std::uint32_t places, std::span<const std::uint32_t> place_of) {
  const std::size_t stride = a.stride();
  std::vector<std::byte> data(places * stride);
  const auto at_place = [&](std::size_t p) { return data.data() + place_of[p] * stride; };
  const auto own = [&](std::size_t p) { return a.data.data() + p * stride; };
  for (std::size_t p = 0; p < place_of.size(); ++p) std::memcpy(at_place(p), own(p), stride);
  for (std::size_t p = 0; p < place_of.size(); ++p)
    if (std::memcmp(at_place(p), own(p), stride) != 0) return false;
  a.data = std::move(data);
  return true;
}

/// The joints of the weights of this name, if they can be known where these are decoded.
std::optional<Attribute> joints_in_coded_order(const CodedMesh& mesh, std::string_view weights,
                                               bool at_places,
                                               std::span<const AttributePlan> plans) {
  const AttributeViews& attributes = mesh.mesh.attributes;
  for (std::size_t i = 0; i < attributes.size(); ++i) {
    const AttributeView a = attributes[i];
    if (a.domain != Domain::vertex || !are_joints_of(a.name, weights)) continue;
    if (may_have_structure(a) || (!plans.empty() && !plans[i].systems.empty())) return {};
    Attribute joints = in_coded_order(a, mesh);
    const bool welded =
        mesh.points != nullptr && weld(joints, mesh.coded.vertices, mesh.points->place_of);
    if (welded != at_places) return {};
    return joints;
  }
  return {};
}

}  // namespace

Expected<std::vector<EncodedAttribute>> encode_values(const CodedMesh& mesh,
                                                      const EncodeOptions& options,
                                                      std::span<const AttributePlan> plans,
                                                      unsigned threads, const Progress& progress) {
  const AttributeViews& attributes = mesh.mesh.attributes;
  const std::size_t count = attributes.size();
  ValueArrays of_points;
  CodedFaces of_vertices = mesh.coded;
  if (mesh.points != nullptr) {
    of_points = make_value_surface(mesh.coded, Domain::corner, mesh.points->structure,
                                   mesh.mesh.vertex_count);
    of_vertices.surface = of_points.surface.view();
    of_vertices.vertices = mesh.mesh.vertex_count;
    of_vertices.place_of = mesh.points->place_of;
  }

  // Which corners share values is found first: seams of one attribute are often those of others.
  std::vector<Attribute> moved(count);
  std::vector<std::vector<EncodedStructure>> ways(count);
  std::size_t position = count;
  Seams beside;
  if (mesh.points != nullptr) beside = mesh.points->structure.seams;
  for (std::size_t i = 0; i < count; ++i) {
    const AttributeView a = attributes[i];
    if (position == count && a.domain == Domain::vertex && a.name == position_name) {
      position = i;
      moved[i] = in_coded_order(a, mesh);
      if (mesh.points != nullptr) weld(moved[i], mesh.coded.vertices, mesh.points->place_of);
      continue;
    }
    if (!may_have_structure(a)) continue;
    moved[i] = in_coded_order(a, mesh);
    const bool keep = options.order == Order::keep && !a.indices.empty();
    ways[i] = encode_structures(
        moved[i], a.domain == Domain::vertex ? of_vertices : mesh.coded,
        keep ? kept_numbering(a.indices, a.value_count()) : std::vector<std::uint32_t>(),
        beside.empty() ? nullptr : &beside, options.level);
    // Where it is left open whether there are any, those after it do without.
    if (a.domain == Domain::corner) beside = ways[i][0].structure.seams;
  }
  const Attribute* const places = position < count ? &moved[position] : nullptr;

  std::vector<Expected<EncodedAttribute>> coded(
      count, fail(ErrorCode::internal, "an attribute is not encoded"));
  for_each_item(count, threads, [&](std::size_t i, unsigned worker) {
    const AttributeView a = attributes[i];
    if (worker == 0)
      progress(a.name, 0.4 + 0.6 * static_cast<double>(i) / static_cast<double>(count));
    const AttributePlan plan = plans.empty() ? AttributePlan{} : plans[i];
    if (!ways[i].empty()) {
      coded[i] = encode_attribute(moved[i], std::move(ways[i]),
                                  a.domain == Domain::vertex ? of_vertices : mesh.coded, places,
                                  options.level, plan);
      return;
    }
    StructureHeader structure;
    structure.at_places = mesh.points != nullptr && i == position;
    if (i != position) {
      moved[i] = in_coded_order(a, mesh);
      if (mesh.points != nullptr && a.domain == Domain::vertex)
        structure.at_places = weld(moved[i], mesh.coded.vertices, mesh.points->place_of);
    }
    const CodedFaces& along =
        a.domain == Domain::vertex && !structure.at_places ? of_vertices : mesh.coded;
    const std::optional<Attribute> joints =
        options.level < first_level_with_twins || i == position || a.domain != Domain::vertex
            ? std::nullopt
            : joints_in_coded_order(mesh, a.name, structure.at_places, plans);
    ValueSurface values_along{
        along.surface, along.place_of, places, {}, joints ? &*joints : nullptr};
    std::optional<FaceSurface> of_faces;
    if (may_be_predicted_by_faces(a, options.level))
      values_along = of_faces.emplace(mesh.coded).view(places);
    coded[i] = encode_attribute(moved[i], structure, values_along, options.level, plan);
    if (coded[i]) coded[i]->info.count = mesh.mesh.value_count(a.domain);
    if (i != position) moved[i] = {};
  });
  std::vector<EncodedAttribute> result;
  for (auto& attribute : coded) {
    if (!attribute) return Failure{attribute.error()};
    result.push_back(std::move(*attribute));
  }
  return result;
}

}  // namespace clers::internal
