// What standard C++ has no words for: code that must be inlined or must not, memory to fetch early,
// vector instructions. All of it is speed: other compilers, and builds with CLERS_PORTABLE, go
// without, and every result is the same.
#ifndef CLERS_CODEC_BASE_PORTABLE_H
#define CLERS_CODEC_BASE_PORTABLE_H

// CLERS_ALWAYS_INLINE and CLERS_NEVER_INLINE begin the declaration of a function;
// CLERS_INLINE_LAMBDA follows the parameters of a lambda.
#if defined(CLERS_PORTABLE)
#define CLERS_ALWAYS_INLINE inline
#define CLERS_NEVER_INLINE
#define CLERS_INLINE_LAMBDA
#elif defined(__GNUC__)  // and clang
#define CLERS_ALWAYS_INLINE [[gnu::always_inline]] inline
#define CLERS_NEVER_INLINE [[gnu::noinline]]
#define CLERS_INLINE_LAMBDA __attribute__((always_inline))
#elif defined(_MSC_VER)
#define CLERS_ALWAYS_INLINE __forceinline
#define CLERS_NEVER_INLINE __declspec(noinline)
#define CLERS_INLINE_LAMBDA
#else
#define CLERS_ALWAYS_INLINE inline
#define CLERS_NEVER_INLINE
#define CLERS_INLINE_LAMBDA
#endif

// Whether <emmintrin.h> is there, and every processor that is compiled for has what it declares.
#if !defined(CLERS_PORTABLE) && (defined(__SSE2__) || defined(_M_X64))
#define CLERS_SSE2 1
#else
#define CLERS_SSE2 0
#endif

namespace clers::internal {

/// Begins to fetch memory that is written to soon.
CLERS_ALWAYS_INLINE void fetch_for_writing(const void* p) {
#if !defined(CLERS_PORTABLE) && defined(__GNUC__)
  __builtin_prefetch(p, 1);
#else
  static_cast<void>(p);
#endif
}

}  // namespace clers::internal

#endif
