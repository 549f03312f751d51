#include "codec/file/mesh_decoder.h"

#include <algorithm>
#include <atomic>
#include <cstring>
#include <functional>
#include <string>
#include <utility>

#include "codec/base/budget.h"
#include "codec/base/parallel.h"
#include "codec/file/file_order.h"
#include "codec/pieces/seams.h"
#include "codec/soup/degenerate_faces.h"
#include "codec/soup/folded_faces.h"
#include "codec/soup/polygons.h"
#include "codec/soup/raw_faces.h"
#include "codec/soup/repeated_faces.h"
#include "codec/soup/reversed_faces.h"
#include "codec/soup/stitching.h"

namespace clers::internal {
namespace {

Failure<Error> broken(const PieceSections::Stream& stream, std::string what) {
  return fail(ErrorCode::invalid, Place::byte, stream.at, std::move(what));
}

Expected<Done> finished(const rans::Decoder& in, const PieceSections::Stream& stream,
                        const char* what) {
  if (in.finished()) return Done{};
  return broken(stream, std::string(what) + " do not end where their bytes end");
}

Expected<std::vector<ReversedRun>> decode_turned(const PieceSections& sections) {
  rans::Decoder in(sections.turned.bytes);
  DecodeFrom coder(in);
  ReversedModel model;
  std::vector<ReversedRun> runs;
  runs.reserve(static_cast<std::size_t>(sections.turned_runs));
  std::uint32_t end = 0;
  for (std::uint64_t i = 0; i < sections.turned_runs; ++i) {
    const ReversedRun run = model.code(coder, {}, end);
    if (run.first < end || (i > 0 && run.first == end) || run.first >= sections.surface_faces ||
        run.count == 0 || run.count > sections.surface_faces - run.first)
      return broken(sections.turned, "a run of turned faces is out of order or beyond all faces");
    end = run.first + run.count;
    runs.push_back(run);
  }
  if (auto ok = finished(in, sections.turned, "the turned faces"); !ok) return Failure{ok.error()};
  return runs;
}

/// Sizes of the polygons that consecutive triangles make.
Expected<std::vector<std::uint32_t>> decode_sizes(const PieceSections& sections,
                                                  std::span<const std::uint32_t> triangles) {
  rans::Decoder in(sections.polygons.bytes);
  DecodeFrom coder(in);
  SizeModel model;
  std::vector<std::uint32_t> sizes;
  sizes.reserve(static_cast<std::size_t>(sections.faces));  // the loose ones follow
  std::size_t left = triangles.size() / 3;
  for (std::uint64_t i = 0; i < sections.surface_faces; ++i) {
    const std::uint32_t size = model.code(coder, 3);
    if (size < 3 || size - 2 > left)
      return broken(sections.polygons, "polygon " + std::to_string(i) + " has " +
                                           std::to_string(size) + " corners where " +
                                           std::to_string(left) + " triangles are left");
    const std::uint32_t* t = triangles.data() + triangles.size() - 3 * left;
    for (std::uint32_t k = 3; k < size; ++k, t += 3)
      if (t[3] != t[2] || t[4] != t[1])
        return broken(sections.polygons, "the triangles of polygon " + std::to_string(i) +
                                             " do not follow each other");
    left -= size - 2;
    sizes.push_back(size);
  }
  if (left != 0)
    return broken(sections.polygons, std::to_string(left) + " triangles belong to no polygon");
  if (auto ok = finished(in, sections.polygons, "the polygons"); !ok) return Failure{ok.error()};
  return sizes;
}

/// Makes vertices of the mesh of those of the surface, in `introduced_by` too where that is wanted.
Expected<Done> decode_stitches(const PieceSections& sections, std::span<std::uint32_t> triangles,
                               std::vector<std::uint32_t>& introduced_by) {
  rans::Decoder in(sections.stitches.bytes);
  DecodeFrom coder(in);
  std::vector<std::uint32_t> classes(sections.connectivity.vertices);
  if (!Stitching(triangles, sections.connectivity.vertices,
                 static_cast<std::uint32_t>(sections.copies))
           .code(coder, classes))
    return broken(sections.stitches, "a vertex is a copy of none, or there are not " +
                                         std::to_string(sections.copies) + " copies");
  if (auto ok = finished(in, sections.stitches, "the copies"); !ok) return ok;
  number_classes(classes);
  stitch(classes, triangles, introduced_by);
  return Done{};
}

/// Appends the faces that repeat one of the surface, whose corners are in `corners` already.
Expected<Done> append_repeats(const PieceSections& sections, std::vector<std::uint32_t>& sizes,
                              std::vector<std::uint32_t>& corners) {
  rans::Decoder in(sections.repeats.bytes);
  DecodeFrom coder(in);
  RepeatModel model;
  std::uint64_t left = sections.repeated_corners;
  std::uint32_t face = 0;
  std::size_t begin = 0;  // of the face, in corners
  for (std::uint64_t i = 0; i < sections.repeated_faces; ++i) {
    const RepeatModel::Code repeat = model.code(coder, {});
    if (repeat.base < face || repeat.base >= sections.surface_faces)
      return broken(sections.repeats, "repeated face " + std::to_string(i) + " repeats none");
    for (; face < repeat.base; ++face) begin += sizes.empty() ? 3 : sizes[face];
    const std::uint32_t size = sizes.empty() ? 3 : sizes[face];
    if (size > left) return broken(sections.repeats, "more repeated corners than declared");
    left -= size;
    if (!sizes.empty()) sizes.push_back(size);
    corners.push_back(corners[begin]);
    for (std::uint32_t j = 1; j < size; ++j)
      corners.push_back(corners[begin + (repeat.reversed ? size - j : j)]);
  }
  if (left != 0) return broken(sections.repeats, "fewer repeated corners than declared");
  return finished(in, sections.repeats, "the repeated faces");
}

/// Appends the triangles on two vertices of an edge.
Expected<Done> append_folded(const PieceSections& sections,
                             std::span<const std::uint32_t> triangles,
                             std::vector<std::uint32_t>& sizes,
                             std::vector<std::uint32_t>& corners) {
  rans::Decoder in(sections.folded.bytes);
  DecodeFrom coder(in);
  FoldedModel model;
  std::uint32_t last = 0;
  for (std::uint64_t i = 0; i < sections.folded_faces; ++i) {
    const Folded folded = model.code(coder, {});
    const std::uint32_t h = folded.half_edge;
    if (h < last || h >= triangles.size())
      return broken(sections.folded, "folded face " + std::to_string(i) + " has no such edge");
    last = h;
    const std::uint32_t a = triangles[h], b = triangles[h % 3 == 2 ? h - 2 : h + 1];
    if (!sizes.empty()) sizes.push_back(3);
    corners.insert(corners.end(), {a, folded.first_twice ? a : b, b});
  }
  return finished(in, sections.folded, "the folded faces");
}

Expected<Done> append_loose(const PieceSections& sections, std::span<const std::uint32_t> triangles,
                            std::vector<std::uint32_t>& sizes,
                            std::vector<std::uint32_t>& corners) {
  rans::Decoder in(sections.loose.bytes);
  DecodeFrom coder(in);
  DegenerateFaceModel model(triangles, static_cast<std::uint32_t>(sections.surface_vertices),
                            static_cast<std::uint32_t>(sections.vertices));
  std::uint64_t left = sections.loose_corners;
  for (std::uint64_t i = 0; i < sections.loose_faces; ++i) {
    const std::uint32_t size = model.code_size(coder, 0);
    if (size > left) return broken(sections.loose, "more loose corners than declared");
    left -= size;
    sizes.push_back(size);
    corners.resize(corners.size() + size);
    if (!model.code_corners(coder, std::span(corners).last(size)))
      return broken(sections.loose, "loose face " + std::to_string(i) + " has no such vertex");
  }
  if (left != 0) return broken(sections.loose, "fewer loose corners than declared");
  return finished(in, sections.loose, "the loose faces");
}

/// No sizes where all faces are triangles.
void drop_sizes_of_triangles(Mesh& mesh) {
  const auto is_triangle = [](std::uint32_t size) { return size == 3; };
  if (std::all_of(mesh.face_sizes.begin(), mesh.face_sizes.end(), is_triangle))
    mesh.face_sizes = {};
}

Expected<Done> decode_plain(const PieceSections& sections, Mesh& mesh) {
  rans::Decoder in(sections.plain.bytes);
  DecodeFrom coder(in);
  RawFaceModel model(mesh.vertex_count);
  mesh.corners.resize(static_cast<std::size_t>(sections.corners));
  mesh.face_sizes.reserve(static_cast<std::size_t>(sections.faces));
  std::size_t at = 0;
  for (std::uint64_t f = 0; f < sections.faces; ++f) {
    const std::uint32_t size = model.code_size(coder, 0);
    if (size > mesh.corners.size() - at)
      return broken(sections.plain, "more corners than declared");
    if (!model.code_corners(coder, std::span(mesh.corners).subspan(at, size)))
      return broken(sections.plain, "face " + std::to_string(f) + " has no such vertex");
    at += size;
    mesh.face_sizes.push_back(size);
  }
  if (at != mesh.corners.size()) return broken(sections.plain, "fewer corners than declared");
  drop_sizes_of_triangles(mesh);
  return finished(in, sections.plain, "the faces");
}

/// Values in another order: to[i] = from[source(i)], and `values` of them.
template <class Source>
void reorder(Attribute& a, std::size_t values, Source source) {
  const std::size_t stride = a.stride();
  std::vector<std::byte> from = std::move(a.data);
  a.data.resize(from.size());
  for (std::size_t i = 0; i < values; ++i)
    std::memcpy(a.data.data() + i * stride, from.data() + source(i) * stride, stride);
}

/// A piece without attributes, and the surface that those are predicted along.
struct DecodedFaces {
  Mesh mesh;
  std::size_t surface_corners = 0;           ///< so many of mesh.corners are its triangles
  std::vector<std::uint32_t> triangles;      ///< or, with polygons, these are
  std::vector<std::uint32_t> introduced_by;  ///< where it is wanted
  std::vector<ReversedRun> turned;
  ConnectivityCounts counts;

  CodedSurface surface() const {
    return {triangles.empty() ? std::span(mesh.corners).first(surface_corners) : triangles,
            {},
            introduced_by};
  }
};

/// Decodes the triangles of the surface, by vertices of the mesh but for polygons and turned faces.
struct DecodedSurface {
  ConnectivityCounts counts;
  std::vector<ReversedRun> turned;
  std::vector<std::uint32_t> sizes;  ///< of polygons, where there are any
  std::vector<std::uint32_t> introduced_by;
};
Expected<DecodedSurface> decode_surface(const PieceSections& sections,
                                        std::span<std::uint32_t> triangles,
                                        std::span<HalfEdge> twins, bool with_introduced) {
  DecodedSurface result;
  if (with_introduced) result.introduced_by.resize(sections.connectivity.vertices);
  auto counts = decode_connectivity(sections.connectivity_bytes, sections.connectivity_at,
                                    sections.connectivity, triangles, twins, result.introduced_by);
  if (!counts) return Failure{counts.error()};
  result.counts = *counts;
  if (sections.features & feature::reversed) {
    auto turned = decode_turned(sections);
    if (!turned) return Failure{turned.error()};
    result.turned = std::move(*turned);
  }
  if (sections.features & feature::polygons) {
    auto sizes = decode_sizes(sections, triangles);
    if (!sizes) return Failure{sizes.error()};
    result.sizes = std::move(*sizes);
  }
  if (sections.features & feature::copies)
    if (auto ok = decode_stitches(sections, triangles, result.introduced_by); !ok)
      return Failure{ok.error()};
  return result;
}

/// The polygons that triangles make.
void make_polygons(std::span<const std::uint32_t> triangles, std::span<const std::uint32_t> sizes,
                   std::vector<std::uint32_t>& corners) {
  const std::uint32_t* t = triangles.data();
  for (const std::uint32_t size : sizes) {
    corners.insert(corners.end(), {t[0], t[1]});
    for (std::uint32_t k = size - 2; k-- > 0;) corners.push_back(t[3 * std::size_t(k) + 2]);
    t += 3 * std::size_t(size - 2);
  }
}

/// Whether some values are predicted along the surface.
bool predicts_along_surface(const PieceSections& sections, Values values) {
  return values == Values::decode &&
         std::any_of(sections.attributes.begin(), sections.attributes.end(),
                     [](const auto& a) { return a.header.predictor == Predictor::parallelogram; });
}

Expected<DecodedFaces> decode_faces(const PieceSections& sections, bool with_introduced) {
  DecodedFaces result;
  Mesh& mesh = result.mesh;
  mesh.vertex_count = static_cast<std::uint32_t>(sections.vertices);
  if (sections.features == feature::raw) {
    if (auto ok = decode_plain(sections, mesh); !ok) return Failure{ok.error()};
    result.surface_corners = mesh.corners.size();
    if (!mesh.triangles_only()) result.triangles = fan_triangles(mesh.corners, mesh.face_sizes);
    if (with_introduced) {
      const auto along = result.surface().corners;
      const auto last = std::max_element(along.begin(), along.end());
      result.introduced_by.resize(last == along.end() ? 0 : *last + std::size_t(1));
      find_introducing(along, result.introduced_by);
    }
    return result;
  }
  const bool polygons = sections.features & feature::polygons;
  const std::size_t surface_corners = 3 * std::size_t(sections.connectivity.faces);
  std::vector<std::uint32_t> triangles;
  // What is appended to triangles finds room behind them.
  triangles.reserve(polygons ? surface_corners : static_cast<std::size_t>(sections.corners));
  triangles.resize(surface_corners);
  auto surface = decode_surface(sections, triangles, {}, with_introduced);
  if (!surface) return Failure{surface.error()};
  result.counts = surface->counts;
  result.turned = std::move(surface->turned);
  result.introduced_by = std::move(surface->introduced_by);
  std::span<const std::uint32_t> along = triangles;
  if (sections.may_have_sizes()) mesh.face_sizes.reserve(static_cast<std::size_t>(sections.faces));
  if (polygons) {
    mesh.corners.reserve(static_cast<std::size_t>(sections.corners));
    make_polygons(triangles, surface->sizes, mesh.corners);
    mesh.face_sizes.assign(surface->sizes.begin(), surface->sizes.end());
    result.triangles = std::move(triangles);
    along = result.triangles;
  } else {
    result.surface_corners = surface_corners;
    mesh.corners = std::move(triangles);
    if (sections.may_have_sizes()) mesh.face_sizes.assign(surface_corners / 3, 3);
  }
  if (sections.features & feature::repeats)
    if (auto ok = append_repeats(sections, mesh.face_sizes, mesh.corners); !ok)
      return Failure{ok.error()};
  if (sections.features & feature::folded)
    if (auto ok = append_folded(sections, along, mesh.face_sizes, mesh.corners); !ok)
      return Failure{ok.error()};
  if (sections.features & feature::degenerate)
    if (auto ok = append_loose(sections, along, mesh.face_sizes, mesh.corners); !ok)
      return Failure{ok.error()};
  drop_sizes_of_triangles(mesh);
  return result;
}

constexpr std::uint64_t each = sizeof(std::uint32_t);

/// Pieces of fewer corners are decoded before another thread has begun.
constexpr std::uint64_t worth_threads = 1 << 15;

/// What vertices of no surface count, though no array has them before a user makes one.
std::uint64_t isolated_memory(const PieceSections& s) {
  return each * (s.vertices - s.surface_vertices);
}

std::uint64_t attribute_memory(const Attribute& what, std::uint64_t count) {
  return sizeof(Attribute) + what.name.size() + count * what.stride();
}

std::uint64_t count_of(const MeshSections& mesh, Domain domain) {
  switch (domain) {
    case Domain::vertex: return mesh.vertices;
    case Domain::corner: return mesh.corners;
    case Domain::face: return mesh.faces;
  }
  return 0;
}

/// Vertices that no corner names follow those that one does.
std::uint64_t most_used_vertices(const PieceSections& sections) {
  return std::min(sections.vertices, sections.corners);
}

/// Turned faces run the other way until then: values are predicted before.
void turn_back(std::span<std::uint32_t> corners, std::span<const std::uint32_t> sizes,
               std::span<const ReversedRun> runs) {
  std::size_t face = 0, begin = 0;
  const auto size = [&](std::size_t f) { return sizes.empty() ? 3 : sizes[f]; };
  for (const ReversedRun& run : runs) {
    for (; face < run.first; ++face) begin += size(face);
    for (; face < std::size_t(run.first) + run.count; ++face) {
      const auto cycle = corners.subspan(begin, size(face));
      std::reverse(cycle.begin() + 1, cycle.end());
      begin += cycle.size();
    }
  }
}

}  // namespace

PieceMemory memory_of(const PieceSections& s, Values values) {
  // Tables of models and of zstd, which are as large for any piece.
  constexpr std::uint64_t constant = 256 << 10;
  const bool plain = s.features == feature::raw, copied = s.features & feature::copies,
             polygons = s.features & feature::polygons;
  const std::uint64_t sizes = s.may_have_sizes() ? each * s.faces : 0;
  const std::uint64_t triangles = each * (plain      ? 3 * s.corners
                                          : polygons ? 3 * s.connectivity.faces
                                                     : s.corners);
  const std::uint64_t runs = sizeof(ReversedRun) * s.turned_runs;

  PieceMemory memory;
  memory.result = each * s.corners + sizes + isolated_memory(s);
  if (plain) {
    memory.faces = memory.result + triangles;
  } else {
    const std::uint64_t corners = 3 * s.connectivity.faces, vertices = s.connectivity.vertices;
    memory.faces =
        triangles +
        std::max(
            {connectivity_memory(s.connectivity, false),
             runs + sizes +
                 (copied
                      ? each * vertices + std::max(Stitching::memory(corners, vertices, s.copies),
                                                   each * vertices)
                      : 0),
             runs + sizes + (polygons ? memory.result : 0) +
                 (s.features & feature::degenerate ? CornersOf::memory(corners, s.surface_vertices)
                                                   : 0)});
  }
  memory.values = memory.result + runs + (plain || polygons ? triangles : 0);
  if (values == Values::decode) {
    const std::uint64_t held =
        sizeof(Expected<Bytes>) * s.attributes.size() +
        (predicts_along_surface(s, values)
             ? each * (plain ? s.corners > 0 ? s.vertices : 0 : s.connectivity.vertices)
             : 0);
    memory.faces += held;
    memory.values += held;
    std::uint64_t most = 0;
    for (const PieceSections::AttributeSection& a : s.attributes) {
      const std::uint64_t size = attribute_memory(a.header.attribute, a.count);
      memory.result += size;
      memory.values += size + sizeof(std::uint64_t);
      most = std::max(most, decoding_memory(a.header, a.count));
    }
    memory.values += most;
  }
  memory.faces += constant;
  memory.values += constant;
  return memory;
}

namespace {

/// How many threads may decode a piece while `left` bytes are left: at least 1. More than one need
/// room for residuals while faces are decoded, and for what several attributes take at a time.
unsigned workers_of(const PieceSections& sections, const PieceMemory& memory, unsigned threads,
                    std::uint64_t left) {
  const std::size_t attributes = sections.attributes.size();
  if (sections.corners < worth_threads) threads = 1;
  std::vector<std::uint64_t> steps;
  steps.reserve(attributes);
  std::uint64_t residuals = 0;
  for (const PieceSections::AttributeSection& a : sections.attributes) {
    steps.push_back(decoding_memory(a.header, a.count));
    residuals += attribute_memory(a.header.attribute, a.count);
  }
  std::sort(steps.begin(), steps.end(), std::greater<>());
  const std::uint64_t held = memory.values - steps[0];
  const unsigned most = worker_count(threads, attributes + 1);
  std::uint64_t others = 0;  // steps beside the faces
  unsigned fit = 1;
  for (; fit < most; ++fit) {
    others += steps[fit - 1];
    const std::uint64_t after = others + (fit < attributes ? steps[fit] : 0);
    if (std::max(memory.faces + residuals + others, held + after) > left) break;
  }
  return fit;
}

}  // namespace

Expected<DecodedPiece> decode_piece(const PieceSections& sections, Values values, unsigned threads,
                                    std::uint64_t left) {
  const bool along_surface = predicts_along_surface(sections, values);
  const std::size_t attributes = values == Values::decode ? sections.attributes.size() : 0;
  const unsigned workers =
      attributes == 0 ? 1 : workers_of(sections, memory_of(sections, values), threads, left);

  // Residuals need no faces, values need both: so first faces and residuals, then values. Whatever
  // the threads do, the error of the faces comes first, then that of the first attribute.
  Expected<DecodedFaces> decoded = fail(ErrorCode::internal, "not decoded");
  std::vector<Expected<Bytes>> residuals(attributes, fail(ErrorCode::internal, "not decoded"));
  std::atomic<bool> in_vain{false};
  for_each_item(1 + attributes, workers, [&](std::size_t i, unsigned) {
    if (i == 0) {
      decoded = decode_faces(sections, along_surface);
      in_vain = !decoded.ok();
    } else if (!in_vain) {
      const PieceSections::AttributeSection& a = sections.attributes[i - 1];
      residuals[i - 1] = decode_residuals(a.bytes, a.at, a.header, a.count);
    }
  });
  if (!decoded) return Failure{decoded.error()};
  for (const auto& rows : residuals)
    if (!rows) return Failure{rows.error()};

  const CodedSurface surface = decoded->surface();  // survives the move
  DecodedPiece result{std::move(decoded->mesh), decoded->counts, 0};
  result.mesh.attributes.resize(attributes);
  for_each_item(attributes, workers, [&](std::size_t i, unsigned) {
    result.mesh.attributes[i] =
        reconstruct(sections.attributes[i].header, std::move(*residuals[i]), surface);
  });
  turn_back(result.mesh.corners, result.mesh.face_sizes, decoded->turned);
  for (const ReversedRun& run : decoded->turned) result.turned_faces += run.count;
  return result;
}

std::uint64_t numbering_memory(const PieceSections& s) {
  return s.shared * (sizeof(SharedVertex) + each) + each * most_used_vertices(s);
}

Expected<Done> decode_triangles(const PieceSections& sections, std::span<std::uint32_t> corners,
                                std::span<HalfEdge> twins) {
  auto surface = decode_surface(sections, corners, twins, false);
  if (!surface) return Failure{surface.error()};
  turn_back(corners, {}, surface->turned);
  return Done{};
}

Expected<std::vector<SharedVertex>> decode_seam(const PieceSections& sections) {
  std::vector<SharedVertex> seam;
  if (sections.shared == 0) return seam;
  seam.reserve(static_cast<std::size_t>(sections.shared));
  const std::uint64_t vertices = most_used_vertices(sections), before = sections.first_vertex;
  rans::Decoder in(sections.seam.bytes);
  DecodeFrom coder(in);
  SeamModel model;
  std::uint64_t end = 0;
  while (seam.size() < sections.shared) {
    const SeamRun run = model.code(coder, {});
    const std::uint64_t left = sections.shared - seam.size();
    const bool fits = run.count > 0 && run.count <= left && run.first >= end &&
                      run.first < vertices && run.count <= vertices - run.first &&
                      run.global < before &&
                      run.count - 1 <= (run.down ? run.global : before - 1 - run.global);
    if (!fits) return broken(sections.seam, "a seam is out of order or has no such vertex");
    for (std::uint32_t i = 0; i < run.count; ++i) seam.push_back({run.first + i, run.global_at(i)});
    end = std::uint64_t(run.first) + run.count;
  }
  if (auto ok = finished(in, sections.seam, "the seam"); !ok) return Failure{ok.error()};
  std::vector<std::uint32_t> numbers;
  numbers.reserve(seam.size());
  for (const SharedVertex& v : seam) numbers.push_back(v.number);
  std::sort(numbers.begin(), numbers.end());
  if (std::adjacent_find(numbers.begin(), numbers.end()) != numbers.end())
    return broken(sections.seam, "a seam has a vertex twice");
  return seam;
}

Expected<std::vector<std::uint32_t>> number_piece(const PieceSections& sections,
                                                  std::span<std::uint32_t> corners) {
  auto seam = decode_seam(sections);
  if (!seam) return Failure{seam.error()};
  std::vector<std::uint32_t> numbers(static_cast<std::size_t>(most_used_vertices(sections)));
  std::uint32_t next = static_cast<std::uint32_t>(sections.first_vertex);
  auto shared = seam->begin();
  for (std::uint32_t v = 0; v < numbers.size(); ++v)
    numbers[v] = shared != seam->end() && shared->vertex == v ? shared++->number : next++;
  for (std::uint32_t& v : corners) {
    if (v >= numbers.size())
      return fail(ErrorCode::invalid, Place::byte, sections.at,
                  "vertex " + std::to_string(v) + " of a piece of " +
                      std::to_string(sections.corners) + " corners");
    v = numbers[v];
  }
  return numbers;
}

std::uint64_t room_memory(const MeshSections& sections, Values values) {
  std::uint64_t memory =
      each * (sections.corners + (sections.may_have_sizes() ? sections.faces : 0));
  for (const PieceSections& piece : sections.pieces) memory += isolated_memory(piece);
  if (values == Values::skip) return memory;
  for (const PieceSections::AttributeSection& a : sections.pieces[0].attributes)
    memory += attribute_memory(a.header.attribute, count_of(sections, a.header.attribute.domain));
  return memory;
}

Mesh make_room(const MeshSections& sections, Values values) {
  Mesh mesh;
  mesh.vertex_count = static_cast<std::uint32_t>(sections.vertices);
  mesh.corners.resize(static_cast<std::size_t>(sections.corners));
  if (sections.may_have_sizes()) mesh.face_sizes.resize(static_cast<std::size_t>(sections.faces));
  if (values == Values::skip) return mesh;
  mesh.attributes.reserve(sections.pieces[0].attributes.size());
  for (const PieceSections::AttributeSection& a : sections.pieces[0].attributes) {
    Attribute attribute = a.header.attribute;
    const std::uint64_t count = count_of(sections, attribute.domain);
    attribute.data.resize(static_cast<std::size_t>(count) * attribute.stride());
    mesh.attributes.push_back(std::move(attribute));
  }
  return mesh;
}

Expected<Done> put_piece(const PieceSections& sections, const Mesh& piece, Mesh& whole) {
  const auto corners = std::span(whole.corners)
                           .subspan(static_cast<std::size_t>(sections.first_corner),
                                    static_cast<std::size_t>(sections.corners));
  std::copy(piece.corners.begin(), piece.corners.end(), corners.begin());
  auto numbers = number_piece(sections, corners);
  if (!numbers) return Failure{numbers.error()};
  if (!whole.face_sizes.empty()) {
    std::uint32_t* size = whole.face_sizes.data() + sections.first_face;
    if (piece.triangles_only())
      std::fill_n(size, piece.face_count(), 3u);
    else
      std::copy(piece.face_sizes.begin(), piece.face_sizes.end(), size);
  }
  for (std::size_t k = 0; k < piece.attributes.size(); ++k) {
    const Attribute& from = piece.attributes[k];
    std::byte* to = whole.attributes[k].data.data();
    const std::size_t stride = from.stride();
    if (from.domain != Domain::vertex) {
      const std::uint64_t first =
          from.domain == Domain::face ? sections.first_face : sections.first_corner;
      std::copy(from.data.begin(), from.data.end(), to + first * stride);
      continue;
    }
    to += sections.first_vertex * stride;
    for (std::size_t v = 0; v < piece.vertex_count; ++v) {
      if (v < numbers->size() && (*numbers)[v] < sections.first_vertex) continue;
      std::memcpy(to, from.data.data() + v * stride, stride);
      to += stride;
    }
  }
  return Done{};
}

std::uint64_t finishing_memory(const MeshSections& s, Values values) {
  if (!s.has_order) return 0;
  const std::uint64_t sizes = s.may_have_sizes() ? each * s.faces : 0,
                      order = each * (2 * s.faces + s.vertices),
                      faces = Faces::memory(s.corners, s.faces, s.may_have_sizes());
  std::uint64_t most = 0;  // of the attributes, whose values are copied into their order
  if (values == Values::decode)
    for (const PieceSections::AttributeSection& a : s.pieces[0].attributes)
      most = std::max(most,
                      attribute_memory(a.header.attribute, count_of(s, a.header.attribute.domain)));
  return faces + order +
         std::max(faces + FileOrderCoder::memory(s.corners, s.faces, s.vertices),
                  2 * each * s.corners + sizes + each * s.vertices + most);
}

Expected<Done> finish_mesh(const MeshSections& sections, Mesh& mesh) {
  mesh.name = sections.name;
  if (sections.metadata) {
    auto metadata = decode_metadata(*sections.metadata);
    if (!metadata) return Failure{metadata.error()};
    mesh.metadata = std::move(*metadata);
  }
  if (sections.pieces.size() > 1) drop_sizes_of_triangles(mesh);
  if (!sections.has_order) return Done{};
  FileOrder order;
  const Faces faces(mesh.corners, mesh.face_sizes);
  {
    rans::Decoder in(sections.order.bytes);
    DecodeFrom coder(in);
    if (!FileOrderCoder(faces, mesh.vertex_count).code(coder, order))
      return broken(sections.order, "the order names a face or a vertex twice, or none");
    if (auto ok = finished(in, sections.order, "the orders"); !ok) return ok;
  }
  std::vector<std::uint32_t> corners, sizes, source;  // source: the new corner of each old one
  corners.reserve(mesh.corners.size());
  source.reserve(mesh.corners.size());
  sizes.reserve(mesh.face_sizes.size());
  for (std::uint32_t j = 0; j < faces.count(); ++j) {
    const std::uint32_t f = order.faces[j], size = faces.size(f);
    for (std::uint32_t i = 0; i < size; ++i) {
      source.push_back(faces.begin(f) + (order.first_corners[j] + i) % size);
      corners.push_back(order.vertices[mesh.corners[source.back()]]);
    }
    if (!mesh.triangles_only()) sizes.push_back(size);
  }
  std::vector<std::uint32_t> new_vertex(mesh.vertex_count);
  for (std::uint32_t v = 0; v < mesh.vertex_count; ++v) new_vertex[order.vertices[v]] = v;
  for (Attribute& a : mesh.attributes) {
    switch (a.domain) {
      case Domain::vertex:
        reorder(a, new_vertex.size(), [&](std::size_t v) { return new_vertex[v]; });
        break;
      case Domain::face:
        reorder(a, faces.count(), [&](std::size_t f) { return order.faces[f]; });
        break;
      case Domain::corner:
        reorder(a, source.size(), [&](std::size_t c) { return source[c]; });
        break;
    }
  }
  mesh.corners = std::move(corners);
  mesh.face_sizes = std::move(sizes);
  return Done{};
}

}  // namespace clers::internal
