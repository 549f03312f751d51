// A second, slow account of a surface: triangles and which half-edges are glued, recounted from
// nothing each time. Shares no code with the surface it judges but the arithmetic of half-edge ids.
#ifndef CLERS_TOPOLOGY_TEST_ORACLE_H
#define CLERS_TOPOLOGY_TEST_ORACLE_H

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "topology/surface.h"

namespace clers::test {

class Oracle {
 public:
  void create(std::uint32_t face);
  void destroy(std::uint32_t face);
  void glue(std::uint32_t h0, std::uint32_t h1);
  void unglue(std::uint32_t h);

  // The stellar operators, as surface.h says what becomes of half-edges; `born` are the faces that
  // the surface made, `die` those it freed, as it says.
  void flip(std::uint32_t h);
  void split_edge(std::uint32_t h, std::uint32_t born_f, std::uint32_t born_g);
  void split_face(std::uint32_t f, std::uint32_t born_b, std::uint32_t born_c);
  void weld(std::uint32_t h);
  void turn(std::uint32_t f);

  /// Takes over which faces are alive and what is glued, and judges all the rest from then on.
  void adopt(const Surface& surface);

  /// Classes by half-edge (dead: -1) and counts, all from the gluing alone.
  struct Account {
    std::vector<int> vertex_of;     // of the origin
    std::vector<int> curve_of;      // -1 off the boundary
    std::vector<int> component_of;  // of the face
    std::vector<Characteristic> components;
    Characteristic total;
  };
  Account recount() const;

  /// Empty if the surface agrees with the account in everything its queries tell, else the first
  /// difference.
  std::string compare(const Surface& surface) const;

 private:
  using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;
  void replace(const Pairs& rim, const Pairs& inside, const std::vector<std::uint32_t>& born,
               const std::vector<std::uint32_t>& die);
  std::uint32_t mate(std::uint32_t h) const { return static_cast<std::uint32_t>(mate_[h]); }

  std::vector<bool> alive_;         // by face
  std::vector<std::int64_t> mate_;  // by half-edge, -1: none
};

}  // namespace clers::test

#endif
