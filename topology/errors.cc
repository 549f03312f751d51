#include "topology/errors.h"

namespace clers {
namespace {

constexpr const char* precondition_names[precondition_count] = {
    "live_face",      "live_half_edge",        "boundary_edge", "interior_edge",
    "two_half_edges", "all_edges_on_boundary", "ids_left",
};

struct InvariantText {
  const char* name;
  const char* element;
};

constexpr InvariantText invariant_texts[invariant_count] = {
    {"array_sizes", "size"},
    {"face_pool", "face"},
    {"vertex_pool", "vertex"},
    {"curve_pool", "curve"},
    {"component_pool", "component"},
    {"origin_is_live", "half-edge"},
    {"twin_in_range", "half-edge"},
    {"twin_is_mutual", "half-edge"},
    {"twin_is_opposite", "half-edge"},
    {"star_leaves_vertex", "vertex"},
    {"star_on_boundary", "vertex"},
    {"corner_count", "vertex"},
    {"one_fan", "vertex"},
    {"ring_links", "half-edge"},
    {"ring_members", "half-edge"},
    {"ring_shape", "half-edge"},
    {"ring_order", "half-edge"},
    {"curve_names", "curve"},
    {"component_labels", "face"},
    {"component_connected", "component"},
    {"component_counts", "component"},
    {"total_counts", "count"},
    {"euler_poincare", "component"},
};

}  // namespace

const char* name(Precondition p) {
  return precondition_names[static_cast<unsigned>(p)];
}
const char* name(Invariant i) {
  return invariant_texts[static_cast<unsigned>(i)].name;
}

std::string describe(const Violation& v) {
  const bool face = v.precondition == Precondition::live_face ||
                    v.precondition == Precondition::all_edges_on_boundary ||
                    v.precondition == Precondition::ids_left;
  return std::string(name(v.precondition)) + " does not hold at " +
         (face ? "face " : "half-edge ") + std::to_string(v.element);
}

std::string describe(const Fault& f) {
  return std::string(name(f.invariant)) + " fails at " +
         invariant_texts[static_cast<unsigned>(f.invariant)].element + " " +
         std::to_string(f.element);
}

}  // namespace clers
