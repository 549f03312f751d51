#include "bench/input.h"

#include <zlib.h>

#include <algorithm>
#include <cstring>
#include <memory>
#include <numeric>
#include <stdexcept>
#include <utility>

namespace clers::bench {
namespace {

namespace fs = std::filesystem;

// gzread passes a file that is not gzipped through as it is.
std::vector<std::byte> read_bytes(const fs::path& file) {
  const std::unique_ptr<gzFile_s, int (*)(gzFile)> stream(gzopen(file.c_str(), "rb"), gzclose);
  if (!stream) throw std::runtime_error("cannot be opened");
  std::vector<std::byte> bytes;
  for (;;) {
    const std::size_t size = bytes.size();
    constexpr unsigned step = 1u << 22;
    bytes.resize(size + step);
    const int got = gzread(stream.get(), bytes.data() + size, step);
    if (got < 0) throw std::runtime_error("cannot be read");
    bytes.resize(size + static_cast<std::size_t>(got));
    if (got == 0) return bytes;
  }
}

void append_triangles(const Mesh& mesh, std::uint32_t first_vertex, Input& input) {
  if (mesh.triangles_only()) {
    for (const std::uint32_t v : mesh.corners) input.triangles.push_back(first_vertex + v);
    return;
  }
  std::size_t begin = 0;
  for (const std::uint32_t size : mesh.face_sizes) {
    if (size != 3) input.fanned = true;
    for (std::uint32_t i = 2; i < size; ++i)
      for (const std::uint32_t corner : {0u, i - 1, i})
        input.triangles.push_back(first_vertex + mesh.corners[begin + corner]);
    begin += size;
  }
}

// Leaves out the vertices that no triangle uses, as some rivals do: sizes are then of one mesh.
void leave_isolated_out(Input& input) {
  constexpr std::uint32_t unused = 0xffffffffu;
  std::vector<std::uint32_t> number(input.vertex_count, unused);
  for (const std::uint32_t v : input.triangles) number[v] = 0;
  std::uint32_t used = 0;
  for (std::uint32_t v = 0; v < input.vertex_count; ++v) {
    if (number[v] == unused) continue;
    std::copy_n(&input.positions[3 * std::size_t(v)], 3, &input.positions[3 * std::size_t(used)]);
    number[v] = used++;
  }
  for (std::uint32_t& v : input.triangles) v = number[v];
  input.positions.resize(3 * std::size_t(used));
  input.vertex_count = used;
}

template <class T>
void append_values(const Attribute& attribute, std::uint32_t count, std::vector<float>& out) {
  for (std::size_t v = 0; v < count; ++v) {
    for (std::size_t k = 0; k < 3; ++k) {
      T value;
      std::memcpy(&value, attribute.data.data() + v * attribute.stride() + k * sizeof(T),
                  sizeof(T));
      out.push_back(static_cast<float>(value));
    }
  }
}

void append_positions(const Mesh& mesh, Input& input) {
  const Attribute* position = mesh.position();
  if (!position || position->components != 3) throw std::runtime_error("has no positions");
  switch (position->scalar) {
    case Scalar::float32:
      return append_values<float>(*position, mesh.vertex_count, input.positions);
    case Scalar::float64:
      return append_values<double>(*position, mesh.vertex_count, input.positions);
    default: throw std::runtime_error("has positions that are not floating point");
  }
}

std::string stem(const fs::path& file) {
  fs::path base = file.filename();
  if (base.extension() == ".gz") base = base.stem();
  return base.stem().string();
}

std::string extension(const fs::path& file) {
  return (file.extension() == ".gz" ? file.stem() : file).extension().string();
}

}  // namespace

bool Input::has_corner_values() const {
  for (const Mesh& m : file.meshes)
    for (const Attribute& a : m.attributes)
      if (a.domain == Domain::corner) return true;
  return false;
}

bool is_oriented_manifold(std::uint32_t vertex_count, const std::vector<std::uint32_t>& triangles) {
  // Half-edges sorted by (from, to): twins are found by looking the reverse up.
  struct HalfEdge {
    std::uint32_t from, to, corner;
    auto key() const { return std::pair(from, to); }
  };
  std::vector<HalfEdge> edges;
  edges.reserve(triangles.size());
  for (std::uint32_t c = 0; c < triangles.size(); ++c) {
    const std::uint32_t next = c % 3 == 2 ? c - 2 : c + 1;
    if (triangles[c] == triangles[next]) return false;
    edges.push_back({triangles[c], triangles[next], c});
  }
  const auto less = [](const HalfEdge& a, const HalfEdge& b) { return a.key() < b.key(); };
  std::sort(edges.begin(), edges.end(), less);
  for (std::size_t i = 1; i < edges.size(); ++i)
    if (edges[i].key() == edges[i - 1].key()) return false;

  // A vertex has one fan if its corners are connected through the edges at it.
  std::vector<std::uint32_t> parent(triangles.size());
  std::iota(parent.begin(), parent.end(), 0u);
  const auto root = [&](std::uint32_t c) {
    while (parent[c] != c) c = parent[c] = parent[parent[c]];
    return c;
  };
  for (const HalfEdge& e : edges) {
    const HalfEdge reverse{e.to, e.from, 0};
    const auto twin = std::lower_bound(edges.begin(), edges.end(), reverse, less);
    if (twin == edges.end() || twin->key() != reverse.key()) continue;
    const std::uint32_t after_twin = twin->corner % 3 == 2 ? twin->corner - 2 : twin->corner + 1;
    parent[root(e.corner)] = root(after_twin);
  }
  std::vector<std::uint32_t> fan(vertex_count, 0xffffffffu);
  for (std::uint32_t c = 0; c < triangles.size(); ++c) {
    std::uint32_t& known = fan[triangles[c]];
    if (known == 0xffffffffu) known = root(c);
    if (known != root(c)) return false;
  }
  return true;
}

Input make_input(std::string name, std::uint32_t vertex_count, std::vector<std::uint32_t> triangles,
                 std::vector<float> positions) {
  Input input;
  const std::size_t begin = name.rfind("many-", 0) == 0 ? 5 : 0;  // many-components-plant
  input.family = name.substr(begin, name.find('-', begin) - begin);
  input.name = std::move(name);
  input.vertex_count = vertex_count;
  input.triangles = std::move(triangles);
  input.positions = std::move(positions);
  input.mesh.vertex_count = vertex_count;
  input.mesh.corners = input.triangles;
  Attribute position;
  position.name = position_name;
  position.components = 3;
  position.data.resize(input.positions.size() * sizeof(float));
  if (!position.data.empty())
    std::memcpy(position.data.data(), input.positions.data(), position.data.size());
  input.mesh.attributes.push_back(std::move(position));
  return input;
}

Input read_input(const fs::path& file) {
  const auto format = io::format_of(extension(file));
  if (!format) throw std::runtime_error("is in a format that is not read");
  std::vector<std::byte> bytes = read_bytes(file);
  auto read = io::read(bytes, *format);
  if (!read) throw std::runtime_error(describe(read.error()));

  Input raw;
  for (const Mesh& mesh : read->meshes) {
    append_triangles(mesh, raw.vertex_count, raw);
    append_positions(mesh, raw);
    raw.vertex_count += mesh.vertex_count;
  }
  if (raw.triangles.empty()) throw std::runtime_error("has no faces");
  leave_isolated_out(raw);
  Input input =
      make_input(stem(file), raw.vertex_count, std::move(raw.triangles), std::move(raw.positions));
  input.fanned = raw.fanned;
  input.manifold = is_oriented_manifold(input.vertex_count, input.triangles);
  input.file = {std::move(bytes), *format, std::move(read->meshes)};
  return input;
}

std::vector<fs::path> list_files(const std::vector<std::string>& arguments) {
  std::vector<fs::path> files;
  for (const fs::path argument : arguments) {
    if (!fs::is_directory(argument)) {
      files.push_back(argument);
      continue;
    }
    std::vector<fs::path> inside;
    for (const auto& entry : fs::directory_iterator(argument))
      if (entry.is_regular_file() && io::format_of(extension(entry.path())))
        inside.push_back(entry.path());
    std::sort(inside.begin(), inside.end());
    files.insert(files.end(), inside.begin(), inside.end());
  }
  return files;
}

}  // namespace clers::bench
