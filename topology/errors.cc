// Errors as sentences.
#include "topology/errors.h"

#include "topology/ids.h"

namespace CLERS_VISIBLE clers {
namespace {

struct Text {
  const char* name;
  const char* element;
};

constexpr Text precondition_texts[precondition_count] = {
    {"live_face", "face"},
    {"live_half_edge", "half-edge"},
    {"boundary_edge", "half-edge"},
    {"interior_edge", "half-edge"},
    {"two_half_edges", "half-edge"},
    {"all_edges_on_boundary", "face"},
    {"ids_left", "face"},
    {"live_vertex", "vertex"},
    {"two_faces", "half-edge"},
    {"simple_star", "vertex"},
    {"weld_degree", "vertex"},
    {"link_condition", "half-edge"},
    {"leave_one_vertex", "half-edge"},
    {"interior_vertex", "vertex"},
    {"one_sharp_edge", "face"},
    {"tri_quad", "half-edge"},
    {"refined_vertex", "vertex"},
    {"levels_left", "half-edge"},
};

constexpr Text invariant_texts[invariant_count] = {
    {"array_sizes", "size"},
    {"face_pool", "face"},
    {"vertex_pool", "vertex"},
    {"curve_pool", "curve"},
    {"component_pool", "component"},
    {"node_pool", "node"},
    {"origin_is_live", "half-edge"},
    {"twin_in_range", "half-edge"},
    {"twin_is_mutual", "half-edge"},
    {"twin_is_opposite", "half-edge"},
    {"star_leaves_vertex", "vertex"},
    {"star_on_boundary", "vertex"},
    {"corner_count", "vertex"},
    {"one_fan", "vertex"},
    {"ring_links", "node"},
    {"ring_members", "vertex"},
    {"ring_shape", "node"},
    {"ring_order", "half-edge"},
    {"curve_names", "curve"},
    {"component_labels", "face"},
    {"component_connected", "component"},
    {"component_counts", "component"},
    {"total_counts", "count"},
    {"euler_poincare", "component"},
};

constexpr Text face_rule_texts[face_rule_count] = {
    {"array_sizes", "size"},
    {"vertex_in_range", "half-edge"},
    {"distinct_corners", "face"},
    {"at_most_two_faces", "half-edge"},
    {"opposite_directions", "half-edge"},
    {"one_fan", "vertex"},
};

std::string fails_at(const Text& text, std::uint32_t element) {
  return std::string(text.name) + " fails at " + text.element + " " + std::to_string(element);
}

}  // namespace

const char* name(Precondition p) {
  return precondition_texts[static_cast<unsigned>(p)].name;
}
const char* name(Invariant i) {
  return invariant_texts[static_cast<unsigned>(i)].name;
}
const char* name(FaceRule r) {
  return face_rule_texts[static_cast<unsigned>(r)].name;
}

std::string describe(const Violation& v) {
  const char* const element = precondition_texts[static_cast<unsigned>(v.precondition)].element;
  const std::string at = v.element == HalfEdge::null_index
                             ? std::string("a null ") + element
                             : std::string(element) + " " + std::to_string(v.element);
  return std::string(name(v.precondition)) + " does not hold at " + at;
}

std::string describe(const Fault& f) {
  return fails_at(invariant_texts[static_cast<unsigned>(f.invariant)], f.element);
}

std::string describe(const BrokenRule& b) {
  return fails_at(face_rule_texts[static_cast<unsigned>(b.rule)], b.element);
}

}  // namespace clers
