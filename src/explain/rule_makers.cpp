// SPDX-License-Identifier: BSD-2-Clause
#include "explain/rule_makers.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <sstream>

#include "diagnostics/number_from_chars.h"

namespace soarbox::explain {
namespace {

std::optional<double> NumberOf(const std::string& word) {
  double number = 0;
  const auto [end, error] = NumberFromChars(word, number);
  if (word.empty() || error != std::errc{} || end != word.data() + word.size()) return std::nullopt;
  return number;
}

std::vector<std::string> WordsOf(const std::string& text) {
  std::istringstream in(text);
  std::vector<std::string> words;
  for (std::string word; in >> word;) words.push_back(word);
  return words;
}

bool Compares(const std::string& word) {
  return word == "<" || word == ">" || word == "<=" || word == ">=" || word == "<>" || word == "<=>" || word == "=";
}

bool IsConstant(const std::string& word) {
  return !word.empty() && !IsVariable(word) && word.find_first_of("(){}^") == std::string::npos && word != "<<" &&
         word != ">>" && !Compares(word);
}

/// Compares two constants by one relation.
bool Holds(const std::string& made, const std::string& relation, const std::string& with) {
  if (relation.empty() || relation == "=") return made == with;
  if (relation == "<>") return made != with;
  const std::optional<double> a = NumberOf(made), b = NumberOf(with);
  if (relation == "<=>") return a.has_value() == b.has_value();
  if (!a || !b) return false;
  return relation == "<" ? *a < *b : relation == "<=" ? *a <= *b : relation == ">" ? *a > *b : *a >= *b;
}

/// Whether a constant passes the tests of a condition.
Makes PassesTests(const std::string& made, const std::string& tests) {
  const std::vector<std::string> words = WordsOf(tests);
  Makes result = Makes::kYes;
  std::string relation;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string& word = words[i];
    if (word == "{" || word == "}") continue;
    if (word == "<<") {
      bool is_there = false;
      for (++i; i < words.size() && words[i] != ">>"; ++i) is_there |= words[i] == made;
      if (!is_there) return Makes::kNo;
    } else if (Compares(word)) {
      relation = word;
      continue;
    } else if (IsConstant(word)) {
      if (!Holds(made, relation, word)) return Makes::kNo;
    } else if (!IsVariable(word) || !relation.empty()) {
      result = Makes::kMaybe;  // It is compared with something else.
    }
    relation.clear();
  }
  return result;
}

/// Whether any value passes the tests.
bool IsFree(const std::string& tests) {
  return std::ranges::all_of(WordsOf(tests),
                             [](const std::string& word) { return IsVariable(word) || word == "{" || word == "}"; });
}

bool IsObjectOf(const RuleText& rule, const std::string& variable) {
  const auto is_of = [&](const RuleAttribute& attribute) { return attribute.id == variable; };
  return std::ranges::any_of(rule.conditions, is_of) || std::ranges::any_of(rule.actions, is_of);
}

/// Whether the value at this path must be an object, because other conditions of the rule test its attributes.
bool MustBeObject(const RuleText& rule, const std::vector<std::string>& path) {
  return std::ranges::any_of(
      rule.paths, [&](const auto& variable) { return variable.second == path && IsObjectOf(rule, variable.first); });
}

/// The states that a rule is about: any state, only the top state, or only substates.
enum class Level : std::uint8_t { kAny, kTop, kSub };

Level LevelOf(const RuleText& rule, const std::vector<std::string>& path) {
  if (!path.empty() && path.front() == "superstate") return Level::kAny;
  if (IsForSubstate(rule)) return Level::kSub;
  const bool is_top = std::ranges::any_of(rule.conditions, [](const RuleAttribute& condition) {
    return condition.attribute == "superstate" && !condition.negated && condition.value == "nil" && condition.on_state;
  });
  return is_top ? Level::kTop : Level::kAny;
}

bool IsOnState(const std::vector<std::string>& path) {
  return FromTop(path).size() < 2;
}

/// Whether an action makes an element with the condition's path, regardless of its value.
Makes WhetherThere(const RuleText& maker, const PathMap& paths, const RuleAttribute& action, const RuleText& rule,
                   const ConditionText& condition) {
  if (action.value.ends_with("-")) return Makes::kNo;
  const bool is_constant = IsConstantAttribute(action.attribute);
  if (is_constant && action.attribute != condition.path.back()) return Makes::kNo;
  const auto at = paths.find(action.id);
  if (at == paths.end()) return Makes::kElsewhere;
  std::vector<std::string> made = at->second;
  made.push_back(condition.path.back());
  const Level by = LevelOf(maker, made), wanted = LevelOf(rule, condition.path);
  if (IsOnState(made) != IsOnState(condition.path)) return Makes::kNo;
  if (FromTop(made) != FromTop(condition.path)) return Makes::kElsewhere;
  if (by != wanted && by != Level::kAny && wanted != Level::kAny) return Makes::kNo;
  return is_constant ? Makes::kYes : Makes::kMaybe;
}

bool IsAcceptable(const std::string& value) {
  return value == "+" || value.ends_with(" +");
}

/// The constant name that a rule tests for a proposed operator; empty if it tests none.
std::string NameAskedFor(const RuleText& rule) {
  for (const RuleAttribute& condition : rule.conditions) {
    if (condition.attribute != "operator" || condition.negated || !IsAcceptable(condition.value)) continue;
    for (const RuleAttribute& name : rule.conditions)
      if (name.id == FirstWord(condition.value) && name.attribute == "name" && IsConstant(name.value))
        return name.value;
  }
  return {};
}

}  // namespace

PathMap MadePaths(const RuleText& rule) {
  PathMap paths = rule.paths;
  for (bool grows = true; grows;) {
    grows = false;
    for (const RuleAttribute& action : rule.actions) {
      const auto from = paths.find(action.id);
      const std::string to = FirstWord(action.value);
      if (from == paths.end() || !IsVariable(to)) continue;
      std::vector<std::string> path = from->second;
      path.push_back(action.attribute);
      grows |= paths.try_emplace(to, std::move(path)).second;
    }
  }
  return paths;
}

std::vector<std::string> FromTop(const std::vector<std::string>& path) {
  const auto begin = std::ranges::find_if(path, [](const std::string& step) { return step != "superstate"; });
  return {begin, path.end()};
}

bool IsForSubstate(const RuleText& rule) {
  return std::ranges::any_of(rule.conditions, [](const RuleAttribute& condition) {
    return condition.attribute == "superstate" && !condition.negated && condition.value != "nil";
  });
}

Makes WhetherMakes(const RuleText& maker, const RuleText& rule, const ConditionText& condition) {
  const PathMap paths = MadePaths(maker);
  Makes best = Makes::kNo;
  for (const RuleAttribute& action : maker.actions) {
    Makes makes = WhetherThere(maker, paths, action, rule, condition);
    if (makes == Makes::kNo) continue;
    if (action.attribute == "operator") {
      // Rules make proposals; the decision procedure makes selections.
      if (!IsAcceptable(condition.value) || action.value.find('+') == std::string::npos) continue;
      const std::string name = NameAskedFor(rule);
      if (!name.empty() && !maker.proposes.contains(name))
        makes = maker.proposes.contains("") ? std::min(makes, Makes::kMaybe) : Makes::kNo;
      best = std::max(best, makes);
      continue;
    }
    const bool is_object = MustBeObject(rule, condition.path);
    const std::string value = action.value.starts_with('(') ? action.value : FirstWord(action.value);
    if (IsConstant(value)) {
      makes = is_object ? Makes::kNo : std::min(makes, PassesTests(value, condition.value));
    } else if (IsVariable(value) && IsObjectOf(maker, value)) {
      const std::vector<std::string> tests = WordsOf(condition.value);
      if (std::ranges::any_of(tests, IsConstant) && std::ranges::find(tests, "<>") == tests.end()) makes = Makes::kNo;
    } else if (is_object || !IsFree(condition.value)) {
      makes = std::min(makes, Makes::kMaybe);
    }
    best = std::max(best, makes);
  }
  return best;
}

std::string OtherValueBy(const RuleText& maker, const RuleText& rule, const ConditionText& condition) {
  const PathMap paths = MadePaths(maker);
  for (const RuleAttribute& action : maker.actions) {
    const std::string value = FirstWord(action.value);
    if (action.value.starts_with('(') || !IsConstant(value) || action.attribute == "operator") continue;
    if (WhetherThere(maker, paths, action, rule, condition) != Makes::kYes) continue;
    if (PassesTests(value, condition.value) == Makes::kNo) return value;
  }
  return {};
}

bool WaitsForTheSame(const RuleText& rule, const ConditionText& asked) {
  const PathMap& paths = rule.paths;
  return std::ranges::any_of(rule.conditions, [&](const RuleAttribute& condition) {
    const auto at = paths.find(condition.id);
    if (at == paths.end() || condition.negated || condition.attribute != asked.path.back()) return false;
    std::vector<std::string> tested = at->second;
    tested.push_back(condition.attribute);
    return FromTop(tested) == FromTop(asked.path) &&
           (condition.value == asked.value || IsVariable(FirstWord(condition.value)));
  });
}

bool MakesAnyAttribute(const RuleText& rule) {
  return std::ranges::any_of(rule.actions,
                             [](const RuleAttribute& action) { return !IsConstantAttribute(action.attribute); });
}

bool AsksForSelected(const RuleText& rule, const ConditionText& condition) {
  const std::vector<std::string> path = FromTop(condition.path);
  if (path.empty() || path.front() != "operator" || condition.negated) return false;
  if (path.size() == 1) return !IsAcceptable(condition.value);
  // If the rule also tests proposals, a condition on an operator's attributes may be about a proposal.
  return std::ranges::none_of(rule.conditions, [](const RuleAttribute& tested) {
    return tested.attribute == "operator" && !tested.negated && IsAcceptable(tested.value);
  });
}

bool Changes(const RuleText& rule) {
  std::set<std::string> operators, states_above, substate;
  for (const RuleAttribute& condition : rule.conditions) {
    if (condition.attribute == "operator" && !condition.negated) operators.insert(FirstWord(condition.value));
    if (condition.attribute == "superstate" && !condition.negated) {
      states_above.insert(FirstWord(condition.value));
      substate.insert(condition.id);
    }
  }
  // In a substate of an operator, what a rule adds to its own state describes only that state and disappears with it.
  const bool is_below = std::ranges::all_of(rule.conditions, [&](const RuleAttribute& condition) {
    return condition.attribute != "operator" || condition.negated || states_above.contains(condition.id);
  });
  if (!is_below) substate.clear();
  for (const RuleAttribute& action : rule.actions)
    if (substate.contains(action.id) && IsVariable(FirstWord(action.value)) &&
        !rule.paths.contains(FirstWord(action.value)))
      substate.insert(FirstWord(action.value));
  if (std::ranges::any_of(rule.calls, [](const std::string& call) { return call == "halt" || call == "interrupt"; }))
    return true;
  return std::ranges::any_of(rule.actions, [&](const RuleAttribute& action) {
    return action.attribute != "operator" && !operators.contains(action.id) && !substate.contains(action.id);
  });
}

}  // namespace soarbox::explain
