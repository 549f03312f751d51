// Corners are decoded where they belong if that can be; else pieces are decoded and copied there.
#include "codec/file/target_decoder.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "codec/base/check.h"
#include "codec/base/faces.h"
#include "codec/file/decode_jobs.h"
#include "codec/file/decode_meshes.h"
#include "codec/file/mesh_decoder.h"
#include "codec/soup/edges.h"
#include "topology/ids.h"

namespace clers::internal {
namespace {

constexpr std::uint64_t each = sizeof(std::uint32_t);

Failure<Error> refused(std::string what) {
  return fail(ErrorCode::bad_option, std::move(what));
}

/// Memory for so many elements, if any is given.
Expected<Done> check_size(const char* what, std::size_t given, std::uint64_t expected) {
  if (given == 0 || given == expected) return Done{};
  return refused("memory for " + std::to_string(given) + " " + what + ", expected " +
                 std::to_string(expected));
}

std::string type_of(Scalar scalar, unsigned components) {
  return std::to_string(components) + " " + name(scalar);
}

/// The attribute that a target is for, by its number in a piece.
Expected<std::size_t> find(const MeshSections& mesh, const AttributeTarget& target) {
  if (const std::string defect =
          kind_defect({{}, target.domain, target.scalar, target.components, {}, 0});
      !defect.empty())
    return refused("memory for an attribute of " + defect);
  const auto& attributes = mesh.pieces[0].attributes;
  const auto found = std::find_if(attributes.begin(), attributes.end(), [&](const auto& a) {
    return a.header.attribute.name == target.name && a.header.attribute.domain == target.domain;
  });
  if (found == attributes.end())
    return refused(std::string("no ") + name(target.domain) + " attribute \"" +
                   std::string(target.name) + "\" in the mesh");
  const std::string prefix = "attribute \"" + std::string(target.name) + "\" ";
  const Attribute& a = found->header.attribute;
  if (a.scalar != target.scalar || a.components != target.components)
    return refused(prefix + "has values of " + type_of(a.scalar, a.components) +
                   ", memory is for " + type_of(target.scalar, target.components));
  const std::uint64_t count = mesh.count(a.domain), size = a.stride(), step = target.step();
  if (step < size)
    return refused(prefix + "has values of " + std::to_string(size) +
                   " bytes, memory is for one in " + std::to_string(step));
  if (!holds_values(target.data.size(), count, size, step))
    return refused(prefix + "has memory of " + std::to_string(target.data.size()) +
                   " bytes, expected " + std::to_string(count) + " times " + std::to_string(step));
  return static_cast<std::size_t>(found - attributes.begin());
}

Expected<Done> check_target(const MeshSections& mesh, const MeshTarget& target) {
  if (!target.corners.empty() && !target.corners_16.empty())
    return refused("memory for corners of 16 and of 32 bits, expected one of the two");
  for (const auto& ok : {check_size("corners", target.corners.size(), mesh.corners),
                         check_size("corners", target.corners_16.size(), mesh.corners),
                         check_size("face sizes", target.face_sizes.size(), mesh.faces),
                         check_size("opposites", target.opposites.size(), mesh.corners)})
    if (!ok) return ok;
  if (!target.corners_16.empty() && mesh.vertices > 0x10000)
    return refused(std::to_string(mesh.vertices) +
                   " vertices, 16 bits have numbers for at most 65536");
  return Done{};
}

/// The mesh with some of its attributes only, and what these need.
MeshSections with_attributes(const MeshSections& mesh, const std::vector<bool>& wanted) {
  MeshSections result = mesh;
  for (PieceSections& piece : result.pieces) piece.keep_attributes(wanted);
  return result;
}

std::uint64_t sections_memory(const MeshSections& mesh, std::size_t attributes) {
  std::uint64_t names = 0;
  for (const auto& a : mesh.pieces[0].attributes) names += a.header.attribute.name.size();
  const std::uint64_t most = std::max(attributes, mesh.pieces[0].attributes.size());
  return sizeof(MeshSections) + mesh.name.size() +
         mesh.pieces.size() *
             (sizeof(PieceSections) + 3 * most * sizeof(PieceSections::AttributeSection) +
              256 * attributes) +
         mesh.pieces.size() * names;
}

/// Opposites by the ends of edges.
void match(const Faces& faces, std::uint32_t vertices, std::span<std::uint32_t> opposites) {
  std::fill(opposites.begin(), opposites.end(), MeshTarget::no_opposite);
  for_each_edge(faces, vertices, [&](std::span<const std::uint32_t> sides) {
    if (sides.size() != 2 || faces.org[sides[0]] == faces.org[sides[1]]) return;
    opposites[sides[0]] = sides[1];
    opposites[sides[1]] = sides[0];
  });
}

Expected<Done> check_triangles(const Mesh& mesh, const MeshTarget& target) {
  if (mesh.triangles_only() || target.corners.empty() || !target.face_sizes.empty()) return Done{};
  return refused("not all faces are triangles, expected memory for face sizes");
}

/// Calls decode(k) for all pieces, several at a time as far as the budget allows; piece k takes
/// work[k] bytes. The first error, in the order of the pieces.
template <class Decode>
Expected<Done> for_each_piece(const MeshSections& mesh, std::vector<std::uint64_t> work,
                              const DecodeOptions& options, Budget& budget, Decode decode) {
  const std::size_t pieces = mesh.pieces.size();
  if (auto ok = budget.take(pieces * sizeof(Expected<Done>)); !ok) return ok;
  if (auto ok = budget.check(*std::max_element(work.begin(), work.end())); !ok) return ok;
  for (const auto& ok : run_decode_jobs(std::move(work), budget.left(), options, decode))
    if (!ok) return ok;
  return Done{};
}

/// Whether corners can be decoded where they belong: all faces are triangles of the surface.
bool all_on_surface(const MeshSections& mesh) {
  return !mesh.has_order &&
         std::all_of(mesh.pieces.begin(), mesh.pieces.end(), [](const PieceSections& piece) {
           return !piece.may_have_sizes() && !piece.is_welded() &&
                  piece.faces == piece.surface_faces;
         });
}

/// Corners of triangles, and nothing else. Returns whether opposites are there too.
Expected<bool> decode_in_place(const MeshSections& mesh, const MeshTarget& target,
                               const DecodeOptions& options, Budget& budget) {
  const bool alone = mesh.pieces.size() == 1;
  const bool with_twins = alone && mesh.pieces[0].features == 0 && !target.opposites.empty();
  std::vector<HalfEdge> twins;
  if (with_twins) {
    if (auto ok = budget.take(each * mesh.corners); !ok) return Failure{ok.error()};
    twins.resize(static_cast<std::size_t>(mesh.corners));
  }
  if (auto ok = budget.take(2 * sizeof(std::uint64_t) * mesh.pieces.size()); !ok)
    return Failure{ok.error()};
  std::vector<std::uint64_t> work;
  work.reserve(mesh.pieces.size());
  for (const PieceSections& piece : mesh.pieces)
    work.push_back(memory_of(piece, Values::skip).peak() - piece.corners * each +
                   (alone ? 0 : numbering_memory(piece)) +
                   connectivity_memory(piece.connectivity, with_twins) -
                   connectivity_memory(piece.connectivity, false));
  const auto ok =
      for_each_piece(mesh, std::move(work), options, budget, [&](std::size_t k) -> Expected<Done> {
        const PieceSections& piece = mesh.pieces[k];
        const auto own = target.corners.subspan(static_cast<std::size_t>(piece.first_corner),
                                                static_cast<std::size_t>(piece.corners));
        if (auto decoded = decode_triangles(piece, own, twins); !decoded) return decoded;
        if (alone) return Done{};
        if (auto numbers = number_piece(piece, own); !numbers) return Failure{numbers.error()};
        return Done{};
      });
  if (!ok) return Failure{ok.error()};
  for (std::size_t h = 0; h < twins.size(); ++h) target.opposites[h] = twins[h].index();
  return with_twins;
}

/// `attribute_of`: which attribute of the mesh each of the target takes.
void copy(const Mesh& mesh, const MeshTarget& target, std::span<const std::size_t> attribute_of) {
  if (!target.corners.empty())
    std::copy(mesh.corners.begin(), mesh.corners.end(), target.corners.begin());
  if (!target.face_sizes.empty()) put_sizes(mesh, target.face_sizes);
  for (std::size_t i = 0; i < target.attributes.size(); ++i) {
    const AttributeTarget& a = target.attributes[i];
    put_values(mesh.attributes[attribute_of[i]], a.data.data(), a.step());
  }
}

/// Anything, but no opposites and no 16-bit corners. `attribute_of` as for copy.
Expected<Done> decode_and_copy(const MeshSections& mesh, const MeshTarget& target,
                               std::span<const std::size_t> attribute_of,
                               const DecodeOptions& options, Budget& budget) {
  if (mesh.has_order) {
    const auto meshes = decode_meshes({&mesh, 1}, Values::decode, options, budget);
    if (!meshes) return Failure{meshes.error()};
    if (auto ok = check_triangles(meshes->front(), target); !ok) return ok;
    copy(meshes->front(), target, attribute_of);
    return Done{};
  }
  const bool alone = mesh.pieces.size() == 1;
  if (auto ok = budget.take(2 * sizeof(std::uint64_t) * mesh.pieces.size()); !ok) return ok;
  std::vector<std::uint64_t> work;
  work.reserve(mesh.pieces.size());
  for (const PieceSections& piece : mesh.pieces)
    work.push_back(memory_of(piece, Values::decode).peak() +
                   (alone ? 0 : numbering_memory(piece) + each * piece.corners));
  return for_each_piece(
      mesh, std::move(work), options, budget, [&](std::size_t k) -> Expected<Done> {
        const PieceSections& sections = mesh.pieces[k];
        const auto piece =
            decode_piece(sections, Values::decode, alone ? options.threads : 1, budget.left());
        if (!piece) return Failure{piece.error()};
        if (auto ok = check_triangles(piece->mesh, target); !ok) return ok;
        if (!alone) return put_piece(sections, piece->mesh, target, attribute_of);
        copy(piece->mesh, target, attribute_of);
        return Done{};
      });
}

}  // namespace

Expected<Done> decode_into(const MeshSections& mesh, const MeshTarget& target,
                           const DecodeOptions& options, Budget& budget) {
  if (auto ok = check_target(mesh, target); !ok) return ok;
  std::vector<std::size_t> wanted;
  wanted.reserve(target.attributes.size());
  for (const AttributeTarget& attribute : target.attributes) {
    const auto found = find(mesh, attribute);
    if (!found) return Failure{found.error()};
    wanted.push_back(*found);
  }
  if (target.corners.empty() && target.corners_16.empty() && target.face_sizes.empty() &&
      target.opposites.empty() && wanted.empty())
    return Done{};

  MeshTarget inner = target;
  std::vector<std::uint32_t> corners;
  if (target.corners.empty() && (!target.corners_16.empty() || !target.opposites.empty())) {
    if (auto ok = budget.take(each * mesh.corners); !ok) return ok;
    corners.resize(static_cast<std::size_t>(mesh.corners));
    inner.corners = corners;
  }
  const bool sizes = !target.face_sizes.empty();
  const std::uint64_t matching = target.opposites.empty()
                                     ? 0
                                     : edges_memory(mesh.corners, mesh.vertices) +
                                           Faces::memory(mesh.corners, mesh.faces, sizes);
  if (auto ok = budget.check(matching); !ok) return ok;
  bool matched = false;
  if (wanted.empty() && !inner.corners.empty() && all_on_surface(mesh)) {
    const auto in_place = decode_in_place(mesh, inner, options, budget);
    if (!in_place) return Failure{in_place.error()};
    matched = *in_place;
    std::fill(inner.face_sizes.begin(), inner.face_sizes.end(), 3u);
  } else {
    if (auto ok = budget.take(sections_memory(mesh, wanted.size())); !ok) return ok;
    // What is asked for twice is decoded once.
    std::vector<bool> is_wanted(mesh.pieces[0].attributes.size());
    for (const std::size_t i : wanted) is_wanted[i] = true;
    for (std::size_t& i : wanted)
      i = static_cast<std::size_t>(
          std::count(is_wanted.begin(), is_wanted.begin() + static_cast<std::ptrdiff_t>(i), true));
    if (auto ok = decode_and_copy(with_attributes(mesh, is_wanted), inner, wanted, options, budget);
        !ok)
      return ok;
  }
  if (!target.opposites.empty() && !matched)
    match(Faces(inner.corners, inner.face_sizes), static_cast<std::uint32_t>(mesh.vertices),
          target.opposites);
  std::transform(
      corners.begin(), corners.begin() + static_cast<std::ptrdiff_t>(target.corners_16.size()),
      target.corners_16.begin(), [](std::uint32_t v) { return static_cast<std::uint16_t>(v); });
  if (options.progress) options.progress("done", 1.0);
  return Done{};
}

}  // namespace clers::internal
