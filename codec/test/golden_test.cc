// Whole files, hash by hash: what was encoded before encodes to the same bytes after.
//
// golden.txt has a line for each case of golden_cases.cc: the hash of the file, of the permutations
// that encoding returns, and of the figures of Encoded::report and inspect(). A change that means
// to alter them writes the table anew with CLERS_RECORD_GOLDEN=FILE, and shows by its diff what it
// alters. Attributes and metadata go through zstd, whose version decides their bytes: with another
// than the table was made with (its first line, Debian 12's) such files are compared by their
// permutations alone.
#include <gtest/gtest.h>
#include <zstd.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>
#include <string>

#include "codec/compare.h"
#include "codec/decode.h"
#include "codec/encode.h"
#include "codec/inspect.h"
#include "codec/test/golden_cases.h"
#include "codec/test/round_trip.h"

namespace clers {
namespace {

class Fnv1a {
 public:
  void byte(unsigned b) { hash_ = (hash_ ^ b) * 0x100000001b3u; }
  void number(std::uint64_t n) {
    for (unsigned i = 0; i < 64; i += 8) byte(n >> i & 0xff);
  }
  void numbers(const std::vector<std::uint32_t>& list) {
    number(list.size());
    for (const std::uint32_t n : list) number(n);
  }
  void text(const std::string& s) {
    number(s.size());
    for (const char c : s) byte(static_cast<unsigned char>(c));
  }
  std::string hex() const {
    std::array<char, 17> s;
    std::snprintf(s.data(), s.size(), "%016llx", static_cast<unsigned long long>(hash_));
    return s.data();
  }

 private:
  std::uint64_t hash_ = 0xcbf29ce484222325u;
};

/// The figures of a mesh in the order of the API, metadata apart.
void hash_figures(Fnv1a& hash, const MeshInfo& info, const CodingCounts& counts) {
  hash.text(info.name);
  for (const std::uint64_t n :
       {info.vertices, info.faces, info.corners, std::uint64_t(info.triangles_only), info.pieces,
        info.copied_vertices, info.repeated_faces, info.degenerate_faces, info.connectivity_bytes,
        info.polygon_bytes, info.stitching_bytes, info.order_bytes, info.position_bytes,
        info.attribute_bytes, info.metadata_bytes, counts.reversed_faces})
    hash.number(n);
  for (const std::uint64_t n : counts.symbols) hash.number(n);
  for (const AttributeInfo& a : info.attributes) {
    hash.text(a.name);
    for (const std::uint64_t n : {std::uint64_t(a.domain), std::uint64_t(a.scalar),
                                  std::uint64_t(a.components), a.count, a.bytes})
      hash.number(n);
  }
}

void hash_figures(Fnv1a& hash, const MeshShape& s) {
  for (const std::uint64_t n :
       {s.vertices, s.faces, s.triangles, s.isolated_vertices, s.nonmanifold_edges,
        s.nonmanifold_vertices, s.misoriented_edges, s.degenerate_faces, s.duplicate_faces,
        s.surface.components, s.surface.nonorientable_components, s.surface.boundary_curves,
        s.surface.genus})
    hash.number(n);
}

struct Hashes {
  std::string file, permutations, figures;
  bool operator==(const Hashes&) const = default;
};

Hashes hashes_of(const Encoded& encoded) {
  Fnv1a file, permutations, figures;
  for (const std::byte b : encoded.bytes) file.byte(std::to_integer<unsigned>(b));
  for (const Permutation& p : encoded.permutations) {
    permutations.numbers(p.vertices);
    permutations.numbers(p.faces);
    permutations.numbers(p.first_corners);
  }
  for (std::size_t i = 0; i < encoded.report.size(); ++i)
    hash_figures(figures, encoded.report[i], encoded.counts[i]);
  const auto found = inspect(encoded.bytes);
  EXPECT_TRUE(found.ok());
  if (found) {
    const FileInfo& info = found->file;
    for (const std::uint64_t n :
         {std::uint64_t(info.format_major), std::uint64_t(info.format_minor),
          std::uint64_t(info.level), info.total_bytes, info.overhead_bytes})
      figures.number(n);
    for (std::size_t i = 0; i < info.meshes.size(); ++i) {
      hash_figures(figures, info.meshes[i], found->meshes[i].counts);
      hash_figures(figures, found->meshes[i].shape);
      for (const MetadataEntry& e : info.meshes[i].metadata)
        figures.text(e.key), figures.text(e.value);
    }
  }
  return {file.hex(), permutations.hex(), figures.hex()};
}

bool uses_zstd(const test::GoldenCase& c) {
  for (const Mesh& m : c.meshes)
    if (!m.attributes.empty() || !m.metadata.empty()) return true;
  return false;
}

struct Table {
  std::string zstd;
  std::map<std::string, Hashes> hashes;
};

Table read_table() {
  Table table;
  std::ifstream in(CLERS_GOLDEN);
  std::string line, word;
  if (std::getline(in, line)) std::istringstream(line) >> word >> table.zstd;
  while (std::getline(in, line)) {
    const std::size_t tab = line.find('\t');
    Hashes h;
    std::istringstream(line.substr(0, tab)) >> h.file >> h.permutations >> h.figures;
    table.hashes[line.substr(tab + 1)] = h;
  }
  return table;
}

/// Values are off by no more than the report says.
void expect_near(const Mesh& mesh, const Mesh& decoded, const MeshInfo& report,
                 const Permutation& order) {
  std::vector<Tolerance> tolerances;
  for (const AttributeInfo& a : report.attributes)
    if (a.error > 0) tolerances.push_back({a.name, a.error, a.domain});
  const auto compared = compare(mesh, decoded, tolerances, order);
  ASSERT_TRUE(compared.ok());
  ASSERT_EQ(compared->verdict, Verdict::same);
}

TEST(Golden, FilesStayTheSameByteForByte) {
  const Table table = read_table();
  const bool same_zstd = table.zstd == ZSTD_versionString();
  std::ofstream record;
  if (const char* path = std::getenv("CLERS_RECORD_GOLDEN")) {
    record.open(path);
    record << "zstd " << ZSTD_versionString() << '\n';
  }
  std::size_t cases = 0;
  for (const test::GoldenCase& c : test::golden_cases()) {
    ++cases;
    const auto encoded = encode(c.meshes, c.options);
    ASSERT_TRUE(encoded.ok()) << c.name << ": " << describe(encoded.error());
    const Hashes got = hashes_of(*encoded);
    if (record.is_open())
      record << got.file << ' ' << got.permutations << ' ' << got.figures << '\t' << c.name << '\n';
    const auto expected = table.hashes.find(c.name);
    if (expected == table.hashes.end()) {
      ADD_FAILURE() << "no line for " << c.name;
      continue;
    }
    EXPECT_EQ(got.permutations, expected->second.permutations) << c.name;
    if (same_zstd || !uses_zstd(c)) {
      EXPECT_EQ(got.file, expected->second.file) << c.name;
      EXPECT_EQ(got.figures, expected->second.figures) << c.name;
    }
    // What the file holds is the mesh: else its hash would be of nothing.
    const auto decoded = decode(encoded->bytes);
    ASSERT_TRUE(decoded.ok()) << c.name << ": " << describe(decoded.error());
    ASSERT_EQ(decoded->size(), c.meshes.size());
    for (std::size_t i = 0; i < decoded->size(); ++i)
      if (c.options.precisions.empty())
        internal::expect_permuted(c.meshes[i], (*decoded)[i], encoded->permutations[i]);
      else
        expect_near(c.meshes[i], (*decoded)[i], encoded->report[i], encoded->permutations[i]);
    ASSERT_FALSE(HasFatalFailure()) << c.name;
  }
  EXPECT_EQ(table.hashes.size(), cases) << "lines without a case, or two cases of one name";
}

}  // namespace
}  // namespace clers
