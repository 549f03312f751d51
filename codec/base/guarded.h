// Where the library's functions for callers begin: running out of memory is an error, as any other.
#ifndef CLERS_CODEC_BASE_GUARDED_H
#define CLERS_CODEC_BASE_GUARDED_H

#include <new>
#include <stdexcept>

#include "codec/error.h"

namespace clers::internal {

/// What `work` returns; out_of_memory if it throws std::bad_alloc, or std::length_error since a
/// container was to have more elements than can be addressed. What callbacks throw passes through.
template <class Work>
auto guarded(const char* to_do_what, const Work& work) -> decltype(work()) {
  try {
    return work();
  } catch (const std::bad_alloc&) {
  } catch (const std::length_error&) {
  }
  return fail(ErrorCode::out_of_memory, std::string("not enough memory to ") + to_do_what);
}

}  // namespace clers::internal

#endif
