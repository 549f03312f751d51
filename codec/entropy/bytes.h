// Little-endian numbers in bytes, read with every bound checked. Knows no entropy coder, and of a
// file only where in it the bytes are.
#ifndef CLERS_CODEC_ENTROPY_BYTES_H
#define CLERS_CODEC_ENTROPY_BYTES_H

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "codec/error.h"

namespace clers::internal {

using Bytes = std::vector<std::byte>;

inline void put_u8(Bytes& out, std::uint32_t v) {
  out.push_back(static_cast<std::byte>(v));
}
inline void put_u32(Bytes& out, std::uint32_t v) {
  for (unsigned shift = 0; shift < 32; shift += 8) put_u8(out, v >> shift & 0xff);
}
/// Seven bits a byte, low ones first, the high bit set on all but the last.
inline void put_varint(Bytes& out, std::uint64_t v) {
  for (; v >= 0x80; v >>= 7) put_u8(out, static_cast<std::uint32_t>(v & 0x7f) | 0x80);
  put_u8(out, static_cast<std::uint32_t>(v));
}
/// 0, -1, 1, -2, .. as 0, 1, 2, 3, ..
inline void put_signed_varint(Bytes& out, std::int64_t v) {
  put_varint(out, (static_cast<std::uint64_t>(v) << 1) ^ static_cast<std::uint64_t>(v >> 63));
}
inline void put_bytes(Bytes& out, std::span<const std::byte> v) {
  out.insert(out.end(), v.begin(), v.end());
}

/// Reads forward. The first failure stays: later reads give zeros, and error() has it.
class ByteReader {
 public:
  /// `at` is the offset of the first byte in the file.
  ByteReader(std::span<const std::byte> bytes, std::uint64_t at) : bytes_(bytes), at_(at) {}

  std::uint64_t offset() const { return at_ + position_; }
  std::size_t position() const { return position_; }
  std::size_t left() const { return bytes_.size() - position_; }
  bool ok() const { return ok_; }
  const Error& error() const { return error_; }

  std::uint32_t u8() {
    if (!need(1)) return 0;
    return std::to_integer<std::uint32_t>(bytes_[position_++]);
  }
  std::uint32_t u32() {
    if (!need(4)) return 0;
    std::uint32_t v = 0;
    for (unsigned shift = 0; shift < 32; shift += 8)
      v |= std::to_integer<std::uint32_t>(bytes_[position_++]) << shift;
    return v;
  }
  /// Refuses more than one way to write a number, and numbers above 64 bits.
  std::uint64_t varint() {
    std::uint64_t v = 0;
    const std::uint64_t start = offset();
    for (unsigned shift = 0; shift < 64; shift += 7) {
      const std::uint64_t b = u8();
      if (!ok_) return 0;
      if (shift == 63 && b > 1) break;
      v |= (b & 0x7f) << shift;
      if (b < 0x80) {
        if (b == 0 && shift > 0) break;
        return v;
      }
    }
    set_error({ErrorCode::invalid, Place::byte, start, "a number is not written the shortest way"});
    return 0;
  }
  std::int64_t signed_varint() {
    const std::uint64_t v = varint();
    return static_cast<std::int64_t>(v >> 1) ^ -static_cast<std::int64_t>(v & 1);
  }
  std::span<const std::byte> take(std::uint64_t n) {
    if (!need(n)) return {};
    const auto part = bytes_.subspan(position_, static_cast<std::size_t>(n));
    position_ += static_cast<std::size_t>(n);
    return part;
  }

 private:
  bool need(std::uint64_t n) {
    if (ok_ && n <= left()) return true;
    if (ok_)
      set_error({ErrorCode::truncated, Place::byte, at_ + bytes_.size(),
                 "the data end here, expected " + std::to_string(n - left()) + " more bytes"});
    return false;
  }
  void set_error(Error e) {
    ok_ = false;
    error_ = std::move(e);
  }

  std::span<const std::byte> bytes_;
  std::uint64_t at_;
  std::size_t position_ = 0;
  bool ok_ = true;
  Error error_;
};

}  // namespace clers::internal

#endif
