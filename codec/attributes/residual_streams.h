// Rows of residuals <-> bytes: each component a stream of its own, by static shares of classes. It
// knows neither the surface nor values, so that it can run while connectivity is decoded.
#ifndef CLERS_CODEC_ATTRIBUTES_RESIDUAL_STREAMS_H
#define CLERS_CODEC_ATTRIBUTES_RESIDUAL_STREAMS_H

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "codec/attributes/lattice.h"
#include "codec/attributes/residual_classes.h"
#include "codec/entropy/bytes.h"
#include "codec/entropy/reversed_bits.h"
#include "codec/entropy/shares.h"
#include "codec/entropy/stream.h"
#include "codec/entropy/tabled_ans.h"
#include "codec/error.h"

namespace clers::internal {

/// How fine shares are. The numbers stand before the streams.
struct SharePrecision {
  unsigned log = 11;         ///< shares are of 2^log, 9 .. tans::most_log
  unsigned significant = 3;  ///< bits of a weight, 1 .. 4
};

/// No residual of values in 0 .. top has a class from this on.
inline unsigned classes_below(std::uint64_t top) {
  return class_of(-static_cast<std::int64_t>(2 * top)) + 1;
}

/// Up to this many components are coded side by side: each waits for itself alone.
inline constexpr std::size_t abreast = 3;

/// Weights <-> decisions, for one component after the other. Each but the first says whether it has
/// those of the one before.
class ComponentWeights {
 public:
  template <class Coder>
  void code(Coder& coder, unsigned significant, Weights& weights) {
    if (!before_.empty() && coder.bit(as_before_, weights == before_)) {
      weights = before_;
      return;
    }
    model_.code(coder, significant, weights);
    before_ = weights;
  }

 private:
  BitModel as_before_;
  WeightsModel model_;
  Weights before_;
};

/// Whether a component with these weights has no stream: all its residuals are 0.
inline bool all_zero(const Weights& weights) {
  return weights.size() == 1;
}

/// Writes components of rows, last row first: a stream each. `classes` are those of the residuals,
/// `raw` the number of all their raw bits.
template <class Int, std::size_t n>
void encode_abreast(std::span<const Int> residuals, std::span<const std::uint8_t> classes,
                    std::size_t components, const std::array<std::size_t, n>& which,
                    const std::array<Shares, n>& shares, const std::array<std::uint64_t, n>& raw,
                    Bytes& out) {
  static constexpr std::array<Int, residual_classes> least = least_residuals<Int>();
  using U = std::make_unsigned_t<Int>;
  const std::size_t count = residuals.size() / components;
  std::array<Bytes, n> memory;
  std::vector<tans::EncodeTable<Int>> tables;
  std::array<const tans::Step<Int>*, n> steps;
  std::array<const std::uint16_t*, n> next;
  std::array<ReversedBitWriter, n> writers;
  std::array<std::uint32_t, n> states;
  tables.reserve(n);
  for (std::size_t i = 0; i < n; ++i) {
    const tans::EncodeTable<Int>& table = tables.emplace_back(shares[i], least, raw_bits);
    steps[i] = table.steps();
    next[i] = table.next();
    memory[i].resize(
        ReversedBitWriter::room(raw[i] + shares[i].log * (std::uint64_t(count) + 1) + 8));
    writers[i] = ReversedBitWriter(memory[i]);
    states[i] = 1u << shares[i].log;
  }
  for (std::size_t row = count; row-- > 0;)
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t at = row * components + which[i];
      const tans::Step<Int>& step = steps[i][classes[at]];
      const std::uint32_t state = states[i];
      const unsigned bits = (state + step.bits) >> 16;
      states[i] = next[i][static_cast<std::ptrdiff_t>(state >> bits) + std::ptrdiff_t(step.begin)];
      const std::uint64_t mantissa =
          static_cast<U>(static_cast<U>(residuals[at]) - static_cast<U>(step.least));
      if (sizeof(Int) > 4 && step.raw > 44) {
        writers[i].put(mantissa >> 32, step.raw - 32);
        writers[i].put(low_bits(mantissa, 32) << bits | low_bits(state, bits), 32 + bits);
      } else {
        writers[i].put(mantissa << bits | low_bits(state, bits), step.raw + bits);
      }
    }
  for (std::size_t i = 0; i < n; ++i) {
    writers[i].put(low_bits(states[i], shares[i].log), shares[i].log);
    const std::span<const std::byte> stream = writers[i].finish();
    put_varint(out, stream.size());
    put_bytes(out, stream);
  }
}

/// Undoes it. False: the bytes do not end with the last row.
template <class Int, std::size_t n>
bool decode_abreast(const std::array<std::span<const std::byte>, n>& bytes,
                    const std::array<Shares, n>& shares, std::size_t components,
                    const std::array<std::size_t, n>& which, std::span<Int> residuals) {
  static constexpr std::array<Int, residual_classes> least = least_residuals<Int>();
  using U = std::make_unsigned_t<Int>;
  std::vector<tans::DecodeTable<Int>> tables;
  std::array<const tans::Entry<Int>*, n> entries;
  std::array<ReversedBitReader, n> readers;
  std::array<std::uint32_t, n> states;
  tables.reserve(n);
  for (std::size_t i = 0; i < n; ++i) {
    entries[i] = tables.emplace_back(shares[i], least, raw_bits).entries();
    readers[i] = ReversedBitReader(bytes[i]);
    states[i] = static_cast<std::uint32_t>(low_bits(readers[i].window(), shares[i].log));
    readers[i].take(shares[i].log);
  }
  // Works on copies of what changes, so that they can stay in registers.
  const auto decode = [&](Int* row, std::size_t rows, auto window_of) {
    std::array<ReversedBitReader, n> in = readers;
    std::array<std::uint32_t, n> state = states;
    for (; rows > 0; --rows, row += components)
      for (std::size_t i = 0; i < n; ++i) {
        const tans::Entry<Int>& entry = entries[i][state[i]];
        const std::uint64_t window = window_of(in[i]);
        state[i] = entry.base + static_cast<std::uint32_t>(low_bits(window, entry.bits));
        std::uint64_t mantissa;
        if (sizeof(Int) > 4 && entry.with_raw > 56) {
          const unsigned raw = entry.with_raw - entry.bits;
          mantissa = low_bits(window >> entry.bits, 32);
          in[i].take(entry.bits + 32);
          mantissa |= low_bits(window_of(in[i]), raw - 32) << 32;
          in[i].take(raw - 32);
        } else {
          mantissa = low_bits(window, entry.with_raw) >> entry.bits;
          in[i].take(entry.with_raw);
        }
        row[which[i]] = static_cast<Int>(static_cast<U>(entry.least) + static_cast<U>(mantissa));
      }
    readers = in;
    states = state;
  };
  constexpr std::uint64_t most_bits = sizeof(Int) > 4 ? 72 : 41;
  Int* row = residuals.data();
  for (std::size_t rows = residuals.size() / components; rows > 0;) {
    std::uint64_t within = rows;
    for (const ReversedBitReader& in : readers) within = std::min(within, in.within() / most_bits);
    const std::size_t some = within > 0 ? static_cast<std::size_t>(within) : 1;
    if (within > 0)
      decode(row, some, [](const ReversedBitReader& in) { return in.window_within(); });
    else
      decode(row, some, [](const ReversedBitReader& in) { return in.window(); });
    row += some * components;
    rows -= some;
  }
  bool finished = true;
  for (std::size_t i = 0; i < n; ++i) finished &= readers[i].finished() && states[i] == 0;
  return finished;
}

}  // namespace clers::internal

#endif
