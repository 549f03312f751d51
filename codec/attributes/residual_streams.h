// Rows of residuals <-> bytes: each component a stream of its own, by static shares of classes. It
// knows neither the surface nor values, so that it can run while connectivity is decoded.
#ifndef CLERS_CODEC_ATTRIBUTES_RESIDUAL_STREAMS_H
#define CLERS_CODEC_ATTRIBUTES_RESIDUAL_STREAMS_H

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "codec/attributes/residual_classes.h"
#include "codec/entropy/bytes.h"
#include "codec/entropy/reversed_bits.h"
#include "codec/entropy/shares.h"
#include "codec/entropy/stream.h"
#include "codec/entropy/tabled_ans.h"
#include "codec/error.h"
#include "codec/numbers/lattice.h"

namespace clers::internal {

/// No residual of values in 0 .. top has a class from this on.
inline unsigned classes_below(std::uint64_t top) {
  return class_of(-static_cast<std::int64_t>(2 * top)) + 1;
}

/// Up to this many components are coded side by side: each waits for itself alone.
inline constexpr std::size_t abreast = 3;

/// Blocks of so many rows have a choice of shares.
inline constexpr std::size_t rows_in_block = 64;

/// What residuals are coded with.
struct ShareSets {
  unsigned log = 10;         ///< shares are of 2^log, least_log .. tans::most_log
  unsigned significant = 3;  ///< bits of a weight, 1 .. 4
  /// One set of weights, or two; in each those of all components. Those of components that are not
  /// coded are empty.
  std::vector<std::vector<Weights>> sets;
  std::vector<std::uint8_t> set_of;  ///< of each block, if there are two

  static constexpr unsigned least_log = 9;

  /// Weights and sets <-> decisions, of components `coded`. Each component but the first says
  /// whether it has the weights of the one before.
  template <class Coder>
  void code(Coder& coder, std::span<const std::size_t> coded) {
    BitModel as_before;
    WeightsModel model;
    const Weights* before = nullptr;
    for (std::vector<Weights>& set : sets)
      for (const std::size_t c : coded) {
        if (before != nullptr && coder.bit(as_before, set[c] == *before))
          set[c] = *before;
        else
          model.code(coder, significant, set[c]);
        before = &set[c];
      }
    std::array<BitModel, 2> second;
    bool last = false;
    for (std::uint8_t& set : set_of) {
      last = coder.bit(second[last], set != 0);
      set = last;
    }
  }

  /// Whether a component has no stream: all its residuals are 0.
  bool all_zero(std::size_t component) const {
    return std::all_of(sets.begin(), sets.end(),
                       [&](const auto& set) { return set[component].size() == 1; });
  }
};

/// Writes components of rows, last row first: a stream each. `classes` are those of the residuals,
/// `raw` the number of all their raw bits.
template <class Int, std::size_t n>
void encode_abreast(std::span<const Int> residuals, std::span<const std::uint8_t> classes,
                    std::size_t components, const std::array<std::size_t, n>& which,
                    const ShareSets& model, const std::array<std::uint64_t, n>& raw, Bytes& out) {
  static constexpr std::array<Int, residual_classes> least = least_residuals<Int>();
  using U = std::make_unsigned_t<Int>;
  const std::size_t count = residuals.size() / components;
  std::array<Bytes, n> memory;
  std::vector<std::array<std::unique_ptr<tans::EncodeTable<Int>>, n>> tables(model.sets.size());
  std::array<ReversedBitWriter, n> writers;
  std::array<std::uint32_t, n> states;
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t s = 0; s < tables.size(); ++s)
      tables[s][i] = std::make_unique<tans::EncodeTable<Int>>(
          shares_of(model.sets[s][which[i]], model.log), least, raw_bits);
    memory[i].resize(ReversedBitWriter::room(raw[i] + model.log * (std::uint64_t(count) + 1) + 8));
    writers[i] = ReversedBitWriter(memory[i]);
    states[i] = 1u << model.log;
  }
  const auto encode = [&](std::size_t begin, std::size_t end, std::size_t set) {
    std::array<const tans::Step<Int>*, n> steps;
    std::array<const std::uint16_t*, n> next;
    for (std::size_t i = 0; i < n; ++i) {
      steps[i] = tables[set][i]->steps();
      next[i] = tables[set][i]->next();
    }
    // Copies of what changes, so that they can stay in registers.
    std::array<ReversedBitWriter, n> to = writers;
    std::array<std::uint32_t, n> state = states;
    for (std::size_t row = end; row-- > begin;)
      for (std::size_t i = 0; i < n; ++i) {
        const std::size_t at = row * components + which[i];
        const tans::Step<Int>& step = steps[i][classes[at]];
        const std::uint32_t behind = state[i];
        const unsigned bits = (behind + step.bits) >> 16;
        state[i] =
            next[i][static_cast<std::ptrdiff_t>(behind >> bits) + std::ptrdiff_t(step.begin)];
        const std::uint64_t mantissa =
            static_cast<U>(static_cast<U>(residuals[at]) - static_cast<U>(step.least));
        if (sizeof(Int) > 4 && step.raw > 44) {
          to[i].put(mantissa >> 32, step.raw - 32);
          to[i].put(low_bits(mantissa, 32) << bits | low_bits(behind, bits), 32 + bits);
        } else {
          to[i].put(mantissa << bits | low_bits(behind, bits), step.raw + bits);
        }
      }
    writers = to;
    states = state;
  };
  if (model.set_of.empty()) {
    encode(0, count, 0);
  } else {
    for (std::size_t b = model.set_of.size(); b-- > 0;)
      encode(b * rows_in_block, std::min(count, (b + 1) * rows_in_block), model.set_of[b]);
  }
  for (std::size_t i = 0; i < n; ++i) {
    writers[i].put(low_bits(states[i], model.log), model.log);
    const std::span<const std::byte> stream = writers[i].finish();
    put_varint(out, stream.size());
    put_bytes(out, stream);
  }
}

/// Undoes it. False: the bytes do not end with the last row.
template <class Int, std::size_t n>
bool decode_abreast(const std::array<std::span<const std::byte>, n>& bytes, const ShareSets& model,
                    std::size_t components, const std::array<std::size_t, n>& which,
                    std::span<Int> residuals) {
  static constexpr std::array<Int, residual_classes> least = least_residuals<Int>();
  using U = std::make_unsigned_t<Int>;
  std::vector<std::array<std::unique_ptr<tans::DecodeTable<Int>>, n>> tables(model.sets.size());
  std::array<ReversedBitReader, n> readers;
  std::array<std::uint32_t, n> states;
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t s = 0; s < tables.size(); ++s)
      tables[s][i] = std::make_unique<tans::DecodeTable<Int>>(
          shares_of(model.sets[s][which[i]], model.log), least, raw_bits);
    readers[i] = ReversedBitReader(bytes[i]);
    states[i] = static_cast<std::uint32_t>(low_bits(readers[i].window(), model.log));
    readers[i].take(model.log);
  }
  // Works on copies of what changes, so that they can stay in registers.
  const auto decode = [&](Int* row, std::size_t rows, std::size_t set, auto window_of) {
    std::array<const tans::Entry<Int>*, n> entries;
    for (std::size_t i = 0; i < n; ++i) entries[i] = tables[set][i]->entries();
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
  const auto decode_block = [&](std::size_t begin, std::size_t end, std::size_t set) {
    while (begin < end) {
      std::uint64_t within = end - begin;
      for (const ReversedBitReader& in : readers)
        within = std::min(within, in.within() / most_bits);
      const std::size_t some = within > 0 ? static_cast<std::size_t>(within) : 1;
      Int* const row = residuals.data() + begin * components;
      if (within > 0)
        decode(row, some, set, [](const ReversedBitReader& in) { return in.window_within(); });
      else
        decode(row, some, set, [](const ReversedBitReader& in) { return in.window(); });
      begin += some;
    }
  };
  const std::size_t count = residuals.size() / components;
  if (model.set_of.empty()) decode_block(0, count, 0);
  for (std::size_t b = 0; b < model.set_of.size(); ++b)
    decode_block(b * rows_in_block, std::min(count, (b + 1) * rows_in_block), model.set_of[b]);
  bool finished = true;
  for (std::size_t i = 0; i < n; ++i) finished &= readers[i].finished() && states[i] == 0;
  return finished;
}

}  // namespace clers::internal

#endif
