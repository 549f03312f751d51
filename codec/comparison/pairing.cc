#include "codec/comparison/pairing.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <string>
#include <utility>

#include "codec/base/no_index.h"

namespace clers::internal {
namespace {

using Index = std::uint32_t;

class Pairing {
 public:
  Pairing(const Side& a, const Side& b)
      : a_(a),
        b_(b),
        search_(a.mesh, enough + 400 * std::uint64_t{a.mesh.corners()}),
        like_(a.mesh.vertices()),
        image_(a.mesh.vertices(), no_index) {}

  /// same: the image is complete, up to collisions of colours.
  Comparison run() {
    const Classes of_a = classes(a_.components.colour), of_b = classes(b_.components.colour);
    if (of_a.size() != of_b.size())
      return {Verdict::different,
              "components: " + std::to_string(of_a.size()) + " and " + std::to_string(of_b.size())};
    for (std::size_t i = 0, j; i < of_a.size(); i = j) {
      for (j = i; j < of_a.size() && of_a[j].first == of_a[i].first; ++j) {
        if (of_a[j].first < of_b[j].first) return alone(a_, of_a[j].second);
        if (of_a[j].first > of_b[j].first) return alone(b_, of_b[j].second);
      }
      Comparison result =
          pair_off(std::span(of_a).subspan(i, j - i), std::span(of_b).subspan(i, j - i));
      if (result.verdict != Verdict::same) return result;
    }
    pair_isolated();
    return {Verdict::same, {}};
  }

  std::vector<Index> take_image() { return std::move(image_); }

 private:
  /// Visits of corners, a second or two. A component whose first guess holds needs ten a corner.
  static constexpr std::uint64_t enough = 1u << 25;

  /// Isomorphic components of the first mesh.
  struct Kind {
    Index first;
    std::vector<Index> unpaired;
  };

  Comparison alone(const Side& side, Index k) const {
    return {Verdict::different, "face " + std::to_string(side.components.faces(k)[0].second) +
                                    " of the " + (&side == &a_ ? "first" : "second") +
                                    " mesh lies in a component that has no counterpart"};
  }

  Comparison pair_off(std::span<const Classes::value_type> as,
                      std::span<const Classes::value_type> bs) {
    std::vector<Kind> kinds;
    for (const auto& [colour, k] : as) {
      const auto [verdict, at] = find(kinds, a_, k);
      if (verdict == Verdict::undecided) return {verdict, "too many renumberings to try"};
      if (verdict == Verdict::same) {
        for (const Index v : search_.vertices()) like_[search_.image(v)] = v;
      } else {
        for (const auto& face : a_.components.faces(k))
          for (const Index v : a_.mesh.faces.cycle(face.second)) like_[v] = v;
        kinds.push_back({k, {}});
      }
      kinds[at].unpaired.push_back(k);
    }
    for (const auto& [colour, k] : bs) {
      const auto [verdict, at] = find(kinds, b_, k);
      if (verdict == Verdict::undecided) return {verdict, "too many renumberings to try"};
      if (verdict == Verdict::different || kinds[at].unpaired.empty()) return alone(b_, k);
      for (const auto& face : a_.components.faces(kinds[at].unpaired.back()))
        for (const Index v : a_.mesh.faces.cycle(face.second)) image_[v] = search_.image(like_[v]);
      kinds[at].unpaired.pop_back();
    }
    return {Verdict::same, {}};
  }

  /// The kind of component k; different: none of them, and the number is how many there are.
  std::pair<Verdict, std::size_t> find(const std::vector<Kind>& kinds, const Side& side, Index k) {
    for (std::size_t i = 0; i < kinds.size(); ++i) {
      const Verdict verdict = search_.search(a_, kinds[i].first, side, k);
      if (verdict != Verdict::different) return {verdict, i};
    }
    return {Verdict::different, kinds.size()};
  }

  /// Vertices that no face uses have nothing but their colour.
  void pair_isolated() {
    std::vector<bool> taken(image_.size());
    Classes rest_a, rest_b;
    for (Index v = 0; v < image_.size(); ++v)
      if (image_[v] == no_index)
        rest_a.push_back({a_.mesh.colour[v], v});
      else
        taken[image_[v]] = true;
    for (Index v = 0; v < image_.size(); ++v)
      if (!taken[v]) rest_b.push_back({b_.mesh.colour[v], v});
    std::sort(rest_a.begin(), rest_a.end());
    std::sort(rest_b.begin(), rest_b.end());
    for (std::size_t i = 0; i < rest_a.size(); ++i) image_[rest_a[i].second] = rest_b[i].second;
  }

  const Side &a_, &b_;
  Isomorphism search_;
  std::vector<Index> like_;   // of each vertex of the first mesh, in the first of its kind
  std::vector<Index> image_;  // vertices of the first -> second
};

}  // namespace

Comparison pair_components(const Side& a, const Side& b, std::vector<Index>& image) {
  Pairing pairing(a, b);
  Comparison result = pairing.run();
  image = pairing.take_image();
  return result;
}

}  // namespace clers::internal
