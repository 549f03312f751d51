// What the figures share: small surfaces and where they are drawn, and the figures themselves.
#ifndef CLERS_TOPOLOGY_FIGURES_DRAWING_H
#define CLERS_TOPOLOGY_FIGURES_DRAWING_H

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include "topology/figures/scene.h"
#include "topology/test/meshes.h"

namespace clers::figures {

/// A figure must not show what did not happen.
inline void must(bool ok, const char* what) {
  if (ok) return;
  std::fprintf(stderr, "draw: %s\n", what);
  std::exit(1);
}
template <class T>
T must(Result<T, Violation> result) {
  if (!result) must(false, describe(result.error()).c_str());
  return *std::move(result);
}

/// These triangles, vertex i at place i.
Scene patch(const test::Triangles& triangles, std::vector<Place> at);
Scene triangle();
/// Two triangles about the edge from 0 to 1.
Scene diamond();
/// A disk as a fan about vertex 0.
Scene fan(std::uint32_t corners, double radius);

HalfEdge between(const Scene& scene, std::uint32_t a, std::uint32_t b);
Place on_circle(double radius, double turns);
Place mean_of_neighbours(const Scene& scene, Vertex v);

// The figures, as SVG: handle_figures.cc,
std::string handles_by_index();
std::string torus_of_handles();
std::string create();
std::string handles_of_type_1();
std::string close();
std::string zip();
std::string two_zips();
// stellar_figures.cc,
std::string bistellar_moves();
std::string split_interior_edge();
std::string split_boundary_edge();
std::string flip_by_split_and_weld();
std::string edge_collapse();
std::string sqrt3_rules();
// edgebreaker_figure.cc,
std::string moves_of_edgebreaker();
// block_figures.cc,
std::string interleaved_refinement();
std::string numbering();
std::string weld_by_star();
// dependency_figures.cc,
std::string dependencies_in_refinement();
std::string dependencies_in_simplification();
std::string dependencies();
// front_figure.cc,
std::string advancing_front();
// shaded_figures.cc.
std::string deforming_sphere();
std::string brush_of_resolution();
std::string torus_by_label();

}  // namespace clers::figures

#endif
