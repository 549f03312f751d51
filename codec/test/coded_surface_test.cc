// What is coded of a surface: polygons are coded as the triangles that they are entered as, and
// encoder and decoder find the same corners, twins and introducing triangles, which are those that
// a search finds.
#include "codec/connectivity/coded_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "codec/connectivity/connectivity.h"
#include "codec/soup/surface_encoder.h"
#include "codec/test/polygon_surface.h"
#include "corpus/generate.h"
#include "corpus/random_gluing.h"
#include "topology/mirror.h"

namespace clers::internal {
namespace {

using test::surface_of;
using test::SurfaceCopy;
using test::without_edges;

constexpr int levels[] = {1, 3, 5, 9};

/// The triangles of polygons entered through these gates, slowly: a fan around the end of each
/// gate.
struct Fans {
  std::vector<std::uint32_t> corners;
  std::vector<HalfEdge> side_of;  ///< which side of them each half-edge of the surface is
  std::vector<HalfEdge> twins;

  Fans(const SurfaceCopy& in, std::span<const HalfEdge> gates) : side_of(in.org.size()) {
    std::vector<std::uint32_t> begin, size, face;
    for (std::uint32_t f = 0; f < in.sizes.size(); ++f) {
      begin.push_back(static_cast<std::uint32_t>(face.size()));
      size.push_back(in.sizes[f]);
      face.insert(face.end(), in.sizes[f], f);
    }
    std::vector<std::pair<std::uint32_t, std::uint32_t>> diagonals;
    for (const HalfEdge gate : gates) {
      const std::uint32_t f = face[gate.index()], n = size[f];
      const auto at = [&](std::uint32_t k) { return begin[f] + (gate.index() - begin[f] + k) % n; };
      side_of[at(0)] = HalfEdge(static_cast<std::uint32_t>(corners.size()));
      for (std::uint32_t k = n - 1; k >= 2; --k) {
        const auto first = static_cast<std::uint32_t>(corners.size());
        corners.insert(corners.end(), {in.org[at((k + 1) % n)], in.org[at(1)], in.org[at(k)]});
        side_of[at(k)] = HalfEdge(first + 2);
        if (k == 2)
          side_of[at(1)] = HalfEdge(first + 1);
        else
          diagonals.emplace_back(first + 1, first + 3);
      }
    }
    twins.resize(corners.size());
    for (std::uint32_t h = 0; h < in.org.size(); ++h)
      if (in.twins[h]) twins[side_of[h].index()] = side_of[in.twins[h].index()];
    for (const auto& [a, b] : diagonals) {
      twins[a] = HalfEdge(b);
      twins[b] = HalfEdge(a);
    }
  }
};

void check_introducing(const CodedSurface& s, std::size_t vertices) {
  ASSERT_EQ(s.introduced_by.size(), vertices);
  std::vector<std::uint32_t> first(vertices, 0xffffffffu);
  for (std::uint32_t h = 0; h < s.corners.size(); ++h)
    first[s.corners[h]] = std::min(first[s.corners[h]], h / 3);
  for (std::uint32_t v = 0; v < vertices; ++v) ASSERT_EQ(s.introduced_by[v], first[v]) << v;
}

/// What a coded surface without copies says of itself, found by search.
void check_against_search(const CodedSurface& s, std::size_t vertices) {
  check_introducing(s, vertices);
  std::vector<bool> known(vertices);
  for (std::uint32_t h = 0; h < s.corners.size(); ++h) {
    const std::uint32_t v = s.corners[h], t = h / 3;
    if (h % 3 < 2 && !known[v]) {
      // The gate is on a new component: no vertex of the triangle is known.
      ASSERT_EQ(s.introduced_by[v], t);
      ASSERT_TRUE(!s.twins[3 * t] || s.twins[3 * t].index() / 3 > t);
    }
    known[v] = true;
    if (h % 3 == 2 && s.introduced_by[v] == t && s.twins[3 * t] && s.twins[3 * t].index() / 3 < t) {
      for (unsigned i = 0; i < 3; ++i)
        ASSERT_LT(s.introduced_by[s.corners[3 * (s.twins[3 * t].index() / 3) + i]], t);
    }
    if (!s.twins[h]) continue;
    ASSERT_EQ(s.twins[s.twins[h].index()], HalfEdge(h));
    const std::uint32_t next = lnext(HalfEdge(h)).index();
    ASSERT_EQ(s.corners[h], s.corners[lnext(s.twins[h]).index()]);
    ASSERT_EQ(s.corners[next], s.corners[s.twins[h].index()]);
  }
}

/// Twins of a simplicial complex by search among all sides.
void check_twins_by_vertices(const CodedSurface& s) {
  for (std::uint32_t h = 0; h < s.corners.size(); ++h) {
    const std::uint32_t a = s.corners[h], b = s.corners[lnext(HalfEdge(h)).index()];
    HalfEdge twin;
    for (std::uint32_t g = 0; g < s.corners.size(); ++g)
      if (s.corners[g] == b && s.corners[lnext(HalfEdge(g)).index()] == a) twin = HalfEdge(g);
    ASSERT_EQ(s.twins[h], twin) << h;
  }
}

/// What a decoder finds of it.
struct Decoded {
  std::vector<std::uint32_t> corners;
  std::vector<HalfEdge> twins;
};
Decoded decoded(std::span<const std::byte> bytes) {
  const auto header = *read_connectivity_header(bytes, 0);
  Decoded d;
  d.corners.resize(3 * std::size_t(header.faces));
  d.twins.resize(d.corners.size());
  const auto counts = decode_connectivity(bytes, 0, header, d.corners, d.twins);
  EXPECT_TRUE(counts.ok());
  return d;
}

/// All that must hold of a surface of triangles or polygons at one level.
void check(const SurfaceCopy& in, int level) {
  SCOPED_TRACE("level " + std::to_string(level));
  SurfaceCopy consumed = in;
  auto coded = encode_connectivity(consumed.arrays(), level, Kept::corners_and_twins);
  ASSERT_TRUE(coded.ok()) << describe(coded.error());
  ASSERT_EQ(coded->gates.size(), in.sizes.empty() ? in.triangles() : in.sizes.size());

  consumed = in;
  const auto plain = encode_connectivity(consumed.arrays(), level);
  ASSERT_TRUE(plain.ok());
  EXPECT_EQ(plain->bytes, coded->bytes);
  EXPECT_EQ(plain->gates, coded->gates);
  EXPECT_EQ(plain->vertices, coded->vertices);
  EXPECT_TRUE(plain->twins.empty());

  // The triangles are unbuilt as the polygons were, by operators on a full surface.
  SurfaceCopy polygons = in;
  if (polygons.sizes.empty()) polygons.sizes.assign(in.triangles(), 3);
  const Fans fans(polygons, coded->gates);
  EXPECT_EQ(coded->twins, fans.twins);
  std::vector<HalfEdge> twins = fans.twins;
  OperatorTrace trace;
  const auto again =
      encode_connectivity_on_surface({fans.corners, twins, in.vertex_count}, level, trace);
  ASSERT_TRUE(again.ok()) << describe(again.error());
  EXPECT_EQ(again->bytes, coded->bytes);
  EXPECT_EQ(again->vertices, coded->vertices);
  for (std::uint32_t i = 0; i < again->gates.size(); ++i)
    ASSERT_EQ(again->gates[i], half_edge(Face(i), 0));
  consumed = polygons;
  OperatorTrace of_polygons;
  const auto on_surface = encode_connectivity_on_surface(consumed.arrays(), level, of_polygons);
  ASSERT_TRUE(on_surface.ok()) << describe(on_surface.error());
  EXPECT_EQ(of_polygons, trace);
  EXPECT_EQ(on_surface->bytes, coded->bytes);

  const std::size_t vertices = coded->vertices.size();
  consumed = in;
  const CodedArrays surface = coded_surface(in.vertex_count, *coded);
  check_against_search(surface.view(), vertices);
  const Decoded found = decoded(coded->bytes);
  EXPECT_EQ(surface.corners, found.corners);
  EXPECT_EQ(surface.twins, found.twins);
  for (std::size_t h = 0; h < surface.corners.size(); ++h)
    ASSERT_EQ(coded->vertices[surface.corners[h]], fans.corners[h]);
}

void check_levels(const SurfaceCopy& in) {
  check(in, levels[(in.org.size() + in.sizes.size()) % 4]);
  check(in, 5);
}

/// With edges and without some of them: as many as each of three times, up to each of three sizes,
/// paired by the seed.
void check_kinds(const SurfaceCopy& triangles, std::uint64_t seed) {
  constexpr std::size_t sizes[] = {4, 6, 50};
  check_levels(triangles);
  for (const unsigned of_100 : {15u, 50u, 100u}) {
    const std::size_t most = sizes[++seed % 3];
    SCOPED_TRACE("of 100 " + std::to_string(of_100) + " most " + std::to_string(most));
    check_levels(without_edges(triangles, of_100, most, seed));
  }
}

TEST(CodedSurface, Shapes) {
  for (const Mesh& mesh :
       {corpus::single_triangle(), corpus::glued_pair(), corpus::tetrahedron(),
        corpus::icosphere(0), corpus::icosphere(2), corpus::torus(3, 3), corpus::torus(12, 9),
        corpus::grid(1, 1), corpus::grid(17, 9), corpus::cylinder(12, 8), corpus::fan(40),
        corpus::strip(50), corpus::loose_triangles(7)})
    check_kinds(surface_of(mesh), mesh.vertex_count);
}

TEST(CodedSurface, HolesHandlesAndComponents) {
  check_kinds(surface_of(corpus::punch_holes(corpus::icosphere(2), 9, 1)), 1);
  check_kinds(surface_of(corpus::punch_holes(corpus::torus(14, 10), 6, 2)), 2);
  check_kinds(surface_of(corpus::gyroid(1, 1, 1, 7, corpus::Ends::periodic)), 3);
  check_kinds(surface_of(corpus::gyroid(2, 1, 1, 5, corpus::Ends::open)), 4);
  check_kinds(surface_of(corpus::copies(corpus::punch_holes(corpus::torus(7, 6), 3, 3), 4)), 5);
  check_kinds(surface_of(corpus::shuffle(corpus::flip_edges(corpus::grid(12, 14), 500, 6), 6)), 6);
}

TEST(CodedSurface, RandomGluings) {
  std::uint64_t seed = 0;
  for (const unsigned zips : {0u, 50u, 90u, 100u})
    for (const unsigned boundary : {0u, 5u, 25u})
      for (const std::uint32_t triangles : {1u, 2u, 3u, 5u, 9u, 14u, 20u, 33u, 60u, 150u}) {
        corpus::GluingOptions options;
        options.zips = zips;
        options.boundary = boundary;
        options.apart = seed % 2 ? 10 : 0;
        options.loops = false;
        SCOPED_TRACE("triangles " + std::to_string(triangles) + " seed " + std::to_string(seed));
        ++seed;
        check_kinds(surface_of(corpus::random_gluing(triangles, seed, options)), seed);
        if (HasFailure()) return;
      }
}

TEST(CodedSurface, TwinsOfSimplicialComplexes) {
  for (const Mesh& mesh : {corpus::torus(7, 5), corpus::punch_holes(corpus::icosphere(2), 5, 1)})
    for (const unsigned of_100 : {0u, 60u}) {
      // A polygon may have a diagonal that is an edge elsewhere, so only triangles are complexes.
      SurfaceCopy in = surface_of(mesh);
      if (of_100 > 0) in.sizes.assign(in.triangles(), 3);
      SurfaceCopy consumed = in;
      auto coded = encode_connectivity(consumed.arrays(), 5, Kept::corners_and_twins);
      ASSERT_TRUE(coded.ok());
      check_twins_by_vertices(coded_surface(in.vertex_count, *coded).view());
    }
}

/// Without an ear a polygon is one of a side less, and its half-edges are a cycle either way.
TEST(PolygonFaces, AreCyclesThatLoseEars) {
  const std::vector<std::uint32_t> sizes = {3, 7, 4};
  std::vector<HalfEdge> twins(14);
  PolygonFaces faces(twins, sizes);
  HalfEdge gate(5);  // of the second face
  for (std::uint32_t left = 7; left >= 3; --left) {
    std::uint32_t count = 0;
    for (HalfEdge h = gate; count == 0 || h != gate; h = faces.next(h), ++count) {
      ASSERT_LT(count, left);
      ASSERT_EQ(faces.prev(faces.next(h)), h);
      ASSERT_FALSE(faces.is_destroyed(h));
    }
    ASSERT_EQ(count, left);
    ASSERT_EQ(faces.is_triangle(gate), left == 3);
    const HalfEdge right = faces.next(gate), apex = faces.prev(gate);
    if (left == 3)
      faces.destroy(gate, right, apex, 14);
    else
      faces.cut_ear(gate, right, apex, 17 - left);
    ASSERT_TRUE(faces.is_destroyed(gate));
    if (left < 7) {
      ASSERT_EQ(faces.detached_side(gate), half_edge(Face(16 - left), 2));
    }
    gate = apex;
  }
  for (std::uint32_t h = 0; h < 14; ++h)
    ASSERT_EQ(faces.is_destroyed(HalfEdge(h)), h >= 3 && h < 10) << h;
  EXPECT_EQ(faces.detached_side(HalfEdge(6)), half_edge(Face(14), 1));
}

/// Polygons alone, glued to themselves along all sides, and of many corners.
TEST(CodedSurface, PolygonsOfManyCorners) {
  for (const std::uint32_t n : {3u, 4u, 5u, 17u, 1000u}) {
    SurfaceCopy one;
    one.vertex_count = n;
    one.sizes = {n};
    one.twins.resize(n);
    for (std::uint32_t v = 0; v < n; ++v) one.org.push_back(v);
    check_levels(one);
    SurfaceCopy pillow = one;
    pillow.sizes = {n, n};
    for (std::uint32_t k = 0; k < n; ++k) pillow.org.push_back((2 * n - 1 - k) % n);
    pillow.twins.resize(2 * n);
    for (std::uint32_t h = 0; h < n; ++h) {  // from h to h + 1, and back
      const HalfEdge back(n + (2 * n - 2 - h) % n);
      ASSERT_EQ(pillow.org[back.index()], (h + 1) % n);
      pillow.twins[h] = back;
      pillow.twins[back.index()] = HalfEdge(h);
    }
    check_levels(pillow);
  }
}

/// Surfaces that faces are cut to: corners are those of the mesh's faces.
TEST(CodedSurface, OfCutFaces) {
  std::vector<Mesh> meshes = {corpus::moebius_strip(12, 3),
                              corpus::book(5),
                              corpus::pinched_hub(4),
                              corpus::chessboard(6),
                              corpus::add_fins(corpus::icosphere(2), 10, 1),
                              corpus::reverse_some(corpus::torus(9, 7), 20, 2)};
  for (std::uint32_t seed = 0; seed < 60; ++seed) {
    // Of a soup the faces that repeat no vertex.
    const Mesh soup = corpus::random_soup(12 + seed % 30, 40, 3 + seed % 4, seed);
    Mesh mesh;
    mesh.vertex_count = soup.vertex_count;
    std::size_t begin = 0;
    for (std::size_t f = 0; f < soup.face_count(); ++f) {
      const std::uint32_t size = soup.triangles_only() ? 3 : soup.face_sizes[f];
      const std::vector<std::uint32_t> face(
          soup.corners.begin() + static_cast<std::ptrdiff_t>(begin),
          soup.corners.begin() + static_cast<std::ptrdiff_t>(begin + size));
      begin += size;
      std::vector<std::uint32_t> sorted = face;
      std::sort(sorted.begin(), sorted.end());
      if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end()) continue;
      mesh.face_sizes.push_back(size);
      mesh.corners.insert(mesh.corners.end(), face.begin(), face.end());
    }
    meshes.push_back(mesh);
  }
  bool stitched = false;
  for (const Mesh& mesh : meshes) {
    const auto coded = encode_surface(mesh.corners, mesh.face_sizes, mesh.vertex_count, 5,
                                      Wanted::surface_with_twins, [] { return false; });
    ASSERT_TRUE(coded.ok()) << describe(coded.error());
    const CodedSurface surface = coded->surface.view();
    stitched |= coded->copied_vertices > 0;
    const Decoded found = decoded(coded->connectivity);
    if (coded->copied_vertices == 0) {
      check_against_search(surface, surface.introduced_by.size());
      EXPECT_EQ(coded->surface.corners, found.corners);
    }
    check_introducing(surface, coded->order.vertices.size());
    EXPECT_EQ(coded->surface.twins, found.twins);
    // Fans by vertices of the mesh, against the faces.
    std::vector<std::uint32_t> begins, sizes;
    std::uint32_t begin = 0;
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
      begins.push_back(begin);
      sizes.push_back(mesh.triangles_only() ? 3 : mesh.face_sizes[f]);
      begin += sizes.back();
    }
    std::size_t at = 0;
    const std::size_t surface_faces = coded->order.faces.size() - coded->repeated_faces;
    for (std::size_t i = 0; i < surface_faces; ++i) {
      const std::uint32_t f = coded->order.faces[i];
      std::vector<std::uint32_t> expected, got;
      for (std::uint32_t k = 0; k < sizes[f]; ++k) expected.push_back(mesh.corners[begins[f] + k]);
      const auto vertex = [&](std::size_t h) { return coded->order.vertices[surface.corners[h]]; };
      got = {vertex(at), vertex(at + 1)};
      for (std::uint32_t k = 2; k < sizes[f]; ++k, at += 3) got.push_back(vertex(at + 2));
      std::sort(expected.begin(), expected.end());
      std::sort(got.begin(), got.end());
      ASSERT_EQ(got, expected) << "face " << f;
    }
    EXPECT_EQ(3 * at / 3, surface.corners.size());
  }
  EXPECT_TRUE(stitched);
}

TEST(CodedSurface, OnlyWhatIsWanted) {
  const Mesh mesh = corpus::torus(9, 7);
  const auto coded = [&](Wanted wanted) {
    return *encode_surface(mesh.corners, {}, mesh.vertex_count, 5, wanted, [] { return false; });
  };
  const EncodedSurface nothing = coded(Wanted::nothing), surface = coded(Wanted::surface),
                       twins = coded(Wanted::surface_with_twins);
  EXPECT_TRUE(nothing.surface.corners.empty());
  EXPECT_FALSE(surface.surface.corners.empty());
  EXPECT_TRUE(surface.surface.twins.empty());
  EXPECT_EQ(twins.surface.twins.size(), twins.surface.corners.size());
  EXPECT_EQ(surface.surface.introduced_by, twins.surface.introduced_by);
  EXPECT_EQ(nothing.connectivity, twins.connectivity);
  EXPECT_EQ(surface.connectivity, twins.connectivity);
}

}  // namespace
}  // namespace clers::internal
