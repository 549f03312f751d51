// A coded piece travels as a file of one mesh: its sections are those that the joined file has.
#include "codec/apart.h"

#include <xxhash.h>

#include <algorithm>
#include <string>
#include <utility>

#include "codec/base/faces.h"
#include "codec/base/guarded.h"
#include "codec/base/wide_corners.h"
#include "codec/file/container.h"
#include "codec/file/cut_mesh.h"
#include "codec/file/mesh_encoder.h"
#include "codec/file/metadata.h"
#include "codec/file/piece_encoder.h"
#include "codec/numbers/plan_format.h"

namespace CLERS_VISIBLE clers {

using namespace internal;

struct PiecesApart::State {
  std::vector<std::uint32_t> wide;
  MeshView mesh;
  EncodeOptions options;
  CutMesh cut;
  Bytes plan;
};

namespace {

Bytes plan_bytes(std::span<const AttributePlan> plans) {
  Bytes out;
  put_varint(out, plans.size());
  for (const AttributePlan& plan : plans) put_plan(out, plan);
  put_u32(out, XXH32(out.data(), out.size(), 0));
  return out;
}

Expected<std::vector<AttributePlan>> plans_of(std::span<const std::byte> bytes,
                                              std::size_t attributes) {
  const auto damaged = fail(ErrorCode::corrupt, "the plan of a piece is damaged");
  if (bytes.size() < sizeof(std::uint32_t)) return damaged;
  const auto said = bytes.first(bytes.size() - sizeof(std::uint32_t));
  ByteReader check(bytes.last(sizeof(std::uint32_t)), 0);
  if (check.u32() != XXH32(said.data(), said.size(), 0)) return damaged;
  ByteReader in(said, 0);
  std::vector<AttributePlan> plans;
  for (std::uint64_t left = in.varint(); in.ok() && left > 0; --left)
    plans.push_back(read_plan(in));
  if (!in.ok() || in.left() > 0) return damaged;
  if (!plans.empty() && plans.size() != attributes)
    return fail(ErrorCode::bad_option, "the plan is of " + std::to_string(plans.size()) +
                                           " attributes, and the piece has " +
                                           std::to_string(attributes));
  return plans;
}

/// Whether numbers are 0 .. size - 1, each once.
bool is_order(std::span<const std::uint32_t> numbers, std::size_t size) {
  std::vector<bool> seen(size);
  for (const std::uint32_t n : numbers) {
    if (n >= size || seen[n]) return false;
    seen[n] = true;
  }
  return numbers.size() == size;
}

/// Brings a piece into the terms of the whole mesh.
Expected<EncodedMesh> piece_of(const CodedPiece& coded, const PieceCutter::Piece& piece,
                               std::span<const std::uint32_t> faces, int level) {
  if (!is_order(coded.order.vertices, piece.vertices.size()) ||
      !is_order(coded.order.faces, faces.size()) ||
      coded.order.first_corners.size() != faces.size())
    return fail(ErrorCode::bad_option, "an order that is not of this piece");
  const Cycles cycles(piece.mesh.corners, piece.mesh.face_sizes);
  for (std::size_t i = 0; i < faces.size(); ++i)
    if (coded.order.first_corners[i] >= std::max(cycles.size(coded.order.faces[i]), 1u))
      return fail(ErrorCode::bad_option, "an order that begins with a corner that no face has");
  ContainerReader file(coded.bytes);
  if (auto ok = file.open(); !ok) return Failure{ok.error()};
  EncodedMesh result;
  for (;;) {
    auto section = file.next();
    if (!section) return Failure{section.error()};
    if (section->kind == SectionKind::end) break;
    const SectionKind expected =
        result.sections.empty() ? SectionKind::mesh : SectionKind::attribute;
    if (section->kind != expected)
      return fail(ErrorCode::invalid, Place::byte, section->at, "a section that no piece has");
    result.sections.push_back(
        {section->kind, Bytes(section->payload.begin(), section->payload.end())});
  }
  if (result.sections.size() != 1 + piece.mesh.attributes.size() || file.level() != level)
    return fail(ErrorCode::bad_option, "a file that is not of this piece");
  result.order = coded.order;
  for (std::uint32_t& v : result.order.vertices) v = piece.vertices[v];
  for (std::uint32_t& f : result.order.faces) f = faces[f];
  return result;
}

Failure<Error> in_piece(Error error, std::size_t piece) {
  error.what += " (piece " + std::to_string(piece) + ")";
  return {std::move(error)};
}

}  // namespace

Expected<PiecesApart> PiecesApart::cut(const MeshView& mesh, const EncodeOptions& options) {
  return guarded("cut a mesh", [&]() -> Expected<PiecesApart> {
    if (auto ok = check_options(options); !ok) return Failure{ok.error()};
    auto state = std::make_shared<State>();
    auto wide = with_wide_corners(mesh, state->wide);
    if (!wide) return Failure{wide.error()};
    state->mesh = *wide;
    state->options = options;
    if (auto ok = check(state->mesh, options); !ok) return Failure{ok.error()};
    if (auto ok = check_precisions({&state->mesh, 1}, options); !ok) return Failure{ok.error()};
    auto cut = cut_mesh(state->mesh, options, options.threads);
    if (!cut) return Failure{cut.error()};
    state->cut = std::move(*cut);
    state->plan = plan_bytes(state->cut.quantised.plans);
    return PiecesApart(std::move(state));
  });
}

std::size_t PiecesApart::count() const {
  return state_->cut.cutter ? state_->cut.cutter->count() : 0;
}

std::span<const std::byte> PiecesApart::plan() const {
  return state_->plan;
}

Expected<Mesh> PiecesApart::piece(std::size_t index) const {
  if (index >= count())
    return fail(ErrorCode::bad_option,
                "piece " + std::to_string(index) + ", and there are " + std::to_string(count()));
  return guarded("cut a piece", [&]() -> Expected<Mesh> {
    std::vector<std::uint32_t> number;
    return state_->cut.cutter->cut(index, number).mesh;
  });
}

Expected<PiecesApart::Joined> PiecesApart::join(std::span<const CodedPiece> pieces) const {
  if (pieces.size() != count() || pieces.empty())
    return fail(ErrorCode::bad_option,
                std::to_string(pieces.size()) + " pieces, expected " + std::to_string(count()));
  return guarded("join pieces", [&]() -> Expected<Joined> {
    const State& s = *state_;
    std::vector<EncodedMesh> all;
    std::vector<std::uint32_t> number;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      auto piece = piece_of(pieces[i], s.cut.cutter->cut(i, number), s.cut.cutter->faces(i),
                            s.options.level);
      if (!piece) return in_piece(piece.error(), i);
      all.push_back(std::move(*piece));
    }
    EncodedMesh whole = join_pieces(std::move(all), s.mesh, s.options.order);
    ContainerWriter out(s.options.level);
    for (const EncodedSection& section : whole.sections) out.section(section.kind, section.payload);
    if (!s.mesh.metadata.empty()) {
      auto metadata = encode_metadata(s.mesh.metadata);
      if (!metadata) return Failure{metadata.error()};
      out.section(SectionKind::metadata, *metadata);
    }
    return Joined{out.finish(1), std::move(whole.order)};
  });
}

Expected<CodedPiece> encode_piece(const MeshView& given, std::span<const std::byte> plan,
                                  const EncodeOptions& options) {
  return guarded("encode a piece", [&]() -> Expected<CodedPiece> {
    if (auto ok = check_options(options); !ok) return Failure{ok.error()};
    std::vector<std::uint32_t> memory;
    const auto piece = with_wide_corners(given, memory);
    if (!piece) return Failure{piece.error()};
    EncodeOptions alone;
    alone.level = options.level;
    if (auto ok = check(*piece, alone); !ok) return Failure{ok.error()};
    if (!piece->name.empty() || !piece->metadata.empty())
      return fail(ErrorCode::bad_option, "a piece with a name or metadata, which are of the mesh");
    const auto plans = plans_of(plan, piece->attributes.size());
    if (!plans) return Failure{plans.error()};
    const auto progress = [&](std::string_view stage, double share) {
      if (options.progress) options.progress(stage, share);
    };
    auto coded = encode_mesh(*piece, alone, *plans, options.threads, progress);
    if (!coded) return Failure{coded.error()};
    ContainerWriter out(options.level);
    for (const EncodedSection& section : coded->sections)
      out.section(section.kind, section.payload);
    return CodedPiece{out.finish(1), std::move(coded->order)};
  });
}

}  // namespace clers
