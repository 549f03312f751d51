// Some of many floats, and what can be seen of them: how many digits and bits they have.
#ifndef CLERS_CODEC_NUMBERS_NUMBER_SAMPLE_H
#define CLERS_CODEC_NUMBERS_NUMBER_SAMPLE_H

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "codec/numbers/floating_maps.h"

namespace clers::internal {

/// The words of numbers, in runs of neighbours.
template <class U>
struct NumberSample {
  std::vector<U> words;
  std::size_t run;  ///< so many are neighbours
};

/// Takes runs at even distances; all words if they are at most runs * run.
template <class U>
NumberSample<U> sample_of(std::span<const U> words, std::size_t runs, std::size_t run) {
  if (words.size() <= runs * run)
    return {{words.begin(), words.end()}, std::max<std::size_t>(words.size(), 1)};
  NumberSample<U> sample = {{}, run};
  const std::size_t apart = (words.size() - run) / (runs - 1);
  for (std::size_t r = 0; r < runs; ++r)
    for (std::size_t i = 0; i < run; ++i) sample.words.push_back(words[r * apart + i]);
  return sample;
}

/// How often 0 .. Size - 1 occurs.
template <std::size_t Size>
class Histogram {
 public:
  void add(std::size_t i) { ++counts_[std::min(i, Size - 1)], ++total_; }
  /// The least i so that at most one of `in` is above it.
  std::size_t covers_all_but_one_in(std::size_t in) const {
    std::uint64_t above = total_;
    std::size_t i = 0;
    for (; i + 1 < Size; ++i)
      if ((above -= counts_[i]) * in <= total_) break;
    return i;
  }

 private:
  std::array<std::uint64_t, Size> counts_ = {};
  std::uint64_t total_ = 0;
};

/// What is seen of a sample of floats of type T.
template <class T>
struct SampleLooks {
  using U = WordOf<T>;
  static constexpr U infinity = std::bit_cast<U>(std::numeric_limits<T>::infinity());
  static constexpr unsigned stored = std::numeric_limits<T>::digits - 1;
  static constexpr unsigned no_decimals = 20;

  /// Exponents of the lowest and the highest bit of a magnitude that is not 0.
  static int lowest_bit(U m) {
    const auto field = static_cast<int>(m >> stored);
    const U mantissa = static_cast<U>((m & ((U(1) << stored) - 1)) | U(field > 0) << stored);
    return BinaryMap<T>::least_exponent + std::max(field - 1, 0) + std::countr_zero(mantissa);
  }
  static int highest_bit(U m) {
    const auto field = static_cast<int>(m >> stored);
    if (field == 0) return BinaryMap<T>::least_exponent + static_cast<int>(std::bit_width(m)) - 1;
    return BinaryMap<T>::least_exponent + field - 1 + static_cast<int>(stored);
  }

  explicit SampleLooks(const std::vector<U>& words) {
    std::vector<U> magnitudes;
    const std::size_t some = 1 + words.size() / 1024;
    for (std::size_t i = 0; i < words.size(); ++i) {
      const U word = words[i], m = magnitude(word);
      if (m < infinity && i % some == 0) sorted.push_back(double(std::bit_cast<T>(word)));
      if (m == 0 && word != 0) minus_zero = true;
      if (m == 0 || m >= infinity) continue;
      magnitudes.push_back(m);
      add_decimal(m);
      const int lowest = lowest_bit(m);
      lowest_bits.add(static_cast<std::size_t>(std::clamp(-lowest, 0, 60)));
      bits.add(static_cast<std::size_t>(highest_bit(m) - lowest + 1));
    }
    std::sort(sorted.begin(), sorted.end());
    if (magnitudes.empty()) return;
    std::sort(magnitudes.begin(), magnitudes.end());
    top = magnitudes[magnitudes.size() - 1 - magnitudes.size() / 500];
  }

  std::vector<double> sorted;                   ///< about a thousand finite ones
  U top = 0;                                    ///< the greatest magnitude but for a few
  bool minus_zero = false;                      ///< whether -0.0 is among them
  Histogram<no_decimals + 1> decimals, digits;  ///< of all but 0
  Histogram<61> lowest_bits;                    ///< how far behind the point they are
  Histogram<64> bits;                           ///< from the highest to the lowest

 private:
  void add_decimal(U m) {
    const double v = double(std::bit_cast<T>(m));
    // No integer that is further away is rounded to the number: to be sure, two units of T.
    const double unit = std::ldexp(1., m >> stored > 0 ? 1 - static_cast<int>(stored) : 0);
    for (unsigned d = 0; d < no_decimals && v * tens[d] < 1e15; ++d) {
      const double shifted = v * tens[d];
      auto n = static_cast<std::uint64_t>(nearest_integer(shifted));
      if (std::fabs(shifted - static_cast<double>(static_cast<std::int64_t>(n))) > shifted * unit)
        continue;
      if (std::bit_cast<U>(static_cast<T>(times_ten_to(n, -static_cast<int>(d)))) != m) continue;
      while (n % 10 == 0) n /= 10;
      decimals.add(d);
      digits.add(decimal_digits(n));
      return;
    }
    decimals.add(no_decimals);
    digits.add(no_decimals);
  }
};

}  // namespace clers::internal

#endif
