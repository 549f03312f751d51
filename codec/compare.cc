// Two meshes are the same when a bijection of vertices carries the faces of one, as a multiset of
// cycles, onto those of the other, and every value with them. Finding it is graph isomorphism;
// meshes make it easy nearly always:
//
//   1. Colour the vertices by their values (compared_mesh.h). In most files positions differ, so
//      every colour is alone in its class and the bijection is forced.
//   2. Otherwise refine (refinement.h), until that is so or nothing more is learned.
//   3. Where classes stay larger than one vertex, cut them finer than hashes did and single out one
//      vertex after the other (equitable.h). Nearly always any of a class will do.
//   4. Where one did not, pair off components that are isomorphic (pairing.h), which a search shows
//      (isomorphism.h).
//
// Colours differ: no bijection exists. Equality is proved at the end, on the bits themselves
// (renumbering.h).
#include "codec/compare.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "codec/base/guarded.h"
#include "codec/comparison/compared_mesh.h"
#include "codec/comparison/equitable.h"
#include "codec/comparison/pairing.h"
#include "codec/comparison/refinement.h"
#include "codec/comparison/renumbering.h"

namespace CLERS_VISIBLE clers {
namespace {

using namespace internal;

using Index = std::uint32_t;

Comparison differ(std::string what) {
  return {Verdict::different, std::move(what)};
}

std::string two_counts(const char* what, std::uint64_t a, std::uint64_t b) {
  return std::string(what) + ": " + std::to_string(a) + " and " + std::to_string(b);
}

/// Steps 1 and 2: colours both until they differ, or each colour is alone, or a round learns
/// little, which cells serve better than a round for every ring of faces. `image` becomes a
/// bijection that keeps colours, the only one if it is `forced`.
std::optional<std::string> colour(ComparedMesh& a, ComparedMesh& b, std::vector<Index>& image,
                                  bool& forced) {
  constexpr std::uint64_t enough = 1u << 24;  // corners and vertices
  Classes vertices_a = classes(a.colour), vertices_b = classes(b.colour);
  if (auto what = histograms_differ(vertices_a, vertices_b, "vertex", "the same values"))
    return what;
  std::size_t count = count_classes(vertices_a), before = 0;
  for (std::uint64_t effort = 0;
       count < vertices_a.size() && effort <= enough && before + before / 8 < count;) {
    effort += a.corners() + a.vertices();
    refine(a);
    refine(b);
    vertices_a = classes(a.colour);
    vertices_b = classes(b.colour);
    if (auto what = histograms_differ(vertices_a, vertices_b, "vertex",
                                      "the same values and neighbourhood"))
      return what;
    before = std::exchange(count, count_classes(vertices_a));
  }
  forced = count == vertices_a.size();
  image.resize(vertices_a.size());
  for (std::size_t i = 0; i < image.size(); ++i) image[vertices_a[i].second] = vertices_b[i].second;
  return std::nullopt;
}

/// What neither colours nor the order of attributes distinguish.
Comparison compare_structure(ComparedMesh& first, ComparedMesh& second) {
  std::vector<Index> image;
  bool forced = false;
  if (auto what = colour(first, second, image, forced)) return differ(std::move(*what));
  // Often any vertex of a class will do: pages of a book, vertices that no face uses.
  auto what = renumbering_fails(first, second, image);
  if (!what) return {Verdict::same, {}};
  if (forced) return differ(std::move(*what));

  const Classes faces_a = classes(face_colours(first)), faces_b = classes(face_colours(second));
  if (what = histograms_differ(faces_a, faces_b, "face", "the same values and neighbourhood"); what)
    return differ(std::move(*what));
  const Side a(first, faces_a), b(second, faces_b);
  Comparison result = pair_by_cells(a, b, image);
  if (result.verdict == Verdict::undecided) result = pair_components(a, b, image);
  if (result.verdict != Verdict::same) return result;
  if (what = renumbering_fails(first, second, image); what)
    return {Verdict::undecided, std::move(*what)};  // colours collided
  return result;
}

Comparison compare_checked(const Mesh& a, const Mesh& b) {
  if (a.vertex_count != b.vertex_count)
    return differ(two_counts("vertices", a.vertex_count, b.vertex_count));
  if (a.face_count() != b.face_count())
    return differ(two_counts("faces", a.face_count(), b.face_count()));
  if (a.corners.size() != b.corners.size())
    return differ(two_counts("corners", a.corners.size(), b.corners.size()));
  ComparedMesh first(a), second(b);
  if (auto what = attributes_differ(first, second)) return differ(std::move(*what));
  return compare_structure(first, second);
}

}  // namespace

Expected<Comparison> compare(const Mesh& a, const Mesh& b) {
  return guarded("compare", [&]() -> Expected<Comparison> {
    for (const Mesh* mesh : {&a, &b})
      if (auto error = why_not_comparable(*mesh)) {
        error->what = (mesh == &a ? "the first mesh " : "the second mesh ") + error->what;
        return Failure{std::move(*error)};
      }
    return compare_checked(a, b);
  });
}

std::string metadata_difference(const Mesh& a, const Mesh& b) {
  const auto sorted = [](const Mesh& mesh) {
    std::vector<const MetadataEntry*> entries;
    for (const MetadataEntry& entry : mesh.metadata) entries.push_back(&entry);
    std::stable_sort(entries.begin(), entries.end(),
                     [](const auto* x, const auto* y) { return x->key < y->key; });
    return entries;
  };
  const auto first = sorted(a), second = sorted(b);
  const auto said = [](const std::string& key, const char* what) {
    return "metadata '" + key + "': " + what;
  };
  std::size_t i = 0;
  for (; i < first.size() && i < second.size(); ++i) {
    const MetadataEntry &x = *first[i], &y = *second[i];
    if (x.key < y.key) return said(x.key, "only the first has it");
    if (y.key < x.key) return said(y.key, "only the second has it");
    if (x.value != y.value) return said(x.key, "different values");
  }
  if (i < first.size()) return said(first[i]->key, "only the first has it");
  if (i < second.size()) return said(second[i]->key, "only the second has it");
  return {};
}

}  // namespace clers
