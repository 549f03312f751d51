#include <array>

#include "codec/attributes/attribute_format.h"

namespace clers::internal {
namespace {

int zstd_level(int level) {
  static constexpr std::array<int, 9> levels = {1, 1, 3, 3, 6, 9, 12, 15, 19};
  return levels[static_cast<std::size_t>(level - 1)];
}

/// Differences of all values to their guesses: for every component, all lowest bytes, then all
/// second ones, and so on.
template <class U>
Bytes differences(const Attribute& attribute, Predictor predictor, std::size_t count,
                  std::span<const std::uint32_t> corners) {
  const std::size_t components = attribute.components;
  const bool ordered = is_float(attribute.scalar);
  Bytes planes(count * components * sizeof(U));
  std::vector<U> keys(count * components);
  if (!keys.empty()) std::memcpy(keys.data(), attribute.data.data(), keys.size() * sizeof(U));
  if (ordered)
    for (U& k : keys) k = to_ordered(k);
  std::size_t row = 0;
  for_each_value(predictor, count, corners, [&](std::size_t v, Guess g) {
    for (std::size_t c = 0; c < components; ++c) {
      const U value = keys[v * components + c];
      U stored = value;
      if (g.a != v) {
        const U guess = static_cast<U>(keys[g.a * components + c] + keys[g.b * components + c] -
                                       keys[g.c * components + c]);
        stored = zigzag(static_cast<U>(value - guess));
      }
      for (std::size_t byte = 0; byte < sizeof(U); ++byte)
        planes[(c * sizeof(U) + byte) * count + row] =
            static_cast<std::byte>(stored >> 8 * byte & 0xff);
    }
    ++row;
  });
  return planes;
}

Expected<Bytes> compress(std::span<const std::byte> data, int level) {
  Bytes out(ZSTD_compressBound(data.size()));
  const std::size_t size =
      zstd_result(ZSTD_compress(out.data(), out.size(), data.data(), data.size(), level));
  if (ZSTD_isError(size))
    return fail(ErrorCode::internal, std::string("zstd failed: ") + ZSTD_getErrorName(size));
  out.resize(size);
  return out;
}

}  // namespace

Expected<Bytes> encode_attribute(const Attribute& attribute, std::span<const std::uint32_t> corners,
                                 int level) {
  const std::size_t count = attribute.data.size() / attribute.stride();
  std::vector<Predictor> candidates = {Predictor::none, Predictor::previous};
  if (attribute.domain == Domain::vertex && !corners.empty()) {
    candidates.push_back(Predictor::parallelogram);
    if (attribute.name == position_name) candidates = {Predictor::parallelogram};
  }
  Predictor best = candidates.back();
  Bytes best_planes;
  std::size_t least = ~std::size_t(0);
  for (const Predictor predictor : candidates) {
    Bytes planes = with_word(attribute.scalar, [&](auto word) {
      return differences<decltype(word)>(attribute, predictor, count, corners);
    });
    std::size_t size = 0;
    if (candidates.size() > 1) {
      auto trial = compress(planes, 1);
      if (!trial) return Failure{trial.error()};
      size = trial->size();
    }
    if (size < least) {
      least = size;
      best = predictor;
      best_planes = std::move(planes);
    }
  }
  auto packed = compress(best_planes, zstd_level(level));
  if (!packed) return Failure{packed.error()};

  Bytes out;
  put_u8(out, static_cast<std::uint32_t>(attribute.name.size()));
  for (const char c : attribute.name) put_u8(out, static_cast<unsigned char>(c));
  put_u8(out, static_cast<std::uint32_t>(attribute.domain));
  put_u8(out, static_cast<std::uint32_t>(attribute.scalar));
  put_u8(out, attribute.components);
  put_u8(out, static_cast<std::uint32_t>(best));
  put_bytes(out, *packed);
  return out;
}

}  // namespace clers::internal
