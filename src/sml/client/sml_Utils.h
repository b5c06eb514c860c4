// SPDX-License-Identifier: BSD-2-Clause
#pragma once

/// Sleeping, debug messages and checks for client programs, with the names that Soar's own programs use. The API does
/// not need them.
#include <cassert>
#include <cerrno>
#include <chrono>
#include <cstdarg>
#include <cstdio>
#include <cstring>
#include <thread>

#include "Export.h"

#if !defined(unused)
#define unused(x) (void)(x)
#endif

/// Return from a function if an argument or a state is wrong; in debug builds the program aborts.
#if !defined(CHECK)
#define CHECK(x)      \
  {                   \
    assert(x);        \
    if (!(x)) return; \
  }
#define CHECK_RET_FALSE(x)  \
  {                         \
    assert(x);              \
    if (!(x)) return false; \
  }
#define CHECK_RET_ZERO(x) \
  {                       \
    assert(x);            \
    if (!(x)) return 0;   \
  }
#define CHECK_RET_NULL(x)     \
  {                           \
    assert(x);                \
    if (!(x)) return nullptr; \
  }
#endif
#if !defined(CTDEBUG_ENTER_METHOD)
#define CTDEBUG_ENTER_METHOD(name)
#endif

namespace sml {

/// Blocks only the calling thread.
inline void Sleep(int seconds, int milliseconds) {
  std::this_thread::sleep_for(std::chrono::seconds(seconds) + std::chrono::milliseconds(milliseconds));
}

/// Prints the system's last error to the standard error.
inline void ReportSystemErrorMessage() {
  std::fprintf(stderr, "%s\n", std::strerror(errno));
}

/// Print a line to the standard error.
inline void PrintDebug(char const* text) {
  std::fprintf(stderr, "%s\n", text);
}
inline void PrintDebugMethod(char const* method, char const* text) {
  std::fprintf(stderr, "%s: %s\n", method, text);
}
inline void PrintDebugFormat(char const* format, ...) {
  va_list values;
  va_start(values, format);
  std::vfprintf(stderr, format, values);
  va_end(values);
  std::fputc('\n', stderr);
}

}  // namespace sml
