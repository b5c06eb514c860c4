// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>

namespace soarbox::wording {

/// Removes the trailing zeros of a number with a fraction, because kernels print six decimals: 0.9 for 0.900000, 1 for
/// 1.000000. Returns everything else unchanged.
inline std::string WithoutZeros(std::string number) {
  const bool is_float =
      number.find('.') != std::string::npos && number.find_first_not_of("-0123456789.") == std::string::npos;
  while (is_float && number.ends_with('0')) number.pop_back();
  if (is_float && number.ends_with('.')) number.pop_back();
  return number;
}

}  // namespace soarbox::wording
