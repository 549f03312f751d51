// Proposes systems from a few hundred numbers, and measures which is best.
#include "codec/attributes/find_system.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <vector>

#include "codec/attributes/system_cost.h"

namespace clers::internal {
namespace {

/// Integers: the greatest step that all differences are multiples of.
NumberSystem integer_steps(std::span<const std::uint64_t> keys) {
  NumberSystem system;
  std::uint64_t step = 0;
  for (std::size_t i = 1; i < keys.size() && step != 1; ++i) {
    const std::uint64_t key = keys[i], first = keys[0];
    const std::uint64_t d = key > first ? key - first : first - key;
    if (d != 0 && (step == 0 || d % step != 0)) step = std::gcd(step, d);
  }
  system.step = std::max<std::uint64_t>(step, 1);
  return system;
}

/// Counts by which a share of the numbers is covered.
template <std::size_t Size>
class Shares {
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
  bool any() const { return total_ > 0; }

 private:
  std::array<std::uint64_t, Size> counts_ = {};
  std::uint64_t total_ = 0;
};

/// Finds the system of floats.
template <class T>
class Finder {
 public:
  using U = WordOf<T>;
  explicit Finder(std::span<const U> words) {
    const std::size_t count = words.size();
    const std::size_t runs = count <= most_sampled ? 1 : 64;
    sample_.run = runs == 1 ? std::max<std::size_t>(count, 1) : most_sampled / runs;
    for (std::size_t r = 0; r < runs; ++r)
      for (std::size_t i = 0; i < std::min(sample_.run, count); ++i)
        sample_.words.push_back(
            words[(runs == 1 ? 0 : r * ((count - sample_.run) / (runs - 1))) + i]);
    for (std::size_t i = 0; i < count; ++i) {
      const U m = magnitude(words[i]);
      if (m < infinity) greatest_ = std::max(greatest_, m);
    }
  }

  NumberSystem find() {
    const NumberSystem words;
    best_ = words;
    least_cost_ = cost_of<T>(words, sample_);
    look_at_digits();
    propose_decimals();
    propose_binary();
    return best_;
  }

 private:
  static constexpr std::size_t most_sampled = 8192;
  static constexpr U infinity = std::bit_cast<U>(std::numeric_limits<T>::infinity());
  static constexpr unsigned no_decimals = 20;
  static constexpr std::array<std::size_t, 4> outliers = {1u << 30, 1000, 50, 6};

  void propose(NumberSystem s) {
    if (std::find(tried_.begin(), tried_.end(), s) != tried_.end()) return;
    tried_.push_back(s);
    const Cost cost = cost_of<T>(s, sample_);
    if (cost < least_cost_) {
      least_cost_ = cost;
      best_ = s;
    }
    if (!s.signed_zero && has_minus_zero_ && !has_refinements(s)) {
      s.signed_zero = true;
      propose(s);
    }
  }

  /// How many decimals and digits, and what lowest bits the numbers have.
  void look_at_digits() {
    std::vector<U> magnitudes;
    for (const U word : sample_.words) {
      const U m = magnitude(word);
      if (m == 0 && word != 0) has_minus_zero_ = true;
      if (m == 0 || m >= infinity) continue;
      magnitudes.push_back(m);
      const T v = std::bit_cast<T>(m);
      unsigned d = 0;
      std::uint64_t n = 0;
      for (; d < no_decimals; ++d) {
        const double scaled = double(v) * tens[d];
        if (!(scaled < 1e15)) d = no_decimals;
        if (d == no_decimals) break;
        n = static_cast<std::uint64_t>(nearest_integer(scaled));
        if (static_cast<T>(times_ten_to(n, -int(d))) == v) break;
      }
      decimals_.add(d);
      if (d == no_decimals) {
        digits_.add(20);
      } else {
        while (n % 10 == 0) n /= 10;
        digits_.add(decimal_digits(n));
      }
      const int lowest = lowest_bit(m);
      lowest_bits_.add(static_cast<std::size_t>(std::clamp(-lowest, 0, 60)));
      bits_.add(static_cast<std::size_t>(highest_bit(m) - lowest + 1));
    }
    std::sort(magnitudes.begin(), magnitudes.end());
    tops_ = {greatest_};
    if (!magnitudes.empty())
      tops_.push_back(magnitudes[magnitudes.size() - 1 - magnitudes.size() / 500]);
  }

  static constexpr unsigned stored = std::numeric_limits<T>::digits - 1;
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

  void propose_decimals() {
    for (const std::size_t in : outliers) {
      if (const std::size_t d = decimals_.covers_all_but_one_in(in); d < no_decimals)
        propose_quotients(integer_tens[d]);
      const std::size_t digits = digits_.covers_all_but_one_in(in);
      if (digits > DigitsMap<T>::most_digits || digits == 0) continue;
      for (const U top : tops_) {
        if (top == 0) continue;
        NumberSystem s;
        s.map = NumberMap::digits;
        s.precision = static_cast<std::uint8_t>(digits);
        // The exponent of the first digit
        const double v = double(std::bit_cast<T>(top));
        int e = -int(most_tens);
        while (e < int(most_tens) && v >= times_ten_to(1, e + 1)) ++e;
        e += 1 - static_cast<int>(digits);
        if (std::abs(e) > int(most_tens)) continue;
        s.exponent = static_cast<std::int16_t>(e);
        propose(s);
      }
    }
  }

  /// Integers over a divisor, and the steps that they have in common, but for a few.
  void propose_quotients(std::uint64_t divisor) {
    NumberSystem s;
    s.map = NumberMap::quotient;
    s.divisor = divisor;
    if (divisor > std::uint64_t(most_exact)) return;
    propose(s);
    const QuotientMap<T> map(s, Scalar::float64);
    std::vector<std::int64_t> ns;
    for (const U word : sample_.words) {
      const NumberPlace at = map.locate(word);
      if (std::abs(at.n) < most_exact && magnitude(map.word(at.n, 0)) == magnitude(word))
        ns.push_back(at.n);
    }
    // Exceptions are few, so most short parts of the sample have none.
    constexpr std::size_t parts = 32;
    std::vector<std::uint64_t> steps;
    for (std::size_t p = 0; p < parts; ++p) {
      const std::size_t begin = p * ns.size() / parts, end = (p + 1) * ns.size() / parts;
      std::uint64_t step = 0;
      for (std::size_t i = begin; i < end; ++i) step = std::gcd(step, absolute(ns[i] - ns[begin]));
      if (step > 0) steps.push_back(step);
    }
    if (steps.empty()) return;
    std::sort(steps.begin(), steps.end());
    const std::uint64_t all = std::accumulate(steps.begin(), steps.end(), std::uint64_t(0),
                                              [](auto a, auto b) { return std::gcd(a, b); });
    for (const std::uint64_t step : {all, steps[steps.size() / 2]}) {
      if (step < 2) continue;
      s.step = step;
      s.first = ns[ns.size() / 2];
      propose(s);
    }
  }

  void propose_binary() {
    for (const std::size_t in : outliers) {
      if (!bits_.any()) return;
      const std::size_t bits = bits_.covers_all_but_one_in(in);
      for (const U top : tops_) {
        if (top == 0) continue;
        NumberSystem s;
        s.map = NumberMap::binary;
        s.precision = static_cast<std::uint8_t>(std::max<std::size_t>(bits, 1));
        s.exponent = static_cast<std::int16_t>(std::max(
            highest_bit(top) + 1 - static_cast<int>(s.precision), BinaryMap<T>::least_exponent));
        propose(s);
      }
      if (const std::size_t lowest = lowest_bits_.covers_all_but_one_in(in); lowest <= 52)
        propose_quotients(std::uint64_t(1) << lowest);
    }
  }

  NumberSample<U> sample_;
  U greatest_ = 0;
  bool has_minus_zero_ = false;
  Shares<21> decimals_, digits_;
  Shares<61> lowest_bits_;
  Shares<64> bits_;
  std::vector<U> tops_;
  std::vector<NumberSystem> tried_;
  NumberSystem best_;
  Cost least_cost_ = 0;
};

}  // namespace

template <class T>
NumberSystem find_system(std::span<const WordOf<T>> words) {
  if constexpr (std::is_same_v<T, Whole>) {
    return integer_steps(words);
  } else {
    std::size_t equal = 1;
    while (equal < words.size() && words[equal] == words[0]) ++equal;
    return equal >= words.size() ? NumberSystem() : Finder<T>(words).find();
  }
}

template NumberSystem find_system<float>(std::span<const std::uint32_t>);
template NumberSystem find_system<double>(std::span<const std::uint64_t>);
template NumberSystem find_system<Whole>(std::span<const std::uint64_t>);

}  // namespace clers::internal
