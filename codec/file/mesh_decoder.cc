#include "codec/file/mesh_decoder.h"

#include <algorithm>
#include <cstring>
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

/// Makes vertices of the mesh of those of the surface.
Expected<Done> stitch(const PieceSections& sections, std::span<std::uint32_t> triangles) {
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
  for (std::uint32_t& v : triangles) v = classes[v];
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

/// A piece without attributes, and the triangles that those are predicted along.
struct DecodedFaces {
  Mesh mesh;
  std::size_t surface_corners = 0;       ///< so many of mesh.corners are those triangles
  std::vector<std::uint32_t> triangles;  ///< or, with polygons, these are
  std::vector<ReversedRun> turned;
  ConnectivityCounts counts;

  std::span<const std::uint32_t> predicted_along() const {
    return triangles.empty() ? std::span(mesh.corners).first(surface_corners) : triangles;
  }
};

/// Decodes the triangles of the surface, by vertices of the mesh but for polygons and turned faces.
struct DecodedSurface {
  ConnectivityCounts counts;
  std::vector<ReversedRun> turned;
  std::vector<std::uint32_t> sizes;  ///< of polygons, where there are any
};
Expected<DecodedSurface> decode_surface(const PieceSections& sections,
                                        std::span<std::uint32_t> triangles,
                                        std::span<HalfEdge> twins = {}) {
  DecodedSurface result;
  auto counts = decode_connectivity(sections.connectivity_bytes, sections.connectivity_at,
                                    sections.connectivity, triangles, twins);
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
    if (auto ok = stitch(sections, triangles); !ok) return Failure{ok.error()};
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

Expected<DecodedFaces> decode_faces(const PieceSections& sections) {
  DecodedFaces result;
  Mesh& mesh = result.mesh;
  mesh.vertex_count = static_cast<std::uint32_t>(sections.vertices);
  if (sections.features == feature::raw) {
    if (auto ok = decode_plain(sections, mesh); !ok) return Failure{ok.error()};
    result.surface_corners = mesh.corners.size();
    if (!mesh.triangles_only()) result.triangles = fan_triangles(mesh.corners, mesh.face_sizes);
    return result;
  }
  const bool polygons = sections.features & feature::polygons;
  const std::size_t surface_corners = 3 * std::size_t(sections.connectivity.faces);
  std::vector<std::uint32_t> triangles;
  // What is appended to triangles finds room behind them.
  triangles.reserve(polygons ? surface_corners : static_cast<std::size_t>(sections.corners));
  triangles.resize(surface_corners);
  auto surface = decode_surface(sections, triangles);
  if (!surface) return Failure{surface.error()};
  result.counts = surface->counts;
  result.turned = std::move(surface->turned);
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

/// What vertices of no surface count, though no array has them before a user makes one.
std::uint64_t isolated_memory(const PieceSections& s) {
  return each * (s.vertices - s.surface_vertices);
}

std::uint64_t attribute_memory(const Attribute& what, std::uint64_t count) {
  return sizeof(Attribute) + what.name.size() + count * what.stride();
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
    std::uint64_t most = 0;
    for (const PieceSections::AttributeSection& a : s.attributes) {
      const std::uint64_t size = attribute_memory(a.header.attribute, a.count);
      memory.result += size;
      memory.values += size + sizeof(Expected<Attribute>) + sizeof(std::uint64_t);
      most = std::max(most, decoding_memory(a.header, a.count));
    }
    memory.values += most;
  }
  memory.faces += constant;
  memory.values += constant;
  return memory;
}

Expected<DecodedPiece> decode_piece(const PieceSections& sections, Values values, unsigned threads,
                                    std::uint64_t left) {
  auto decoded = decode_faces(sections);
  if (!decoded) return Failure{decoded.error()};
  const std::span<const std::uint32_t> along = decoded->predicted_along();  // survives the move
  DecodedPiece result{std::move(decoded->mesh), decoded->counts, 0};
  if (values == Values::decode) {
    std::vector<Expected<Attribute>> attributes(
        sections.attributes.size(), fail(ErrorCode::internal, "an attribute is not decoded"));
    std::vector<std::uint64_t> memory;
    memory.reserve(attributes.size());
    for (const PieceSections::AttributeSection& a : sections.attributes)
      memory.push_back(decoding_memory(a.header, a.count));
    const std::uint64_t held =
        memory_of(sections, values).values -
        (memory.empty() ? 0 : *std::max_element(memory.begin(), memory.end()));
    const unsigned workers =
        workers_that_fit(std::move(memory), threads, left > held ? left - held : 0);
    for_each_item(attributes.size(), workers, [&](std::size_t i, unsigned) {
      const PieceSections::AttributeSection& a = sections.attributes[i];
      attributes[i] = decode_attribute(a.bytes, a.at, a.header, a.count, along);
    });
    result.mesh.attributes.reserve(attributes.size());
    for (auto& attribute : attributes) {
      if (!attribute) return Failure{attribute.error()};
      result.mesh.attributes.push_back(std::move(*attribute));
    }
  }
  turn_back(result.mesh.corners, result.mesh.face_sizes, decoded->turned);
  for (const ReversedRun& run : decoded->turned) result.turned_faces += run.count;
  return result;
}

std::uint64_t numbering_memory(const PieceSections& s) {
  return s.shared * (sizeof(SharedVertex) + each) + each * most_used_vertices(s);
}

Expected<Done> decode_triangles(const PieceSections& sections, std::span<std::uint32_t> corners,
                                std::span<HalfEdge> twins) {
  auto surface = decode_surface(sections, corners, twins);
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
    memory += attribute_memory(a.header.attribute, sections.count(a.header.attribute.domain));
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
    const std::uint64_t count = sections.count(attribute.domain);
    attribute.data.resize(static_cast<std::size_t>(count) * attribute.stride());
    mesh.attributes.push_back(std::move(attribute));
  }
  return mesh;
}

namespace {

/// Puts a piece into arrays; `values_of(k)` is memory for attribute k, and bytes between its
/// values.
template <class ValuesOf>
Expected<Done> put_piece(const PieceSections& sections, const Mesh& piece,
                         std::span<std::uint32_t> corners, std::span<std::uint32_t> sizes,
                         ValuesOf values_of) {
  std::vector<std::uint32_t> own;
  if (corners.empty()) {
    own = piece.corners;
  } else {
    corners = corners.subspan(static_cast<std::size_t>(sections.first_corner),
                              static_cast<std::size_t>(sections.corners));
    std::copy(piece.corners.begin(), piece.corners.end(), corners.begin());
  }
  auto numbers = number_piece(sections, own.empty() ? corners : std::span(own));
  if (!numbers) return Failure{numbers.error()};
  if (!sizes.empty())
    put_sizes(piece, sizes.subspan(static_cast<std::size_t>(sections.first_face)));
  for (std::size_t k = 0; k < piece.attributes.size(); ++k) {
    const Attribute& from = piece.attributes[k];
    const auto [to, step] = values_of(k);
    const std::size_t size = from.stride();
    if (from.domain == Domain::vertex) {
      std::size_t next = static_cast<std::size_t>(sections.first_vertex);
      for (std::size_t v = 0; v < piece.vertex_count; ++v) {
        if (v < numbers->size() && (*numbers)[v] < sections.first_vertex) continue;
        std::memcpy(to + next++ * step, from.data.data() + v * size, size);
      }
    } else {
      put_values(
          from,
          to + step * static_cast<std::size_t>(from.domain == Domain::face ? sections.first_face
                                                                           : sections.first_corner),
          step);
    }
  }
  return Done{};
}

}  // namespace

void put_sizes(const Mesh& from, std::span<std::uint32_t> to) {
  if (from.triangles_only())
    std::fill_n(to.begin(), from.face_count(), 3u);
  else
    std::copy(from.face_sizes.begin(), from.face_sizes.end(), to.begin());
}

void put_values(const Attribute& from, std::byte* to, std::size_t step) {
  const std::size_t size = from.stride();
  if (step == size) {
    std::copy(from.data.begin(), from.data.end(), to);
    return;
  }
  for (std::size_t at = 0; at < from.data.size(); at += size, to += step)
    std::memcpy(to, from.data.data() + at, size);
}

Expected<Done> put_piece(const PieceSections& sections, const Mesh& piece, Mesh& whole) {
  return put_piece(sections, piece, whole.corners, whole.face_sizes, [&](std::size_t k) {
    Attribute& a = whole.attributes[k];
    return std::pair(a.data.data(), a.stride());
  });
}

Expected<Done> put_piece(const PieceSections& sections, const Mesh& piece,
                         const MeshTarget& whole) {
  return put_piece(sections, piece, whole.corners, whole.face_sizes, [&](std::size_t k) {
    const AttributeTarget& a = whole.attributes[k];
    return std::pair(a.data.data(), a.step());
  });
}

std::uint64_t finishing_memory(const MeshSections& s, Values values) {
  if (!s.has_order) return 0;
  const std::uint64_t sizes = s.may_have_sizes() ? each * s.faces : 0,
                      order = each * (2 * s.faces + s.vertices),
                      faces = Faces::memory(s.corners, s.faces, s.may_have_sizes());
  std::uint64_t most = 0;  // of the attributes, whose values are copied into their order
  if (values == Values::decode)
    for (const PieceSections::AttributeSection& a : s.pieces[0].attributes)
      most =
          std::max(most, attribute_memory(a.header.attribute, s.count(a.header.attribute.domain)));
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
