// SPDX-License-Identifier: BSD-2-Clause
#include "cli/generate_rules.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace soarbox::cli {
namespace {

bool IsBlank(char c) {
  return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

/// The index after the closing `quote` of the quoted text that begins at `start`; the end if it is not closed.
std::size_t SkipQuoted(std::string_view text, std::size_t start, char quote) {
  std::size_t i = start + 1;
  while (i < text.size() && text[i] != quote) i += text[i] == '\\' ? 2 : 1;
  return std::min(i + 1, text.size());
}

/// Reads the values between [ and ]; false if the ] is missing. `position` moves to the character after the ].
bool ReadValues(std::string_view text, std::size_t& position, std::vector<std::string>& values) {
  std::string value;
  const auto finish = [&] {
    if (!value.empty()) values.push_back(std::move(value));
    value.clear();
  };
  while (position < text.size()) {
    const char c = text[position];
    if (c == ']') {
      ++position;
      finish();
      return true;
    }
    if (c == '|' || c == '"') {
      const std::size_t end = SkipQuoted(text, position, c);
      value += text.substr(position, end - position);
      position = end;
      if (c == '|') finish();  // The following text is the next value.
      continue;
    }
    if (c == '\\' && position + 1 < text.size()) {  // The next character literally, also a blank or a bracket.
      value += text[position + 1];
      position += 2;
      continue;
    }
    if (IsBlank(c))
      finish();
    else
      value += c;
    ++position;
  }
  return false;
}

}  // namespace

std::string GeneratedRules::Body(std::uint64_t index) const {
  std::string body = fmt::format("{}*{}", name, index + 1);
  for (std::size_t i = 0; i < texts.size(); ++i) {
    body += texts[i];
    if (i < values.size()) {
      body += values[i][index % values[i].size()];
      index /= values[i].size();
    }
  }
  return body;
}

GeneratedRules GenerateRules(std::string_view text, std::uint64_t limit) {
  GeneratedRules rules;
  std::size_t position = 0;
  while (position < text.size() && IsBlank(text[position])) ++position;
  const std::size_t name_start = position;
  while (position < text.size() && !IsBlank(text[position]) && text[position] != '(') {
    if (text[position] == '[' || text[position] == ']') {
      rules.error = "gp syntax error, the production's name may not hold a values bracket.";
      return rules;
    }
    position = text[position] == '|' ? SkipQuoted(text, position, '|') : position + 1;
  }
  rules.name = text.substr(name_start, position - name_start);
  if (rules.name.empty()) {
    rules.error = "gp syntax error, the production has no name.";
    return rules;
  }
  rules.count = 1;
  std::string part;
  while (position < text.size()) {
    const char c = text[position];
    if (c == '|' || c == '"') {
      const std::size_t end = SkipQuoted(text, position, c);
      part += text.substr(position, end - position);
      position = end;
      continue;
    }
    ++position;
    if (c != '[') {
      part += c;
      continue;
    }
    std::vector<std::string> values;
    if (!ReadValues(text, position, values)) {
      rules.error = "gp syntax error, unmatched values bracket.";
      return rules;
    }
    if (values.empty()) {
      rules.error = "gp syntax error, a values bracket is empty.";
      return rules;
    }
    // The product stops growing before it can overflow. It is then already above every limit.
    if (rules.count <= 1'000'000'000'000) rules.count *= values.size();
    rules.texts.push_back(std::exchange(part, {}));
    rules.values.push_back(std::move(values));
  }
  rules.texts.push_back(std::move(part));
  if (rules.count > limit) {
    rules.error = fmt::format("gp-max exceeded, current production produces {} productions.", rules.count);
    rules.count = 0;
  }
  return rules;
}

}  // namespace soarbox::cli
