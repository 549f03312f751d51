// Memory of C as a MeshTarget; a piece copied into it.
#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include "bindings/c/decoder.h"
#include "codec/base/holds_values.h"
#include "codec/mesh_target.h"
#include "codec/piece.h"

namespace clers::internal {
namespace {

static_assert(CLERS_NONE == MeshTarget::no_opposite);

Expected<AttributeTarget> attribute_target_of(const clers_attribute_target& given) {
  if (given.domain < 0 || given.domain > CLERS_FACE)
    return bad_option("no domain " + std::to_string(given.domain));
  if (given.scalar < 0 || given.scalar > CLERS_FLOAT64)
    return bad_option("no scalar " + std::to_string(given.scalar));
  if (given.components > 255)
    return bad_option(std::to_string(given.components) + " components, expected 1 to 255");
  AttributeTarget target;
  target.name = given.name == nullptr ? std::string_view() : std::string_view(given.name);
  target.domain = static_cast<Domain>(given.domain);
  target.scalar = static_cast<Scalar>(given.scalar);
  target.components = static_cast<std::uint8_t>(given.components);
  target.data = array_of(static_cast<std::byte*>(given.data), given.data_size);
  target.stride = given.stride;
  return target;
}

/// `attributes` takes those that the target names.
Expected<MeshTarget> target_of(const clers_target* given,
                               std::vector<AttributeTarget>& attributes) {
  const auto taken = internal::taken(given, "a clers_target");
  if (!taken) return Failure{taken.error()};
  const auto all = Structs<clers_attribute_target>::of(taken->attributes, taken->attribute_count,
                                                       "a clers_attribute_target");
  if (!all) return Failure{all.error()};
  for (std::size_t i = 0; i < all->size(); ++i) {
    const auto attribute = attribute_target_of((*all)[i]);
    if (!attribute) return Failure{attribute.error()};
    attributes.push_back(*attribute);
  }
  MeshTarget target;
  target.corners = array_of(taken->corners, taken->corner_count);
  target.corners_16 = array_of(taken->corners_16, taken->corner_count);
  target.opposites = array_of(taken->opposites, taken->corner_count);
  target.face_sizes = array_of(taken->face_sizes, taken->face_count);
  target.attributes = attributes;
  return target;
}

// ---- A piece

/// Memory for so many elements, if any is given.
Expected<Done> check_count(const char* what, std::size_t given, std::size_t expected) {
  if (given == 0 || given == expected) return Done{};
  return bad_option("memory for " + std::to_string(given) + " " + what + ", expected " +
                    std::to_string(expected));
}

Expected<const Attribute*> attribute_for(const Mesh& mesh, const AttributeTarget& target) {
  const auto found = std::find_if(
      mesh.attributes.begin(), mesh.attributes.end(),
      [&](const Attribute& a) { return a.name == target.name && a.domain == target.domain; });
  const std::string title =
      std::string(name(target.domain)) + " attribute \"" + std::string(target.name) + "\"";
  if (found == mesh.attributes.end()) return bad_option("no " + title + " in the piece");
  if (found->scalar != target.scalar || found->components != target.components)
    return bad_option(title + " has values of " + std::to_string(found->components) + " " +
                      name(found->scalar) + ", memory is for others");
  const std::size_t count = mesh.value_count(target.domain), size = found->stride();
  if (target.step() < size || !holds_values(target.data.size(), count, size, target.step()))
    return bad_option(title + " has memory of " + std::to_string(target.data.size()) +
                      " bytes, expected " + std::to_string(count) + " times " +
                      std::to_string(std::max(target.step(), size)));
  return &*found;
}

/// Precondition: attribute_for.
void put_values(const Attribute& from, std::size_t count, const AttributeTarget& to) {
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t value = from.indices.empty() ? i : from.indices[i];
    if (value == no_value) continue;
    std::memcpy(to.data.data() + i * to.step(), from.data.data() + value * from.stride(),
                from.stride());
  }
}

void put_sizes(const Mesh& from, std::span<std::uint32_t> to) {
  if (from.triangles_only())
    std::fill(to.begin(), to.end(), 3u);
  else
    std::copy(from.face_sizes.begin(), from.face_sizes.end(), to.begin());
}

/// The number that each vertex of a piece has in the mesh.
void put_numbers(const Piece& piece, std::uint32_t* numbers) {
  auto shared = piece.seam.begin();
  std::uint32_t next = piece.first_vertex;
  for (std::uint32_t v = 0; v < piece.mesh.vertex_count; ++v)
    numbers[v] = shared != piece.seam.end() && shared->vertex == v ? shared++->number : next++;
}

Expected<Done> put_piece(const Piece& piece, const MeshTarget& target, std::uint32_t* numbers) {
  const Mesh& mesh = piece.mesh;
  if (!target.opposites.empty()) return bad_option("opposites of a piece, which it has not");
  if (!target.corners.empty() && !target.corners_16.empty())
    return bad_option("memory for corners of 16 and of 32 bits, expected one of the two");
  for (const auto& ok : {check_count("corners", target.corners.size(), mesh.corners.size()),
                         check_count("corners", target.corners_16.size(), mesh.corners.size()),
                         check_count("face sizes", target.face_sizes.size(), mesh.face_count())})
    if (!ok) return ok;
  if (!target.corners_16.empty() && mesh.vertex_count > 0x10000)
    return bad_option(std::to_string(mesh.vertex_count) +
                      " vertices, 16 bits have numbers for at most 65536");
  if (!mesh.triangles_only() && target.face_sizes.empty() &&
      !(target.corners.empty() && target.corners_16.empty()))
    return bad_option("not all faces are triangles, expected memory for face sizes");
  for (const AttributeTarget& to : target.attributes) {
    const auto from = attribute_for(mesh, to);
    if (!from) return Failure{from.error()};
    put_values(**from, mesh.value_count(to.domain), to);
  }
  std::copy_n(mesh.corners.begin(), target.corners.size(), target.corners.begin());
  std::transform(mesh.corners.begin(),
                 mesh.corners.begin() + static_cast<std::ptrdiff_t>(target.corners_16.size()),
                 target.corners_16.begin(),
                 [](std::uint32_t v) { return static_cast<std::uint16_t>(v); });
  if (!target.face_sizes.empty()) put_sizes(mesh, target.face_sizes);
  if (numbers != nullptr) put_numbers(piece, numbers);
  return Done{};
}

}  // namespace
}  // namespace clers::internal

using namespace clers::internal;
using clers::Done;
using clers::Expected;
using clers::Failure;

clers_code clers_decode(const clers_decoder* decoder, std::size_t mesh, const clers_target* target,
                        clers_error* error) {
  return guarded_for_c(error, [&]() -> Expected<Done> {
    const auto found = mesh_info(decoder, mesh);
    if (!found) return Failure{found.error()};
    std::vector<clers::AttributeTarget> attributes;
    const auto into = target_of(target, attributes);
    if (!into) return Failure{into.error()};
    return decoder->decoder.decode_into(mesh, *into);
  });
}

clers_code clers_decode_attribute(const clers_decoder* decoder, std::size_t mesh,
                                  std::size_t attribute, void* data, std::size_t size,
                                  clers_error* error) {
  return guarded_for_c(error, [&]() -> Expected<Done> {
    const auto in = mesh_info(decoder, mesh);
    if (!in) return Failure{in.error()};
    const auto found = attribute_info(**in, attribute);
    if (!found) return Failure{found.error()};
    const clers::AttributeInfo& a = **found;
    for (std::size_t i = 0; i < attribute; ++i) {
      const clers::AttributeInfo& before = (*in)->attributes[i];
      if (before.name == a.name && before.domain == a.domain)
        return clers::fail(clers::ErrorCode::unsupported,
                           "attribute " + std::to_string(attribute) +
                               " has the name and domain of attribute " + std::to_string(i));
    }
    const clers::AttributeTarget one[] = {{a.name, a.domain, a.scalar, a.components,
                                           array_of(static_cast<std::byte*>(data), size), 0}};
    clers::MeshTarget target;
    target.attributes = one;
    return decoder->decoder.decode_into(mesh, target);
  });
}

clers_code clers_decode_piece(const clers_decoder* decoder, std::size_t piece,
                              const clers_target* target, std::uint32_t* numbers,
                              clers_error* error) {
  return guarded_for_c(error, [&]() -> Expected<Done> {
    if (decoder == nullptr) return bad_option("no decoder");
    std::vector<clers::AttributeTarget> attributes;
    const auto into = target_of(target, attributes);
    if (!into) return Failure{into.error()};
    const auto decoded = decoder->decoder.decode_piece(piece);
    if (!decoded) return Failure{decoded.error()};
    return put_piece(*decoded, *into, numbers);
  });
}
