#include "codec/cli/report.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "codec/cli/printable.h"

namespace clers::cli {

std::string grouped(std::uint64_t n) {
  std::string digits = std::to_string(n);
  for (std::size_t at = digits.size(); at > 3;) digits.insert(at -= 3, 1, ',');
  return digits;
}

namespace {

using Json = nlohmann::ordered_json;

constexpr char letters[] = "CLERS";

void add(MeshShape& sum, const MeshShape& s) {
  sum.vertices += s.vertices;
  sum.faces += s.faces;
  sum.triangles += s.triangles;
  sum.components += s.components;
  sum.boundary_curves += s.boundary_curves;
  sum.genus += s.genus;
  sum.nonmanifold_edges += s.nonmanifold_edges;
  sum.nonmanifold_vertices += s.nonmanifold_vertices;
  sum.misoriented_edges += s.misoriented_edges;
  sum.degenerate_faces += s.degenerate_faces;
  sum.duplicate_faces += s.duplicate_faces;
  sum.nonorientable_components += s.nonorientable_components;
  sum.isolated_vertices += s.isolated_vertices;
}

MeshInfo total(const FileInfo& info) {
  MeshInfo sum;
  sum.pieces = 0;
  for (const MeshInfo& mesh : info.meshes) {
    add(sum.shape, mesh.shape);
    sum.pieces += mesh.pieces;
    sum.cuts.turned_faces += mesh.cuts.turned_faces;
    sum.cuts.copied_vertices += mesh.cuts.copied_vertices;
    sum.cuts.repeated_faces += mesh.cuts.repeated_faces;
    sum.cuts.loose_faces += mesh.cuts.loose_faces;
    sum.connectivity_bytes += mesh.connectivity_bytes;
    sum.polygon_bytes += mesh.polygon_bytes;
    sum.stitching_bytes += mesh.stitching_bytes;
    sum.order_bytes += mesh.order_bytes;
    sum.position_bytes += mesh.position_bytes;
    sum.attribute_bytes += mesh.attribute_bytes;
    sum.metadata_bytes += mesh.metadata_bytes;
    for (std::size_t i = 0; i < sum.clers.size(); ++i) sum.clers[i] += mesh.clers[i];
  }
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
  json["components"] = s.components;
  json["boundary_curves"] = s.boundary_curves;
  json["genus"] = s.genus;
  json["nonmanifold_edges"] = s.nonmanifold_edges;
  json["nonmanifold_vertices"] = s.nonmanifold_vertices;
  json["misoriented_edges"] = s.misoriented_edges;
  json["degenerate_faces"] = s.degenerate_faces;
  json["duplicate_faces"] = s.duplicate_faces;
  json["nonorientable_components"] = s.nonorientable_components;
  json["isolated_vertices"] = s.isolated_vertices;
}

double bits_per_triangle(const MeshInfo& m) {
  return 8 * static_cast<double>(m.connectivity_bytes) / static_cast<double>(m.shape.triangles);
}

void put(Json& json, const MeshInfo& m) {
  put(json, m.shape);
  json["pieces"] = m.pieces;
  json["turned_faces"] = m.cuts.turned_faces;
  json["copied_vertices"] = m.cuts.copied_vertices;
  json["repeated_faces"] = m.cuts.repeated_faces;
  json["loose_faces"] = m.cuts.loose_faces;
  json["connectivity_bytes"] = m.connectivity_bytes;
  json["polygon_bytes"] = m.polygon_bytes;
  json["stitching_bytes"] = m.stitching_bytes;
  json["order_bytes"] = m.order_bytes;
  json["position_bytes"] = m.position_bytes;
  json["attribute_bytes"] = m.attribute_bytes;
  json["metadata_bytes"] = m.metadata_bytes;
  json["connectivity_bits_per_triangle"] =
      m.shape.triangles == 0 ? Json() : Json(bits_per_triangle(m));
  for (std::size_t i = 0; i < m.clers.size(); ++i)
    json["clers"][std::string(1, letters[i])] = m.clers[i];
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
  line(out, "components", s.components);
  line(out, "boundary curves", s.boundary_curves);
  line(out, "genus", s.genus);
  line(out, "non-manifold edges", s.nonmanifold_edges);
  line(out, "non-manifold vertices", s.nonmanifold_vertices);
  if (s.misoriented_edges != 0) line(out, "misoriented edges", s.misoriented_edges);
  if (s.degenerate_faces != 0) line(out, "degenerate faces", s.degenerate_faces);
  if (s.duplicate_faces != 0) line(out, "duplicate faces", s.duplicate_faces);
  if (s.nonorientable_components != 0)
    line(out, "one-sided components", s.nonorientable_components);
  if (s.isolated_vertices != 0) line(out, "isolated vertices", s.isolated_vertices);
}

constexpr std::size_t longest_value = 54;  ///< of metadata, in a line of 80 columns

std::string heading(std::size_t i, const std::string& mesh) {
  return mesh.empty() ? fmt::format("mesh {}\n", i)
                      : fmt::format("mesh {} '{}'\n", i, printable(mesh));
}

}  // namespace

std::string info_json(const std::string& file, const FileInfo& info) {
  Json json;
  json["file"] = file;
  json["format"] = fmt::format("{}.{}", info.format_major, info.format_minor);
  json["level"] = info.level;
  put(json, total(info));
  json["overhead_bytes"] = info.overhead_bytes;
  json["total_bytes"] = info.total_bytes;
  json["meshes"] = Json::array();
  for (const MeshInfo& mesh : info.meshes) {
    Json one;
    one["name"] = mesh.name;
    put(one, mesh);
    one["attributes"] = Json::array();
    for (const AttributeInfo& a : mesh.attributes)
      one["attributes"].push_back({{"name", a.name},
                                   {"domain", name(a.domain)},
                                   {"scalar", name(a.scalar)},
                                   {"components", a.components},
                                   {"count", a.count},
                                   {"bytes", a.bytes}});
    one["metadata"] = Json::array();
    for (const MetadataEntry& entry : mesh.metadata)
      one["metadata"].push_back({{"key", entry.key}, {"value", entry.value}});
    json["meshes"].push_back(std::move(one));
  }
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

std::string info_text(const std::string& file, const FileInfo& info) {
  const MeshInfo sum = total(info);
  std::string out = fmt::format("{}: clers format {}.{}, level {}, {} mesh{}\n", printable(file),
                                info.format_major, info.format_minor, info.level,
                                info.meshes.size(), info.meshes.size() == 1 ? "" : "es");
  if (info.meshes.size() > 1) {
    for (std::size_t i = 0; i < info.meshes.size(); ++i) {
      out += heading(i, info.meshes[i].name);
      put(out, info.meshes[i].shape);
      line(out, "connectivity bytes", info.meshes[i].connectivity_bytes);
    }
    out += "all meshes\n";
  }
  put(out, sum.shape);
  if (sum.pieces != info.meshes.size()) line(out, "pieces", sum.pieces);
  if (sum.cuts.turned_faces != 0) line(out, "turned faces", sum.cuts.turned_faces);
  if (sum.cuts.copied_vertices != 0) line(out, "copied vertices", sum.cuts.copied_vertices);
  if (sum.cuts.repeated_faces != 0) line(out, "repeated faces", sum.cuts.repeated_faces);
  if (sum.cuts.loose_faces != 0) line(out, "loose faces", sum.cuts.loose_faces);
  std::string counts;
  for (std::size_t i = 0; i < sum.clers.size(); ++i)
    counts += fmt::format(" {} {}", letters[i], grouped(sum.clers[i]));
  out += fmt::format("  {:<22}{}\n", "symbols", counts.substr(1));
  line(out, "connectivity bytes", sum.connectivity_bytes);
  if (sum.shape.triangles != 0)
    out += fmt::format("  {:<22}{:>15.3f}\n", "  bits per triangle", bits_per_triangle(sum));
  if (sum.polygon_bytes != 0) line(out, "  of them for polygons", sum.polygon_bytes);
  if (sum.stitching_bytes != 0) line(out, "  of them for stitching", sum.stitching_bytes);
  if (sum.order_bytes != 0) line(out, "  of them for the order", sum.order_bytes);
  line(out, "position bytes", sum.position_bytes);
  line(out, "attribute bytes", sum.attribute_bytes);
  if (sum.metadata_bytes != 0) line(out, "metadata bytes", sum.metadata_bytes);
  line(out, "overhead bytes", info.overhead_bytes);
  line(out, "total bytes", info.total_bytes);
  if (info.meshes.size() == 1)
    for (const MetadataEntry& entry : info.meshes[0].metadata)
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

std::string info_line(const std::string& file, const FileInfo& info) {
  const MeshShape shape = total(info).shape;
  const double bits = 8 * static_cast<double>(info.total_bytes) / static_cast<double>(shape.faces);
  return fmt::format("{:>14} {:>12} {:>12} {:>9}  {}\n", grouped(info.total_bytes),
                     grouped(shape.vertices), grouped(shape.faces),
                     shape.faces == 0 ? "-" : fmt::format("{:.2f}", bits), printable(file));
}

std::string check_heading() {
  return fmt::format("{:>12} {:>12} {:>10} {:>10} {:>7} {:>8}  file\n", "vertices", "faces",
                     "components", "boundaries", "genus", "defects");
}

std::string check_line(const std::string& file, std::span<const Measured> meshes) {
  const MeshShape s = total(meshes);
  const std::uint64_t defects = s.nonmanifold_edges + s.nonmanifold_vertices + s.misoriented_edges +
                                s.degenerate_faces + s.duplicate_faces +
                                s.nonorientable_components + s.isolated_vertices;
  return fmt::format("{:>12} {:>12} {:>10} {:>10} {:>7} {:>8}  {}\n", grouped(s.vertices),
                     grouped(s.faces), grouped(s.components), grouped(s.boundary_curves),
                     grouped(s.genus), grouped(defects), printable(file));
}

std::string json_list(std::span<const std::string> files) {
  std::string out;
  for (const std::string& file : files) out += (out.empty() ? "[" : ",\n") + file;
  return out.empty() ? "[]" : out + "]";
}

}  // namespace clers::cli
