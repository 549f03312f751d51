#include <algorithm>
#include <new>
#include <type_traits>

#include "codec/bytes.h"
#include "codec/connectivity.h"
#include "codec/event_model.h"
#include "codec/mixing_model.h"
#include "codec/prefix_code.h"
#include "codec/rans.h"
#include "codec/spirale_reversi.h"
#include "codec/symbol_model.h"
#include "topology/mirror.h"

namespace clers {
namespace {

static_assert(Traversal::max_valence == ContextTables::max_valence);

/// What is told besides a symbol, in the order of decoding.
struct Event {
  enum class Kind : std::uint8_t { new_component, closed, special, split, join };
  std::uint32_t symbol;  ///< comes after this one, counted in the order of decoding
  Kind kind;
  bool value = false;          ///< new_component, closed, special
  bool two_edges = false;      ///< new_component
  std::uint32_t curve = 0;     ///< split, join: number of the curve that is split off
  std::uint32_t distance = 0;  ///< split: edges back to the split; join: position on the curve
  std::uint32_t length = 0;    ///< split, join: edges of the curve walked on
  bool operator==(const Event&) const = default;
};

/// What a decoder will have to be told, and what it will know then.
struct Record {
  std::vector<std::uint8_t> contexts;  ///< valence << 3 | letter, in the order of decoding
  std::vector<Event> events;
  std::uint32_t curves = 0;             ///< that special S split off
  std::vector<std::uint32_t> vertices;  ///< vertices[new] = old
};

/// The record of a traversal without special S. Only what is asked at an E depends on the surface,
/// and only on the length of the curve there.
Record plain_record(Traversal& traversal) {
  Record record;
  record.contexts = std::move(traversal.contexts);
  record.vertices = std::move(traversal.vertices);
  std::vector<Event>& events = record.events;
  const std::uint32_t faces = static_cast<std::uint32_t>(record.contexts.size());
  std::size_t next_start = traversal.starts.size();
  std::vector<std::uint32_t> aside;  // lengths of the curves whose gates are put aside
  std::uint32_t length = 3;
  const auto end_component = [&](std::uint32_t symbol) {
    --next_start;
    if (length == 2)
      events.push_back({symbol, Event::Kind::closed, traversal.starts[next_start].closed});
  };
  for (std::uint32_t i = 1; i < faces; ++i) {
    switch (static_cast<Clers>(record.contexts[i] & 7)) {
      case Clers::C: --length; break;
      case Clers::R:
      case Clers::L: ++length; break;
      case Clers::S:
        events.push_back({i, Event::Kind::special, false});
        length += aside.back() - 1;
        aside.pop_back();
        break;
      case Clers::E: {
        bool ends = false;
        if (aside.empty()) {
          ends = traversal.starts[next_start - 1].index == faces - i;
          events.push_back({i, Event::Kind::new_component, ends, length == 2});
        }
        if (ends)
          end_component(i);
        else
          aside.push_back(length);
        length = 3;
        break;
      }
    }
  }
  end_component(faces - 1);
  return record;
}

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
    record.contexts.resize(faces_);
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
  template <class Front, class Gate, class Then>
  [[gnu::always_inline]] auto symbol(const Front&, const Gate& gate, std::size_t, Then then) {
    step(gate.kx);
    return with_letter(traversal_.letters[index_], then);
  }

  bool new_component(bool two_edges) {
    // Letters come last to first: a component ends where the one decoded before it started.
    const bool value = traversal_.starts[next_start_ - 1].index == index_ + 1;
    record.events.push_back({done(), Event::Kind::new_component, value, two_edges});
    return value;
  }
  bool closed() {
    const bool value = traversal_.starts[next_start_ - 1].closed;
    record.events.push_back({done(), Event::Kind::closed, value});
    return value;
  }
  void component_ended() {
    --next_start_;
    waiting_.clear();
  }

  bool special() {
    const bool value = is_special();
    record.events.push_back({done(), Event::Kind::special, value});
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
      record.events.push_back({done(), Event::Kind::join, false, false, curve, position_, 0});
      return SpecialS::join;
    }
    const std::uint32_t number = record.curves++;
    distance_ = 0;
    for (std::uint32_t v = gate.x; v != q || distance_ == 0;) {
      // Not there: the vertex was marked from another fan of its corners.
      if (v == gate.y) return SpecialS::hole;
      v = front.prev(v);
      curve_of_[v] = number;
      ++distance_;
    }
    waiting_.push_back(number);
    record.events.push_back({done(), Event::Kind::split, false, false, number, distance_, 0});
    return SpecialS::split;
  }
  /// Holes show at the component's end. Asked for one before, no length is right.
  std::uint64_t hole_length() { return 0; }
  std::uint64_t split_distance(std::uint64_t n) {
    record.events.back().length = static_cast<std::uint32_t>(n);
    return distance_;
  }
  std::uint32_t join_curve(std::uint32_t) { return recency_; }
  std::uint32_t join_position(std::uint32_t n) {
    record.events.back().length = n;
    return position_;
  }

  Record record;

 private:
  static constexpr std::uint32_t no_curve = 0xffffffffu;

  void step(std::uint32_t kx) {
    --index_;
    record.contexts[done()] =
        static_cast<std::uint8_t>(std::min(kx, Traversal::max_valence) << 3 |
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
  std::uint32_t recency_ = 0, position_ = 0, distance_ = 0;
};

/// log2(32768 / size) in 1/256 bits, for comparing models: a linear mantissa is near enough.
std::uint32_t cost(std::uint32_t size) {
  const unsigned exponent = static_cast<unsigned>(std::bit_width(size)) - 1;
  const std::uint32_t mantissa = (size << (15 - exponent)) - rans::scale;
  return (15 - exponent) * 256 - (mantissa >> 7);
}

/// The answers that a decoder will need, in the order in which it asks, told to a stream. A curve
/// that was split off and never joined is a hole.
class Answers {
  const Event& event() const { return events_[next_]; }

  template <class Code>
  auto count_special(std::size_t first, Code code) {
    const auto value = code();
    for (std::size_t k = first; k < out_.intervals().size(); ++k)
      special_cost += cost(out_.intervals()[k].size);
    return value;
  }

 public:
  static constexpr bool resolves = false;

  Answers(const std::vector<Event>& events, std::uint32_t curves, rans::Encoder& out)
      : events_(events), joined_(curves), coder_(out), out_(out) {
    for (const Event& e : events)
      if (e.kind == Event::Kind::join) joined_[e.curve] = true;
  }

  /// The next letter is about to be told.
  void letter_begins() { letter_ = out_.intervals().size(); }

  /// All that come after a symbol.
  void write_after(std::uint32_t symbol) {
    while (next_symbol() == symbol) {
      switch (event().kind) {
        case Event::Kind::new_component: new_component(event().two_edges); break;
        case Event::Kind::closed: closed(); break;
        case Event::Kind::special: special(); break;
        case Event::Kind::split:
        case Event::Kind::join:
          switch (kind()) {
            case SpecialS::hole: hole_length(); break;
            case SpecialS::split: split_distance(event().length); break;
            case SpecialS::join:
              join_curve(static_cast<std::uint32_t>(waiting_.size()));
              join_position(event().length);
              break;
          }
          break;
      }
    }
  }

  std::uint32_t next_symbol() const {
    return next_ < events_.size() ? event().symbol : 0xffffffffu;
  }

  bool new_component(bool two_edges) {
    return model_.new_component(coder_, two_edges, events_[next_++].value);
  }
  bool closed() {
    const bool value = model_.closed(coder_, events_[next_++].value);
    closed_components += value;
    return value;
  }
  void component_ended() {}
  bool special() { return model_.special(coder_, events_[next_++].value); }
  SpecialS kind() {
    return count_special(letter_, [&] {
      const SpecialS kind = event().kind == Event::Kind::join ? SpecialS::join
                            : joined_[event().curve]          ? SpecialS::split
                                                              : SpecialS::hole;
      return model_.kind(coder_, !waiting_.empty(), kind);
    });
  }
  std::uint64_t hole_length() {
    return count_special(out_.intervals().size(), [&] {
      const Event& e = events_[next_++];
      ++holes;
      steps += e.distance;
      return model_.hole_length(coder_, e.distance);
    });
  }
  std::uint64_t split_distance(std::uint64_t n) {
    return count_special(out_.intervals().size(), [&] {
      const Event& e = events_[next_++];
      waiting_.push_back(e.curve);
      steps += n + e.distance;
      return model_.split_distance(coder_, n, e.distance);
    });
  }
  std::uint32_t join_curve(std::uint32_t waiting) {
    return count_special(out_.intervals().size(), [&] {
      std::size_t w = waiting_.size() - 1;
      while (waiting_[w] != event().curve) --w;
      const std::size_t recency = waiting_.size() - 1 - w;
      waiting_.erase(waiting_.begin() + static_cast<std::ptrdiff_t>(w));
      return model_.join_curve(coder_, waiting, static_cast<std::uint32_t>(recency));
    });
  }
  std::uint32_t join_position(std::uint32_t n) {
    return count_special(out_.intervals().size(), [&] {
      const Event& e = events_[next_++];
      ++handles;
      steps += 2 * std::uint64_t(n);
      return model_.join_position(coder_, n, e.distance);
    });
  }

  std::uint64_t handles = 0, holes = 0, closed_components = 0;
  std::uint64_t steps = 0;         ///< that decoding takes along boundary curves
  std::uint64_t special_cost = 0;  ///< of holes and handles with their letters, in 1/256 bits

 private:
  const std::vector<Event>& events_;
  std::vector<bool> joined_;
  std::vector<std::uint32_t> waiting_;
  EncodeTo coder_;
  rans::Encoder& out_;
  EventModel model_;
  std::size_t next_ = 0;
  std::size_t letter_ = 0;  ///< where the last letter begins
};

/// Tells letters and answers while the surface is built once more, with all that the decoder will
/// know of it.
class TellingSource : public Answers {
 public:
  TellingSource(const Traversal& traversal, const Record& record, std::size_t ids,
                rans::Encoder& out)
      : Answers(record.events, record.curves, out),
        letters_(traversal.letters),
        left_(letters_.size()),
        coder_(out),
        model_(letters_.size(), ids) {}

  void first() { --left_; }
  template <class Front, class Gate, class Then>
  auto symbol(const Front& front, const Gate& gate, std::size_t aside, Then then) {
    letter_begins();
    const Clers letter = letters_[--left_];
    model_.code(coder_, front, gate, aside, letter);
    return with_letter(letter, then);
  }
  template <class Front, class Gate>
  SpecialS kind(const Front&, const Gate&, std::span<const std::uint32_t>) {
    return Answers::kind();
  }

 private:
  const std::vector<Clers>& letters_;
  std::size_t left_;
  EncodeTo coder_;
  MixingModel model_;
};

/// Letters to judge models by: a few runs from all over, or all of a short string.
struct Sample {
  std::vector<std::uint8_t> contexts;
  /// Letters of each run that are not counted: what a model has to learn matters less in the whole.
  std::size_t run, uncounted;

  explicit Sample(const std::vector<std::uint8_t>& all) {
    constexpr std::size_t runs = 8, least = 6144, most = 1u << 15;
    run = std::clamp(all.size() / 12, least, most) / runs;
    uncounted = run / 4;
    if (runs * run >= all.size()) {
      contexts = all;
      run = all.size();
      uncounted = 0;
      return;
    }
    contexts.reserve(runs * run);
    for (std::size_t r = 1; r <= runs; ++r) {
      const auto first =
          all.begin() + static_cast<std::ptrdiff_t>((all.size() - run) * r / (runs + 1));
      contexts.insert(contexts.end(), first, first + static_cast<std::ptrdiff_t>(run));
    }
  }

  /// What they cost, in 1/256 bits.
  template <class Model>
  std::uint64_t cost_with(Model model) const {
    if (!model.ok()) throw std::bad_alloc();
    std::uint64_t total = 0;
    for (std::size_t begin = 0; begin < contexts.size(); begin += run)
      for (std::size_t i = 0; i < run; ++i) {
        const std::uint8_t c = contexts[begin + i];
        const std::uint32_t size = model.encode(static_cast<Clers>(c & 7), c >> 3).size;
        if (i >= uncounted) total += cost(size);
      }
    return total;
  }
};

/// The model of a level that codes these letters in the fewest bits.
LetterModel choose_model(const std::vector<std::uint8_t>& contexts, int level) {
  using Kind = LetterModel::Kind;
  if (level < 3) return {Kind::code, 0};
  if (level >= 9) return {Kind::mixing, 0};
  const Kind kind = level < 5 ? Kind::single : Kind::pair;
  LetterModel best{kind, 3};
  if (contexts.size() < 64) return best;
  const Sample sample(contexts);
  std::uint64_t least = ~std::uint64_t(0);
  const auto judge = [&](LetterModel m) {
    const std::uint64_t total =
        m.kind == Kind::single ? sample.cost_with(SingleModel(m.history))
                               : sample.cost_with(PairModel(m.history, m.kind == Kind::quick_pair));
    if (total >= least) return;
    least = total;
    best = m;
  };
  // A longer history while it pays, else the shortest where there is little to learn from.
  judge({kind, 3});
  judge({kind, 5});
  if (best.history == 5)
    judge({kind == Kind::pair ? Kind::quick_pair : kind, 8});
  else if (kind == Kind::single && contexts.size() < (1u << 16))
    judge({kind, 1});
  return best;
}

/// What follows the header, and what it tells of.
struct Told {
  LetterModel model;
  Bytes bytes;
  std::uint64_t handles = 0, holes = 0, closed_components = 0, steps = 0, special_cost = 0;
};

/// Tells the letters and answers with a model.
Told tell(LetterModel model, const Traversal& traversal, const Record& record, std::size_t ids) {
  Told told;
  told.model = model;
  rans::Encoder stream;
  const auto finish = [&](const Answers& answers) {
    told.handles = answers.handles;
    told.holes = answers.holes;
    told.closed_components = answers.closed_components;
    told.steps = answers.steps;
    told.special_cost = answers.special_cost;
    stream.finish(told.bytes);
  };
  const std::size_t faces = record.contexts.size();
  if (model.kind == LetterModel::Kind::mixing) {
    std::vector<std::uint32_t> corners(3 * faces);
    std::vector<FrontLink> links(ids);
    Building building;
    building.corners = corners;
    building.links = links;
    NoPairing none;
    TellingSource source(traversal, record, ids, stream);
    const Breakage breakage =
        SpiraleReversi<NoPairing, TellingSource>(building, none, source).run();
    finish(source);
    // It took more steps than a decoder may.
    if (breakage.broken != Broken::none) told.steps = ~std::uint64_t(0);
    return told;
  }
  Answers answers(record.events, record.curves, stream);
  // put(letter, valence) for each, and the answers where they are asked for.
  const auto tell_all = [&](auto put) {
    std::uint32_t next = answers.next_symbol();
    for (std::uint32_t i = 0; i < faces; ++i) {
      if (i == next) answers.letter_begins();
      if (i > 0) put(static_cast<Clers>(record.contexts[i] & 7), record.contexts[i] >> 3);
      if (i == next) {
        answers.write_after(i);
        next = answers.next_symbol();
      }
    }
  };
  const auto tell_with = [&](auto letters) {
    if (!letters.ok()) throw std::bad_alloc();
    stream.reserve(faces + 4 * record.events.size());
    tell_all([&](Clers letter, std::uint32_t kx) { stream.put(letters.encode(letter, kx)); });
  };
  switch (model.kind) {
    case LetterModel::Kind::single: tell_with(SingleModel(model.history)); break;
    case LetterModel::Kind::code: {
      Bytes code;
      LetterWriter letters(code);
      tell_all([&](Clers letter, std::uint32_t) { letters.put(letter); });
      letters.finish();
      put_varint(told.bytes, code.size());
      put_bytes(told.bytes, code);
      break;
    }
    default:
      tell_with(PairModel(model.history, model.kind == LetterModel::Kind::quick_pair));
      break;
  }
  finish(answers);
  if (model.kind == LetterModel::Kind::code)  // the letters S, 4 bits each
    told.special_cost += 4 * 256 * (told.holes + 2 * told.handles);
  return told;
}

void put_header(Bytes& out, std::uint32_t faces, std::uint32_t vertices, std::uint32_t merges,
                LetterModel model) {
  put_varint(out, faces);
  put_signed_varint(out, 2 * std::int64_t(vertices) - faces - 4);
  std::uint32_t room = 0;
  while (room_for_merges(room) < merges) ++room;
  put_u8(out, room);
  put_u8(out, model.byte());
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

bool agree(const Record& a, const Record& b) {
  return a.contexts == b.contexts && a.events == b.events && a.vertices == b.vertices;
}

/// The record of any traversal, by building the surface again. Errors: nonmanifold_vertex.
template <class Pairing>
Expected<Record> built_record(std::span<const std::uint32_t> org, std::uint32_t vertex_count,
                              const Traversal& traversal, std::size_t ids, Pairing& pairing) {
  const std::uint32_t faces = static_cast<std::uint32_t>(traversal.letters.size());
  std::vector<std::uint32_t> corners(3 * std::size_t(faces));
  std::vector<FrontLink> links(ids);
  Building building;
  building.corners = corners;
  building.links = links;
  RecordingSource source(traversal, building);
  const Breakage breakage =
      SpiraleReversi<Pairing, RecordingSource>(building, pairing, source).run();
  if (breakage.broken != Broken::none) return several_fans();

  resolve_merges(building);
  std::vector<std::uint32_t>& vertices = source.record.vertices;
  vertices.resize(building.finished);
  std::uint32_t id = 0;
  const auto number = [&](HalfEdge corner) {
    vertices[building.finished - 1 - links[id++].prev] = org[corner.index()];
  };
  for (std::uint32_t i = faces; i-- > 0;) {  // vertices as they were made: by E, L and R
    const HalfEdge gate = traversal.gates[i];
    const Clers letter = traversal.letters[i];
    if (letter == Clers::E || letter == Clers::L) number(gate);
    if (letter == Clers::E || letter == Clers::R) number(lnext(gate));
    if (letter == Clers::E) number(lprev(gate));
  }
  std::vector<bool> numbered(vertex_count);
  for (const std::uint32_t v : vertices) {
    if (numbered[v]) return several_fans();
    numbered[v] = true;
  }
  return std::move(source.record);
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
  const bool valences = on_full_surface || level >= 3;
  Traversal traversal = valences ? Edgebreaker<Witness, true>(surface, witness).run()
                                 : Edgebreaker<Witness, false>(surface, witness).run();
  if (traversal.several_fans) return several_fans();

  std::size_t ids = 0, merges = 0;
  for (const Clers letter : traversal.letters) {
    ++result.counts.letters[static_cast<unsigned>(letter)];
    static constexpr std::uint8_t made[] = {0, 1, 1, 0, 3};
    ids += made[static_cast<unsigned>(letter)];
    merges += letter == Clers::S;
  }
  const bool plain = traversal.specials.empty();
  Record record;
  if (plain) record = plain_record(traversal);
  if (!plain || on_full_surface) {
    Pairing pairing = make_pairing<Pairing>(ids);
    auto built = built_record(surface.org, surface.vertex_count, traversal, ids, pairing);
    if (!built) return Failure{built.error()};
    if constexpr (on_full_surface) {
      if (!agree(witness, pairing) || (plain && !agree(record, *built)))
        return fail(ErrorCode::internal, "the fast operators and the full surface do not agree");
      if (trace) *trace = std::move(witness.trace);
    }
    record = std::move(*built);
  }

  const LetterModel chosen = choose_model(record.contexts, level);
  Told told = tell(chosen, traversal, record, ids);
  // The most thorough model does not pay for the smallest meshes.
  if (chosen.kind == LetterModel::Kind::mixing) {
    Told other = tell(choose_model(record.contexts, level - 1), traversal, record, ids);
    if (other.bytes.size() < told.bytes.size()) told = std::move(other);
  }
  if (told.steps > allowed_steps(faces))
    return fail(
        ErrorCode::limit,
        "the handles of this mesh are so long that decoding would take more than the format's "
        "1024 steps a face");
  put_header(result.bytes, faces, static_cast<std::uint32_t>(record.vertices.size()),
             static_cast<std::uint32_t>(merges), told.model);
  put_bytes(result.bytes, told.bytes);
  result.special_cost = told.special_cost;
  result.counts.components = traversal.starts.size();
  result.counts.handles = told.handles;
  result.counts.coded_holes = told.holes;
  result.counts.boundary_curves = told.holes + traversal.starts.size() - told.closed_components;

  result.vertices = std::move(record.vertices);
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
