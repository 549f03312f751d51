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

// Whether doubles are calculated with on the x87, which rounds to 64 bits unless told otherwise.
#if defined(__i386__) && !defined(__SSE2_MATH__)
#if !defined(__GNUC__)
#error "a way to make the x87 round to doubles"
#endif
#define CLERS_X87 1
#else
#define CLERS_X87 0
#endif

namespace clers::internal {

/// While there is one, each operation on doubles rounds to a double, as elsewhere. Results that are
/// smaller than normal doubles are still rounded twice.
class DoublePrecision {
 public:
  DoublePrecision() {
#if CLERS_X87
    asm volatile("fnstcw %0" : "=m"(before_));
    set(static_cast<unsigned short>((before_ & ~0x300) | 0x200));
#endif
  }
  ~DoublePrecision() {
#if CLERS_X87
    set(before_);
#endif
  }
  DoublePrecision(const DoublePrecision&) = delete;
  DoublePrecision& operator=(const DoublePrecision&) = delete;

#if CLERS_X87
 private:
  static void set(unsigned short control) {
    asm volatile("fldcw %0" : : "m"(control) : "memory");
  }
  unsigned short before_;
#endif
};

/// Begins to fetch memory that is read soon.
CLERS_ALWAYS_INLINE void fetch(const void* p) {
#if !defined(CLERS_PORTABLE) && defined(__GNUC__)
  __builtin_prefetch(p);
#else
  static_cast<void>(p);
#endif
}

/// The same where it is written to.
CLERS_ALWAYS_INLINE void fetch_for_writing(const void* p) {
#if !defined(CLERS_PORTABLE) && defined(__GNUC__)
  __builtin_prefetch(p, 1);
#else
  static_cast<void>(p);
#endif
}

}  // namespace clers::internal

#endif
