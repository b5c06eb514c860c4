// SPDX-License-Identifier: BSD-2-Clause
#include "diagnostics/number_from_chars.h"

namespace soarbox {

std::from_chars_result NumberFromChars(std::string_view text, float& value) {
#ifdef __cpp_lib_to_chars
  return std::from_chars(text.data(), text.data() + text.size(), value);
#else
  return NumberByStrtod(text, value);
#endif
}

std::from_chars_result NumberFromChars(std::string_view text, double& value, std::chars_format format) {
#ifdef __cpp_lib_to_chars
  return std::from_chars(text.data(), text.data() + text.size(), value, format);
#else
  return NumberByStrtod(text, value, format);
#endif
}

}  // namespace soarbox
