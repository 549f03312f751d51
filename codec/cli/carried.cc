// Along an edge that is a seam both sides are mixed, each for itself:
//
//         l            corners of `gone` and `kept` in the face of l become mixtures of both, and
//        / .           so do those in the face of r. All corners that have these values, as those
//   gone ---- kept     of a fan between two seams do, get the mixtures. `kept` stays where it is
//        . /           if it has other values, and so they are not mixed.
//         r
#include "codec/cli/carried.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

#include "codec/cli/vertex_values.h"

namespace clers::cli {

// ---- Mixtures

MixedValues::MixedValues(const Attribute& of)
    : of_(of),
      given_(of.value_count()),
      mixed_(of.scalar == Scalar::float32 || of.scalar == Scalar::float64 ||
             size_of(of.scalar) == 1),
      direction_(of.name == "normal" && of.components == 3 && size_of(of.scalar) > 1) {}

double MixedValues::number(std::uint32_t value, std::size_t k) const {
  return value < given_
             ? load(of_.scalar, of_.data.data() + value * of_.stride() + k * size_of(of_.scalar))
             : mixtures_[(value - given_) * of_.components + k];
}

std::uint32_t MixedValues::mix(std::uint32_t a, std::uint32_t b, double weight) {
  if (a == b || weight == 0 || a == no_value || b == no_value) return a;
  if (weight == 1) return b;
  if (!mixed_) return weight < 0.5 ? a : b;
  const std::size_t first = mixtures_.size(), n = of_.components;
  double of_a = 0, of_b = 0, of_mixture = 0;  // squared lengths
  for (std::size_t k = 0; k < n; ++k) {
    const double x = number(a, k), y = number(b, k), z = (1 - weight) * x + weight * y;
    of_a += x * x, of_b += y * y, of_mixture += z * z;
    mixtures_.push_back(z);
  }
  if (direction_ && of_mixture > 0) {
    const double longer =
        ((1 - weight) * std::sqrt(of_a) + weight * std::sqrt(of_b)) / std::sqrt(of_mixture);
    for (std::size_t k = 0; k < n; ++k) mixtures_[first + k] *= longer;
  }
  return static_cast<std::uint32_t>(given_ + first / n);
}

bool MixedValues::same(std::uint32_t a, std::uint32_t b) const {
  if (a == b) return true;
  if (a >= given_ || b >= given_) return false;
  const std::byte* data = of_.data.data();
  return std::memcmp(data + a * of_.stride(), data + b * of_.stride(), of_.stride()) == 0;
}

void MixedValues::write(std::uint32_t value, std::byte* to) const {
  if (value < given_) {
    std::memcpy(to, of_.data.data() + value * of_.stride(), of_.stride());
    return;
  }
  for (std::size_t k = 0; k < of_.components; ++k)
    store(of_.scalar, number(value, k), to + k * size_of(of_.scalar));
}

// ---- Elements

Carried::Carried(const Mesh& mesh, const SurfaceByCuts& cut, Creases& creases,
                 std::vector<std::string>& notes)
    : surface_(cut.surface), cut_(cut), mesh_(mesh) {
  for (const Attribute& a : mesh.attributes) {
    if (&a == mesh.position()) continue;
    Track track{&a, MixedValues(a), {}};
    const auto give = [&](std::uint32_t i) {
      track.of.push_back(a.indices.empty() ? i : a.indices[i]);
    };
    switch (a.domain) {
      case Domain::vertex:
        for (std::uint32_t v = 0; v < mesh.vertex_count; ++v) give(v);
        for (const std::uint32_t v : cut.copied) give(v);
        vertices_.push_back(std::move(track));
        break;
      case Domain::face:
        for (std::uint32_t f = 0; f < surface_.face_limit(); ++f) give(f);
        if (!mark_seams(track, creases))
          notes.push_back(fmt::format(
              "attribute \"{}\" changes at most edges: faces alike are not kept together", a.name));
        faces_.push_back(std::move(track));
        break;
      case Domain::corner:
        for (std::uint32_t h = 0; h < surface_.half_edge_limit(); ++h)
          give(corner_of_mesh(HalfEdge(h)));
        share(track);
        if (mark_seams(track, creases))
          corners_.push_back(std::move(track));
        else
          notes.push_back(
              fmt::format("attribute \"{}\" is left out: it has seams at most edges", a.name));
        break;
    }
  }
}

std::uint32_t Carried::corner_of_mesh(HalfEdge h) const {
  const std::uint32_t f = left(h).index(), i = corner(h);
  const bool turned = std::binary_search(cut_.reversed.begin(), cut_.reversed.end(), f);
  return 3 * f + (turned ? (3 - i) % 3 : i);
}

/// Gives equal values at a vertex one number.
void Carried::share(Track& track) const {
  std::vector<std::uint32_t> others;
  for (const Vertex v : surface_.vertices()) {
    others.clear();
    for (const HalfEdge h : surface_.fan(v)) {
      std::uint32_t& value = track.of[h.index()];
      const auto equal = std::find_if(others.begin(), others.end(), [&](std::uint32_t other) {
        return track.values.same(value, other);
      });
      if (equal == others.end())
        others.push_back(value);
      else
        value = *equal;
    }
  }
}

bool Carried::is_seam(const Track& track, HalfEdge h) const {
  const HalfEdge twin = surface_.sym(h);
  if (!twin) return false;
  const auto& of = track.of;
  if (track.attribute->domain == Domain::face)
    return !track.values.same(of[left(h).index()], of[left(twin).index()]);
  return of[h.index()] != of[lnext(twin).index()] || of[lnext(h).index()] != of[twin.index()];
}

/// Or does not: returns false if they are most edges.
bool Carried::mark_seams(const Track& track, Creases& creases) const {
  std::vector<HalfEdge> seams;
  std::size_t inside = 0;
  for (const HalfEdge h : surface_.edges()) {
    if (!surface_.is_boundary(h)) ++inside;
    if (is_seam(track, h)) seams.push_back(h);
  }
  if (4 * seams.size() > 3 * inside) return false;
  for (const HalfEdge h : seams) creases.mark(surface_, h);
  return true;
}

// ---- Contractions

void Carried::before(const Contraction& c) {
  for (Track& t : vertices_) {
    std::uint32_t& value = t.of[c.kept.index()];
    value = t.values.mix(value, t.of[c.gone.index()], c.weight);
  }
  if (corners_.empty() && faces_.empty()) return;

  /// What corners of both ends become, on each side.
  struct Side {
    std::uint32_t kept, gone, mixture;
  };
  std::vector<std::array<Side, 2>> sides;
  const HalfEdge h = c.edge, twin = surface_.sym(h);
  for (Track& t : corners_) {
    const auto mixed = [&](HalfEdge at_kept, HalfEdge at_gone) {
      const std::uint32_t kept = t.of[at_kept.index()], gone = t.of[at_gone.index()];
      return Side{kept, gone, t.values.mix(kept, gone, c.weight)};
    };
    const Side one = mixed(lnext(h), h);
    const bool alike =
        !twin || (t.of[twin.index()] == one.kept && t.of[lnext(twin).index()] == one.gone);
    sides.push_back({one, alike ? one : mixed(twin, lnext(twin))});
  }

  kept_.clear();
  values_.clear();
  for (const Vertex end : {c.kept, c.gone}) {
    const Vertex other = end == c.kept ? c.gone : c.kept;
    for (const HalfEdge f : surface_.fan(end)) {
      const Vertex to = surface_.dest(f), next = surface_.org(lprev(f));
      if (to == other || next == other) continue;
      kept_.push_back({to, next, values_.size()});
      for (std::size_t i = 0; i < corners_.size(); ++i) {
        const auto& of = corners_[i].of;
        std::uint32_t value = of[f.index()];
        for (const Side& side : sides[i])
          if (value == (end == c.kept ? side.kept : side.gone)) {
            value = side.mixture;
            break;
          }
        values_.insert(values_.end(), {value, of[lnext(f).index()], of[lprev(f).index()]});
      }
      for (const Track& t : faces_) values_.push_back(t.of[left(f).index()]);
    }
  }
}

void Carried::after(const Contraction& c) {
  if (corners_.empty() && faces_.empty()) return;
  for (const HalfEdge f : surface_.fan(c.kept)) {
    const Vertex to = surface_.dest(f), next = surface_.org(lprev(f));
    const auto found = std::find_if(kept_.begin(), kept_.end(),
                                    [&](const Kept& k) { return k.to == to && k.next == next; });
    if (found == kept_.end()) continue;
    const std::uint32_t* value = values_.data() + found->values;
    for (Track& t : corners_)
      for (const HalfEdge h : {f, lnext(f), lprev(f)}) t.of[h.index()] = *value++;
    for (Track& t : faces_) t.of[left(f).index()] = *value++;
    *found = kept_.back();  // of two alike, each once
    kept_.pop_back();
  }
}

// ---- The mesh

Attribute Carried::made_of(const Track& track, const std::vector<std::uint32_t>& elements) {
  const Attribute& a = *track.attribute;
  Attribute out{a.name, a.domain, a.scalar, a.components, {}};
  const std::size_t stride = a.stride();
  const auto append = [&](std::uint32_t value) {
    out.data.resize(out.data.size() + stride);
    track.values.write(value, out.data.data() + out.data.size() - stride);
  };
  if (a.indices.empty()) {
    out.data.reserve(elements.size() * stride);
    for (const std::uint32_t i : elements) append(track.of[i]);
    return out;
  }
  std::vector<std::uint32_t> number;  // of values that elements have
  for (const std::uint32_t i : elements) {
    const std::uint32_t value = track.of[i];
    if (value == no_value) {
      out.indices.push_back(no_value);
      continue;
    }
    if (value >= number.size()) number.resize(value + std::size_t{1}, no_value);
    if (number[value] == no_value) {
      number[value] = static_cast<std::uint32_t>(out.data.size() / stride);
      append(value);
    }
    out.indices.push_back(number[value]);
  }
  return out;
}

std::vector<Attribute> Carried::attributes(const MeshOfSurface& made,
                                           const std::vector<Position3>& at) const {
  std::vector<std::uint32_t> vertices, corners, faces;
  for (const Vertex v : made.vertices) vertices.push_back(v.index());
  for (const Face f : made.faces) {
    faces.push_back(f.index());
    for (unsigned i = 0; i < 3; ++i) corners.push_back(half_edge(f, i).index());
  }
  std::vector<Attribute> out;
  for (const Attribute& a : mesh_.attributes) {
    if (&a == mesh_.position()) {
      Attribute& position = out.emplace_back(Attribute{a.name, a.domain, a.scalar, 3, {}});
      const std::size_t size = size_of(a.scalar);
      position.data.resize(vertices.size() * 3 * size);
      std::byte* to = position.data.data();
      for (const std::uint32_t v : vertices)
        for (const double x : at[v]) store(a.scalar, x, std::exchange(to, to + size));
      continue;
    }
    for (const auto* tracks : {&vertices_, &corners_, &faces_})
      for (const Track& t : *tracks)
        if (t.attribute == &a)
          out.push_back(made_of(t, a.domain == Domain::vertex   ? vertices
                                   : a.domain == Domain::corner ? corners
                                                                : faces));
  }
  return out;
}

}  // namespace clers::cli
