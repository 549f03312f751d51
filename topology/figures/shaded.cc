#include "topology/figures/shaded.h"

#include <algorithm>
#include <array>
#include <compare>
#include <cstdint>
#include <cstdio>
#include <utility>
#include <vector>

namespace clers::figures {
namespace {

/// A vertex on the page: tenths of a pixel to the right and down, and thousandths towards the
/// camera.
struct Dot {
  std::int64_t x = 0, y = 0, z = 0;
  auto operator<=>(const Dot&) const = default;
};
struct Triangle {
  unsigned layer = 0, colour = 0;
  std::array<Dot, 3> at;      // the least first, counterclockwise as seen
  std::array<bool, 3> rim{};  // of the side from a corner on: what is beyond it is far behind
  bool hidden = true;
  auto operator<=>(const Triangle&) const = default;
};
using Triangles = std::vector<Triangle>;

constexpr std::int64_t pixel = 10;
constexpr double depth_unit = 1000, far_behind = 12 * depth_unit;
constexpr unsigned shades = 18;
/// The dark and the light end of each tone.
constexpr std::array<std::array<Vector, 2>, 2> tones{{
    {{{104, 126, 146}, {246, 250, 253}}},
    {{{168, 112, 92}, {255, 236, 222}}},
}};

std::int64_t rounded(double x) {
  return static_cast<std::int64_t>(std::floor(x + 0.5));
}

/// Twice the area of a, b and (x, y), positive if that is to the left; y is down.
std::int64_t area(const Dot& a, const Dot& b, std::int64_t x, std::int64_t y) {
  return (b.y - a.y) * (x - a.x) - (b.x - a.x) * (y - a.y);
}

/// A triangle at the middle of a pixel.
struct Hit {
  std::int64_t x = 0, y = 0;
  double depth = 0;
  std::uint32_t triangle = 0;
  auto operator<=>(const Hit&) const = default;
};

/// All triangles at each pixel, from the back to the front.
std::vector<Hit> hits_of(Triangles& triangles) {
  std::vector<Hit> hits;
  for (std::uint32_t i = 0; i < triangles.size(); ++i) {
    const auto& [a, b, c] = triangles[i].at;
    const std::size_t before = hits.size();
    const auto whole = static_cast<double>(area(a, b, c.x, c.y));
    const auto [left, right] = std::minmax({a.x, b.x, c.x});
    const auto [top, bottom] = std::minmax({a.y, b.y, c.y});
    const auto first = [](std::int64_t x) { return x - (x % pixel + pixel) % pixel; };
    for (std::int64_t y = first(top); y <= bottom; y += pixel)
      for (std::int64_t x = first(left); x <= right; x += pixel) {
        const std::int64_t at_a = area(b, c, x, y), at_b = area(c, a, x, y),
                           at_c = area(a, b, x, y);
        if (at_a <= 0 || at_b <= 0 || at_c <= 0) continue;
        const double sum = static_cast<double>(at_a) * static_cast<double>(a.z) +
                           static_cast<double>(at_b) * static_cast<double>(b.z) +
                           static_cast<double>(at_c) * static_cast<double>(c.z);
        hits.push_back({x, y, sum / whole, i});
      }
    if (hits.size() != before) continue;
    // Smaller than a pixel.
    triangles[i].hidden = false;
    hits.push_back({first((a.x + b.x + c.x) / 3), first((a.y + b.y + c.y) / 3),
                    static_cast<double>(a.z + b.z + c.z) / 3, i});
  }
  std::sort(hits.begin(), hits.end());
  return hits;
}

bool same_pixel(const Hit& a, const Hit& b) {
  return a.x == b.x && a.y == b.y;
}

/// Which sides the surface turns away behind, for an outline. Where it is nearly edge-on, narrow
/// triangles turn away that are none's outline: what is a pixel farther decides.
void find_rims(Triangles& triangles, const std::vector<Hit>& hits) {
  const auto floor_to_pixel = [](double x) {
    return pixel * static_cast<std::int64_t>(std::floor(x / pixel));
  };
  for (Triangle& t : triangles) {
    if (t.hidden) continue;
    for (unsigned i = 0; i < 3; ++i) {
      if (!t.rim[i]) continue;
      const Dot &a = t.at[i], &b = t.at[(i + 1) % 3];
      const auto dx = static_cast<double>(b.x - a.x), dy = static_cast<double>(b.y - a.y);
      const double out = 1.5 * pixel / std::sqrt(dx * dx + dy * dy);
      Hit beyond;
      beyond.x = floor_to_pixel(static_cast<double>(a.x + b.x) / 2 - out * dy + pixel / 2.);
      beyond.y = floor_to_pixel(static_cast<double>(a.y + b.y) / 2 + out * dx + pixel / 2.);
      beyond.depth = 1e300;
      const auto next = std::upper_bound(hits.begin(), hits.end(), beyond);
      if (next != hits.begin() && same_pixel(*(next - 1), beyond))
        t.rim[i] = (next - 1)->depth < static_cast<double>(std::min(a.z, b.z)) - far_behind;
    }
  }
}

/// Puts a triangle into a layer above those of all that it hides, so that those of one layer can be
/// drawn in any order, and finds which are hidden wholly.
void find_layers(Triangles& triangles) {
  const std::vector<Hit> hits = hits_of(triangles);
  for (std::size_t i = 0; i < hits.size(); ++i)
    if (i + 1 == hits.size() || !same_pixel(hits[i], hits[i + 1]))
      triangles[hits[i].triangle].hidden = false;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> over;
  const Hit* last = nullptr;
  for (const Hit& hit : hits) {
    if (triangles[hit.triangle].hidden) continue;
    if (last != nullptr && same_pixel(*last, hit)) over.emplace_back(last->triangle, hit.triangle);
    last = &hit;
  }
  std::sort(over.begin(), over.end());
  over.erase(std::unique(over.begin(), over.end()), over.end());
  find_rims(triangles, hits);
  // Small triangles may be said to hide each other: there is an end to that.
  bool changed = true;
  for (int round = 0; changed && round < 40; ++round) {
    changed = false;
    for (const auto& [below, above] : over)
      if (triangles[above].layer <= triangles[below].layer) {
        triangles[above].layer = triangles[below].layer + 1;
        changed = true;
      }
  }
}

std::string fill(unsigned colour) {
  const auto& [dark, light] = tones[colour / shades];
  const Vector rgb = dark + (colour % shades / double(shades - 1)) * (light - dark);
  char text[16];
  std::snprintf(text, sizeof text, "#%02x%02x%02x", static_cast<unsigned>(rounded(rgb[0])),
                static_cast<unsigned>(rounded(rgb[1])), static_cast<unsigned>(rounded(rgb[2])));
  return text;
}

std::string pair(std::int64_t x, std::int64_t y) {
  return std::to_string(x) + (y < 0 ? "" : " ") + std::to_string(y);
}
std::string step(const Dot& a, const Dot& b) {
  return pair(b.x - a.x, b.y - a.y);
}

/// Moves from where the last part of a path began.
std::string move(Dot& pen, const Dot& to) {
  return "m" + step(std::exchange(pen, to), to);
}

}  // namespace

Camera::Camera(const Vector& from, const Vector& up_, const Vector& target_, double pixels_,
               double distance_)
    : target(target_), towards(unit(from)), pixels(pixels_), distance(distance_) {
  right = unit(cross(up_, towards));
  up = cross(towards, right);
}

Vector Camera::see(const Vector& p) const {
  const Vector d = p - target;
  const double near = dot(d, towards);
  const double scale = distance == 0 ? pixels : pixels * distance / (distance - near);
  return {scale * dot(d, right), scale * dot(d, up), near};
}

std::string shaded(const Surface& surface, const Camera& camera,
                   const std::function<Vector(Vertex)>& at,
                   const std::function<unsigned(Face)>& tone) {
  std::vector<Dot> dots(surface.vertex_limit());
  for (const Vertex v : surface.vertices()) {
    const Vector p = camera.see(at(v));
    dots[v.index()] = {rounded(pixel * p[0]), -rounded(pixel * p[1]),
                       rounded(depth_unit * camera.pixels * p[2])};
  }
  const auto dot_at = [&](HalfEdge h) { return dots[surface.org(h).index()]; };
  const auto towards_camera = [&](Face f) {
    const Dot c = dot_at(half_edge(f, 2));
    return area(dot_at(half_edge(f, 0)), dot_at(half_edge(f, 1)), c.x, c.y) > 0;
  };
  const Vector light = unit(-0.45 * camera.right + 0.65 * camera.up + 0.75 * camera.towards);
  Triangles triangles;
  for (const Face f : surface.faces()) {
    if (!towards_camera(f)) continue;
    unsigned first = 0;
    for (unsigned i = 1; i < 3; ++i)
      if (dot_at(half_edge(f, i)) < dot_at(half_edge(f, first))) first = i;
    Triangle t;
    for (unsigned i = 0; i < 3; ++i) {
      const HalfEdge h = half_edge(f, (first + i) % 3);
      t.at[i] = dot_at(h);
      t.rim[i] = surface.is_boundary(h) || !towards_camera(left(surface.sym(h)));
    }
    const Vector a = at(surface.org(half_edge(f, 0))), b = at(surface.org(half_edge(f, 1))),
                 c = at(surface.org(half_edge(f, 2)));
    const double bright = std::fmax(0, 0.25 + 0.75 * dot(unit(cross(b - a, c - a)), light));
    t.colour = (tone ? tone(f) : 0) * shades + static_cast<unsigned>((shades - 1) * bright + 0.5);
    triangles.push_back(t);
  }
  std::sort(triangles.begin(), triangles.end());
  find_layers(triangles);
  std::sort(triangles.begin(), triangles.end());

  std::string svg;
  const auto end = triangles.end();
  for (auto layer = triangles.begin(); layer != end;) {
    const auto above = std::find_if(layer, end, [&](auto& t) { return t.layer != layer->layer; });
    std::string rim;
    Dot rim_pen;
    for (auto colour = layer; colour != above;) {
      std::string path;
      Dot pen;
      const auto begin = colour;
      for (; colour != above && colour->colour == begin->colour; ++colour) {
        if (colour->hidden) continue;
        const auto& [a, b, c] = colour->at;
        path += move(pen, a) + "l" + step(a, b) + (c.x < b.x ? "" : " ") + step(b, c) + "z";
        for (unsigned i = 0; i < 3; ++i) {
          if (!colour->rim[i]) continue;
          const Dot &from = colour->at[i], &to = colour->at[(i + 1) % 3];
          rim += move(rim_pen, from) + "l" + step(from, to);
          rim_pen = to;
        }
      }
      if (!path.empty()) svg += "<path fill=\"" + fill(begin->colour) + "\" d=\"" + path + "\"/>\n";
    }
    if (!rim.empty()) svg += "<path class=\"o\" d=\"" + rim + "\"/>\n";
    layer = above;
  }
  return svg;
}

}  // namespace clers::figures
