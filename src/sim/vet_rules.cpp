// SPDX-License-Identifier: BSD-2-Clause
#include "sim/vet_rules.h"

#include <algorithm>
#include <sstream>
#include <system_error>

#include "explain/rule_slips.h"
#include "explain/rule_text.h"
#include "sim/check.h"
#include "sim/live_edits.h"
#include "sim/sourced_files.h"

namespace soarbox::sim {
namespace {

namespace fs = std::filesystem;

/// The text without lines that source existing files; other lines keep their numbers.
std::string WithoutSourced(const std::string& text, const fs::path& file) {
  std::istringstream lines(text);
  std::string rest;
  for (std::string line; std::getline(lines, line); rest += '\n') {
    std::error_code error;
    const std::string name = NameSourcedBy(line);
    if (!name.empty() && fs::is_regular_file(file.parent_path() / name, error)) continue;
    rest += line;
  }
  return rest;
}

/// SplitRules counts braces. If the parser accepts a text that SplitRules cannot split, its rules could not be
/// distinguished.
std::vector<Diagnostic> WithUnclosed(std::vector<Diagnostic> problems, const SplitText& split,
                                     const std::string& name) {
  if (split.unclosed.empty() || HasError(problems)) return problems;
  Diagnostic problem;
  problem.file = name;
  problem.message = "rule " + split.unclosed + " is not closed: } is missing";
  problem.hint = "put } at its end";
  problems.push_back(std::move(problem));
  return problems;
}

}  // namespace

bool HasError(const std::vector<Diagnostic>& problems) {
  return std::ranges::any_of(problems, [](const Diagnostic& p) { return p.severity == Severity::kError; });
}

std::vector<Diagnostic> VetRuleFile(const std::string& text, const fs::path& file) {
  std::vector<Diagnostic> problems =
      WithUnclosed(CheckRuleText(WithoutSourced(text, file), file.string()), SplitRules(text), file.string());
  for (Diagnostic& twice : explain::FindDuplicates({{file, explain::BlankComments(text)}}))
    problems.push_back(std::move(twice));
  return problems;
}

std::vector<Diagnostic> VetTypedRules(const std::string& line) {
  const std::size_t begin = std::min(line.find_first_not_of(" \t\r\n"), line.size());
  const std::string_view command = std::string_view(line).substr(begin, 2);
  const std::size_t open = line.find_first_not_of(" \t\r\n", std::min(begin + 2, line.size()));
  if ((command != "sp" && command != "gp") || open == std::string::npos || line[open] != '{') return {};
  const SplitText split = SplitRules(line);
  // For a line that ends within its rule, the entire line is parsed, so that the parser reports what is missing.
  return WithUnclosed(CheckRuleText(split.unclosed.empty() ? split.only_rules : line, ""), split, "");
}

}  // namespace soarbox::sim
