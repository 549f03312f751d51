// Connectivity through the codec and back, checked by a correspondence of half-edges: every decoded
// half-edge names the one it came from, and twins must go with twins.
#include "codec/connectivity/connectivity.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

#include "codec/connectivity/spirale_reversi.h"
#include "codec/connectivity/stream_source.h"
#include "codec/soup/adjacency.h"
#include "codec/test/coded_surface.h"
#include "codec/test/correspondence.h"
#include "corpus/enumerate.h"
#include "corpus/generate.h"
#include "corpus/random_gluing.h"
#include "topology/mirror.h"

namespace clers::internal {
namespace {

/// Arrays that own their memory.
struct Arrays {
  std::vector<std::uint32_t> org;
  std::vector<HalfEdge> twins;
  std::uint32_t vertex_count = 0;
};

Arrays arrays_of(const Mesh& mesh) {
  auto twins = find_twins({mesh.corners, mesh.face_sizes}, mesh.vertex_count);
  EXPECT_TRUE(twins.ok()) << (twins.ok() ? "" : describe(twins.error()));
  return {mesh.corners, twins.ok() ? *twins : std::vector<HalfEdge>(), mesh.vertex_count};
}

Arrays arrays_of(const corpus::Gluing& gluing) {
  Arrays a{gluing.org, {}, gluing.vertex_count};
  for (const std::uint32_t t : gluing.twin) a.twins.emplace_back(t);
  return a;
}

/// The first `count` bytes in memory of exactly that size, so that reading past them is seen.
std::vector<std::byte> exactly(std::span<const std::byte> bytes, std::size_t count) {
  return {bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(count)};
}

struct Decoded {
  std::vector<std::uint32_t> corners;
  std::vector<HalfEdge> twins;
  ConnectivityCounts counts;
};

Expected<Decoded> decode(std::span<const std::byte> bytes) {
  auto header = read_connectivity_header(bytes, 0);
  if (!header) return Failure{header.error()};
  Decoded d;
  d.corners.resize(3 * std::size_t(header->faces));
  d.twins.resize(d.corners.size());
  std::vector<std::uint32_t> introduced_by(header->vertices);
  auto counts = decode_connectivity(bytes, 0, *header, d.corners, d.twins, introduced_by);
  if (!counts) return Failure{counts.error()};
  d.counts = *counts;
  if (std::string fault = fault_of({d.corners, d.twins, introduced_by}); !fault.empty())
    return fail(ErrorCode::internal, std::move(fault));
  std::vector<std::uint32_t> again(d.corners.size());  // the path without twins
  if (!decode_connectivity(bytes, 0, *header, again) || again != d.corners)
    return fail(ErrorCode::internal, "decoding with and without twins differ");
  return d;
}

::testing::AssertionResult same(const Arrays& in, const EncodedConnectivity& coded,
                                const Decoded& out) {
  const std::string difference = difference_of(in.org, in.twins, coded, out.corners, out.twins);
  return (difference.empty() ? ::testing::AssertionSuccess() : ::testing::AssertionFailure())
         << difference;
}

/// Counts of a surface that share no code with the codec: flood fill over twins, walks of fans.
Characteristic count(const Arrays& a, std::int64_t& closed) {
  Characteristic c;
  const std::size_t n = a.org.size();
  c.f = static_cast<std::int64_t>(n / 3);
  std::vector<bool> face(n / 3), side(n);
  std::set<std::uint32_t> vertices(a.org.begin(), a.org.end());
  c.v = static_cast<std::int64_t>(vertices.size());
  closed = 0;
  for (std::uint32_t h = 0; h < n; ++h) c.e += !a.twins[h] || h < a.twins[h].index();
  for (std::uint32_t f = 0; f < n / 3; ++f) {
    if (face[f]) continue;
    ++c.s;
    bool open = false;
    std::vector<std::uint32_t> todo = {f};
    face[f] = true;
    while (!todo.empty()) {
      const std::uint32_t g = todo.back();
      todo.pop_back();
      for (unsigned i = 0; i < 3; ++i) {
        const HalfEdge t = a.twins[3 * g + i];
        if (!t) {
          open = true;
        } else if (!face[left(t).index()]) {
          face[left(t).index()] = true;
          todo.push_back(left(t).index());
        }
      }
    }
    closed += !open;
  }
  for (std::uint32_t h = 0; h < n; ++h) {
    if (a.twins[h] || side[h]) continue;
    ++c.b;
    HalfEdge g(h);
    do {
      side[g.index()] = true;
      g = lnext(g);
      while (a.twins[g.index()]) g = lnext(a.twins[g.index()]);
    } while (g != HalfEdge(h));
  }
  c.g = (2 * c.s - c.b - c.euler()) / 2;
  return c;
}

/// Everything that must hold of one surface.
void check(const Arrays& in, int level) {
  Arrays consumed = in;
  auto coded = encode_connectivity({consumed.org, consumed.twins, consumed.vertex_count}, level);
  ASSERT_TRUE(coded.ok()) << describe(coded.error());
  auto out = decode(coded->bytes);
  ASSERT_TRUE(out.ok()) << describe(out.error());
  ASSERT_TRUE(same(in, *coded, *out));
  EXPECT_EQ(coded->counts.symbols, out->counts.symbols);

  // The fast operators and those on the full surface: equal bytes, equal traces, either way.
  consumed = in;
  OperatorTrace unbuilt;
  auto full = encode_connectivity_on_surface({consumed.org, consumed.twins, consumed.vertex_count},
                                             level, unbuilt);
  ASSERT_TRUE(full.ok()) << describe(full.error());
  EXPECT_EQ(coded->bytes, full->bytes);
  EXPECT_EQ(coded->vertices, full->vertices);
  OperatorTrace built;
  {
    const auto header = *read_connectivity_header(coded->bytes, 0);
    std::vector<std::uint32_t> corners(3 * std::size_t(header.faces));
    std::vector<FrontLink> links(header.vertices + header.merges);
    Building building;
    building.corners = corners;
    building.links = links;
    Tracing tracing;
    with_stream_source(header, coded->bytes, [&](auto& source) {
      using Source = std::remove_reference_t<decltype(source)>;
      ASSERT_EQ((SpiraleReversi<Tracing, Source>(building, tracing, source).run().broken),
                StreamFault::none);
    });
    built = std::move(tracing.trace);
  }
  EXPECT_TRUE(std::equal(built.begin(), built.end(), unbuilt.rbegin(), unbuilt.rend()));

  // As many operators of each kind as the surface's counts say, and through Λ those counts again.
  std::int64_t closed = 0;
  const Characteristic c = count(in, closed);
  const OperatorCounts n = count_operators(built);
  EXPECT_EQ(lambda(n), c);
  EXPECT_EQ(n.create, c.f);
  EXPECT_EQ(n.join_components, c.f - c.s);
  EXPECT_EQ(n.join_curves, c.g);
  EXPECT_EQ(n.split_curve, c.g + c.b - (c.s - closed));
  EXPECT_EQ(n.close, closed);
  EXPECT_EQ(out->counts.components, static_cast<std::uint64_t>(c.s));
  EXPECT_EQ(out->counts.boundary_curves, static_cast<std::uint64_t>(c.b));
  EXPECT_EQ(out->counts.handles, static_cast<std::uint64_t>(c.g));
  if (c.s == 1 && closed == 1) {
    const auto symbol = [&](Clers l) {
      return static_cast<std::int64_t>(out->counts.symbols[static_cast<unsigned>(l)]);
    };
    EXPECT_EQ(symbol(Clers::S) - symbol(Clers::E), 2 * c.g - 1);
    EXPECT_EQ(n.zip, c.v - 2);
  }
}

/// At the default level, and at one of the others.
void check(const Arrays& in) {
  constexpr int others[] = {1, 3, 9};
  for (const int level : {5, others[(in.org.size() / 3 + in.vertex_count) % 3]}) {
    SCOPED_TRACE(level);
    check(in, level);
  }
}

TEST(Connectivity, Shapes) {
  for (const Mesh& mesh :
       {corpus::single_triangle(), corpus::glued_pair(), corpus::tetrahedron(),
        corpus::icosphere(0), corpus::icosphere(3), corpus::torus(3, 3), corpus::torus(20, 30),
        corpus::grid(1, 1), corpus::grid(17, 9), corpus::cylinder(3, 1), corpus::cylinder(12, 8),
        corpus::strip(1), corpus::strip(50), corpus::fan(3), corpus::fan(40),
        corpus::loose_triangles(7)}) {
    check(arrays_of(mesh));
  }
}

TEST(Connectivity, NoFaces) {
  auto coded = encode_connectivity({{}, {}, 0}, 5);
  ASSERT_TRUE(coded.ok());
  EXPECT_EQ(coded->bytes.size(), 1u);
  auto out = decode(coded->bytes);
  ASSERT_TRUE(out.ok());
  EXPECT_TRUE(out->corners.empty());
}

TEST(Connectivity, HolesAndHandles) {
  check(arrays_of(corpus::punch_holes(corpus::icosphere(3), 30, 1)));
  check(arrays_of(corpus::punch_holes(corpus::torus(30, 20), 30, 2)));
  check(arrays_of(corpus::gyroid(1, 1, 1, 10, corpus::Ends::periodic)));
  check(arrays_of(corpus::gyroid(2, 2, 1, 7, corpus::Ends::capped)));
  check(arrays_of(corpus::gyroid(2, 2, 2, 6, corpus::Ends::open)));
  check(arrays_of(corpus::copies(corpus::punch_holes(corpus::torus(10, 10), 4, 3), 5)));
}

TEST(Connectivity, IrregularAndShuffled) {
  for (std::uint64_t seed = 0; seed < 3; ++seed) {
    check(arrays_of(corpus::flip_edges(corpus::icosphere(3), 3000, seed)));
    check(arrays_of(corpus::shuffle(corpus::flip_edges(corpus::grid(20, 30), 2000, seed), seed)));
    check(arrays_of(corpus::shuffle(corpus::gyroid(2, 1, 1, 10, corpus::Ends::open), seed)));
  }
}

/// Surfaces of random glued triangles: mostly no simplicial complexes, of any genus.
TEST(Connectivity, RandomGluings) {
  std::uint64_t seed = 0;
  for (const unsigned zips : {0u, 50u, 90u, 100u})
    for (const unsigned boundary : {0u, 5u, 25u})
      for (const unsigned apart : {0u, 10u})
        for (std::uint32_t triangles = 1; triangles <= 60; triangles += triangles < 20 ? 1 : 4) {
          corpus::GluingOptions options;
          options.zips = zips;
          options.boundary = boundary;
          options.apart = apart;
          options.loops = false;
          SCOPED_TRACE("triangles " + std::to_string(triangles) + " seed " + std::to_string(seed));
          check(arrays_of(corpus::random_gluing(triangles, ++seed, options)));
          if (HasFailure()) return;
        }
}

TEST(Connectivity, LargerRandomGluings) {
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    corpus::GluingOptions options;
    options.loops = false;
    options.zips = seed % 2 ? 98 : 60;
    options.boundary = static_cast<unsigned>(seed % 3);
    check(arrays_of(corpus::random_gluing(3000, seed, options)));
  }
}

/// Every rooted triangulation of the sphere gives a stream of its own, and comes back with its
/// root.
TEST(Connectivity, AllSmallSpheres) {
  constexpr std::size_t expected[] = {1, 3, 13, 68, 399, 2530, 16965};
  for (std::uint32_t n = 4; n <= 10; ++n) {
    std::set<std::string> streams;
    std::size_t visited = 0;
    corpus::for_each_sphere_triangulation(n, [&](const Mesh& mesh) {
      ++visited;
      const Arrays in = arrays_of(mesh);
      Arrays consumed = in;
      auto coded = encode_connectivity({consumed.org, consumed.twins, consumed.vertex_count}, 5);
      ASSERT_TRUE(coded.ok());
      EXPECT_EQ(coded->gates[0], HalfEdge(0)) << "the root is where it starts";
      auto out = decode(coded->bytes);
      ASSERT_TRUE(out.ok()) << describe(out.error());
      ASSERT_TRUE(same(in, *coded, *out));
      streams.emplace(reinterpret_cast<const char*>(coded->bytes.data()), coded->bytes.size());
    });
    EXPECT_EQ(visited, expected[n - 4]);
    EXPECT_EQ(streams.size(), expected[n - 4]);
  }
}

/// Coding what was decoded gives the same bytes: starts and order are where decoding put them.
TEST(Connectivity, IsIdempotent) {
  for (const Mesh& mesh :
       {corpus::shuffle(corpus::punch_holes(corpus::torus(30, 20), 12, 1), 1),
        corpus::shuffle(corpus::copies(corpus::punch_holes(corpus::icosphere(2), 3, 1), 4), 2),
        corpus::shuffle(corpus::gyroid(2, 2, 1, 10, corpus::Ends::open), 3)}) {
    Arrays in = arrays_of(mesh);
    auto coded = encode_connectivity({in.org, in.twins, in.vertex_count}, 5);
    ASSERT_TRUE(coded.ok());
    auto out = decode(coded->bytes);
    ASSERT_TRUE(out.ok());
    const std::vector<std::uint32_t> corners = out->corners;
    auto again = encode_connectivity(
        {corners, out->twins, static_cast<std::uint32_t>(coded->vertices.size())}, 5);
    ASSERT_TRUE(again.ok());
    EXPECT_EQ(coded->bytes, again->bytes);
    for (std::size_t i = 0; i < again->gates.size(); ++i)
      ASSERT_EQ(again->gates[i], half_edge(Face(static_cast<std::uint32_t>(i)), 0));
    for (std::uint32_t v = 0; v < again->vertices.size(); ++v) ASSERT_EQ(again->vertices[v], v);
  }
}

/// No prefix decodes, and none is read past its end (the sanitizers look).
TEST(Connectivity, PrefixesAreRefused) {
  const Arrays in =
      arrays_of(corpus::punch_holes(corpus::gyroid(1, 1, 1, 10, corpus::Ends::periodic), 5, 1));
  for (const int level : {1, 3, 5, 9}) {
    SCOPED_TRACE(level);
    Arrays consumed = in;
    auto coded = encode_connectivity({consumed.org, consumed.twins, consumed.vertex_count}, level);
    ASSERT_TRUE(coded.ok());
    for (std::size_t n = 0; n < coded->bytes.size(); ++n) {
      auto out = decode(exactly(coded->bytes, n));
      ASSERT_FALSE(out.ok()) << n;
      EXPECT_NE(out.error().code, ErrorCode::internal);
      EXPECT_NE(out.error().code, ErrorCode::out_of_memory);
    }
  }
}

/// Whatever a stream says, what is returned is a surface without repeated vertices, or an error.
TEST(Connectivity, AlteredStreamsGiveSurfacesOrErrors) {
  std::uint64_t random = 1;
  const auto next = [&] {
    random = random * 6364136223846793005u + 1442695040888963407u;
    return static_cast<std::uint32_t>(random >> 33);
  };
  int decoded = 0;
  std::vector<std::byte> unaltered;
  for (int round = 0; round < 4000; ++round) {
    if (const int mesh = round / 10; round % 10 == 0) {
      Arrays in = arrays_of(corpus::shuffle(
          mesh % 2 ? corpus::punch_holes(corpus::torus(8, 7), 3, static_cast<std::uint64_t>(mesh))
                   : corpus::gyroid(1, 1, 1, 8, corpus::Ends::open),
          static_cast<std::uint64_t>(mesh)));
      constexpr int levels[] = {1, 3, 5, 9};
      auto coded = encode_connectivity({in.org, in.twins, in.vertex_count}, levels[mesh / 2 % 4]);
      ASSERT_TRUE(coded.ok());
      unaltered = coded->bytes;
    }
    std::vector<std::byte> bytes = unaltered;
    for (std::uint32_t k = next() % 3 + 1; k-- > 0;)
      bytes[next() % bytes.size()] ^= static_cast<std::byte>(1u << next() % 8);
    auto out = decode(bytes);
    if (!out) continue;
    ++decoded;
    for (std::size_t h = 0; h < out->corners.size(); h += 3) {
      const auto [a, b, c] = std::tuple(out->corners[h], out->corners[h + 1], out->corners[h + 2]);
      ASSERT_TRUE(a != b && b != c && c != a);
    }
  }
  RecordProperty("decoded", decoded);
}

}  // namespace
}  // namespace clers::internal
