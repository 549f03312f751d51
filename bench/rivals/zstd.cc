#include "bench/rivals/zstd.h"

#include <zstd.h>

#include <numeric>

namespace clers::bench {
namespace {

class Zstd : public Codec {
 public:
  void prepare(const Input& input, Mode mode) override {
    indices_ = input.triangles;
    if (mode == Mode::lossless) positions_ = input.positions;
    vertex_count_ = input.vertex_count;
  }

  void encode() override {
    index_frame_ = zstd_compress(indices_.data(), 4 * indices_.size(), 19);
    if (!positions_.empty())
      position_frame_ = zstd_compress(positions_.data(), 4 * positions_.size(), 19);
  }
  std::size_t bytes() const override { return index_frame_.size() + position_frame_.size(); }

  // Not vectors: those would be filled with zeros first.
  void decode() override {
    out_indices_.reset(new std::uint32_t[indices_.size()]);
    zstd_decompress(index_frame_, out_indices_.get(), 4 * indices_.size());
    if (positions_.empty()) return;
    out_positions_.reset(new float[positions_.size()]);
    zstd_decompress(position_frame_, out_positions_.get(), 4 * positions_.size());
  }
  void discard() override {
    out_indices_.reset();
    out_positions_.reset();
  }

  Output output() override {
    Output out;
    out.triangles.assign(out_indices_.get(), out_indices_.get() + indices_.size());
    out.origin.resize(vertex_count_);
    std::iota(out.origin.begin(), out.origin.end(), 0u);
    if (out_positions_)
      out.positions.assign(out_positions_.get(), out_positions_.get() + positions_.size());
    return out;
  }

 private:
  std::uint32_t vertex_count_ = 0;
  std::vector<std::uint32_t> indices_;
  std::vector<float> positions_;
  std::vector<std::uint8_t> index_frame_, position_frame_;
  std::unique_ptr<std::uint32_t[]> out_indices_;
  std::unique_ptr<float[]> out_positions_;
};

}  // namespace

std::vector<std::uint8_t> zstd_compress(const void* data, std::size_t size, int level) {
  std::vector<std::uint8_t> frame(ZSTD_compressBound(size));
  const std::size_t got = ZSTD_compress(frame.data(), frame.size(), data, size, level);
  if (ZSTD_isError(got)) throw CodecFailure(ZSTD_getErrorName(got));
  frame.resize(got);
  return frame;
}

void zstd_decompress(const std::vector<std::uint8_t>& frame, void* out, std::size_t size) {
  const std::size_t got = ZSTD_decompress(out, size, frame.data(), frame.size());
  if (ZSTD_isError(got)) throw CodecFailure(ZSTD_getErrorName(got));
  if (got != size) throw CodecFailure("zstd gives another size");
}

std::vector<CodecEntry> zstd_codecs() {
  return {
      {"zstd19", {Mode::connectivity, Mode::lossless}, [] { return std::make_unique<Zstd>(); }}};
}

std::string zstd_version() {
  return ZSTD_versionString();
}

}  // namespace clers::bench
