// SPDX-License-Identifier: BSD-2-Clause
#pragma once

/// System headers that client programs rely on, and a few helpers with the names that Soar's own programs use. The API
/// does not need them.
#include <dirent.h>
#include <dlfcn.h>
#include <sys/stat.h>
#include <sys/time.h>
#include <sys/types.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <chrono>
#include <cinttypes>
#include <climits>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <string>
#include <system_error>

#include "Export.h"

/// Programs written for Windows use TRUE and FALSE without including a header, so sml_Client.h defines them. Define
/// SOARBOX_SML_NO_TRUE before including it to prevent that.
#if !defined(SOARBOX_SML_NO_TRUE)
#if !defined(TRUE)
#define TRUE 1
#endif
#if !defined(FALSE)
#define FALSE 0
#endif
#endif

#if !defined(SNPRINTF)
#define SNPRINTF snprintf
#endif
#if !defined(VSNPRINTF)
#define VSNPRINTF vsnprintf
#endif
#if !defined(MAXPATHLEN)
#define MAXPATHLEN 1024
#endif

/// Increments a counter that threads share. Returns the new value.
inline long atomic_inc(volatile long* counter) {
  return __atomic_add_fetch(counter, 1, __ATOMIC_SEQ_CST);
}

/// Decrements a counter that threads share. Returns the new value.
inline long atomic_dec(volatile long* counter) {
  return __atomic_sub_fetch(counter, 1, __ATOMIC_SEQ_CST);
}

/// Makes the folder of the running program the working directory, so that files in it are found. Returns 0; on error,
/// prints a message to the standard error and returns -1.
inline int set_working_directory_to_executable_path() {
  std::error_code error;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", error);
  if (!error) std::filesystem::current_path(program.parent_path(), error);
  if (!error) return 0;
  std::fprintf(stderr, "cannot make the program's folder the working directory: %s\n", error.message().c_str());
  return -1;
}

/// A monotonic clock. Its unit is 1 / get_raw_time_per_usec() microseconds.
inline std::uint64_t get_raw_time() {
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  return static_cast<std::uint64_t>(std::chrono::duration_cast<std::chrono::nanoseconds>(now).count());
}
inline double get_raw_time_per_usec() {
  return 1000.0;
}

/// Whether colours may be printed: the standard output is a terminal.
inline bool stdout_supports_ansi_colors() {
  return isatty(STDOUT_FILENO) != 0;
}
