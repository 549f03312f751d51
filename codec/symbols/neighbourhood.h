// What the decoder knows of the surface around the gate besides valences: for every vertex on the
// boundary the next one and its inner neighbours in order, for every closed vertex its degree.
//
//        prev(x) <--- x ===gate===> y <--- next(y)
//           inner neighbours of x, from the gate's side on: ends of the interior edges at x
//
// It follows the front from outside: it gets each gate and symbol, and knows nothing of how the
// surface is kept.
#ifndef CLERS_CODEC_SYMBOLS_NEIGHBOURHOOD_H
#define CLERS_CODEC_SYMBOLS_NEIGHBOURHOOD_H

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace clers::internal {

class Neighbourhood {
 public:
  /// The inner neighbours of a vertex that are nearest to where it grew last, at most eight.
  class Fan {
   public:
    unsigned size() const { return size_; }
    /// i = 0 is next to the edge that leaves the vertex along the boundary.
    std::uint32_t operator[](unsigned i) const { return ids_[(first_ + i) % ids_.size()]; }
    void push_front(std::uint32_t v) {
      first_ = static_cast<std::uint8_t>((first_ - 1u) % ids_.size());
      ids_[first_] = v;
      if (size_ < ids_.size()) ++size_;
    }
    void push_back(std::uint32_t v) {
      ids_[(first_ + size_) % ids_.size()] = v;
      if (size_ < ids_.size())
        ++size_;
      else
        first_ = static_cast<std::uint8_t>((first_ + 1u) % ids_.size());
    }

   private:
    std::array<std::uint32_t, 8> ids_;
    std::uint8_t first_ = 0, size_ = 0;
  };

  explicit Neighbourhood(std::size_t ids) : at_(ids), degrees_(ids) {}
  static constexpr std::size_t bytes_each = 41;  ///< of memory, for every id

  std::uint32_t next(std::uint32_t v) const { return at_[v].next; }
  const Fan& fan(std::uint32_t v) const { return at_[v].fan; }
  /// At most 255; 0 while it is on the boundary, or if it was merged away.
  unsigned degree(std::uint32_t v) const { return degrees_[v]; }

  /// After create: the gate is x -> x+1.
  void create(std::uint32_t x) {
    at_[x] = {x + 1, {}};
    at_[x + 1] = {x + 2, {}};
    at_[x + 2] = {x, {}};
  }

  /// After attach, with zip for C: the gate was x -> y, and its origin is p now.
  void zip(std::uint32_t x, std::uint32_t y, std::uint32_t kx, std::uint32_t p) {
    degrees_[x] = static_cast<std::uint8_t>(std::min(kx + 1, 255u));
    at_[y].fan.push_back(x);
    at_[p].fan.push_front(x);
    at_[p].next = y;
  }

  /// After attach with a new vertex n, for L and R.
  void attach(std::uint32_t x, std::uint32_t y, std::uint32_t n) {
    at_[x].fan.push_front(y);
    at_[y].fan.push_back(x);
    at_[x].next = n;
    at_[n] = {y, {}};
  }

  /// After attach, with glue for S: x and q have become q, and before it is prev(q).
  void glue(std::uint32_t x, std::uint32_t y, std::uint32_t p, std::uint32_t q,
            std::uint32_t before) {
    Fan& fan = at_[q].fan;
    fan.push_back(p);
    fan.push_back(y);
    for (unsigned i = 0; i < at_[x].fan.size(); ++i) fan.push_back(at_[x].fan[i]);
    at_[y].fan.push_back(q);
    at_[p].fan.push_front(q);
    at_[before].next = q;
    at_[p].next = y;
  }

 private:
  struct Around {
    std::uint32_t next = 0;  ///< along the boundary
    Fan fan;
  };
  static_assert(sizeof(Around) + 1 == bytes_each);
  std::vector<Around> at_;
  std::vector<std::uint8_t> degrees_;
};

}  // namespace clers::internal

#endif
