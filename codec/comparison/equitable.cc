// Cells as ranges of two orders, split by how often their elements are touched.
#include "codec/comparison/equitable.h"

#include <algorithm>
#include <array>
#include <span>
#include <string>

#include "codec/base/no_index.h"

namespace clers::internal {
namespace {

using Index = std::uint32_t;

/// The elements of one kind, of both meshes, in cells. A cell is the same range of both orders, so
/// that it has as many elements of either mesh.
class Cells {
 public:
  /// Cells by colour, all waiting. Precondition: check fits().
  Cells(const std::vector<Colour>& a, const std::vector<Colour>& b) {
    const Classes classes_a = classes(a), classes_b = classes(b);
    for (std::size_t i = 0; i < a.size() && fits_; ++i)
      if (classes_a[i].first != classes_b[i].first) {
        fits_ = false;
        odd_ = {classes_a[i].second, no_index};
      }
    fill(sides_[0], classes_a);
    fill(sides_[1], classes_b);
    for (Index i = 0, j; i < a.size(); i = j) {
      for (j = i; j < a.size() && classes_a[j].first == classes_a[i].first; ++j)
        for (OneSide& side : sides_) side.at[side.order[j]].cell = count();
      add(i, j);
      wait(count() - 1);
    }
  }

  /// Both have as many elements of each colour.
  bool fits() const { return fits_; }
  /// Where they do not: an element of either mesh, or none.
  std::array<Index, 2> odd() const { return odd_; }

  Index count() const { return static_cast<Index>(begin_.size()); }
  Index size(Index x) const { return end_[x] - begin_[x]; }
  std::span<const Index> elements(std::size_t side, Index x) const {
    return std::span(sides_[side].order).subspan(begin_[x], size(x));
  }

  /// A cell that has changed since it was last taken, or none.
  Index take() {
    if (waiting_.empty()) return no_index;
    const Index x = waiting_.back();
    waiting_.pop_back();
    is_waiting_[x] = false;
    return x;
  }

  /// Counts an element, which the next split() goes by.
  void touch(std::size_t s, Index e) {
    OneSide& side = sides_[s];
    Element& element = side.at[e];
    if (element.touches++ > 0) return;
    const Index x = element.cell;
    if (marked_[0][x] + marked_[1][x] == 0) touched_.push_back(x);
    const Index to = end_[x] - ++marked_[s][x], from = element.place;
    if (from == to) return;
    const Index other = side.order[to];
    side.order[from] = other, side.at[other].place = from;
    side.order[to] = e, element.place = to;
  }

  /// Parts the cells by how often their elements were touched. False if the meshes differ in that.
  /// Cost: the touched elements, sorted where they were touched unequally often.
  bool split() {
    for (const Index x : touched_) {
      const Index m = marked_[0][x];
      if (m != marked_[1][x]) {
        fits_ = false;
        const std::size_t more = m > marked_[1][x] ? 0 : 1;
        odd_ = {no_index, no_index};
        odd_[more] = sides_[more].order[end_[x] - marked_[more][x]];
      }
      marked_[0][x] = marked_[1][x] = 0;
      if (!fits_ || !split(x, end_[x] - m)) return false;
    }
    touched_.clear();
    return true;
  }

  /// A cell of several elements of each mesh, one that was made lately, or none.
  Index ambiguous() {
    while (!recent_.empty() && size(recent_.back()) == 1) recent_.pop_back();
    return recent_.empty() ? no_index : recent_.back();
  }
  /// Says that any element of the ambiguous() cell may become any other.
  void leave_ambiguous() { recent_.pop_back(); }

 private:
  struct Element {
    Index place = 0;  // in the order
    Index cell = 0;
    Index touches = 0;  // since the last split
  };
  struct OneSide {
    std::vector<Index> order;  // the elements, cell by cell
    std::vector<Element> at;   // of each element
  };

  static void fill(OneSide& side, const Classes& sorted) {
    side.order.resize(sorted.size());
    side.at.resize(sorted.size());
    for (Index i = 0; i < sorted.size(); ++i) {
      side.order[i] = sorted[i].second;
      side.at[sorted[i].second].place = i;
    }
  }

  void add(Index begin, Index end) {
    recent_.push_back(count());
    begin_.push_back(begin);
    end_.push_back(end);
    marked_[0].push_back(0);
    marked_[1].push_back(0);
    is_waiting_.push_back(false);
  }

  void wait(Index x) {
    if (is_waiting_[x]) return;
    is_waiting_[x] = true;
    waiting_.push_back(x);
  }

  /// The touched elements of cell x begin at `low` in both orders.
  bool split(Index x, Index low) {
    const Index begin = begin_[x], end = end_[x];
    const auto touches = [&](std::size_t s, Index i) {
      return sides_[s].at[sides_[s].order[i]].touches;
    };
    for (std::size_t s = 0; s < 2; ++s) {
      OneSide& side = sides_[s];
      bool equal = true;
      for (Index i = low + 1; i < end && equal; ++i) equal = touches(s, i) == touches(s, low);
      if (equal) continue;
      std::sort(side.order.begin() + low, side.order.begin() + end,
                [&](Index e, Index f) { return side.at[e].touches < side.at[f].touches; });
      for (Index i = low; i < end; ++i) side.at[side.order[i]].place = i;
    }
    parts_.clear();
    if (low > begin) parts_.push_back(begin);
    for (Index i = low; i < end; ++i) {
      if (touches(0, i) != touches(1, i)) {
        fits_ = false;
        odd_ = {sides_[0].order[i], no_index};
        return false;
      }
      if (i == low || touches(0, i) != touches(0, i - 1)) parts_.push_back(i);
    }
    for (Index i = low; i < end; ++i)
      for (OneSide& side : sides_) side.at[side.order[i]].touches = 0;
    if (parts_.size() == 1) return true;
    parts_.push_back(end);

    // The first part keeps the cell's number. All wait but the largest, which what waited before or
    // was taken stands for; it waits as well where the cell still does.
    std::size_t largest = 0;
    for (std::size_t p = 1; p + 1 < parts_.size(); ++p)
      if (parts_[p + 1] - parts_[p] > parts_[largest + 1] - parts_[largest]) largest = p;
    end_[x] = parts_[1];
    const bool whole_waits = is_waiting_[x];
    if (largest != 0) wait(x);
    for (std::size_t p = 1; p + 1 < parts_.size(); ++p) {
      const Index y = count();
      add(parts_[p], parts_[p + 1]);
      for (Index i = parts_[p]; i < parts_[p + 1]; ++i)
        for (OneSide& side : sides_) side.at[side.order[i]].cell = y;
      if (p != largest || whole_waits) wait(y);
    }
    return true;
  }

  std::array<OneSide, 2> sides_;
  std::vector<Index> begin_, end_;                 // of each cell
  std::array<std::vector<Index>, 2> marked_;       // of each cell: elements touched
  std::vector<bool> is_waiting_;                   // of each cell
  std::vector<Index> waiting_, touched_, recent_;  // cells
  std::vector<Index> parts_;                       // of split
  bool fits_ = true;
  std::array<Index, 2> odd_ = {no_index, no_index};
};

/// The colours of vertices, which differ where their components do.
std::vector<Colour> vertex_colours(const Side& side) {
  std::vector<Colour> colours = side.mesh.colour;
  std::vector<bool> seen(colours.size());
  for (Index k = 0; k < side.components.count(); ++k)
    for (const auto& face : side.components.faces(k))
      for (const Index v : side.mesh.faces.cycle(face.second)) {
        if (seen[v]) continue;
        seen[v] = true;
        colours[v] = combine(colours[v], side.components.colour[k]);
      }
  return colours;
}

/// What is known of a corner besides its vertex and neighbours: values, and how many faces run
/// along the edge that begins there, either way. Cells alone would not see a face that is reversed
/// where every face is there both ways.
std::vector<Colour> corner_colours(const Side& side) {
  const ComparedMesh& mesh = side.mesh;
  std::vector<Colour> colours(mesh.corners());
  for (Index f = 0; f < mesh.faces.count(); ++f) {
    const Colour face = combine(mesh.value_of_face(f), mesh.faces.size(f));
    for (Index c = mesh.faces.begin(f); c < mesh.faces.end(f); ++c)
      colours[c] = combine(face, mesh.value_of_corner(c));
  }
  for (Index u = 0; u < mesh.vertices(); ++u) {
    const auto star = side.stars.at(u);
    for (std::size_t i = 0, n; i < star.size(); i += n) {
      const Index v = mesh.faces.org[mesh.faces.next(star[i])];
      n = side.stars.along(u, v).size();
      const Colour faces = combine(n, side.stars.along(v, u).size());
      for (std::size_t k = i; k < i + n; ++k) colours[star[k]] = combine(colours[star[k]], faces);
    }
  }
  return colours;
}

class Refinement {
 public:
  Refinement(const Side& a, const Side& b)
      : sides_{&a, &b},
        vertices_(vertex_colours(a), vertex_colours(b)),
        corners_(corner_colours(a), corner_colours(b)) {}

  Comparison run(std::vector<Index>& image) {
    if (!vertices_.fits() || !corners_.fits() || !refine()) return {Verdict::different, odd()};
    for (Index x = vertices_.ambiguous(); x != no_index; x = vertices_.ambiguous()) {
      if (sides_[0]->stars.at(vertices_.elements(0, x)[0]).empty()) {  // no face uses them
        vertices_.leave_ambiguous();
        continue;
      }
      for (std::size_t s = 0; s < 2; ++s) vertices_.touch(s, vertices_.elements(s, x).back());
      if (!vertices_.split() || !refine())
        return {Verdict::undecided, "vertices that look alike are not, or not all"};
    }
    image.resize(sides_[0]->mesh.vertices());
    for (Index x = 0; x < vertices_.count(); ++x)
      for (Index i = 0; i < vertices_.size(x); ++i)
        image[vertices_.elements(0, x)[i]] = vertices_.elements(1, x)[i];
    return {Verdict::same, {}};
  }

 private:
  /// Splits until no cell divides another: a cell of vertices by who is at the
  /// corners, a cell of corners by what comes next in faces and by how often a vertex has them.
  bool refine() {
    for (;;) {
      if (const Index x = vertices_.take(); x != no_index) {
        for (std::size_t s = 0; s < 2; ++s)
          for (const Index v : vertices_.elements(s, x))
            for (const Index c : sides_[s]->stars.at(v)) corners_.touch(s, c);
        if (!corners_.split()) return false;
      } else if (const Index y = corners_.take(); y != no_index) {
        for (std::size_t s = 0; s < 2; ++s) {
          const auto elements = corners_.elements(s, y);
          splitter_[s].assign(elements.begin(), elements.end());  // touching changes the order
          // Once cells are whole against what comes next, so they are against what came before:
          // next is a permutation.
          for (const Index c : splitter_[s]) corners_.touch(s, sides_[s]->mesh.faces.prev(c));
        }
        if (!corners_.split()) return false;
        for (std::size_t s = 0; s < 2; ++s)
          for (const Index c : splitter_[s]) vertices_.touch(s, sides_[s]->mesh.faces.org[c]);
        if (!vertices_.split()) return false;
      } else {
        return true;
      }
    }
  }

  /// The element that has no counterpart.
  std::string odd() const {
    const bool vertex = !vertices_.fits();
    const std::array<Index, 2> at = vertex ? vertices_.odd() : corners_.odd();
    const std::size_t s = at[0] != no_index ? 0 : 1;
    const Index element = vertex ? at[s] : sides_[s]->mesh.faces.face(at[s]);
    return std::string(vertex ? "vertex " : "face ") + std::to_string(element) + " of the " +
           (s == 0 ? "first" : "second") +
           " mesh has no counterpart with the same values and surroundings";
  }

  std::array<const Side*, 2> sides_;
  Cells vertices_, corners_;
  std::array<std::vector<Index>, 2> splitter_;
};

}  // namespace

Comparison pair_by_cells(const Side& a, const Side& b, std::vector<Index>& image) {
  return Refinement(a, b).run(image);
}

}  // namespace clers::internal
