// The manifest's rows against the meshes that their recipes make.
#include <gtest/gtest.h>

#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "corpus/generate.h"
#include "corpus/recipe.h"
#include "corpus/test/recount.h"

namespace clers::corpus {
namespace {

enum Column { name, kind, source, sum, vertices, triangles, components, curves, genus, columns };

std::vector<std::vector<std::string>> rows() {
  std::ifstream file(CLERS_CORPUS_MANIFEST);
  std::vector<std::vector<std::string>> out;
  std::string line;
  std::getline(file, line);  // the header
  while (std::getline(file, line)) {
    std::istringstream fields(line);
    out.emplace_back();
    for (std::string field; std::getline(fields, field, '\t');) out.back().push_back(field);
  }
  return out;
}

bool is_package(const std::string& source) {
  return source.compare(0, 4, "npm:") == 0 || source.compare(0, 4, "deb:") == 0;
}

TEST(Manifest, IsComplete) {
  const std::set<std::string> kinds = {
      "scan",    "cad",     "game",     "terrain",    "medical",     "quad",         "irregular",
      "regular", "handles", "boundary", "components", "nonmanifold", "nonorientable"};
  std::set<std::string> names, kinds_seen;
  for (const auto& row : rows()) {
    ASSERT_EQ(row.size(), columns) << row[0];
    EXPECT_TRUE(names.insert(row[name]).second) << row[name] << " twice";
    EXPECT_EQ(kinds.count(row[kind]), 1u) << row[name] << " has class " << row[kind];
    EXPECT_EQ(row[sum].size(), is_package(row[source]) ? 64u : 1u) << row[name];
    kinds_seen.insert(row[kind]);
  }
  EXPECT_EQ(kinds_seen, kinds);
}

TEST(Manifest, FiguresAreThoseOfTheMeshes) {
  int checked = 0;
  for (const auto& row : rows()) {
    if (is_package(row[source]) || std::stol(row[triangles]) > 300000) continue;
    SCOPED_TRACE(row[name]);
    const std::optional<Mesh> mesh = cook(row[source]);
    ASSERT_TRUE(mesh);
    ++checked;
    EXPECT_EQ(std::to_string(mesh->vertex_count), row[vertices]);
    if (!mesh->triangles_only()) {
      EXPECT_EQ(std::to_string(mesh->corners.size() - 2 * mesh->face_count()), row[triangles]);
      EXPECT_EQ(row[components] + row[curves] + row[genus], "---");
      continue;
    }
    const Figures n = recount(*mesh);
    EXPECT_EQ(std::to_string(n.faces), row[triangles]);
    EXPECT_EQ(std::to_string(n.components), row[components]);
    EXPECT_EQ(n.manifold() ? std::to_string(n.boundary_curves) : "-", row[curves]);
    EXPECT_EQ(n.surface() ? std::to_string(n.genus) : "-", row[genus]);
    EXPECT_EQ(n.surface(), row[kind] != "nonmanifold" && row[kind] != "nonorientable");
  }
  EXPECT_GT(checked, 25);
}

TEST(Recipe, IsTheCallItSays) {
  EXPECT_EQ(cook("tetrahedron")->corners, tetrahedron().corners);
  EXPECT_EQ(cook(" shuffle ( torus(5 ,4),9 ) ")->corners, shuffle(torus(5, 4), 9).corners);
  EXPECT_EQ(cook("gyroid(1,1,2,8,open)")->corners, gyroid(1, 1, 2, 8, Ends::open).corners);
  EXPECT_EQ(cook("disjoint_union(grid(1,1),strip(3))")->face_count(), 5u);
  EXPECT_EQ(cook("torus(5,4)")->name, "torus(5,4)");
}

TEST(Recipe, RefusesWhatItDoesNotUnderstand) {
  for (const char* recipe :
       {"", "5", "open", "cube", "torus", "torus(5)", "torus(5,4", "torus(5,4))", "torus(5,4,3)",
        "torus(5,open)", "torus(5,-4)", "torus(5,5000000000)", "shuffle(5,torus(5,4))",
        "torus(5,4) x", "gyroid(1,1,1,8,closed)", "torus(5,)", "99999999999999999999"})
    EXPECT_FALSE(cook(recipe)) << recipe;
}

}  // namespace
}  // namespace clers::corpus
