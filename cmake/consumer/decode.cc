// Decodes and never encodes: scripts/test-install looks that no encoder is linked.
#include <clers/decode.h>
#include <clers/decoder.h>

int main() {
  const std::byte bytes[] = {std::byte{'c'}};
  const auto decoder = clers::Decoder::open(bytes);
  if (decoder) return decoder->decode_into(0, {}).ok() ? 1 : 2;
  return clers::decode(bytes) ? 1 : 0;
}
