// SPDX-License-Identifier: BSD-2-Clause
#pragma once

/// Waiting, messages for debugging, and checks for client programs, under the names that Soar's own programs use for
/// them. Nothing in the API needs any of them.
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

/// Leave a function whose argument or state is wrong; in debug builds the program ends there.
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

/// Waits, without holding up other threads.
inline void Sleep(int seconds, int milliseconds) {
  std::this_thread::sleep_for(std::chrono::seconds(seconds) + std::chrono::milliseconds(milliseconds));
}

/// Says on the standard error what the system's last error was.
inline void ReportSystemErrorMessage() {
  std::fprintf(stderr, "%s\n", std::strerror(errno));
}

/// Write a line to the standard error.
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
