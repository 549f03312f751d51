// Encoding includes the reordering of triangles and vertices, without which the sizes are not to
// be had. meshoptimizer stores what it is given, so the renumbering is known and nothing else than
// vertices that no triangle uses can be lost; the reordering drops those.
#include "bench/rivals/meshopt.h"

#include <meshoptimizer.h>

#include <cstring>

#include "bench/rivals/general.h"

namespace clers::bench {
namespace {

enum class Order { cache, strip };

class Meshopt : public Codec {
 public:
  Meshopt(Order order, bool zstd) : order_(order), zstd_(zstd) {}

  void prepare(const Input& input, Mode mode) override {
    mode_ = mode;
    input_ = &input;
    grid_ = bits(mode) ? grid_of(input, bits(mode)) : Grid{};
  }

  void encode() override {
    const std::vector<std::uint32_t>& triangles = input_->triangles;
    const std::size_t corners = triangles.size(), vertices = input_->vertex_count;
    std::vector<std::uint32_t> indices(corners), remap(vertices);
    if (order_ == Order::cache) {
      meshopt_optimizeVertexCache(indices.data(), triangles.data(), corners, vertices);
    } else {
      meshopt_optimizeVertexCacheStrip(indices.data(), triangles.data(), corners, vertices);
    }
    used_ = meshopt_optimizeVertexFetchRemap(remap.data(), indices.data(), corners, vertices);
    meshopt_remapIndexBuffer(indices.data(), indices.data(), corners, remap.data());

    meshopt_encodeIndexVersion(1);
    index_bytes_.resize(meshopt_encodeIndexBufferBound(corners, used_));
    index_bytes_.resize(meshopt_encodeIndexBuffer(index_bytes_.data(), index_bytes_.size(),
                                                  indices.data(), corners));
    raw_index_size_ = index_bytes_.size();
    if (zstd_) index_bytes_ = zstd19(index_bytes_.data(), index_bytes_.size());
    if (mode_ != Mode::connectivity) encode_vertices(remap);
    remap_ = std::move(remap);
  }

  std::size_t bytes() const override {
    return meshopt_header(mode_) + index_bytes_.size() + vertex_bytes_.size();
  }
  std::size_t position_bytes() const override { return vertex_bytes_.size(); }

  void decode() override {
    const std::size_t corners = input_->triangles.size();
    const std::vector<std::uint8_t> index_raw = inflate(index_bytes_, raw_index_size_);
    const std::vector<std::uint8_t>& index = zstd_ ? index_raw : index_bytes_;
    out_indices_.reset(new std::uint32_t[corners]);
    if (meshopt_decodeIndexBuffer(out_indices_.get(), corners, 4, index.data(), index.size()) != 0)
      throw CodecFailure("meshopt_decodeIndexBuffer refuses the bytes");
    if (mode_ != Mode::connectivity) decode_vertices();
  }
  void discard() override {
    out_indices_.reset();
    out_positions_.reset();
  }

  Output output() override {
    Output out;
    out.triangles.assign(out_indices_.get(), out_indices_.get() + input_->triangles.size());
    out.origin.resize(used_);
    for (std::uint32_t v = 0; v < remap_.size(); ++v)
      if (remap_[v] != ~0u) out.origin[remap_[v]] = v;
    if (out_positions_)
      out.positions.assign(out_positions_.get(), out_positions_.get() + 3 * used_);
    return out;
  }

 private:
  void encode_vertices(const std::vector<std::uint32_t>& remap) {
    const std::vector<std::uint8_t> values = meshopt_vertices(*input_, mode_);
    const std::size_t stride = meshopt_stride(mode_);
    std::vector<std::uint8_t> raw(used_ * stride);
    meshopt_remapVertexBuffer(raw.data(), values.data(), remap.size(), stride, remap.data());
    vertex_bytes_.resize(meshopt_encodeVertexBufferBound(used_, stride));
    vertex_bytes_.resize(meshopt_encodeVertexBuffer(vertex_bytes_.data(), vertex_bytes_.size(),
                                                    raw.data(), used_, stride));
    raw_vertex_size_ = vertex_bytes_.size();
    if (zstd_) vertex_bytes_ = zstd19(vertex_bytes_.data(), vertex_bytes_.size());
  }

  void decode_vertices() {
    const std::vector<std::uint8_t> inflated = inflate(vertex_bytes_, raw_vertex_size_);
    const std::vector<std::uint8_t>& bytes = zstd_ ? inflated : vertex_bytes_;
    out_positions_.reset(new float[3 * used_]);
    if (!bits(mode_)) return decode_vertices_to(out_positions_.get(), bytes);
    const std::unique_ptr<std::uint8_t[]> numbers(new std::uint8_t[meshopt_stride(mode_) * used_]);
    decode_vertices_to(numbers.get(), bytes);
    meshopt_off_grid(numbers.get(), used_, grid_, out_positions_.get());
  }

  void decode_vertices_to(void* out, const std::vector<std::uint8_t>& bytes) {
    if (meshopt_decodeVertexBuffer(out, used_, meshopt_stride(mode_), bytes.data(), bytes.size()) !=
        0)
      throw CodecFailure("meshopt_decodeVertexBuffer refuses the bytes");
  }

  std::vector<std::uint8_t> inflate(const std::vector<std::uint8_t>& frame, std::size_t size) {
    std::vector<std::uint8_t> raw;
    if (!zstd_) return raw;
    raw.resize(size);
    zstd_decompress(frame, raw.data(), size);
    return raw;
  }

  Order order_;
  bool zstd_;
  Mode mode_ = Mode::connectivity;
  const Input* input_ = nullptr;
  Grid grid_{};
  std::size_t used_ = 0;  // vertices that a triangle uses
  std::size_t raw_index_size_ = 0, raw_vertex_size_ = 0;
  std::vector<std::uint32_t> remap_;
  std::vector<std::uint8_t> index_bytes_, vertex_bytes_;
  std::unique_ptr<std::uint32_t[]> out_indices_;
  std::unique_ptr<float[]> out_positions_;
};

std::string release() {
  const int v = MESHOPTIMIZER_VERSION;
  return std::to_string(v / 1000) + "." + std::to_string(v / 10 % 100);
}

}  // namespace

std::vector<std::uint8_t> meshopt_vertices(const Input& input, Mode mode) {
  const std::size_t stride = meshopt_stride(mode), size = stride * input.vertex_count;
  std::vector<std::uint8_t> vertices(size, 0);
  if (!bits(mode)) {
    if (size) std::memcpy(vertices.data(), input.positions.data(), size);
    return vertices;
  }
  const std::vector<std::uint16_t> numbers = on_grid(input.positions, grid_of(input, bits(mode)));
  for (std::size_t v = 0; v < input.vertex_count; ++v)
    std::memcpy(&vertices[stride * v], &numbers[3 * v], 3 * sizeof(std::uint16_t));
  return vertices;
}

void meshopt_off_grid(const std::uint8_t* vertices, std::size_t count, const Grid& grid,
                      float* positions) {
  for (std::size_t v = 0; v < count; ++v) {
    std::uint16_t numbers[4];
    std::memcpy(numbers, vertices + sizeof numbers * v, sizeof numbers);
    for (std::size_t k = 0; k < 3; ++k)
      positions[3 * v + k] = grid.origin[k] + static_cast<float>(numbers[k]) * grid.step;
  }
}

std::vector<CodecEntry> meshopt_codecs() {
  const std::vector<Mode> connectivity = {Mode::connectivity};
  const std::vector<Mode> all = {Mode::connectivity, Mode::q11, Mode::q14, Mode::q16,
                                 Mode::lossless};
  const auto entry = [](const char* row, std::vector<Mode> modes, Order order, bool zstd) {
    return CodecEntry{"meshopt-" + release() + row, std::move(modes),
                      [=] { return std::make_unique<Meshopt>(order, zstd); }};
  };
  return {entry("-vcache", connectivity, Order::cache, false),
          entry("-vcache-zstd19", all, Order::cache, true),
          entry("-strip", connectivity, Order::strip, false),
          entry("-strip-zstd19", all, Order::strip, true)};
}

std::string meshopt_version() {
  const std::string package = CLERS_BENCH_MESHOPTIMIZER_PACKAGE;
  return release() + (package.empty() ? "" : " (the distribution's " + package + ")");
}

}  // namespace clers::bench
