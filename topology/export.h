// What a shared library shows: the declarations of public headers, and nothing else. Includers need
// C++20.
#ifndef CLERS_TOPOLOGY_EXPORT_H
#define CLERS_TOPOLOGY_EXPORT_H

#if (defined(_MSVC_LANG) ? _MSVC_LANG : __cplusplus) < 202002L
#error "clers needs C++20"
#endif

// Libraries are built with hidden symbols; `namespace CLERS_VISIBLE clers` opens the public part,
// where it is declared and, since clang looks there, where it is defined.
#if defined(__GNUC__)
#define CLERS_VISIBLE [[gnu::visibility("default")]]
#else
#define CLERS_VISIBLE
#endif

#endif
