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

/// Who says where the next vertex is.
enum Expert : unsigned {
  plain_mean,      ///< of parallelograms
  corrected_mean,  ///< the same, with what was learned
  line_mean,       ///< of lines through neighbours
  axis_mean,       ///< the plain mean, whose scale is known along axes
  gate_end,        ///< the first parallelogram
  shape_or_copy,   ///< by an earlier component, or by shapes of the same degrees
  ring_mean,       ///< of neighbours
  mirror_image,
  experts
};

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
  static constexpr unsigned decisions = 16, first_halving = 8;

  Mixing()
      : weights_{first_rows(Context::misses), first_rows(Context::supports * Context::scales)},
        curves_(std::size_t(curves) * points) {
    for (std::size_t i = 0; i < curves_.size(); ++i)
      curves_[i] = static_cast<std::uint16_t>(logistic.squash((int(i % points) - 16) * 128));
    for (unsigned n = 0; n < most_rates; ++n)
      rates_[n] = final_rate + first_rate / (50 + 4 * n) * 50;
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

    const int error = (yes ? 65536 : 0) - p;
    for (Row* const row : w) {
      const int rate = static_cast<int>(rates_[row->seen / 4] >> 15);
      row->seen += row->seen + 1 < 4 * most_rates;
      const int step = (error * rate + 256) >> 9;
      mixer::train(said.data(), row->w.data(), experts,
                   static_cast<std::int16_t>(std::clamp(step, -32767, 32767)));
    }
    std::uint16_t& nearer = point[part >= 64];
    nearer = static_cast<std::uint16_t>(nearer + (((yes ? 65535 : 0) - nearer) >> 5));
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
  static constexpr unsigned most_rates = 1024;
  static constexpr std::uint32_t first_rate = 42949673, final_rate = 4294967;  ///< .02, .002

  /// What decisions learn on many meshes, in 1/256: by mode, and whether they are first, further
  /// away or halve.
  static constexpr std::int16_t first_weights[Context::modes][3][experts] = {
      {{7, 63, 28, 45, 12, 0, 31, 0},
       {34, 91, 16, 78, 28, 0, -9, 0},
       {44, 56, 47, 47, 49, 0, 44, 0}},
      {{-1, 55, 19, 25, -2, 202, 11, 0},
       {9, 76, -28, 16, -4, 161, -25, 0},
       {15, 20, 10, 16, 24, 103, 18, 0}},
      {{-3, 52, 20, 69, -6, 128, 14, 113},
       {11, 99, -5, 85, -4, 90, -36, 73},
       {45, 45, 47, 48, 46, 49, 48, 60}},
      {{0, 22, 25, 19, 8, 60, 8, 354},
       {6, 31, -50, 20, -30, 51, -72, 237},
       {25, 22, 31, 34, 33, 47, 34, 38}}};

  /// Rows of weights, `contexts` of them for each component and mode.
  static std::vector<Row> first_rows(unsigned contexts) {
    std::vector<Row> all;
    all.reserve(std::size_t(Context::components) * Context::modes * contexts * decisions);
    for (unsigned of = 0; of < Context::components * Context::modes * contexts; ++of)
      for (unsigned decision = 0; decision < decisions; ++decision) {
        Row r;
        const unsigned kind = decision == 0 ? 0 : decision < first_halving ? 1 : 2;
        for (unsigned i = 0; i < experts; ++i)
          r.w[i] = first_weights[of / contexts % Context::modes][kind][i] * (mixer::one / 256);
        all.push_back(r);
      }
    return all;
  }

  std::array<std::vector<Row>, 2> weights_;
  std::vector<std::uint16_t> curves_;
  std::array<std::uint32_t, most_rates> rates_;
  unsigned row_[2] = {}, curve_ = 0;
};

}  // namespace clers::internal::mixed

#endif
