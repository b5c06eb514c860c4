// SPDX-License-Identifier: BSD-2-Clause
#include "sim/game_rules.h"

#include <algorithm>
#include <cctype>
#include <set>
#include <string>
#include <system_error>

#include "diagnostics/read_text.h"
#include "vocabulary/vocabulary.h"

namespace soarbox::sim {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kFewest = 2;

/// The commands of rules, and their percepts directly on the input link, that bodies do not have.
std::set<std::string> ForeignWords(const std::vector<explain::RuleText>& rules) {
  const std::vector<std::string> link = {"io", "input-link"};
  std::set<std::string> words;
  for (const explain::RuleText& rule : rules) {
    for (const std::string& command : rule.says)
      if (explain::IsConstantAttribute(command) && vocabulary::FindCommand(command) == nullptr) words.insert(command);
    for (const explain::RuleAttribute& condition : rule.conditions) {
      const auto path = rule.paths.find(condition.id);
      if (path != rule.paths.end() && path->second == link && explain::IsConstantAttribute(condition.attribute) &&
          !vocabulary::IsPerceptAttribute(condition.attribute))
        words.insert(condition.attribute);
    }
  }
  return words;
}

bool IsOfWord(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-';
}

/// The keys of the tables in a script: clock = 1, ["my-location"] = 2.
std::set<std::string> KeysOf(const std::string& script) {
  std::set<std::string> keys;
  for (std::size_t at = script.find('='); at != std::string::npos; at = script.find('=', at + 1)) {
    std::size_t end = at;
    while (end > 0 && script[end - 1] == ' ') --end;
    if (end > 1 && script[end - 1] == ']' && script[end - 2] == '"') end -= 2;
    std::size_t begin = end;
    while (begin > 0 && IsOfWord(script[begin - 1])) --begin;
    if (begin < end) keys.insert(script.substr(begin, end - begin));
  }
  return keys;
}

}  // namespace

bool AreForGame(const std::vector<explain::RuleText>& rules, const fs::path& library) {
  const std::set<std::string> words = ForeignWords(rules);
  if (library.empty() || words.size() < kFewest) return false;
  std::error_code error;
  for (fs::directory_iterator at(library, error), end; !error && at != end; at.increment(error)) {
    if (!at->path().filename().string().ends_with("Rules.lua")) continue;
    const std::set<std::string> keys = KeysOf(ReadText(at->path()).value_or(""));
    if (std::ranges::includes(keys, words)) return true;
  }
  return false;
}

}  // namespace soarbox::sim
