// What was read once, and for each call a copy of the budget that is left.
#include "codec/decoder.h"

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>

#include "codec/base/guarded.h"
#include "codec/base/in_mesh.h"
#include "codec/file/decode_meshes.h"
#include "codec/file/mesh_decoder.h"
#include "codec/file/open_file.h"
#include "codec/file/target_decoder.h"

namespace CLERS_VISIBLE clers {

struct Decoder::State {
  internal::OpenFile file;
  DecodeOptions options;
  std::vector<std::size_t> ends;  ///< of each mesh: its pieces and those of meshes before

  struct Place {
    std::size_t mesh, index;  ///< the index is among the pieces of that mesh
  };
  /// Precondition: there is such a piece.
  Place place_of(std::size_t piece) const {
    const auto mesh =
        static_cast<std::size_t>(std::upper_bound(ends.begin(), ends.end(), piece) - ends.begin());
    return {mesh, piece - (mesh == 0 ? 0 : ends[mesh - 1])};
  }
};

namespace {

using namespace internal;

/// Can make_piece do with what is left? Error: limit.
Expected<Done> check_piece(const MeshSections& mesh, const PieceSections& piece,
                           const Budget& budget) {
  const PieceMemory memory = memory_of(piece, Values::decode);
  const std::uint64_t then =
      mesh.pieces.size() > 1 ? numbering_memory(piece) : finishing_memory(mesh, Values::decode);
  return budget.check(std::max(memory.peak(), memory.result + then));
}

Expected<Piece> make_piece(const MeshSections& mesh, std::size_t mesh_index, std::size_t index,
                           unsigned threads, const Budget& budget) {
  const PieceSections& sections = mesh.pieces[index];
  if (auto ok = check_piece(mesh, sections, budget); !ok) return Failure{ok.error()};
  auto decoded = decode_piece(sections, Values::decode, threads, budget.left());
  if (!decoded) return Failure{decoded.error()};
  Piece piece{mesh_index, index, mesh.pieces.size(), std::move(decoded->mesh), {}, 0, 0};
  if (piece.count == 1) {
    if (auto ok = finish_mesh(mesh, piece.mesh); !ok) return Failure{ok.error()};
    return piece;
  }
  auto seam = decode_seam(sections);
  if (!seam) return Failure{seam.error()};
  piece.seam = std::move(*seam);
  piece.mesh.name = mesh.name;
  if (index == 0 && mesh.metadata) {
    auto metadata = decode_metadata(*mesh.metadata);
    if (!metadata) return Failure{metadata.error()};
    piece.mesh.metadata = std::move(*metadata);
  }
  piece.first_vertex = static_cast<std::uint32_t>(sections.first_vertex);
  piece.first_face = static_cast<std::uint32_t>(sections.first_face);
  return piece;
}

/// Callers make memory for the vertices that headers say, of which some cost no byte.
Expected<Done> check_isolated(const OpenFile& file) {
  for (const MeshSections& mesh : file.meshes) {
    std::uint64_t isolated = 0;
    for (const PieceSections& piece : mesh.pieces)
      isolated += piece.vertices - piece.surface_vertices;
    if (auto ok = file.budget.check(sizeof(std::uint32_t) * isolated); !ok) return ok;
  }
  return Done{};
}

Failure<Error> no_such(const char* what, std::size_t index, std::size_t count) {
  return fail(ErrorCode::bad_option, std::string(what) + " " + std::to_string(index) +
                                         ", there are " + std::to_string(count));
}

}  // namespace

Expected<Decoder> Decoder::open(std::span<const std::byte> bytes, DecodeOptions options) {
  return guarded("decode", [&]() -> Expected<Decoder> {
    auto file = open_file(bytes, options.limits);
    if (!file) return Failure{file.error()};
    if (auto ok = check_isolated(*file); !ok) return Failure{ok.error()};
    if (auto ok = file->budget.take(sizeof(State) + file->meshes.size() * sizeof(std::size_t)); !ok)
      return Failure{ok.error()};
    auto state = std::make_shared<State>(State{std::move(*file), std::move(options), {}});
    state->ends.reserve(state->file.meshes.size());
    std::size_t end = 0;
    for (const MeshSections& mesh : state->file.meshes)
      state->ends.push_back(end += mesh.pieces.size());
    return Decoder(std::move(state));
  });
}

std::size_t Decoder::mesh_count() const {
  return state_->file.meshes.size();
}

std::size_t Decoder::piece_count() const {
  return state_->ends.empty() ? 0 : state_->ends.back();
}

Expected<FileInfo> Decoder::info() const {
  return guarded("decode", [&]() -> Expected<FileInfo> {
    if (auto ok = state_->file.budget.check(info_memory(state_->file)); !ok)
      return Failure{ok.error()};
    return info_of(state_->file, true);
  });
}

Expected<PieceInfo> Decoder::piece_info(std::size_t piece) const {
  return guarded("decode", [&]() -> Expected<PieceInfo> {
    if (piece >= piece_count()) return no_such("piece", piece, piece_count());
    const auto [mesh, index] = state_->place_of(piece);
    const auto& pieces = state_->file.meshes[mesh].pieces;
    const PieceSections& s = pieces[index];
    return PieceInfo{mesh,
                     index,
                     pieces.size(),
                     s.vertices,
                     s.faces,
                     s.corners,
                     !s.may_have_sizes(),
                     static_cast<std::uint32_t>(s.first_vertex),
                     static_cast<std::uint32_t>(s.first_face)};
  });
}

Expected<std::vector<Mesh>> Decoder::decode() const {
  return guarded("decode", [&] {
    Budget budget = state_->file.budget;
    auto meshes = decode_meshes(state_->file.meshes, Values::decode, state_->options, budget);
    if (meshes && state_->options.progress) state_->options.progress("done", 1.0);
    return meshes;
  });
}

Expected<Mesh> Decoder::decode(std::size_t mesh) const {
  return guarded("decode", [&]() -> Expected<Mesh> {
    if (mesh >= mesh_count()) return no_such("mesh", mesh, mesh_count());
    Budget budget = state_->file.budget;
    auto meshes =
        decode_meshes({&state_->file.meshes[mesh], 1}, Values::decode, state_->options, budget);
    if (!meshes) return Failure{meshes.error()};
    if (state_->options.progress) state_->options.progress("done", 1.0);
    return std::move(meshes->front());
  });
}

Expected<Done> Decoder::decode_into(std::size_t mesh, const MeshTarget& target) const {
  return guarded("decode", [&]() -> Expected<Done> {
    if (mesh >= mesh_count()) return no_such("mesh", mesh, mesh_count());
    Budget budget = state_->file.budget;
    return internal::decode_into(state_->file.meshes[mesh], target, state_->options, budget);
  });
}

Expected<Piece> Decoder::decode_piece(std::size_t piece) const {
  return guarded("decode", [&]() -> Expected<Piece> {
    if (piece >= piece_count()) return no_such("piece", piece, piece_count());
    const auto [mesh, index] = state_->place_of(piece);
    auto made = make_piece(state_->file.meshes[mesh], mesh, index, state_->options.threads,
                           state_->file.budget);
    if (!made) return in_mesh(made.error(), mesh, mesh_count());
    return made;
  });
}

}  // namespace clers
