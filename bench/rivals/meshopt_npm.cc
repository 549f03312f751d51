// One run of node encodes and decodes: rivals/meshopt_npm.mjs.
#include "bench/rivals/meshopt_npm.h"

#ifdef CLERS_BENCH_MESHOPTIMIZER_NPM

#include <unistd.h>

#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "bench/rivals/general.h"
#include "bench/rivals/meshopt.h"

namespace clers::bench {
namespace {

using Bytes = std::vector<std::uint8_t>;

// A folder that goes when its owner does.
struct Scratch {
  std::filesystem::path folder;
  Scratch() {
    std::string name = (std::filesystem::temp_directory_path() / "clers-bench-XXXXXX").string();
    if (!mkdtemp(name.data())) throw CodecFailure("no folder to be had");
    folder = name;
  }
  ~Scratch() {
    std::error_code ignored;
    std::filesystem::remove_all(folder, ignored);
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
};

template <class T>
void append(Bytes& out, const std::vector<T>& values) {
  const auto* first = reinterpret_cast<const std::uint8_t*>(values.data());
  out.insert(out.end(), first, first + values.size() * sizeof(T));
}

Bytes run_node(const Bytes& in) {
  const Scratch scratch;
  const std::string from = (scratch.folder / "in").string(), to = (scratch.folder / "out").string();
  std::ofstream(from, std::ios::binary)
      .write(reinterpret_cast<const char*>(in.data()), static_cast<std::streamsize>(in.size()));
  const std::string command = CLERS_BENCH_MESHOPTIMIZER_NPM " '" + from + "' '" + to + "'";
  if (std::system(command.c_str()) != 0) throw CodecFailure("node fails");
  std::ifstream out(to, std::ios::binary);
  return {std::istreambuf_iterator<char>(out), {}};
}

class MeshoptNpm : public Codec {
 public:
  void prepare(const Input& input, Mode mode) override {
    mode_ = mode;
    grid_ = bits(mode) ? grid_of(input, bits(mode)) : Grid{};
    corners_ = input.triangles.size();
    vertices_ = input.vertex_count;
    const Bytes values = meshopt_vertices(input, mode);
    stride_ = meshopt_stride(mode);
    in_.clear();
    append<std::uint32_t>(
        in_, {std::uint32_t(corners_), std::uint32_t(vertices_), std::uint32_t(stride_)});
    append(in_, input.triangles);
    append(in_, values);
  }

  void encode() override {
    out_ = run_node(in_);
    at_ = 0;
    const std::vector<std::uint32_t> head = take<std::uint32_t>(3);
    remap_ = take<std::uint32_t>(vertices_);
    used_ = head[0];
    const Bytes index = take<std::uint8_t>(head[1]), vertex = take<std::uint8_t>(head[2]);
    decoded_ = at_;
    index_bytes_ = zstd19(index.data(), index.size()).size();
    vertex_bytes_ = zstd19(vertex.data(), vertex.size()).size();
  }
  std::size_t bytes() const override {
    return meshopt_header(mode_) + index_bytes_ + vertex_bytes_;
  }
  std::size_t position_bytes() const override { return vertex_bytes_; }

  void decode() override {
    at_ = decoded_;
    indices_ = take<std::uint32_t>(corners_);
    values_ = take<std::uint8_t>(used_ * stride_);
  }
  void discard() override {}

  Output output() override {
    Output out;
    out.triangles = indices_;
    out.origin.resize(used_);
    for (std::uint32_t v = 0; v < remap_.size(); ++v)
      if (remap_[v] != ~0u) out.origin.at(remap_[v]) = v;
    out.positions.resize(3 * used_);
    if (bits(mode_)) {
      meshopt_off_grid(values_.data(), used_, grid_, out.positions.data());
    } else if (used_) {
      std::memcpy(out.positions.data(), values_.data(), values_.size());
    }
    return out;
  }

 private:
  template <class T>
  std::vector<T> take(std::size_t count) {
    const std::size_t size = count * sizeof(T);
    if (size > out_.size() - at_) throw CodecFailure("node gives too little");
    std::vector<T> values(count);
    if (size) std::memcpy(values.data(), out_.data() + at_, size);
    at_ += size;
    return values;
  }

  Mode mode_ = Mode::lossless;
  Grid grid_{};
  std::size_t corners_ = 0, vertices_ = 0, stride_ = 0, used_ = 0, at_ = 0, decoded_ = 0;
  std::size_t index_bytes_ = 0, vertex_bytes_ = 0;
  Bytes in_, out_, values_;
  std::vector<std::uint32_t> remap_, indices_;
};

}  // namespace

std::vector<CodecEntry> meshopt_npm_codecs() {
  return {{"meshopt-" CLERS_BENCH_MESHOPTIMIZER_NPM_VERSION "-strip-zstd19",
           {Mode::q11, Mode::q14, Mode::q16, Mode::lossless},
           [] { return std::make_unique<MeshoptNpm>(); },
           false}};
}
std::string meshopt_npm_version() {
  return CLERS_BENCH_MESHOPTIMIZER_NPM_VERSION " (WebAssembly; bytes alone)";
}

}  // namespace clers::bench

#else

namespace clers::bench {

std::vector<CodecEntry> meshopt_npm_codecs() {
  return {};
}
std::string meshopt_npm_version() {
  return "left out: the build found no node and npm";
}

}  // namespace clers::bench

#endif
