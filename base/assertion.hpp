#pragma once
// For our own bugs only; bad input is refused with a Result.

#include <cstdio>
#include <cstdlib>

namespace tuberia::detail {

[[noreturn]] inline void assertion_failed(const char* condition, const char* message,
                                          const char* file, int line) noexcept {
  std::fprintf(stderr, "%s:%d: assertion `%s` failed: %s\n", file, line, condition, message);
  std::abort();
}

}  // namespace tuberia::detail

#ifdef NDEBUG
#define TUBERIA_ASSERT(condition, message) ((void)sizeof(!(condition)))
#else
#define TUBERIA_ASSERT(condition, message) \
  ((condition) ? (void)0                   \
               : ::tuberia::detail::assertion_failed(#condition, message, __FILE__, __LINE__))
#endif
