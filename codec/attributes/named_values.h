// Values of any name but positions, coded along a surface: colours, weights, joints, labels,
// measurements. A value is predicted from what is known around it, the same by who encodes and who
// decodes, and what it is off is coded in contexts: how far off the values around it were, and the
// earlier components of this one.
#ifndef CLERS_CODEC_ATTRIBUTES_NAMED_VALUES_H
#define CLERS_CODEC_ATTRIBUTES_NAMED_VALUES_H

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "codec/attributes/known_values.h"
#include "codec/attributes/named_model.h"
#include "codec/attributes/named_prediction.h"
#include "codec/connectivity/coded_surface.h"
#include "codec/entropy/coder.h"
#include "codec/numbers/lattice.h"

namespace clers::internal {

/// A size in quarter octaves: 0, 1, 2, 3, 4, 5, 6, 7, 8 are 0, 1, 5, 7, 9, 10, 11, 12, 13.
inline unsigned quarter_octaves(std::uint64_t n) {
  if (n == 0) return 0;
  const unsigned octave = static_cast<unsigned>(std::bit_width(n)) - 1;
  const std::uint64_t next = octave >= 2 ? n >> (octave - 2) : n << (2 - octave);
  return 4 * octave + static_cast<unsigned>(next & 3) + 1;
}

/// Codes values with Coder, one that encodes what is in the rows or one that fills them.
///
/// The length of a residual is coded up or down from the one expected, in two contexts whose
/// probabilities are averaged: the size expected, by quarter octaves; and by octaves, with how much
/// larger than expected the earlier components of this value were.
template <class Int, class Coder>
class NamedValueCoder {
 public:
  /// `tops` of each component.
  NamedValueCoder(Coder& coder, NamedModel model, std::span<const std::uint64_t> tops,
                  std::span<Int> rows)
      : coder_(coder),
        model_(model),
        tops_(tops),
        rows_(rows),
        width_(tops.size()),
        sizes_(rows.size()),
        repeated_(rows.size() / (model.repeats == Repeats::components ? 1 : width_)) {
    std::uint64_t most = 0;
    for (const std::uint64_t top : tops) most = std::max(most, top);
    quarters_ = quarter_octaves(most) + 1;
    const std::size_t kinds = std::min(width_, kinds_of_components);
    by_quarter_.resize(kinds * quarters_);
    by_component_.resize(kinds * (quarters_ / 4 + 2) * contexts);
    mantissas_.resize(kinds);
    if (model.predictor == NamedPredictor::symbol) symbols_.resize(kinds);
  }

  /// Codes value v. False if an integer that is decoded is not in 0 .. top.
  bool code(std::uint32_t v, const Nearby& nearby) {
    if (nearby.same != Nearby::none && code_same(v, nearby.same)) return true;
    if (model_.repeats == Repeats::values && code_repeat(v, nearby)) return true;
    if (model_.predictor == NamedPredictor::symbol) return code_symbols(v);
    std::int64_t first_off = 0, sum_off = 0;
    int larger = 0;
    for (std::size_t i = 0; i < width_; ++i) {
      const bool green = model_.relation == Relation::green;
      const std::size_t c = green && i < 2 ? 1 - i : i;
      const auto top = static_cast<std::int64_t>(tops_[c]);
      if (top == 0) {
        at(v, c) = 0;
        continue;
      }
      const std::int64_t alone =
          predict_named<Int>(model_.predictor, rows_.subspan(c), width_, tops_[c], nearby);
      if (model_.repeats != Repeats::components || !code_repeat(v, c, i, nearby)) {
        std::int64_t prediction = alone;
        if (green && (i == 1 || i == 2)) prediction += first_off;
        if (model_.relation == Relation::sum && i + 1 == width_) prediction -= sum_off;
        prediction = std::clamp<std::int64_t>(prediction, 0, top);
        const unsigned expected = expect(c, nearby);
        const unsigned context =
            i == 0 ? 0 : static_cast<unsigned>(3 + std::clamp(larger / 3, -2, 2));
        const std::int64_t r =
            code_residual(c, expected, context, Coder::encodes ? at(v, c) - prediction : 0);
        if (r < -prediction || r > top - prediction) return false;
        at(v, c) = static_cast<Int>(prediction + r);
        const unsigned size = quarter_octaves(static_cast<std::uint64_t>(r < 0 ? -r : r));
        sizes_[v * width_ + c] = static_cast<std::uint8_t>(size);
        const int by = static_cast<int>(size) - static_cast<int>(expected);
        larger = i == 0 ? by : (larger + by) / 2;
      }
      const std::int64_t off = at(v, c) - alone;
      if (i == 0) first_off = off;
      sum_off = std::clamp<std::int64_t>(sum_off + off, -most_off, most_off);
    }
    return true;
  }

  /// The bytes that one takes.
  static std::uint64_t memory(std::uint64_t values, std::uint64_t components) {
    return values * (2 * components + 1) + (std::uint64_t(1) << 20);
  }

 private:
  // Components from here on share the models of the last.
  static constexpr std::size_t kinds_of_components = 6;
  static constexpr std::size_t contexts = 6;
  static constexpr std::int64_t most_off = std::int64_t(1) << 61;
  static constexpr unsigned most_length = std::bit_width(most_wide);
  static constexpr unsigned steps = 8;  // differences of lengths with contexts of their own

  struct LengthModel {
    BitModel longer[steps], shorter[steps];
  };
  struct MantissaModel {
    BitModel negative, next[most_length + 1][4];
  };
  struct SymbolModel {
    BitModel top[256];
  };

  Int& at(std::size_t v, std::size_t c) { return rows_[v * width_ + c]; }
  std::int64_t get(std::size_t v, std::size_t c) const { return rows_[v * width_ + c]; }
  std::size_t kind(std::size_t c) const { return std::min(c, kinds_of_components - 1); }

  /// The mean size of what the neighbours were off, in quarter octaves.
  unsigned expect(std::size_t c, const Nearby& n) const {
    if (n.count == 0 || model_.predictor == NamedPredictor::before)
      return n.before == Nearby::none ? quarters_ - 1 : sizes_[n.before * width_ + c];
    unsigned sum = 0;
    for (std::size_t i = 0; i < n.count; ++i) sum += sizes_[n.around[i] * width_ + c];
    return (sum + static_cast<unsigned>(n.count) / 2) / static_cast<unsigned>(n.count);
  }

  /// A decision by two models.
  bool decide(BitModel& a, BitModel& b, bool bit) {
    bit = coder_.decide((a.share() + b.share()) / 2, bit);
    a.update(bit);
    b.update(bit);
    return bit;
  }

  std::int64_t code_residual(std::size_t c, unsigned expected, unsigned context, std::int64_t r) {
    const std::size_t k = kind(c);
    const unsigned octave = std::min((expected + 3) / 4, most_length - 1);
    LengthModel& one = by_quarter_[k * quarters_ + std::min<unsigned>(expected, quarters_ - 1)];
    LengthModel& two = by_component_[(k * (quarters_ / 4 + 2) + octave) * contexts + context];
    const std::uint64_t n = static_cast<std::uint64_t>(r < 0 ? -r : r);
    const unsigned length = static_cast<unsigned>(std::bit_width(n));
    unsigned l = octave;
    if (decide(one.longer[0], two.longer[0], length > l)) {
      ++l;
      for (unsigned i = 1; l < most_length && decide(one.longer[i], two.longer[i], length > l); ++l)
        i = std::min(i + 1, steps - 1);
    } else {
      for (unsigned i = 0; l > 0 && decide(one.shorter[i], two.shorter[i], length < l); --l)
        i = std::min(i + 1, steps - 1);
    }
    if (l == 0) return 0;
    // The highest bit is 1; the next two depend on the length.
    MantissaModel& m = mantissas_[k];
    std::uint64_t magnitude = 1;
    unsigned rest = l - 1;
    for (unsigned i = 0; i < 2 && rest > 0; ++i) {
      --rest;
      magnitude = 2 * magnitude | coder_.bit(m.next[l][magnitude], n >> rest & 1);
    }
    magnitude = code_raw(rest, n, magnitude);
    const auto positive = static_cast<std::int64_t>(magnitude);
    return coder_.bit(m.negative, r < 0) ? -positive : positive;
  }

  bool code_symbols(std::uint32_t v) {
    for (std::size_t c = 0; c < width_; ++c) {
      const std::uint64_t x =
          code_symbol(c, Coder::encodes ? static_cast<std::uint64_t>(get(v, c)) : 0);
      if (x > tops_[c]) return false;
      at(v, c) = static_cast<Int>(x);
    }
    return true;
  }

  /// The upper eight bits each in the context of those above it, the others raw.
  std::uint64_t code_symbol(std::size_t c, std::uint64_t x) {
    SymbolModel& model = symbols_[kind(c)];
    unsigned bits = static_cast<unsigned>(std::bit_width(tops_[c]));
    std::size_t node = 1;
    std::uint64_t result = 0;
    while (bits > 0 && node < 256) {
      const bool bit = coder_.bit(model.top[node], x >> --bits & 1);
      node = 2 * node + bit;
      result = 2 * result + bit;
    }
    return code_raw(bits, x, result);
  }

  /// Appends the lowest bits of n to those that are known.
  std::uint64_t code_raw(unsigned bits, std::uint64_t n, std::uint64_t known) {
    while (bits > 0) {
      const unsigned part = std::min(bits, 14u);
      bits -= part;
      const auto mask = static_cast<std::uint32_t>((1u << part) - 1);
      known = known << part | coder_.raw(part, static_cast<std::uint32_t>(n >> bits) & mask);
    }
    return known;
  }

  bool same(std::size_t v, std::size_t u) const {
    const auto row = rows_.begin() + static_cast<std::ptrdiff_t>(width_ * v);
    return std::equal(row, row + static_cast<std::ptrdiff_t>(width_),
                      rows_.begin() + static_cast<std::ptrdiff_t>(width_ * u));
  }

  /// Whether the value is that which was coded last at its vertex.
  bool code_same(std::uint32_t v, std::uint32_t u) {
    const bool is_same = coder_.bit(same_[last_same_], Coder::encodes && same(v, u));
    last_same_ = (2 * last_same_ + is_same) % 4;
    if (!is_same) return false;
    for (std::size_t c = 0; c < width_; ++c) {
      at(v, c) = at(u, c);
      sizes_[v * width_ + c] = sizes_[u * width_ + c];
    }
    const std::size_t n = repeated_.size() * width_ / rows_.size();  // 1, or one a component
    for (std::size_t i = 0; i < n; ++i) repeated_[v * n + i] = repeated_[u * n + i];
    return true;
  }

  /// Whether the value is one of those around it, and which.
  bool code_repeat(std::uint32_t v, const Nearby& n) {
    std::array<std::uint32_t, 4> different;
    std::size_t count = 0;
    unsigned lately = 0;
    const auto offer = [&](std::uint32_t u) {
      for (std::size_t i = 0; i < count; ++i)
        if (same(different[i], u)) return;
      if (count < different.size()) different[count++] = u;
    };
    for (std::size_t i = 0; i < n.count; ++i) {
      offer(n.around[i]);
      lately += repeated_[n.around[i]];
    }
    const std::size_t all = std::max<std::size_t>(n.count, 1);
    if (n.count == 0 && n.before != Nearby::none) {
      offer(n.before);
      lately = repeated_[n.before];
    }
    const std::size_t context = 3 * lately / all;
    const bool before = n.before != Nearby::none && repeated_[n.before];
    for (std::size_t i = 0; i < count; ++i) {
      BitModel& m = repeat_[before][context][count - 1][i];
      if (!coder_.bit(m, Coder::encodes && same(v, different[i]))) continue;
      if (!Coder::encodes)
        for (std::size_t c = 0; c < width_; ++c) at(v, c) = at(different[i], c);
      repeated_[v] = 1;
      return true;
    }
    return false;
  }

  /// The same for component c, the i-th that is coded.
  bool code_repeat(std::uint32_t v, std::size_t c, std::size_t i, const Nearby& n) {
    std::array<std::int64_t, 3> different;
    std::size_t count = 0;
    unsigned lately = 0;
    for (std::size_t k = 0; k < n.count; ++k) {
      const std::int64_t x = get(n.around[k], c);
      const auto end = different.begin() + static_cast<std::ptrdiff_t>(count);
      if (count < different.size() && std::find(different.begin(), end, x) == end)
        different[count++] = x;
      lately += repeated_[n.around[k] * width_ + c];
    }
    if (count == 0) return false;
    // How many around were, whether most of them are alike, and which components before were.
    const std::size_t share = (3 * lately + n.count - 1) / n.count;
    const bool alike = n.count > count + 2;
    std::size_t earlier = n.count > 2 ? 4 : 0;
    for (std::size_t k = 0; k < std::min<std::size_t>(i, 2); ++k)
      earlier += std::size_t(repeated_[v * width_ + k]) << k;
    for (std::size_t k = 0; k < count; ++k) {
      BitModel& m = component_repeat_[std::min<std::size_t>(c, 3)][alike][share][earlier][k];
      if (!coder_.bit(m, Coder::encodes && get(v, c) == different[k])) continue;
      at(v, c) = static_cast<Int>(different[k]);
      repeated_[v * width_ + c] = 1;
      return true;
    }
    return false;
  }

  Coder& coder_;
  const NamedModel model_;
  const std::span<const std::uint64_t> tops_;
  const std::span<Int> rows_;
  const std::size_t width_;
  unsigned quarters_ = 0;
  std::vector<std::uint8_t> sizes_;     // of what was off, in quarter octaves, a component each
  std::vector<std::uint8_t> repeated_;  // a value each, or a component
  std::vector<LengthModel> by_quarter_, by_component_;
  std::vector<MantissaModel> mantissas_;
  std::vector<SymbolModel> symbols_;
  BitModel same_[4];
  unsigned last_same_ = 3;
  BitModel repeat_[2][4][4][4], component_repeat_[4][2][4][8][3];
};

}  // namespace clers::internal

#endif
