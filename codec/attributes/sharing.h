// Which values are the same, where that is said one by one: a new one, or which of the earlier
// ones. And the numbers that values had in the input, where these are kept.
#ifndef CLERS_CODEC_ATTRIBUTES_SHARING_H
#define CLERS_CODEC_ATTRIBUTES_SHARING_H

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "codec/base/no_index.h"
#include "codec/entropy/coder.h"

namespace clers::internal {

/// Codes numbers of which each is one of those before, or one more than the greatest of them.
/// Mostly they go on as they did after the last number when it was met before, or are the last one,
/// its successor, or one of the latest. Cost: linear.
class SharingCoder {
 public:
  /// A coder that decodes fills in the numbers. There are `most` different ones, at most. False:
  /// there are more, or what was decoded is none of those before.
  template <class Coder>
  bool code(Coder& coder, std::span<std::uint32_t> numbers, std::uint64_t most) {
    after_.reserve(static_cast<std::size_t>(std::min<std::uint64_t>(most, numbers.size())));
    for (std::uint32_t& n : numbers) {
      n = code_number(coder, n);
      if (n > count() || n >= most) return false;
      if (n == count()) after_.push_back(no_index);
      if (last_ != no_index) after_[last_] = n;
      last_ = n;
    }
    return true;
  }
  std::uint32_t count() const { return static_cast<std::uint32_t>(after_.size()); }

  static std::uint64_t memory(std::uint64_t numbers, std::uint64_t most) {
    return 4 * std::min(numbers, most);
  }

 private:
  static constexpr unsigned remembered = 6, guesses = remembered + 2, far = guesses,
                            fresh = far + 1, outcomes = fresh + 1;

  template <class Coder>
  std::uint32_t code_number(Coder& coder, std::uint32_t value) {
    BitModel* const guess = guess_[before_[0]][before_[1]];
    const auto is = [&](unsigned outcome) {
      before_[1] = before_[0];
      before_[0] = outcome;
    };
    if (coder.bit(guess[fresh], value == count())) return is(fresh), remember(count(), remembered);
    const std::uint32_t after = last_ == no_index ? no_index : after_[last_];
    if (after != no_index && coder.bit(guess[remembered], value == after))
      return is(remembered), remember(after, remembered);
    if (last_ != no_index && last_ + 1 < count() && last_ + 1 != after &&
        coder.bit(guess[remembered + 1], value == last_ + 1))
      return is(remembered + 1), remember(last_ + 1, remembered);
    for (unsigned i = 0; i < filled_; ++i)
      if (recent_[i] != after && recent_[i] != last_ + 1 &&
          coder.bit(guess[i], value == recent_[i]))
        return is(i), remember(recent_[i], i);
    if (count() == 0) return no_index;
    is(far);
    return remember(code_uniform(coder, count(), value), remembered);
  }

  /// Moves a number to the front, from place `at`, or from wherever it is.
  std::uint32_t remember(std::uint32_t n, unsigned at) {
    for (unsigned i = 0; at == remembered && i < filled_; ++i)
      if (recent_[i] == n) at = i;
    if (at == remembered) at = filled_ < remembered ? filled_++ : remembered - 1;
    for (; at > 0; --at) recent_[at] = recent_[at - 1];
    recent_[0] = n;
    return n;
  }

  std::vector<std::uint32_t> after_;  ///< what came after each number the last time
  std::uint32_t last_ = no_index;
  std::array<std::uint32_t, remembered> recent_{};
  unsigned filled_ = 0;
  std::array<unsigned, 2> before_ = {fresh, fresh};
  BitModel guess_[outcomes][outcomes][outcomes];
};

/// Codes a permutation, each number by its distance from the one before, and one.
class NumberingCoder {
 public:
  /// A coder that decodes fills it in. False: it is none.
  template <class Coder>
  bool code(Coder& coder, std::span<std::uint32_t> numbers) {
    std::vector<bool> taken(numbers.size());
    std::uint32_t next = 0;
    for (std::uint32_t& n : numbers) {
      NumberModel& model = step_[next_was_right_];
      const std::uint32_t expected = next;
      n = code_from(coder, model, expected, n);
      if (n >= numbers.size() || taken[n]) return false;
      taken[n] = true;
      next_was_right_ = n == expected;
      next = n + 1;
    }
    return true;
  }

 private:
  bool next_was_right_ = true;
  NumberModel step_[2];
};

}  // namespace clers::internal

#endif
