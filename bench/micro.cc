// micro: the parts of an encode and a decode, one by one (Google Benchmark). The counter is
// triangles a second, for the range coder symbols, for the checksum bytes.
//
// Each part runs on a torus, where all is regular, and on one with randomly flipped edges, where
// little can be predicted.
#include <benchmark/benchmark.h>
#include <xxhash.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>

#include "codec/attributes/attribute_decoder.h"
#include "codec/attributes/attribute_encoder.h"
#include "codec/attributes/prediction.h"
#include "codec/connectivity/connectivity.h"
#include "codec/decode.h"
#include "codec/encode.h"
#include "codec/entropy/rans.h"
#include "codec/soup/adjacency.h"
#include "codec/symbols/context_models.h"
#include "corpus/generate.h"
#include "topology/front.h"

namespace clers {
namespace {

using namespace internal;

enum Shape { regular, irregular };

void shapes(benchmark::internal::Benchmark* b) {
  b->ArgName("irregular")->Arg(regular)->Arg(irregular);
}

const Mesh& mesh_of(benchmark::State& state) {
  static const Mesh meshes[] = {
      corpus::torus(300, 300),
      corpus::flip_edges(corpus::torus(300, 300), 900000, 1),
  };
  return meshes[state.range(0)];
}

template <class T>
T must(Expected<T> result) {
  if (!result) std::abort();
  return std::move(*result);
}

void count_items(benchmark::State& state, std::size_t items) {
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(items));
}

struct Surface {
  std::vector<std::uint32_t> corners;
  std::vector<HalfEdge> twins;
  std::uint32_t vertices;

  explicit Surface(const Mesh& mesh)
      : corners(mesh.corners),
        twins(must(find_twins({mesh.corners, mesh.face_sizes}, mesh.vertex_count))),
        vertices(mesh.vertex_count) {}
};

EncodedConnectivity encoded(const Surface& s) {
  std::vector<HalfEdge> twins = s.twins;
  return must(encode_connectivity({s.corners, twins, s.vertices}, default_level));
}

void adjacency(benchmark::State& state) {
  const Mesh& mesh = mesh_of(state);
  for (auto _ : state)
    benchmark::DoNotOptimize(must(find_twins({mesh.corners, mesh.face_sizes}, mesh.vertex_count)));
  count_items(state, mesh.face_count());
}
BENCHMARK(adjacency)->Apply(shapes);

// Unbuilding by detach and unglue, until every triangle has its symbol and its context.
void traversal(benchmark::State& state) {
  const Surface s(mesh_of(state));
  std::vector<HalfEdge> twins(s.twins.size());
  for (auto _ : state) {
    std::copy(s.twins.begin(), s.twins.end(), twins.begin());
    NoWitness witness;
    benchmark::DoNotOptimize(
        Edgebreaker<TriangleFaces, NoWitness, true>({s.corners, twins, s.vertices}, witness, false)
            .run());
  }
  count_items(state, s.twins.size() / 3);
}
BENCHMARK(traversal)->Apply(shapes);

// Traversal, choice of model, coding.
void connectivity_encode(benchmark::State& state) {
  const Surface s(mesh_of(state));
  for (auto _ : state) benchmark::DoNotOptimize(encoded(s));
  count_items(state, s.twins.size() / 3);
}
BENCHMARK(connectivity_encode)->Apply(shapes);

void connectivity_decode(benchmark::State& state) {
  const std::vector<std::byte> bytes = encoded(Surface(mesh_of(state))).bytes;
  for (auto _ : state) {
    const ConnectivityHeader header = must(read_connectivity_header(bytes, 0));
    std::vector<std::uint32_t> corners(3 * std::size_t(header.faces));
    must(decode_connectivity(bytes, 0, header, corners));
    benchmark::DoNotOptimize(corners.data());
  }
  count_items(state, mesh_of(state).face_count());
}
BENCHMARK(connectivity_decode)->Apply(shapes);

// Symbols in the order and with the valences in which a decoder meets them are not to be had from
// outside; half C at one valence, the rest spread, costs the model as much.
std::vector<Clers> symbols(std::size_t n) {
  std::vector<Clers> all(n);
  std::uint32_t random = 1;
  for (Clers& symbol : all) {
    random = random * 1664525u + 1013904223u;
    const std::uint32_t r = random >> 28;
    symbol = r < 8    ? Clers::C
             : r < 13 ? Clers::R
             : r < 14 ? Clers::L
             : r < 15 ? Clers::S
                      : Clers::E;
  }
  return all;
}

std::vector<std::byte> coded(const std::vector<Clers>& all) {
  SingleModel model(3);
  rans::Encoder out;
  out.reserve(all.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    const rans::Interval interval = model.encode(all[i], 4 + static_cast<std::uint32_t>(i % 4));
    out.put(interval.start, interval.size);
  }
  std::vector<std::byte> bytes;
  out.finish(bytes);
  return bytes;
}

void symbol_encode(benchmark::State& state) {
  const std::vector<Clers> all = symbols(200000);
  for (auto _ : state) benchmark::DoNotOptimize(coded(all));
  count_items(state, all.size());
}
BENCHMARK(symbol_encode);

void symbol_decode(benchmark::State& state) {
  const std::vector<Clers> all = symbols(200000);
  const std::vector<std::byte> bytes = coded(all);
  for (auto _ : state) {
    SingleModel model(3);
    rans::Decoder in(bytes);
    NoPairing none;
    const Front<NoPairing> front(nullptr, none);
    using Gate = Front<NoPairing>::Gate;
    for (std::size_t i = 0; i < all.size(); ++i)
      benchmark::DoNotOptimize(model.decode(in, front,
                                            Gate{.kx = 4 + static_cast<std::uint32_t>(i % 4)}, 0,
                                            [](auto symbol) { return Clers(symbol()); }));
  }
  count_items(state, all.size());
}
BENCHMARK(symbol_decode);

/// The mesh of a benchmark as it is decoded, with what attributes are predicted along.
struct CodedMesh {
  explicit CodedMesh(const Mesh& input)
      : mesh(must(decode(must(encode({&input, 1})).bytes)).at(0)),
        introduced_by(mesh.vertex_count),
        twins(must(find_twins({mesh.corners, {}}, mesh.vertex_count))) {
    find_introducing(mesh.corners, introduced_by);
  }
  CodedSurface surface() const { return {mesh.corners, twins, introduced_by}; }

  Mesh mesh;
  std::vector<std::uint32_t> introduced_by;
  std::vector<HalfEdge> twins;
};

// The parallelogram rule alone, on a mesh in the codec's order.
void prediction(benchmark::State& state) {
  const CodedMesh coded(mesh_of(state));
  Bytes keys = coded.mesh.position()->data, residuals(keys.size());
  for (std::size_t i = 0; i < keys.size() / 4; ++i)
    set_word(keys.data(), i, to_ordered(word_at<std::uint32_t>(keys.data(), i)));
  for (auto _ : state) {
    subtract_predictions<std::uint32_t>(Predictor::parallelogram, coded.mesh.vertex_count,
                                        std::size_t{3}, coded.surface(), keys.data(),
                                        residuals.data());
    benchmark::DoNotOptimize(residuals.data());
    benchmark::ClobberMemory();
  }
  count_items(state, coded.mesh.face_count());
}
BENCHMARK(prediction)->Apply(shapes);

// Number systems and the coder of positions, at the default level.
void position_encode(benchmark::State& state) {
  const CodedMesh coded(mesh_of(state));
  for (auto _ : state)
    benchmark::DoNotOptimize(
        must(encode_attribute(*coded.mesh.position(), {}, {coded.surface()}, default_level)));
  count_items(state, coded.mesh.face_count());
}
BENCHMARK(position_encode)->Apply(shapes);

void position_decode(benchmark::State& state) {
  const CodedMesh coded(mesh_of(state));
  const Bytes bytes =
      must(encode_attribute(*coded.mesh.position(), {}, {coded.surface()}, default_level)).bytes;
  const AttributeHeader header = must(read_attribute_header(bytes, 0));
  const std::uint32_t count = coded.mesh.vertex_count;
  for (auto _ : state)
    benchmark::DoNotOptimize(
        must(finish_attribute(bytes, 0, header, count,
                              must(begin_attribute(bytes, 0, header, count)), {coded.surface()})));
  count_items(state, coded.mesh.face_count());
}
BENCHMARK(position_decode)->Apply(shapes);

void checksum(benchmark::State& state) {
  const std::vector<std::byte> bytes(1 << 20);
  for (auto _ : state) benchmark::DoNotOptimize(XXH32(bytes.data(), bytes.size(), 0));
  state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(bytes.size()));
}
BENCHMARK(checksum);

void whole_encode(benchmark::State& state) {
  const Mesh& mesh = mesh_of(state);
  for (auto _ : state) benchmark::DoNotOptimize(must(encode({&mesh, 1})));
  count_items(state, mesh.face_count());
}
BENCHMARK(whole_encode)->Apply(shapes);

void whole_decode(benchmark::State& state) {
  const Mesh& mesh = mesh_of(state);
  const std::vector<std::byte> bytes = must(encode({&mesh, 1})).bytes;
  for (auto _ : state) benchmark::DoNotOptimize(must(decode(bytes)));
  count_items(state, mesh.face_count());
}
BENCHMARK(whole_decode)->Apply(shapes);

}  // namespace
}  // namespace clers

BENCHMARK_MAIN();
