// The system that the numbers of a component are likely to have been written in.
#ifndef CLERS_CODEC_NUMBERS_FIND_SYSTEM_H
#define CLERS_CODEC_NUMBERS_FIND_SYSTEM_H

#include <cstddef>
#include <span>
#include <vector>

#include "codec/numbers/number_maps.h"

namespace clers::internal {

/// How many numbers a sample has: some hundred, or some thousand.
enum class Search { quick, thorough };

/// The system in which a sample of the numbers, of type T, takes the fewest bits; all of them if
/// they are few. `first` is an N that fits, not the least. Cost: linear in the number of values for
/// types of integers; for floats constant, but for a look whether all are equal.
template <class T>
NumberSystem find_system(std::span<const WordOf<T>> words, Search search);
/// The same; and, where it leaves strays of the sample, the best one besides that leaves none, if
/// there is one: strays that repeat themselves may take more than a palette of what they are.
template <class T>
std::vector<NumberSystem> find_systems(std::span<const WordOf<T>> words, Search search);

extern template NumberSystem find_system<float>(std::span<const std::uint32_t>, Search);
extern template NumberSystem find_system<double>(std::span<const std::uint64_t>, Search);
extern template NumberSystem find_system<Whole>(std::span<const std::uint64_t>, Search);
extern template std::vector<NumberSystem> find_systems<float>(std::span<const std::uint32_t>,
                                                              Search);
extern template std::vector<NumberSystem> find_systems<double>(std::span<const std::uint64_t>,
                                                               Search);
extern template std::vector<NumberSystem> find_systems<Whole>(std::span<const std::uint64_t>,
                                                              Search);

}  // namespace clers::internal

#endif
