// Values <-> what they differ by from predictions. It knows the surface and words, but no bytes of
// a file.
#ifndef CLERS_CODEC_ATTRIBUTES_PREDICTION_H
#define CLERS_CODEC_ATTRIBUTES_PREDICTION_H

#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "codec/connectivity/coded_surface.h"
#include "codec/numbers/transform.h"

namespace clers::internal {

/// From where a value is predicted. The numbers are the file format's.
enum class Predictor : std::uint8_t {
  none = 0,
  previous = 1,       ///< the value before
  parallelogram = 2,  ///< vertex attributes: from the triangle before
};

/// Values from which another is predicted: a + b - c. With b == c: just a.
struct Prediction {
  std::uint32_t a, b, c;

  /// What it says of a component, modulo the word.
  template <class U>
  U of(const std::byte* keys, std::size_t components, std::size_t component) const {
    const auto key = [&](std::size_t value) {
      return word_at<U>(keys, value * components + component);
    };
    return static_cast<U>(key(a) + key(b) - key(c));
  }
};

/// Calls visit(vertex, prediction) for every vertex that a triangle has, in the order of their
/// introduction, with a prediction from vertices before (Touma and Gotsman 1998); then for all
/// others in the order of their numbers, predicted from the number before. What has nothing before
/// it gets itself.
///
///        v          c is the corner across the gate a-b, if the triangle before is there
///       / \         .
///      a===b
///       \ /
///        c
template <class Visit>
void for_each_predicted_vertex(const CodedSurface& surface, std::uint32_t vertex_count,
                               Visit visit) {
  std::uint32_t last = 0;
  bool any = false;
  for_each_introduced(surface, [&](std::uint32_t t, unsigned j) {
    const std::uint32_t* face = surface.corners.data() + 3 * std::size_t(t);
    const std::uint32_t v = face[j];
    Prediction from{last, last, last};
    if (j == 2 && t > 0) {
      const std::uint32_t* before = face - 3;
      if (face[0] == before[2] && face[1] == before[1])
        from = {face[0], face[1], before[0]};
      else if (face[0] == before[0] && face[1] == before[2])
        from = {face[0], face[1], before[1]};
      else
        from = {face[1], face[1], face[1]};
    } else if (j > 0) {
      from = {face[j - 1], face[j - 1], face[j - 1]};
    } else if (!any) {
      from = {v, v, v};
    }
    any = true;
    visit(v, from);
    last = v;
  });
  for (std::uint32_t v = 0; v < vertex_count; ++v) {
    if (surface.has(v)) continue;
    const std::uint32_t before = v == 0 ? v : v - 1;
    visit(v, Prediction{before, before, before});
  }
}

/// Calls visit(value, prediction) for every value in the order in which residuals are stored. A
/// value that is its own prediction has none.
template <class Visit>
void for_each_predicted(Predictor predictor, std::size_t count, const CodedSurface& surface,
                        Visit visit) {
  if (predictor == Predictor::parallelogram)
    return for_each_predicted_vertex(surface, static_cast<std::uint32_t>(count), visit);
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint32_t v = static_cast<std::uint32_t>(i);
    const std::uint32_t from = predictor == Predictor::none || i == 0 ? v : v - 1;
    visit(v, Prediction{from, from, from});
  }
}

/// Whether residuals are stored in the order of the values.
constexpr bool in_order_of_values(Predictor predictor) {
  return predictor != Predictor::parallelogram;
}

/// Calls use(n) with the number of components: a constant where there are two or three, as there
/// mostly are, so that loops over them unroll.
template <class Use>
void with_components(std::size_t n, Use use) {
  switch (n) {
    case 2: return use(std::integral_constant<std::size_t, 2>());
    case 3: return use(std::integral_constant<std::size_t, 3>());
    default: return use(n);
  }
}

/// The residuals of `count` values, a row of components each. Both are words; values are keys
/// (transform.h). `Components` counts components, as a constant where that is one.
template <class U, class Components>
void subtract_predictions(Predictor predictor, std::size_t count, Components components,
                          const CodedSurface& surface, const std::byte* keys,
                          std::byte* residuals) {
  std::size_t row = 0;
  for_each_predicted(predictor, count, surface, [&](std::uint32_t v, Prediction from) {
    for (std::size_t c = 0; c < components; ++c) {
      U word = word_at<U>(keys, v * components + c);
      if (from.a != v) word = zigzag(static_cast<U>(word - from.of<U>(keys, components, c)));
      set_word(residuals, row * components + c, word);
    }
    ++row;
  });
}

/// Undoes subtract_predictions. Where they are in one order, both may be the same memory.
template <class U, class Components>
void add_predictions(Predictor predictor, std::size_t count, Components components,
                     const CodedSurface& surface, const std::byte* residuals, std::byte* keys) {
  std::size_t row = 0;
  for_each_predicted(predictor, count, surface, [&](std::uint32_t v, Prediction from) {
    for (std::size_t c = 0; c < components; ++c) {
      U word = word_at<U>(residuals, row * components + c);
      if (from.a != v) word = static_cast<U>(from.of<U>(keys, components, c) + unzigzag(word));
      set_word(keys, v * components + c, word);
    }
    ++row;
  });
}

}  // namespace clers::internal

#endif
