// Finds the plane that most vertices have a mirror image by. By votes: two vertices that agree in
// two coordinates vote for the sum of the third ones; the sums with the most votes are tried.
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

}  // namespace

template <class Int>
std::optional<MirrorPlane> find_mirror(const Lattice<Int>& lattice) {
  const std::size_t count = lattice.count();
  std::optional<MirrorPlane> best;
  std::uint64_t most = 0;
  for (std::uint32_t axis = 0; axis < 3; ++axis)
    for (const std::uint64_t sum : elected(voters(lattice, axis))) {
      const MirrorPlane plane{axis, sum};
      Mirror<Int> mirror(plane, lattice.rows.data(), count, {});
      for (std::uint32_t v = 0; v < count; ++v) mirror.known(v);
      std::uint64_t paired = 0, exactly = 0;
      for (std::uint32_t v = 0; v < count; ++v) {
        const std::uint32_t w = mirror.partner(v);
        if (w == v || w == mirror.nobody) continue;
        ++paired;
        exactly += mirror.image(w, axis) == lattice.rows[3 * std::size_t(v) + axis];
      }
      if (10 * paired < count || 4 * paired + exactly <= most) continue;
      most = 4 * paired + exactly;
      best = plane;
    }
  return best;
}

template std::optional<MirrorPlane> find_mirror(const Lattice<std::int32_t>&);
template std::optional<MirrorPlane> find_mirror(const Lattice<std::int64_t>&);

}  // namespace clers::internal
