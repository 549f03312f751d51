// The doors: meshes with what files say of them, and what is told to people.
#include <exception>
#include <set>
#include <string>
#include <utility>

#include "codec/base/guarded.h"
#include "codec/base/utf8.h"
#include "codec/draco/decoded.h"
#include "codec/draco/draco.h"
#include "codec/draco/mesh_of.h"

namespace clers {
namespace CLERS_VISIBLE draco {
namespace {

constexpr std::size_t longest_key = 255;  // of metadata

/// Draco throws what containers throw; anything else is a fault of it.
template <class Work>
auto safely(const Work& work) -> decltype(work()) {
  try {
    return internal::guarded("decode Draco", work);
  } catch (const std::exception& e) {
    return fail(ErrorCode::malformed, std::string("Draco cannot decode it: ") + e.what());
  }
}

/// Adds what Draco's metadata say; keys that cannot be ours are counted instead.
class Entries {
 public:
  explicit Entries(Mesh& mesh) : mesh_(mesh) {}

  std::size_t left_out = 0;

  void add_all(const Decoded& decoded) {
    const ::draco::GeometryMetadata* metadata = decoded.points->GetMetadata();
    if (metadata == nullptr) return;
    add("draco", *metadata);
    for (const auto& of_attribute : metadata->attribute_metadatas()) {
      const std::int32_t i =
          decoded.points->GetAttributeIdByUniqueId(of_attribute->att_unique_id());
      if (i >= 0) add("draco." + mesh_.attributes[std::size_t(i)].name, *of_attribute);
    }
  }

  void add(const std::string& key, std::string value) {
    const bool good =
        key.size() <= longest_key && internal::is_utf8(key) && keys_.insert(key).second;
    if (good)
      mesh_.metadata.push_back({key, std::move(value)});
    else
      ++left_out;
  }

 private:
  void add(const std::string& above, const ::draco::Metadata& metadata) {
    for (const auto& [key, value] : metadata.entries())
      add(above + "." + key, std::string(value.data().begin(), value.data().end()));
    if (above.size() > longest_key) return;  // they may be nested without an end
    for (const auto& [key, sub] : metadata.sub_metadatas()) add(above + "." + key, *sub);
  }

  Mesh& mesh_;
  std::set<std::string> keys_;
};

std::string count(std::size_t n, const char* one, const char* many) {
  return std::to_string(n) + " " + (n == 1 ? one : many);
}

/// "position to 11 bits, normal to 8 bits"
std::string quantised(const Decoded& decoded, const Mesh& mesh) {
  std::string text;
  for (std::size_t i = 0; i < decoded.bits.size(); ++i) {
    const bool somehow = decoded.tree && is_float(mesh.attributes[i].scalar);
    if (decoded.bits[i] == 0 && !somehow) continue;
    text += (text.empty() ? "" : ", ") + mesh.attributes[i].name;
    if (decoded.bits[i] > 0) text += " to " + std::to_string(decoded.bits[i]) + " bits";
  }
  return text;
}

/// A line for each attribute.
std::string attribute_lines(const Decoded& decoded, const Mesh& mesh) {
  std::string lines;
  for (std::size_t i = 0; i < mesh.attributes.size(); ++i) {
    const ::draco::PointAttribute& a = *decoded.points->attribute(std::int32_t(i));
    if (i > 0) lines += '\n';
    lines += mesh.attributes[i].name + ": " +
             ::draco::GeometryAttribute::TypeToString(a.attribute_type()) + " " +
             std::to_string(a.unique_id());
    if (a.normalized()) lines += " normalized";
    if (decoded.bits[i] > 0) lines += " " + std::to_string(decoded.bits[i]) + " bits";
  }
  return lines;
}

Expected<ReadResult> read_file(std::span<const std::byte> bytes, const Limits& limits) {
  const auto decoded = decode_checked(bytes, limits);
  if (!decoded) return Failure{decoded.error()};
  ReadResult result;
  result.mesh = surface_of(*decoded);
  Entries entries(result.mesh);
  entries.add("draco.attributes", attribute_lines(*decoded, result.mesh));
  entries.add_all(*decoded);
  if (const std::string what = quantised(*decoded, result.mesh); !what.empty())
    result.notes.push_back("Draco has quantised " + what + ": what values were before is lost");
  if (decoded->edgebreaker)
    result.notes.push_back(
        "Draco's Edgebreaker has changed the order of faces and vertices, left out degenerate "
        "faces "
        "and split vertices where faces were not manifold: what there was of these is not known");
  if (decoded->tree) result.notes.push_back("Draco's tree has changed the order of points");
  if (decoded->mesh == nullptr)
    result.notes.push_back(count(decoded->points->num_points(), "point", "points") +
                           " became a mesh without faces");
  if (entries.left_out > 0)
    result.notes.push_back(count(entries.left_out, "entry", "entries") +
                           " of Draco's metadata have no name that can be kept");
  if (decoded->left > 0)
    result.notes.push_back(count(decoded->left, "byte", "bytes") + " behind the mesh left out");
  return result;
}

Expected<Mesh> read_for_gltf(std::span<const std::byte> bytes) {
  const auto decoded = decode_checked(bytes, {});
  if (!decoded) return Failure{decoded.error()};
  if (decoded->mesh == nullptr)
    return fail(ErrorCode::malformed, "expected a mesh of Draco, found a cloud of points");
  Mesh mesh = points_of(*decoded);
  for (std::size_t i = 0; i < decoded->bits.size(); ++i)
    if (decoded->bits[i] > 0)
      mesh.metadata.push_back(
          {mesh.attributes[i].name, std::to_string(decoded->bits[i]) + " bits"});
  return mesh;
}

}  // namespace

Expected<ReadResult> read(std::span<const std::byte> bytes, const Limits& limits) {
  return safely([&] { return read_file(bytes, limits); });
}

Expected<Mesh> decode_for_gltf(std::span<const std::byte> bytes) {
  return safely([&] { return read_for_gltf(bytes); });
}

}  // namespace draco
}  // namespace clers
