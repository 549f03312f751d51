// Contexts, their counts and matches, and how they are mixed: in the order of codec/format.md.
#include "codec/symbols/mixing_model.h"

#include <algorithm>
#include <bit>

#include "codec/base/portable.h"
#include "codec/entropy/logistic.h"
#include "codec/symbols/mixing_weights.h"

namespace clers::internal {
namespace {

constexpr unsigned most_asked = 1000;  ///< a counter's least rate is 1 / (this + 1.4)

/// 65536 / (n + 1.4); at first 1 / (n + 1.1): what happened once will most likely happen again.
constexpr auto counter_rates = [] {
  std::array<std::uint16_t, most_asked + 1> r = {};
  for (unsigned n = 0; n <= most_asked; ++n)
    r[n] = static_cast<std::uint16_t>(655360 / (10 * n + (n < 2 ? 11 : 14)));
  return r;
}();

/// In 1/256: how far a counter is trusted that was asked n times, about .35 + .2 log2 n.
constexpr auto trust = [] {
  std::array<std::uint16_t, most_asked + 1> r = {0, 90, 141, 169, 192, 207, 220, 230, 243, 249};
  for (unsigned n = 10; n <= most_asked; ++n) r[n] = 256;
  return r;
}();

constexpr std::uint32_t unasked = 1u << 31;

void count(std::uint32_t& counter, bool yes, unsigned most) {
  const unsigned n = counter & 1023;
  const std::int32_t p = static_cast<std::int32_t>(counter >> 10);
  const std::int32_t target = yes ? (1 << 22) - 1 : 0;
  const std::int32_t step =
      static_cast<std::int32_t>((std::int64_t(target - p) * counter_rates[n]) >> 16);
  counter = static_cast<std::uint32_t>(p + step) << 10 | std::min(n + 1, most);
}

/// Rates of learning, .007 and .001, in units of 2^-31.
constexpr std::uint32_t first_rate = 15032386, final_rate = 2147484;

/// Hash of a few numbers, the first of which says what for.
template <class... Values>
constexpr std::uint32_t hash(std::uint32_t what, Values... values) {
  std::uint32_t h = (what + 1) * 0x9e3779b1u;
  ((h = (std::rotl(h, 13) ^ static_cast<std::uint32_t>(values)) * 0x2c1b3c6du), ...);
  return h;
}

constexpr unsigned rows[] = {64, 216, 96, 24, 21};  // of the sets of weights
constexpr unsigned curve_contexts[] = {512, 1024, 1024, 96};

/// n times the same, n at least 1, by doubling: for a small mesh such tables are most of the work.
template <class T, std::size_t size>
std::vector<T> copies(const std::array<T, size>& first, std::size_t n) {
  std::vector<T> all(size * n);
  std::copy(first.begin(), first.end(), all.begin());
  for (std::size_t done = size; done < all.size(); done *= 2)
    std::copy_n(all.data(), std::min(done, all.size() - done), all.data() + done);
  return all;
}

}  // namespace

/// Valences are at most 15, degrees at most 31; an unknown degree is 0.
struct MixingModel::Local {
  unsigned kx, ky;                  ///< of the gate
  unsigned kp, kpp, kp3, kp4;       ///< of the four vertices before x
  unsigned kyn, kyn2;               ///< of the two vertices after y
  unsigned ring;                    ///< edges of the curve less 2, at most 5
  unsigned t_gate, t_prev, t_next;  ///< degrees of the tips behind the gate, the edge before it and
                                    ///< the one after it
  unsigned t_prev2, t_next2, t_prev3;  ///< and behind the edges further along
  std::array<int, 3> excess;           ///< of the closed neighbours of x, prev(x), y: sum of degree
                                       ///< - 6, at most 20 either way
  std::array<std::uint32_t, 3> fan;    ///< hashes of the degrees of their inner neighbours
  std::array<unsigned, 3> level;       ///< excess + 3, 0 .. 6
  int recent_excess;                   ///< of the eight vertices closed last, at most 15 either way
};

MixingModel::MixingModel(std::size_t faces, std::size_t ids)
    : around_(ids),
      table_bits_(table_bits(faces)),
      slots_(std::size_t(contexts) << table_bits_, Slot{unasked, unasked, unasked, unasked}),
      final_weights_(rows[0] * decisions * sets, 65536 / sets) {
  history_.reserve(faces + 1);
  history_.push_back(static_cast<std::uint8_t>(Clers::E));
  std::array<std::int32_t, std::size_t{decisions} * inputs> first_row;
  for (std::size_t k = 0; k < first_row.size(); ++k)
    first_row[k] = first_weights[k / inputs][k % inputs] * (mixer::one / 4096);
  for (unsigned s = 0; s < sets; ++s) {
    rates_[s].resize(rows[s] * decisions, first_rate);
    weights_[s] = copies(first_row, rows[s]);
  }
  std::array<std::uint16_t, 33> first_curve;
  for (std::size_t i = 0; i < first_curve.size(); ++i)
    first_curve[i] = static_cast<std::uint16_t>(logistic.squash((int(i) - 16) * 128));
  for (unsigned c = 0; c < curves; ++c)
    curve_[c] = copies(first_curve, std::size_t(curve_contexts[c]) * decisions);
  for (unsigned m = 0; m < matches; ++m) {
    places_[m].resize(std::size_t(1) << table_bits_);
    confidence_[m].resize(64 * 2 * decisions);
    for (std::uint32_t row = 0; row < 64; ++row) {
      const std::uint32_t length = m < 2 ? row % 16 : std::min(row, 15u);
      const bool missed = m < 2 && row >= 16;
      constexpr std::uint32_t one = 1u << 22;
      const std::uint32_t hit = missed ? one / 10 * 7 : one / (2 * length + 6) * (2 * length + 5);
      for (std::size_t d = 0; d < decisions; ++d) {
        confidence_[m][(row * 2) * decisions + d] = (one - hit) / 2 << 10 | 4;
        confidence_[m][(row * 2 + 1) * decisions + d] = hit << 10 | 4;
      }
    }
  }
}

/// Brings the record of the surface up to the gate of the next symbol.
void MixingModel::follow(const FrontLink* links, GateView gate) {
  const std::uint32_t x = gate_.x, y = gate_.y;
  switch (static_cast<Clers>(history_.back())) {
    case Clers::C:
      around_.zip(x, y, gate_.kx, gate.x);
      std::copy_backward(excess_.begin(), excess_.end() - 1, excess_.end());
      excess_[0] = static_cast<int>(std::min(gate_.kx, 29u)) - 5;
      break;
    case Clers::R: around_.attach(x, y, gate.y); break;
    case Clers::L: around_.attach(x, y, gate.x); break;
    case Clers::S: {
      const std::uint32_t q = links[x].prev;
      around_.glue(x, y, gate.x, q, links[q].prev);
      break;
    }
    case Clers::E: around_.create(gate.x); break;
  }
  gate_ = gate;
}

void MixingModel::look(const FrontLink* links, GateView gate, std::size_t pending) {
  follow(links, gate);
  const Local l = local(links);
  two_edges_ = l.ring == 0;
  find_contexts(l, pending);
  set_numbers(l);
  find_matches(l);
  select(l, pending);
}

MixingModel::Local MixingModel::local(const FrontLink* links) const {
  const std::uint32_t x = gate_.x, y = gate_.y;
  // The links of the gate's own ends are stale.
  const auto before = [&](std::uint32_t v) { return v == y ? x : links[v].prev; };
  const auto valence = [&](std::uint32_t v) {
    return std::min(v == x ? gate_.kx : v == y ? gate_.ky : links[v].valence, 15u);
  };
  const auto first_tip = [&](std::uint32_t v) {  // behind the boundary edge that leaves v
    const auto& fan = around_.fan(v);
    return fan.size() ? std::min(around_.degree(fan[0]), 31u) : 0;
  };
  const auto last_tip = [&](std::uint32_t v) {  // behind the one that enters it
    const auto& fan = around_.fan(v);
    return fan.size() ? std::min(around_.degree(fan[fan.size() - 1]), 31u) : 0;
  };
  const std::uint32_t p = before(x), pp = before(p), p3 = before(pp), p4 = before(p3);
  const std::uint32_t yn = around_.next(y), yn2 = around_.next(yn);
  Local l;
  l.kx = valence(x), l.ky = valence(y);
  l.kp = valence(p), l.kpp = valence(pp), l.kp3 = valence(p3), l.kp4 = valence(p4);
  l.kyn = valence(yn), l.kyn2 = valence(yn2);
  l.ring = p == y ? 0 : pp == y ? 1 : p3 == y ? 2 : p4 == y ? 3 : yn2 == p4 ? 4 : 5;
  l.t_gate = first_tip(x), l.t_prev = last_tip(x), l.t_next = first_tip(y);
  l.t_prev2 = last_tip(p), l.t_next2 = first_tip(yn), l.t_prev3 = last_tip(pp);
  const std::uint32_t of[3] = {x, p, y};
  for (unsigned i = 0; i < 3; ++i) {
    const auto& fan = around_.fan(of[i]);
    int excess = 0;
    std::uint32_t h = hash(77);
    for (unsigned k = 0; k < fan.size(); ++k) {
      const unsigned d = around_.degree(fan[k]);
      if (d != 0) excess += static_cast<int>(d) - 6;
      h = (std::rotl(h, 13) ^ d) * 0x2c1b3c6du;
    }
    l.fan[i] = h;
    l.excess[i] = std::clamp(excess, -20, 20);
    l.level[i] = static_cast<unsigned>(std::clamp(excess, -3, 3) + 3);
  }
  int recent = 0;
  for (const int e : excess_) recent += e;
  l.recent_excess = std::clamp(recent, -15, 15);
  return l;
}

void MixingModel::find_contexts(const Local& l, std::size_t pending) {
  const unsigned s1 = last(1), s12 = last(2);  // the symbol before, with the one before that
  const auto closed = [&](unsigned i) { return static_cast<unsigned>(excess_[i] + 6); };
  const unsigned stack = static_cast<unsigned>(std::min<std::size_t>(pending, 3));
  const unsigned kx = l.kx;
  const std::uint32_t hashes[] = {
      hash(0, kx),
      hash(1, kx | s1 << 4),
      hash(2, kx | s1 << 4 | l.t_gate << 6 | l.level[0] << 11),
      hash(3, kx | closed(0) << 4 | closed(1) << 10),
      hash(4, kx | l.ring << 4 | s1 << 7 | stack << 9),
      hash(5, kx | l.level[0] << 4 | l.level[1] << 7 | l.level[2] << 10),
      hash(6, l.fan[0], l.fan[1], kx | l.kp << 4 | s1 << 8),
      hash(7, last(10), kx),
      hash(8, last(8), kx),
      hash(9, last(6)),
      hash(10, last(12)),
      hash(11, last(15)),
      hash(12, last(5), kx | l.kp << 4 | l.ky << 8),
      hash(13, kx | l.kp << 4 | l.kpp << 8 | s1 << 12 | l.t_gate << 16 | l.t_prev << 21,
           l.level[0] | l.level[1] << 3),
      hash(14, l.fan[0], kx | s1 << 4),
      hash(15, l.fan[0], l.fan[1], l.fan[2], kx | l.kp << 4 | l.ky << 8 | s1 << 12),
      hash(16, kx | l.kp << 4 | l.kpp << 8 | l.kp3 << 12 | l.kp4 << 16 | s12 << 20),
      hash(17, kx | l.ky << 4 | l.kyn << 8 | l.kyn2 << 12 | s12 << 16),
      hash(18, kx | s1 << 4 | static_cast<unsigned>(l.recent_excess + 16) << 6),
      hash(19, kx | l.kp << 4 | l.kpp << 8 | l.ky << 12 | l.kyn << 16 | l.level[0] << 20,
           l.t_gate | l.t_prev << 5 | l.t_next << 10),
  };
  static_assert(std::size(hashes) == contexts);
  for (unsigned c = 0; c < contexts; ++c) {
    slot_[c] = &slots_[(std::size_t(c) << table_bits_) + (hashes[c] >> (32 - table_bits_))];
    fetch_for_writing(slot_[c]);
  }
}

/// Degrees and valences as inputs themselves: the mixer then is a logistic regression on them.
void MixingModel::set_numbers(const Local& l) {
  std::int16_t* in = input_.data() + contexts;
  const auto put = [&](int v) { *in++ = static_cast<std::int16_t>(3 * std::clamp(v, -384, 384)); };
  const auto degree = [](unsigned d) { return d != 0 ? 128 * (static_cast<int>(d) - 6) : 0; };
  for (const int e : l.excess) put(64 * e);
  for (const unsigned k : {l.kp, l.kpp, l.kp3, l.ky, l.kyn, l.kyn2})
    put(102 * (static_cast<int>(k) - 3));
  for (const unsigned d : {l.t_gate, l.t_prev, l.t_next, l.t_prev2, l.t_next2, l.t_prev3})
    put(degree(d));
  for (unsigned i = 0; i < 3; ++i) put(128 * excess_[i]);
  put(51 * l.recent_excess);
  put(26 * (static_cast<int>(l.kp) - 4) * l.excess[0]);
  put(13 * l.excess[0] * l.excess[0] - 128);
  const unsigned s2 = last(2) >> 2, s3 = last(3) >> 4;
  put(s2 == 0 ? 179 : -179);
  put(s3 == 0 ? 179 : -179);
  put(s2 == 1 ? 179 : -179);
}

void MixingModel::find_matches(const Local& l) {
  const std::uint32_t now = static_cast<std::uint32_t>(history_.size());
  const std::uint32_t around =
      hash(92, l.fan[0], l.fan[1], l.fan[2],
           l.kp | l.kpp << 4 | l.ky << 8 | l.kyn << 12 | last(1) << 16 | l.kx << 20);
  const std::uint32_t hashes[matches] = {
      hash(90, last(16)), hash(91, recent_ & 0xffffffff, recent_ >> 32), around,
      hash(93, around, l.kp3 | l.kp4 << 4 | l.kyn2 << 8, last(12))};
  for (unsigned i = 0; i < matches; ++i) {
    Match& m = match_[i];
    std::uint32_t& place = places_[i][hashes[i] >> (32 - table_bits_)];
    const std::uint32_t candidate = place;
    place = now;
    if (i >= 2) {
      m.at = candidate;
      m.row = m.length < 16 ? m.length : 15 + std::min(m.length / 16, 16u);
      continue;
    }
    // It stays where it is for some misses: most defects are local.
    if (candidate != 0 && candidate != m.at && (m.at == 0 || m.length < 16)) {
      std::uint32_t length = 0;
      while (length < 32 && length < candidate &&
             history_[candidate - 1 - length] == history_[now - 1 - length])
        ++length;
      if (length >= (i == 0 ? 16u : 32u)) m = {candidate, length, 0, 0};
    }
    const std::uint32_t length =
        m.length < 16 ? m.length / 2
                      : std::min(3 + static_cast<std::uint32_t>(std::bit_width(m.length)), 15u);
    m.row = std::min(m.misses, 3u) * 16 + length;
  }
}

/// Chooses the weights and the curves of refinement.
void MixingModel::select(const Local& l, std::size_t pending) {
  const unsigned s1 = last(1);
  run_ = s1 == 0 ? 0 : std::min(run_ + 1, 7u);
  const Match& m = match_[0];
  const unsigned expected = m.at != 0 ? history_[m.at] : 5;
  const unsigned certainty = m.misses != 0 ? 0 : m.length < 20 ? 1 : m.length < 32 ? 2 : 3;
  const auto within = [](unsigned v, unsigned most) { return std::clamp(v, 1u, most) - 1; };
  row_[0] = l.kx << 2 | s1;
  row_[1] = within(l.kp, 6) + 6 * within(l.ky, 6) + 36 * within(l.kyn, 6);
  row_[2] = run_ + 8 * (pending == 0) + 16 * l.ring;
  row_[3] = expected + 6 * certainty;
  curve_context_ = {l.kx | s1 << 4 | within(l.kp, 8) << 6, hash(94, l.fan[0], l.kx) >> 22,
                    l.kx | within(l.ky, 8) << 4 | within(l.kp, 8) << 7, l.kx | expected << 4};
}

/// The share of rans::scale of yes.
std::uint32_t MixingModel::predict(unsigned decision) {
  unsigned seen = 0;
  for (unsigned c = 0; c < contexts; ++c) {
    const Counter counter = (*slot_[c])[decision];
    const unsigned n = counter & 1023;
    seen += n != 0;
    input_[c] = static_cast<std::int16_t>(logistic.stretch(counter >> 10) * trust[n] >> 8);
  }
  row_[4] = seen;
  std::int16_t* in = input_.data() + contexts + numbers;
  for (unsigned i = 0; i < matches; ++i, in += 2) {
    const Match& m = match_[i];
    in[0] = in[1] = 0;
    asked_[i] = nullptr;
    if (m.at == 0) continue;
    const unsigned expected = history_[m.at];
    if (expected < decision) continue;
    asked_[i] = &confidence_[i][(m.row * 2 + (expected == decision)) * decisions + decision];
    const std::uint32_t p = *asked_[i] >> 10;
    in[0] = static_cast<std::int16_t>(logistic.stretch(p));
    in[1] = static_cast<std::int16_t>(2 * (static_cast<int>(p >> 12) - 512));
  }
  input_[inputs - 1] = 256;

  final_ = &final_weights_[std::size_t(row_[0] * decisions + decision) * sets];
  std::int64_t sum = 0;
  for (unsigned s = 0; s < sets; ++s) {
    const std::int32_t dot = mixer::dot(input_.data(), weights(s, decision), inputs);
    logit_[s] = std::clamp(dot >> 12, -max_logit, max_logit);
    sum += std::int64_t(logit_[s]) * final_[s];
  }
  const int logit = static_cast<int>(std::clamp<std::int64_t>(sum >> 16, -max_logit, max_logit));
  mixed_ = logistic.squash(logit);

  // Points of the curves are 128 apart; between them it is a straight line.
  const unsigned position = static_cast<unsigned>(std::clamp(logit, -2047, 2047) + 2048);
  const unsigned part = position % 128;
  unsigned refined = 0;
  for (unsigned c = 0; c < curves; ++c) {
    const unsigned point = (curve_context_[c] * decisions + decision) * 33 + position / 128;
    refined += (curve_[c][point] * (128 - part) + curve_[c][point + 1] * part) >> 7;
    point_[c] = point + (part >= 64);
  }
  const unsigned p = (static_cast<unsigned>(mixed_) * 4 + refined) / 8;
  // At least this, so that a byte holds no more symbols than the format allows.
  return std::clamp(p / 2, 12u, rans::scale - 12);
}

void MixingModel::learn(unsigned decision, bool yes) {
  for (unsigned c = 0; c < contexts; ++c) count((*slot_[c])[decision], yes, most_asked);
  for (Counter* counter : asked_)
    if (counter) count(*counter, yes, 255);
  const int target = yes ? 65536 : 0;
  for (unsigned s = 0; s < sets; ++s) {
    std::uint32_t& rate = rates_[s][row_[s] * decisions + decision];
    const int error = target - logistic.squash(logit_[s]);
    const int step = (error * static_cast<int>(rate >> 15) + 256) >> 9;
    mixer::train(input_.data(), weights(s, decision), inputs,
                 static_cast<std::int16_t>(std::clamp(step, -32767, 32767)));
    rate -= (rate - final_rate) >> 10;
  }
  const std::int64_t error = target - mixed_;
  for (unsigned s = 0; s < sets; ++s) {
    const auto step = static_cast<std::int32_t>((error * logit_[s] + (1 << 16)) >> 17);
    final_[s] = std::clamp(final_[s] + step, -(1 << 24), 1 << 24);
  }
  for (unsigned c = 0; c < curves; ++c) {
    std::uint16_t& point = curve_[c][point_[c]];
    point = static_cast<std::uint16_t>(point + (((yes ? 65535 : 0) - point) >> 6));
  }
}

void MixingModel::remember(unsigned symbol) {
  for (unsigned i = 0; i < matches; ++i) {
    Match& m = match_[i];
    if (m.at == 0) continue;
    const bool hit = history_[m.at] == symbol;
    m.length = hit ? m.length + 1 : 0;
    if (i >= 2) continue;
    if (hit) {
      if (m.length > 16) m.misses = 0;
      ++m.at;
    } else {
      m.at = ++m.misses > 8 ? 0 : m.at + 1;
    }
  }
  history_.push_back(static_cast<std::uint8_t>(symbol));
  recent_ = recent_ << 2 | std::min(symbol, 3u);
}

}  // namespace clers::internal
