#include "codec/decode.h"

#include <algorithm>
#include <atomic>
#include <utility>

#include "codec/base/budget.h"
#include "codec/base/faces.h"
#include "codec/base/guarded.h"
#include "codec/base/parallel.h"
#include "codec/file/mesh_decoder.h"
#include "codec/soup/edges.h"

namespace clers {
namespace {

using namespace internal;

Failure<Error> in_mesh(Error error, std::size_t mesh, std::size_t meshes) {
  if (meshes > 1) error.what += " (mesh " + std::to_string(mesh) + ")";
  return {std::move(error)};
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

/// Which bytes the parts of a call take, by what headers say.
struct Plan {
  struct Job {
    std::size_t mesh, piece;
  };
  std::vector<Job> jobs;            ///< all pieces of all meshes
  std::vector<std::uint64_t> work;  ///< of each, besides the results
  std::uint64_t results = 0;        ///< all meshes
};

/// What decoding meshes will take, found to be within the budget. Only the plan itself and what
/// goes with each job are taken from it.
Expected<Plan> plan_meshes(std::span<const MeshSections> meshes, Values values, Budget& budget) {
  std::size_t pieces = 0;
  for (const MeshSections& mesh : meshes) pieces += mesh.pieces.size();
  if (auto ok = budget.take(
          pieces * (sizeof(Plan::Job) + 2 * sizeof(std::uint64_t) + sizeof(Expected<Done>)) +
          meshes.size() * sizeof(Mesh));
      !ok)
    return Failure{ok.error()};
  Plan plan;
  plan.jobs.reserve(pieces);
  plan.work.reserve(pieces);
  std::uint64_t most = 0;
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    const MeshSections& mesh = meshes[i];
    const bool whole = mesh.pieces.size() == 1;
    if (!whole) plan.results += room_memory(mesh, values);
    for (std::size_t k = 0; k < mesh.pieces.size(); ++k) {
      const PieceMemory memory = memory_of(mesh.pieces[k], values);
      if (whole) plan.results += memory.result;
      plan.jobs.push_back({i, k});
      plan.work.push_back(whole ? memory.peak() - memory.result
                                : memory.peak() + numbering_memory(mesh.pieces[k]));
      most = std::max(most, plan.work.back());
    }
    most = std::max(most, finishing_memory(mesh, values));
  }
  if (auto ok = budget.check(plan.results + most); !ok) return Failure{ok.error()};
  return plan;
}

/// Decodes meshes with all their values, or only their faces.
Expected<std::vector<Mesh>> decode_meshes(std::span<const MeshSections> sections, Values values,
                                          const DecodeOptions& options, Budget& budget) {
  const auto plan = plan_meshes(sections, values, budget);
  if (!plan) return Failure{plan.error()};
  const std::vector<Plan::Job>& jobs = plan->jobs;
  std::vector<Mesh> meshes(sections.size());
  for (std::size_t i = 0; i < meshes.size(); ++i)
    if (sections[i].pieces.size() > 1) meshes[i] = make_room(sections[i], values);
  std::vector<Expected<Done>> outcomes(jobs.size(), Done{});
  std::atomic<std::size_t> done{0};
  const unsigned threads_inside = jobs.size() > 1 ? 1 : options.threads;
  const unsigned workers =
      workers_that_fit(plan->work, options.threads, budget.left() - plan->results);
  for_each_item(jobs.size(), workers, [&](std::size_t j, unsigned worker) {
    if (options.progress && worker == 0)
      options.progress("decode", static_cast<double>(done) / static_cast<double>(jobs.size()));
    const MeshSections& from = sections[jobs[j].mesh];
    const PieceSections& part = from.pieces[jobs[j].piece];
    Mesh& mesh = meshes[jobs[j].mesh];
    auto piece = decode_piece(part, values, threads_inside, budget.left());
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
    if (auto ok = finish_mesh(sections[i], meshes[i]); !ok)
      return in_mesh(ok.error(), i, meshes.size());
  return meshes;
}

/// Can make_piece do with what is left? Error: limit.
Expected<Done> check_piece(const MeshSections& mesh, const PieceSections& piece,
                           const Budget& budget) {
  const PieceMemory memory = memory_of(piece, Values::decode);
  const std::uint64_t then =
      mesh.pieces.size() > 1 ? numbering_memory(piece) : finishing_memory(mesh, Values::decode);
  return budget.check(std::max(memory.peak(), memory.result + then));
}

Expected<Piece> make_piece(const std::vector<MeshSections>& meshes, std::size_t mesh_index,
                           std::size_t index, unsigned threads, const Budget& budget) {
  const MeshSections& mesh = meshes[mesh_index];
  const PieceSections& sections = mesh.pieces[index];
  auto decoded = decode_piece(sections, Values::decode, threads, budget.left());
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

/// The faces of a mesh of triangles that are decoded where they belong. Returns whether opposites
/// are there too.
Expected<bool> decode_in_place(const MeshSections& mesh, std::span<std::uint32_t> corners,
                               std::span<HalfEdge> opposites, unsigned threads, Budget& budget) {
  const std::size_t pieces = mesh.pieces.size();
  const bool with_twins = pieces == 1 && mesh.pieces[0].features == 0;
  if (auto ok = budget.take(pieces * (sizeof(Expected<Done>) + 2 * sizeof(std::uint64_t))); !ok)
    return Failure{ok.error()};
  std::vector<std::uint64_t> work;
  work.reserve(pieces);
  for (const PieceSections& piece : mesh.pieces)
    work.push_back(memory_of(piece, Values::skip).peak() - piece.corners * sizeof(std::uint32_t) +
                   (pieces > 1 ? numbering_memory(piece) : 0) +
                   connectivity_memory(piece.connectivity, with_twins) -
                   connectivity_memory(piece.connectivity, false));
  if (auto ok = budget.check(*std::max_element(work.begin(), work.end())); !ok)
    return Failure{ok.error()};
  std::vector<Expected<Done>> outcomes(pieces, Done{});
  std::fill(opposites.begin(), opposites.end(), HalfEdge());
  const unsigned workers = workers_that_fit(std::move(work), threads, budget.left());
  for_each_item(pieces, workers, [&](std::size_t k, unsigned) {
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

/// decode_into with what is left of the caller's limits.
Expected<Done> decode_faces_into(std::span<const std::byte> bytes, std::span<std::uint32_t> corners,
                                 std::span<HalfEdge> opposites, const DecodeOptions& options,
                                 Budget& budget) {
  ContainerReader file(bytes);
  auto meshes = read_meshes(file, options.limits, budget);
  if (!meshes) return Failure{meshes.error()};
  if (meshes->size() != 1)
    return fail(ErrorCode::bad_option,
                std::to_string(meshes->size()) + " meshes in the file, expected one");
  const MeshSections& mesh = meshes->front();
  if (corners.size() != mesh.corners || (!opposites.empty() && opposites.size() != mesh.corners))
    return fail(ErrorCode::bad_option,
                "the memory is not for " + std::to_string(mesh.corners) + " corners");
  if (!opposites.empty())
    if (auto ok = budget.check(edges_memory(mesh.corners, mesh.vertices)); !ok) return ok;
  bool matched = false;
  const bool all_on_surface =
      std::all_of(mesh.pieces.begin(), mesh.pieces.end(), [](const PieceSections& piece) {
        return !piece.may_have_sizes() && piece.faces == piece.surface_faces;
      });
  if (!all_on_surface || mesh.has_order) {
    DecodeOptions quiet;
    quiet.threads = options.threads;
    auto decoded = decode_meshes(*meshes, Values::skip, quiet, budget);
    if (!decoded) return Failure{decoded.error()};
    const Mesh& whole = decoded->front();
    if (!whole.triangles_only())
      return fail(ErrorCode::bad_option, "not all faces of the mesh are triangles");
    std::copy(whole.corners.begin(), whole.corners.end(), corners.begin());
  } else {
    auto in_place = decode_in_place(mesh, corners, opposites, options.threads, budget);
    if (!in_place) return Failure{in_place.error()};
    matched = *in_place;
  }
  if (!opposites.empty() && !matched)
    match(corners, static_cast<std::uint32_t>(mesh.vertices), opposites);
  return Done{};
}

}  // namespace

Expected<std::vector<Mesh>> decode(std::span<const std::byte> bytes, const DecodeOptions& options) {
  return guarded("decode", [&]() -> Expected<std::vector<Mesh>> {
    Budget budget(options.limits, bytes.size());
    ContainerReader file(bytes);
    const auto sections = read_meshes(file, options.limits, budget);
    if (!sections) return Failure{sections.error()};
    auto meshes = decode_meshes(*sections, Values::decode, options, budget);
    if (meshes && options.progress) options.progress("done", 1.0);
    return meshes;
  });
}

Expected<Done> decode_pieces(std::span<const std::byte> bytes,
                             const std::function<void(Piece)>& take, const DecodeOptions& options) {
  if (!take) return fail(ErrorCode::bad_option, "no function to take the pieces");
  return guarded("decode", [&]() -> Expected<Done> {
    Budget budget(options.limits, bytes.size());
    ContainerReader file(bytes);
    const auto meshes = read_meshes(file, options.limits, budget);
    if (!meshes) return Failure{meshes.error()};
    std::size_t all = 0, done = 0;
    for (const MeshSections& mesh : *meshes) {
      all += mesh.pieces.size();
      for (const PieceSections& piece : mesh.pieces)
        if (auto ok = check_piece(mesh, piece, budget); !ok) return ok;
    }
    for (std::size_t i = 0; i < meshes->size(); ++i)
      for (std::size_t k = 0; k < (*meshes)[i].pieces.size(); ++k) {
        if (options.progress)
          options.progress("decode", static_cast<double>(done++) / static_cast<double>(all));
        auto piece = make_piece(*meshes, i, k, 1, budget);
        if (!piece) return Failure{piece.error()};
        take(std::move(*piece));
      }
    if (options.progress) options.progress("done", 1.0);
    return Done{};
  });
}

Expected<Piece> decode_piece(std::span<const std::byte> bytes, std::size_t index,
                             const DecodeOptions& options) {
  return guarded("decode", [&]() -> Expected<Piece> {
    Budget budget(options.limits, bytes.size());
    ContainerReader file(bytes);
    const auto meshes = read_meshes(file, options.limits, budget);
    if (!meshes) return Failure{meshes.error()};
    std::size_t before = 0;
    for (std::size_t i = 0; i < meshes->size(); ++i) {
      const MeshSections& mesh = (*meshes)[i];
      if (index - before < mesh.pieces.size()) {
        if (auto ok = check_piece(mesh, mesh.pieces[index - before], budget); !ok)
          return Failure{ok.error()};
        return make_piece(*meshes, i, index - before, options.threads, budget);
      }
      before += mesh.pieces.size();
    }
    return fail(ErrorCode::bad_option,
                "piece " + std::to_string(index) + ", there are " + std::to_string(before));
  });
}

Expected<std::vector<MeshSizes>> sizes(std::span<const std::byte> bytes, const Limits& limits) {
  return guarded("decode", [&]() -> Expected<std::vector<MeshSizes>> {
    Budget budget(limits, bytes.size());
    ContainerReader file(bytes);
    const auto meshes = read_meshes(file, limits, budget);
    if (!meshes) return Failure{meshes.error()};
    if (auto plan = plan_meshes(*meshes, Values::decode, budget); !plan)
      return Failure{plan.error()};
    std::vector<MeshSizes> result;
    result.reserve(meshes->size());
    for (const MeshSections& m : *meshes)
      result.push_back({m.vertices, m.faces, m.corners, m.pieces.size()});
    return result;
  });
}

Expected<Done> decode_into(std::span<const std::byte> bytes, std::span<std::uint32_t> corners,
                           std::span<HalfEdge> opposites, const DecodeOptions& options) {
  return guarded("decode", [&] {
    Budget budget(options.limits, bytes.size());
    return decode_faces_into(bytes, corners, opposites, options, budget);
  });
}

Expected<Done> decode_into(std::span<const std::byte> bytes, std::span<std::uint16_t> corners,
                           std::span<HalfEdge> opposites, const DecodeOptions& options) {
  return guarded("decode", [&]() -> Expected<Done> {
    Budget budget(options.limits, bytes.size());
    // As many as the file has, if the call below is not to refuse them.
    if (auto ok = budget.take(corners.size() * sizeof(std::uint32_t)); !ok) return ok;
    std::vector<std::uint32_t> wide(corners.size());
    if (auto ok = decode_faces_into(bytes, wide, opposites, options, budget); !ok) return ok;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      if (wide[i] > 0xffff)
        return fail(ErrorCode::bad_option,
                    "vertex " + std::to_string(wide[i]) + " does not fit into 16 bits");
      corners[i] = static_cast<std::uint16_t>(wide[i]);
    }
    return Done{};
  });
}

}  // namespace clers
