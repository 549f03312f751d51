#include "codec/test/golden_meshes.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

#include "corpus/build.h"
#include "corpus/generate.h"
#include "corpus/random.h"

namespace clers::test {
namespace {

using corpus::Random;
using Index = std::uint32_t;

void add_face(Mesh& mesh, const std::vector<Index>& face) {
  mesh.corners.insert(mesh.corners.end(), face.begin(), face.end());
  mesh.face_sizes.push_back(static_cast<Index>(face.size()));
}

std::vector<std::vector<Index>> faces_of(const Mesh& mesh) {
  std::vector<std::vector<Index>> faces;
  auto at = mesh.corners.begin();
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const std::ptrdiff_t size = mesh.triangles_only() ? 3 : mesh.face_sizes[f];
    faces.emplace_back(at, at + size);
    at += size;
  }
  return faces;
}

Mesh with_faces(const Mesh& mesh, const std::vector<std::vector<Index>>& faces) {
  Mesh out = mesh;
  out.corners.clear();
  out.face_sizes.clear();
  for (const auto& face : faces) add_face(out, face);
  if (std::all_of(out.face_sizes.begin(), out.face_sizes.end(), [](Index n) { return n == 3; }))
    out.face_sizes.clear();
  return out;
}

/// A vertex for each triangle, and a polygon around each vertex. Precondition: closed.
Mesh dual(const Mesh& mesh) {
  const std::vector<Index> twin = corpus::twins_of(mesh.corners, mesh.vertex_count);
  std::vector<Index> at(mesh.vertex_count);
  for (Index h = 0; h < mesh.corners.size(); ++h) at[mesh.corners[h]] = h;
  Mesh out;
  out.vertex_count = static_cast<Index>(mesh.face_count());
  for (const Index begin : at) {
    std::vector<Index> face;
    Index h = begin;
    do {
      face.push_back(h / 3);
      h = twin[corpus::prev_corner(h)];
    } while (h != begin);
    add_face(out, face);
  }
  return out;
}

/// Two polygons of n corners and a belt of quadrilaterals.
Mesh prism(Index n) {
  Mesh out;
  out.vertex_count = 2 * n;
  std::vector<Index> top(n), bottom(n);
  for (Index i = 0; i < n; ++i) top[i] = i, bottom[i] = 2 * n - 1 - i;
  add_face(out, top);
  for (Index i = 0; i < n; ++i) {
    const Index j = (i + 1) % n;
    add_face(out, {j, i, n + i, n + j});
  }
  add_face(out, bottom);
  return out;
}

/// Every k-th face is left out, reversed, or repeated.
enum class Do { leave_out, reverse, repeat };
Mesh every(Index k, Do what, const Mesh& mesh) {
  std::vector<std::vector<Index>> faces;
  Index i = 0;
  for (auto& face : faces_of(mesh)) {
    const bool chosen = ++i % k == 0;
    if (chosen && what == Do::leave_out) continue;
    if (chosen && what == Do::reverse) std::reverse(face.begin(), face.end());
    faces.push_back(face);
    if (chosen && what == Do::repeat) faces.push_back(std::move(face));
  }
  return with_faces(mesh, faces);
}

/// Random vertices become one, and leave isolated ones behind.
Mesh merge_vertices(Mesh mesh, Index times, std::uint64_t seed) {
  Random random(seed);
  for (Index i = 0; i < times; ++i) {
    const Index from = random.below(mesh.vertex_count), to = random.below(mesh.vertex_count);
    for (Index& v : mesh.corners)
      if (v == from) v = to;
  }
  return mesh;
}

/// Behind every k-th face a triangle (a, a, b) on one of its edges, and one (a, a, a) now and then.
Mesh fold(const Mesh& mesh, Index k) {
  std::vector<std::vector<Index>> faces;
  for (auto& face : faces_of(mesh)) {
    faces.push_back(face);
    const auto i = faces.size();
    const Index a = face[i % face.size()], b = face[(i + 1) % face.size()];
    if (i % k == 0) faces.push_back(i % 2 ? std::vector{a, a, b} : std::vector{b, a, b});
    if (i % (5 * k) == 0) faces.push_back({a, a, a});
  }
  return with_faces(mesh, faces);
}

/// Faces of 0 .. 6 corners, which repeat each other and themselves.
Mesh wild_soup(Index vertices, Index count, std::uint64_t seed) {
  Random random(seed);
  Mesh out;
  out.vertex_count = vertices;
  std::vector<std::vector<Index>> faces;
  for (Index f = 0; f < count; ++f) {
    std::vector<Index> face;
    if (f > 0 && random.chance(20)) {
      face = faces[random.below(f)];
      if (random.chance(50)) std::reverse(face.begin(), face.end());
    } else {
      face.resize(random.below(7));
      for (Index& v : face) v = random.below(vertices);
    }
    faces.push_back(std::move(face));
  }
  for (const auto& face : faces) add_face(out, face);
  return out;
}

}  // namespace

Mesh bare(Mesh mesh) {
  mesh.attributes.clear();
  return mesh;
}

Mesh steady(Mesh mesh) {
  for (Attribute& a : mesh.attributes) {
    std::vector<float> values(a.data.size() / sizeof(float));
    std::memcpy(values.data(), a.data.data(), a.data.size());
    for (float& x : values) x = static_cast<float>(std::llround(x * 1024.0)) / 1024;
    std::memcpy(a.data.data(), values.data(), a.data.size());
  }
  return mesh;
}

Mesh quads(const Mesh& mesh, unsigned percent, std::uint64_t seed) {
  const auto triangles = faces_of(mesh);
  std::vector<std::vector<Index>> faces;
  Random random(seed);
  for (std::size_t f = 0; f + 1 < triangles.size(); f += 2) {
    const auto &s = triangles[f], &t = triangles[f + 1];
    if (random.chance(percent))
      faces.push_back({s[0], s[1], s[2], t[2]});
    else
      faces.insert(faces.end(), {s, t});
  }
  return with_faces(mesh, faces);
}

std::vector<NamedMesh> surfaces() {
  const Mesh parts[] = {corpus::tetrahedron(), corpus::grid(2, 3), corpus::torus(3, 4)};
  return {{"triangle", corpus::single_triangle()},
          {"pair", corpus::glued_pair()},
          {"sphere", corpus::icosphere(3)},
          {"irregular sphere", corpus::flip_edges(corpus::icosphere(3), 1000, 1)},
          {"holes", corpus::punch_holes(corpus::torus(25, 20), 12, 2)},
          {"annulus", corpus::shuffle(corpus::cylinder(20, 9), 3)},
          {"gyroid", corpus::gyroid(2, 1, 1, 6, corpus::Ends::open)},
          {"periodic gyroid", corpus::gyroid(1, 1, 2, 6, corpus::Ends::periodic)},
          {"lattice", corpus::lattice(4)},
          {"strip", corpus::strip(500)},
          {"fan", corpus::fan(200)},
          {"parts", corpus::disjoint_union(parts)},
          {"copies", corpus::copies(corpus::flip_edges(corpus::icosphere(2), 100, 3), 5)},
          {"apart", corpus::loose_triangles(30)},
          {"reversed", corpus::reversed(corpus::punch_holes(corpus::icosphere(2), 3, 4))},
          {"quads", quads(corpus::torus(24, 17))},
          {"quads with holes", every(9, Do::leave_out, quads(corpus::grid(20, 20)))},
          {"quads and triangles", quads(corpus::cylinder(25, 14), 60, 5)},
          {"dual", dual(corpus::flip_edges(corpus::icosphere(3), 2000, 6))},
          {"dual with handles", dual(corpus::lattice(3))},
          {"dual with holes",
           every(11, Do::leave_out, dual(corpus::flip_edges(corpus::torus(20, 21), 500, 7)))},
          {"prism", prism(700)}};
}

std::vector<NamedMesh> defects() {
  const Mesh ball = corpus::flip_edges(corpus::icosphere(2), 200, 8);
  // Defects at fewer than one side in 64 are cut in another way.
  const Mesh large = corpus::flip_edges(corpus::icosphere(3), 900, 20);
  return {{"fins", corpus::add_fins(ball, 40, 9)},
          {"book", corpus::book(12)},
          {"chessboard", corpus::chessboard(9)},
          {"hub", corpus::pinched_hub(25)},
          {"pinches", merge_vertices(corpus::torus(20, 15), 12, 10)},
          {"pinched quads", merge_vertices(quads(corpus::torus(20, 15)), 12, 11)},
          {"moebius", corpus::moebius_strip(30, 4)},
          {"moebius quads", quads(corpus::moebius_strip(30, 4))},
          {"some reversed", corpus::reverse_some(ball, 60, 12)},
          {"some polygons reversed", every(6, Do::reverse, dual(ball))},
          {"doubled", corpus::doubled(ball)},
          {"two-sided", corpus::two_sided(quads(corpus::grid(9, 8)))},
          {"some repeated", every(5, Do::repeat, ball)},
          {"some polygons repeated", every(5, Do::repeat, dual(ball))},
          {"folded", fold(corpus::grid(12, 12), 4)},
          {"folded quads", fold(quads(corpus::torus(12, 12)), 4)},
          {"same triangle", corpus::same_triangle(20)},
          {"all triples", corpus::all_triples(11)},
          {"soup", corpus::random_soup(60, 200, 3, 13)},
          {"thin soup", corpus::random_soup(3000, 900, 3, 14)},
          {"soup of polygons", corpus::random_soup(300, 300, 9, 15)},
          {"wild soup", wild_soup(40, 150, 16)},
          {"isolated", corpus::isolate(ball, 31)},
          {"few fins", corpus::add_fins(large, 4, 21)},
          {"few fins and pinches", merge_vertices(corpus::add_fins(large, 4, 22), 6, 23)},
          {"few reversed", corpus::reverse_some(large, 4, 24)},
          {"few repeated", every(299, Do::repeat, dual(large))}};
}

}  // namespace clers::test
