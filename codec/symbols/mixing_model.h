// The model of level 9: what many contexts have seen, a logistic regression on degrees, and what
// followed at earlier places that looked the same, mixed into one probability (Mahoney's PAQ).
//
// A symbol is up to four decisions: is it C? R? L? S? No four times is E. Everything is an integer;
// codec/format.md has the numbers.
#ifndef CLERS_CODEC_SYMBOLS_MIXING_MODEL_H
#define CLERS_CODEC_SYMBOLS_MIXING_MODEL_H

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "codec/entropy/coder.h"
#include "codec/entropy/mixer.h"
#include "codec/entropy/rans.h"
#include "codec/symbols/neighbourhood.h"
#include "codec/symbols/symbol.h"
#include "topology/front.h"

namespace clers::internal {

class MixingModel {
 public:
  /// For a surface of `faces` faces built from `ids` vertices. Throws std::bad_alloc only.
  MixingModel(std::size_t faces, std::size_t ids);
  /// Bytes that takes at most: 41 a vertex, one a face, and 2 to 13 MB.
  static std::uint64_t memory(std::uint64_t faces, std::uint64_t ids) {
    return Neighbourhood::bytes_each * ids + faces +
           (std::uint64_t(contexts * sizeof(Slot) + matches * sizeof(std::uint32_t))
            << table_bits(faces)) +
           (2 << 20);
  }
  bool ok() const { return true; }

  /// Codes the next symbol, or ignores the one it is given and decodes one. The front is as the
  /// symbols so far left it, `pending` the number of pending gates.
  template <class Coder, class Front, class Gate>
  Clers code(Coder& coder, const Front& front, const Gate& gate, std::size_t pending,
             Clers symbol) {
    look(front.links(), {gate.x, gate.y, gate.kx, gate.ky}, pending);
    // C is impossible where the curve has two edges.
    unsigned decision = two_edges_ ? 1 : 0;
    for (; decision < decisions; ++decision) {
      const bool yes = coder.decide(predict(decision), static_cast<unsigned>(symbol) == decision);
      learn(decision, yes);
      if (yes) break;
    }
    remember(decision);
    return static_cast<Clers>(decision);
  }

  template <class Front, class Gate, class Then>
  auto decode(rans::Decoder& in, const Front& front, const Gate& gate, std::size_t pending,
              Then then) {
    DecodeFrom coder(in);
    return with_symbol(code(coder, front, gate, pending, Clers::C), then);
  }

 private:
  static constexpr unsigned decisions = 4;
  static constexpr unsigned contexts = 20, numbers = 24, matches = 4;
  static constexpr unsigned inputs = 56;  ///< those, two a match, a constant; a multiple of 8
  static constexpr unsigned sets = 5;     ///< of weights, each with rows for a context of its own
  static constexpr unsigned curves = 4;   ///< that refine the probability

  static unsigned table_bits(std::uint64_t faces) {
    return std::clamp(static_cast<unsigned>(std::bit_width(faces)) - 1u, 8u, 15u);
  }

  /// Probability of yes in units of 2^-22, and below it 10 bits: how often it was asked.
  using Counter = std::uint32_t;
  using Slot = std::array<Counter, decisions>;

  /// A place in history_ whose symbol is expected to follow.
  struct Match {
    std::uint32_t at = 0;      ///< 0: none
    std::uint32_t length = 0;  ///< how many symbols before agree
    std::uint32_t misses = 0;  ///< since it agreed for long
    std::uint32_t row = 0;     ///< of its confidence
  };

  struct GateView {
    std::uint32_t x, y, kx, ky;
  };
  struct Local;  ///< what surrounds the gate

  void follow(const FrontLink* links, GateView gate);
  void look(const FrontLink* links, GateView gate, std::size_t pending);
  Local local(const FrontLink* links) const;
  void find_contexts(const Local& l, std::size_t pending);
  void set_numbers(const Local& l);
  void find_matches(const Local& l);
  void select(const Local& l, std::size_t pending);
  std::uint32_t predict(unsigned decision);
  void learn(unsigned decision, bool yes);
  void remember(unsigned symbol);

  /// The last n symbols, 2 bits each, the latest in the low bits; S and E are both 3.
  std::uint32_t last(unsigned n) const {
    return static_cast<std::uint32_t>(recent_ & ((std::uint64_t(1) << 2 * n) - 1));
  }
  std::int32_t* weights(unsigned set, unsigned decision) {
    return &weights_[set][std::size_t(row_[set] * decisions + decision) * inputs];
  }

  // What was built and coded so far.
  Neighbourhood around_;
  GateView gate_ = {};  ///< of the last symbol, or the next one
  bool two_edges_ = false;
  std::vector<std::uint8_t> history_;  ///< a symbol to begin with, then all
  std::uint64_t recent_ = 0;
  std::array<int, 8> excess_ = {};  ///< degree - 6 of the vertices closed last
  unsigned run_ = 0;                ///< symbols since the last C, at most 7

  // Contexts.
  unsigned table_bits_;
  std::vector<Slot> slots_;
  std::array<Slot*, contexts> slot_ = {};

  // Matches: two by the symbols before, two by what is around.
  std::array<Match, matches> match_;
  std::array<std::vector<std::uint32_t>, matches> places_;  ///< by hash: where it was seen last
  std::array<std::vector<Counter>, matches> confidence_;
  std::array<Counter*, matches> asked_ = {};

  // The mixer.
  alignas(16) std::array<std::int16_t, inputs> input_ = {};
  std::array<std::vector<std::int32_t>, sets> weights_;
  std::array<std::vector<std::uint32_t>, sets> rates_;
  std::array<unsigned, sets> row_ = {};
  std::array<std::int32_t, sets> logit_ = {};
  std::vector<std::int32_t> final_weights_;
  std::int32_t* final_ = nullptr;
  int mixed_ = 0;  ///< probability of yes in 1/65536

  // Refinement: measured probabilities by (context, mixed logit), 33 points a curve.
  std::array<std::vector<std::uint16_t>, curves> curve_;
  std::array<unsigned, curves> curve_context_ = {}, point_ = {};
};

}  // namespace clers::internal

#endif
