// Values that no parallelogram predicts: the first of a chart, the second and the third. What
// encoder and decoder share of it; it knows single integers, and no surface.
#ifndef CLERS_CODEC_ATTRIBUTES_CHARTS_APART_H
#define CLERS_CODEC_ATTRIBUTES_CHARTS_APART_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "codec/attributes/axis_steps.h"
#include "codec/attributes/residual_sizes.h"
#include "codec/entropy/distribution.h"

namespace clers::internal {

/// Steps from one value of a chart to the next that were seen lately: charts of one triangle are
/// often alike. One table has steps to the second value of a chart, and for each of these there is
/// one with steps to the third.
class ChartShapes {
 public:
  using Step = std::array<std::int64_t, 2>;

  ChartShapes() {
    std::array<std::uint16_t, 16> even;
    even.fill(shares / 16);
    which_.assign(most + 1, Distribution(even));
    tables_.resize(most + 1);
  }
  static constexpr std::uint64_t memory() {
    return (most + 1) * (sizeof(Distribution) + sizeof(Table));
  }

  /// Begins a chart's second value, or its third.
  void begin(bool third) {
    table_ = third ? second_ : most;
    third_ = third;
  }
  /// Codes whether the step is one that was seen, and which; true if it is. `valid` becomes false
  /// where there is no such one.
  template <class Coder>
  bool code(Coder& coder, unsigned lane, Step& step, bool& valid) {
    Table& table = tables_[table_];
    unsigned i = most;
    if constexpr (Coder::encodes)
      for (unsigned k = 0; k < table.count; ++k)
        if (table.step[k] == step) i = k;
    i = coder.symbol(lane, which_[table_], i);
    if (!third_) second_ = i;
    if (i == most) return false;
    valid = valid && i < table.count;
    if (!valid) return false;
    table.used[i] = ++time_;
    step = table.step[i];
    return true;
  }
  /// Keeps a step that was not, in place of the one that was used least lately.
  void learn(const Step& step) {
    Table& table = tables_[table_];
    unsigned i = table.count;
    if (i < most) {
      ++table.count;
    } else {
      i = 0;
      for (unsigned k = 1; k < most; ++k)
        if (table.used[k] < table.used[i]) i = k;
    }
    table.step[i] = step;
    table.used[i] = ++time_;
    if (third_) return;
    second_ = i;
    tables_[i].count = 0;
  }

 private:
  static constexpr unsigned most = 15;  // the sixteenth symbol: none of these
  struct Table {
    unsigned count = 0;
    std::array<Step, most> step;
    std::array<std::uint64_t, most> used;
  };

  std::vector<Table> tables_;
  std::vector<Distribution> which_;
  unsigned table_ = most, second_ = most;
  bool third_ = false;
  std::uint64_t time_ = 0;
};

/// Where the first value of a chart may be, of one component: where the last chart began, or the
/// mean of many, whichever was nearer lately.
class ChartStarts {
 public:
  std::int64_t guess() const { return off_mean_ < off_last_ ? mean_ : last_; }
  void learn(std::int64_t x) {
    const auto size = [](std::int64_t off) {
      return 16 * static_cast<int>(size_of(4 * magnitude(off)));
    };
    off_last_ += (size(x - last_) - off_last_) >> 4;
    off_mean_ += (size(x - mean_) - off_mean_) >> 4;
    mean_ += (x - mean_) >> 5;
    last_ = x;
  }

 private:
  std::int64_t last_ = 0, mean_ = 0;
  int off_last_ = 0, off_mean_ = 0;  ///< sizes, in 1/16
};

/// How large residuals of one kind are, lately.
class UsualSize {
 public:
  unsigned size() const { return static_cast<unsigned>(at_ >> 4); }
  void learn(std::uint64_t residual) {
    at_ += (16 * static_cast<int>(size_of(residual)) - at_) >> 2;
  }

 private:
  int at_ = 0;  // in 1/16
};

}  // namespace clers::internal

#endif
