// Random legal streams: holes, handles, curves of two edges and components where no encoder makes
// them; and the surfaces that they must give, built in the most obvious way.
#ifndef CLERS_CODEC_TEST_LEGAL_STREAMS_H
#define CLERS_CODEC_TEST_LEGAL_STREAMS_H

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <utility>
#include <vector>

#include "codec/test/stream_writer.h"
#include "topology/ids.h"

namespace clers::internal {

/// A stream and what a decoder must make of it.
struct LegalStream {
  Bytes bytes;
  std::vector<std::uint32_t> corners;
  std::vector<HalfEdge> twins;
  std::uint32_t vertices = 0, components = 0, holes = 0, handles = 0;
};

/// A surface built from its symbols as codec/format.md says, with every boundary curve written out.
/// Cost: of an S the faces and vertices there are.
class WrittenOutSurface {
 public:
  struct Place {
    std::uint32_t vertex, into;  ///< the half-edge into it, from the place in front of it
  };
  /// From y to x; the half-edge into y is the gate.
  using Curve = std::deque<Place>;

  WrittenOutSurface() { create(); }

  const Curve& curve() const { return curve_; }
  const Curve& pending() const { return pending_.back(); }
  std::size_t faces() const { return corners_.size() / 3; }

  /// Whether x may be glued to a vertex: no face has both, and none has y.
  bool may_glue(std::uint32_t p, std::uint32_t q) const {
    const std::uint32_t x = curve_.back().vertex, y = curve_.front().vertex;
    if (p == y || p == x || q == x || q == y) return false;
    for (std::size_t f = 0; f < corners_.size(); f += 3) {
      bool has_x = false, has_q = false;
      for (std::size_t i = f; i < f + 3; ++i) {
        has_x |= now(corners_[i]) == x;
        has_q |= now(corners_[i]) == q;
      }
      if (has_x && has_q) return false;
    }
    return true;
  }

  void c() {
    const Place x = take_x();
    face(curve_.back().vertex, curve_.front().vertex, x.vertex);
    glue(side(1), curve_.front().into);
    glue(side(2), x.into);
    curve_.front().into = side(0);
    finished_.push_back(x.vertex);
  }
  void r() {
    const std::uint32_t n = vertex();
    face(curve_.back().vertex, n, curve_.front().vertex);
    glue(side(2), curve_.front().into);
    curve_.front().into = side(1);
    curve_.push_front({n, side(0)});
  }
  void l() {
    const std::uint32_t n = vertex();
    face(n, curve_.front().vertex, curve_.back().vertex);
    glue(side(1), curve_.front().into);
    curve_.front().into = side(0);
    curve_.push_back({n, side(2)});
  }
  void e() {
    pending_.push_back(std::move(curve_));
    create();
  }
  void e_new_component(bool closed) {
    end(closed);
    create();
  }
  void s() {
    Curve other = std::move(pending_.back());
    pending_.pop_back();
    glue_to(std::move(other));
  }
  /// Of a hole or a split: the curve of d edges that is split off.
  void split(std::uint32_t d, bool hole) {
    const auto q = curve_.end() - 1 - static_cast<std::ptrdiff_t>(d);
    Curve ring(q, curve_.end());  // q .. x
    curve_.erase(q, curve_.end());
    const Place x = ring.back();
    ring.pop_back();
    face(curve_.back().vertex, curve_.front().vertex, x.vertex);
    glue(side(1), curve_.front().into);
    glue(side(2), ring.front().into);
    curve_.front().into = side(0);
    ring.front().into = x.into;
    merge(x.vertex, ring.front().vertex);
    (hole ? holes_ : waiting_).push_back(std::move(ring));
  }
  void join(std::uint32_t recency, std::uint32_t position) {
    Curve ring = turned(recency, position);
    waiting_.erase(waiting_.end() - 1 - static_cast<std::ptrdiff_t>(recency));
    glue_to(std::move(ring));
    ++handles_;
  }
  /// A waiting curve with the vertex at a position in front, and the one before it at the back.
  Curve turned(std::uint32_t recency, std::uint32_t position) const {
    Curve ring = waiting_[waiting_.size() - 1 - recency];
    const auto steps = (ring.size() - position) % ring.size();
    std::rotate(ring.begin(), ring.begin() + static_cast<std::ptrdiff_t>(steps), ring.end());
    return ring;
  }

  LegalStream finish(bool closed) {
    end(closed);
    LegalStream out;
    out.vertices = static_cast<std::uint32_t>(finished_.size());
    out.components = components_;
    out.holes = hole_count_;
    out.handles = handles_;
    std::vector<std::uint32_t> number(into_.size());
    for (std::uint32_t k = 0; k < out.vertices; ++k) number[finished_[k]] = out.vertices - 1 - k;
    const std::uint32_t last = static_cast<std::uint32_t>(faces()) - 1;
    for (std::uint32_t f = 0; f <= last; ++f)
      for (std::uint32_t i = 0; i < 3; ++i) {
        const std::uint32_t h = 3 * (last - f) + i, t = twins_[h];
        out.corners.push_back(number[now(corners_[h])]);
        out.twins.push_back(t == none ? HalfEdge() : half_edge(Face(last - t / 3), t % 3));
      }
    return out;
  }

 private:
  static constexpr std::uint32_t none = 0xffffffffu;

  std::uint32_t vertex() {
    into_.push_back(static_cast<std::uint32_t>(into_.size()));
    return into_.back();
  }
  std::uint32_t now(std::uint32_t v) const {
    while (into_[v] != v) v = into_[v];
    return v;
  }
  void merge(std::uint32_t x, std::uint32_t q) { into_[x] = q; }
  void face(std::uint32_t a, std::uint32_t b, std::uint32_t v) {
    corners_.insert(corners_.end(), {a, b, v});
    twins_.insert(twins_.end(), 3, none);
  }
  std::uint32_t side(std::uint32_t i) const {
    return static_cast<std::uint32_t>(corners_.size()) - 3 + i;
  }
  void glue(std::uint32_t a, std::uint32_t b) { twins_[a] = b, twins_[b] = a; }
  Place take_x() {
    const Place x = curve_.back();
    curve_.pop_back();
    return x;
  }
  void create() {
    const std::uint32_t a = vertex(), b = vertex(), v = vertex();
    face(a, b, v);
    curve_ = {{b, side(0)}, {v, side(1)}, {a, side(2)}};
  }
  /// Glues x -> y .. to the edge from the back to the front of another curve.
  void glue_to(Curve other) {
    const Place x = take_x();
    face(other.back().vertex, curve_.front().vertex, x.vertex);
    glue(side(1), curve_.front().into);
    glue(side(2), other.front().into);
    curve_.front().into = side(0);
    other.front().into = x.into;
    merge(x.vertex, other.front().vertex);
    curve_.insert(curve_.end(), other.begin(), other.end());
  }
  void end(bool closed) {
    ++components_;
    hole_count_ += static_cast<std::uint32_t>(holes_.size());
    if (closed) glue(curve_.front().into, curve_.back().into);
    for (const Curve& hole : holes_) {  // h, prev(h) .. : the front, then from the back
      finished_.push_back(hole.front().vertex);
      for (std::size_t i = hole.size(); i-- > 1;) finished_.push_back(hole[i].vertex);
    }
    holes_.clear();
    for (std::size_t i = curve_.size(); i-- > 0;) finished_.push_back(curve_[i].vertex);
  }

  std::vector<std::uint32_t> corners_, twins_, into_, finished_;
  Curve curve_;
  std::vector<Curve> pending_, waiting_, holes_;
  std::uint32_t components_ = 0, hole_count_ = 0, handles_ = 0;
};

/// A legal stream of about `faces` faces. `choose(n)` gives 0 .. n - 1. A handle may join a curve
/// of a part that an S joins later, which no encoder makes.
template <class Choose>
LegalStream legal_stream(std::uint32_t faces, Choose choose) {
  WrittenOutSurface surface;
  StreamWriter writer(4 * std::size_t(faces) + 64);
  const auto closable = [&] { return surface.curve().size() == 2 && choose(2) == 1; };
  const auto length = [&] { return static_cast<std::uint32_t>(surface.curve().size()); };
  const auto at = [&](std::uint32_t back) { return surface.curve()[length() - 1 - back].vertex; };

  const auto split = [&](bool hole) {
    if (length() < 5) return false;
    const std::uint32_t d = 2 + choose(length() - 4);
    if (!surface.may_glue(at(d + 1), at(d))) return false;
    hole ? writer.hole(d) : writer.split(d);
    surface.split(d, hole);
    return true;
  };
  const auto join = [&] {
    if (writer.waiting() == 0) return false;
    const std::uint32_t recency = choose(static_cast<std::uint32_t>(writer.waiting()));
    const std::uint32_t position = choose(writer.waiting_length(recency));
    const WrittenOutSurface::Curve ring = surface.turned(recency, position);
    if (!surface.may_glue(ring.back().vertex, ring.front().vertex)) return false;
    writer.join(recency, position);
    surface.join(recency, position);
    return true;
  };
  const auto l = [&] { writer.l(), surface.l(); };
  const auto r = [&] { writer.r(), surface.r(); };
  const auto s = [&] {
    if (writer.pending() == 0) return false;
    // A handle may already join the two.
    const WrittenOutSurface::Curve& other = surface.pending();
    if (!surface.may_glue(other.back().vertex, other.front().vertex)) return false;
    writer.s(), surface.s();
    return true;
  };

  while (writer.faces() < faces) {
    const std::uint32_t before = writer.faces();
    switch (choose(16)) {
      case 0:
      case 1:
      case 2:
      case 3:
        if (length() > 2) writer.c(), surface.c();
        break;
      case 4:
      case 5:
      case 6: r(); break;
      case 7:
      case 8: l(); break;
      case 9:
        if (writer.pending() == 0 && writer.waiting() == 0 && choose(2) == 1) {
          const bool closed = closable();
          writer.e(true, closed), surface.e_new_component(closed);
        } else {
          writer.e(), surface.e();
        }
        break;
      case 10:
      case 11: s(); break;
      case 12: split(true); break;
      case 13: split(false); break;
      default: join(); break;
    }
    if (writer.faces() == before) r();  // that could not be
  }
  // A vertex of its own can be glued to all but its neighbours.
  while (writer.waiting() > 0 || writer.pending() > 0)
    if (!(writer.pending() > 0 ? s() : join())) l();
  const bool closed = closable();
  LegalStream out = surface.finish(closed);
  out.bytes = writer.finish(closed);
  return out;
}

}  // namespace clers::internal

#endif
