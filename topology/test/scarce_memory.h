// Memory that runs out when a test says so. A program that links scarce_memory.cc has its operators
// new and delete.
#pragma once

#include <cstddef>

namespace clers::test::memory {

/// Allocations that still succeed; negative: all do.
inline long remaining = -1;
/// Allocations so far, and what they asked for together.
inline long made = 0;
inline std::size_t bytes = 0;

}  // namespace clers::test::memory
