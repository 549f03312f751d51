// Surfaces as drawings: what a figure of the documentation is made of.
#ifndef CLERS_TOPOLOGY_FIGURES_SCENE_H
#define CLERS_TOPOLOGY_FIGURES_SCENE_H

#include <array>
#include <map>
#include <string>
#include <vector>

#include "topology/surface.h"

namespace clers::figures {

struct Place {
  double x = 0, y = 0, z = 0;  ///< y up, z towards the reader
};

/// Words at a place.
struct Note {
  enum class Kind { plain, red, badge };  ///< a badge is a number on a disk

  Place at;
  std::string text;
  Kind kind = Kind::plain;
};

/// A surface and how to draw it.
struct Scene {
  Surface surface;
  std::vector<Place> at;  ///< by vertex
  std::vector<HalfEdge> marked;
  std::vector<Vertex> dots;
  std::map<HalfEdge, double> bends;        ///< how far a side bulges to its right, in its lengths
  std::vector<std::array<Place, 3>> gone;  ///< triangles that were there
  std::vector<HalfEdge> dashed{};
  std::vector<HalfEdge> arrows{};  ///< half-edges, drawn as such
  std::vector<Note> notes{};
  double dot_size = 4;

  Place& place(Vertex v) {
    if (v.index() >= at.size()) at.resize(v.index() + std::size_t{1});
    return at[v.index()];
  }
  void dot(Vertex v) { dots.push_back(v); }
  void unmark() {
    marked.clear();
    dots.clear();
    notes.clear();
  }
};

/// Panels and arrows from left to right in rows, as one SVG. The same on every machine.
class Figure {
 public:
  /// `unit`: pixels for a length of one; panels are `width` by `height` pixels.
  Figure(double unit, double width, double height)
      : unit_(unit), panel_width_(width), panel_height_(height) {}

  void panel(const Scene& scene, const std::string& caption);
  /// What shaded.h draws, about the middle of a panel.
  void panel(const std::string& shaded, const std::string& caption);
  /// An arrow there, and one back if `back` is not empty.
  void arrow(const std::string& there, const std::string& back = "");
  void row();
  /// Of panels from here on.
  void resize(double width, double height) { panel_width_ = width, panel_height_ = height; }
  std::string svg() const;

 private:
  void text(double x, double y, const std::string& what, const char* anchor, const char* kind = "");
  void line(double x0, double y0, double x1, double y1);
  void end_panel(const std::string& caption);

  double unit_, panel_width_, panel_height_;
  double x_ = 10, y_ = 10, right_ = 0;
  std::string body_;
};

}  // namespace clers::figures

#endif
