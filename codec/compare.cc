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
//
// Within a tolerance colours are coarser, so that this still holds (near_values.h). If they leave
// it open, values are rounded to the nearest of the other mesh, which shows what is the same.
#include "codec/compare.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "codec/base/guarded.h"
#include "codec/base/portable.h"
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

/// Of the attributes that were compared within a tolerance.
std::vector<FoundError> found_errors(const ComparedMesh& mesh, const std::vector<double>& errors) {
  std::vector<FoundError> found;
  for (std::size_t k = 0; k < errors.size(); ++k)
    if (mesh.tolerance[k])
      found.push_back(
          {mesh.attributes[k]->name, mesh.attributes[k]->domain, errors[k], mesh.measure[k]});
  return found;
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

/// What is shown of two meshes whose vertices are coloured.
struct Attempt {
  Comparison comparison;
  std::vector<double> errors = {};  ///< if they are the same
};

/// What neither colours nor the order of attributes distinguish. "different" is certain if colours
/// prove a difference.
Attempt compare_structure(ComparedMesh& first, ComparedMesh& second) {
  std::vector<Index> image;
  std::vector<double> errors;
  bool forced = false;
  if (auto what = colour(first, second, image, forced)) return {differ(std::move(*what))};
  // Often any vertex of a class will do: pages of a book, vertices that no face uses.
  auto wrong = renumbering_fails(first, second, image, errors);
  if (!wrong) return {{Verdict::same, {}}, std::move(errors)};
  if (forced && wrong->is_certain) return {differ(std::move(wrong->what))};

  const Classes faces_a = classes(face_colours(first)), faces_b = classes(face_colours(second));
  if (auto what = histograms_differ(faces_a, faces_b, "face", "the same values and neighbourhood"))
    return {differ(std::move(*what))};
  const Side a(first, faces_a), b(second, faces_b);
  Comparison result = pair_by_cells(a, b, image);
  if (result.verdict == Verdict::undecided) result = pair_components(a, b, image);
  if (result.verdict != Verdict::same) return {std::move(result)};
  if (wrong = renumbering_fails(first, second, image, errors); wrong)
    // Colours collided, or values within a tolerance are too close together.
    return {{Verdict::undecided, std::move(wrong->what)}};
  return {std::move(result), std::move(errors)};
}

/// Guesses which vertices become which by the nearest values. What it shows is the same.
Attempt guess(ComparedMesh& first, ComparedMesh& second) {
  for (const Nearness nearness : {Nearness::nearest_or_lesser, Nearness::nearest_or_greater})
    for (const bool swapped : {false, true}) {
      ComparedMesh &from = swapped ? second : first, &to = swapped ? first : second;
      colour_vertices(from, to, nearness);
      Attempt attempt = compare_structure(from, to);
      if (attempt.comparison.verdict == Verdict::same) return attempt;
    }
  return {{Verdict::undecided, {}}};
}

/// Which of the counts of vertices, faces and corners is another.
std::optional<std::string> counts_differ(const Mesh& a, const Mesh& b) {
  if (a.vertex_count != b.vertex_count)
    return two_counts("vertices", a.vertex_count, b.vertex_count);
  if (a.face_count() != b.face_count()) return two_counts("faces", a.face_count(), b.face_count());
  if (a.corners.size() != b.corners.size())
    return two_counts("corners", a.corners.size(), b.corners.size());
  return std::nullopt;
}

Comparison compare_checked(const Mesh& a, const Mesh& b, std::span<const Tolerance> tolerances) {
  if (auto what = counts_differ(a, b)) return differ(std::move(*what));
  ComparedMesh first(a, tolerances), second(b, tolerances);
  if (auto what = attributes_differ(first, second)) return differ(std::move(*what));
  if (auto what = compare_sharing(first, second)) return differ(std::move(*what));
  colour_values(first, second);
  Attempt attempt = compare_structure(first, second);
  if (attempt.comparison.verdict == Verdict::undecided && !first.is_exact())
    if (Attempt guessed = guess(first, second); guessed.comparison.verdict == Verdict::same)
      attempt = std::move(guessed);
  if (attempt.comparison.verdict == Verdict::same)
    attempt.comparison.errors = found_errors(first, attempt.errors);
  return std::move(attempt.comparison);
}

/// What keeps two meshes from being compared.
std::optional<Error> refused(const Mesh& a, const Mesh& b, std::span<const Tolerance> tolerances) {
  for (const Tolerance& t : tolerances)
    if (!(t.error >= 0) || std::isinf(t.error))
      return Error{ErrorCode::bad_option, Place::nowhere, 0,
                   "a tolerance for '" + t.name + "' that is negative or not finite"};
  for (const Mesh* mesh : {&a, &b})
    if (auto error = why_not_comparable(*mesh)) {
      error->what = (mesh == &a ? "the first mesh " : "the second mesh ") + error->what;
      return error;
    }
  return std::nullopt;
}

}  // namespace

Expected<Comparison> compare(const Mesh& a, const Mesh& b) {
  return compare(a, b, {});
}

Expected<Comparison> compare(const Mesh& a, const Mesh& b, std::span<const Tolerance> tolerances) {
  return guarded("compare", [&]() -> Expected<Comparison> {
    if (auto error = refused(a, b, tolerances)) return Failure{std::move(*error)};
    const DoublePrecision doubles;
    return compare_checked(a, b, tolerances);
  });
}

Expected<Comparison> compare(const Mesh& a, const Mesh& b, std::span<const Tolerance> tolerances,
                             const Permutation& renumbering) {
  return guarded("compare", [&]() -> Expected<Comparison> {
    if (auto error = refused(a, b, tolerances)) return Failure{std::move(*error)};
    if (auto what = counts_differ(a, b)) return differ(std::move(*what));
    ComparedMesh first(a, tolerances), second(b, tolerances);
    if (auto what = attributes_differ(first, second)) return differ(std::move(*what));
    if (auto what = compare_sharing(first, second)) return differ(std::move(*what));
    const DoublePrecision doubles;
    std::vector<double> errors;
    auto wrong = renumbering_fails(first, second, renumbering, errors);
    if (!wrong) return Failure{wrong.error()};
    if (*wrong) return differ(std::move(**wrong));
    return Comparison{Verdict::same, {}, found_errors(first, errors)};
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
