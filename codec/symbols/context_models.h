// Adaptive probabilities of CLERS symbols in the order of decoding.
//
// In that order the decoder knows the valences, and the valence of the gate's pivot x, the vertex
// that a C would close, says most about the next symbol. A context is (valence of x, last k
// symbols); a context seen for the first time inherits from (valence of x, last symbol). Integers
// only: the same bytes on every machine.
#ifndef CLERS_CODEC_SYMBOLS_CONTEXT_MODELS_H
#define CLERS_CODEC_SYMBOLS_CONTEXT_MODELS_H

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <memory>

#include "codec/base/portable.h"
#include "codec/entropy/rans.h"
#include "codec/symbols/symbol.h"
#include "codec/symbols/symbol_priors.h"

namespace clers::internal {

/// Adaptive distribution over the five symbols.
struct SymbolRecord {
  /// bound[s]: share of the symbols below s, in units of 2^-31. bound[0] = 0, bound[5] = 2^31.
  std::uint32_t bound[6];
  std::uint32_t seen;  ///< 0: never used
  std::uint32_t unused;

  static constexpr unsigned shift = 31 - rans::scale_bits;

  std::uint32_t start(unsigned s) const { return bound[s] >> shift; }
  std::uint32_t size(unsigned s) const { return start(s + 1) - start(s); }

  /// Moves towards s by 1/2, 1/2, 1/4 .. 1/128 of the way. Every symbol keeps at least 3 units of
  /// rans::scale: targets leave it 4, and rounding takes less than one.
  CLERS_ALWAYS_INLINE void update(unsigned s) {
    const int rate = int(std::bit_width(seen + 2)) - 1;
    seen += seen < 126;
    // Four lanes at once: from a copy, compilers see that nothing overlaps and make vectors of
    // them.
    std::int32_t lanes[4];
    std::memcpy(lanes, bound + 1, sizeof lanes);
    const std::int32_t* const t = targets[s];
    for (unsigned i = 0; i < 4; ++i) lanes[i] += (t[i] - lanes[i]) >> rate;
    std::memcpy(bound + 1, lanes, sizeof lanes);
  }

 private:
  /// Where the bounds go when symbol s was seen: 4 units of rans::scale are left to each other one.
  static constexpr std::int32_t least = 4 << shift, top = 0x7fffffff - least + 1;
  static constexpr std::int32_t targets[5][4] = {
      {top - 3 * least, top - 2 * least, top - least, top},
      {least, top - 2 * least, top - least, top},
      {least, 2 * least, top - least, top},
      {least, 2 * least, 3 * least, top},
      {least, 2 * least, 3 * least, 4 * least}};
};
static_assert(sizeof(SymbolRecord) == 32);

/// Distributions by (valence of x, last symbol) and by (valence of x, last k symbols).
class ContextTables {
 public:
  static constexpr unsigned max_valence = 15, max_history = 8, table_bits = 13;
  static constexpr std::size_t most_memory =
      sizeof(SymbolRecord) * (((max_valence + 1) << 2) + (1u << table_bits));

  /// k symbols of history, 1..max_history. May fail to allocate: see ok().
  explicit ContextTables(unsigned k)
      : mask_((1u << 2 * k) - 1),
        bits_(2 * k),
        hashed_(4 + bits_ > table_bits),
        first_(allocate(std::size_t(max_valence + 1) << 2)),
        second_(allocate(std::size_t(1) << std::min(4 + bits_, table_bits))) {
    if (!ok()) return;
    for (unsigned c = 0; c < (max_valence + 1) << 2; ++c) first_[c] = initial(symbol_priors[c]);
  }

  bool ok() const { return first_ && second_; }

 protected:
  struct Pair {
    SymbolRecord& first;
    SymbolRecord& second;
  };

  /// The distributions after a pivot of valence kx; of k symbols one that was never used before is
  /// a copy of the other.
  CLERS_ALWAYS_INLINE Pair context(std::uint32_t kx) {
    kx = std::min(kx, max_valence);
    std::uint32_t index = kx << bits_ | (history_ & mask_);
    if (hashed_) index = index * 0x9e3779b1u >> (32 - table_bits);
    Pair p{first_[kx << 2 | (history_ & 3)], second_[index]};
    if (p.second.seen == 0) {
      p.second = p.first;
      p.second.seen = std::min(p.second.seen, 1u);
    }
    return p;
  }

  void remember(unsigned s) { history_ = history_ << 2 | std::min(s, 3u); }

 private:
  struct Free {
    void operator()(SymbolRecord* p) const { std::free(p); }
  };
  using Table = std::unique_ptr<SymbolRecord[], Free>;

  /// Zeroed pages that cost nothing until a context is used.
  static Table allocate(std::size_t n) {
    return Table(static_cast<SymbolRecord*>(std::calloc(n, sizeof(SymbolRecord))));
  }

  /// As if it had been seen a few times, if it ever was.
  static SymbolRecord initial(const std::array<std::uint8_t, 4>& prior) {
    constexpr std::uint32_t unit = 1u << 23;
    return {{0, prior[0] * unit, prior[1] * unit, prior[2] * unit, prior[3] * unit, 256 * unit},
            prior == default_prior ? 0u : 8u,
            0};
  }

  std::uint32_t history_ = 0;
  std::uint32_t mask_;
  unsigned bits_;
  bool hashed_;   ///< contexts of long histories share a table that stays in cache
  Table first_;   ///< (valence, last symbol)
  Table second_;  ///< (valence, last k symbols)
};

/// Decodes the next symbol from the bounds that `start` gives and returns
/// then(Symbol<symbol>(), take(s)).
///
/// The comparisons that find the symbol are also the branches on it. So the processor goes on with
/// the symbol it expects, the next context included, while the state is still being computed.
template <class Start, class Learn, class Then>
CLERS_ALWAYS_INLINE auto decode_symbol(rans::Decoder& in, Start start, Learn learn, Then& then) {
  const std::uint32_t slot = in.slot();
  const auto take = [&](auto symbol, std::uint32_t low, std::uint32_t high) CLERS_INLINE_LAMBDA {
    in.advance(low, high - low);
    learn(static_cast<unsigned>(symbol()));
    return then(symbol);
  };
  const std::uint32_t r = start(1);
  if (slot < r) return take(Symbol<Clers::C>(), 0, r);
  const std::uint32_t l = start(2);
  if (slot < l) return take(Symbol<Clers::R>(), r, l);
  const std::uint32_t s = start(3);
  if (slot < s) return take(Symbol<Clers::L>(), l, s);
  const std::uint32_t e = start(4);
  if (slot < e) return take(Symbol<Clers::S>(), s, e);
  return take(Symbol<Clers::E>(), e, rans::scale);
}

/// One distribution, of the last k symbols. The shorter context only lends its records.
class SingleModel : public ContextTables {
 public:
  using ContextTables::ContextTables;

  template <class Front, class Gate, class Then>
  CLERS_ALWAYS_INLINE auto decode(rans::Decoder& in, const Front&, const Gate& gate, std::size_t,
                                  Then then) {
    const Pair p = context(gate.kx);
    return decode_symbol(
        in, [&](unsigned s) CLERS_INLINE_LAMBDA { return p.second.start(s); },
        [&](unsigned s) CLERS_INLINE_LAMBDA { learn(p, s); }, then);
  }

  /// The interval of a symbol, for coding it or for counting what it costs.
  rans::Interval encode(Clers symbol, std::uint32_t kx) {
    const Pair p = context(kx);
    const unsigned s = static_cast<unsigned>(symbol);
    const rans::Interval interval{static_cast<std::uint16_t>(p.second.start(s)),
                                  static_cast<std::uint16_t>(p.second.size(s))};
    learn(p, s);
    return interval;
  }

 private:
  CLERS_ALWAYS_INLINE void learn(const Pair& p, unsigned s) {
    if (p.second.seen <= 16) p.first.update(s);
    p.second.update(s);
    remember(s);
  }
};

/// The average of both distributions: the longer context weighs more the more often it was seen.
class PairModel : public ContextTables {
 public:
  /// `quick`: it is trusted almost at once, which suits surfaces that repeat themselves.
  PairModel(unsigned k, bool quick)
      : ContextTables(k), weights_(quick ? quick_trust : slow_trust) {}

  template <class Front, class Gate, class Then>
  CLERS_ALWAYS_INLINE auto decode(rans::Decoder& in, const Front&, const Gate& gate, std::size_t,
                                  Then then) {
    const Pair p = context(gate.kx);
    const std::uint32_t w = weight(p);
    return decode_symbol(
        in, [&](unsigned s) CLERS_INLINE_LAMBDA { return start(p, w, s); },
        [&](unsigned s) CLERS_INLINE_LAMBDA { learn(p, s); }, then);
  }

  rans::Interval encode(Clers symbol, std::uint32_t kx) {
    const Pair p = context(kx);
    const std::uint32_t w = weight(p);
    const unsigned s = static_cast<unsigned>(symbol);
    const std::uint32_t low = start(p, w, s), high = start(p, w, s + 1);
    learn(p, s);
    return {static_cast<std::uint16_t>(low), static_cast<std::uint16_t>(high - low)};
  }

 private:
  using Weights = std::array<std::uint8_t, 8>;  ///< in eighths, by floor(log2(times seen + 2))
  static constexpr Weights slow_trust = {0, 1, 2, 3, 4, 5, 6, 7},
                           quick_trust = {0, 1, 7, 8, 8, 8, 8, 8};

  std::uint32_t weight(const Pair& p) const {
    return weights_[static_cast<unsigned>(std::bit_width(p.second.seen + 2)) - 1];
  }
  static std::uint32_t start(const Pair& p, std::uint32_t w, unsigned s) {
    // (first * (8 - w) + second * w) / 8 with one multiplication
    const auto first = static_cast<std::int32_t>(p.first.start(s));
    const auto second = static_cast<std::int32_t>(p.second.start(s));
    return static_cast<std::uint32_t>(
        (8 * first + (second - first) * static_cast<std::int32_t>(w)) >> 3);
  }
  CLERS_ALWAYS_INLINE void learn(const Pair& p, unsigned s) {
    if (p.second.seen <= 62) p.first.update(s);
    p.second.update(s);
    remember(s);
  }

  Weights weights_;
};

}  // namespace clers::internal

#endif
