#include "codec/soup/adjacency.h"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <set>
#include <utility>

#include "corpus/generate.h"

namespace clers::internal {
namespace {

/// Twins by a map of directed edges.
std::vector<HalfEdge> twins_by_map(const Mesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> sides;
  const auto dest = [&](std::uint32_t h) { return mesh.corners[lnext(HalfEdge(h)).index()]; };
  for (std::uint32_t h = 0; h < mesh.corners.size(); ++h) sides[{mesh.corners[h], dest(h)}] = h;
  std::vector<HalfEdge> twins;
  for (std::uint32_t h = 0; h < mesh.corners.size(); ++h) {
    const auto other = sides.find({dest(h), mesh.corners[h]});
    twins.push_back(other == sides.end() ? HalfEdge() : HalfEdge(other->second));
  }
  return twins;
}

/// All sides of each edge by a map of undirected ones: regular pairs and defects.
Adjacency edges_by_map(const Mesh& mesh) {
  const Faces faces(mesh.corners, mesh.face_sizes);
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::uint32_t>> edges;
  for (std::uint32_t h = 0; h < mesh.corners.size(); ++h)
    edges[std::minmax(faces.org[h], faces.org[faces.next(h)])].push_back(h);
  Adjacency all;
  all.twins.resize(mesh.corners.size());
  std::map<std::uint32_t, std::vector<std::uint32_t>> defects;  // by first side
  for (const auto& [ends, sides] : edges) {
    if (sides.size() == 2 && faces.org[sides[0]] != faces.org[sides[1]]) {
      all.twins[sides[0]] = HalfEdge(sides[1]);
      all.twins[sides[1]] = HalfEdge(sides[0]);
    } else if (sides.size() > 1) {
      defects[sides[0]] = sides;
    }
  }
  for (const auto& [first, sides] : defects) {
    all.sides.insert(all.sides.end(), sides.begin(), sides.end());
    all.ends.push_back(static_cast<std::uint32_t>(all.sides.size()));
  }
  return all;
}

void expect_edges_of_map(const Mesh& mesh) {
  const Adjacency found = match_edges({mesh.corners, mesh.face_sizes}, mesh.vertex_count);
  const Adjacency expected = edges_by_map(mesh);
  ASSERT_EQ(found.twins, expected.twins);
  ASSERT_EQ(found.sides, expected.sides);
  ASSERT_EQ(found.ends, expected.ends);
}

Error error_of(std::vector<std::uint32_t> corners, std::uint32_t vertices) {
  auto twins = find_twins({corners, {}}, vertices);
  EXPECT_FALSE(twins.ok());
  return twins.ok() ? Error{} : twins.error();
}

TEST(Adjacency, EqualsAMapOfDirectedEdges) {
  for (const Mesh& mesh :
       {corpus::icosphere(3), corpus::torus(30, 20), corpus::grid(20, 10), corpus::fan(500),
        corpus::glued_pair(), corpus::strip(9), corpus::gyroid(1, 1, 1, 12, corpus::Ends::open)}) {
    for (const Mesh& m : {mesh, corpus::shuffle(mesh, 7)}) {
      auto twins = find_twins({m.corners, m.face_sizes}, m.vertex_count);
      ASSERT_TRUE(twins.ok()) << describe(twins.error());
      EXPECT_EQ(*twins, twins_by_map(m));
    }
  }
}

/// Few vertices, so that edges of three faces, faces turned and hubs of more edges than a cache
/// line takes are common: refused if and only if a directed edge comes twice.
TEST(Adjacency, RandomFacesAgainstAMapOfDirectedEdges) {
  std::mt19937 engine(5);
  const auto random = [&] { return static_cast<std::uint32_t>(engine()); };
  int good = 0;
  for (int round = 0; round < 20000; ++round) {
    Mesh mesh;
    mesh.vertex_count = 4 + random() % 20;
    std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
    bool twice = false;
    for (std::uint32_t f = 0; f < 3 * mesh.vertex_count; ++f) {
      std::uint32_t c[3];
      for (std::uint32_t& v : c)
        v = random() % 8 != 0 ? random() % mesh.vertex_count : random() % 2;
      if (c[0] == c[1] || c[1] == c[2] || c[2] == c[0]) continue;
      unsigned there = 0;
      for (unsigned i = 0; i < 3; ++i) there += edges.count({c[i], c[(i + 1) % 3]}) > 0;
      if (there > 0 && random() % 24 != 0) continue;  // mostly one that fits
      twice |= there > 0;
      for (unsigned i = 0; i < 3; ++i) edges.insert({c[i], c[(i + 1) % 3]});
      mesh.corners.insert(mesh.corners.end(), c, c + 3);
    }
    SCOPED_TRACE(round);
    expect_edges_of_map(mesh);
    auto twins = find_twins({mesh.corners, {}}, mesh.vertex_count);
    ASSERT_EQ(twins.ok(), !twice) << round;
    if (!twins) continue;
    ++good;
    ASSERT_EQ(*twins, twins_by_map(mesh)) << round;
  }
  EXPECT_GT(good, 5000);
  EXPECT_LT(good, 15000);
}

TEST(Adjacency, SoupsAgainstAMapOfEdges) {
  for (unsigned seed = 0; seed < 2000; ++seed) {
    SCOPED_TRACE(seed);
    Mesh mesh = corpus::random_soup(4 + seed % 60, 2 + seed % 97, 3, seed);
    std::vector<std::uint32_t> corners;
    for (std::size_t h = 0; h < mesh.corners.size(); h += 3) {
      const std::uint32_t* c = &mesh.corners[h];
      if (c[0] != c[1] && c[1] != c[2] && c[2] != c[0]) corners.insert(corners.end(), c, c + 3);
    }
    mesh.corners = corners;
    mesh.face_sizes.clear();
    expect_edges_of_map(mesh);
  }
  expect_edges_of_map(corpus::book(3000));
}

/// Vertices that no face has take no memory, and a look ahead does not leave the faces.
TEST(Adjacency, FewFacesOnManyVertices) {
  for (const std::uint32_t vertices : {70000u, 0xffffffffu}) {
    const std::vector<std::uint32_t> corners = {vertices - 1, 5, 9, 5, vertices - 1, 7};
    const Adjacency all = match_edges({corners, {}}, vertices);
    EXPECT_EQ(all.twins[0], HalfEdge(3));
    EXPECT_EQ(all.twins[3], HalfEdge(0));
    EXPECT_TRUE(all.ends.empty());
  }
}

/// A hub whose edges come in random order defeats the streaming lists; time must stay near linear.
TEST(Adjacency, ShuffledHub) {
  const Mesh mesh = corpus::shuffle(corpus::fan(100000), 3);
  auto twins = find_twins({mesh.corners, mesh.face_sizes}, mesh.vertex_count);
  ASSERT_TRUE(twins.ok());
  EXPECT_EQ(*twins, twins_by_map(mesh));
}

TEST(Adjacency, NamesWhatIsWrong) {
  Error e = error_of({4, 5, 6, 0, 1, 2, 1, 0, 3, 0, 1, 7}, 8);
  EXPECT_EQ(e.code, ErrorCode::nonmanifold_edge);
  EXPECT_EQ(e.place, Place::face);
  EXPECT_EQ(e.at, 1u);

  e = error_of({0, 1, 2, 0, 1, 3}, 4);
  EXPECT_EQ(e.code, ErrorCode::nonorientable);
  EXPECT_EQ(e.at, 0u);

  const Mesh strip = corpus::moebius_strip(6, 1);
  EXPECT_EQ(error_of(strip.corners, strip.vertex_count).code, ErrorCode::nonorientable);
}

TEST(Adjacency, FindsVerticesOfSeveralFans) {
  const auto found = [](const std::vector<std::uint32_t>& corners, std::uint32_t vertices) {
    auto twins = find_twins({corners, {}}, vertices);
    EXPECT_TRUE(twins.ok());
    return vertex_of_several_fans({corners, {}}, *twins, vertices);
  };
  EXPECT_EQ(found({0, 1, 2, 2, 3, 4}, 5), 2u);
  const Mesh board = corpus::chessboard(3);
  EXPECT_NE(found(board.corners, board.vertex_count), Vertex::null_index);
  for (const Mesh& mesh : {corpus::grid(4, 4), corpus::torus(5, 5), corpus::single_triangle()})
    EXPECT_EQ(found(mesh.corners, mesh.vertex_count), Vertex::null_index);
}

/// An edge of four faces, whose ends are one fan each when its faces are matched in pairs.
TEST(Adjacency, AnEdgeOfFourFacesIsFoundThoughFansAreSingle) {
  const std::vector<std::uint32_t> corners = {0, 1, 2, 1, 0, 3, 0, 1, 4, 1, 0, 5,
                                              0, 2, 5, 2, 1, 5, 0, 4, 3, 4, 1, 3};
  EXPECT_EQ(error_of(corners, 6).code, ErrorCode::nonmanifold_edge);
}

}  // namespace
}  // namespace clers::internal
