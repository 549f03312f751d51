// Meshes and options of C as those of C++, and how many bytes their file may take.
#include "codec/encode.h"

#include <algorithm>
#include <cstring>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "bindings/c/structs.h"
#include "codec/mesh_view.h"
#include "codec/options.h"
#include "codec/scalar.h"
#include <clers/version.h>

namespace clers::internal {
namespace {

static_assert(CLERS_NONE == no_value && CLERS_NONE == never_in_pieces);
static_assert(CLERS_VERTEX == static_cast<int>(Domain::vertex) &&
              CLERS_CORNER == static_cast<int>(Domain::corner) &&
              CLERS_FACE == static_cast<int>(Domain::face) && domain_count == 3);
static_assert(CLERS_INT8 == static_cast<int>(Scalar::int8) &&
              CLERS_FLOAT64 == static_cast<int>(Scalar::float64) && scalar_count == 10);
static_assert(CLERS_ORDER_KEEP == static_cast<int>(Order::keep) &&
              CLERS_REJECT == static_cast<int>(DefectPolicy::reject));

struct GivenMesh {
  MeshView view;
  std::vector<AttributeView> attributes;  ///< that the view names
  clers_mesh given;
};

std::string_view text_of(const char* text) {
  return text == nullptr ? std::string_view() : std::string_view(text);
}

/// What C++ has as one byte.
template <class Enum>
Expected<Enum> enum_of(std::int32_t value, std::int32_t last, const char* what) {
  if (value < 0 || value > last)
    return bad_option("no " + std::string(what) + " " + std::to_string(value));
  return static_cast<Enum>(value);
}

Expected<Precision> precision_of(const clers_attribute& a) {
  const auto kind = enum_of<std::uint8_t>(a.precision, CLERS_RECOMPUTED, "precision");
  if (!kind) return Failure{kind.error()};
  switch (*kind) {
    case CLERS_BITS: return Precision::of_bits(a.bits);
    case CLERS_STEP: return Precision::of_step(a.amount);
    case CLERS_ERROR: return Precision::of_error(a.amount);
    case CLERS_GRID: {
      const auto origin = array_of(a.origin, a.origin_count);
      return Precision::on_grid({origin.begin(), origin.end()}, a.amount);
    }
    case CLERS_DIRECTIONS: return Precision::of_directions(a.bits);
    case CLERS_RECOMPUTED: return Precision::recomputed(a.amount);
    default: return Precision::lossless();
  }
}

Expected<AttributeView> attribute_of(const clers_attribute& a, const MeshView& mesh) {
  AttributeView view;
  view.name = text_of(a.name);
  const auto domain = enum_of<Domain>(a.domain, CLERS_FACE, "domain");
  if (!domain) return Failure{domain.error()};
  const auto scalar = enum_of<Scalar>(a.scalar, CLERS_FLOAT64, "scalar");
  if (!scalar) return Failure{scalar.error()};
  if (a.components < 1 || a.components > 255)
    return bad_option(std::to_string(a.components) + " components, expected 1 to 255");
  view.domain = *domain;
  view.scalar = *scalar;
  view.components = static_cast<std::uint8_t>(a.components);
  view.data = bytes_of(a.data, a.data_size);
  view.stride = a.stride;
  view.indices = array_of(a.indices, mesh.value_count(view.domain));
  return view;
}

/// All but attributes.
Expected<MeshView> faces_of(const clers_mesh& mesh) {
  MeshView view;
  view.vertex_count = mesh.vertex_count;
  view.corners = array_of(mesh.corners, mesh.corner_count);
  view.corners_16 = array_of(mesh.corners_16, mesh.corner_count);
  view.face_sizes = array_of(mesh.face_sizes, mesh.face_count);
  view.name = text_of(mesh.name);
  if (mesh.corner_count > 0 && (mesh.corners == nullptr) == (mesh.corners_16 == nullptr))
    return bad_option("corners of 16 and of 32 bits, or neither, expected one of the two");
  if (mesh.face_sizes == nullptr && mesh.face_count > 0 && mesh.face_count != mesh.corner_count / 3)
    return bad_option(std::to_string(mesh.face_count) + " faces of " +
                      std::to_string(mesh.corner_count) + " corners, and no sizes of faces");
  return view;
}

/// `precisions` takes what is asked for attributes, once for each name and domain.
Expected<GivenMesh> mesh_of(const clers_mesh& given, std::vector<AttributePrecision>& precisions) {
  GivenMesh mesh{{}, {}, given};
  const auto faces = faces_of(given);
  if (!faces) return Failure{faces.error()};
  mesh.view = *faces;
  const auto attributes =
      Structs<clers_attribute>::of(given.attributes, given.attribute_count, "a clers_attribute");
  if (!attributes) return Failure{attributes.error()};
  mesh.attributes.reserve(attributes->size());
  for (std::size_t i = 0; i < attributes->size(); ++i) {
    const clers_attribute a = (*attributes)[i];
    const auto view = attribute_of(a, mesh.view);
    if (!view) return Failure{view.error()};
    auto precision = precision_of(a);
    if (!precision) return Failure{precision.error()};
    mesh.attributes.push_back(*view);
    const auto before =
        std::find_if(precisions.begin(), precisions.end(), [&](const AttributePrecision& p) {
          return p.name == view->name && p.domain == view->domain;
        });
    if (before == precisions.end())
      precisions.push_back({std::string(view->name), std::move(*precision), view->domain});
    else if (!(before->precision == *precision))
      return bad_option("two precisions for attributes \"" + before->name + "\"");
  }
  return mesh;
}

struct Given {
  std::vector<GivenMesh> meshes;
  EncodeOptions options;
};

Expected<EncodeOptions> options_of(const clers_encode_options* given) {
  const auto taken = taken_or_default(given, "clers_encode_options");
  if (!taken) return Failure{taken.error()};
  EncodeOptions options;
  if (taken->level != 0) options.level = taken->level;
  if (taken->piece_faces != 0) options.piece_faces = taken->piece_faces;
  options.threads = taken->threads == CLERS_EVERY_CORE ? 0 : std::max(taken->threads, 1u);
  const auto order = enum_of<Order>(taken->order, CLERS_ORDER_KEEP, "order");
  if (!order) return Failure{order.error()};
  options.order = *order;
  for (const auto& [value, policy] : {std::pair(taken->on_nonmanifold, &options.on_nonmanifold),
                                      std::pair(taken->on_degenerate, &options.on_degenerate),
                                      std::pair(taken->on_duplicate, &options.on_duplicate)}) {
    const auto on = enum_of<DefectPolicy>(value, CLERS_REJECT, "policy for defects");
    if (!on) return Failure{on.error()};
    *policy = *on;
  }
  return options;
}

Expected<Given> given_of(const clers_mesh* meshes, std::size_t count,
                         const clers_encode_options* options) {
  const auto structs = Structs<clers_mesh>::of(meshes, count, "a clers_mesh");
  if (!structs) return Failure{structs.error()};
  auto taken = options_of(options);
  if (!taken) return Failure{taken.error()};
  Given given{{}, std::move(*taken)};
  std::vector<AttributePrecision> precisions;
  for (std::size_t i = 0; i < structs->size(); ++i) {
    auto mesh = mesh_of((*structs)[i], precisions);
    if (!mesh) return Failure{mesh.error()};
    given.meshes.push_back(std::move(*mesh));
  }
  for (AttributePrecision& p : precisions)
    if (!(p.precision == Precision::lossless())) given.options.precisions.push_back(std::move(p));
  for (GivenMesh& mesh : given.meshes) mesh.view.attributes = mesh.attributes;
  return given;
}

/// Bytes that are enough, as a number that no sizes make overflow.
double bound_of(const GivenMesh& mesh, const EncodeOptions& options) {
  const auto real = [](std::size_t n) { return static_cast<double>(n); };
  const MeshView& view = mesh.view;
  const double corners = real(view.corner_count()), faces = real(view.face_count());
  const double vertices = real(view.vertex_count);
  // Pieces have heads of their own, and shared vertices once more: in the worst case, as many as
  // there are corners.
  const double piece = options.piece_faces ? real(*options.piece_faces) : real(default_piece_faces);
  const bool in_pieces =
      options.piece_faces ? faces > piece : faces > real(most_faces_whole) && view.position();
  const double pieces = in_pieces ? 1 + std::min(faces, 4 * faces / piece) : 1;
  double bytes = 256 + real(view.name.size()) + pieces * 256 + 6 * corners + faces + vertices;
  if (!view.triangles_only()) bytes += 6 * faces;
  if (in_pieces) bytes += 6 * std::min(vertices, corners) + corners;
  if (options.order == Order::keep) bytes += 6 * (faces + vertices);
  for (const AttributeView& a : mesh.attributes) {
    const bool exact = options.precision_of(a.name, a.domain) == Precision::lossless();
    double count = real(view.value_count(a.domain));
    if (in_pieces && a.domain == Domain::vertex) count += corners;
    // A grid may be far finer than what values are stored in.
    const double value = (exact ? real(size_of(a.scalar)) : 16.) * a.components;
    bytes += pieces * (256 + real(a.name.size()) + 64. * a.components) + 2 * count * value;
    if (!a.indices.empty()) bytes += 8 * count + 2 * real(a.data.size());
  }
  return bytes;
}

Expected<Done> encode_into(const Given& given, void* bytes, std::size_t capacity,
                           std::size_t* size) {
  std::vector<MeshView> views;
  for (const GivenMesh& mesh : given.meshes) views.push_back(mesh.view);
  if (size == nullptr || (bytes == nullptr && capacity > 0))
    return bad_option("no memory for the file, or for its size");
  const auto encoded = encode(std::span<const MeshView>(views), given.options);
  if (!encoded) return Failure{encoded.error()};
  if (encoded->bytes.size() > capacity) {
    auto failure = fail(static_cast<ErrorCode>(CLERS_BUFFER_TOO_SMALL),
                        "the file takes " + std::to_string(encoded->bytes.size()) +
                            " bytes, there is memory for " + std::to_string(capacity));
    failure.error.needed = encoded->bytes.size();
    return failure;
  }
  std::memcpy(bytes, encoded->bytes.data(), encoded->bytes.size());
  *size = encoded->bytes.size();
  for (std::size_t i = 0; i < given.meshes.size(); ++i) {
    const clers_mesh& mesh = given.meshes[i].given;
    const Permutation& order = encoded->permutations[i];
    const auto put = [](const std::vector<std::uint32_t>& from, std::uint32_t* to) {
      if (to != nullptr) std::copy(from.begin(), from.end(), to);
    };
    put(order.vertices, mesh.old_vertices);
    put(order.faces, mesh.old_faces);
    put(order.first_corners, mesh.first_corners);
  }
  return Done{};
}

}  // namespace
}  // namespace clers::internal

using namespace clers::internal;

const char* clers_version(void) {
  return clers::version;
}

const char* clers_code_name(clers_code code) {
  if (code == CLERS_OK) return "ok";
  if (code == CLERS_BUFFER_TOO_SMALL) return "buffer_too_small";
  return name(static_cast<clers::ErrorCode>(code));
}

std::size_t clers_bound(const clers_mesh* meshes, std::size_t mesh_count,
                        const clers_encode_options* options) {
  double bytes = 256;
  const clers_code code = guarded_for_c(nullptr, [&]() -> clers::Expected<clers::Done> {
    const auto given = given_of(meshes, mesh_count, options);
    if (!given) return clers::Failure{given.error()};
    for (const GivenMesh& mesh : given->meshes) bytes += bound_of(mesh, given->options);
    return clers::Done{};
  });
  if (code != CLERS_OK || bytes >= static_cast<double>(SIZE_MAX)) return 0;
  return static_cast<std::size_t>(bytes);
}

clers_code clers_encode(const clers_mesh* meshes, std::size_t mesh_count,
                        const clers_encode_options* options, void* bytes, std::size_t capacity,
                        std::size_t* size, clers_error* error) {
  return guarded_for_c(error, [&]() -> clers::Expected<clers::Done> {
    const auto given = given_of(meshes, mesh_count, options);
    if (!given) return clers::Failure{given.error()};
    return encode_into(*given, bytes, capacity, size);
  });
}
