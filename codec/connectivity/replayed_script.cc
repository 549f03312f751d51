// Spirale Reversi once more, beside the full surface, walking along curves.
#include "codec/connectivity/replayed_script.h"

#include <algorithm>
#include <utility>

#include "codec/base/portable.h"
#include "codec/connectivity/spirale_reversi.h"

namespace clers::internal {
namespace {

/// Answers the driver's questions from a traversal, and writes down what the stream must carry,
/// and in which context.
class RecordingSource {
 public:
  static constexpr bool knows_vertices = true;

  RecordingSource(const Traversal& traversal, const Building& building)
      : traversal_(traversal),
        building_(building),
        faces_(static_cast<std::uint32_t>(traversal.gates.size())),
        index_(faces_) {
    script.contexts.resize(faces_);
    next_start_ = traversal.starts.size();
    next_special_ = traversal.specials.size();
    if (!traversal.specials.empty()) {
      index_of_face_.resize(faces_);
      for (std::uint32_t i = 0; i < faces_; ++i)
        index_of_face_[left(traversal.gates[i]).index()] = i;
      curve_of_.resize(building.links.size());
    }
  }

  void first() { step(0); }
  template <class Front, class Gate, class Then>
  CLERS_ALWAYS_INLINE auto symbol(const Front&, const Gate& gate, std::size_t, Then then) {
    step(gate.kx);
    return with_symbol(traversal_.symbol(index_), then);
  }

  bool new_component(bool two_edges) {
    // Symbols come last to first: a component ends where the one decoded before it started.
    const bool value = traversal_.starts[next_start_ - 1].index == index_ + 1;
    script.events.push_back({done(), Event::Kind::new_component, value, two_edges});
    return value;
  }
  bool closed() {
    const bool value = traversal_.starts[next_start_ - 1].closed;
    script.events.push_back({done(), Event::Kind::closed, value});
    return value;
  }
  void component_ended() { --next_start_; }
  /// Holes are the curves that no S joined.
  bool nothing_waits(std::vector<std::uint32_t>& holes) {
    holes.clear();
    for (const Waiting& w : waiting_) {
      holes.push_back(w.vertex);
      script.events[w.event].kind = Event::Kind::hole;
      script.events[w.event].length = 0;
    }
    waiting_.clear();
    return true;
  }

  bool special() {
    const bool value = is_special();
    script.events.push_back({done(), Event::Kind::special, value});
    return value;
  }

  /// Finds the edge that the S glues to: on a curve split off before, or on the gate's own.
  SpecialVertex special_vertex(std::uint32_t x, std::uint32_t y) {
    const FrontLink* const links = building_.links.data();
    const std::uint32_t q = vertex_at(traversal_.specials[--next_special_].left);
    const std::uint32_t curve = curve_of_[q];
    for (std::size_t w = waiting_.size(); w-- > 0;) {
      if (waiting_[w].number != curve) continue;
      Event e{done(), Event::Kind::join};
      for (std::uint32_t v = waiting_[w].vertex; v != q; v = links[v].prev) ++e.distance;
      e.length = 1;
      for (std::uint32_t v = links[q].prev; v != q; v = links[v].prev) ++e.length;
      waiting_.erase(waiting_.begin() + static_cast<std::ptrdiff_t>(w));
      curves_.push_back(curve);
      script.events.push_back(e);
      return {true, SpecialS::join, q};
    }
    const std::uint32_t number = ++split_off_;
    Event e{done(), Event::Kind::split};
    for (std::uint32_t v = x; v != q || e.distance == 0;) {
      if (v == y) return {};  // not there: the vertex was marked from another fan of its corners
      v = links[v].prev;
      curve_of_[v] = number;
      ++e.distance;
    }
    e.length = 2;  // edges: x to y backwards, and the gate
    for (std::uint32_t v = links[x].prev; v != y; v = links[v].prev) ++e.length;
    waiting_.push_back({number, q, script.events.size()});
    curves_.push_back(number);
    script.events.push_back(e);
    return {true, SpecialS::split, q};
  }

  /// How recent the curves were that were joined, among those that were to be joined.
  void tell_recency() {
    std::vector<std::uint32_t> waiting;
    std::size_t next = 0;
    for (Event& e : script.events) {
      if (e.kind < Event::Kind::hole) continue;
      const std::uint32_t curve = curves_[next++];
      if (e.kind == Event::Kind::split) waiting.push_back(curve);
      if (e.kind != Event::Kind::join) continue;
      const auto at = std::find(waiting.begin(), waiting.end(), curve);
      e.recency = static_cast<std::uint32_t>(waiting.end() - at) - 1;
      waiting.erase(at);
    }
  }

  DecodeScript script;

 private:
  void step(std::uint32_t kx) {
    --index_;
    script.contexts[done()] =
        static_cast<std::uint8_t>(std::min(kx, Traversal::max_valence) << 3 |
                                  static_cast<unsigned>(traversal_.symbol(index_)));
  }
  std::uint32_t done() const { return faces_ - 1 - index_; }

  bool is_special() const {
    return next_special_ > 0 && traversal_.specials[next_special_ - 1].index == index_;
  }

  /// The vertex of the construction at the end of a half-edge of the input.
  std::uint32_t vertex_at(HalfEdge h) const {
    const std::uint32_t i = index_of_face_[left(h).index()];
    const unsigned side = (corner(h) + 1 + 3 - corner(traversal_.gates[i])) % 3;
    std::uint32_t v = building_.corners[3 * std::size_t(i) + side];
    while (building_.links[v].valence == merged_away) v = building_.links[v].prev;
    return v;
  }

  const Traversal& traversal_;
  const Building& building_;
  std::uint32_t faces_;
  std::uint32_t index_;  ///< in the traversal, of the current symbol
  std::size_t next_start_, next_special_;
  std::vector<std::uint32_t> index_of_face_;
  std::vector<std::uint32_t> curve_of_;  ///< last curve that a vertex was split off with, from 1
  struct Waiting {
    std::uint32_t number, vertex;
    std::size_t event;
  };
  std::vector<Waiting> waiting_;       ///< curves that are split off: for handles, and holes
  std::vector<std::uint32_t> curves_;  ///< numbers of the curves of hole, split and join
  std::uint32_t split_off_ = 0;
};

}  // namespace

std::optional<DecodeScript> replayed_script(std::span<const std::uint32_t> org,
                                            std::uint32_t vertex_count, const Traversal& traversal,
                                            BuildingMirror& pairing) {
  const std::uint32_t faces = static_cast<std::uint32_t>(traversal.gates.size());
  std::vector<std::uint32_t> corners(3 * std::size_t(faces));
  std::vector<FrontLink> links(3 * std::size_t(faces));
  Building building;
  building.corners = corners;
  building.links = links;
  RecordingSource source(traversal, building);
  const StreamError breakage =
      SpiraleReversi<BuildingMirror, RecordingSource>(building, pairing, source).run();
  if (breakage.broken != StreamFault::none) return std::nullopt;

  resolve_merges(building);
  std::vector<std::uint32_t>& vertices = source.script.vertices;
  vertices.resize(building.finished);
  std::uint32_t id = 0;
  const auto number = [&](HalfEdge corner) {
    vertices[building.finished - 1 - links[id++].prev] = org[corner.index()];
  };
  for (std::uint32_t i = faces; i-- > 0;) {  // vertices as they were made: by E, L and R
    const HalfEdge gate = traversal.gates[i];
    const Clers symbol = traversal.symbol(i);
    if (symbol == Clers::E || symbol == Clers::L) number(gate);
    if (symbol == Clers::E || symbol == Clers::R) number(lnext(gate));
    if (symbol == Clers::E) number(lprev(gate));
  }
  std::vector<bool> numbered(vertex_count);
  for (const std::uint32_t v : vertices) {
    if (numbered[v]) return std::nullopt;
    numbered[v] = true;
  }
  source.tell_recency();
  return std::move(source.script);
}

}  // namespace clers::internal
