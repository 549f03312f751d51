// How the values of one name are predicted <-> a number below named_models.
#ifndef CLERS_CODEC_ATTRIBUTES_NAMED_MODEL_H
#define CLERS_CODEC_ATTRIBUTES_NAMED_MODEL_H

#include <cstddef>
#include <cstdint>

#include "codec/numbers/lattice.h"

namespace clers::internal {

/// What a component is predicted by; the numbers are the format's.
enum class NamedPredictor : std::uint8_t {
  symbol,         ///< nothing: its bits are coded, each in the context of those above it
  before,         ///< the value before
  mean,           ///< the mean of the neighbours
  parallelogram,  ///< a + b - c of the gate
  median,         ///< of a, b and a + b - c, as in LOCO-I (Weinberger, Seroussi, Sapiro 2000)
};
inline constexpr std::uint32_t named_predictors = 5;

/// How components are predicted from others; the numbers are the format's.
enum class Relation : std::uint8_t {
  none,
  green,  ///< first the second of three; the first and the third are off as it is
  sum,    ///< the last one is off so that the sum of all is not
};
inline constexpr std::uint32_t relations = 3;

/// What is asked before anything is predicted; the numbers are the format's.
enum class Repeats : std::uint8_t {
  none,
  values,      ///< whether the value is one of those around it
  components,  ///< whether a component is that of one of those
};
inline constexpr std::uint32_t repeats_count = 3;

struct NamedModel {
  NamedPredictor predictor = NamedPredictor::before;
  Relation relation = Relation::none;
  Repeats repeats = Repeats::none;

  /// Whether it is one for so many components.
  bool fits(std::size_t components) const {
    if (repeats == Repeats::components && (components < 2 || predictor == NamedPredictor::symbol))
      return false;
    if (relation == Relation::none) return true;
    return predictor != NamedPredictor::symbol &&
           components >= (relation == Relation::green ? 3u : 2u);
  }
};
inline constexpr std::uint32_t named_models = repeats_count * relations * named_predictors;

/// As the byte that the format has for it, below named_models; and back.
inline std::uint32_t number_of(const NamedModel& model) {
  return (static_cast<std::uint32_t>(model.repeats) * relations +
          static_cast<std::uint32_t>(model.relation)) *
             named_predictors +
         static_cast<std::uint32_t>(model.predictor);
}
inline NamedModel named_model(std::uint32_t number) {
  return {static_cast<NamedPredictor>(number % named_predictors),
          static_cast<Relation>(number / named_predictors % relations),
          static_cast<Repeats>(number / (named_predictors * relations) % repeats_count)};
}

/// The greatest integer of a component as it is coded: of those that are one of few, the rank.
inline std::uint64_t coded_top(const Axis& axis) {
  return axis.palette.empty() ? axis.top : axis.palette.size() - 1;
}

}  // namespace clers::internal

#endif
