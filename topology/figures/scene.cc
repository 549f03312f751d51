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

void Figure::text(double x, double y, const std::string& what, const char* anchor,
                  const char* kind) {
  body_ += std::string("<text") + kind + " x=\"" + number(x) + "\" y=\"" + number(y) +
           "\" text-anchor=\"" + anchor + "\">" + what + "</text>\n";
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

  const auto has = [&](const std::vector<HalfEdge>& list, HalfEdge h) {
    return std::find(list.begin(), list.end(), h) != list.end() ||
           (!s.is_boundary(h) && std::find(list.begin(), list.end(), s.sym(h)) != list.end());
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
      const bool marked = has(scene.marked, h);
      if (!marked && !rim) continue;
      body_ += std::string("<path class=\"") + (marked ? "m" : "b") + "\" d=\"M" +
               point(place(s.org(h))) + side(h) + "\"/>\n";
    }
  }
  const auto straight = [&](const char* kind, const Place& a, const Place& b) {
    body_ +=
        std::string("<path class=\"") + kind + "\" d=\"M" + point(a) + 'L' + point(b) + "\"/>\n";
  };
  for (const HalfEdge h : scene.dashed) {
    if (has(scene.marked, h)) continue;
    const Place a = place(s.org(h)), b = place(s.dest(h));
    const double dx = b.x - a.x, dy = b.y - a.y, end = 1.5 / std::sqrt(dx * dx + dy * dy);
    straight("u", {a.x + end * dx, a.y + end * dy}, {b.x - end * dx, b.y - end * dy});
    straight("d", a, b);
  }
  for (const HalfEdge h : scene.arrows) {
    // Along the side, within its face, with half a head.
    const Place a = place(s.org(h)), b = place(s.dest(h));
    const double dx = b.x - a.x, dy = b.y - a.y, length = std::sqrt(dx * dx + dy * dy);
    const auto at = [&](double along, double in) {
      return Place{a.x + (along * dx + in * dy) / length, a.y + (along * dy - in * dx) / length};
    };
    constexpr double in = 6, head = 9;
    straight("h", at(0.2 * length, in), at(0.8 * length, in));
    straight("h", at(0.8 * length - head, in + 6), at(0.8 * length, in));
  }
  const auto circle = [&](const Place& p, double radius, const char* kind) {
    char size[16];
    std::snprintf(size, sizeof size, "%g", radius);
    body_ += std::string("<circle") + kind + " cx=\"" + number(p.x) + "\" cy=\"" + number(p.y) +
             "\" r=\"" + size + "\"/>\n";
  };
  for (const Vertex v : scene.dots) circle(place(v), scene.dot_size, "");
  for (const Note& note : scene.notes) {
    const Place p = on_page(note.at);
    const bool badge = note.kind == Note::Kind::badge;
    if (badge) circle(p, 7, " class=\"n\"");
    text(p.x, p.y + (badge ? 3.5 : 4), note.text, "middle",
         badge                          ? " class=\"k\""
         : note.kind == Note::Kind::red ? " class=\"r\""
                                        : "");
  }
  end_panel(caption);
}

void Figure::panel(const std::string& shaded, const std::string& caption) {
  body_ += "<g class=\"s\" transform=\"translate(" + number(x_ + panel_width_ / 2) + ' ' +
           number(y_ + panel_height_ / 2) + ")scale(.1)\">\n" + shaded + "</g>\n";
  end_panel(caption);
}

void Figure::end_panel(const std::string& caption) {
  text(x_ + panel_width_ / 2, y_ + panel_height_ + 14, caption, "middle");
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
         ".u,.d{fill:none;stroke-linecap:butt}.u{stroke:#dae8f4;stroke-width:1.6}"
         ".d{stroke-dasharray:4 3}"
         ".h{fill:none;stroke:#d1352b;stroke-width:1.8}.n{fill:#fff;stroke:#d1352b}"
         ".s path{stroke-width:2.5}.s "
         ".o{fill:none;stroke:#1d2b36;stroke-width:9}.q{fill:none;stroke:#d1352b;stroke-width:16}"
         "text{font:12px sans-serif;fill:#222}.k{font-size:10px}.r{fill:#d1352b}</style>\n"
         "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n" +
         body_ + "</svg>\n";
}

}  // namespace clers::figures
