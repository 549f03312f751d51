// Values sorted by hash, so that equal ones are neighbours.
#include "codec/io/weld.h"

#include <algorithm>
#include <cstring>

namespace clers::io {

namespace {

std::uint64_t hash(const std::byte* bytes, std::size_t size) {
  std::uint64_t h = size;
  for (; size > 0;) {
    std::uint64_t word = 0;
    const std::size_t n = std::min(size, sizeof word);
    std::memcpy(&word, bytes, n);
    bytes += n;
    size -= n;
    h = (h ^ word) * 0x9e3779b97f4a7c15u;
    h ^= h >> 32;
  }
  return h;
}

}  // namespace

// Sorting by hash brings equal values together without comparing bytes much, and unlike a hash
// table it takes no longer when somebody makes the hashes collide.
Welded weld(std::span<const std::byte> values, std::size_t stride) {
  struct Entry {
    std::uint64_t hash;
    std::uint32_t index;
  };
  const auto bytes = [&](const Entry& e) { return values.data() + e.index * stride; };
  std::vector<Entry> entries(values.size() / stride);
  for (std::uint32_t i = 0; i < entries.size(); ++i)
    entries[i] = {hash(values.data() + i * stride, stride), i};
  std::sort(entries.begin(), entries.end(), [&](const Entry& a, const Entry& b) {
    if (a.hash != b.hash) return a.hash < b.hash;
    const int order = std::memcmp(bytes(a), bytes(b), stride);
    return order != 0 ? order < 0 : a.index < b.index;
  });

  Welded welded;
  welded.number.resize(entries.size());
  const Entry* first = nullptr;  // of the run of equal values
  for (const Entry& e : entries) {
    if (!first || first->hash != e.hash || std::memcmp(bytes(*first), bytes(e), stride) != 0)
      first = &e;
    welded.number[e.index] = first->index;
  }
  for (std::uint32_t i = 0; i < entries.size(); ++i) {
    if (welded.number[i] == i) {
      welded.number[i] = static_cast<std::uint32_t>(welded.first.size());
      welded.first.push_back(i);
    } else {
      welded.number[i] = welded.number[welded.number[i]];
    }
  }
  return welded;
}

}  // namespace clers::io
