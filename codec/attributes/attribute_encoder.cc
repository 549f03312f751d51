// Tries each predictor that may pay, and keeps the one whose residuals a quick zstd packs smallest.
#include "codec/attributes/attribute_encoder.h"

#include <array>
#include <utility>
#include <vector>

#include "codec/attributes/attribute_format.h"
#include "codec/attributes/residuals.h"

namespace clers::internal {
namespace {

int zstd_level(int level) {
  static constexpr std::array<int, 9> levels = {1, 1, 3, 3, 6, 9, 12, 15, 19};
  return levels[static_cast<std::size_t>(level - 1)];
}

/// Values as integers that sort like them.
Bytes keys_of(const Attribute& attribute) {
  Bytes keys = attribute.data;
  if (is_float(attribute.scalar))
    with_word(attribute.scalar, [&](auto word) {
      using U = decltype(word);
      for (std::size_t i = 0; i < keys.size() / sizeof(U); ++i)
        set_word(keys.data(), i, to_ordered(word_at<U>(keys.data(), i)));
    });
  return keys;
}

}  // namespace

Expected<Bytes> encode_attribute(const Attribute& attribute, const CodedSurface& surface,
                                 int level) {
  const std::size_t components = attribute.components,
                    count = attribute.data.size() / attribute.stride();
  std::vector<Predictor> candidates = {Predictor::none, Predictor::previous};
  if (attribute.domain == Domain::vertex && !surface.corners.empty()) {
    candidates.push_back(Predictor::parallelogram);
    if (attribute.name == position_name) candidates = {Predictor::parallelogram};
  }
  const Bytes keys = keys_of(attribute);
  Bytes residuals(keys.size()), best_planes;
  Predictor best = candidates.back();
  std::size_t least = ~std::size_t(0);
  for (const Predictor predictor : candidates) {
    with_word(attribute.scalar, [&](auto word) {
      subtract_predictions<decltype(word)>(predictor, count, components, surface, keys.data(),
                                           residuals.data());
    });
    Bytes planes = planes_of(residuals, attribute.scalar, components);
    std::size_t size = 0;
    if (candidates.size() > 1) {
      auto trial = pack_frame(planes, 1);
      if (!trial) return trial;
      size = trial->size();
    }
    if (size < least) {
      least = size;
      best = predictor;
      best_planes = std::move(planes);
    }
  }
  auto packed = pack_frame(best_planes, zstd_level(level));
  if (!packed) return packed;
  Bytes out;
  put_attribute_header(out, attribute, best);
  put_bytes(out, *packed);
  return out;
}

}  // namespace clers::internal
