// SPDX-License-Identifier: BSD-2-Clause
#include "mission/rule_pattern.h"

#include <algorithm>
#include <map>
#include <sstream>

#include "explain/rule_text.h"
#include "mission/conditions.h"

namespace soarbox::mission {
namespace {

/// A clause of a pattern, or a condition or action of a rule in the same form.
struct Clause {
  bool negated = false;
  bool is_from_state = false;     ///< The path begins at the state; always true for rules.
  std::vector<std::string> path;  ///< Variables are replaced by <x>.
  std::string value;              ///< Variables are replaced by <x>; empty: any value.
};

/// Separates words by single blanks, and replaces all variables by <x>.
std::string Normal(std::string_view text) {
  std::string normal;
  std::istringstream words{std::string(text)};
  for (std::string word; words >> word;) normal += (normal.empty() ? "" : " ") + word;
  for (std::size_t at = normal.find('<'); at != std::string::npos; at = normal.find('<', at + 1)) {
    const std::size_t end = normal.find('>', at);
    if (end == std::string::npos || end == at + 1) continue;
    const std::string_view name(normal.data() + at + 1, end - at - 1);
    if (name.find_first_of(" <=") == std::string_view::npos) normal.replace(at, end + 1 - at, "<x>");
  }
  return normal;
}

std::vector<std::string> PathOf(std::string_view dotted) {
  std::vector<std::string> path;
  while (!dotted.empty()) {
    const std::size_t end = std::min(dotted.find('.'), dotted.size());
    path.push_back(Normal(dotted.substr(0, end)));
    dotted.remove_prefix(std::min(end + 1, dotted.size()));
  }
  return path;
}

Clause ReadClause(std::string_view text) {
  Clause clause;
  clause.negated = text.starts_with('-');
  if (clause.negated) text.remove_prefix(1);
  clause.is_from_state = text.starts_with("state ");
  const std::size_t caret = text.find('^');
  if (caret == std::string_view::npos) return clause;
  text.remove_prefix(caret + 1);
  const std::size_t end = std::min(text.find(' '), text.size());
  clause.path = PathOf(text.substr(0, end));
  clause.value = Normal(text.substr(end));
  return clause;
}

/// Replaces all numbers by #.
std::string WithoutNumbers(const std::string& text) {
  std::string plain;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    const bool is_number = word.find_first_of("0123456789") != std::string::npos &&
                           word.find_first_not_of("0123456789.-e+") == std::string::npos;
    plain += (plain.empty() ? "" : " ") + (is_number ? "#" : word);
  }
  return plain;
}

bool Matches(const Clause& wanted, const Clause& there) {
  if (wanted.negated != there.negated || wanted.path.size() > there.path.size()) return false;
  if (wanted.is_from_state && wanted.path.size() != there.path.size()) return false;
  const auto first = there.path.end() - static_cast<std::ptrdiff_t>(wanted.path.size());
  const auto is_like = [](const std::string& pattern, const std::string& word) {
    return MatchesPattern(pattern, word);
  };
  if (!std::equal(wanted.path.begin(), wanted.path.end(), first, is_like)) return false;
  if (wanted.value.empty()) return true;
  const bool asks_for_number = wanted.value.find('#') != std::string::npos;
  return MatchesPattern(wanted.value, asks_for_number ? WithoutNumbers(there.value) : there.value);
}

std::vector<Clause> ConditionsOf(const explain::RuleText& rule) {
  std::vector<Clause> clauses;
  for (const explain::RuleAttribute& condition : rule.conditions) {
    Clause& clause = clauses.emplace_back();
    clause.negated = condition.negated;
    if (const auto at = rule.paths.find(condition.id); at != rule.paths.end())
      for (const std::string& word : at->second) clause.path.push_back(Normal(word));
    clause.path.push_back(Normal(condition.attribute));
    clause.value = Normal(condition.value);
  }
  return clauses;
}

/// Returns the actions of a rule as clauses. The path of an object that actions create is the path of the action that
/// refers to it.
std::vector<Clause> ActionsOf(const explain::RuleText& rule) {
  constexpr int kDeepest = 20;
  explain::PathMap paths = rule.paths;
  for (int i = 0; i < kDeepest; ++i) {
    bool has_more = false;
    for (const explain::RuleAttribute& action : rule.actions) {
      const std::string word = explain::FirstWord(action.value);
      const auto at = paths.find(action.id);
      if (at == paths.end() || !explain::IsVariable(word) || paths.contains(word)) continue;
      std::vector<std::string> path = at->second;
      path.push_back(action.attribute);
      has_more |= paths.emplace(word, std::move(path)).second;
    }
    if (!has_more) break;
  }
  std::vector<Clause> clauses;
  for (const explain::RuleAttribute& action : rule.actions) {
    Clause& clause = clauses.emplace_back();
    if (const auto at = paths.find(action.id); at != paths.end())
      for (const std::string& word : at->second) clause.path.push_back(Normal(word));
    clause.path.push_back(Normal(action.attribute));
    clause.value = Normal(action.value);
    // Kernels also print the + of values that are not operators.
    if (action.attribute != "operator" && clause.value.ends_with(" +")) clause.value.resize(clause.value.size() - 2);
  }
  return clauses;
}

bool HasAll(const std::vector<std::string>& wanted, const std::vector<Clause>& there) {
  return std::ranges::all_of(wanted, [&](const std::string& text) {
    const Clause clause = ReadClause(text);
    return std::ranges::any_of(there, [&](const Clause& each) { return Matches(clause, each); });
  });
}

bool Calls(const explain::RuleText& rule, const std::string& wanted) {
  const std::size_t blank = std::min(wanted.find(' '), wanted.size());
  const std::string function = wanted.substr(0, blank), argument = Normal(wanted.substr(blank));
  return std::ranges::any_of(rule.all_calls, [&](const explain::RuleCall& call) {
    return call.function == function &&
           (argument.empty() || std::ranges::any_of(call.arguments, [&](const std::string& each) {
              return MatchesPattern(argument, Normal(each));
            }));
  });
}

}  // namespace

bool RulePattern::Fits(const explain::RuleText& rule) const {
  const std::vector<Clause> conditions = ConditionsOf(rule), actions = ActionsOf(rule);
  if (!HasAll(tests, conditions) || !HasAll(makes, actions)) return false;
  if (!std::ranges::all_of(calls, [&](const std::string& call) { return Calls(rule, call); })) return false;
  return std::ranges::none_of(
      without, [&](const std::string& clause) { return HasAll({clause}, conditions) || HasAll({clause}, actions); });
}

std::string ProblemOfClause(std::string_view clause) {
  if (clause.starts_with('-')) clause.remove_prefix(1);
  if (clause.starts_with("state ")) clause.remove_prefix(6);
  if (clause.size() > 1 && clause.starts_with('^') && clause[1] != ' ') return {};
  return "a clause is a path and perhaps a value: \"^status complete\", \"-^danger\", \"state ^operator <x> > <y>\"";
}

}  // namespace soarbox::mission
