// A surface and an oracle that live through the same operators, step by step.
//
// Every step knows what its operator must do: whether it is refused, its effect on the counts, what
// undoes it. handle_steps.cc has those of the handle operators and of what is composed of them,
// stellar_steps.cc those of the stellar ones, composed_steps.cc those of what is composed of these.
#ifndef CLERS_TOPOLOGY_TEST_PAIR_H
#define CLERS_TOPOLOGY_TEST_PAIR_H

#include <cstdint>
#include <iosfwd>
#include <string>

#include "topology/characteristic.h"
#include "topology/stellar.h"
#include "topology/surface.h"
#include "topology/test/oracle.h"

namespace clers::test {

/// One random step; what its numbers mean depends on the surface it meets.
struct Op {
  std::uint8_t kind = 0;
  std::uint8_t choice = 0;
  std::uint16_t a = 0, b = 0;
};

void showValue(const Op& op, std::ostream& os);

class Pair {
 public:
  /// Thorough: compares with what was before, and undoes every step on a copy.
  explicit Pair(bool thorough) : thorough_(thorough) {}

  const Surface& surface() const { return surface_; }
  const Oracle& oracle() const { return oracle_; }
  std::uint64_t glued(HandleCase kind) const { return glued_[static_cast<unsigned>(kind)]; }
  std::uint64_t split(StellarCase kind) const { return split_[static_cast<unsigned>(kind)]; }
  std::uint64_t welded(StellarCase kind) const { return welded_[static_cast<unsigned>(kind)]; }
  std::uint64_t composed(unsigned which) const { return composed_[which]; }
  std::uint64_t done() const { return done_; }
  std::uint64_t refused() const { return refused_; }

  /// Does the step; empty, or what went wrong.
  std::string step(const Op& op, std::uint32_t target_faces);

  /// Empty, or what the oracle or validate() says.
  std::string check() const;

 private:
  // pair.cc: what steps are made of.
  std::string stellar(const Op& op, bool crowded);
  std::uint32_t random(std::uint32_t n);
  /// Mostly a live half-edge on the boundary or inside; now and then any number at all.
  HalfEdge pick(bool boundary);
  bool simple_star(Vertex v) const;
  std::string refuse(const std::string& before);
  /// Half-edge by half-edge: not only equivalent, but of the same ids.
  static bool identical(const Surface& a, const Surface& b);
  static std::string compare(const Surface& a, const Surface& b, const char* wrong);

  // handle_steps.cc
  HalfEdge partner(const Op& op);
  std::string create(const Op& op);
  std::string destroy(const Op&);
  std::string glue(HalfEdge h0, HalfEdge h1);
  std::string unglue(HalfEdge h);
  std::string attach(HalfEdge h, Point p);
  std::string detach(const Op& op);

  // stellar_steps.cc
  std::string flip(HalfEdge h);
  std::string unsplit(const Surface& old, Vertex v, StellarCase kind, bool exact);
  std::string split_edge(HalfEdge h, Point p);
  std::string split_face(Face f, Point p);
  HalfEdge pick_weldable();
  std::string weld(const Op& op);
  std::string turn(Face f);
  std::string begin_star(HalfEdge h);

  // composed_steps.cc
  bool may_collapse(HalfEdge h) const;
  std::string collapse(HalfEdge h);
  std::string split_vertex(const Op& op);
  std::string remove(const Op& op);

  Surface surface_;
  Oracle oracle_;
  bool thorough_;
  std::uint64_t seed_ = 0;
  HalfEdge first_;  // that of the glue under way
  std::uint64_t glued_[handle_case_count] = {};
  std::uint64_t split_[stellar_case_count] = {}, welded_[stellar_case_count] = {};
  std::uint64_t composed_[4] = {};        // collapse, split_vertex, remove, flip
  std::uint64_t done_ = 0, refused_ = 0;  // counting the parts of attach and detach
};

}  // namespace clers::test

#endif
