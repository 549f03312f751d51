// Streams that no encoder makes, and long ones made to cost as much as any.
#include "codec/test/legal_streams.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <ctime>
#include <limits>
#include <string>
#include <type_traits>

#include "codec/connectivity/connectivity.h"
#include "codec/connectivity/spirale_reversi.h"
#include "codec/connectivity/stream_source.h"
#include "codec/test/coded_surface.h"
#include "codec/test/correspondence.h"
#include "corpus/random.h"
#include "topology/mirror.h"

namespace clers::internal {
namespace {

struct Decoded {
  std::vector<std::uint32_t> corners;
  std::vector<HalfEdge> twins;
  std::vector<std::uint32_t> introduced_by;
  ConnectivityCounts counts;
  std::uint32_t vertices = 0;
};

Expected<Decoded> decode(std::span<const std::byte> bytes) {
  const auto header = read_connectivity_header(bytes, 0);
  if (!header) return Failure{header.error()};
  Decoded d;
  d.vertices = header->vertices;
  d.corners.resize(3 * std::size_t(header->faces));
  d.twins.resize(d.corners.size());
  d.introduced_by.resize(d.vertices);
  auto counts = decode_connectivity(bytes, 0, *header, d.corners, d.twins, d.introduced_by);
  if (!counts) return Failure{counts.error()};
  d.counts = *counts;
  return d;
}

Expected<EncodedConnectivity> encode(const Decoded& in, int level) {
  std::vector<HalfEdge> twins = in.twins;
  return encode_connectivity({in.corners, twins, in.vertices}, level);
}

/// Empty if each operator is on a full surface what the decoder takes it for, the front's curves
/// and vertices are the surface's, and the vertices that come out.
std::string difference_from_mirror(std::span<const std::byte> bytes,
                                   std::span<const std::uint32_t> decoded) {
  const auto header = *read_connectivity_header(bytes, 0);
  std::vector<std::uint32_t> corners(3 * std::size_t(header.faces));
  std::vector<FrontLink> links(header.vertices + header.merges);
  Building building;
  building.corners = corners;
  building.links = links;
  BuildingMirror mirror(links.size());
  StreamError error;
  with_stream_source(header, bytes, [&](auto& source) {
    using Source = std::remove_reference_t<decltype(source)>;
    error = SpiraleReversi<BuildingMirror, Source>(building, mirror, source).run();
  });
  if (error.broken != StreamFault::none) return "broken";
  if (!mirror.agrees) return "the front and the full surface do not agree";
  return mirror.same_vertices(decoded) ? "" : "the vertices are not the surface's";
}

/// What a decoder makes of a stream is what its symbols say, and can be coded: to the same surface,
/// and from there to the same bytes.
void check(const LegalStream& stream, int level) {
  const auto decoded = decode(stream.bytes);
  ASSERT_TRUE(decoded.ok()) << describe(decoded.error());
  ASSERT_EQ(decoded->vertices, stream.vertices);
  ASSERT_EQ(decoded->corners, stream.corners);
  ASSERT_EQ(decoded->twins, stream.twins);
  ASSERT_EQ(fault_of({decoded->corners, decoded->twins, decoded->introduced_by}), "");
  EXPECT_EQ(decoded->counts.components, stream.components);
  EXPECT_EQ(decoded->counts.coded_holes, stream.holes);
  EXPECT_EQ(decoded->counts.handles, stream.handles);

  EXPECT_EQ(difference_from_mirror(stream.bytes, decoded->corners), "");

  const auto coded = encode(*decoded, level);
  ASSERT_TRUE(coded.ok()) << describe(coded.error());
  const auto out = decode(coded->bytes);
  ASSERT_TRUE(out.ok()) << describe(out.error());
  ASSERT_EQ(difference_of(decoded->corners, decoded->twins, *coded, out->corners, out->twins), "");
  const auto again = encode(*out, level);
  ASSERT_TRUE(again.ok()) << describe(again.error());
  EXPECT_EQ(coded->bytes, again->bytes);

  std::vector<HalfEdge> twins = decoded->twins;
  OperatorTrace trace;
  const auto full =
      encode_connectivity_on_surface({decoded->corners, twins, decoded->vertices}, level, trace);
  ASSERT_TRUE(full.ok()) << describe(full.error());
  EXPECT_EQ(coded->bytes, full->bytes);
}

TEST(LegalStreams, GiveTheSurfacesTheySay) {
  std::uint64_t holes = 0, handles = 0, components = 0, closed = 0;
  for (std::uint64_t seed = 0; seed < 1500; ++seed) {
    corpus::Random random(seed);
    const std::uint32_t faces = 1 + random.below(seed % 10 == 0 ? 400 : 40);
    const LegalStream stream =
        legal_stream(faces, [&](std::uint32_t n) { return random.below(n); });
    constexpr int levels[] = {1, 3, 5, 9};
    SCOPED_TRACE("seed " + std::to_string(seed));
    check(stream, levels[seed % 4]);
    if (HasFailure()) return;
    holes += stream.holes;
    handles += stream.handles;
    components += stream.components;
    closed += std::find(stream.twins.begin(), stream.twins.end(), HalfEdge()) == stream.twins.end();
  }
  EXPECT_GT(holes, 1250u);
  EXPECT_GT(handles, 1250u);
  EXPECT_GT(components, 1750u);
  EXPECT_GT(closed, 5u);
}

// Each of the following is at most ten faces for each of n handles.

/// n curves wait, and are joined oldest first or latest first.
Bytes waiting_curves(std::uint32_t n, bool oldest_first) {
  StreamWriter writer(10 * std::size_t(n));
  for (std::uint32_t i = 0; i < n; ++i) {
    for (int k = 0; k < 5; ++k) writer.l();
    writer.split(3);
  }
  for (std::uint32_t i = n; i > 0; --i) {
    writer.l();
    writer.join(oldest_first ? i - 1 : 0, i % 3);
  }
  return writer.finish(false);
}

/// A curve of 2 n edges is split far from the gate, and joined in the middle, n times.
Bytes long_curve(std::uint32_t n, bool) {
  StreamWriter writer(10 * std::size_t(n));
  for (std::uint32_t i = 0; i < 2 * n; ++i) writer.l();
  for (std::uint32_t i = 0; i < n; ++i) {
    writer.l();
    writer.split(writer.length() - 3);
    writer.l();
    writer.join(0, writer.waiting_length(0) / 2);
  }
  return writer.finish(false);
}

/// n gates are pushed, each with a curve of its own, and popped one by one; in between a
/// handle joins what came.
Bytes gates_aside(std::uint32_t n, bool) {
  StreamWriter writer(14 * std::size_t(n));
  for (std::uint32_t i = 0; i < n; ++i) {
    for (int k = 0; k < 2; ++k) writer.l();
    writer.e();
  }
  for (int k = 0; k < 4; ++k) writer.l();
  for (std::uint32_t i = 0; i < n; ++i) {
    writer.s();
    writer.l();
    writer.l();
    writer.split(writer.length() / 2);
    writer.l();
    writer.join(0, writer.waiting_length(0) / 3);
  }
  return writer.finish(false);
}

double seconds() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// Least of three, a face.
template <class Run>
double cost(std::size_t faces, Run run) {
  double best = std::numeric_limits<double>::max();
  for (int i = 0; i < 3; ++i) {
    const double start = seconds();
    run();
    best = std::min(best, seconds() - start);
  }
  return best / static_cast<double>(faces);
}

/// Sixteen times the faces cost sixteen times as much, each four times at most for memory that is
/// farther away. What walks along curves, or through lists of them, takes sixteen times each.
TEST(LegalStreams, CostsGrowNoFasterThanFaces) {
  const auto latest = [](std::uint32_t n, bool) { return waiting_curves(n, false); };
  const auto oldest = [](std::uint32_t n, bool) { return waiting_curves(n, true); };
  using Make = Bytes (*)(std::uint32_t, bool);
  for (const Make make : {Make(latest), Make(oldest), Make(long_curve), Make(gates_aside)}) {
    double decoding[2], encoding[2];
    for (const bool large : {false, true}) {
      const auto bytes = make(large ? 16 * 1500 : 1500, false);
      const auto decoded = decode(bytes);
      ASSERT_TRUE(decoded.ok()) << describe(decoded.error());
      EXPECT_GT(decoded->counts.handles, 1000u);
      const std::size_t faces = decoded->corners.size() / 3;
      decoding[large] = cost(faces, [&] { ASSERT_TRUE(decode(bytes).ok()); });
      encoding[large] = cost(faces, [&] { ASSERT_TRUE(encode(*decoded, 5).ok()); });
    }
    EXPECT_LT(decoding[1], 4 * decoding[0]);
    EXPECT_LT(encoding[1], 4 * encoding[0]);
  }
}

}  // namespace
}  // namespace clers::internal
