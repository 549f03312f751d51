#include <algorithm>
#include <vector>

#include "corpus/build.h"
#include "corpus/generate.h"
#include "corpus/random.h"

namespace clers::corpus {
namespace {

// The faces around the origin of h, as the half-edges that leave it; empty at a boundary.
std::vector<std::uint32_t> star(const std::vector<std::uint32_t>& twin, std::uint32_t h) {
  std::vector<std::uint32_t> leaving;
  std::uint32_t e = h;
  do {
    leaving.push_back(e);
    e = twin[prev_corner(e)];
    if (e == no_twin) return {};
  } while (e != h);
  return leaving;
}

// Faces that `kept` marks, and the vertices they use, in order.
Mesh select(const Mesh& mesh, const std::vector<bool>& kept) {
  std::vector<std::uint32_t> faces, corners;
  std::vector<bool> used(mesh.vertex_count, false);
  for (std::uint32_t f = 0; f < kept.size(); ++f) {
    if (!kept[f]) continue;
    faces.push_back(f);
    for (std::uint32_t h = 3 * f; h < 3 * f + 3; ++h) {
      corners.push_back(h);
      used[mesh.corners[h]] = true;
    }
  }
  std::vector<std::uint32_t> vertices, renumbered(mesh.vertex_count);
  for (std::uint32_t v = 0; v < mesh.vertex_count; ++v) {
    renumbered[v] = static_cast<std::uint32_t>(vertices.size());
    if (used[v]) vertices.push_back(v);
  }
  Mesh out;
  out.name = mesh.name;
  out.vertex_count = static_cast<std::uint32_t>(vertices.size());
  for (const std::uint32_t h : corners) out.corners.push_back(renumbered[mesh.corners[h]]);
  for (const Attribute& a : mesh.attributes)
    out.attributes.push_back(gather(a, a.domain == Domain::vertex   ? vertices
                                       : a.domain == Domain::corner ? corners
                                                                    : faces));
  return out;
}

}  // namespace

Mesh punch_holes(const Mesh& mesh, std::uint32_t count, std::uint64_t seed) {
  const std::vector<std::uint32_t> twin = twins_of(mesh.corners, mesh.vertex_count);
  // Holes that share no vertex leave every vertex one fan: an inner vertex loses one run of its
  // star.
  std::vector<bool> taken(mesh.vertex_count, false);
  for (std::uint32_t h = 0; h < mesh.corners.size(); ++h)
    if (twin[h] == no_twin) taken[mesh.corners[h]] = taken[mesh.corners[next_corner(h)]] = true;

  const auto face_count = static_cast<std::uint32_t>(mesh.face_count());
  std::vector<bool> kept(face_count, true);
  Random random(seed);
  for (const std::uint32_t f : random.permutation(face_count)) {
    if (count == 0) break;
    std::vector<std::uint32_t> hole{3 * f};
    if (random.chance(50)) hole = star(twin, 3 * f);
    const bool free = !hole.empty() && std::all_of(hole.begin(), hole.end(), [&](std::uint32_t h) {
      return !taken[mesh.corners[h]] && !taken[mesh.corners[next_corner(h)]] &&
             !taken[mesh.corners[prev_corner(h)]];
    });
    if (!free) continue;
    for (const std::uint32_t h : hole) {
      kept[h / 3] = false;
      for (std::uint32_t corner = h / 3 * 3; corner < h / 3 * 3 + 3; ++corner)
        taken[mesh.corners[corner]] = true;
    }
    --count;
  }
  return select(mesh, kept);
}

}  // namespace clers::corpus
