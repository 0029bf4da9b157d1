#pragma once

/// Guards against bugs in Bumpfoil itself, never against user input. Armed in the presets `dev` and
/// `release-audit`; compiled out elsewhere. Prints condition, place and function, then aborts.
#ifdef BUMPFOIL_ASSERTIONS
#include <cstdio>
#include <cstdlib>
#define BUMPFOIL_ASSERT(condition)                                                                                   \
  ((condition) ? static_cast<void>(0)                                                                                \
               : (std::fprintf(stderr, "bumpfoil bug: %s is false at %s:%d in %s\n", #condition, __FILE__, __LINE__, \
                               static_cast<const char*>(__func__)),                                                  \
                  std::abort()))
#else
#define BUMPFOIL_ASSERT(condition) static_cast<void>(0)
#endif
