// A multi-triangulation with its labels, and the oracle that lives through the same calls.
#ifndef CLERS_TOPOLOGY_MODELING_TEST_TRACKED_MESH_H
#define CLERS_TOPOLOGY_MODELING_TEST_TRACKED_MESH_H

#include <cstdint>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "topology/modeling/labels.h"
#include "topology/modeling/multi_triangulation.h"
#include "topology/modeling/test/hierarchy.h"

namespace clers::test {

class TrackedMesh {
 public:
  explicit TrackedMesh(Surface base);

  MultiTriangulation& mesh() { return mesh_; }
  const Surface& surface() const { return mesh_.surface(); }
  const Hierarchy& oracle() const { return oracle_; }

  // Each does the call on both, and compares what it did: empty, or what is wrong.
  std::string refine(HalfEdge h);
  std::string simplify(Vertex v);
  /// From a bad argument, too.
  std::string refuse_refine(HalfEdge h, Precondition why);
  std::string refuse_simplify(Vertex v, Precondition why);
  /// Takes away all that was refined, in an order given by `seed`: then it is the base again.
  std::string simplify_all(std::uint32_t seed);

  /// Compares everything: validity, levels, every face and edge with the oracle's leaves, labels.
  std::string check() const;

 private:
  /// Where corner c of a face is: the base face, and the place in it.
  struct At {
    std::uint32_t base = 0;
    Place place;
  };
  At corner_at(Face f, unsigned c) const;
  At at(const Label& label) const;
  Spot middle(HalfEdge h) const;
  std::string compare(std::size_t made, std::size_t gone, const std::vector<Spot>& spots);

  /// Follows the mesh.
  struct Observer {
    TrackedMesh& of;
    void operator()(const Refined& change);
    void operator()(const Simplified& change);
  };

  MultiTriangulation mesh_;
  Labels labels_;
  Hierarchy oracle_;
  std::string base_dump_;
  std::vector<std::uint32_t> faces_of_block_;          // two each; the second may be that of nobody
  std::unordered_map<std::uint32_t, Label> label_of_;  // of vertices refined, since they were made
  std::vector<Spot> made_, gone_;
  std::string wrong_;
};

}  // namespace clers::test

#endif
