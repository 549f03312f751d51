// One component of packed values <-> the words of its numbers.
#ifndef CLERS_CODEC_NUMBERS_COMPONENT_WORDS_H
#define CLERS_CODEC_NUMBERS_COMPONENT_WORDS_H

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "codec/numbers/number_maps.h"
#include "codec/numbers/transform.h"
#include "codec/scalar.h"

namespace clers::internal {

/// Where the numbers of a component are.
struct Component {
  Scalar scalar;
  std::size_t components, component;  ///< so many a value, and which one
};

/// Reads the words of the values from `begin` on.
template <class U>
void load_words(std::span<const std::byte> values, const Component& of, std::size_t begin,
                std::span<U> words) {
  const auto mask = static_cast<U>(key_mask(of.scalar));
  with_word(of.scalar, [&](auto word) {
    using Stored = decltype(word);
    std::size_t at = begin * of.components + of.component;
    for (U& w : words) {
      w = static_cast<U>(word_at<Stored>(values.data(), at) ^ mask);
      at += of.components;
    }
  });
}
template <class U>
void store_words(std::span<const U> words, const Component& of, std::size_t begin,
                 std::span<std::byte> values) {
  const auto mask = static_cast<U>(key_mask(of.scalar));
  with_word(of.scalar, [&](auto word) {
    using Stored = decltype(word);
    std::size_t at = begin * of.components + of.component;
    for (const U w : words) {
      set_word(values.data(), at, static_cast<Stored>(w ^ mask));
      at += of.components;
    }
  });
}

/// The words of all values.
template <class T>
std::vector<WordOf<T>> words_of(std::span<const std::byte> values, const Component& of) {
  std::vector<WordOf<T>> words(values.size() / (of.components * size_of(of.scalar)));
  load_words(values, of, 0, std::span(words));
  return words;
}

}  // namespace clers::internal

#endif
