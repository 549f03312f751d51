// Bytes <-> one zstd frame, and what a payload must be to be one.
#ifndef CLERS_CODEC_ENTROPY_ZSTD_FRAME_H
#define CLERS_CODEC_ENTROPY_ZSTD_FRAME_H

#include <zstd.h>
#include <zstd_errors.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <new>
#include <span>
#include <string>

#include "codec/entropy/bytes.h"
#include "codec/error.h"

namespace clers::internal {

/// Passes on what a function of zstd returned, but throws if it had no memory: that is no fault of
/// the data.
inline std::size_t zstd_result(std::size_t result) {
  if (ZSTD_isError(result) && ZSTD_getErrorCode(result) == ZSTD_error_memory_allocation)
    throw std::bad_alloc();
  return result;
}

/// The same bytes on every machine. Left alone, zstd chooses how it looks for matches by whether it
/// was built with vectors, which it is not for 32-bit x86. Errors: internal.
inline Expected<Bytes> pack_frame(std::span<const std::byte> data, int zstd_level) {
  const std::unique_ptr<ZSTD_CCtx, std::size_t (*)(ZSTD_CCtx*)> context(ZSTD_createCCtx(),
                                                                        ZSTD_freeCCtx);
  if (!context) throw std::bad_alloc();
  ZSTD_CCtx_setParameter(context.get(), ZSTD_c_compressionLevel, zstd_level);
#if ZSTD_VERSION_NUMBER >= 10500
  constexpr int in_rows = 1, in_chains = 2;
  const bool large = data.size() > 1 << 14;  // as with vectors
  ZSTD_CCtx_setParameter(context.get(), ZSTD_c_experimentalParam14, large ? in_rows : in_chains);
#endif
  Bytes out(ZSTD_compressBound(data.size()));
  const std::size_t size =
      zstd_result(ZSTD_compress2(context.get(), out.data(), out.size(), data.data(), data.size()));
  if (ZSTD_isError(size))
    return fail(ErrorCode::internal, std::string("zstd failed: ") + ZSTD_getErrorName(size));
  out.resize(size);
  return out;
}

/// What a frame holds, if that is `size` bytes. Precondition: check_frame. Errors: invalid.
inline Expected<Bytes> unpack_frame(std::span<const std::byte> packed, std::uint64_t at,
                                    std::uint64_t size, const std::string& what) {
  Bytes out(static_cast<std::size_t>(size));
  const std::size_t got =
      zstd_result(ZSTD_decompress(out.data(), out.size(), packed.data(), packed.size()));
  if (ZSTD_isError(got))
    return fail(ErrorCode::invalid, Place::byte, at,
                std::string("zstd: ") + ZSTD_getErrorName(got));
  if (got != size)
    return fail(ErrorCode::invalid, Place::byte, at,
                what + " take " + std::to_string(got) + " bytes, expected " + std::to_string(size));
  return out;
}

/// Whether bytes are one zstd frame that can hold `size` bytes, as far as can be seen without
/// unpacking it. `at` is their offset in the file, `what` names them for errors: invalid.
inline Expected<Done> check_frame(std::span<const std::byte> packed, std::uint64_t at,
                                  std::uint64_t size, const std::string& what) {
  constexpr std::uint64_t max_expansion = 32768;  // a block makes 128 KiB of 4 bytes at best
  const auto invalid = [&](std::size_t where, std::string text) {
    return fail(ErrorCode::invalid, Place::byte, at + where, std::move(text));
  };
  if (size > max_expansion * packed.size())
    return invalid(0, std::to_string(size) + " bytes of " + what + " cannot come from " +
                          std::to_string(packed.size()));
  // Not one that is to be skipped, nor one of zstd's old formats.
  std::uint32_t magic = 0;
  for (std::size_t i = 0; i < 4 && i < packed.size(); ++i)
    magic |= std::to_integer<std::uint32_t>(packed[i]) << 8 * i;
  if (magic != ZSTD_MAGICNUMBER) return invalid(0, "no zstd frame, which " + what + " must be");
  const std::size_t frame = ZSTD_findFrameCompressedSize(packed.data(), packed.size());
  if (ZSTD_isError(frame)) return invalid(0, std::string("zstd: ") + ZSTD_getErrorName(frame));
  if (frame != packed.size())
    return invalid(
        frame, std::to_string(packed.size() - frame) + " bytes after the zstd frame of " + what);
  const unsigned long long content = ZSTD_getFrameContentSize(packed.data(), packed.size());
  if (content != ZSTD_CONTENTSIZE_UNKNOWN && content != size)
    return invalid(
        0, what + " take " + std::to_string(content) + " bytes, expected " + std::to_string(size));
  return Done{};
}

}  // namespace clers::internal

#endif
