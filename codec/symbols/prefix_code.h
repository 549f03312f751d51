// Symbols as a prefix code, for the fastest level: C 0, R 10, L 110, S 1110, E 1111.
//
// A closed surface of genus 0 has as many C as other symbols, less two, and few of those but R: one
// and two thirds of a bit a triangle on most surfaces, and no table to look anything up in.
#ifndef CLERS_CODEC_SYMBOLS_PREFIX_CODE_H
#define CLERS_CODEC_SYMBOLS_PREFIX_CODE_H

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

#include "codec/base/portable.h"
#include "codec/symbols/symbol.h"

namespace clers::internal {

/// Writes symbols, lowest bits of a byte first.
class SymbolWriter {
 public:
  /// At most so many symbols.
  explicit SymbolWriter(std::size_t symbols) : bytes_(symbols / 2 + 8) {}
  void put(Clers symbol) {
    static constexpr std::uint8_t codes[] = {0, 1, 3, 7, 15}, lengths[] = {1, 2, 3, 4, 4};
    const unsigned s = static_cast<unsigned>(symbol);
    bits_ |= std::uint64_t(codes[s]) << count_;
    count_ += lengths[s];
    if (count_ >= 32) flush();
  }
  std::vector<std::byte> finish() {
    const std::size_t size = size_ + (count_ + 7) / 8;
    flush();
    bytes_.resize(size);
    return std::move(bytes_);
  }

 private:
  void flush() {
    for (unsigned i = 0; i < 4; ++i) bytes_[size_++] = static_cast<std::byte>(bits_ >> 8 * i);
    bits_ >>= 32;
    count_ -= 32;
  }

  std::vector<std::byte> bytes_;
  std::size_t size_ = 0;
  std::uint64_t bits_ = 0;
  unsigned count_ = 0;
};

/// Reads them. Past the end it reads zeros, which are C, and finished() is false.
class PrefixCode {
 public:
  explicit PrefixCode(std::span<const std::byte> bytes)
      : next_(bytes.data()), end_(bytes.data() + bytes.size()) {}
  bool ok() const { return true; }

  template <class Coder, class Front, class Gate, class Then>
  CLERS_ALWAYS_INLINE auto decode(Coder&, const Front&, const Gate&, std::size_t, Then then) {
    if (left_ < 4) refill();
    if (!take()) return then(Symbol<Clers::C>());
    if (!take()) return then(Symbol<Clers::R>());
    if (!take()) return then(Symbol<Clers::L>());
    if (!take()) return then(Symbol<Clers::S>());
    return then(Symbol<Clers::E>());
  }

  /// Everything was read, and what is left of the last byte is zero.
  bool finished() const { return next_ == end_ && left_ >= 0 && left_ < 8 && bits_ == 0; }

 private:
  bool take() {
    const bool bit = bits_ & 1;
    bits_ >>= 1;
    --left_;
    return bit;
  }
  void refill() {
    if (end_ - next_ >= 4) {
      std::uint32_t word = 0;
      for (unsigned i = 0; i < 4; ++i) word |= std::to_integer<std::uint32_t>(next_[i]) << 8 * i;
      bits_ |= std::uint64_t(word) << left_;
      left_ += 32;
      next_ += 4;
    } else {
      slow_refill();
    }
  }
  CLERS_NEVER_INLINE void slow_refill() {
    if (left_ < 0) return;
    for (; next_ != end_; ++next_, left_ += 8)
      bits_ |= std::to_integer<std::uint64_t>(*next_) << left_;
  }

  const std::byte* next_;
  const std::byte* end_;
  std::uint64_t bits_ = 0;
  int left_ = 0;  ///< bits that are not read yet; below zero behind the end
};

}  // namespace clers::internal

#endif
