// Decisions whose probability is a mix of what experts say, the weights learned as the answers
// come. It knows logits and contexts, no values.
#ifndef CLERS_CODEC_ATTRIBUTES_MIXED_MIXING_H
#define CLERS_CODEC_ATTRIBUTES_MIXED_MIXING_H

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "codec/entropy/coder.h"
#include "codec/entropy/logistic.h"
#include "codec/entropy/mixer.h"
#include "codec/entropy/rans.h"

namespace clers::internal::mixed {

inline constexpr unsigned experts = 8;

/// Where in a value a decision is.
struct Context {
  unsigned component = 0;  ///< in the order of coding
  unsigned mode = 0;       ///< which experts there are
  unsigned missed = 0;     ///< how far off the components coded before were, by their scale
  unsigned support = 0;    ///< parallelograms: 0, 1, 2, more
  unsigned scale = 0;      ///< octave of the scale in steps

  static constexpr unsigned components = 3, modes = 4, misses = 4, supports = 4, scales = 8;
};

/// Two sets of weights, whose logits are averaged, and a curve that refines the result.
class Mixing {
 public:
  static constexpr unsigned decisions = 16;

  Mixing()
      : weights_{std::vector<Row>(rows[0], first_row()), std::vector<Row>(rows[1], first_row())},
        curves_(std::size_t(curves) * points) {
    for (std::size_t i = 0; i < curves_.size(); ++i)
      curves_[i] = static_cast<std::uint16_t>(logistic.squash((int(i % points) - 16) * 128));
    for (unsigned n = 0; n < most_seen; ++n) rates_[n] = final_rate + first_rate / (50 + n) * 50;
  }
  static constexpr std::uint64_t memory() {
    return (rows[0] + rows[1]) * sizeof(Row) + curves * points * sizeof(std::uint16_t);
  }

  void set(const Context& c) {
    row_[0] = ((c.component * Context::modes + c.mode) * Context::misses + c.missed) * decisions;
    row_[1] = (((c.component * Context::modes + c.mode) * Context::supports + c.support) *
                   Context::scales +
               c.scale) *
              decisions;
    curve_ = ((c.component * Context::misses + c.missed) * Context::scales + c.scale) * decisions;
  }

  /// What the experts say of the next decision: logits, at most max_logit, 0 of one that has none.
  alignas(16) std::array<std::int16_t, experts> said = {};

  /// Codes the next decision, which is the `decision`-th kind of Mixing::decisions.
  template <class Coder>
  bool code(Coder& coder, unsigned decision, bool value) {
    Row* const w[2] = {&weights_[0][row_[0] + decision], &weights_[1][row_[1] + decision]};
    int logit[2];
    for (unsigned s = 0; s < 2; ++s)
      logit[s] =
          std::clamp(mixer::dot(said.data(), w[s]->w.data(), experts) >> 12, -max_logit, max_logit);
    const int mixed = (logit[0] + logit[1]) / 2;
    const unsigned position = static_cast<unsigned>(std::clamp(mixed, -2047, 2047) + 2048);
    const unsigned part = position % 128;
    std::uint16_t* const point = &curves_[std::size_t(curve_ + decision) * points + position / 128];
    const unsigned refined = (point[0] * (128 - part) + point[1] * part) >> 7;
    const int p = logistic.squash(mixed);
    const std::uint32_t share = (static_cast<unsigned>(p) + refined) / 4;
    const bool yes = coder.decide(std::clamp(share, 8u, rans::scale - 8), value);

    const int target = yes ? 65536 : 0;
    for (unsigned s = 0; s < 2; ++s) {
      const int error = target - logistic.squash(logit[s]);
      const int rate = static_cast<int>(rates_[w[s]->seen] >> 15);
      w[s]->seen += w[s]->seen + 1 < most_seen;
      const int step = (error * rate + 256) >> 9;
      mixer::train(said.data(), w[s]->w.data(), experts,
                   static_cast<std::int16_t>(std::clamp(step, -32767, 32767)));
    }
    std::uint16_t& nearer = point[part >= 64];
    nearer = static_cast<std::uint16_t>(nearer + (((yes ? 65535 : 0) - nearer) >> 6));
    return yes;
  }

 private:
  struct alignas(16) Row {
    std::array<std::int32_t, experts> w;
    std::uint32_t seen = 0;
  };
  static constexpr unsigned points = 33;
  static constexpr unsigned rows[2] = {
      Context::components * Context::modes * Context::misses * decisions,
      Context::components* Context::modes* Context::supports* Context::scales* decisions};
  static constexpr unsigned curves =
      Context::components * Context::misses * Context::scales * decisions;
  static constexpr unsigned most_seen = 4096;
  static constexpr std::uint32_t first_rate = 171798692, final_rate = 4294967;  ///< .08, .002

  static Row first_row() {
    Row r;
    r.w.fill(mixer::one / 6);
    return r;
  }

  std::array<std::vector<Row>, 2> weights_;
  std::vector<std::uint16_t> curves_;
  std::array<std::uint32_t, most_seen> rates_;
  unsigned row_[2] = {}, curve_ = 0;
};

}  // namespace clers::internal::mixed

#endif
