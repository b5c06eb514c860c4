// SPDX-License-Identifier: BSD-2-Clause
#pragma once

/// What client programs take from here besides the API: the system's headers that their sources rely on, and a few
/// small helpers under the names that Soar's own programs use. Nothing in the API needs any of them.
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

/// Programs written for Windows use TRUE and FALSE without a header of their own; sml_Client.h gives them the two
/// words. Define SOARBOX_SML_NO_TRUE before including it to keep them out.
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

/// Adds one to a counter that several threads share; the new value.
inline long atomic_inc(volatile long* counter) {
  return __atomic_add_fetch(counter, 1, __ATOMIC_SEQ_CST);
}

/// Takes one from a counter that several threads share; the new value.
inline long atomic_dec(volatile long* counter) {
  return __atomic_sub_fetch(counter, 1, __ATOMIC_SEQ_CST);
}

/// Makes the folder of the running program the working directory, so that files beside it are found. 0, or -1 after
/// saying why not on the standard error.
inline int set_working_directory_to_executable_path() {
  std::error_code error;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", error);
  if (!error) std::filesystem::current_path(program.parent_path(), error);
  if (!error) return 0;
  std::fprintf(stderr, "cannot make the program's folder the working directory: %s\n", error.message().c_str());
  return -1;
}

/// A clock that only goes forward, in units of which get_raw_time_per_usec() make a microsecond.
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
