// Halves of halves on a sample of the positions; without positions, breadth first.
#include "codec/pieces/cells.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <span>

#include "codec/base/no_index.h"
#include "codec/base/parallel.h"
#include "codec/numbers/transform.h"
#include "topology/buckets.h"

namespace clers::internal {
namespace {

/// Numbers that sort like a component of the positions, each to `out`, `step` apart.
template <class U>
void put_ordered(const AttributeView& position, unsigned component, std::uint32_t count,
                 std::uint32_t* out, unsigned step) {
  const bool is_signed = position.scalar == Scalar::int8 || position.scalar == Scalar::int16 ||
                         position.scalar == Scalar::int32 || position.scalar == Scalar::int64;
  const std::size_t from_step = position.step();
  std::vector<U> wide(sizeof(U) > 4 ? count : 0);
  for (std::uint32_t v = 0; v < count; ++v) {
    U key;
    std::memcpy(&key, position.data.data() + v * from_step + component * sizeof(U), sizeof(U));
    if (is_float(position.scalar))
      key = to_ordered(key);
    else if (is_signed)
      key = static_cast<U>(key ^ U(1) << (8 * sizeof(U) - 1));
    if constexpr (sizeof(U) > 4)
      wide[v] = key;
    else
      out[std::size_t(v) * step] = key;
  }
  if constexpr (sizeof(U) > 4) {
    std::vector<U> all = wide;
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    for (std::uint32_t v = 0; v < count; ++v)
      out[std::size_t(v) * step] = static_cast<std::uint32_t>(
          std::lower_bound(all.begin(), all.end(), wide[v]) - all.begin());
  }
}

/// A tree of halvings. It is grown on a sample of the vertices, chosen by their places.
class Tree {
 public:
  Tree(const SpatialKeys& places, std::uint32_t vertex_count, std::uint32_t pieces,
       std::uint32_t each)
      : places_(places), each_(each) {
    const std::uint32_t leaves = static_cast<std::uint32_t>(
        std::min(std::uint64_t(pieces), 0xffffffffu / std::uint64_t(each)) * each);
    // 32 vertices a leaf, and some 2^14 in all, show well enough where the middle is.
    const std::uint64_t enough = std::max<std::uint64_t>(1u << 14, 32 * std::uint64_t(leaves));
    unsigned shift = 0;  // one vertex in 2^shift is chosen
    while (vertex_count >> shift > enough) ++shift;
    std::vector<std::uint32_t> sample;
    for (std::uint32_t v = 0; v < vertex_count; ++v)
      if (shift == 0 || places.hash(v) >> (32 - shift) == 0) sample.push_back(v);
    grow(sample, leaves, 0);
  }

  /// The leaves, counted from the left, where vertices v, v + 1 .. are. Several go down at a time,
  /// and all as far, so that no step waits for another or need be guessed: a leaf follows itself.
  template <std::uint32_t several>
  void find(std::uint32_t v, std::uint32_t* leaf) const {
    std::uint32_t at[several] = {};
    const std::uint32_t* places = places_.of(v);
    const unsigned axes = places_.axes();
    for (unsigned step = 0; step < depth_; ++step)
      for (std::uint32_t k = 0; k < several; ++k) {
        const Node& node = nodes_[at[k]];
        at[k] = node.next[places[k * axes + node.axis] > node.most];
      }
    for (std::uint32_t k = 0; k < several; ++k) leaf[k] = nodes_[at[k]].leaf;
  }

 private:
  struct Node {
    std::uint32_t axis = 0;
    std::uint32_t most = 0;      ///< what is at most here goes left
    std::uint32_t next[2] = {};  ///< left, right
    std::uint32_t leaf = 0;      ///< of a leaf: its number
  };

  /// Reorders the sample.
  void grow(std::span<std::uint32_t> sample, std::uint32_t leaves, unsigned depth) {
    const std::uint32_t node = static_cast<std::uint32_t>(nodes_.size());
    nodes_.push_back({0, 0, {node, node}, leaves_});
    const std::uint32_t half = leaves > each_ ? leaves / each_ / 2 * each_ : leaves / 2;
    if (half == 0 || !cut(sample, half, leaves, nodes_[node])) {
      leaves_ += leaves;
      depth_ = std::max(depth_, depth);
      return;
    }
    const auto right = std::partition(
        sample.begin(), sample.end(),
        [&, here = nodes_[node]](auto v) { return places_.at(here.axis, v) <= here.most; });
    const auto left_size = static_cast<std::size_t>(right - sample.begin());
    nodes_[node].next[0] = static_cast<std::uint32_t>(nodes_.size());
    grow(sample.first(left_size), half, depth + 1);
    nodes_[node].next[1] = static_cast<std::uint32_t>(nodes_.size());
    grow(sample.subspan(left_size), leaves - half, depth + 1);
  }

  /// Cuts across the longest axis, so that the right shares are on both sides. Is there anything to
  /// cut?
  bool cut(std::span<std::uint32_t> sample, std::uint32_t half, std::uint32_t leaves,
           Node& node) const {
    std::uint64_t longest = 0;
    std::uint32_t end = 0;
    for (std::uint32_t axis = 0; axis < places_.axes(); ++axis) {
      std::uint32_t low = no_index, high = 0;
      for (const std::uint32_t v : sample) {
        low = std::min(low, places_.at(axis, v));
        high = std::max(high, places_.at(axis, v));
      }
      if (low >= high) continue;
      const std::uint64_t length = places_.distance(low, high);
      if (end > 0 && length <= longest) continue;
      longest = length;
      node.axis = axis;
      end = high;
    }
    if (end == 0) return false;
    const auto less = [&](std::uint32_t v, std::uint32_t w) {
      return places_.at(node.axis, v) < places_.at(node.axis, w);
    };
    const auto middle = sample.begin() + static_cast<std::ptrdiff_t>(
                                             std::uint64_t(sample.size() - 1) * half / leaves);
    std::nth_element(sample.begin(), middle, sample.end(), less);
    node.most = places_.at(node.axis, *middle);
    // What is at one place cannot be parted: then less goes to the left.
    if (node.most == end) {
      node.most = 0;
      for (const std::uint32_t v : sample)
        if (const std::uint32_t at = places_.at(node.axis, v); at < end)
          node.most = std::max(node.most, at);
    }
    return true;
  }

  const SpatialKeys& places_;
  std::uint32_t each_;  ///< leaves of a piece
  std::uint32_t leaves_ = 0;
  unsigned depth_ = 0;
  std::vector<Node> nodes_;
};

/// Cells of `size` vertices, each grown from where those before it stopped.
std::vector<std::uint32_t> grown(const Faces& faces, std::uint32_t vertex_count,
                                 std::uint32_t size) {
  const Buckets corners(static_cast<std::uint32_t>(faces.org.size()), vertex_count,
                        [&](std::uint32_t h) { return faces.org[h]; });
  std::vector<std::uint32_t> cell(vertex_count, no_index), inside, rim;
  std::size_t next_rim = 0;
  for (std::uint32_t v = 0, number = 0; v < vertex_count; ++number) {
    // From what others left on their rims; else from the next component.
    std::uint32_t from = no_index;
    while (from == no_index && next_rim < rim.size())
      if (cell[rim[next_rim++]] == no_index) from = rim[next_rim - 1];
    while (from == no_index && v < vertex_count)
      if (cell[v++] == no_index) from = v - 1;
    if (from == no_index) break;
    inside.assign(1, from);
    cell[from] = number;
    for (std::size_t i = 0; i < inside.size(); ++i) {
      const auto around = corners[inside[i]];
      for (std::size_t k = around.size(); k-- > 0;)
        for (const std::uint32_t w : faces.cycle(faces.face(around[k]))) {
          if (cell[w] != no_index) continue;
          if (inside.size() < size) {
            cell[w] = number;
            inside.push_back(w);
          } else if (rim.empty() || rim.back() != w) {
            rim.push_back(w);
          }
        }
    }
  }
  return cell;
}

}  // namespace

SpatialKeys::SpatialKeys(const MeshView& mesh) {
  const std::optional<AttributeView> position = mesh.position();
  if (!position) return;
  axes_ = std::min<unsigned>(position->components, 3);
  is_float_ = position->scalar == Scalar::float32;
  numbers_.resize(std::size_t(axes_) * mesh.vertex_count);
  for (unsigned axis = 0; axis < axes_; ++axis)
    with_word(position->scalar, [&](auto word) {
      put_ordered<decltype(word)>(*position, axis, mesh.vertex_count, numbers_.data() + axis,
                                  axes_);
    });
}

std::uint64_t SpatialKeys::distance(std::uint32_t low, std::uint32_t high) const {
  if (!is_float_) return high - low;
  // In integers, as all that decides about bytes: the difference of mantissas in the greater
  // exponent, as exponent and mantissa once more.
  const auto exponent = [](std::uint32_t key) {
    return std::max(1u, from_ordered(key) >> 23 & 0xff);
  };
  const std::uint32_t most = std::max(exponent(low), exponent(high));
  const auto mantissa = [&](std::uint32_t key) {
    const std::uint32_t bits = from_ordered(key);
    const std::uint64_t size = (bits & 0x7fffff) | (bits >> 23 & 0xff ? 0x800000 : 0);
    const auto scaled =
        static_cast<std::int64_t>(size << 38 >> std::min(62u, most - exponent(key)));
    return bits >> 31 ? -scaled : scaled;
  };
  const auto difference = static_cast<std::uint64_t>(mantissa(high) - mantissa(low));
  if (difference == 0) return 0;
  const unsigned zeros = static_cast<unsigned>(std::countl_zero(difference));
  return (std::uint64_t(most) + 64 - zeros) << 32 | difference << zeros >> 32;
}

std::vector<std::uint32_t> cells_of(const SpatialKeys& places, const Faces& faces,
                                    std::uint32_t vertex_count, std::uint32_t pieces,
                                    std::uint32_t each, unsigned threads) {
  if (places.axes() == 0)
    return grown(faces, vertex_count,
                 static_cast<std::uint32_t>(vertex_count / (std::uint64_t(pieces) * each)) + 1);
  const Tree tree(places, vertex_count, pieces, each);
  std::vector<std::uint32_t> cell(vertex_count);
  constexpr std::uint32_t block = 1u << 16;
  for_each_item(vertex_count / block + 1, threads, [&](std::size_t i, unsigned) {
    const std::uint32_t begin = static_cast<std::uint32_t>(i * block);
    const std::uint32_t end = begin + std::min(block, vertex_count - begin);
    std::uint32_t v = begin;
    for (; v + 8 <= end; v += 8) tree.find<8>(v, cell.data() + v);
    for (; v < end; ++v) tree.find<1>(v, cell.data() + v);
  });
  return cell;
}

}  // namespace clers::internal
