#include "bench/rivals/openctm.h"

#include <openctm.h>

#include <algorithm>
#include <cstring>

#include "bench/fidelity.h"

namespace clers::bench {
namespace {

using Bytes = std::vector<std::uint8_t>;

struct Context {
  explicit Context(CTMenum mode) : handle(ctmNewContext(mode)) {}
  ~Context() { ctmFreeContext(handle); }
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;

  void require() const {
    if (const CTMenum error = ctmGetError(handle); error != CTM_NONE)
      throw CodecFailure(ctmErrorString(error));
  }

  CTMcontext handle;
};

CTMuint CTMCALL append(const void* data, CTMuint size, void* bytes) {
  const auto* first = static_cast<const std::uint8_t*>(data);
  auto& out = *static_cast<Bytes*>(bytes);
  out.insert(out.end(), first, first + size);
  return size;
}

struct Source {
  const Bytes* bytes;
  std::size_t at = 0;
};

CTMuint CTMCALL take(void* data, CTMuint size, void* user) {
  auto& source = *static_cast<Source*>(user);
  const std::size_t n = std::min<std::size_t>(size, source.bytes->size() - source.at);
  std::memcpy(data, source.bytes->data() + source.at, n);
  source.at += n;
  return static_cast<CTMuint>(n);
}

class OpenCtm : public Codec {
 public:
  explicit OpenCtm(CTMenum method) : method_(method) {}

  void prepare(const Input& input, Mode mode) override {
    input_ = &input;
    if (bits(mode)) step_ = grid_of(input, bits(mode)).step;
  }

  void encode() override {
    bytes_.clear();
    save(bytes_, nullptr);
  }
  std::size_t bytes() const override { return bytes_.size(); }

  void decode() override {
    decoded_ = std::make_unique<Context>(CTM_IMPORT);
    load(*decoded_, bytes_);
  }
  void discard() override { decoded_.reset(); }

  // MG2 sorts the vertices: a second run carries their numbers as an attribute of step 1.
  Output output() override {
    std::vector<float> ids(4 * std::size_t(input_->vertex_count), 0.0f);
    for (std::size_t v = 0; v < input_->vertex_count; ++v) {
      ids[4 * v] = static_cast<float>(v & 0xffff);
      ids[4 * v + 1] = static_cast<float>(v >> 16);
    }
    Bytes numbered;
    save(numbered, &ids);
    Context witness(CTM_IMPORT);
    load(witness, numbered);

    Output out;
    out.triangles = indices(*decoded_);
    if (out.triangles != indices(witness))
      throw CodecFailure("the run that follows the vertices gives other faces");
    const CTMuint count = ctmGetInteger(decoded_->handle, CTM_VERTEX_COUNT);
    const CTMfloat* xyz = ctmGetFloatArray(decoded_->handle, CTM_VERTICES);
    const CTMfloat* id = ctmGetFloatArray(witness.handle, CTM_ATTRIB_MAP_1);
    if (!xyz || !id) throw CodecFailure("an array is missing");
    out.positions.assign(xyz, xyz + 3 * std::size_t(count));
    for (std::size_t v = 0; v < count; ++v)
      out.origin.push_back(static_cast<std::uint32_t>(id[4 * v] + 0.5f) +
                           (static_cast<std::uint32_t>(id[4 * v + 1] + 0.5f) << 16));
    return out;
  }

 private:
  void save(Bytes& out, const std::vector<float>* ids) const {
    const Context context(CTM_EXPORT);
    ctmDefineMesh(context.handle, input_->positions.data(), input_->vertex_count,
                  input_->triangles.data(), static_cast<CTMuint>(input_->triangle_count()),
                  nullptr);
    context.require();
    ctmCompressionMethod(context.handle, method_);
    if (method_ == CTM_METHOD_MG2) ctmVertexPrecision(context.handle, step_);
    if (ids) {
      const CTMenum map = ctmAddAttribMap(context.handle, ids->data(), "id");
      ctmAttribPrecision(context.handle, map, 1.0f);
    }
    context.require();
    ctmSaveCustom(context.handle, append, &out);
    context.require();
  }

  static void load(Context& context, const Bytes& bytes) {
    Source source{&bytes};
    ctmLoadCustom(context.handle, take, &source);
    context.require();
  }

  static std::vector<std::uint32_t> indices(const Context& context) {
    const CTMuint* first = ctmGetIntegerArray(context.handle, CTM_INDICES);
    if (!first) throw CodecFailure("an array is missing");
    return {first, first + 3 * std::size_t(ctmGetInteger(context.handle, CTM_TRIANGLE_COUNT))};
  }

  CTMenum method_;
  const Input* input_ = nullptr;
  float step_ = 0;
  Bytes bytes_;
  std::unique_ptr<Context> decoded_;
};

}  // namespace

std::vector<CodecEntry> openctm_codecs() {
  return {
      {"openctm-mg1", {Mode::lossless}, [] { return std::make_unique<OpenCtm>(CTM_METHOD_MG1); }},
      {"openctm-mg2", {Mode::q11, Mode::q14, Mode::q16}, [] {
         return std::make_unique<OpenCtm>(CTM_METHOD_MG2);
       }}};
}

std::string openctm_version() {
  const std::string package = CLERS_BENCH_OPENCTM_PACKAGE;
  const std::string release = package.substr(0, package.find('+'));
  return package.empty() ? "of unknown release" : release + " (the distribution's " + package + ")";
}

}  // namespace clers::bench
