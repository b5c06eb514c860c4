// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string_view>

/// The characters and word shapes of the rule language, independent of the locale.
namespace soarbox::kernel {

constexpr bool IsDigit(char c) {
  return c >= '0' && c <= '9';
}
constexpr bool IsLetter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}
constexpr char ToUpper(char c) {
  return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
}
constexpr char ToLower(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

/// True for characters of symbols that are written without bars.
constexpr bool IsConstituent(char c) {
  return IsLetter(c) || IsDigit(c) || std::string_view("$%&*+-/:<=>?_@").find(c) != std::string_view::npos;
}

/// True for separators of symbols: blanks, line ends and, as in Soar, the semicolon.
constexpr bool IsBlank(char c) {
  return c == ' ' || (c >= '\t' && c <= '\r') || c == ';';
}

/// True for an optional sign followed by one or more digits.
constexpr bool LooksLikeInteger(std::string_view text) {
  if (!text.empty() && (text[0] == '+' || text[0] == '-')) {
    text.remove_prefix(1);
  }
  for (const char c : text) {
    if (!IsDigit(c)) {
      return false;
    }
  }
  return !text.empty();
}

/// "<x>": brackets around at least one constituent character.
constexpr bool LooksLikeVariable(std::string_view text) {
  if (text.size() < 3 || text.front() != '<' || text.back() != '>') {
    return false;
  }
  for (const char c : text) {
    if (!IsConstituent(c)) {
      return false;
    }
  }
  return true;
}

/// True for one letter followed by one or more digits: "S1", "r22".
constexpr bool LooksLikeIdentifier(std::string_view text) {
  if (text.size() < 2 || !IsLetter(text[0])) {
    return false;
  }
  for (const char c : text.substr(1)) {
    if (!IsDigit(c)) {
      return false;
    }
  }
  return true;
}

}  // namespace soarbox::kernel
