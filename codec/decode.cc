#include "codec/decode.h"

#include <algorithm>
#include <atomic>
#include <new>
#include <utility>

#include "codec/edges.h"
#include "codec/faces.h"
#include "codec/mesh_decoder.h"
#include "codec/parallel.h"

namespace clers {
namespace {

Failure<Error> in_mesh(Error error, std::size_t mesh, std::size_t meshes) {
  if (meshes > 1) error.what += " (mesh " + std::to_string(mesh) + ")";
  return {std::move(error)};
}

Expected<Piece> make_piece(const std::vector<MeshSections>& meshes, std::size_t mesh_index,
                           std::size_t index, unsigned threads) {
  const MeshSections& mesh = meshes[mesh_index];
  const PieceSections& sections = mesh.pieces[index];
  auto decoded = decode_piece(sections, Values::decode, threads);
  if (!decoded) return in_mesh(decoded.error(), mesh_index, meshes.size());
  Piece piece{mesh_index, index, mesh.pieces.size(), std::move(decoded->mesh), {}, 0, 0};
  if (piece.count == 1) {
    if (auto ok = finish_mesh(mesh, piece.mesh); !ok)
      return in_mesh(ok.error(), mesh_index, meshes.size());
    return piece;
  }
  auto seam = decode_seam(sections);
  if (!seam) return in_mesh(seam.error(), mesh_index, meshes.size());
  piece.seam = std::move(*seam);
  piece.mesh.name = mesh.name;
  if (index == 0 && mesh.metadata) {
    auto metadata = decode_metadata(*mesh.metadata);
    if (!metadata) return in_mesh(metadata.error(), mesh_index, meshes.size());
    piece.mesh.metadata = std::move(*metadata);
  }
  piece.first_vertex = static_cast<std::uint32_t>(sections.first_vertex);
  piece.first_face = static_cast<std::uint32_t>(sections.first_face);
  return piece;
}

/// Opposites by the ends of edges.
void match(std::span<const std::uint32_t> corners, std::uint32_t vertices,
           std::span<HalfEdge> opposites) {
  std::fill(opposites.begin(), opposites.end(), HalfEdge());
  for_each_edge(Faces(corners, {}), vertices, [&](std::span<const std::uint32_t> sides) {
    if (sides.size() != 2 || corners[sides[0]] == corners[sides[1]]) return;
    opposites[sides[0]] = HalfEdge(sides[1]);
    opposites[sides[1]] = HalfEdge(sides[0]);
  });
}

/// The faces of a mesh of triangles. Returns whether opposites are there too.
Expected<bool> decode_corners(const MeshSections& mesh, std::span<std::uint32_t> corners,
                              std::span<HalfEdge> opposites, unsigned threads) {
  const std::size_t pieces = mesh.pieces.size();
  std::vector<Expected<Done>> outcomes(pieces, Done{});
  if (mesh.may_have_sizes() || !mesh.order.bytes.empty()) {
    Mesh whole;
    if (pieces > 1) whole = make_room(mesh, Values::skip);
    for_each_item(pieces, threads, [&](std::size_t k, unsigned) {
      auto piece = decode_piece(mesh.pieces[k], Values::skip);
      if (!piece)
        outcomes[k] = Failure{piece.error()};
      else if (pieces > 1)
        outcomes[k] = put_piece(mesh.pieces[k], piece->mesh, whole);
      else
        whole = std::move(piece->mesh);
    });
    for (const auto& ok : outcomes)
      if (!ok) return Failure{ok.error()};
    if (auto ok = finish_mesh(mesh, whole); !ok) return Failure{ok.error()};
    if (!whole.triangles_only())
      return fail(ErrorCode::bad_option, "not all faces of the mesh are triangles");
    std::copy(whole.corners.begin(), whole.corners.end(), corners.begin());
    return false;
  }
  const bool with_twins = pieces == 1 && mesh.pieces[0].features == 0;
  std::fill(opposites.begin(), opposites.end(), HalfEdge());
  for_each_item(pieces, threads, [&](std::size_t k, unsigned) {
    const PieceSections& piece = mesh.pieces[k];
    const auto own = corners.subspan(static_cast<std::size_t>(piece.first_corner),
                                     static_cast<std::size_t>(piece.corners));
    outcomes[k] = decode_triangles(piece, own, with_twins ? opposites : std::span<HalfEdge>());
    if (!outcomes[k] || pieces == 1) return;
    if (auto ok = number_piece(piece, own); !ok) outcomes[k] = Failure{ok.error()};
  });
  for (const auto& ok : outcomes)
    if (!ok) return Failure{ok.error()};
  return with_twins;
}

}  // namespace

Expected<std::vector<Mesh>> decode(std::span<const std::byte> bytes,
                                   const DecodeOptions& options) try {
  ContainerReader file(bytes);
  auto sections = read_meshes(file, options.limits);
  if (!sections) return Failure{sections.error()};
  struct Job {
    std::size_t mesh, piece;
  };
  std::vector<Job> jobs;
  std::vector<Mesh> meshes(sections->size());
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    const std::size_t pieces = (*sections)[i].pieces.size();
    if (pieces > 1) meshes[i] = make_room((*sections)[i], Values::decode);
    for (std::size_t k = 0; k < pieces; ++k) jobs.push_back({i, k});
  }
  std::vector<Expected<Done>> outcomes(jobs.size(), Done{});
  std::atomic<std::size_t> done{0};
  const unsigned threads_inside = jobs.size() > 1 ? 1 : options.threads;
  for_each_item(jobs.size(), options.threads, [&](std::size_t j, unsigned worker) {
    if (options.progress && worker == 0)
      options.progress("decode", static_cast<double>(done) / static_cast<double>(jobs.size()));
    const MeshSections& from = (*sections)[jobs[j].mesh];
    const PieceSections& part = from.pieces[jobs[j].piece];
    Mesh& mesh = meshes[jobs[j].mesh];
    auto piece = decode_piece(part, Values::decode, threads_inside);
    if (!piece)
      outcomes[j] = Failure{piece.error()};
    else if (from.pieces.size() > 1)
      outcomes[j] = put_piece(part, piece->mesh, mesh);
    else
      mesh = std::move(piece->mesh);
    ++done;
  });
  for (std::size_t j = 0; j < jobs.size(); ++j)
    if (!outcomes[j]) return in_mesh(outcomes[j].error(), jobs[j].mesh, meshes.size());
  for (std::size_t i = 0; i < meshes.size(); ++i)
    if (auto ok = finish_mesh((*sections)[i], meshes[i]); !ok)
      return in_mesh(ok.error(), i, meshes.size());
  if (options.progress) options.progress("done", 1.0);
  return meshes;
} catch (const std::bad_alloc&) {
  return fail(ErrorCode::out_of_memory, "not enough memory to decode");
}

Expected<Done> decode_pieces(std::span<const std::byte> bytes,
                             const std::function<void(Piece)>& take,
                             const DecodeOptions& options) try {
  ContainerReader file(bytes);
  auto meshes = read_meshes(file, options.limits);
  if (!meshes) return Failure{meshes.error()};
  std::size_t all = 0, done = 0;
  for (const MeshSections& mesh : *meshes) all += mesh.pieces.size();
  for (std::size_t i = 0; i < meshes->size(); ++i)
    for (std::size_t k = 0; k < (*meshes)[i].pieces.size(); ++k) {
      if (options.progress)
        options.progress("decode", static_cast<double>(done++) / static_cast<double>(all));
      auto piece = make_piece(*meshes, i, k, 1);
      if (!piece) return Failure{piece.error()};
      take(std::move(*piece));
    }
  if (options.progress) options.progress("done", 1.0);
  return Done{};
} catch (const std::bad_alloc&) {
  return fail(ErrorCode::out_of_memory, "not enough memory to decode");
}

Expected<Piece> decode_piece(std::span<const std::byte> bytes, std::size_t index,
                             const DecodeOptions& options) try {
  ContainerReader file(bytes);
  auto meshes = read_meshes(file, options.limits);
  if (!meshes) return Failure{meshes.error()};
  std::size_t before = 0;
  for (std::size_t i = 0; i < meshes->size(); ++i) {
    const std::size_t pieces = (*meshes)[i].pieces.size();
    if (index - before < pieces) return make_piece(*meshes, i, index - before, options.threads);
    before += pieces;
  }
  return fail(ErrorCode::bad_option,
              "piece " + std::to_string(index) + ", there are " + std::to_string(before));
} catch (const std::bad_alloc&) {
  return fail(ErrorCode::out_of_memory, "not enough memory to decode");
}

Expected<std::vector<MeshSizes>> sizes(std::span<const std::byte> bytes, const Limits& limits) try {
  ContainerReader file(bytes);
  auto meshes = read_meshes(file, limits);
  if (!meshes) return Failure{meshes.error()};
  std::vector<MeshSizes> result;
  for (const MeshSections& m : *meshes)
    result.push_back({m.vertices, m.faces, m.corners, m.pieces.size()});
  return result;
} catch (const std::bad_alloc&) {
  return fail(ErrorCode::out_of_memory, "not enough memory to decode");
}

Expected<Done> decode_into(std::span<const std::byte> bytes, std::span<std::uint32_t> corners,
                           std::span<HalfEdge> opposites, const DecodeOptions& options) try {
  ContainerReader file(bytes);
  auto meshes = read_meshes(file, options.limits);
  if (!meshes) return Failure{meshes.error()};
  if (meshes->size() != 1)
    return fail(ErrorCode::bad_option,
                std::to_string(meshes->size()) + " meshes in the file, expected one");
  const MeshSections& mesh = meshes->front();
  if (corners.size() != mesh.corners || (!opposites.empty() && opposites.size() != mesh.corners))
    return fail(ErrorCode::bad_option,
                "the memory is not for " + std::to_string(mesh.corners) + " corners");
  const auto matched = decode_corners(mesh, corners, opposites, options.threads);
  if (!matched) return Failure{matched.error()};
  if (!opposites.empty() && !*matched)
    match(corners, static_cast<std::uint32_t>(mesh.vertices), opposites);
  return Done{};
} catch (const std::bad_alloc&) {
  return fail(ErrorCode::out_of_memory, "not enough memory to decode");
}

Expected<Done> decode_into(std::span<const std::byte> bytes, std::span<std::uint16_t> corners,
                           std::span<HalfEdge> opposites, const DecodeOptions& options) try {
  // As many as the file has, if the call below is not to refuse them.
  std::vector<std::uint32_t> wide(corners.size());
  if (auto ok = decode_into(bytes, wide, opposites, options); !ok) return ok;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (wide[i] > 0xffff)
      return fail(ErrorCode::bad_option,
                  "vertex " + std::to_string(wide[i]) + " does not fit into 16 bits");
    corners[i] = static_cast<std::uint16_t>(wide[i]);
  }
  return Done{};
} catch (const std::bad_alloc&) {
  return fail(ErrorCode::out_of_memory, "not enough memory to decode");
}

}  // namespace clers
