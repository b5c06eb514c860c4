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

/// An implementation with C's strtod, for standard libraries without floating-point std::from_chars. The locale must be
/// "C", which is the default of a program.
std::from_chars_result NumberByStrtod(std::string_view text, float& value);
std::from_chars_result NumberByStrtod(std::string_view text, double& value, std::chars_format format);

}  // namespace soarbox
