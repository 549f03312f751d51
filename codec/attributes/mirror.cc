// Finds the symmetry by which most vertices are images of others. Mirrors by votes: two vertices
// that agree in two coordinates vote for the sum of the third ones; the sums with the most votes
// are tried. Turns about the middle alone.
#include "codec/attributes/mirror.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace clers::internal {
namespace {

// Vertices that vote on an axis at most. Whether one does depends on two of its coordinates, so
// that a vertex and its image do or do not together.
constexpr std::size_t most_voters = std::size_t(1) << 16;
// Where so many agree in two coordinates, as on the walls of a box, their sums say little.
constexpr std::size_t crowd = 40;
// Sums that are tried on an axis, and the share of voters without whose votes one is not.
constexpr std::size_t candidates = 4, least_votes = 50;

struct Voter {
  std::uint64_t line, x;
};

/// The vertices by the line along the axis that they are on: each line a hash.
template <class Int>
std::vector<Voter> voters(const Lattice<Int>& lattice, std::size_t axis) {
  const std::size_t count = lattice.count();
  const std::uint64_t parts = count / most_voters + 1;
  std::vector<Voter> found;
  found.reserve(std::min(count, 2 * most_voters));
  for (std::size_t v = 0; v < count; ++v) {
    const Int* const row = &lattice.rows[3 * v];
    std::uint64_t line = static_cast<std::uint64_t>(row[(axis + 1) % 3]) * 0x9e3779b97f4a7c15u;
    line = (line ^ line >> 29) + static_cast<std::uint64_t>(row[(axis + 2) % 3]);
    line = (line ^ line >> 32) * 0xc2b2ae3d27d4eb4fu;
    line ^= line >> 29;
    if (line % parts != 0) continue;
    found.push_back({line, static_cast<std::uint64_t>(row[axis])});
    if (found.size() == 2 * most_voters) break;
  }
  std::sort(found.begin(), found.end(),
            [](const Voter& a, const Voter& b) { return a.line < b.line; });
  return found;
}

/// The sums that get the most votes, with those of the sums beside them.
std::vector<std::uint64_t> elected(const std::vector<Voter>& voters) {
  std::vector<std::uint64_t> sums;
  for (std::size_t from = 0, to; from < voters.size(); from = to) {
    for (to = from; to < voters.size() && voters[to].line == voters[from].line;) ++to;
    if (to - from >= crowd) continue;
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

/// A measure of how much can be predicted, 0 if it is too little: vertices that are images, and
/// among what has as many those that are so exactly.
template <class Int>
std::uint64_t worth(const Symmetry& symmetry, std::span<const Int> rows) {
  const std::size_t count = rows.size() / 3;
  Mirror<Int> mirror(symmetry, rows.data(), count, {});
  for (std::uint32_t v = 0; v < count; ++v) mirror.known(v);
  if (20 * mirror.images() < count) return 0;
  std::uint64_t exactly = 0;
  for (std::uint32_t v = 0; v < count; ++v) {
    const std::uint32_t w = mirror.partner(v);
    bool same = w != v && w != mirror.nobody;
    for (std::size_t c = 0; same && c < 3; ++c)
      same = mirror.partner_image(v, c) == rows[3 * std::size_t(v) + c];
    exactly += same;
  }
  return 8 * std::uint64_t(mirror.images()) + exactly;
}

/// The rows that have some of the coordinates there are on an axis, all if they are not many.
template <class Int>
std::vector<Int> some_layers(const Lattice<Int>& lattice, std::size_t axis) {
  constexpr std::size_t many = 8192;
  const std::uint64_t parts = lattice.count() / many + 1;
  std::vector<Int> rows;
  for (std::size_t v = 0; v < lattice.count() && rows.size() < 12 * many; ++v) {
    const auto row = lattice.rows.subspan(3 * v, 3);
    const std::uint64_t x = static_cast<std::uint64_t>(row[axis]) * 0x9e3779b97f4a7c15u;
    if ((x ^ x >> 32) % parts == 0) rows.insert(rows.end(), row.begin(), row.end());
  }
  return rows;
}

}  // namespace

template <class Int>
std::optional<Symmetry> find_mirror(const Lattice<Int>& lattice) {
  std::optional<Symmetry> best;
  std::uint64_t most = 0;
  const auto try_one = [&](const Symmetry& symmetry) {
    const std::uint64_t found = worth<Int>(symmetry, lattice.rows);
    if (found > most) {
      most = found;
      best = symmetry;
    }
    return found;
  };
  // Mirrors.
  std::array<std::optional<Symmetry>, 3> mirrors;
  for (std::uint32_t axis = 0; axis < 3; ++axis) {
    std::uint64_t most_here = 0;
    for (const std::uint64_t sum : elected(voters(lattice, axis))) {
      const std::uint64_t found = try_one({axis, sum});
      if (found <= most_here) continue;
      most_here = found;
      mirrors[axis] = {axis, sum};
    }
  }
  for (std::uint32_t axis = 0; axis < 3; ++axis)
    if (const auto& one = mirrors[axis], &other = mirrors[(axis + 1) % 3]; one && other)
      try_one({axis, one->sum, Symmetry::mirrors, other->sum});
  // Turns about the middle of all.
  std::array<std::uint64_t, 3> sums = {};
  for (std::size_t c = 0; c < 3 && lattice.count() > 0; ++c) {
    Int least = lattice.rows[c], greatest = least;
    for (std::size_t i = c; i < lattice.rows.size(); i += 3) {
      least = std::min(least, lattice.rows[i]);
      greatest = std::max(greatest, lattice.rows[i]);
    }
    sums[c] = static_cast<std::uint64_t>(least + greatest);
  }
  for (std::uint32_t axis = 0; axis < 3; ++axis) {
    const std::vector<Int> some = some_layers(lattice, (axis + 2) % 3);
    Symmetry turn = {axis, sums[axis], Symmetry::half_turn, sums[(axis + 1) % 3]};
    for (const Symmetry::Kind kind : {Symmetry::half_turn, Symmetry::quarter_turn}) {
      turn.kind = kind;
      turn.sum = sums[axis];
      if (kind == Symmetry::quarter_turn && (turn.sum + turn.sum2) % 2 != 0) --turn.sum;
      if (!turn.fits(lattice.axes) || worth<Int>(turn, some) == 0) continue;
      try_one(turn);
      // What rounding may have moved.
      for (const bool up : {false, true}) {
        Symmetry beside = turn;
        beside.sum += up ? 1 : ~std::uint64_t(0);
        beside.sum2 += up ? 1 : ~std::uint64_t(0);
        if (beside.fits(lattice.axes)) try_one(beside);
      }
    }
  }
  return best;
}

template std::optional<Symmetry> find_mirror(const Lattice<std::int32_t>&);
template std::optional<Symmetry> find_mirror(const Lattice<std::int64_t>&);

}  // namespace clers::internal
