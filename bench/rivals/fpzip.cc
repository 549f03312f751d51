#include "bench/rivals/fpzip.h"

#include <fpzip.h>

#include <numeric>

#include "bench/rivals/general.h"

namespace clers::bench {
namespace {

using Bytes = std::vector<std::uint8_t>;

// What the array is said to be.
enum class Shape {
  line,    // x y z x y z ..
  rows,    // rows of three
  fields,  // all x, all y, all z
};

void set_size(FPZ& stream, Shape shape, std::size_t vertices) {
  const int n = static_cast<int>(vertices);
  stream.type = FPZIP_TYPE_FLOAT;
  stream.prec = 0;
  stream.nx = shape == Shape::line ? 3 * n : shape == Shape::rows ? 3 : n;
  stream.ny = shape == Shape::rows ? n : 1;
  stream.nz = 1;
  stream.nf = shape == Shape::fields ? 3 : 1;
}

Bytes compress(const std::vector<float>& values, Shape shape) {
  Bytes bytes(values.size() * sizeof(float) * 2 + 1024);
  FPZ* stream = fpzip_write_to_buffer(bytes.data(), bytes.size());
  set_size(*stream, shape, values.size() / 3);
  const std::size_t size = fpzip_write(stream, values.data());
  fpzip_write_close(stream);
  if (size == 0) throw CodecFailure("fpzip cannot compress it");
  bytes.resize(size);
  return bytes;
}

// All x, all y, all z; and back.
std::vector<float> by_fields(const std::vector<float>& values, bool back) {
  const std::size_t n = values.size() / 3;
  std::vector<float> out(values.size());
  for (std::size_t v = 0; v < n; ++v)
    for (std::size_t k = 0; k < 3; ++k)
      (back ? out[3 * v + k] : out[k * n + v]) = back ? values[k * n + v] : values[3 * v + k];
  return out;
}

class Fpzip : public Codec {
 public:
  void prepare(const Input& input, Mode) override {
    input_ = &input;
    std::size_t least = SIZE_MAX;
    for (const Shape shape : {Shape::line, Shape::rows, Shape::fields}) {
      const std::size_t size = compress(values_for(shape), shape).size();
      if (size < least) least = size, shape_ = shape;
    }
  }

  void encode() override {
    positions_ = compress(values_for(shape_), shape_);
    indices_ = zstd19(input_->triangles.data(), 4 * input_->triangles.size());
  }
  // What a decoder has to be told besides: two counts and the shape.
  std::size_t bytes() const override { return positions_.size() + indices_.size() + 9; }
  std::size_t position_bytes() const override { return positions_.size(); }

  void decode() override {
    out_indices_.resize(input_->triangles.size());
    zstd_decompress(indices_, out_indices_.data(), 4 * out_indices_.size());
    out_positions_.resize(input_->positions.size());
    FPZ* stream = fpzip_read_from_buffer(positions_.data());
    set_size(*stream, shape_, input_->vertex_count);
    const std::size_t size = fpzip_read(stream, out_positions_.data());
    fpzip_read_close(stream);
    if (size == 0) throw CodecFailure("fpzip refuses the bytes");
    if (shape_ == Shape::fields) out_positions_ = by_fields(out_positions_, true);
  }
  void discard() override { out_indices_ = {}, out_positions_ = {}; }

  Output output() override {
    Output out;
    out.triangles = out_indices_;
    out.origin.resize(input_->vertex_count);
    std::iota(out.origin.begin(), out.origin.end(), 0u);
    out.positions = out_positions_;
    return out;
  }

 private:
  std::vector<float> values_for(Shape shape) const {
    return shape == Shape::fields ? by_fields(input_->positions, false) : input_->positions;
  }

  const Input* input_ = nullptr;
  Shape shape_ = Shape::line;
  Bytes positions_, indices_;
  std::vector<std::uint32_t> out_indices_;
  std::vector<float> out_positions_;
};

}  // namespace

std::vector<CodecEntry> fpzip_codecs() {
  return {{"fpzip-zstd19", {Mode::lossless}, [] { return std::make_unique<Fpzip>(); }}};
}

std::string fpzip_version() {
  return FPZIP_VERSION_STRING;
}

}  // namespace clers::bench
