// A frame -> residuals; residuals and a surface -> values.
#include "codec/attributes/attribute_decoder.h"

#include <utility>

#include "codec/attributes/residuals.h"

namespace clers::internal {

Expected<Done> check_values(std::span<const std::byte> bytes, std::uint64_t at,
                            const AttributeHeader& header, std::uint64_t count) {
  return check_frame(bytes.subspan(header.bytes), at + header.bytes,
                     count * header.attribute.stride(), "the values");
}

Expected<Bytes> decode_residuals(std::span<const std::byte> bytes, std::uint64_t at,
                                 const AttributeHeader& header, std::uint64_t count) {
  return unpack_residuals(bytes.subspan(header.bytes), at + header.bytes,
                          count * header.attribute.stride(), header.attribute.scalar,
                          header.attribute.components);
}

Attribute reconstruct(const AttributeHeader& header, Bytes residuals, const CodedSurface& surface) {
  Attribute attribute = header.attribute;
  const std::size_t components = attribute.components,
                    count = residuals.size() / attribute.stride();
  if (in_order_of_values(header.predictor))
    attribute.data = std::move(residuals);
  else
    attribute.data.resize(residuals.size());
  Bytes& keys = attribute.data;
  const std::byte* rows = residuals.empty() ? keys.data() : residuals.data();
  with_word(attribute.scalar, [&](auto word) {
    using U = decltype(word);
    if (header.predictor != Predictor::none)
      with_components(components, [&](auto n) {
        add_predictions<U>(header.predictor, count, n, surface, rows, keys.data());
      });
    if (is_float(attribute.scalar))
      for (std::size_t i = 0; i < count * components; ++i)
        set_word(keys.data(), i, from_ordered(word_at<U>(keys.data(), i)));
  });
  return attribute;
}

}  // namespace clers::internal
