// Spirale Reversi once more, over the symbols that Edgebreaker found.
#include "codec/connectivity/place_handles.h"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <vector>

#include "codec/base/portable.h"
#include "codec/connectivity/spirale_reversi.h"
#include "codec/symbols/symbol.h"
#include "topology/front.h"

namespace clers::internal {
namespace {

/// Answers the driver's questions from a traversal, and finds out where its handles are; and
/// valences, if they are wanted.
template <bool valences>
class PlacingSource {
 public:
  static constexpr bool knows_vertices = true;

  PlacingSource(Traversal& traversal, const Building& building)
      : traversal_(traversal),
        building_(building),
        curves_(building.links.data(), building.links.size()),
        faces_(static_cast<std::uint32_t>(traversal.contexts.size())),
        index_(faces_),
        next_start_(traversal.starts.size()),
        next_special_(traversal.specials.size()) {}

  void first() { --index_; }
  template <class Front, class Gate, class Then>
  CLERS_ALWAYS_INLINE auto symbol(const Front&, const Gate& gate, std::size_t, Then then) {
    std::uint8_t& context = traversal_.contexts[faces_ - index_--];
    if constexpr (valences)
      context = static_cast<std::uint8_t>(context | std::min(gate.kx, Traversal::max_valence) << 3);
    return with_symbol(static_cast<Clers>(context & 7), then);
  }

  bool new_component(bool) {
    // Symbols come last to first: a component ends where the one decoded before it started.
    return traversal_.starts[next_start_ - 1].index == index_ + 1;
  }
  bool closed() { return traversal_.starts[next_start_ - 1].closed; }
  void component_ended() { --next_start_; }
  bool nothing_waits(const std::vector<std::uint32_t>&) { return waiting_.empty(); }

  bool special() const {
    return next_special_ > 0 && traversal_.specials[next_special_ - 1].index == index_;
  }

  SpecialVertex special_vertex(std::uint32_t x, std::uint32_t y) {
    if (!special()) return {};
    Traversal::Special& s = traversal_.specials[--next_special_];
    std::uint32_t q;
    if (s.kind == SpecialS::hole) {
      q = x;
      for (std::uint32_t k = 0; k < s.distance; ++k) q = building_.links[q].prev;
      return {true, s.kind, q};
    }
    q = end_of_left(s);
    const CurveIndex::Curve gathered = curves_.gather(x, y);
    const auto [curve, place] = curves_.place(q);
    const std::uint32_t n = curves_.length(curve);
    s.length = n;
    if (const WaitingCurves::Ticket ticket = curves_.name(curve)) {
      s.kind = SpecialS::join;
      s.distance = place + 1 == n ? 0 : place + 1;
      s.recency = waiting_.recency(ticket);
      waiting_.take(s.recency);
      curves_.join(gathered, curve, place);
    } else {
      if (place < 2 || n < 3 || place > n - 3) return {};
      s.kind = SpecialS::split;
      s.distance = place;
      const CurveIndex::Curve ring = curves_.split_off(curve, place);
      curves_.set_name(ring, waiting_.put(ring));
    }
    return {true, s.kind, q};
  }

 private:
  /// The vertex of the construction at the end of the edge that a handle's S is glued to.
  std::uint32_t end_of_left(const Traversal::Special& s) {
    std::uint32_t v = building_.corners[lnext(s.visited).index()];
    // What vertices merged into may have merged too. Paths are halved, so that none stays long.
    while (building_.links[v].valence == merged_away) {
      std::uint32_t& into = building_.links[v].prev;
      if (building_.links[into].valence == merged_away) into = building_.links[into].prev;
      v = into;
    }
    return v;
  }

  Traversal& traversal_;
  const Building& building_;
  CurveIndex curves_;
  WaitingCurves waiting_;
  std::uint32_t faces_;
  std::uint32_t index_;  ///< in the traversal, of the current symbol
  std::size_t next_start_, next_special_;
};

template <bool valences>
bool build_again(Traversal& traversal) {
  const std::uint32_t faces = static_cast<std::uint32_t>(traversal.contexts.size());
  std::size_t ids = 0;
  for (const std::uint8_t c : traversal.contexts) {
    const Clers symbol = static_cast<Clers>(c & 7);
    ids += symbol == Clers::E ? 3 : symbol == Clers::L || symbol == Clers::R;
  }

  const std::unique_ptr<std::uint32_t[]> corners(new std::uint32_t[3 * std::size_t(faces)]);
  const std::unique_ptr<FrontLink[]> links(new FrontLink[ids]);
  Building building;
  building.corners = {corners.get(), 3 * std::size_t(faces)};
  building.links = {links.get(), ids};
  NoPairing none;
  using Source = PlacingSource<valences>;
  Source source(traversal, building);
  return SpiraleReversi<NoPairing, Source>(building, none, source).run().broken ==
         StreamFault::none;
}

}  // namespace

bool place_handles(Traversal& traversal) {
  return build_again<false>(traversal);
}

bool place_handles_and_count_valences(Traversal& traversal) {
  return build_again<true>(traversal);
}

}  // namespace clers::internal
