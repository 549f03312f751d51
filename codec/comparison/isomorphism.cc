// A search with going back, whose steps are counted.
#include "codec/comparison/isomorphism.h"

#include <algorithm>

#include "codec/base/no_index.h"

namespace clers::internal {
namespace {

using Index = std::uint32_t;

}  // namespace

Stars::Stars(const ComparedMesh& mesh)
    : faces_(mesh.faces), corners_([&] {
        const auto own = [&](Index c) { return faces_.org[c]; };
        const auto next = [&](Index c) { return faces_.org[faces_.next(c)]; };
        const std::vector<Index> by_next = Buckets(mesh.corners(), mesh.vertices(), next).items();
        return Buckets(by_next, mesh.vertices(), own);
      }()) {}

std::span<const Index> Stars::along(Index u, Index v) const {
  const auto all = at(u);
  const auto next = [&](Index c) { return faces_.org[faces_.next(c)]; };
  const auto low =
      std::partition_point(all.begin(), all.end(), [&](Index c) { return next(c) < v; });
  const auto high = std::partition_point(low, all.end(), [&](Index c) { return next(c) == v; });
  return {low, high};
}

Isomorphism::Isomorphism(const ComparedMesh& mesh, std::uint64_t budget)
    : image_(mesh.vertices(), no_index),
      origin_(mesh.vertices(), no_index),
      matched_from_(mesh.faces.count()),
      matched_to_(mesh.faces.count()),
      budget_(budget) {}

Verdict Isomorphism::search(const Side& from, Index k, const Side& to, Index l) {
  go_back_to({});
  from_ = &from;
  to_ = &to;
  if (from.components.faces(k).size() != to.components.faces(l).size()) return Verdict::different;
  std::vector<Choice> choices = {first_choice(k, l)};
  while (!choices.empty()) {
    if (work_ > budget_) return Verdict::undecided;
    Choice& last = choices.back();
    go_back_to(last);
    if (last.at == last.candidates.size()) {
      choices.pop_back();
      continue;
    }
    ++work_;
    queue_.clear();
    if (!match(last.corner, last.candidates[last.at++]) || !propagate()) continue;
    const std::optional<Choice> more = next_choice();
    if (!more) return Verdict::same;
    choices.push_back(*more);
  }
  return Verdict::different;
}

void Isomorphism::go_back_to(const Choice& choice) {
  for (; vertices_.size() > choice.vertices; vertices_.pop_back()) {
    origin_[image_[vertices_.back()]] = no_index;
    image_[vertices_.back()] = no_index;
  }
  for (; matches_.size() > choice.matches; matches_.pop_back()) {
    matched_from_[matches_.back().first] = false;
    matched_to_[matches_.back().second] = false;
  }
  cursor_ = choice.cursor;
}

/// A corner of a face of the rarest colour may become any corner of the faces of that colour.
Isomorphism::Choice Isomorphism::first_choice(Index k, Index l) {
  const auto faces = from_->components.faces(k), others = to_->components.faces(l);
  const auto same_colour = [](const auto& all, std::size_t i) {
    std::size_t j = i;
    while (j < all.size() && all[j].first == all[i].first) ++j;
    return j - i;
  };
  std::size_t rarest = 0, fewest = faces.size() + 1;
  for (std::size_t i = 0, n; i < faces.size(); i += n) {
    n = same_colour(faces, i);
    if (n < fewest) rarest = i, fewest = n;
  }
  first_candidates_.clear();
  const std::size_t first = static_cast<std::size_t>(
      std::lower_bound(others.begin(), others.end(), std::pair(faces[rarest].first, Index{0})) -
      others.begin());
  for (std::size_t i = first; i < others.size() && others[i].first == faces[rarest].first; ++i)
    for (Index c = to_->mesh.faces.begin(others[i].second);
         c < to_->mesh.faces.end(others[i].second); ++c)
      first_candidates_.push_back(c);
  return {from_->mesh.faces.begin(faces[rarest].second), first_candidates_};
}

/// A face not matched yet at a vertex that is: it is across a vertex or edge of several sheets.
std::optional<Isomorphism::Choice> Isomorphism::next_choice() {
  for (; cursor_ < vertices_.size(); ++cursor_)
    for (const Index c : from_->stars.at(vertices_[cursor_])) {
      ++work_;
      if (matched_from_[from_->mesh.faces.face(c)]) continue;
      return Choice{
          c,      to_->stars.at(image_[vertices_[cursor_]]), 0, vertices_.size(), matches_.size(),
          cursor_};
    }
  return std::nullopt;
}

/// The face of one corner becomes that of the other. Precondition: `from` is not matched.
bool Isomorphism::match(Index from, Index to) {
  const ComparedMesh &a = from_->mesh, &b = to_->mesh;
  const Index f = a.faces.face(from), g = b.faces.face(to);
  if (matched_to_[g] || a.faces.size(f) != b.faces.size(g) ||
      a.value_of_face(f) != b.value_of_face(g))
    return false;
  matched_from_[f] = matched_to_[g] = true;
  matches_.push_back({f, g});
  queue_.push_back(f);
  for (Index j = 0; j < a.faces.size(f); ++j) {
    ++work_;
    const Index u = a.faces.org[from], v = b.faces.org[to];
    if (a.value_of_corner(from) != b.value_of_corner(to) || a.colour[u] != b.colour[v])
      return false;
    if (image_[u] == no_index && origin_[v] == no_index) {
      image_[u] = v;
      origin_[v] = u;
      vertices_.push_back(u);
    } else if (image_[u] != v) {
      return false;
    }
    from = a.faces.next(from);
    to = b.faces.next(to);
  }
  return true;
}

bool Isomorphism::propagate() {
  const Faces& faces = from_->mesh.faces;
  while (!queue_.empty()) {
    const Index f = queue_.back();
    queue_.pop_back();
    for (Index c = faces.begin(f); c < faces.end(f); ++c) {
      const Index u = faces.org[c], v = faces.org[faces.next(c)];
      if (!match_along(u, v) || !match_along(v, u) || work_ > budget_) return false;
    }
  }
  return true;
}

/// Both ends of an edge are matched: matches the faces along it as far as there is no choice.
bool Isomorphism::match_along(Index u, Index v) {
  const auto unmatched = [this](const Side& side, const std::vector<bool>& matched, Index tail,
                                Index head, Classes& out) {
    out.clear();
    for (const Index c : side.stars.along(tail, head)) {
      ++work_;
      if (!matched[side.mesh.faces.face(c)]) out.push_back({0, c});
    }
  };
  unmatched(*from_, matched_from_, u, v, along_from_);
  unmatched(*to_, matched_to_, image_[u], image_[v], along_to_);
  if (along_from_.size() != along_to_.size()) return false;
  if (along_from_.empty()) return true;
  if (along_from_.size() == 1) return match(along_from_[0].second, along_to_[0].second);

  // An edge of many faces. Those that differ in what is known of them are no choice.
  for (auto& [h, c] : along_from_) h = known(from_->mesh, c, [&](Index w) { return image_[w]; });
  for (auto& [h, c] : along_to_)
    h = known(to_->mesh, c, [&](Index w) { return origin_[w] == no_index ? no_index : w; });
  std::sort(along_from_.begin(), along_from_.end());
  std::sort(along_to_.begin(), along_to_.end());
  for (std::size_t i = 0, j; i < along_from_.size(); i = j) {
    for (j = i; j < along_from_.size() && along_from_[j].first == along_from_[i].first; ++j)
      if (along_to_[j].first != along_from_[j].first) return false;
    if (j < along_to_.size() && along_to_[j].first == along_from_[i].first) return false;
    // Equal faces without an unknown vertex may be paired at will.
    if (j - i > 1 && has_unknown(from_->mesh.faces.face(along_from_[i].second))) continue;
    for (std::size_t k = i; k < j; ++k) {
      const Index from = along_from_[k].second, to = along_to_[k].second;
      const bool done_from = matched_from_[from_->mesh.faces.face(from)];
      const bool done_to = matched_to_[to_->mesh.faces.face(to)];
      if (done_from != done_to) return false;
      if (done_from || match(from, to)) continue;
      if (j - i > 1) work_ = budget_ + 1;  // unequal after all: colours collided, so give up
      return false;
    }
  }
  return true;
}

/// Colour of a face read from a corner on, with the vertices that are matched known by the number
/// that `name` gives them.
template <class Name>
Colour Isomorphism::known(const ComparedMesh& mesh, Index c, Name name) {
  const Index n = mesh.faces.size(mesh.faces.face(c));
  Colour h = combine(n, mesh.value_of_face(mesh.faces.face(c)));
  for (Index j = 0; j < n; ++j, c = mesh.faces.next(c)) {
    ++work_;
    const Index v = mesh.faces.org[c], number = name(v);
    h = combine(h, number == no_index ? mesh.colour[v] : mix(number));
    h = combine(h, mesh.value_of_corner(c));
  }
  return h;
}

bool Isomorphism::has_unknown(Index f) const {
  const auto cycle = from_->mesh.faces.cycle(f);
  return std::any_of(cycle.begin(), cycle.end(), [&](Index v) { return image_[v] == no_index; });
}

}  // namespace clers::internal
