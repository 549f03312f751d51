#include "bench/rivals/general.h"

#include <lzma.h>
#include <zstd.h>

#include <algorithm>
#include <cstring>
#include <numeric>
#include <span>

#include "bench/fidelity.h"

namespace clers::bench {
namespace {

using Bytes = std::vector<std::uint8_t>;

// A compressor of bytes.
struct Packer {
  const char* name;
  Bytes (*pack)(const void* data, std::size_t size);
  void (*unpack)(const Bytes& packed, void* out, std::size_t size);
};

// The bytes of `xz -9e`.
Bytes xz9e(const void* data, std::size_t size) {
  Bytes packed(lzma_stream_buffer_bound(size));
  std::size_t used = 0;
  if (lzma_easy_buffer_encode(9 | LZMA_PRESET_EXTREME, LZMA_CHECK_CRC64, nullptr,
                              static_cast<const std::uint8_t*>(data), size, packed.data(), &used,
                              packed.size()) != LZMA_OK)
    throw CodecFailure("xz cannot compress it");
  packed.resize(used);
  return packed;
}

void unxz(const Bytes& packed, void* out, std::size_t size) {
  std::uint64_t memory = UINT64_MAX;
  std::size_t from = 0, to = 0;
  if (lzma_stream_buffer_decode(&memory, 0, nullptr, packed.data(), &from, packed.size(),
                                static_cast<std::uint8_t*>(out), &to, size) != LZMA_OK ||
      to != size)
    throw CodecFailure("xz gives something else");
}

constexpr Packer packers[] = {{"zstd19", zstd19, zstd_decompress}, {"xz9e", xz9e, unxz}};

// An array, and what is made of it. Not vectors where it is decoded to: those would be filled with
// zeros first.
class Array {
 public:
  template <class T>
  void set(const std::vector<T>& values) {
    size_ = values.size() * sizeof(T);
    in_.reset(new std::uint8_t[size_]);
    if (size_) std::memcpy(in_.get(), values.data(), size_);
  }
  void pack(const Packer& packer) {
    packed_.clear();
    if (size_) packed_ = packer.pack(in_.get(), size_);
  }
  void unpack(const Packer& packer) {
    out_.reset(new std::uint8_t[size_]);
    if (size_) packer.unpack(packed_, out_.get(), size_);
  }
  void discard() { out_.reset(); }
  std::size_t packed_size() const { return packed_.size(); }

  template <class T>
  std::vector<T> result() const {
    std::vector<T> values(size_ / sizeof(T));
    if (size_) std::memcpy(values.data(), out_.get(), size_);
    return values;
  }

 private:
  std::size_t size_ = 0;
  std::unique_ptr<std::uint8_t[]> in_, out_;
  Bytes packed_;
};

class PackedArrays : public Codec {
 public:
  explicit PackedArrays(const Packer& packer) : packer_(packer) {}

  void prepare(const Input& input, Mode mode) override {
    mode_ = mode;
    vertex_count_ = input.vertex_count;
    indices_.set(input.triangles);
    if (mode == Mode::lossless) positions_.set(input.positions);
    if (bits(mode)) {
      grid_ = grid_of(input, bits(mode));
      positions_.set(on_grid(input.positions, grid_));
    }
  }

  void encode() override {
    indices_.pack(packer_);
    positions_.pack(packer_);
  }
  // What a decoder has to be told besides: origin and step of a grid.
  std::size_t bytes() const override {
    return indices_.packed_size() + positions_.packed_size() + (bits(mode_) ? 16 : 0);
  }
  std::size_t position_bytes() const override { return positions_.packed_size(); }

  void decode() override {
    indices_.unpack(packer_);
    positions_.unpack(packer_);
    if (bits(mode_)) floats_ = off_grid(positions_.result<std::uint16_t>(), grid_);
  }
  void discard() override {
    indices_.discard();
    positions_.discard();
    floats_ = {};
  }

  Output output() override {
    Output out;
    out.triangles = indices_.result<std::uint32_t>();
    out.origin.resize(vertex_count_);
    std::iota(out.origin.begin(), out.origin.end(), 0u);
    out.positions = bits(mode_) ? floats_ : positions_.result<float>();
    return out;
  }

 private:
  const Packer& packer_;
  Mode mode_ = Mode::connectivity;
  std::uint32_t vertex_count_ = 0;
  Grid grid_{};
  Array indices_, positions_;
  std::vector<float> floats_;
};

class PackedFile : public Codec {
 public:
  PackedFile(const Packer& packer, bool as_ply) : packer_(packer), as_ply_(as_ply) {}

  void prepare(const Input& input, Mode) override {
    format_ = as_ply_ ? io::Format::ply : input.file.format;
    if (!as_ply_) return file_.set(input.file.bytes);
    auto written = io::write(input.file.meshes, format_);
    if (!written) throw CodecFailure(describe(written.error()));
    file_.set(written->bytes);
  }

  void encode() override { file_.pack(packer_); }
  std::size_t bytes() const override { return file_.packed_size(); }
  void decode() override { file_.unpack(packer_); }
  void discard() override { file_.discard(); }

  Output output() override {
    auto read = io::read(file_.result<std::byte>(), format_);
    if (!read) throw CodecFailure(describe(read.error()));
    Output out;
    out.meshes = std::move(read->meshes);
    return out;
  }

 private:
  const Packer& packer_;
  bool as_ply_;
  io::Format format_ = io::Format::ply;
  Array file_;
};

}  // namespace

std::vector<std::uint8_t> zstd19(const void* data, std::size_t size) {
  std::vector<std::uint8_t> frame(ZSTD_compressBound(size));
  const std::size_t got = ZSTD_compress(frame.data(), frame.size(), data, size, 19);
  if (ZSTD_isError(got)) throw CodecFailure(ZSTD_getErrorName(got));
  frame.resize(got);
  return frame;
}

void zstd_decompress(const std::vector<std::uint8_t>& frame, void* out, std::size_t size) {
  const std::size_t got = ZSTD_decompress(out, size, frame.data(), frame.size());
  if (ZSTD_isError(got)) throw CodecFailure(ZSTD_getErrorName(got));
  if (got != size) throw CodecFailure("zstd gives another size");
}

std::vector<CodecEntry> general_codecs() {
  std::vector<CodecEntry> entries;
  for (const Packer& packer : packers) {
    const std::string name = packer.name;
    entries.push_back({name,
                       {Mode::connectivity, Mode::q11, Mode::q14, Mode::q16, Mode::lossless},
                       [&packer] { return std::make_unique<PackedArrays>(packer); }});
    for (const bool as_ply : {false, true})
      entries.push_back({(as_ply ? "ply-" : "file-") + name, {Mode::file}, [&packer, as_ply] {
                           return std::make_unique<PackedFile>(packer, as_ply);
                         }});
  }
  return entries;
}

std::string zstd_version() {
  return ZSTD_versionString();
}

std::string xz_version() {
  return lzma_version_string();
}

}  // namespace clers::bench
