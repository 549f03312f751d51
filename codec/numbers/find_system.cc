// Proposes systems from a few hundred numbers, and measures which is best.
#include "codec/numbers/find_system.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <vector>

#include "codec/numbers/approximate_steps.h"
#include "codec/numbers/float_steps.h"
#include "codec/numbers/number_sample.h"
#include "codec/numbers/system_cost.h"

namespace clers::internal {
namespace {

/// The greatest common divisor, which mostly is the step already.
std::uint64_t common_step(std::uint64_t step, std::uint64_t d) {
  return step != 0 && d % step == 0 ? step : std::gcd(step, d);
}

/// Integers: the greatest step that all differences are multiples of.
NumberSystem integer_steps(std::span<const std::uint64_t> keys) {
  NumberSystem system;
  std::uint64_t step = 0;
  for (std::size_t i = 1; i < keys.size() && step != 1; ++i) {
    const std::uint64_t key = keys[i], first = keys[0];
    step = common_step(step, key > first ? key - first : first - key);
  }
  system.step = std::max<std::uint64_t>(step, 1);
  return system;
}

/// Finds the system of floats.
template <class T>
class Finder {
 public:
  using U = WordOf<T>;
  Finder(std::span<const U> words, Search search)
      : sample_(search == Search::quick ? sample_of(words, 16, 32) : sample_of(words, 64, 64)),
        few_(search == Search::quick ? sample_of(std::span<const U>(sample_.words), 8, 16)
                                     : sample_of(std::span<const U>(sample_.words), 16, 32)),
        looks_(sample_.words) {
    U greatest = 0;
    for (const U word : words) {
      if (magnitude(word) >= Looks::infinity) continue;
      greatest = std::max(greatest, magnitude(word));
      least_ = std::min(least_, std::bit_cast<T>(word));
    }
    tops_ = {greatest, looks_.top};
  }

  /// The best; and, if wanted, the best without strays.
  std::vector<NumberSystem> find(bool both) {
    propose(NumberSystem());
    if (looks_.top > 0) {
      propose_decimals();
      propose_binary();
      propose_noisy();
    }
    std::stable_sort(proposed_.begin(), proposed_.end(),
                     [](const Proposal& a, const Proposal& b) { return a.cost < b.cost; });
    NumberSystem best;
    Cost least = ~Cost(0);
    for (const Proposal& p : std::span(proposed_).first(std::min(proposed_.size(), finalists))) {
      Cost cost = cost_of<T>(p.system, sample_, least);
      // Words are no lengths, which predictions may know more of than the number before tells.
      if (p.system.map == NumberMap::word) cost += cost / 16;
      if (cost >= least) continue;
      least = cost;
      best = p.system;
    }
    if (!both || has_all(best)) return {best};
    std::optional<NumberSystem> second;
    least = ~Cost(0);
    for (const Proposal& p : proposed_) {
      if (!has_all(p.system)) continue;
      const Cost cost = cost_of<T>(p.system, sample_, least);
      if (cost >= least) continue;
      least = cost;
      second = p.system;
    }
    if (!second) return {best};
    return {best, *second};
  }

 private:
  using Looks = SampleLooks<T>;
  struct Proposal {
    NumberSystem system;
    Cost cost;
  };
  static constexpr std::size_t finalists = 5;
  static constexpr std::array<std::size_t, 4> outliers = {1u << 30, 1000, 50, 6};

  /// Measures a system by a few numbers.
  void propose(NumberSystem s) {
    if (std::any_of(proposed_.begin(), proposed_.end(),
                    [&](const Proposal& p) { return p.system == s; }))
      return;
    proposed_.push_back({s, cost_of<T>(s, few_, limit())});
    if (!s.signed_zero && looks_.minus_zero && !has_refinements(s) && s.map != NumberMap::word) {
      s.signed_zero = true;
      propose(s);
    }
  }

  /// Whether none of the sample is a stray.
  bool has_all(const NumberSystem& s) const {
    return with_map<T>(s, Scalar::float64, [&](const auto& map) {
      const Placing<T, std::decay_t<decltype(map)>> placing(s, map);
      return std::all_of(sample_.words.begin(), sample_.words.end(),
                         [&](const U word) { return placing.place(word).exact; });
    });
  }

  /// What a system may cost to be among the finalists yet.
  Cost limit() {
    if (proposed_.size() < finalists) return ~Cost(0);
    std::vector<Cost>& costs = costs_;
    costs.clear();
    for (const Proposal& p : proposed_) costs.push_back(p.cost);
    std::nth_element(costs.begin(), costs.begin() + (finalists - 1), costs.end());
    return costs[finalists - 1];
  }

  void propose_decimals() {
    for (const std::size_t in : outliers) {
      if (const std::size_t d = looks_.decimals.covers_all_but_one_in(in); d < Looks::no_decimals)
        propose_quotients(integer_tens[d]);
      const std::size_t digits = looks_.digits.covers_all_but_one_in(in);
      if (digits > DigitsMap<T>::most_digits || digits == 0) continue;
      for (const U top : tops_) {
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
    if (std::find(divisors_.begin(), divisors_.end(), divisor) != divisors_.end()) return;
    divisors_.push_back(divisor);
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
      for (std::size_t i = begin; i < end && step != 1; ++i)
        step = common_step(step, absolute(ns[i] - ns[begin]));
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
      const std::size_t bits = looks_.bits.covers_all_but_one_in(in);
      for (const U top : tops_) {
        NumberSystem s;
        s.map = NumberMap::binary;
        s.precision = static_cast<std::uint8_t>(std::max<std::size_t>(bits, 1));
        s.exponent = static_cast<std::int16_t>(
            std::max(Looks::highest_bit(top) + 1 - static_cast<int>(s.precision),
                     BinaryMap<T>::least_exponent));
        propose(s);
      }
      if (const std::size_t lowest = looks_.lowest_bits.covers_all_but_one_in(in); lowest <= 52)
        propose_quotients(std::uint64_t(1) << lowest);
    }
  }

  /// Decimals and steps that a calculation has left some ulps beside, or a printer some digits.
  void propose_noisy() {
    const double top = double(std::bit_cast<T>(looks_.top));
    const double ulp =
        std::ldexp(1., Looks::highest_bit(looks_.top) - static_cast<int>(Looks::stored));
    for (unsigned d = 0; d < 10 && 1 / tens[d] > 16 * ulp; ++d) {
      NumberSystem s;
      s.map = NumberMap::quotient;
      s.divisor = integer_tens[d];
      propose_with_ulps(s);
    }
    if (const auto steps = approximate_steps(looks_.sorted, 4 * ulp)) propose_steps(*steps);
    std::size_t digits = 0, decimals = Looks::no_decimals;
    for (const std::size_t in : outliers) {
      const std::size_t last_digits = digits, last_decimals = decimals;
      digits = looks_.digits.covers_all_but_one_in(in);
      decimals = looks_.decimals.covers_all_but_one_in(in);
      if (digits <= PrintedMap<T>::most_digits && digits > 0 && digits != last_digits) {
        int e = 0;  // of the unit of the last digit
        while (e < int(most_tens) && top * tens[static_cast<unsigned>(e)] < tens[digits - 1]) ++e;
        propose_printed(1 / tens[static_cast<unsigned>(e)], digits, false);
      }
      if (decimals <= PrintedMap<T>::most_decimals && decimals != last_decimals)
        propose_printed(1 / tens[decimals], decimals, true);
    }
  }

  /// A system whose numbers are off by as many ulps as nearly all of the sample.
  void propose_with_ulps(NumberSystem s) {
    with_map<T>(s, Scalar::float64, [&](const auto& map) {
      if constexpr (!std::decay_t<decltype(map)>::has_choices) {
        Histogram<256> off;
        constexpr std::size_t most_ulps = 16, most_in = 20;
        std::size_t too_far = 0;
        const std::int64_t most = most_integer<T>(s);
        for (const U word : sample_.words) {
          const std::int64_t k = nearest_step(s, std::clamp(map.locate(word).n, -most, most));
          const std::int64_t n =
              std::clamp(s.first + k * static_cast<std::int64_t>(s.step), -most, most);
          const U d = zigzag(static_cast<U>(key_of<T>(word) - key_of<T>(map.word(n, 0))));
          const std::uint64_t ulps = (std::uint64_t(d) + 1) / 2;
          too_far += ulps > most_ulps;
          if (too_far * most_in > sample_.words.size()) return;
          off.add(static_cast<std::size_t>(std::min<std::uint64_t>(ulps, 255)));
        }
        for (const std::size_t in : {std::size_t(200), most_in}) {
          s.ulps = static_cast<std::uint8_t>(off.covers_all_but_one_in(in));
          if (s.ulps <= most_ulps) propose(s);
        }
      }
    });
  }

  void propose_steps(const ApproximateSteps& steps) {
    if (const auto quotients = quotients_of(steps)) propose_with_ulps(*quotients);
    NumberSystem s;
    s.map = NumberMap::affine;
    s.origin = steps.origin;
    s.length = steps.length;
    if (fault_of_map<T>(s).empty()) propose_with_ulps(s);
    if constexpr (std::is_same_v<T, float>) {
      std::vector<float> numbers;
      for (const double v : looks_.sorted) numbers.push_back(static_cast<float>(v));
      const auto in_floats = float_steps(std::move(numbers), least_, steps.length);
      if (in_floats && fault_of_map<T>(*in_floats).empty()) propose(*in_floats);
    }
  }

  void propose_printed(double unit, std::size_t precision, bool decimals) {
    const auto steps = approximate_steps(looks_.sorted, unit);
    if (!steps) return;
    auto s = quotients_of(*steps);
    if (!s) return;
    s->map = NumberMap::printed;
    s->precision = static_cast<std::uint8_t>(precision);
    s->decimals = decimals;
    propose(*s);
  }

  /// Steps of 1 / D, or of few decimals, that begin at a simple part of a step.
  std::optional<NumberSystem> quotients_of(const ApproximateSteps& steps) const {
    if (auto s = quotients_of(steps, std::floor(1 / steps.length + .5), 1)) return s;
    for (unsigned d = 0; d < 10; ++d)
      if (auto s = quotients_of(steps, tens[d], std::floor(steps.length * tens[d] + .5))) return s;
    return std::nullopt;
  }
  std::optional<NumberSystem> quotients_of(const ApproximateSteps& steps, double divisor,
                                           double step) const {
    const auto& numbers = looks_.sorted;
    if (divisor < 1 || divisor > 1e9 || step < 1 || step > 1e6) return std::nullopt;
    const double farthest = std::max(std::fabs(numbers.front()), std::fabs(numbers.back()));
    if (!(farthest * divisor * 16 < double(most_exact))) return std::nullopt;
    if (std::fabs(steps.length - step / divisor) > 2 * steps.error + 1e-15) return std::nullopt;
    // Where in a step numbers are, from where one of them is
    const auto part = [&](double v) {
      const double in_steps = v * divisor / step;
      return in_steps - std::floor(in_steps);
    };
    const double about = part(numbers[numbers.size() / 2]);
    double sum = 0;
    for (const double v : numbers) {
      const double d = part(v) - about;
      sum += d - std::floor(d + .5);
    }
    const double begin = step * (about + sum / double(numbers.size()));
    NumberSystem s;
    s.map = NumberMap::quotient;
    for (unsigned parts = 1; parts <= 16; ++parts) {
      const double first = std::floor(begin * parts + .5);
      if (std::fabs(begin - first / parts) > steps.noise * divisor / 4 + 1e-9) continue;
      s.divisor = static_cast<std::uint64_t>(divisor) * parts;
      s.step = static_cast<std::uint64_t>(step) * parts;
      s.first = static_cast<std::int64_t>(first);
      return s;
    }
    return std::nullopt;
  }

  NumberSample<U> sample_, few_;
  Looks looks_;
  T least_ = std::numeric_limits<T>::max();  ///< of all
  std::array<U, 2> tops_;                    ///< the greatest magnitude of all, and but for a few
  std::vector<Proposal> proposed_;
  std::vector<Cost> costs_;
  std::vector<std::uint64_t> divisors_;  ///< for which quotients were proposed
};

template <class T>
std::vector<NumberSystem> find(std::span<const WordOf<T>> words, Search search, bool both) {
  if constexpr (std::is_same_v<T, Whole>) {
    return {integer_steps(words)};
  } else {
    std::size_t equal = 1;
    while (equal < words.size() && words[equal] == words[0]) ++equal;
    if (equal >= words.size()) return {NumberSystem()};
    return Finder<T>(words, search).find(both);
  }
}

}  // namespace

template <class T>
NumberSystem find_system(std::span<const WordOf<T>> words, Search search) {
  return find<T>(words, search, false).front();
}
template <class T>
std::vector<NumberSystem> find_systems(std::span<const WordOf<T>> words, Search search) {
  return find<T>(words, search, true);
}

template NumberSystem find_system<float>(std::span<const std::uint32_t>, Search);
template NumberSystem find_system<double>(std::span<const std::uint64_t>, Search);
template NumberSystem find_system<Whole>(std::span<const std::uint64_t>, Search);
template std::vector<NumberSystem> find_systems<float>(std::span<const std::uint32_t>, Search);
template std::vector<NumberSystem> find_systems<double>(std::span<const std::uint64_t>, Search);
template std::vector<NumberSystem> find_systems<Whole>(std::span<const std::uint64_t>, Search);

}  // namespace clers::internal
