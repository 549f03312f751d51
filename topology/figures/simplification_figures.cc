// Figures of simplification by four-face clusters (§7.4).
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "topology/figures/drawing.h"
#include "topology/modeling/clusters.h"
#include "topology/modeling/simplify.h"

namespace clers::figures {

std::string four_face_cluster() {
  Figure figure(62, 160, 160);
  Scene s = fan(6, 1.1);
  s.at[0] = {0.1, 0.05};
  for (std::uint32_t v = 1; v < 7; ++v) s.place(Vertex(v)).x *= v % 2 == 0 ? 1 : 0.8;
  s.dot(Vertex(0));
  std::vector<Position3> at;
  for (const Place& p : s.at) at.push_back({p.x, p.y, p.z});
  Creases none;
  ClusterSimplification clusters(s.surface, at, none, {.faces = 5});
  const std::optional<Removal> removal = clusters.next();
  must(removal && removal->vertex == Vertex(0) && removal->ears.size() == 2,
       "a vertex of six edges");

  for (const Vertex ear : removal->ears) s.marked.push_back(between(s, 0, ear.index()));
  figure.panel(s, "two edges to flip");
  std::size_t flips = 0;
  remove(s.surface, none, *removal, [&](const Change& change) {
    s.unmark();
    if (change.gone()) {
      figure.arrow("weld(v)");
      s.marked = {between(s, removal->diagonal[0].index(), removal->diagonal[1].index())};
      figure.panel(s, "");
      return;
    }
    figure.arrow("flip(e)");
    s.marked = {change.slots()[0].at};
    s.dot(Vertex(0));
    figure.panel(s, ++flips == 2 ? "a cluster of four faces" : "");
  });
  must(flips == 2 && s.surface.characteristic().f == 4, "flips and a weld");
  return figure.svg();
}

namespace {

struct Land {
  Surface surface;
  std::vector<Position3> at;
};

/// Hills over points that are off a grid at random.
Land land(std::uint32_t n) {
  Land l{test::grid(n, n), {}};
  std::uint32_t seed = 2010;
  const auto random = [&] {
    seed = seed * 1664525u + 1013904223u;
    return (seed >> 8) / 16777216. - 0.5;
  };
  for (std::uint32_t y = 0; y <= n; ++y)
    for (std::uint32_t x = 0; x <= n; ++x) {
      const bool inside = x != 0 && y != 0 && x != n && y != n;
      const double p = x + (inside ? 0.7 * random() : 0), q = y + (inside ? 0.7 * random() : 0);
      double z = 0;
      for (const auto& [a, b] : {std::pair(0.25, 0.25), std::pair(0.7, 0.6), std::pair(0.3, 0.8)}) {
        const double dx = p / n - a, dy = q / n - b;
        z += 0.15 * n / (1 + 40 * (dx * dx + dy * dy));
      }
      l.at.push_back({p, q, z});
    }
  return l;
}

/// How many faces are how round, in tenths: twice the radius of the inscribed circle over that of
/// the circumscribed one.
std::array<double, 10> shares(const Land& l) {
  std::array<double, 10> shares{};
  const double one = 1. / static_cast<double>(l.surface.characteristic().f);
  for (const Face f : l.surface.faces()) {
    std::array<double, 3> e{};
    for (unsigned i = 0; i < 3; ++i) {
      const Position3 &a = l.at[l.surface.org(half_edge(f, i)).index()],
                      &b = l.at[l.surface.dest(half_edge(f, i)).index()];
      double square = 0;
      for (std::size_t k = 0; k < 3; ++k) square += (a[k] - b[k]) * (a[k] - b[k]);
      e[i] = std::sqrt(square);
    }
    const double ratio =
        (e[0] + e[1] - e[2]) * (e[1] + e[2] - e[0]) * (e[2] + e[0] - e[1]) / (e[0] * e[1] * e[2]);
    shares[std::min(static_cast<std::size_t>(std::max(10 * ratio, 0.)), std::size_t{9})] += one;
  }
  return shares;
}

/// In tenths of a pixel, about the middle of a panel of 200 by 150.
std::string histogram(const std::array<double, 10>& shares) {
  std::string out;
  const auto add = [&](const std::string& what) { out += what + '\n'; };
  for (std::size_t i = 0; i < 10; ++i) {
    const int height = static_cast<int>(std::lround(4000 * shares[i]));
    add("<rect x=\"" + std::to_string(-850 + 170 * static_cast<int>(i)) + "\" y=\"" +
        std::to_string(600 - height) + "\" width=\"150\" height=\"" + std::to_string(height) +
        "\" fill=\"#8fb0cc\"/>");
  }
  add("<path d=\"M-860 600H860\"/>");
  for (const auto& [x, text] : {std::pair(-850, "0"), std::pair(850, "1")})
    add("<text x=\"" + std::to_string(x) +
        "\" y=\"730\" text-anchor=\"middle\" style=\"font-size:110px\">" + text + "</text>");
  return out;
}

}  // namespace

std::string shapes_of_triangles() {
  Figure figure(1, 200, 150);
  const Land whole = land(60);
  const std::int64_t half = whole.surface.characteristic().f / 2;
  figure.panel(histogram(shares(whole)), "7,200 faces");
  Land edges = whole, clusters = whole;
  must(simplify(edges.surface, edges.at, {.faces = half}).ok(), "contracted edges");
  figure.panel(histogram(shares(edges)), "3,600, by error alone");
  Creases none;
  must(simplify_by_clusters(clusters.surface, clusters.at, none, {.faces = half}).ok(), "clusters");
  must(edges.surface.characteristic().f <= half && clusters.surface.characteristic().f <= half,
       "half of the faces");
  figure.panel(histogram(shares(clusters)), "3,600, by four-face clusters");
  return figure.svg();
}

}  // namespace clers::figures
