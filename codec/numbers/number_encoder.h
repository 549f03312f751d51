// Values -> number systems that have them, integers, and what the integers leave open.
#ifndef CLERS_CODEC_NUMBERS_NUMBER_ENCODER_H
#define CLERS_CODEC_NUMBERS_NUMBER_ENCODER_H

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "codec/entropy/bytes.h"
#include "codec/numbers/number_system.h"

namespace clers::internal {

/// Values as integers, and all that gives the values back.
struct NumberedValues {
  Numbers numbers;
  std::vector<std::int32_t> narrow;  ///< the rows, if numbers.narrow()
  std::vector<std::int64_t> wide;    ///< the rows, if not
  Bytes bytes;                       ///< what NumberReader::read reads
};

/// Finds the system of each component that is likely to cost least, and puts the values into it.
/// `values` are packed and in native order, `components` >= 1 a value, in the order in which they
/// will be coded: neighbours in it should be near each other. Exact for any bits of any type.
/// Cost: linear.
NumberedValues number_values(std::span<const std::byte> values, Scalar scalar,
                             std::size_t components, int level);

/// What becomes of integers before they are coded.
enum class Integers : std::uint8_t {
  as_coded,  ///< low bits that are not worth predicting are taken off, few integers are a palette
  whole,     ///< neither: for who predicts them by arithmetic (number_line.h)
};

/// Puts values into given systems, those that do not fit as strays. Sets the axes' tops, their
/// scales, and a palette if it pays. Cost: linear.
NumberedValues put_into_systems(std::span<const std::byte> values, Scalar scalar,
                                std::vector<NumberSystem> systems, int level,
                                Integers integers = Integers::as_coded);

/// Values as whole integers: words, and if they are decimals or on a grid, that. Which takes less
/// shows when they are coded. As number_values else.
std::vector<NumberedValues> number_for_lines(std::span<const std::byte> values, Scalar scalar,
                                             std::size_t components, int level);

/// The same of values that are integers already, K of their systems, packed as std::int32_t. No
/// component's range is greater than most_narrow.
NumberedValues put_integers(std::span<const std::byte> integers, Scalar scalar,
                            std::vector<NumberSystem> systems);

/// Appends the bytes of systems without refinements and strays: what the caller made integers of.
/// Preconditions: as NumberReader::read checks them.
void put_plain_numbers(Bytes& out, const Numbers& numbers);

}  // namespace clers::internal

#endif
