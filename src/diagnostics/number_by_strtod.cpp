// SPDX-License-Identifier: BSD-2-Clause
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>

#include "diagnostics/number_from_chars.h"

namespace soarbox {
namespace {

bool IsDigit(char c, bool hexadecimal) {
  const bool is_letter = (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F');
  return (c >= '0' && c <= '9') || (hexadecimal && is_letter);
}

std::size_t DigitsAt(std::string_view text, std::size_t at, bool hexadecimal) {
  std::size_t count = 0;
  while (at + count < text.size() && IsDigit(text[at + count], hexadecimal)) ++count;
  return count;
}

/// Whether the text begins with a lower-case word, ignoring case in the text.
bool BeginsWith(std::string_view text, std::string_view word) {
  return text.size() >= word.size() && std::equal(word.begin(), word.end(), text.begin(), [](char letter, char c) {
           return c == letter || c == letter - 'a' + 'A';
         });
}

/// Length of "inf", "infinity", "nan" or "nan(letters)" at the beginning; 0 if there is none.
std::size_t WordLength(std::string_view text) {
  if (BeginsWith(text, "infinity")) return 8;
  if (BeginsWith(text, "inf")) return 3;
  if (!BeginsWith(text, "nan")) return 0;
  if (text.size() < 4 || text[3] != '(') return 3;
  const std::size_t end = std::min(
      text.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_", 4), text.size());
  return end < text.size() && text[end] == ')' ? end + 1 : 3;
}

/// Length of the digits, dot and exponent at the beginning; 0 if there are no digits.
std::size_t NumberLength(std::string_view text, bool hexadecimal) {
  std::size_t end = DigitsAt(text, 0, hexadecimal);
  std::size_t digits = end;
  if (end < text.size() && text[end] == '.') {
    const std::size_t fraction = DigitsAt(text, end + 1, hexadecimal);
    digits += fraction;
    end += 1 + fraction;
  }
  if (digits == 0) return 0;
  const char letter = hexadecimal ? 'p' : 'e';
  if (end < text.size() && (text[end] == letter || text[end] == letter - 'a' + 'A')) {
    const bool has_sign = end + 1 < text.size() && (text[end + 1] == '-' || text[end + 1] == '+');
    const std::size_t first = end + (has_sign ? 2 : 1);
    if (const std::size_t exponent = DigitsAt(text, first, false); exponent > 0) end = first + exponent;
  }
  return end;
}

/// Whether a digit before the exponent is not 0.
bool HasValue(std::string_view number, bool hexadecimal) {
  const std::string_view mantissa = number.substr(0, number.find_first_of(hexadecimal ? "pP" : "eE"));
  return mantissa.find_first_not_of("0.") != std::string_view::npos;
}

template <typename Number>
std::from_chars_result Read(std::string_view text, Number& value, bool hexadecimal,
                            Number (*convert)(const char*, char**)) {
  const bool negative = text.starts_with('-');
  const std::string_view rest = text.substr(negative ? 1 : 0);
  const std::size_t word = WordLength(rest);
  const std::size_t length = word > 0 ? word : NumberLength(rest, hexadecimal);
  if (length == 0) return {text.data(), std::errc::invalid_argument};
  const char* const end = rest.data() + length;
  const std::string_view number = rest.substr(0, length);
  const std::string copy = (word == 0 && hexadecimal ? "0x" : "") + std::string(number);
  const Number read = convert(copy.c_str(), nullptr);
  const bool is_lost = read == 0 && HasValue(number, hexadecimal);
  if (word == 0 && (std::isinf(read) || is_lost)) return {end, std::errc::result_out_of_range};
  value = negative ? -read : read;
  return {end, std::errc()};
}

}  // namespace

std::from_chars_result NumberByStrtod(std::string_view text, float& value) {
  return Read<float>(text, value, false, &std::strtof);
}

std::from_chars_result NumberByStrtod(std::string_view text, double& value, std::chars_format format) {
  return Read<double>(text, value, format == std::chars_format::hex, &std::strtod);
}

}  // namespace soarbox
