// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <sstream>
#include <string>
#include <string_view>
#include <vector>

namespace soarbox::explain {

// Helpers for parsing the text that kernels print.

inline std::vector<std::string> Lines(std::string_view text) {
  std::vector<std::string> lines;
  std::istringstream in{std::string(text)};
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

inline std::string_view WithoutBlanks(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(" \t\r\n");
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(" \t\r\n") - begin + 1);
}

inline std::string Trimmed(std::string_view text) {
  return std::string(WithoutBlanks(text));
}

}  // namespace soarbox::explain
