// All pieces of all meshes are one list, of which as many are decoded at a time as there is memory
// for.
#include "codec/file/decode_meshes.h"

#include <algorithm>
#include <utility>

#include "codec/base/in_mesh.h"
#include "codec/file/decode_jobs.h"

namespace clers::internal {
namespace {

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

}  // namespace

Expected<std::vector<Mesh>> decode_meshes(std::span<const MeshSections> sections, Values values,
                                          const DecodeOptions& options, Budget& budget) {
  const auto plan = plan_meshes(sections, values, budget);
  if (!plan) return Failure{plan.error()};
  const std::vector<Plan::Job>& jobs = plan->jobs;
  std::vector<Mesh> meshes(sections.size());
  for (std::size_t i = 0; i < meshes.size(); ++i)
    if (sections[i].pieces.size() > 1) meshes[i] = make_room(sections[i], values);
  const unsigned threads_inside = jobs.size() > 1 ? 1 : options.threads;
  const auto outcomes = run_decode_jobs(
      plan->work, budget.left() - plan->results, options, [&](std::size_t j) -> Expected<Done> {
        const MeshSections& from = sections[jobs[j].mesh];
        const PieceSections& part = from.pieces[jobs[j].piece];
        Mesh& mesh = meshes[jobs[j].mesh];
        auto piece = decode_piece(part, values, threads_inside, budget.left());
        if (!piece) return Failure{piece.error()};
        if (from.pieces.size() > 1) return put_piece(part, piece->mesh, mesh);
        mesh = std::move(piece->mesh);
        return Done{};
      });
  for (std::size_t j = 0; j < jobs.size(); ++j)
    if (!outcomes[j]) return in_mesh(outcomes[j].error(), jobs[j].mesh, meshes.size());
  for (std::size_t i = 0; i < meshes.size(); ++i)
    if (auto ok = finish_mesh(sections[i], meshes[i]); !ok)
      return in_mesh(ok.error(), i, meshes.size());
  return meshes;
}

}  // namespace clers::internal
