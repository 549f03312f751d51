// Encoding includes the reordering of triangles and vertices, without which the sizes are not to
// be had. meshoptimizer stores what it is given, so the renumbering is known and nothing else than
// vertices that no triangle uses can be lost; the reordering drops those.
#include "bench/rivals/meshopt.h"

#include <meshoptimizer.h>

#include <cmath>

#include "bench/fidelity.h"
#include "bench/rivals/zstd.h"

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
    if (zstd_) index_bytes_ = zstd_compress(index_bytes_.data(), index_bytes_.size(), 19);
    if (mode_ != Mode::connectivity) encode_vertices(remap);
    remap_ = std::move(remap);
  }

  // What a decoder has to be told besides: three counts and, quantised, origin and step.
  std::size_t bytes() const override {
    const std::size_t header = mode_ == Mode::connectivity ? 0 : bits(mode_) ? 28 : 12;
    return header + index_bytes_.size() + vertex_bytes_.size();
  }

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
  using Quantised = std::uint16_t[4];  // the vertex codec wants multiples of four bytes

  void encode_vertices(const std::vector<std::uint32_t>& remap) {
    std::vector<std::uint8_t> raw;
    std::size_t stride;
    if (bits(mode_)) {
      stride = sizeof(Quantised);
      raw.resize(used_ * stride);
      auto* out = reinterpret_cast<Quantised*>(raw.data());
      for (std::size_t v = 0; v < remap.size(); ++v) {
        if (remap[v] == ~0u) continue;
        for (std::size_t k = 0; k < 3; ++k)
          out[remap[v]][k] = static_cast<std::uint16_t>(
              std::floor((input_->positions[3 * v + k] - grid_.origin[k]) / grid_.step + 0.5f));
      }
    } else {
      stride = 3 * sizeof(float);
      raw.resize(used_ * stride);
      meshopt_remapVertexBuffer(raw.data(), input_->positions.data(), remap.size(), stride,
                                remap.data());
    }
    vertex_bytes_.resize(meshopt_encodeVertexBufferBound(used_, stride));
    vertex_bytes_.resize(meshopt_encodeVertexBuffer(vertex_bytes_.data(), vertex_bytes_.size(),
                                                    raw.data(), used_, stride));
    raw_vertex_size_ = vertex_bytes_.size();
    if (zstd_) vertex_bytes_ = zstd_compress(vertex_bytes_.data(), vertex_bytes_.size(), 19);
  }

  void decode_vertices() {
    const std::vector<std::uint8_t> inflated = inflate(vertex_bytes_, raw_vertex_size_);
    const std::vector<std::uint8_t>& bytes = zstd_ ? inflated : vertex_bytes_;
    out_positions_.reset(new float[3 * used_]);
    if (!bits(mode_)) return decode_vertices_to(out_positions_.get(), 12, bytes);
    const std::unique_ptr<Quantised[]> grid(new Quantised[used_]);
    decode_vertices_to(grid.get(), sizeof(Quantised), bytes);
    for (std::size_t v = 0; v < used_; ++v)
      for (std::size_t k = 0; k < 3; ++k)
        out_positions_[3 * v + k] = grid_.origin[k] + static_cast<float>(grid[v][k]) * grid_.step;
  }

  void decode_vertices_to(void* out, std::size_t stride, const std::vector<std::uint8_t>& bytes) {
    if (meshopt_decodeVertexBuffer(out, used_, stride, bytes.data(), bytes.size()) != 0)
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

}  // namespace

std::vector<CodecEntry> meshopt_codecs() {
  const std::vector<Mode> connectivity = {Mode::connectivity};
  const std::vector<Mode> all(std::begin(all_modes), std::end(all_modes));
  const auto entry = [](std::string row, std::vector<Mode> modes, Order order, bool zstd) {
    return CodecEntry{std::move(row), std::move(modes),
                      [=] { return std::make_unique<Meshopt>(order, zstd); }};
  };
  return {entry("meshopt-vcache", connectivity, Order::cache, false),
          entry("meshopt-vcache-zstd19", all, Order::cache, true),
          entry("meshopt-strip", connectivity, Order::strip, false),
          entry("meshopt-strip-zstd19", all, Order::strip, true)};
}

std::string meshopt_version() {
  const int v = MESHOPTIMIZER_VERSION;
  const std::string package = CLERS_BENCH_MESHOPTIMIZER_PACKAGE;
  return std::to_string(v / 1000) + "." + std::to_string(v / 10 % 100) +
         (package.empty() ? "" : " (the distribution's " + package + ")");
}

}  // namespace clers::bench
