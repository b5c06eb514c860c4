// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <charconv>
#include <concepts>
#include <string_view>

namespace soarbox {

/// std::from_chars for every type of number: reads the longest number that the text begins with. libc++ before version
/// 20 has no std::from_chars for floating-point numbers. The value is unchanged unless `ec` is std::errc().
template <std::integral Number>
std::from_chars_result NumberFromChars(std::string_view text, Number& value) {
  return std::from_chars(text.data(), text.data() + text.size(), value);
}
std::from_chars_result NumberFromChars(std::string_view text, float& value);
/// `format` is std::chars_format::general or, for digits without 0x, std::chars_format::hex.
std::from_chars_result NumberFromChars(std::string_view text, double& value,
                                       std::chars_format format = std::chars_format::general);

/// The same by C's strtod, for libraries without the above. The locale must be C's, as it is in a program that does not
/// set it.
std::from_chars_result NumberByStrtod(std::string_view text, float& value);
std::from_chars_result NumberByStrtod(std::string_view text, double& value, std::chars_format format);

}  // namespace soarbox
