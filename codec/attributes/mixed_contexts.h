// Decisions in several contexts at once: what was decided in each of them before is mixed by
// weights that are learned (Mahoney's PAQ). It knows no values.
#ifndef CLERS_CODEC_ATTRIBUTES_MIXED_CONTEXTS_H
#define CLERS_CODEC_ATTRIBUTES_MIXED_CONTEXTS_H

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <vector>

#include "codec/entropy/logistic.h"
#include "codec/entropy/mixer.h"
#include "codec/entropy/rans.h"

namespace clers::internal {

/// Codes differences, near ones cheap, each in one context of each of some tables:
///
///     is it not 0? is it negative? is it longer than 1 bit, than 2 ..? its two bits after the
///     first; and what is below as plain bits
class MixedContexts {
 public:
  static constexpr unsigned tables = 4;

  /// How many contexts each table has, and how many sets of weights there are.
  MixedContexts(const std::array<std::uint32_t, tables>& contexts, unsigned sets)
      : weights_(std::size_t(sets) * decisions) {
    for (unsigned i = 0; i < tables; ++i) slots_[i].resize(std::size_t(contexts[i]) * decisions);
    for (unsigned n = 0; n < rates_.size(); ++n) rates_[n] = (2u << 16) / (2 * n + 3);
  }
  /// The bytes that one takes.
  static std::uint64_t memory(const std::array<std::uint32_t, tables>& contexts, unsigned sets) {
    std::uint64_t all = sets * sizeof(Weights);
    for (const std::uint32_t n : contexts) all += n * sizeof(Slot);
    return all * decisions;
  }

  /// Which contexts the next number is in, one of each table, and which set of weights.
  void set(const std::array<std::uint32_t, tables>& contexts, unsigned set) {
    for (unsigned i = 0; i < tables; ++i) at_[i] = &slots_[i][std::size_t(contexts[i]) * decisions];
    row_ = &weights_[std::size_t(set) * decisions];
  }

  /// Codes a number that is less than 2^62 away from 0.
  template <class Coder>
  std::int64_t code(Coder& coder, std::int64_t number) {
    const auto n = static_cast<std::uint64_t>(number < 0 ? -number : number);
    const auto length = static_cast<unsigned>(std::bit_width(n));
    if (!decide(coder, zero, n != 0)) return 0;
    const bool negative = decide(coder, sign, number < 0);
    unsigned l = 1;
    while (l < most_length && decide(coder, longer + std::min(l, lengths) - 1, length > l)) ++l;
    std::uint64_t result = 1;
    unsigned rest = l - 1;
    for (unsigned i = 0; i < 2 && rest > 0; ++i) {
      --rest;
      const unsigned node =
          next + 3 * (std::min(l, own_bits) - 2) + static_cast<unsigned>(result) - 1;
      result = 2 * result | decide(coder, node, n >> rest & 1);
    }
    while (rest > 0) {
      const unsigned part = std::min(rest, 14u);
      rest -= part;
      const auto bits = static_cast<std::uint32_t>(n >> rest & ((1u << part) - 1));
      result = result << part | coder.raw(part, bits);
    }
    const auto size = static_cast<std::int64_t>(result);
    return negative ? -size : size;
  }

 private:
  static constexpr unsigned most_length = 62;
  static constexpr unsigned lengths = 16;  ///< with decisions of their own
  static constexpr unsigned own_bits = 7;  ///< lengths with bits of their own
  static constexpr unsigned zero = 0, sign = 1, longer = 2, next = longer + lengths,
                            decisions = next + 3 * (own_bits - 1);
  static constexpr unsigned most_seen = 250;
  static constexpr int learning = 40;

  /// The share of yes in 1/65536, and how many decisions it is of.
  struct Slot {
    std::uint16_t share = 1u << 15;
    std::uint16_t seen = 0;
  };
  struct Weights {
    alignas(16) std::array<std::int32_t, 8> of = {first, first, first, first};
    static constexpr std::int32_t first = mixer::one / 16 * 5;
  };

  template <class Coder>
  bool decide(Coder& coder, unsigned decision, bool value) {
    alignas(16) std::array<std::int16_t, 8> said = {};
    for (unsigned i = 0; i < tables; ++i)
      said[i] = static_cast<std::int16_t>(
          logistic.stretch(static_cast<std::uint32_t>(at_[i][decision].share) << 6));
    said[tables] = 256;
    Weights& weights = row_[decision];
    const int logit =
        std::clamp(mixer::dot(said.data(), weights.of.data(), 8) >> 12, -max_logit, max_logit);
    const int p = logistic.squash(logit);
    const bool yes =
        coder.decide(std::clamp(static_cast<std::uint32_t>(p) / 2, 32u, rans::most_certain), value);
    const int error = (yes ? 65536 : 0) - p;
    mixer::train(said.data(), weights.of.data(), 8,
                 static_cast<std::int16_t>(error * learning / 256));
    for (unsigned i = 0; i < tables; ++i) {
      Slot& slot = at_[i][decision];
      const std::int64_t target = yes ? 65535 : 0;
      slot.share = static_cast<std::uint16_t>(slot.share +
                                              ((target - slot.share) * rates_[slot.seen] >> 16));
      slot.seen = static_cast<std::uint16_t>(slot.seen + (slot.seen < most_seen));
    }
    return yes;
  }

  std::array<std::vector<Slot>, tables> slots_;
  std::vector<Weights> weights_;
  std::array<std::int64_t, most_seen + 1> rates_;
  std::array<Slot*, tables> at_ = {};
  Weights* row_ = nullptr;
};

}  // namespace clers::internal

#endif
