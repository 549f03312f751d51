#include "topology/figures/scene.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace clers::figures {
namespace {

constexpr double caption_height = 24, row_gap = 12, arrow_width = 92;

std::string number(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f", x);
  return std::string(text) == "-0.0" ? "0.0" : text;
}

std::string point(const Place& p) {
  return number(p.x) + ' ' + number(p.y);
}

}  // namespace

void Figure::text(double x, double y, const std::string& what, const char* anchor) {
  body_ += "<text x=\"" + number(x) + "\" y=\"" + number(y) + "\" text-anchor=\"" + anchor + "\">" +
           what + "</text>\n";
}

void Figure::line(double x0, double y0, double x1, double y1) {
  body_ += "<path class=\"a\" d=\"M" + number(x0) + ' ' + number(y0) + 'L' + number(x1) + ' ' +
           number(y1) + "\"/>\n";
}

void Figure::panel(const Scene& scene, const std::string& caption) {
  const Surface& s = scene.surface;
  const double left = x_, middle_x = left + panel_width_ / 2, middle_y = y_ + panel_height_ / 2;
  const auto on_page = [&](const Place& p) {
    return Place{middle_x + unit_ * p.x, middle_y - unit_ * p.y, p.z};
  };
  const auto place = [&](Vertex v) { return on_page(scene.at[v.index()]); };
  for (const auto& [a, b, c] : scene.gone)
    body_ += "<path fill=\"none\" style=\"stroke:#b8c0c6;stroke-dasharray:3 3\" d=\"M" +
             point(on_page(a)) + 'L' + point(on_page(b)) + 'L' + point(on_page(c)) + "z\"/>\n";
  // A side from its origin on, as a straight or a bent line.
  const auto side = [&](HalfEdge h) {
    const Place a = place(s.org(h)), b = place(s.dest(h));
    const auto bend = scene.bends.find(h);
    if (bend == scene.bends.end()) return 'L' + point(b);
    const Place middle{(a.x + b.x) / 2 - 2 * bend->second * (b.y - a.y),
                       (a.y + b.y) / 2 + 2 * bend->second * (b.x - a.x), 0};
    return 'Q' + point(middle) + ' ' + point(b);
  };

  // Faces and their sides from the back to the front.
  struct Drawn {
    double depth = 0;
    Face f;
  };
  std::vector<Drawn> order;
  for (const Face f : s.faces()) {
    Drawn d{0, f};
    for (const HalfEdge h : s.star(f)) d.depth += place(s.org(h)).z;
    order.push_back(d);
  }
  std::stable_sort(order.begin(), order.end(),
                   [](const Drawn& a, const Drawn& b) { return a.depth < b.depth; });
  for (const auto& [depth, f] : order) {
    const Place a = scene.at[s.org(half_edge(f, 0)).index()],
                b = scene.at[s.org(half_edge(f, 1)).index()],
                c = scene.at[s.org(half_edge(f, 2)).index()];
    const double ux = b.x - a.x, uy = b.y - a.y, uz = b.z - a.z, vx = c.x - a.x, vy = c.y - a.y,
                 vz = c.z - a.z;
    const double nx = uy * vz - uz * vy, ny = uz * vx - ux * vz, nz = ux * vy - uy * vx;
    const double length = std::sqrt(nx * nx + ny * ny + nz * nz);
    const double light = length == 0 ? 1 : (0.3 * nx + 0.4 * ny + 0.87 * nz) / length;
    // The back of a face is darker.
    const int grey = nz < 0 ? 150 : static_cast<int>(std::lround(190 + 48 * std::max(0.0, light)));
    char fill[32];
    std::snprintf(fill, sizeof fill, "#%02x%02x%02x", static_cast<unsigned>(grey - 14),
                  static_cast<unsigned>(grey), static_cast<unsigned>(grey + 12));
    std::string path = "M" + point(place(s.org(half_edge(f, 0))));
    for (const HalfEdge h : s.star(f)) path += side(h);
    body_ += "<path fill=\"" + std::string(fill) + "\" d=\"" + path + "z\"/>\n";
    for (const HalfEdge h : s.star(f)) {
      const bool rim = s.is_boundary(h);
      const bool marked =
          std::find(scene.marked.begin(), scene.marked.end(), h) != scene.marked.end() ||
          (!rim &&
           std::find(scene.marked.begin(), scene.marked.end(), s.sym(h)) != scene.marked.end());
      if (!marked && !rim) continue;
      body_ += std::string("<path class=\"") + (marked ? "m" : "b") + "\" d=\"M" +
               point(place(s.org(h))) + side(h) + "\"/>\n";
    }
  }
  for (const Vertex v : scene.dots)
    body_ +=
        "<circle cx=\"" + number(place(v).x) + "\" cy=\"" + number(place(v).y) + "\" r=\"4\"/>\n";
  text(middle_x, y_ + panel_height_ + 14, caption, "middle");
  x_ += panel_width_;
  right_ = std::max(right_, x_);
}

void Figure::arrow(const std::string& there, const std::string& back) {
  const double y = y_ + panel_height_ / 2, from = x_ + 10, to = x_ + arrow_width - 10;
  const auto draw = [&](double at, double tail, double head) {
    const double turn = head > tail ? -6 : 6;
    line(tail, at, head, at);
    line(head, at, head + turn, at - 4);
    line(head, at, head + turn, at + 4);
  };
  draw(back.empty() ? y : y - 5, from, to);
  text((from + to) / 2, y - 12, there, "middle");
  if (!back.empty()) {
    draw(y + 5, to, from);
    text((from + to) / 2, y + 22, back, "middle");
  }
  x_ += arrow_width;
}

void Figure::row() {
  x_ = 10;
  y_ += panel_height_ + caption_height + row_gap;
}

std::string Figure::svg() const {
  const std::string width = number(right_ + 10),
                    height = number(y_ + panel_height_ + caption_height + 4);
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + width + "\" height=\"" + height +
         "\" viewBox=\"0 0 " + width + ' ' + height +
         "\">\n"
         "<style>path{stroke:#51606b;stroke-linejoin:round;stroke-linecap:round}.b{fill:none;"
         "stroke:#1d2b36;stroke-width:2.2}.m{fill:none;stroke:#d1352b;stroke-width:3}"
         ".a{fill:none;stroke:#333;stroke-width:1.4}circle{fill:#d1352b}"
         "text{font:12px sans-serif;fill:#222}</style>\n"
         "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n" +
         body_ + "</svg>\n";
}

}  // namespace clers::figures
