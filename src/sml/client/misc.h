// SPDX-License-Identifier: BSD-2-Clause
#pragma once

/// Conversions, paths and timers for client programs, with the names that Soar's own programs use. The API does not
/// need them.
#include <charconv>
#include <iomanip>
#include <sstream>
#include <string>
#include <type_traits>

#include "portability.h"

// Paths ---------------------------------------------------------------------------------------------------------------

/// The separator between the folders of a path.
inline char const* get_directory_separator() {
  return "/";
}

/// Replaces a path's separators by get_directory_separator().
inline void normalize_separators(std::string& path) {
  for (char& c : path) {
    if (c == '\\') c = '/';
  }
}

// Values and texts ----------------------------------------------------------------------------------------------------

/// Writes a value into `text` and returns `text`. Floating-point values are written with `precision` digits, counted
/// after the decimal point if `fixed`.
template <class T>
std::string& to_string(const T& value, std::string& text, int precision = 16, bool fixed = false) {
  std::ostringstream out;
  if (fixed) out << std::fixed;
  out << std::setprecision(precision) << value;
  text = out.str();
  return text;
}

/// Parses the value at the beginning of a text. Returns false if there is none.
template <class T>
bool from_string(T& value, const std::string& text) {
  std::istringstream in(text);
  return static_cast<bool>(in >> value);
}
template <class T>
bool from_string(T& value, char const* text) {
  return from_string(value, std::string(text));
}

/// Buffer size for any integer written by to_c_string. Floating-point values may need more.
constexpr std::size_t TO_C_STRING_BUFSIZE = 24;

/// Writes a number into a buffer of TO_C_STRING_BUFSIZE characters and returns the buffer. Longer texts are truncated.
template <class T, class = std::enable_if_t<std::is_arithmetic_v<T>>>
char const* to_c_string(const T& value, char* buffer) {
  if constexpr (std::is_floating_point_v<T>) {
    std::snprintf(buffer, TO_C_STRING_BUFSIZE, "%Lf", static_cast<long double>(value));
  } else {
    *std::to_chars(buffer, buffer + TO_C_STRING_BUFSIZE - 1, value).ptr = '\0';
  }
  return buffer;
}

/// Parses the number at the beginning of a text, after blanks. Returns false if there is none.
template <class T, class = std::enable_if_t<std::is_arithmetic_v<T>>>
bool from_c_string(T& value, char const* text) {
  if constexpr (std::is_integral_v<T> && sizeof(T) == 1) {
    int number = 0;
    if (!from_string(number, text)) return false;
    value = static_cast<T>(number);
    return true;
  } else {
    return from_string(value, text);
  }
}

/// The difference of two numbers, for qsort.
template <class T>
T compare_num(const void* left, const void* right) {
  return *static_cast<const T*>(left) - *static_cast<const T*>(right);
}

/// Returns a number that is stored in a pointer.
template <class T>
T cast_and_possibly_truncate(void* pointer) {
  return static_cast<T>(reinterpret_cast<std::uintptr_t>(pointer));
}

/// Reinterprets the bits of a pointer, for conversions between functions and objects (dlsym).
template <typename Goal>
struct Dangerous_Pointer_Cast {
  template <typename Given>
  static Goal from(Given given) {
    static_assert(sizeof(Goal) == sizeof(Given));
    Goal goal;
    std::memcpy(&goal, &given, sizeof goal);
    return goal;
  }
};

// Time ----------------------------------------------------------------------------------------------------------------

/// Measures the time between the last start() and stop(). If it was given a switch, it measures only while that is on.
class soar_timer {
 public:
  soar_timer() = default;
  soar_timer(const soar_timer&) = delete;
  soar_timer& operator=(const soar_timer&) = delete;

  void set_enabled(bool* on) { on_ = on; }
  void start() {
    if (Runs()) began_ = get_raw_time();
  }
  void stop() {
    if (Runs()) elapsed_ = get_raw_time() - began_;
  }
  void reset() { began_ = elapsed_ = 0; }
  /// In microseconds.
  std::uint64_t get_usec() const {
    return Runs() ? static_cast<std::uint64_t>(static_cast<double>(elapsed_) / get_raw_time_per_usec()) : 0;
  }

 private:
  bool Runs() const { return !on_ || *on_; }

  std::uint64_t began_ = 0, elapsed_ = 0;
  bool* on_ = nullptr;
};

/// The sum of a timer's intervals.
class soar_timer_accumulator {
 public:
  void reset() { total_us_ = 0; }
  void update(const soar_timer& timer) { total_us_ += timer.get_usec(); }
  double get_sec() const { return static_cast<double>(total_us_) / 1e6; }
  std::uint64_t get_usec() const { return total_us_; }
  std::uint64_t get_msec() const { return total_us_ / 1000; }

 private:
  std::uint64_t total_us_ = 0;
};
