// A stream: what one model says of a mesh, coded with rANS, in bytes whose number stands before
// them. It is written and read here and nowhere else, so that every stream is read to its end and
// is the only one that says the same. Knows no model and no mesh.
#ifndef CLERS_CODEC_ENTROPY_STREAM_H
#define CLERS_CODEC_ENTROPY_STREAM_H

#include <cstdint>
#include <initializer_list>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "codec/entropy/bytes.h"
#include "codec/entropy/coder.h"
#include "codec/entropy/rans.h"
#include "codec/error.h"

namespace clers::internal {

/// A decision takes at least log2(32768 / 32736) bits, so a byte holds fewer than this many.
inline constexpr std::uint64_t max_decisions_per_byte = 8192;

/// A stream in a file.
struct Stream {
  std::span<const std::byte> bytes;
  std::uint64_t at = 0;  ///< their offset in the file

  /// No stream of so many bytes says more.
  std::uint64_t max_decisions() const { return max_decisions_per_byte * bytes.size(); }
};

/// A stream that is written, after the numbers that its reader must know beforehand.
struct EncodedStream {
  std::vector<std::uint64_t> numbers;
  Bytes bytes;

  bool empty() const { return bytes.empty(); }  ///< left out; a stream has a byte at least
  void put(Bytes& out) const {
    for (const std::uint64_t n : numbers) put_varint(out, n);
    put_varint(out, bytes.size());
    put_bytes(out, bytes);
  }
};

/// Reads the numbers and where the stream is. What of it is missing `in` knows.
inline Stream read_stream(ByteReader& in, std::initializer_list<std::uint64_t*> numbers) {
  for (std::uint64_t* n : numbers) *n = in.varint();
  const std::uint64_t size = in.varint();
  const std::uint64_t at = in.offset();
  return {in.take(size), at};
}

/// The stream of what `code` encodes with the coder that it is called with.
template <class Code>
Bytes encode_stream(const Code& code) {
  rans::Encoder stream;
  EncodeTo coder(stream);
  code(coder);
  Bytes bytes;
  stream.finish(bytes);
  return bytes;
}

/// Calls `code` with a coder that decodes the stream. It returns what is wrong with what it
/// decoded, an empty string if nothing is. `what` is decoded, for errors. Error: invalid.
template <class Code>
Expected<Done> decode_stream(const Stream& stream, const char* what, const Code& code) {
  rans::Decoder in(stream.bytes);
  DecodeFrom coder(in);
  std::string fault = code(coder);
  if (fault.empty() && !in.finished())
    fault = std::string(what) + " do not end where their bytes end";
  if (fault.empty()) return Done{};
  return fail(ErrorCode::invalid, Place::byte, stream.at, std::move(fault));
}

}  // namespace clers::internal

#endif
