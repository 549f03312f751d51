// Connectivity: a mesh without attributes goes through the whole API, container, checksums and all;
// counted are the bytes of the connectivity section, as Draco's header is not counted either.
#include "bench/ours.h"

#include <cstring>
#include <iterator>
#include <string>

#include "codec/decode.h"
#include "codec/encode.h"

namespace clers::bench {
namespace {

class Clers : public Codec {
 public:
  explicit Clers(int level) { options_.level = level; }

  void prepare(const Input& input, Mode mode) override {
    mode_ = mode;
    mesh_ = mode == Mode::file ? input.file.meshes : std::vector<Mesh>{input.mesh};
    if (mode == Mode::connectivity) mesh_[0].attributes.clear();
    options_.precisions.clear();
    if (const int b = bits(mode))
      options_.precisions = {{std::string(position_name), Precision::of_bits(b), {}}};
  }

  void encode() override {
    auto encoded = clers::encode(mesh_, options_);
    if (!encoded) throw CodecFailure(describe(encoded.error()));
    encoded_ = std::move(*encoded);
  }
  std::size_t bytes() const override {
    return mode_ == Mode::connectivity
               ? static_cast<std::size_t>(encoded_.report.at(0).connectivity_bytes)
               : encoded_.bytes.size();
  }

  std::size_t position_bytes() const override {
    std::size_t sum = 0;
    for (const MeshInfo& info : encoded_.report) sum += info.position_bytes;
    return sum;
  }

  void decode() override {
    auto decoded = clers::decode(encoded_.bytes);
    if (!decoded) throw CodecFailure(describe(decoded.error()));
    decoded_ = std::move(*decoded);
  }
  void discard() override { decoded_.clear(); }

  Output output() override {
    Output out;
    if (mode_ == Mode::file) {
      out.meshes = decoded_;
      return out;
    }
    const Mesh& mesh = decoded_.at(0);
    out.triangles = mesh.corners;
    out.origin = encoded_.permutations.at(0).vertices;
    if (const Attribute* position = mesh.position()) {
      out.positions.resize(position->data.size() / sizeof(float));
      std::memcpy(out.positions.data(), position->data.data(), position->data.size());
    }
    return out;
  }

 private:
  EncodeOptions options_;
  Mode mode_ = Mode::connectivity;
  std::vector<Mesh> mesh_, decoded_;
  Encoded encoded_;
};

}  // namespace

std::vector<CodecEntry> clers_codecs() {
  std::vector<CodecEntry> entries;
  for (const int level : {1, 3, 5, 7, 9}) {
    std::vector<Mode> modes(std::begin(all_modes), std::end(all_modes));
    if (level == 7) modes.erase(modes.begin());  // its connectivity is that of level 5
    entries.push_back({"clers-" + std::to_string(level), std::move(modes),
                       [level] { return std::make_unique<Clers>(level); }});
  }
  return entries;
}

}  // namespace clers::bench
