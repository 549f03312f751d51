// Draws the figures of Topological mesh operators, and of Dynamic adaptive meshes (dam), from
// surfaces on which our operators have just done what is shown. usage: draw DIRECTORY
#include <cstdio>
#include <cstdlib>
#include <fstream>

#include "topology/figures/drawing.h"

namespace clers::figures {
namespace {

void save(const std::string& directory, const char* file, const std::string& svg) {
  std::ofstream out(directory + "/" + file, std::ios::binary);
  out << svg;
  out.close();
  if (!out) {
    std::fprintf(stderr, "draw: cannot write %s/%s\n", directory.c_str(), file);
    std::exit(1);
  }
}

}  // namespace
}  // namespace clers::figures

int main(int argc, char** argv) {
  using namespace clers::figures;
  if (argc != 2) {
    std::fprintf(stderr, "usage: draw DIRECTORY\n");
    return 2;
  }
  const std::string directory = argv[1];
  save(directory, "fig01-handles.svg", handles_by_index());
  save(directory, "fig02-torus-of-handles.svg", torus_of_handles());
  save(directory, "fig03-bistellar-moves.svg", bistellar_moves());
  save(directory, "fig04-split-interior-edge.svg", split_interior_edge());
  save(directory, "fig05-split-boundary-edge.svg", split_boundary_edge());
  save(directory, "fig06-flip-by-split-and-weld.svg", flip_by_split_and_weld());
  save(directory, "fig07-create.svg", create());
  save(directory, "fig08-glue-type-1.svg", handles_of_type_1());
  save(directory, "fig09-glue-type-2.svg", close());
  save(directory, "fig10-zip.svg", zip());
  save(directory, "fig11-two-zips.svg", two_zips());
  save(directory, "fig12-edge-collapse.svg", edge_collapse());
  save(directory, "fig13-advancing-front.svg", advancing_front());
  save(directory, "fig14-edgebreaker.svg", moves_of_edgebreaker());
  save(directory, "fig15-sqrt3.svg", sqrt3_rules());
  save(directory, "fig18-dependencies.svg", dependencies());
  save(directory, "fig19-deforming-sphere.svg", deforming_sphere());
  save(directory, "dam05-interleaved-refinement.svg", interleaved_refinement());
  save(directory, "dam06-dependencies-in-refinement.svg", dependencies_in_refinement());
  save(directory, "dam07-dependencies-in-simplification.svg", dependencies_in_simplification());
  save(directory, "dam09-numbering.svg", numbering());
  save(directory, "dam10-weld-by-star.svg", weld_by_star());
  save(directory, "dam11-brush-of-resolution.svg", brush_of_resolution());
  save(directory, "dam-torus-by-label.svg", torus_by_label());
}
