// SPDX-License-Identifier: BSD-2-Clause
#pragma once

/// The version of Soar whose behaviour and interface this library implements.
#define MAJOR_VERSION_NUMBER 9
#define MINOR_VERSION_NUMBER 6
#define MICRO_VERSION_NUMBER 3
#define GREEK_VERSION_NUMBER 0

#define SML_MAJOR_VERSION_NUMBER 9
#define SML_MINOR_VERSION_NUMBER 6
#define SML_MICRO_VERSION_NUMBER 3
#define SML_GREEK_VERSION_NUMBER 0

inline const char* VERSION_STRING() {
  return "9.6.3";
}
inline const char* SML_VERSION_STRING() {
  return "9.6.3";
}
