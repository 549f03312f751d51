#include "corpus/generate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "corpus/test/recount.h"

namespace clers::corpus {
namespace {

// Checks what generate.h promises of every mesh that is a surface.
Figures surface(const Mesh& mesh, bool simple = true) {
  const Figures n = recount(mesh);
  EXPECT_TRUE(n.surface());
  if (simple) {
    EXPECT_EQ(n.equal_faces, 0);
  }
  EXPECT_NE(mesh.position(), nullptr);
  EXPECT_EQ(mesh.position()->data.size(), mesh.vertex_count * 3 * sizeof(float));
  return n;
}

void expect_topology(const Figures& n, std::int64_t components, std::int64_t curves,
                     std::int64_t genus) {
  EXPECT_EQ(n.components, components);
  EXPECT_EQ(n.boundary_curves, curves);
  EXPECT_EQ(n.genus, genus);
}

// Faces as positions, each with its least corner first, sorted: the same for meshes that differ in
// order only.
std::vector<std::string> by_position(const Mesh& mesh, bool backwards = false) {
  std::vector<std::string> faces;
  const auto* data = reinterpret_cast<const char*>(mesh.position()->data.data());
  std::size_t at = 0;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const std::size_t size = mesh.triangles_only() ? 3 : mesh.face_sizes[f];
    std::vector<std::string> face;
    for (std::size_t k = 0; k < size; ++k)
      face.emplace_back(data + mesh.corners[at + k] * std::size_t{12}, 12);
    at += size;
    if (backwards) std::reverse(face.begin(), face.end());
    std::vector<std::string> least = face;
    for (std::size_t k = 1; k < size; ++k) {
      std::rotate(face.begin(), face.begin() + 1, face.end());
      least = std::min(least, face);
    }
    std::string joined;
    for (const std::string& corner : least) joined += corner;
    faces.push_back(joined);
  }
  std::sort(faces.begin(), faces.end());
  return faces;
}

TEST(Shapes, HaveTheTopologyTheirNamesSay) {
  expect_topology(surface(single_triangle()), 1, 1, 0);
  expect_topology(surface(glued_pair(), false), 1, 0, 0);
  expect_topology(surface(tetrahedron()), 1, 0, 0);
  for (unsigned level = 0; level < 4; ++level) {
    const Figures n = surface(icosphere(level));
    expect_topology(n, 1, 0, 0);
    EXPECT_EQ(n.faces, 20 << 2 * level);
  }
  for (unsigned k = 3; k < 7; ++k) {
    expect_topology(surface(torus(k, 3)), 1, 0, 1);
    expect_topology(surface(torus(3, k)), 1, 0, 1);
    expect_topology(surface(cylinder(k, 1)), 1, 2, 0);
    expect_topology(surface(cylinder(3, k)), 1, 2, 0);
    expect_topology(surface(grid(k, 1)), 1, 1, 0);
    expect_topology(surface(grid(2, k)), 1, 1, 0);
  }
}

TEST(Shapes, MoebiusStripIsAManifoldWithoutOrientation) {
  for (unsigned rows = 1; rows < 4; ++rows) {
    const Figures n = recount(moebius_strip(7, rows));
    EXPECT_TRUE(n.manifold());
    EXPECT_EQ(n.misoriented_edges, rows);
    EXPECT_EQ(n.boundary_curves, 1);
    EXPECT_EQ(n.vertices - n.edges + n.faces, 0);
  }
}

TEST(Flips, KeepTopologyAndMakeIrregular) {
  const std::vector<std::pair<Mesh, std::vector<std::int64_t>>> cases = {
      {grid(12, 9), {1, 1, 0}},   {torus(12, 9), {1, 0, 1}},  {icosphere(2), {1, 0, 0}},
      {torus(3, 3), {1, 0, 1}},   {tetrahedron(), {1, 0, 0}}, {single_triangle(), {1, 1, 0}},
      {cylinder(3, 1), {1, 2, 0}}};
  for (std::uint64_t seed = 0; seed < 20; ++seed)
    for (const auto& [mesh, expected] : cases) {
      const Mesh flipped = flip_edges(mesh, 5000, seed);
      const Figures n = surface(flipped);
      expect_topology(n, expected[0], expected[1], expected[2]);
      EXPECT_EQ(n.edges, recount(mesh).edges);  // so no two have the same ends
      EXPECT_EQ(n.faces, recount(mesh).faces);

      std::map<std::uint32_t, unsigned> faces_at;
      for (const std::uint32_t v : flipped.corners) ++faces_at[v];
      if (n.boundary_curves == 0) {
        for (const auto& [v, count] : faces_at) EXPECT_GE(count, 3u) << "vertex " << v;
      }
      if (n.faces > 200) {
        EXPECT_GT(std::count_if(faces_at.begin(), faces_at.end(),
                                [](const auto& at) { return at.second != 6; }),
                  n.vertices / 2);
      }
    }
}

TEST(Holes, AreOneBoundaryCurveEach) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Mesh ball = flip_edges(icosphere(3), 2000, seed);
    expect_topology(surface(punch_holes(ball, 0, seed)), 1, 0, 0);
    expect_topology(surface(punch_holes(ball, 1, seed)), 1, 1, 0);
    expect_topology(surface(punch_holes(ball, 30, seed)), 1, 30, 0);
    const Figures full = surface(punch_holes(ball, 1000, seed));
    EXPECT_EQ(full.components, 1);
    EXPECT_GT(full.boundary_curves, 50);
    expect_topology(surface(punch_holes(grid(20, 20), 10, seed)), 1, 11, 0);
    expect_topology(surface(punch_holes(torus(20, 20), 10, seed)), 1, 10, 1);
  }
}

TEST(Gyroid, IsASurfaceWithTheGenusOfItsCells) {
  for (unsigned resolution : {8u, 9u, 10u, 16u}) {
    expect_topology(surface(gyroid(1, 1, 1, resolution, Ends::periodic)), 1, 0, 5);
    expect_topology(surface(gyroid(1, 2, 3, resolution, Ends::periodic)), 1, 0, 25);
    const Figures capped = surface(gyroid(2, 2, 2, resolution, Ends::capped));
    EXPECT_EQ(capped.boundary_curves, 0);
    EXPECT_GT(capped.genus, 20);
    const Figures open = surface(gyroid(2, 2, 2, resolution, Ends::open));
    EXPECT_GT(open.boundary_curves, 5);
    EXPECT_GT(open.genus, 20);
  }
}

TEST(Lattice, HasAHandleForEveryLoopOfTubes) {
  expect_topology(surface(lattice(1)), 1, 0, 0);
  expect_topology(surface(lattice(2)), 1, 0, 5);
  expect_topology(surface(lattice(5)), 1, 0, 176);
  EXPECT_EQ(lattice(5).face_count(), 24u * 125 - 12 * 25);
}

TEST(Arrange, ShuffleChangesOrderOnly) {
  for (std::uint64_t seed = 0; seed < 10; ++seed)
    for (const Mesh& mesh : {icosphere(2), random_soup(50, 200, 7, seed)}) {
      const Mesh shuffled = shuffle(mesh, seed);
      EXPECT_NE(shuffled.corners, mesh.corners);
      EXPECT_EQ(by_position(shuffled), by_position(mesh));
      EXPECT_EQ(shuffle(mesh, seed).corners, shuffled.corners);
      EXPECT_NE(shuffle(mesh, seed + 1).corners, shuffled.corners);
    }
}

TEST(Arrange, ReversedTurnsEveryFace) {
  for (const Mesh& mesh : {gyroid(1, 1, 1, 8, Ends::open), random_soup(50, 200, 7, 1)}) {
    const Mesh turned = reversed(mesh);
    EXPECT_NE(by_position(turned), by_position(mesh));
    EXPECT_EQ(by_position(turned, true), by_position(mesh));
    EXPECT_EQ(reversed(turned).corners, mesh.corners);
  }
}

TEST(Arrange, UnionsAddUp) {
  const std::vector<Mesh> parts = {torus(5, 4), tetrahedron(), grid(3, 3), torus(3, 3)};
  expect_topology(surface(disjoint_union(parts)), 4, 1, 2);
  expect_topology(surface(copies(cylinder(4, 2), 100)), 100, 200, 0);
  EXPECT_EQ(copies(tetrahedron(), 0).face_count(), 0u);

  const std::vector<Mesh> mixed = {random_soup(9, 20, 6, 1), tetrahedron()};
  const Mesh all = disjoint_union(mixed);
  EXPECT_EQ(all.face_count(), 24u);
  EXPECT_EQ(all.face_sizes.back(), 3u);
}

TEST(Arrange, CarriesAttributesOfEveryDomain) {
  Mesh mesh = icosphere(1);
  Attribute corner_id{"corner", Domain::corner, Scalar::uint32, 1, {}};
  Attribute face_id{"face", Domain::face, Scalar::uint32, 1, {}};
  const auto push = [](Attribute& a, std::uint32_t value) {
    const auto* bytes = reinterpret_cast<const std::byte*>(&value);
    a.data.insert(a.data.end(), bytes, bytes + sizeof value);
  };
  // A value of a corner is its vertex, of a face the sum of its vertices.
  for (std::size_t c = 0; c < mesh.corners.size(); ++c) {
    push(corner_id, mesh.corners[c]);
    if (c % 3 == 2) push(face_id, mesh.corners[c] + mesh.corners[c - 1] + mesh.corners[c - 2]);
  }
  Attribute vertex_id{"vertex", Domain::vertex, Scalar::uint32, 1, {}};
  for (std::uint32_t v = 0; v < mesh.vertex_count; ++v) push(vertex_id, v);
  mesh.attributes.insert(mesh.attributes.end(), {vertex_id, corner_id, face_id});

  for (const Mesh& out : {shuffle(mesh, 1), reversed(mesh), punch_holes(mesh, 4, 1)}) {
    const auto value = [&](std::size_t attribute, std::size_t i) {
      std::uint32_t v = 0;
      std::memcpy(&v, out.attributes[attribute].data.data() + i * sizeof v, sizeof v);
      return v;
    };
    std::uint32_t sum = 0;
    for (std::size_t c = 0; c < out.corners.size(); ++c) {
      const std::uint32_t original = value(1, out.corners[c]);
      ASSERT_EQ(value(2, c), original);
      sum += original;
      if (c % 3 < 2) continue;
      ASSERT_EQ(value(3, c / 3), sum);
      sum = 0;
    }
  }
}

TEST(Soups, AreWhatTheyAreCalled) {
  const Figures wheel = surface(fan(1000));
  expect_topology(wheel, 1, 1, 0);
  EXPECT_EQ(wheel.vertices, 1001);

  const Figures pages = recount(book(7));
  EXPECT_EQ(pages.crowded_edges, 1);
  EXPECT_EQ(pages.edges, 15);

  const Figures board = recount(chessboard(8));
  EXPECT_EQ(board.faces, 64);
  EXPECT_EQ(board.pinched_vertices, 49);
  EXPECT_EQ(board.components, 1);
  EXPECT_EQ(board.crowded_edges, 0);

  for (unsigned n : {1u, 2u, 3u, 10u, 11u}) {
    const Figures band = surface(strip(n));
    expect_topology(band, 1, 1, 0);
    EXPECT_EQ(band.vertices, n + 2);
    expect_topology(surface(loose_triangles(n)), n, n, 0);
  }

  const Figures soup = recount(random_soup(100, 1000, 3, 5));
  EXPECT_GT(soup.pinched_vertices, 0);
  EXPECT_GT(soup.crowded_edges, 0);
  EXPECT_GT(soup.misoriented_edges, 0);
  EXPECT_GT(soup.degenerate_faces, 0);
  EXPECT_GT(soup.equal_faces, 0);
  EXPECT_GT(recount(random_soup(3000, 1000, 3, 5)).isolated_vertices, 0);
  const Mesh polygons = random_soup(100, 1000, 9, 5);
  EXPECT_EQ(polygons.face_sizes.size(), 1000u);
  EXPECT_EQ(*std::min_element(polygons.face_sizes.begin(), polygons.face_sizes.end()), 3u);
  EXPECT_EQ(*std::max_element(polygons.face_sizes.begin(), polygons.face_sizes.end()), 9u);
}

TEST(Soups, CrowdsAreAsManyAsTheySay) {
  EXPECT_EQ(recount(same_triangle(50)).equal_faces, 49);
  const Figures triples = recount(all_triples(7));
  EXPECT_EQ(triples.faces, 35);
  EXPECT_EQ(triples.edges, 21);
  EXPECT_EQ(triples.crowded_edges, 21);
  EXPECT_EQ(triples.equal_faces, 0);
  const Figures hub = recount(pinched_hub(9));
  EXPECT_EQ(hub.components, 1);
  EXPECT_EQ(hub.pinched_vertices, 1);
  EXPECT_EQ(hub.vertices, 19);
  EXPECT_EQ(hub.edges, 27);
}

TEST(Defects, AreWhatTheyAreCalled) {
  const Mesh mesh = torus(12, 9);
  const Figures clean = recount(mesh);
  const Figures twice = recount(doubled(mesh));
  EXPECT_EQ(twice.equal_faces, clean.faces);
  EXPECT_EQ(twice.crowded_edges, clean.edges);
  const Figures both = recount(two_sided(mesh));
  EXPECT_EQ(both.faces, 2 * clean.faces);
  EXPECT_EQ(both.crowded_edges, clean.edges);
  EXPECT_EQ(by_position(two_sided(mesh)), by_position(two_sided(reversed(mesh))));
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    const Figures fins = recount(add_fins(mesh, 10, seed));
    EXPECT_EQ(fins.faces, clean.faces + 10);
    EXPECT_EQ(fins.vertices, clean.vertices + 10);
    EXPECT_GT(fins.crowded_edges, 5);
    EXPECT_LE(fins.crowded_edges, 10);
    const Figures turned = recount(reverse_some(mesh, 1, seed));
    EXPECT_EQ(turned.misoriented_edges, 3);
    EXPECT_EQ(turned.edges, clean.edges);
    EXPECT_EQ(by_position(reverse_some(mesh, 1000, seed)), by_position(reversed(mesh)));
  }
  const Figures alone = recount(isolate(mesh, 77));
  EXPECT_EQ(alone.isolated_vertices, 77);
  EXPECT_EQ(alone.faces, clean.faces);
}

// Other machines must make the same meshes: figures below were seen once and are compared from then
// on.
std::uint64_t fingerprint(const std::vector<std::uint32_t>& corners) {
  std::uint64_t hash = 0xcbf29ce484222325u;  // FNV-1a by words
  for (const std::uint32_t c : corners) hash = (hash ^ c) * 0x100000001b3u;
  return hash;
}

TEST(Determinism, ConnectivityIsTheSameEverywhere) {
  EXPECT_EQ(fingerprint(flip_edges(torus(20, 20), 10000, 7).corners), 16071800385100763260u);
  EXPECT_EQ(fingerprint(shuffle(icosphere(3), 7).corners), 1392775415309005727u);
  EXPECT_EQ(fingerprint(punch_holes(grid(30, 30), 20, 7).corners), 13948235876784683061u);
  EXPECT_EQ(fingerprint(gyroid(2, 1, 1, 17, Ends::open).corners), 1353947339049239475u);
  EXPECT_EQ(fingerprint(random_soup(50, 100, 8, 7).corners), 13056768308632086277u);
}

}  // namespace
}  // namespace clers::corpus
