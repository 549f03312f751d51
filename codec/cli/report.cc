// What info, check and verify print, as text and as JSON.
#include "codec/cli/report.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "codec/cli/precision.h"
#include "codec/cli/printable.h"

namespace clers::cli {

std::string grouped(std::uint64_t n) {
  std::string digits = std::to_string(n);
  for (std::size_t at = digits.size(); at > 3;) digits.insert(at -= 3, 1, ',');
  return digits;
}

std::string counted(std::uint64_t n, const char* one, const char* more) {
  return grouped(n) + " " + (n == 1 ? one : more);
}

namespace {

using Json = nlohmann::ordered_json;

constexpr char symbol_names[] = "CLERS";

void add(MeshShape& sum, const MeshShape& s) {
  sum.vertices += s.vertices;
  sum.faces += s.faces;
  sum.triangles += s.triangles;
  sum.nonmanifold_edges += s.nonmanifold_edges;
  sum.nonmanifold_vertices += s.nonmanifold_vertices;
  sum.misoriented_edges += s.misoriented_edges;
  sum.degenerate_faces += s.degenerate_faces;
  sum.duplicate_faces += s.duplicate_faces;
  sum.isolated_vertices += s.isolated_vertices;
  sum.surface.components += s.surface.components;
  sum.surface.nonorientable_components += s.surface.nonorientable_components;
  sum.surface.boundary_curves += s.surface.boundary_curves;
  sum.surface.genus += s.surface.genus;
}

/// A mesh of a file, or the sum of all.
struct Row {
  MeshInfo info;
  InspectedMesh measured;
};

void add(Row& sum, const MeshInfo& info, const InspectedMesh& measured) {
  sum.info.pieces += info.pieces;
  sum.info.copied_vertices += info.copied_vertices;
  sum.info.repeated_faces += info.repeated_faces;
  sum.info.connectivity_bytes += info.connectivity_bytes;
  sum.info.polygon_bytes += info.polygon_bytes;
  sum.info.stitching_bytes += info.stitching_bytes;
  sum.info.order_bytes += info.order_bytes;
  sum.info.position_bytes += info.position_bytes;
  sum.info.attribute_bytes += info.attribute_bytes;
  sum.info.metadata_bytes += info.metadata_bytes;
  add(sum.measured.shape, measured.shape);
  CodingCounts& counts = sum.measured.counts;
  counts.reversed_faces += measured.counts.reversed_faces;
  for (std::size_t i = 0; i < counts.symbols.size(); ++i)
    counts.symbols[i] += measured.counts.symbols[i];
}

Row total(const Inspection& found) {
  Row sum;
  sum.info.pieces = 0;
  for (std::size_t i = 0; i < found.meshes.size(); ++i)
    add(sum, found.file.meshes[i], found.meshes[i]);
  return sum;
}

MeshShape total(std::span<const Measured> meshes) {
  MeshShape sum;
  for (const Measured& mesh : meshes) add(sum, mesh.shape);
  return sum;
}

void put(Json& json, const MeshShape& s) {
  json["vertices"] = s.vertices;
  json["faces"] = s.faces;
  json["triangles"] = s.triangles;
  json["components"] = s.surface.components;
  json["boundary_curves"] = s.surface.boundary_curves;
  json["genus"] = s.surface.genus;
  json["nonmanifold_edges"] = s.nonmanifold_edges;
  json["nonmanifold_vertices"] = s.nonmanifold_vertices;
  json["misoriented_edges"] = s.misoriented_edges;
  json["degenerate_faces"] = s.degenerate_faces;
  json["duplicate_faces"] = s.duplicate_faces;
  json["nonorientable_components"] = s.surface.nonorientable_components;
  json["isolated_vertices"] = s.isolated_vertices;
}

double bits_per_triangle(const MeshInfo& info, const MeshShape& shape) {
  return 8 * static_cast<double>(info.connectivity_bytes) / static_cast<double>(shape.triangles);
}

void put(Json& json, const MeshInfo& info, const InspectedMesh& measured) {
  put(json, measured.shape);
  json["pieces"] = info.pieces;
  json["reversed_faces"] = measured.counts.reversed_faces;
  json["copied_vertices"] = info.copied_vertices;
  json["repeated_faces"] = info.repeated_faces;
  json["connectivity_bytes"] = info.connectivity_bytes;
  json["polygon_bytes"] = info.polygon_bytes;
  json["stitching_bytes"] = info.stitching_bytes;
  json["order_bytes"] = info.order_bytes;
  json["position_bytes"] = info.position_bytes;
  json["attribute_bytes"] = info.attribute_bytes;
  json["metadata_bytes"] = info.metadata_bytes;
  json["connectivity_bits_per_triangle"] =
      measured.shape.triangles == 0 ? Json() : Json(bits_per_triangle(info, measured.shape));
  for (std::size_t i = 0; i < measured.counts.symbols.size(); ++i)
    json["symbols"][std::string(1, symbol_names[i])] = measured.counts.symbols[i];
}

/// What a file holds besides meshes, if anything.
Json in_json(const SceneInfo& scene) {
  Json json;
  json["document_size"] = scene.document_size;
  json["document_bytes"] = scene.document_bytes;
  json["metadata_bytes"] = scene.metadata_bytes;
  json["arrays"] = Json::array();
  for (const ArrayInfo& a : scene.arrays) {
    json["arrays"].push_back({{"name", a.name},
                              {"scalar", name(a.scalar)},
                              {"components", a.components},
                              {"count", a.count},
                              {"bytes", a.bytes},
                              {"numbers", a.numbers},
                              {"coder", a.coder},
                              {"error", a.error}});
    if (a.vertices_of) json["arrays"].back()["vertices_of"] = *a.vertices_of;
  }
  json["blobs"] = Json::array();
  for (const BlobInfo& b : scene.blobs)
    json["blobs"].push_back({{"name", b.name}, {"size", b.size}, {"bytes", b.bytes}});
  json["metadata"] = Json::array();
  for (const MetadataEntry& entry : scene.metadata)
    json["metadata"].push_back({{"key", entry.key}, {"value", entry.value}});
  return json;
}

/// Names come from files: bytes that are no UTF-8 are replaced rather than refused.
std::string dump(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace);
}

// ---- Text

void line(std::string& out, const char* what, std::uint64_t n) {
  out += fmt::format("  {:<22}{:>15}\n", what, grouped(n));
}

/// Oddities that most meshes have none of are shown only where there are some.
void put(std::string& out, const MeshShape& s) {
  line(out, "vertices", s.vertices);
  line(out, "faces", s.faces);
  if (s.triangles != s.faces) line(out, "triangles", s.triangles);
  line(out, "components", s.surface.components);
  line(out, "boundary curves", s.surface.boundary_curves);
  line(out, "genus", s.surface.genus);
  line(out, "non-manifold edges", s.nonmanifold_edges);
  line(out, "non-manifold vertices", s.nonmanifold_vertices);
  if (s.misoriented_edges != 0) line(out, "misoriented edges", s.misoriented_edges);
  if (s.degenerate_faces != 0) line(out, "degenerate faces", s.degenerate_faces);
  if (s.duplicate_faces != 0) line(out, "duplicate faces", s.duplicate_faces);
  if (s.surface.nonorientable_components != 0)
    line(out, "one-sided components", s.surface.nonorientable_components);
  if (s.isolated_vertices != 0) line(out, "isolated vertices", s.isolated_vertices);
}

/// A line for each: type and number of values, what they cost, how they are coded, how exact.
void put(std::string& out, std::span<const AttributeInfo> attributes) {
  for (const AttributeInfo& a : attributes) {
    const double bits =
        a.count == 0 ? 0 : 8 * static_cast<double>(a.bytes) / static_cast<double>(a.count);
    out += fmt::format(
        "  {:<22}{:>15} bytes, {:.2f} bits each: {} {} {} of {}, {}",
        fitting(printable(a.name), 22), grouped(a.bytes), bits, grouped(a.count), name(a.domain),
        a.count == 1 ? "value" : "values",
        a.components == 1 ? name(a.scalar) : fmt::format("{} {}", a.components, name(a.scalar)),
        a.coder);
    if (!a.numbers.empty()) out += ", " + printable(a.numbers);
    out += a.error > 0 ? fmt::format(", off by {} at most\n", in_words(a.error, a.measure)) : "\n";
  }
}

/// A line for each array and blob.
void put(std::string& out, const SceneInfo& scene) {
  if (scene.document_size != 0)
    out += fmt::format("  {:<22}{:>15} bytes of {}\n", "document", grouped(scene.document_bytes),
                       grouped(scene.document_size));
  for (const ArrayInfo& a : scene.arrays)
    out += fmt::format(
        "  {:<22}{:>15} bytes: {} values of {}{}, {}, {}{}\n", fitting(printable(a.name), 22),
        grouped(a.bytes), grouped(a.count),
        a.components == 1 ? name(a.scalar) : fmt::format("{} {}", a.components, name(a.scalar)),
        a.vertices_of ? fmt::format(", vertices of mesh {}", *a.vertices_of) : "", a.coder,
        printable(a.numbers), a.error > 0 ? fmt::format(", off by {:.4g} at most", a.error) : "");
  for (const BlobInfo& b : scene.blobs)
    out += fmt::format("  {:<22}{:>15} bytes of {}\n", fitting(printable(b.name), 22),
                       grouped(b.bytes), grouped(b.size));
}

constexpr std::size_t longest_value = 54;  ///< of metadata, in a line of 80 columns

std::string heading(std::size_t i, const std::string& mesh) {
  return mesh.empty() ? fmt::format("mesh {}\n", i)
                      : fmt::format("mesh {} '{}'\n", i, printable(mesh));
}

}  // namespace

std::string info_json(const std::string& file, const Inspection& found) {
  const Row sum = total(found);
  Json json;
  json["file"] = file;
  json["format"] = fmt::format("{}.{}", found.file.format_major, found.file.format_minor);
  json["level"] = found.file.level;
  put(json, sum.info, sum.measured);
  json["overhead_bytes"] = found.file.overhead_bytes;
  json["total_bytes"] = found.file.total_bytes;
  json["meshes"] = Json::array();
  for (std::size_t i = 0; i < found.meshes.size(); ++i) {
    const MeshInfo& mesh = found.file.meshes[i];
    Json one;
    one["name"] = mesh.name;
    put(one, mesh, found.meshes[i]);
    one["attributes"] = Json::array();
    for (const AttributeInfo& a : mesh.attributes)
      one["attributes"].push_back({{"name", a.name},
                                   {"domain", name(a.domain)},
                                   {"scalar", name(a.scalar)},
                                   {"components", a.components},
                                   {"count", a.count},
                                   {"bytes", a.bytes},
                                   {"numbers", a.numbers},
                                   {"coder", a.coder},
                                   {"error", a.error},
                                   {"error_is", name(a.measure)}});
    one["metadata"] = Json::array();
    for (const MetadataEntry& entry : mesh.metadata)
      one["metadata"].push_back({{"key", entry.key}, {"value", entry.value}});
    json["meshes"].push_back(std::move(one));
  }
  if (found.file.scene.bytes() != 0) json["scene"] = in_json(found.file.scene);
  return dump(json);
}

std::string check_json(const std::string& file, std::span<const Measured> meshes) {
  Json json;
  json["file"] = file;
  put(json, total(meshes));
  json["meshes"] = Json::array();
  for (const Measured& mesh : meshes) {
    Json one;
    one["name"] = mesh.name;
    put(one, mesh.shape);
    json["meshes"].push_back(std::move(one));
  }
  return dump(json);
}

std::string info_text(const std::string& file, const Inspection& found) {
  const std::vector<MeshInfo>& meshes = found.file.meshes;
  const auto [sum, measured] = total(found);
  std::string out = fmt::format("{}: clers format {}.{}, level {}, {} mesh{}\n", printable(file),
                                found.file.format_major, found.file.format_minor, found.file.level,
                                meshes.size(), meshes.size() == 1 ? "" : "es");
  if (meshes.size() > 1) {
    for (std::size_t i = 0; i < meshes.size(); ++i) {
      out += heading(i, meshes[i].name);
      put(out, found.meshes[i].shape);
      line(out, "connectivity bytes", meshes[i].connectivity_bytes);
      put(out, meshes[i].attributes);
    }
    out += "all meshes\n";
  }
  put(out, measured.shape);
  if (sum.pieces != meshes.size()) line(out, "pieces", sum.pieces);
  if (measured.counts.reversed_faces != 0)
    line(out, "reversed faces", measured.counts.reversed_faces);
  if (sum.copied_vertices != 0) line(out, "copied vertices", sum.copied_vertices);
  if (sum.repeated_faces != 0) line(out, "repeated faces", sum.repeated_faces);
  std::string counts;
  for (std::size_t i = 0; i < measured.counts.symbols.size(); ++i)
    counts += fmt::format(" {} {}", symbol_names[i], grouped(measured.counts.symbols[i]));
  out += fmt::format("  {:<22}{}\n", "symbols", counts.substr(1));
  line(out, "connectivity bytes", sum.connectivity_bytes);
  if (measured.shape.triangles != 0)
    out += fmt::format("  {:<22}{:>15.3f}\n", "  bits per triangle",
                       bits_per_triangle(sum, measured.shape));
  if (sum.polygon_bytes != 0) line(out, "  of them for polygons", sum.polygon_bytes);
  if (sum.stitching_bytes != 0) line(out, "  of them for stitching", sum.stitching_bytes);
  if (sum.order_bytes != 0) line(out, "  of them for the order", sum.order_bytes);
  line(out, "position bytes", sum.position_bytes);
  line(out, "attribute bytes", sum.attribute_bytes);
  if (meshes.size() == 1) put(out, meshes[0].attributes);
  if (sum.metadata_bytes != 0) line(out, "metadata bytes", sum.metadata_bytes);
  put(out, found.file.scene);
  line(out, "overhead bytes", found.file.overhead_bytes);
  line(out, "total bytes", found.file.total_bytes);
  if (meshes.size() == 1)
    for (const MetadataEntry& entry : meshes[0].metadata)
      out += fmt::format("  {:<22} {}\n", printable(entry.key),
                         fitting(printable(entry.value), longest_value));
  return out;
}

std::string check_text(const std::string& file, std::span<const Measured> meshes) {
  std::string out = fmt::format("{}: {} mesh{}\n", printable(file), meshes.size(),
                                meshes.size() == 1 ? "" : "es");
  if (meshes.size() > 1) {
    for (std::size_t i = 0; i < meshes.size(); ++i) {
      out += heading(i, meshes[i].name);
      put(out, meshes[i].shape);
    }
    out += "all meshes\n";
  }
  put(out, total(meshes));
  return out;
}

std::string info_heading() {
  return fmt::format("{:>14} {:>12} {:>12} {:>9}  file\n", "bytes", "vertices", "faces",
                     "bits/face");
}

std::string info_line(const std::string& file, const Inspection& found) {
  const MeshShape shape = total(found).measured.shape;
  const std::uint64_t bytes = found.file.total_bytes;
  const double bits = 8 * static_cast<double>(bytes) / static_cast<double>(shape.faces);
  return fmt::format("{:>14} {:>12} {:>12} {:>9}  {}\n", grouped(bytes), grouped(shape.vertices),
                     grouped(shape.faces), shape.faces == 0 ? "-" : fmt::format("{:.2f}", bits),
                     printable(file));
}

std::string check_heading() {
  return fmt::format("{:>12} {:>12} {:>10} {:>10} {:>7} {:>8}  file\n", "vertices", "faces",
                     "components", "boundaries", "genus", "defects");
}

std::string check_line(const std::string& file, std::span<const Measured> meshes) {
  const MeshShape s = total(meshes);
  const std::uint64_t defects = s.nonmanifold_edges + s.nonmanifold_vertices + s.misoriented_edges +
                                s.degenerate_faces + s.duplicate_faces +
                                s.surface.nonorientable_components + s.isolated_vertices;
  return fmt::format("{:>12} {:>12} {:>10} {:>10} {:>7} {:>8}  {}\n", grouped(s.vertices),
                     grouped(s.faces), grouped(s.surface.components),
                     grouped(s.surface.boundary_curves), grouped(s.surface.genus), grouped(defects),
                     printable(file));
}

std::string json_list(std::span<const std::string> files) {
  std::string out;
  for (const std::string& file : files) out += (out.empty() ? "[" : ",\n") + file;
  return out.empty() ? "[]" : out + "]";
}

}  // namespace clers::cli
