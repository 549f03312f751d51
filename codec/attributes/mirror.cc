// Finds the symmetry by which most vertices are images of others. Mirrors by votes: two vertices
// that agree in two coordinates vote for the sum of the third ones; the sums with the most votes
// are tried. Turns about the middle of all, and about where votes say: two vertices that agree in
// one coordinate vote for the sums of the two others.
#include "codec/attributes/mirror.h"

#include <algorithm>
#include <array>
#include <span>
#include <vector>

namespace clers::internal {
namespace {

// All is tried on about so many vertices, chosen by coordinates that a symmetry keeps, so that a
// vertex and its images are chosen together or not at all; and on no more than a few times as many.
constexpr std::size_t sample = 4096;
// A part of those first, where at least so many are in it.
constexpr std::size_t few_parts = 8, least_few = 128;
// Where so many agree in two coordinates, as on the walls of a box, their sums say little.
constexpr std::size_t crowd = 40;
// The same where they agree in one coordinate.
constexpr std::size_t layer_crowd = 12;
// Sums that are tried on an axis, and the part of all votes without which one is not.
constexpr std::size_t candidates = 4, least_votes = 50;

std::uint64_t mixed(std::uint64_t x) {
  x = (x ^ x >> 32) * 0xc2b2ae3d27d4eb4fu;
  return x ^ x >> 29;
}

template <class Int>
struct Sample {
  std::vector<Int> rows, few;
};

/// Rows whose key, of what a symmetry keeps, is chosen; all if they are few.
template <class Int, class Key>
Sample<Int> chosen(const Lattice<Int>& lattice, Key key) {
  const std::uint64_t below = ~std::uint64_t(0) / (lattice.count() / sample + 1);
  Sample<Int> found;
  std::vector<Int>&rows = found.rows, &few = found.few;
  rows.reserve(3 * std::min(lattice.count(), 2 * sample));
  for (std::size_t v = 0; v < lattice.count() && rows.size() < 12 * sample; ++v) {
    const Int* const row = &lattice.rows[3 * v];
    const std::uint64_t hash = mixed(key(row)) * 0x9e3779b97f4a7c15u;
    if (hash > below) continue;
    rows.insert(rows.end(), row, row + 3);
    if (hash <= below / few_parts) few.insert(few.end(), row, row + 3);
  }
  if (few.size() < 3 * least_few) few.clear();
  return found;
}

/// The line along an axis that a place is on, as a hash.
template <class Int>
std::uint64_t line_of(const Int* row, std::size_t axis) {
  const std::uint64_t y = static_cast<std::uint64_t>(row[(axis + 1) % 3]) * 0x9e3779b97f4a7c15u;
  return (y ^ y >> 29) + static_cast<std::uint64_t>(row[(axis + 2) % 3]);
}

struct Voter {
  std::uint64_t line, x;
};

/// Coordinates on an axis, by the line that they are on.
template <class Int, class Line>
std::vector<Voter> voters(std::span<const Int> rows, std::size_t axis, Line line) {
  std::vector<Voter> found;
  found.reserve(rows.size() / 3);
  for (std::size_t i = 0; i < rows.size(); i += 3)
    found.push_back({line(&rows[i]), static_cast<std::uint64_t>(rows[i + axis])});
  std::sort(found.begin(), found.end(),
            [](const Voter& a, const Voter& b) { return a.line < b.line; });
  return found;
}

/// The sums that get the most votes, with those of the sums beside them.
std::vector<std::uint64_t> elected(const std::vector<Voter>& voters, std::size_t many = crowd) {
  std::vector<std::uint64_t> sums;
  for (std::size_t from = 0, to; from < voters.size(); from = to) {
    for (to = from; to < voters.size() && voters[to].line == voters[from].line;) ++to;
    if (to - from >= many) continue;
    for (std::size_t i = from; i < to; ++i)
      for (std::size_t j = i + 1; j < to; ++j) sums.push_back(voters[i].x + voters[j].x);
  }
  std::sort(sums.begin(), sums.end());
  struct Candidate {
    std::uint64_t sum;
    std::size_t votes;
  };
  std::vector<Candidate> counted;
  for (std::size_t from = 0, to; from < sums.size(); from = to) {
    for (to = from; to < sums.size() && sums[to] == sums[from];) ++to;
    counted.push_back({sums[from], to - from});
  }
  std::vector<Candidate> best;
  for (std::size_t i = 0; i < counted.size(); ++i) {
    std::size_t votes = counted[i].votes;
    if (i > 0 && counted[i - 1].sum + 1 == counted[i].sum) votes += counted[i - 1].votes;
    if (i + 1 < counted.size() && counted[i].sum + 1 == counted[i + 1].sum)
      votes += counted[i + 1].votes;
    if (votes > voters.size() / least_votes) best.push_back({counted[i].sum, votes});
  }
  const auto more = [](const Candidate& a, const Candidate& b) {
    return a.votes != b.votes ? a.votes > b.votes : a.sum < b.sum;
  };
  const std::size_t kept = std::min(best.size(), candidates);
  std::partial_sort(best.begin(), best.begin() + static_cast<std::ptrdiff_t>(kept), best.end(),
                    more);
  std::vector<std::uint64_t> result;
  for (std::size_t i = 0; i < kept; ++i) result.push_back(best[i].sum);
  return result;
}

/// A measure of how much can be predicted, 0 if it is too little: the share of vertices that are
/// images, and a little of those that are so exactly.
template <class Int>
std::uint64_t worth(const Symmetry& symmetry, std::span<const Int> rows,
                    std::span<const Int> few = {}) {
  const auto images_of = [](Mirror<Int>& mirror, std::size_t count) {
    for (std::uint32_t v = 0; v < count; ++v) mirror.known(v);
    return mirror.images();
  };
  if (const std::size_t some = few.size() / 3; some > 0) {
    Mirror<Int> mirror(symmetry, few.data(), some, {});
    if (60 * images_of(mirror, some) < some) return 0;
  }
  const std::size_t count = rows.size() / 3;
  Mirror<Int> mirror(symmetry, rows.data(), count, {});
  if (20 * images_of(mirror, count) < count) return 0;
  std::uint64_t exactly = 0;
  for (std::uint32_t v = 0; v < count; ++v) {
    const std::uint32_t w = mirror.partner(v);
    bool same = w != v && w != mirror.nobody;
    for (std::size_t c = 0; same && c < 3; ++c)
      same = mirror.partner_image(v, c) == rows[3 * std::size_t(v) + c];
    exactly += same;
  }
  return ((8 * std::uint64_t(mirror.images()) + exactly) << 16) / count;
}

}  // namespace

template <class Int>
std::optional<Symmetry> find_mirror(const Lattice<Int>& lattice) {
  if (lattice.count() == 0) return std::nullopt;
  struct Best {
    std::optional<Symmetry> symmetry;
    std::uint64_t worth = 0;
  };
  const auto try_one = [&](Best& best, const Symmetry& symmetry, std::span<const Int> rows,
                           std::span<const Int> few = {}) {
    const std::uint64_t found = symmetry.fits(lattice.axes) ? worth<Int>(symmetry, rows, few) : 0;
    if (found > best.worth) best = {symmetry, found};
    return found;
  };
  // Mirrors.
  std::array<Best, 3> mirrors;
  for (std::uint32_t axis = 0; axis < 3; ++axis) {
    const auto line = [&](const Int* row) { return line_of(row, axis); };
    const auto [rows, few] = chosen(lattice, line);
    for (const std::uint64_t sum : elected(voters<Int>(rows, axis, line)))
      try_one(mirrors[axis], {axis, sum}, rows, few);
  }
  // Two of them, and turns about the middle of all.
  std::array<std::uint64_t, 3> sums = {};
  for (std::size_t c = 0; c < 3; ++c) {
    Int least = lattice.rows[c], greatest = least;
    for (std::size_t i = c; i < lattice.rows.size(); i += 3) {
      least = std::min(least, lattice.rows[i]);
      greatest = std::max(greatest, lattice.rows[i]);
    }
    sums[c] = static_cast<std::uint64_t>(least + greatest);
  }
  Best others;
  for (std::uint32_t axis = 0; axis < 3; ++axis) {
    const std::uint32_t axis2 = (axis + 1) % 3, kept = (axis + 2) % 3;
    const auto layer = [&](const Int* row) { return static_cast<std::uint64_t>(row[kept]); };
    const auto [rows, few] = chosen(lattice, layer);
    if (rows.empty()) continue;
    if (mirrors[axis].symmetry && mirrors[axis2].symmetry)
      try_one(others,
              {axis, mirrors[axis].symmetry->sum, Symmetry::mirrors, mirrors[axis2].symmetry->sum},
              rows, few);
    std::vector<std::array<std::uint64_t, 2>> centres = {{sums[axis], sums[axis2]}};
    const auto x = elected(voters<Int>(rows, axis, layer), layer_crowd),
               y = elected(voters<Int>(rows, axis2, layer), layer_crowd);
    if (!x.empty() && !y.empty() && (x[0] != sums[axis] || y[0] != sums[axis2]))
      centres.push_back({x[0], y[0]});
    for (const auto& [sum, sum2] : centres) {
      try_one(others, {axis, sum, Symmetry::half_turn, sum2}, rows, few);
      Symmetry turn = {axis, sum, Symmetry::quarter_turn, sum2};
      if ((turn.sum + turn.sum2) % 2 != 0) --turn.sum;
      if (try_one(others, turn, rows, few) == 0) continue;
      // What rounding may have moved.
      for (const std::uint64_t by : {std::uint64_t(1), ~std::uint64_t(0)})
        try_one(others, {axis, turn.sum + by, Symmetry::quarter_turn, turn.sum2 + by}, rows, few);
    }
  }
  // What is chosen by layers may be all flat, so the best are asked of all.
  Best best;
  for (const Best& finalist :
       {*std::max_element(mirrors.begin(), mirrors.end(),
                          [](const Best&a, const Best&b) { return a.worth < b.worth; }),
        others})
    if (finalist.symmetry) try_one(best, *finalist.symmetry, lattice.rows);
  return best.symmetry;
}

template std::optional<Symmetry> find_mirror(const Lattice<std::int32_t>&);
template std::optional<Symmetry> find_mirror(const Lattice<std::int64_t>&);

}  // namespace clers::internal
