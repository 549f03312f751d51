#include <algorithm>
#include <new>
#include <type_traits>

#include "codec/bytes.h"
#include "codec/connectivity.h"
#include "codec/event_model.h"
#include "codec/rans.h"
#include "codec/spirale_reversi.h"
#include "codec/symbol_model.h"
#include "topology/mirror.h"

namespace clers {
namespace {

/// What is told besides a symbol, in the order of decoding.
struct Event {
  enum class Kind : std::uint8_t { new_component, closed, special, split, join };
  std::uint32_t symbol;  ///< comes after this one, counted in the order of decoding
  Kind kind;
  bool value = false;          ///< new_component, closed, special
  std::uint32_t curve = 0;     ///< split, join: number of the curve that is split off
  std::uint32_t distance = 0;  ///< split: edges back to the split; join: position on the curve
  std::uint32_t length = 0;    ///< split, join: edges of the curve walked on
};

/// Answers the driver's questions from a traversal, and writes down what a decoder will have to be
/// told in which context.
class RecordingSource {
 public:
  static constexpr bool resolves = true;

  RecordingSource(const Traversal& traversal, const Building& building)
      : traversal_(traversal),
        building_(building),
        faces_(static_cast<std::uint32_t>(traversal.gates.size())),
        index_(faces_) {
    contexts.resize(faces_);
    next_start_ = traversal.starts.size();
    next_special_ = traversal.specials.size();
    if (!traversal.specials.empty()) {
      index_of_face_.resize(faces_);
      for (std::uint32_t i = 0; i < faces_; ++i)
        index_of_face_[left(traversal.gates[i]).index()] = i;
      curve_of_.resize(building.links.size(), no_curve);
    }
  }

  void first() { step(0); }
  template <class Then>
  [[gnu::always_inline]] auto symbol(std::uint32_t kx, Then then) {
    step(kx);
    switch (traversal_.letters[index_]) {
      case Clers::C: return then(Letter<Clers::C>());
      case Clers::R: return then(Letter<Clers::R>());
      case Clers::L: return then(Letter<Clers::L>());
      case Clers::S: return then(Letter<Clers::S>());
      default: return then(Letter<Clers::E>());
    }
  }
  bool overrun() const { return false; }

  bool new_component() {
    // Letters come last to first: a component ends where the one decoded before it started.
    const bool value = traversal_.starts[next_start_ - 1].index == index_ + 1;
    events.push_back({done(), Event::Kind::new_component, value});
    return value;
  }
  bool closed() {
    const bool value = traversal_.starts[next_start_ - 1].closed;
    events.push_back({done(), Event::Kind::closed, value});
    return value;
  }
  void component_ended() {
    --next_start_;
    waiting_.clear();
  }

  bool special() {
    const bool value = is_special();
    events.push_back({done(), Event::Kind::special, value});
    return value;
  }

  /// Finds the edge that the S glues to: on the gate's own curve, or on one split off before.
  template <class Front, class Gate>
  SpecialS kind(const Front& front, const Gate& gate, std::span<const std::uint32_t> waiting) {
    const Traversal::Special s = traversal_.specials[--next_special_];
    const FrontLink* links = building_.links.data();
    const std::uint32_t q = vertex_at(s.left);
    const std::uint32_t curve = curve_of_[q];
    for (std::size_t w = waiting_.size(); w-- > 0;) {
      if (waiting_[w] != curve) continue;
      recency_ = static_cast<std::uint32_t>(waiting_.size() - 1 - w);
      waiting_.erase(waiting_.begin() + static_cast<std::ptrdiff_t>(w));
      position_ = 0;
      for (std::uint32_t v = waiting[w]; v != q; v = links[v].prev) ++position_;
      events.push_back({done(), Event::Kind::join, false, curve, position_, 0});
      return SpecialS::join;
    }
    const std::uint32_t number = curves_++;
    distance_ = 0;
    for (std::uint32_t v = gate.x; v != q || distance_ == 0;) {
      // Not there: the vertex was marked from another fan of its corners.
      if (v == gate.y) return SpecialS::hole;
      v = front.prev(v);
      curve_of_[v] = number;
      ++distance_;
    }
    waiting_.push_back(number);
    events.push_back({done(), Event::Kind::split, false, number, distance_, 0});
    return SpecialS::split;
  }
  /// Holes show at the component's end. Asked for one before, no length is right.
  std::uint64_t hole_length() { return 0; }
  std::uint64_t split_distance(std::uint64_t n) {
    events.back().length = static_cast<std::uint32_t>(n);
    return distance_;
  }
  std::uint32_t join_curve(std::uint32_t) { return recency_; }
  std::uint32_t join_position(std::uint32_t n) {
    events.back().length = n;
    return position_;
  }

  std::vector<std::uint8_t> contexts;  ///< valence << 3 | letter, in the order of decoding
  std::vector<Event> events;
  std::uint32_t curves() const { return curves_; }

 private:
  static constexpr std::uint32_t no_curve = 0xffffffffu;

  void step(std::uint32_t kx) {
    --index_;
    contexts[done()] = static_cast<std::uint8_t>(std::min(kx, SymbolModel::max_valence) << 3 |
                                                 static_cast<unsigned>(traversal_.letters[index_]));
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
  std::uint32_t index_;  ///< in the traversal, of the current letter
  std::size_t next_start_, next_special_;
  std::vector<std::uint32_t> index_of_face_;
  std::vector<std::uint32_t> curve_of_;  ///< last curve that a vertex was split off with
  std::vector<std::uint32_t>
      waiting_;  ///< numbers of the curves that are split off, as in the driver
  std::uint32_t curves_ = 0;
  std::uint32_t recency_ = 0, position_ = 0, distance_ = 0;
};

/// Tells events to a stream. A curve that was split off and never joined is a hole.
class EventWriter {
 public:
  EventWriter(const std::vector<Event>& events, std::uint32_t curves)
      : events_(events), joined_(curves) {
    for (const Event& e : events)
      if (e.kind == Event::Kind::join) joined_[e.curve] = true;
  }

  template <class Coder>
  void write_after(std::uint32_t symbol, Coder& coder) {
    for (; next_ < events_.size() && events_[next_].symbol == symbol; ++next_)
      write(events_[next_], coder);
  }

  std::uint32_t next_symbol() const {
    return next_ < events_.size() ? events_[next_].symbol : 0xffffffffu;
  }
  std::uint64_t handles = 0, splits = 0, holes = 0, closed = 0, steps = 0;

 private:
  template <class Coder>
  void write(const Event& e, Coder& coder) {
    switch (e.kind) {
      case Event::Kind::new_component: model_.new_component(coder, e.value); break;
      case Event::Kind::closed:
        model_.closed(coder, e.value);
        closed += e.value;
        break;
      case Event::Kind::special: model_.special(coder, e.value); break;
      case Event::Kind::split: {
        const SpecialS kind = joined_[e.curve] ? SpecialS::split : SpecialS::hole;
        model_.kind(coder, !waiting_.empty(), kind);
        steps += e.distance;
        if (kind == SpecialS::hole) {
          model_.hole_length(coder, e.distance);
          ++holes;
        } else {
          model_.split_distance(coder, e.length, e.distance);
          waiting_.push_back(e.curve);
          steps += e.length;
          ++splits;
        }
        break;
      }
      case Event::Kind::join: {
        model_.kind(coder, true, SpecialS::join);
        std::size_t w = waiting_.size() - 1;
        while (waiting_[w] != e.curve) --w;
        model_.join_curve(coder, static_cast<std::uint32_t>(waiting_.size()),
                          static_cast<std::uint32_t>(waiting_.size() - 1 - w));
        waiting_.erase(waiting_.begin() + static_cast<std::ptrdiff_t>(w));
        model_.join_position(coder, e.length, e.distance);
        steps += 2 * std::uint64_t(e.length);
        ++handles;
        break;
      }
    }
  }

  const std::vector<Event>& events_;
  std::vector<bool> joined_;
  std::vector<std::uint32_t> waiting_;
  EventModel model_;
  std::size_t next_ = 0;
};

/// log2(32768 / size) in 1/256 bits, for comparing models: a linear mantissa is near enough.
std::uint32_t cost(std::uint32_t size) {
  const unsigned exponent = static_cast<unsigned>(std::bit_width(size)) - 1;
  const std::uint32_t mantissa = (size << (15 - exponent)) - rans::scale;
  return (15 - exponent) * 256 - (mantissa >> 7);
}

/// The history length that codes these symbols in the fewest bits, judged by a part of them at the
/// front: the first quarter of that part is for learning when there is more behind it.
unsigned choose_history(std::span<const std::uint8_t> contexts, int level) {
  struct Candidate {
    unsigned history;
    std::size_t least_symbols;  ///< fewer do not pay for clearing its table
  };
  constexpr Candidate candidates[] = {{1, 0}, {3, 64}, {4, 1024}, {6, 1024}, {8, 1024}};
  if (level < 3) return 3;
  const std::size_t end =
      std::min(contexts.size(), std::clamp<std::size_t>(contexts.size() / 4, 1u << 14, 1u << 16));
  const std::size_t begin = end < contexts.size() ? end / 4 : 1;
  unsigned best = 1;
  std::uint64_t least = ~std::uint64_t(0);
  for (const auto [history, least_symbols] : candidates) {
    if (contexts.size() < least_symbols) break;
    SymbolModel model(history);
    if (!model.ok()) throw std::bad_alloc();
    std::uint64_t total = 0;
    for (std::size_t i = 1; i < end; ++i) {
      const rans::Interval interval =
          model.encode(static_cast<Clers>(contexts[i] & 7), contexts[i] >> 3);
      if (i >= begin) total += cost(interval.size);
    }
    if (total < least) {
      least = total;
      best = history;
    }
  }
  return best;
}

/// What comes of a vertex of several fans: a surface has a vertex for each.
Failure<Error> several_fans() {
  return fail(ErrorCode::nonmanifold_vertex, "the faces of a vertex form more than one fan");
}

template <class Witness>
Witness make_witness(const SurfaceArrays& arrays) {
  if constexpr (std::is_same_v<Witness, NoWitness>) {
    return {};
  } else {
    std::vector<Vertex> org(arrays.org.size());
    for (std::size_t h = 0; h < org.size(); ++h) org[h] = Vertex(arrays.org[h]);
    auto surface = Surface::from_twins(org, arrays.twins, arrays.vertex_count);
    return Witness(surface ? std::move(*surface) : Surface());
  }
}

template <class Pairing>
Pairing make_pairing(std::size_t vertex_ids) {
  if constexpr (std::is_same_v<Pairing, NoPairing>)
    return {};
  else
    return Pairing(vertex_ids);
}

/// What was unbuilt is gone now, and was built again by the same operators in opposite order.
bool agree(const UnbuildingMirror& unbuilt, const BuildingMirror& built) {
  return unbuilt.agrees && built.agrees && unbuilt.surface.characteristic() == Characteristic{} &&
         std::equal(unbuilt.trace.begin(), unbuilt.trace.end(), built.trace.rbegin(),
                    built.trace.rend());
}

template <bool on_full_surface>
Expected<EncodedConnectivity> encode(SurfaceArrays surface, int level, OperatorTrace* trace) {
  EncodedConnectivity result;
  const std::uint32_t faces = static_cast<std::uint32_t>(surface.twins.size() / 3);
  if (faces == 0) {
    put_varint(result.bytes, 0);
    return result;
  }
  using Witness = std::conditional_t<on_full_surface, UnbuildingMirror, NoWitness>;
  using Pairing = std::conditional_t<on_full_surface, BuildingMirror, NoPairing>;
  Witness witness = make_witness<Witness>(surface);
  Traversal traversal = Edgebreaker<Witness>(surface, witness).run();

  std::size_t ids = 0, merges = 0;
  for (const Clers letter : traversal.letters) {
    ++result.counts.letters[static_cast<unsigned>(letter)];
    static constexpr std::uint8_t made[] = {0, 1, 1, 0, 3};
    ids += made[static_cast<unsigned>(letter)];
    merges += letter == Clers::S;
  }
  std::vector<std::uint32_t> corners(3 * std::size_t(faces));
  std::vector<FrontLink> links(ids);
  Building building;
  building.corners = corners;
  building.links = links;
  RecordingSource source(traversal, building);
  Pairing pairing = make_pairing<Pairing>(ids);
  const Breakage breakage =
      SpiraleReversi<Pairing, RecordingSource>(building, pairing, source).run();
  if (breakage.broken != Broken::none) return several_fans();
  if constexpr (on_full_surface) {
    if (!agree(witness, pairing))
      return fail(ErrorCode::internal, "the fast operators and the full surface do not agree");
    if (trace) *trace = std::move(witness.trace);
  }
  number_vertices(building);

  const unsigned history = choose_history(source.contexts, level);
  SymbolModel model(history);
  if (!model.ok()) throw std::bad_alloc();
  rans::Encoder stream;
  stream.reserve(faces + 4 * source.events.size());
  EncodeTo coder(stream);
  EventWriter events(source.events, source.curves());
  for (std::uint32_t i = 0; i < faces; ++i) {
    if (i > 0) {
      const std::uint8_t c = source.contexts[i];
      const rans::Interval interval = model.encode(static_cast<Clers>(c & 7), c >> 3);
      stream.put(interval);
    }
    if (events.next_symbol() == i) {
      const std::size_t first = stream.intervals().size();
      const std::uint64_t specials = events.handles + events.holes + events.splits;
      events.write_after(i, coder);
      const bool special = specials < events.handles + events.holes + events.splits;
      for (std::size_t k = first - special; k < stream.intervals().size(); ++k)
        result.special_cost += cost(stream.intervals()[k].size);
    }
  }
  if (events.steps > allowed_steps(faces))
    return fail(
        ErrorCode::limit,
        "the handles of this mesh are so long that decoding would take more than the format's "
        "1024 steps a face");

  put_varint(result.bytes, faces);
  put_varint(result.bytes, building.finished);
  put_varint(result.bytes, merges);
  put_u8(result.bytes, history);
  stream.finish(result.bytes);

  result.counts.components = traversal.starts.size();
  result.counts.handles = events.handles;
  result.counts.coded_holes = events.holes;
  result.counts.boundary_curves = events.holes + traversal.starts.size() - events.closed;
  result.vertices.resize(building.finished);
  for (std::uint32_t i = 0; i < faces; ++i) {
    HalfEdge h = traversal.gates[i];
    for (unsigned side = 0; side < 3; ++side, h = lnext(h))
      result.vertices[corners[3 * std::size_t(i) + side]] = surface.org[h.index()];
  }
  std::vector<bool> numbered(surface.vertex_count);
  for (const std::uint32_t v : result.vertices) {
    if (numbered[v]) return several_fans();
    numbered[v] = true;
  }
  result.gates = std::move(traversal.gates);
  return result;
}

#ifdef CLERS_BOOKKEEPING
constexpr bool bookkeeping = true;
#else
constexpr bool bookkeeping = false;
#endif

}  // namespace

Expected<EncodedConnectivity> encode_connectivity(SurfaceArrays surface, int level) try {
  return encode<bookkeeping>(surface, level, nullptr);
} catch (const std::bad_alloc&) {
  return fail(ErrorCode::out_of_memory, "not enough memory for the connectivity");
}

Expected<EncodedConnectivity> encode_connectivity_on_surface(SurfaceArrays surface, int level,
                                                             OperatorTrace& trace) try {
  return encode<true>(surface, level, &trace);
} catch (const std::bad_alloc&) {
  return fail(ErrorCode::out_of_memory, "not enough memory for the connectivity");
}

}  // namespace clers
