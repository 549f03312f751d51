// Checks all meshes, makes one list of their pieces for threads, and joins what comes of them in
// the order of the list.
#include "codec/encode.h"

#include <algorithm>
#include <atomic>
#include <utility>

#include "codec/base/guarded.h"
#include "codec/base/in_mesh.h"
#include "codec/base/parallel.h"
#include "codec/base/wide_corners.h"
#include "codec/file/container.h"
#include "codec/file/cut_mesh.h"
#include "codec/file/mesh_encoder.h"
#include "codec/file/metadata.h"
#include "codec/file/piece_encoder.h"
#include "codec/file/quantised_mesh.h"
#include "codec/file/scene_encoder.h"

namespace CLERS_VISIBLE clers {
namespace {

using namespace internal;

/// A mesh on its way: whole, or parted into pieces.
struct Work : CutMesh {
  std::vector<Expected<EncodedMesh>> coded;  ///< a mesh, or pieces
};

Expected<Done> prepare(const MeshView& mesh, const EncodeOptions& options, unsigned threads,
                       Work& work) {
  auto cut = cut_mesh(mesh, options, threads);
  if (!cut) return Failure{cut.error()};
  static_cast<CutMesh&>(work) = std::move(*cut);
  work.coded.assign(work.cutter ? work.cutter->count() : 1,
                    fail(ErrorCode::internal, "a piece is not encoded"));
  return Done{};
}

/// All of a mesh, once its pieces are coded.
EncodedMesh finish(Work work, const MeshView& mesh, const EncodeOptions& options) {
  if (!work.cutter) return std::move(*work.coded[0]);
  std::vector<EncodedMesh> pieces;
  for (auto& piece : work.coded) pieces.push_back(std::move(*piece));
  return join_pieces(std::move(pieces), mesh, options.order);
}

/// `scene`: what there is besides the meshes; none if nothing.
Expected<Encoded> encode_meshes(std::span<const MeshView> given, const EncodeOptions& options,
                                const Scene* scene = nullptr, std::span<const Order> orders = {}) {
  if (auto ok = check_options(options); !ok) return Failure{ok.error()};
  std::vector<MeshView> meshes;
  std::vector<std::vector<std::uint32_t>> wide(given.size());
  meshes.reserve(given.size());
  for (std::size_t i = 0; i < given.size(); ++i) {
    const auto mesh = with_wide_corners(given[i], wide[i]);
    if (!mesh) return in_mesh(mesh.error(), i, given.size());
    meshes.push_back(*mesh);
  }
  for (const Order order : orders)
    if (order > Order::keep) return fail(ErrorCode::bad_option, "no such order");
  if (!orders.empty() && orders.size() != meshes.size())
    return fail(ErrorCode::bad_option, std::to_string(orders.size()) + " orders of " +
                                           std::to_string(meshes.size()) + " meshes");
  for (std::size_t i = 0; i < meshes.size(); ++i)
    if (auto ok = check(meshes[i], options); !ok) return in_mesh(ok.error(), i, meshes.size());
  if (auto ok = check_precisions(meshes, options,
                                 scene ? std::span(scene->arrays) : std::span<const Array>());
      !ok)
    return Failure{ok.error()};
  if (scene)
    if (auto ok = check_scene(*scene); !ok) return Failure{ok.error()};
  std::vector<EncodeOptions> of_mesh(orders.empty() ? 0 : meshes.size(), options);
  for (std::size_t i = 0; i < of_mesh.size(); ++i) of_mesh[i].order = orders[i];
  const auto options_of = [&](std::size_t mesh) -> const EncodeOptions& {
    return of_mesh.empty() ? options : of_mesh[mesh];
  };

  struct Job {
    std::size_t mesh, piece;
  };
  std::vector<Work> works(meshes.size());
  std::vector<Expected<Done>> prepared(meshes.size(), Done{});
  const unsigned threads_in_mesh = meshes.size() > 1 ? 1 : options.threads;
  for_each_item(meshes.size(), options.threads, [&](std::size_t i, unsigned) {
    prepared[i] = prepare(meshes[i], options, threads_in_mesh, works[i]);
  });
  for (std::size_t i = 0; i < meshes.size(); ++i)
    if (!prepared[i]) return in_mesh(prepared[i].error(), i, meshes.size());
  std::vector<Job> jobs;
  for (std::size_t i = 0; i < meshes.size(); ++i)
    for (std::size_t k = 0; k < works[i].coded.size(); ++k) jobs.push_back({i, k});

  EncodeOptions in_pieces = options;
  in_pieces.order = Order::free;
  std::atomic<std::size_t> done{0};
  std::vector<std::vector<std::uint32_t>> memory(worker_count(options.threads, jobs.size()));
  const unsigned threads_inside = jobs.size() > 1 ? 1 : options.threads;
  for_each_item(jobs.size(), options.threads, [&](std::size_t j, unsigned worker) {
    double last = 0;
    const auto progress = [&](std::string_view stage, double share) {
      if (!options.progress || worker != 0) return;
      last = std::max(last, (static_cast<double>(done) + share) / static_cast<double>(jobs.size()));
      options.progress(stage, last);
    };
    Work& work = works[jobs[j].mesh];
    const std::size_t k = jobs[j].piece;
    const QuantisedMesh& quantised = work.quantised;
    work.coded[k] = work.cutter
                        ? encode_piece(work.cutter->cut(k, memory[worker]), work.cutter->faces(k),
                                       in_pieces, quantised.plans, progress)
                        : encode_mesh(quantised.mesh, options_of(jobs[j].mesh), quantised.plans,
                                      threads_inside, progress);
    ++done;
  });
  for (const Job& job : jobs)
    if (const auto& coded = works[job.mesh].coded[job.piece]; !coded)
      return in_mesh(coded.error(), job.mesh, meshes.size());

  ContainerWriter out(options.level);
  Encoded result;
  if (scene)
    if (auto ok = put_before_meshes(*scene, out, result.scene); !ok) return Failure{ok.error()};
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    for (Warning& warning : works[i].quantised.warnings) {
      warning.mesh = i;
      result.warnings.push_back(std::move(warning));
    }
    EncodedMesh coded = finish(std::move(works[i]), meshes[i], options_of(i));
    for (const EncodedSection& section : coded.sections) out.section(section.kind, section.payload);
    if (!meshes[i].metadata.empty()) {
      auto metadata = encode_metadata(meshes[i].metadata);
      if (!metadata) return in_mesh(metadata.error(), i, meshes.size());
      coded.info.metadata_bytes = metadata->size();
      out.section(SectionKind::metadata, *metadata);
    }
    result.permutations.push_back(std::move(coded.order));
    result.report.push_back(std::move(coded.info));
    result.counts.push_back(coded.counts);
  }
  if (scene)
    if (auto ok = put_after_meshes(*scene, result.permutations, options, out, result.scene); !ok)
      return Failure{ok.error()};
  result.bytes = out.finish(meshes.size());
  if (options.progress) options.progress("done", 1.0);
  return result;
}

}  // namespace

Expected<Encoded> encode(const MeshView& mesh, const EncodeOptions& options) {
  return encode({&mesh, 1}, options);
}

Expected<Encoded> encode(std::span<const MeshView> meshes, const EncodeOptions& options) {
  return guarded("encode", [&] { return encode_meshes(meshes, options); });
}

Expected<Encoded> encode(std::span<const Mesh> meshes, const EncodeOptions& options) {
  return guarded("encode", [&] {
    const std::vector<MeshView> views(meshes.begin(), meshes.end());
    return encode_meshes(views, options);
  });
}

Expected<Encoded> encode(const Scene& scene, const EncodeOptions& options,
                         std::span<const Order> orders) {
  return guarded("encode", [&] {
    const std::vector<MeshView> views(scene.meshes.begin(), scene.meshes.end());
    return encode_meshes(views, options, &scene, orders);
  });
}

}  // namespace clers
