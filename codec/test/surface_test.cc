// A mesh becomes a surface and a mesh again; what is no surface is refused, and its place named.
#include "codec/surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "codec/encode.h"
#include "codec/inspect.h"
#include "codec/test/attribute.h"
#include "corpus/generate.h"
#include "topology/validate.h"

namespace clers::internal {
namespace {

using test::attribute;

/// A number at each vertex, corner and face.
Mesh numbered(Mesh mesh) {
  const auto numbers = [&](const char* name, Domain domain) {
    std::vector<std::uint32_t> values(mesh.value_count(domain));
    std::iota(values.begin(), values.end(), 100u);
    return attribute(name, domain, Scalar::uint32, 1, values);
  };
  mesh.attributes = {numbers("v", Domain::vertex), numbers("c", Domain::corner),
                     numbers("f", Domain::face)};
  return mesh;
}

TEST(CodecSurface, ThereAndBack) {
  for (const Mesh& bare : {Mesh{}, corpus::tetrahedron(), corpus::torus(5, 6), corpus::glued_pair(),
                           corpus::shuffle(corpus::punch_holes(corpus::icosphere(2), 4, 1), 2),
                           corpus::gyroid(1, 1, 1, 10, corpus::Ends::open)}) {
    const Mesh mesh = numbered(bare);
    const auto surface = to_surface(mesh);
    ASSERT_TRUE(surface.ok()) << describe(surface.error());
    EXPECT_TRUE(validate(*surface).empty());
    const auto shape = measure(mesh);
    const Characteristic& k = surface->characteristic();
    EXPECT_EQ(static_cast<std::uint64_t>(k.f), shape->faces);
    EXPECT_EQ(static_cast<std::uint64_t>(k.b), shape->surface.boundary_curves);
    EXPECT_EQ(static_cast<std::uint64_t>(k.s), shape->surface.components);
    const auto back = to_mesh(*surface, mesh.attributes);
    ASSERT_TRUE(back.ok()) << describe(back.error());
    EXPECT_EQ(back->mesh.corners, mesh.corners);
    EXPECT_EQ(back->mesh.vertex_count, mesh.vertex_count);
    for (std::size_t i = 0; i < mesh.attributes.size(); ++i)
      EXPECT_EQ(back->mesh.attributes[i].data, mesh.attributes[i].data);
  }
}

TEST(CodecSurface, ValuesFollowWhatIsLeftAfterEdits) {
  const Mesh mesh = numbered(corpus::grid(4, 4));
  auto surface = to_surface(mesh);
  ASSERT_TRUE(surface.ok());
  const auto first_inside = [&](Face f) {
    for (const HalfEdge h : surface->star(f))
      if (!surface->is_boundary(h)) return h;
    return HalfEdge();
  };
  ASSERT_TRUE(surface->flip(first_inside(Face(20))).ok());
  ASSERT_TRUE(surface->unglue(first_inside(Face(3))).ok());
  ASSERT_TRUE(surface->split(Face(9), Point(99)).ok());
  std::vector<std::uint32_t> at_vertices(surface->vertex_limit()), at_faces(surface->face_limit());
  for (const clers::Vertex v : surface->vertices()) at_vertices[v.index()] = 7 * v.index();
  for (const Face f : surface->faces()) at_faces[f.index()] = 3 * f.index();
  const AttributeView views[] = {attribute_view("v", at_vertices, 1),
                                 attribute_view("f", at_faces, 1, Domain::face)};
  const auto back = to_mesh(*surface, views);
  ASSERT_TRUE(back.ok()) << describe(back.error());
  const Mesh& made = back->mesh;
  ASSERT_EQ(back->vertices.size(), made.vertex_count);
  ASSERT_EQ(back->faces.size(), made.face_count());
  for (std::size_t i = 0; i < back->faces.size(); ++i)
    for (unsigned j = 0; j < 3; ++j)
      EXPECT_EQ(back->vertices[made.corners[3 * i + j]],
                surface->org(half_edge(back->faces[i], j)));
  const auto value = [](const Attribute& a, std::size_t i) {
    std::uint32_t x;
    std::memcpy(&x, a.data.data() + 4 * i, 4);
    return x;
  };
  for (std::size_t i = 0; i < back->vertices.size(); ++i)
    EXPECT_EQ(value(made.attributes[0], i), 7 * back->vertices[i].index());
  for (std::size_t i = 0; i < back->faces.size(); ++i)
    EXPECT_EQ(value(made.attributes[1], i), 3 * back->faces[i].index());
  EXPECT_TRUE(encode(made).ok());

  const AttributeView few[] = {attribute_view("v", std::span(at_vertices).first(5), 1)};
  EXPECT_EQ(to_mesh(*surface, few).error().code, ErrorCode::inconsistent_mesh);
}

TEST(CodecSurface, DeadIdsAreLeftOut) {
  const Mesh mesh = corpus::loose_triangles(5);
  auto surface = to_surface(mesh);
  ASSERT_TRUE(surface.ok());
  ASSERT_TRUE(surface->destroy(Face(2)).ok());
  std::vector<std::uint16_t> numbers(surface->vertex_limit());
  std::iota(numbers.begin(), numbers.end(), std::uint16_t(0));
  const AttributeView view = attribute_view("n", numbers, 1);
  const auto back = to_mesh(*surface, std::span(&view, 1));
  ASSERT_TRUE(back.ok());
  EXPECT_EQ(back->mesh.vertex_count, 12u);
  EXPECT_EQ(back->mesh.face_count(), 4u);
  EXPECT_EQ(back->faces, (std::vector<Face>{Face(0), Face(1), Face(3), Face(4)}));
  EXPECT_EQ(back->vertices[6], clers::Vertex(9));
  EXPECT_EQ(back->mesh.attributes[0].data.size(), 24u);
}

TEST(CodecSurface, UnusedVerticesAreNoneOfIt) {
  Mesh mesh = corpus::tetrahedron();
  mesh.vertex_count += 3;
  const auto surface = to_surface(mesh);
  ASSERT_TRUE(surface.ok());
  EXPECT_EQ(surface->characteristic().v, 4);
  EXPECT_EQ(surface->vertex_limit(), 7u);
  EXPECT_EQ(to_mesh(*surface)->mesh.vertex_count, 4u);
}

TEST(CodecSurface, CutsWhatIsNoSurface) {
  Mesh degenerate = corpus::add_fins(corpus::icosphere(2), 5, 1);
  degenerate.corners[4] = degenerate.corners[5];
  for (const Mesh& mesh :
       {Mesh{}, corpus::torus(5, 6), corpus::book(5), corpus::moebius_strip(9, 2),
        corpus::chessboard(3), corpus::same_triangle(3), corpus::two_sided(corpus::grid(4, 4)),
        corpus::reverse_some(corpus::icosphere(2), 30, 1), degenerate,
        corpus::random_soup(20, 60, 3, 1), corpus::isolate(corpus::tetrahedron(), 2)}) {
    if (!mesh.triangles_only()) continue;
    const auto made = to_surface_by_cuts(mesh);
    ASSERT_TRUE(made.ok()) << describe(made.error());
    EXPECT_TRUE(validate(made->surface).empty());
    EXPECT_EQ(made->whole(), to_surface(mesh).ok());
    std::size_t faces = 0;
    for (const Face f : made->surface.faces()) {
      ++faces;
      const bool turned =
          std::binary_search(made->reversed.begin(), made->reversed.end(), f.index());
      for (unsigned i = 0; i < 3; ++i) {
        const std::uint32_t v = made->surface.org(half_edge(f, turned ? (3 - i) % 3 : i)).index();
        EXPECT_EQ(mesh.corners[3 * f.index() + i],
                  v < mesh.vertex_count ? v : made->copied[v - mesh.vertex_count]);
      }
    }
    EXPECT_EQ(faces + made->degenerate.size() + made->repeated.size(), mesh.face_count());
    for (const auto* gone : {&made->degenerate, &made->repeated})
      for (const std::uint32_t f : *gone) EXPECT_FALSE(made->surface.is_live(Face(f)));
  }
  Mesh mesh = corpus::tetrahedron();
  mesh.corners[3] = 4;
  EXPECT_EQ(to_surface_by_cuts(mesh).error().code, ErrorCode::inconsistent_mesh);
  mesh.face_sizes = {3, 4, 3, 2};
  mesh.corners[3] = 0;
  EXPECT_EQ(to_surface_by_cuts(mesh).error().code, ErrorCode::unsupported);
}

TEST(CodecSurface, RefusesWhatIsNoSurface) {
  const auto error = [](const MeshView& mesh) {
    const auto surface = to_surface(mesh);
    EXPECT_FALSE(surface.ok());
    return surface ? Error{} : surface.error();
  };
  Mesh mesh = corpus::tetrahedron();
  mesh.face_sizes = {3, 4, 3, 2};
  EXPECT_EQ(describe(error(mesh)), "face 1: has 4 corners, a surface is made of triangles");
  EXPECT_EQ(error(mesh).code, ErrorCode::unsupported);
  mesh.face_sizes = {3, 3, 3, 3};
  EXPECT_TRUE(to_surface(mesh).ok());
  mesh = corpus::tetrahedron();
  mesh.corners[4] = mesh.corners[5];
  EXPECT_EQ(describe(error(mesh)), "face 1: uses a vertex twice");
  EXPECT_EQ(error(corpus::book(3)).code, ErrorCode::nonmanifold_edge);
  EXPECT_EQ(error(corpus::moebius_strip(9, 2)).code, ErrorCode::nonorientable);
  const Error fans = error(corpus::chessboard(3));
  EXPECT_EQ(fans.code, ErrorCode::nonmanifold_vertex);
  EXPECT_EQ(fans.place, Place::vertex);
  mesh = corpus::tetrahedron();
  mesh.corners[7] = 4;
  EXPECT_EQ(describe(error(mesh)), "face 2: has vertex 4, expected one below 4");
  mesh.corners.pop_back();
  EXPECT_EQ(error(mesh).code, ErrorCode::inconsistent_mesh);
  const std::vector<std::uint16_t> narrow = {0, 1, 2, 2, 1, 3};
  MeshView view;
  view.vertex_count = 4;
  view.corners_16 = narrow;
  ASSERT_TRUE(to_surface(view).ok());
  EXPECT_EQ(to_surface(view)->characteristic().b, 1);
}

}  // namespace
}  // namespace clers::internal
