// Writes the files that fuzzing starts from: small meshes in every form that the targets take. They
// are made rather than kept, so that they are always of the current format.
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

#include "codec/connectivity/connectivity.h"
#include "codec/encode.h"
#include "codec/gltf/gltf.h"
#include "codec/io/io.h"
#include "codec/soup/adjacency.h"
#include "corpus/generate.h"

namespace {

using namespace clers;
using namespace clers::internal;

struct Named {
  std::string name;
  Mesh mesh;
};

std::vector<Named> meshes() {
  const Mesh pieces[] = {corpus::tetrahedron(), corpus::grid(2, 3), corpus::torus(3, 4)};
  return {{"triangle", corpus::single_triangle()},
          {"pair", corpus::glued_pair()},
          {"icosahedron", corpus::icosphere(0)},
          {"grid", corpus::shuffle(corpus::grid(4, 5), 1)},
          {"cylinder", corpus::cylinder(5, 2)},
          {"torus", corpus::flip_edges(corpus::torus(4, 5), 30, 2)},
          {"holes", corpus::punch_holes(corpus::icosphere(2), 4, 3)},
          {"pieces", corpus::disjoint_union(pieces)},
          {"moebius", corpus::moebius_strip(7, 2)},
          {"book", corpus::book(5)},
          {"chessboard", corpus::chessboard(4)},
          {"soup", corpus::random_soup(9, 12, 3, 1)},
          {"polygons", corpus::random_soup(40, 30, 7, 2)}};
}

bool is_surface(const Mesh& mesh) {
  EncodeOptions options;
  options.on_nonmanifold = options.on_degenerate = DefectPolicy::reject;
  return encode({&mesh, 1}, options).ok();
}

bool write(const std::filesystem::path& file, std::span<const std::byte> bytes) {
  std::filesystem::create_directories(file.parent_path());
  std::ofstream out(file, std::ios::binary);
  out.write(reinterpret_cast<const char*>(bytes.data()),
            static_cast<std::streamsize>(bytes.size()));
  return bool(out.flush());
}

/// A triangle, as a glTF.
constexpr std::string_view small_gltf =
    R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":36,"uri":"data:;base64,)"
    R"(AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}],"bufferViews":[{"buffer":0,"byteLength":36}],)"
    R"("accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","max":[1,1,0],"min":[0,0,0]}],)"
    R"("meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],"nodes":[{"mesh":0}]})";

/// What a file may hold besides meshes.
bool write_scenes(const std::filesystem::path& root) {
  const auto bytes = std::as_bytes(std::span(small_gltf));
  const auto read = gltf::read(bytes, {});
  if (!read) return false;
  Scene other;
  other.meshes = {corpus::grid(2, 3)};
  other.arrays = {{"vertices", Scalar::uint32, 1, std::vector<std::byte>(40), 0},
                  {"values", Scalar::float32, 2, std::vector<std::byte>(80, std::byte{60})}};
  other.blobs = {{"blob", std::vector<std::byte>(100)}};
  const auto of_gltf = encode(read->scene), of_other = encode(other);
  return of_gltf && of_other && write(root / "read_gltf" / "triangle", bytes) &&
         write(root / "decode_any" / "gltf", of_gltf->bytes) &&
         write(root / "decode_any" / "scene", of_other->bytes);
}

/// Nothing here may fail: the meshes are ours.
bool write_all(const std::filesystem::path& root) {
  bool ok = true;
  std::vector<Mesh> all;
  for (const auto& [name, mesh] : meshes()) {
    // Levels differ in connectivity, which knows nothing of order and pieces: one level has those.
    for (const std::uint32_t faces : {0u, 1u, 12u}) {
      EncodeOptions options;
      if (faces > 0) options.piece_faces = faces;
      options.order = faces == 1 ? Order::free : Order::keep;  // 0: whole
      const auto encoded = encode({&mesh, 1}, options);
      ok = ok && encoded &&
           write(root / "decode_any" /
                     (name + (faces == 0 ? "-kept" : "-in-pieces-" + std::to_string(faces))),
                 encoded->bytes);
    }
    for (const int level : {1, 5, 9}) {
      EncodeOptions options;
      options.level = level;
      const auto encoded = encode({&mesh, 1}, options);
      ok = ok && encoded &&
           write(root / "decode_any" / (name + "-" + std::to_string(level)), encoded->bytes);
      if (!mesh.triangles_only() || !is_surface(mesh)) continue;
      auto twins = find_twins({mesh.corners, mesh.face_sizes}, mesh.vertex_count);
      const auto connectivity =
          encode_connectivity({mesh.corners, *twins, mesh.vertex_count}, level);
      ok = ok && connectivity &&
           write(root / "decode_connectivity" / (name + "-" + std::to_string(level)),
                 connectivity->bytes);
    }
    const io::Format formats[] = {io::Format::ply, io::Format::obj, io::Format::off,
                                  io::Format::stl};
    for (unsigned format = 0; format < 4; ++format)
      for (const io::Encoding encoding : {io::Encoding::text, io::Encoding::binary}) {
        const auto written = io::write({&mesh, 1}, formats[format], encoding);
        if (!written) continue;  // there is no binary OBJ
        std::vector<std::byte> bytes = {std::byte(format)};
        bytes.insert(bytes.end(), written->bytes.begin(), written->bytes.end());
        const char* const kind = encoding == io::Encoding::text ? "text" : "binary";
        ok = ok && write(root / "read_any" / (name + "-" + std::to_string(format) + kind), bytes);
      }
    all.push_back(mesh);
  }
  const auto together = encode(all);
  ok = ok && together && write(root / "decode_any" / "all", together->bytes);

  ok = ok && write_scenes(root);

  // round_trip makes its meshes from any bytes: vertices, level, kind, then what to join.
  for (unsigned kind = 0; kind < 16; ++kind) {  // the second half in pieces
    std::vector<std::byte> bytes = {std::byte(4 * kind), std::byte(kind),
                                    std::byte(kind % 8 + (kind < 8 ? 0 : 24))};
    for (unsigned i = 0; i < 40 + 10 * kind; ++i) bytes.push_back(std::byte(i * (37 + 2 * kind)));
    ok = ok && write(root / "round_trip" / std::to_string(kind), bytes);
  }
  // So does legal_streams: level, then choices.
  for (unsigned kind = 0; kind < 16; ++kind) {
    std::vector<std::byte> bytes = {std::byte(kind)};
    for (unsigned i = 0; i < 30 + 40 * kind; ++i)
      bytes.push_back(std::byte(i * i * (2 * kind + 1) >> kind % 5));
    ok = ok && write(root / "legal_streams" / std::to_string(kind), bytes);
  }
  return ok;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: %s DIRECTORY\n", argv[0]);
    return 2;
  }
  if (write_all(argv[1])) return 0;
  std::fprintf(stderr, "%s: cannot make the seeds\n", argv[1]);
  return 1;
}
