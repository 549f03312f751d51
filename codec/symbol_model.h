// Adaptive probabilities of CLERS symbols in the order of decoding.
//
// In that order the decoder knows the valences, and the valence of the gate's pivot x, the vertex
// that a C would close, says most about the next symbol. A context is (valence of x, last k
// symbols); a context seen for the first time inherits from (valence of x, last symbol). Integers
// only: the same bytes on every machine.
#ifndef CLERS_CODEC_SYMBOL_MODEL_H
#define CLERS_CODEC_SYMBOL_MODEL_H

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <memory>

#include "codec/clers.h"
#include "codec/rans.h"

namespace clers {

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
  void update(unsigned s) {
    const int rate = int(std::bit_width(seen + 2)) - 1;
    seen += seen < 126;
    // Four lanes at once: g++ and clang make this SSE2, or what else there is, with equal results.
    typedef std::int32_t Lanes __attribute__((vector_size(16)));
    Lanes lanes;
    std::memcpy(&lanes, bound + 1, sizeof lanes);
    const std::int32_t* t = targets[s];
    lanes += (Lanes{t[0], t[1], t[2], t[3]} - lanes) >> rate;
    std::memcpy(bound + 1, &lanes, sizeof lanes);
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

class SymbolModel {
 public:
  static constexpr unsigned max_valence = 15, max_history = 8, table_bits = 12;

  /// k symbols of history, 1..max_history. May fail to allocate: see ok().
  explicit SymbolModel(unsigned k)
      : mask_((1u << 2 * k) - 1),
        bits_(2 * k),
        hashed_(k > 4),
        first_(allocate(std::size_t(max_valence + 1) << 2)),
        second_(allocate(std::size_t(1) << std::min(4 + bits_, table_bits))) {
    if (!ok()) return;
    for (unsigned c = 0; c < (max_valence + 1) << 2; ++c) first_[c] = initial();
  }

  bool ok() const { return first_ && second_; }

  /// Decodes the next symbol after a pivot of valence kx and returns then(Letter<symbol>()).
  ///
  /// The comparisons that find the symbol are also the branches on it. So the processor goes on
  /// with the symbol it expects, the next context included, while the state is still being
  /// computed.
  template <class Then>
  [[gnu::always_inline]] auto decode(rans::Decoder& in, std::uint32_t kx, Then then) {
    SymbolRecord& record = context(kx);
    const std::uint32_t slot = in.slot();
    if (slot < record.start(1)) return take<Clers::C>(in, record, kx, then);
    if (slot < record.start(2)) return take<Clers::R>(in, record, kx, then);
    if (slot < record.start(3)) return take<Clers::L>(in, record, kx, then);
    if (slot < record.start(4)) return take<Clers::S>(in, record, kx, then);
    return take<Clers::E>(in, record, kx, then);
  }

  /// The interval of a symbol, for coding it or for counting what it costs.
  rans::Interval encode(Clers symbol, std::uint32_t kx) {
    SymbolRecord& record = context(kx);
    const unsigned s = static_cast<unsigned>(symbol);
    const rans::Interval interval{static_cast<std::uint16_t>(record.start(s)),
                                  static_cast<std::uint16_t>(record.size(s))};
    learn(record, kx, s);
    return interval;
  }

 private:
  template <Clers symbol, class Then>
  [[gnu::always_inline]] auto take(rans::Decoder& in, SymbolRecord& record, std::uint32_t kx,
                                   Then& then) {
    constexpr unsigned s = static_cast<unsigned>(symbol);
    in.advance(record.start(s), record.size(s));
    learn(record, kx, s);
    return then(Letter<symbol>());
  }

  struct Free {
    void operator()(SymbolRecord* p) const { std::free(p); }
  };
  using Table = std::unique_ptr<SymbolRecord[], Free>;

  /// Zeroed pages that cost nothing until a context is used.
  static Table allocate(std::size_t n) {
    return Table(static_cast<SymbolRecord*>(std::calloc(n, sizeof(SymbolRecord))));
  }

  static SymbolRecord initial() {
    constexpr std::uint32_t unit = 1u << 31;
    return {{0, unit / 2, unit / 100 * 80, unit / 100 * 92, unit / 100 * 96, unit}, 0, 0};
  }

  SymbolRecord& context(std::uint32_t kx) {
    kx = std::min(kx, max_valence);
    std::uint32_t index = kx << bits_ | (history_ & mask_);
    if (hashed_) index = index * 0x9e3779b1u >> (32 - table_bits);
    SymbolRecord& record = second_[index];
    if (record.seen == 0) {
      record = first_[kx << 2 | (history_ & 3)];
      record.seen = std::min(record.seen, 2u);
    }
    return record;
  }

  void learn(SymbolRecord& record, std::uint32_t kx, unsigned s) {
    if (record.seen <= 16) first_[std::min(kx, max_valence) << 2 | (history_ & 3)].update(s);
    record.update(s);
    history_ = history_ << 2 | std::min(s, 3u);
  }

  std::uint32_t history_ = 0;
  std::uint32_t mask_;
  unsigned bits_;
  bool hashed_;   ///< contexts of long histories share a table that stays in cache
  Table first_;   ///< (valence, last symbol)
  Table second_;  ///< (valence, last k symbols)
};

}  // namespace clers

#endif
