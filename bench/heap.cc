#include "bench/heap.h"

#include <malloc.h>

#include <algorithm>
#include <cerrno>
#include <cstddef>

// glibc's own allocator under the names it keeps for replacements like this one.
extern "C" {
void* __libc_malloc(std::size_t);
void* __libc_calloc(std::size_t, std::size_t);
void* __libc_realloc(void*, std::size_t);
void* __libc_memalign(std::size_t, std::size_t);
void __libc_free(void*);
}

namespace {

// One thread works while heap is counted.
bool counting = false;
std::int64_t held = 0, peak = 0;

void* taken(void* block) {
  if (counting && block) {
    held += static_cast<std::int64_t>(malloc_usable_size(block));
    peak = std::max(peak, held);
  }
  return block;
}

void given_back(void* block) {
  if (counting && block) held -= static_cast<std::int64_t>(malloc_usable_size(block));
}

}  // namespace

extern "C" {

void* malloc(std::size_t size) {
  return taken(__libc_malloc(size));
}
void* calloc(std::size_t count, std::size_t size) {
  return taken(__libc_calloc(count, size));
}

void* realloc(void* block, std::size_t size) {
  if (!counting) return __libc_realloc(block, size);
  // While it copies, both blocks are there; glibc often grows in place, and then only one is.
  const std::size_t before = block ? malloc_usable_size(block) : 0;
  void* moved = __libc_realloc(block, size);
  if (moved || size == 0) held -= static_cast<std::int64_t>(before);
  return taken(moved);
}

void* memalign(std::size_t alignment, std::size_t size) {
  return taken(__libc_memalign(alignment, size));
}
void* aligned_alloc(std::size_t alignment, std::size_t size) {
  return taken(__libc_memalign(alignment, size));
}
int posix_memalign(void** out, std::size_t alignment, std::size_t size) {
  void* block = taken(__libc_memalign(alignment, size));
  if (!block) return ENOMEM;
  *out = block;
  return 0;
}

void free(void* block) {
  given_back(block);
  __libc_free(block);
}

}  // extern "C"

namespace clers::bench {

void start_counting_heap() {
  held = peak = 0;
  counting = true;
}

std::uint64_t stop_counting_heap() {
  counting = false;
  return static_cast<std::uint64_t>(peak);
}

void keep_heap_warm() {
  mallopt(M_MMAP_MAX, 0);
  mallopt(M_TRIM_THRESHOLD, -1);
  mallopt(M_TOP_PAD, 64 << 20);
}

}  // namespace clers::bench
