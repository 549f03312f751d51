#include "topology/test/scarce_memory.h"

#include <cstdlib>
#include <new>

namespace memory = clers::test::memory;

void* operator new(std::size_t size) {
  ++memory::made;
  memory::bytes += size;
  if (memory::remaining == 0) throw std::bad_alloc();
  if (memory::remaining > 0) --memory::remaining;
  void* p = std::malloc(size == 0 ? 1 : size);
  if (p == nullptr) throw std::bad_alloc();
  return p;
}
// The standard library's own buffers (std::stable_sort) ask in this way. It is replaced too, or a
// sanitizer's answers and the operators below frees.
void* operator new(std::size_t size, const std::nothrow_t&) noexcept try {
  return ::operator new(size);
} catch (const std::bad_alloc&) {
  return nullptr;
}
void operator delete(void* p) noexcept {
  std::free(p);
}
void operator delete(void* p, std::size_t) noexcept {
  std::free(p);
}
void operator delete(void* p, const std::nothrow_t&) noexcept {
  std::free(p);
}
