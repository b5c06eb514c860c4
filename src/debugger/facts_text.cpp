// SPDX-License-Identifier: BSD-2-Clause
#include "debugger/facts_text.h"

#include <algorithm>
#include <sstream>

#include "diagnostics/lower_case.h"

namespace soarbox::debugger {
namespace {

/// Number of columns of a text. Continuation bytes of a character do not count.
std::size_t Width(std::string_view text) {
  return static_cast<std::size_t>(std::ranges::count_if(text, [](char c) { return (c & 0xC0) != 0x80; }));
}

}  // namespace

std::string Describe(const explain::ElementFact& element) {
  return element.id + " ^" + element.attribute + " " + element.value + (element.acceptable ? " +" : "");
}

std::string Describe(const explain::MakerFact& maker) {
  switch (maker.kind) {
    case explain::MakerFact::Kind::kInput:
      return "input";
    case explain::MakerFact::Kind::kArchitecture:
      return "the architecture";
    case explain::MakerFact::Kind::kRule:
      break;
  }
  return "rule " + maker.rule + (maker.o_supported ? " (o-support)" : " (i-support)");
}

std::string NameAndId(std::string_view name, std::string_view id) {
  if (name.empty()) return std::string(id);
  return std::string(name) + " (" + std::string(id) + ")";
}

std::string Table(const std::vector<std::vector<std::string>>& rows) {
  std::vector<std::size_t> widths;
  for (const std::vector<std::string>& row : rows) {
    if (widths.size() < row.size()) widths.resize(row.size());
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], Width(row[i]));
  }
  std::string text;
  for (const std::vector<std::string>& row : rows) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i)
      line += row[i] + std::string(i + 1 < row.size() ? widths[i] - Width(row[i]) + 2 : 0, ' ');
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + "\n";
  }
  return text;
}

bool Passes(std::string_view filter, std::string_view text) {
  const std::string lower = LowerCase(text);
  std::istringstream words(LowerCase(filter));
  for (std::string word; words >> word;)
    if (lower.find(word) == std::string::npos) return false;
  return true;
}

}  // namespace soarbox::debugger
