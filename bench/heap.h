// How many bytes of heap a piece of work needs at its peak.
#ifndef CLERS_BENCH_HEAP_H
#define CLERS_BENCH_HEAP_H

#include <cstdint>

namespace clers::bench {

/// Starts counting from zero. malloc and its kin are replaced in this program, so that C libraries
/// are counted like operator new; while nothing is counted they only pass the call on.
void start_counting_heap();

/// Stops, and gives the most bytes that were held at once since the start, beyond those held then:
/// usable sizes of the blocks, without the allocator's own administration.
std::uint64_t stop_counting_heap();

/// Keeps freed memory in the process, so that no codec pays for pages that another already touched:
/// without this, blocks of some 100 kB and more come from mmap and go back to the system at
/// every free, and a decoder that allocates afresh at each call looks two to three times as slow.
void keep_heap_warm();

}  // namespace clers::bench

#endif
