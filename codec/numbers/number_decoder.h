// Number systems and integers -> values.
#ifndef CLERS_CODEC_NUMBERS_NUMBER_DECODER_H
#define CLERS_CODEC_NUMBERS_NUMBER_DECODER_H

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "codec/entropy/bytes.h"
#include "codec/entropy/stream.h"
#include "codec/error.h"
#include "codec/numbers/number_format.h"
#include "codec/numbers/number_system.h"

namespace clers::internal {

/// What is known of values before their integers are.
class NumberReader {
 public:
  /// Reads the systems of `count` values, and remembers where their refinements and strays are.
  /// Errors: truncated, invalid.
  static Expected<NumberReader> read(ByteReader& in, Scalar scalar, std::size_t components,
                                     std::uint64_t count);

  const Numbers& numbers() const { return numbers_; }

  /// What read() of these bytes and to_values() take besides the values, at most. Takes none
  /// itself.
  static std::uint64_t memory(std::span<const std::byte> bytes, Scalar scalar,
                              std::size_t components, std::uint64_t count);

  /// Makes values of rows: packed, in native order. Precondition: every integer is in 0 .. top.
  /// Errors: invalid.
  Expected<Done> to_values(std::span<const std::int32_t> rows, std::span<std::byte> values) const;
  Expected<Done> to_values(std::span<const std::int64_t> rows, std::span<std::byte> values) const;

 private:
  template <class Int>
  Expected<Done> make_values(std::span<const Int> rows, std::span<std::byte> values) const;

  /// How what a component's integers leave open is coded.
  struct Part {
    RefinementCoding coding;
    bool refined_palette;
    Stream refinements;
    std::uint64_t strays;
    Stream stray_numbers;
  };

  Numbers numbers_;
  std::vector<Part> parts_;
};

}  // namespace clers::internal

#endif
