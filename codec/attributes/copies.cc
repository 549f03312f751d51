// Finds components with the same connectivity, by hashes of their corners. Where two components
// have the same hash by accident, what is predicted is bad and nothing else is wrong.
#include "codec/attributes/copies.h"

#include "topology/ids.h"

namespace clers::internal {
namespace {

struct Component {
  std::uint64_t hash;
  std::uint32_t index, first, count;  ///< vertices in the order of introduction
};

bool begins_component(const CodedSurface& surface, std::uint32_t t) {
  const HalfEdge across = surface.twins[3 * std::size_t(t)];
  return !across || left(across).index() >= t;
}

}  // namespace

std::size_t component_count(const CodedSurface& surface) {
  std::size_t count = 0;
  for (std::uint32_t t = 0; t < surface.twins.size() / 3; ++t)
    count += begins_component(surface, t);
  return count;
}

Originals find_originals(const CodedSurface& surface) {
  constexpr std::uint32_t none = Originals::none;
  Originals found;
  if (surface.twins.empty()) return found;
  const std::size_t vertices = surface.introduced_by.size();
  found.component.assign(vertices, none);
  // For the time being the place of each vertex in `order`.
  std::vector<std::uint32_t>& place = found.of;
  place.assign(vertices, none);
  std::vector<std::uint32_t> order;
  order.reserve(vertices);
  const auto triangles = static_cast<std::uint32_t>(surface.corners.size() / 3);
  std::vector<Component> components;
  components.reserve(component_count(surface));
  for (std::uint32_t t = 0; t < triangles; ++t) {
    if (begins_component(surface, t))
      components.push_back({0, static_cast<std::uint32_t>(components.size()),
                            static_cast<std::uint32_t>(order.size()), 0});
    Component& component = components.back();
    for (const std::uint32_t v : surface.corners.subspan(3 * std::size_t(t), 3)) {
      if (found.component[v] == none) {
        found.component[v] = component.index;
        place[v] = static_cast<std::uint32_t>(order.size());
        order.push_back(v);
        ++component.count;
      }
      // By its place in the component; one of an earlier component has a great one.
      std::uint64_t& hash = component.hash;
      hash = (hash ^ (place[v] - component.first + 1)) * 0x9e3779b97f4a7c15u;
      hash ^= hash >> 29;
    }
  }
  std::sort(components.begin(), components.end(), [](const Component& a, const Component& b) {
    if (a.hash != b.hash) return a.hash < b.hash;
    if (a.count != b.count) return a.count < b.count;
    return a.index < b.index;
  });
  std::fill(found.of.begin(), found.of.end(), none);
  for (std::size_t i = 1; i < components.size(); ++i) {
    const Component &of = components[i - 1], &copy = components[i];
    if (of.hash != copy.hash || of.count != copy.count) continue;
    for (std::uint32_t k = 0; k < copy.count; ++k)
      found.of[order[copy.first + k]] = order[of.first + k];
    found.count += copy.count;
  }
  return found;
}

template <class Int>
bool copies_pay(const CodedSurface& surface, const Originals& originals,
                const Lattice<Int>& lattice) {
  if (20 * originals.count < lattice.count()) return false;
  Copies<Int> copies(originals, lattice.rows.data(), lattice.axes);
  std::uint64_t by_copies = 0, by_parallelograms = 0;  // bits of what they are off
  for_each_introduced(surface, [&](std::uint32_t t, unsigned corner) {
    const std::uint32_t* const c = &surface.corners[3 * std::size_t(t)];
    const HalfEdge across = surface.twins[3 * std::size_t(t)];
    if (corner == 2 && across) {
      const std::uint32_t o = surface.corners[lprev(across).index()];
      std::array<Int, 3> place;
      const bool guessed = copies.guess(c[2], c[0], c[1], o, place.data());
      for (std::size_t i = 0; guessed && i < 3; ++i) {
        const auto at = [&](std::uint32_t v) {
          return std::int64_t(lattice.rows[3 * std::size_t(v) + i]);
        };
        const auto bits = [](std::int64_t d) {
          return std::bit_width(static_cast<std::uint64_t>(d < 0 ? -d : d));
        };
        by_copies += static_cast<std::uint64_t>(bits(at(c[2]) - place[i]));
        by_parallelograms +=
            static_cast<std::uint64_t>(bits(at(c[2]) - at(c[0]) - at(c[1]) + at(o)));
      }
    }
    copies.known(c[corner]);
  });
  return by_copies + 100 < by_parallelograms;
}

template bool copies_pay(const CodedSurface&, const Originals&, const Lattice<std::int32_t>&);
template bool copies_pay(const CodedSurface&, const Originals&, const Lattice<std::int64_t>&);

}  // namespace clers::internal
