// SPDX-License-Identifier: BSD-2-Clause
#include "explain/rule_text.h"

#include <algorithm>
#include <cctype>
#include <utility>

#include "explain/rule_from_facts.h"
#include "rule_reading/rule_reading.h"

namespace soarbox::explain {
namespace {

/// Splits a text into words. Text between bars is one word.
std::vector<std::string> WordsIn(std::string_view text) {
  std::vector<std::string> words;
  for (std::size_t i = text.find_first_not_of(' '); i < text.size(); i = text.find_first_not_of(' ', i)) {
    const std::size_t begin = i;
    for (bool quoted = false; i < text.size() && (quoted || text[i] != ' '); ++i) {
      if (text[i] == '\\' && quoted) {
        ++i;
      } else if (text[i] == '|') {
        quoted = !quoted;
      }
    }
    i = std::min(i, text.size());
    words.emplace_back(text.substr(begin, i - begin));
  }
  return words;
}

RuleAttribute AttributeOf(const mind::RuleConditionFact& fact) {
  RuleAttribute condition;
  condition.id = fact.id;
  condition.attribute = fact.attribute;
  condition.value = fact.value;
  if (fact.acceptable) condition.value += condition.value.empty() ? "+" : " +";
  condition.negated = fact.negated;
  condition.on_state = fact.on_state;
  condition.in_group = fact.group > 0;
  return condition;
}

/// Converts "(+ <n> 1)" to "( + <n> 1 )", so that each bracket is a word. Brackets between bars are not changed.
std::string WithBracketsApart(const std::string& call) {
  std::string text;
  bool quoted = false;
  for (std::size_t i = 0; i < call.size(); ++i) {
    const char c = call[i];
    if (c == '\\' && quoted) {
      text += c;
      if (++i < call.size()) text += call[i];
      continue;
    }
    if (c == '|') quoted = !quoted;
    if (c == ')' && !quoted) text += ' ';
    text += c;
    if (c == '(' && !quoted) text += ' ';
  }
  return text;
}

RuleAttribute AttributeOf(const mind::RuleActionFact& fact) {
  RuleAttribute action;
  action.id = fact.id;
  action.attribute = fact.attribute;
  action.value = fact.value.starts_with('(') ? WithBracketsApart(fact.value) : fact.value;
  // The sign + is written only for operators.
  if (fact.attribute == "operator" || fact.sign != "+") action.value += " " + fact.sign;
  if (!fact.referent.empty())
    action.value += " " + (fact.referent.starts_with('(') ? WithBracketsApart(fact.referent) : fact.referent);
  action.removes = fact.sign == "-" && fact.referent.empty();
  return action;
}

/// The constants that a name test allows: one, those of << a b >>, or "" for any other test.
std::set<std::string> NamesOf(const std::string& value) {
  if (value.empty()) return {""};
  if (value.find("<<") != std::string::npos) {
    std::set<std::string> names;
    std::string_view rest = value;
    rest.remove_prefix(rest.find("<<") + 2);
    for (std::string& word : WordsIn(rest.substr(0, rest.find(">>")))) names.insert(std::move(word));
    return names;
  }
  const std::string first = FirstWord(value);
  if (IsVariable(first) || first == "{" || first == "<>" || first == "(") return {""};
  return {first};
}

void Classify(RuleText& rule) {
  std::set<std::string> outputs;
  for (const RuleAttribute& condition : rule.conditions) {
    if (condition.attribute == "output-link" && !condition.negated) outputs.insert(FirstWord(condition.value));
  }
  for (const RuleAttribute& action : rule.actions) {
    if (outputs.contains(action.id) && !action.removes) rule.says.insert(action.attribute);
    if (action.attribute != "operator" || action.value.find('+') == std::string::npos) continue;
    const std::string id = FirstWord(action.value);
    bool named = false;
    for (const RuleAttribute& name : rule.actions) {
      if (name.id != id || name.attribute != "name") continue;
      const std::set<std::string> names = NamesOf(name.value);
      rule.proposes.insert(names.begin(), names.end());
      named = true;
    }
    if (!named) rule.proposes.insert("");
  }
  std::set<std::string> states;
  for (const RuleAttribute& condition : rule.conditions)
    if (condition.on_state) states.insert(condition.id);
  for (const RuleAttribute& condition : rule.conditions) {
    if (condition.attribute != "operator" || condition.negated) continue;
    if (condition.value.ends_with(" +") || condition.value == "+") continue;
    const bool is_above = !states.contains(condition.id) && !rule.proposes.empty();
    std::set<std::string>& tested = is_above ? rule.works_on : rule.applies;
    const std::string id = FirstWord(condition.value);
    bool named = false;
    for (const RuleAttribute& name : rule.conditions) {
      if (name.id != id || name.attribute != "name" || name.negated) continue;
      const std::set<std::string> names = NamesOf(name.value);
      tested.insert(names.begin(), names.end());
      named = true;
    }
    if (!named) tested.insert("");
  }
}

}  // namespace

bool IsIdentifier(std::string_view value) {
  return value.size() > 1 && std::isupper(static_cast<unsigned char>(value[0])) != 0 &&
         value.find_first_not_of("0123456789", 1) == std::string_view::npos;
}

std::string Dotted(const std::vector<std::string>& path) {
  std::string text = "^";
  for (std::size_t i = 0; i < path.size(); ++i) text += (i == 0 ? "" : ".") + path[i];
  return text;
}

std::string FirstWord(const std::string& value) {
  if (!value.starts_with('|')) return value.substr(0, value.find(' '));
  std::size_t end = 1;
  while (end < value.size() && value[end] != '|') end += value[end] == '\\' ? 2 : 1;
  return value.substr(0, end + 1);
}

bool IsVariable(std::string_view word) {
  return word.size() > 2 && word.front() == '<' && word.back() == '>' && word[1] != '<' && word != "<=>";
}

std::vector<std::string> VariablesIn(std::string_view text) {
  std::vector<std::string> found;
  for (std::size_t at = text.find('<'); at != std::string_view::npos; at = text.find('<', at + 1)) {
    std::size_t end = at + 1;
    while (end < text.size() && (std::isalnum(static_cast<unsigned char>(text[end])) != 0 || text[end] == '-' ||
                                 text[end] == '_' || text[end] == '*'))
      ++end;
    if (end > at + 1 && end < text.size() && text[end] == '>') found.emplace_back(text.substr(at, end + 1 - at));
  }
  return found;
}

bool IsMadeUpVariable(std::string_view variable) {
  const std::size_t star = variable.rfind('*');
  return star != std::string_view::npos && star + 2 < variable.size() &&
         variable.find_first_not_of("0123456789", star + 1) == variable.size() - 1;
}

bool IsElaboration(const RuleText& rule) {
  if (rule.support != RuleSupport::kByConditions) return rule.support == RuleSupport::kISupport;
  return std::ranges::none_of(rule.conditions, [&](const RuleAttribute& condition) {
    if (condition.attribute != "operator" || condition.negated || condition.value.ends_with('+')) return false;
    // A rule that tests the operator of the superstate elaborates its own state.
    const auto path = rule.paths.find(condition.id);
    return path == rule.paths.end() || path->second.empty();
  });
}

bool IsConstantAttribute(std::string_view attribute) {
  return !attribute.empty() && attribute[0] != '<' && attribute[0] != '{' && attribute[0] != '>' && attribute[0] != '=';
}

bool IsArchitectureAttribute(std::string_view attribute) {
  static const std::set<std::string_view> known = {
      "superstate", "io", "input-link", "output-link", "operator", "type", "name", "attribute", "choices", "impasse",
      "quiescence", "record", "params", "child", "item", "item-count", "non-numeric", "non-numeric-count",
      "reward-link", "smem", "epmem", "command", "result", "svs", "status", "reason", "parameter", "progress", "reward",
      "value", "present-id", "spatial-scene",
      // Attributes of answers of memories.
      "retrieved", "success", "failure", "bad-cmd", "memory-id", "match-score", "cue-size", "normalized-match-score",
      "match-cardinality", "graph-match", "mapping", "node", "cue"};
  return known.contains(attribute);
}

bool TestsWhatWasRecalled(const RuleText& rule) {
  return std::ranges::any_of(rule.conditions, [](const RuleAttribute& one) { return one.attribute == "retrieved"; });
}

std::string BlankComments(std::string text) {
  bool quoted = false, comment = false;
  for (char& c : text) {
    if (c == '\n') comment = quoted = false;
    if (comment) {
      c = ' ';
    } else if (c == '|') {
      quoted = !quoted;
    } else if (c == '#' && !quoted) {
      comment = true;
      c = ' ';
    }
  }
  return text;
}

std::vector<RuleAttribute> ReadConditions(std::string_view text) {
  std::vector<RuleAttribute> conditions;
  for (const mind::RuleConditionFact& fact : rule_reading::ReadPrintedConditions(text))
    conditions.push_back(AttributeOf(fact));
  return conditions;
}

namespace {

PathMap VariablePaths(const RuleText& rule) {
  PathMap paths;
  for (const RuleAttribute& condition : rule.conditions)
    if (condition.on_state) paths.try_emplace(condition.id);
  for (bool grows = true; grows;) {
    grows = false;
    for (const RuleAttribute& condition : rule.conditions) {
      const auto from = paths.find(condition.id);
      if (from == paths.end()) continue;
      // <x>, or { <x> <> ... }. A variable after a relation is bound elsewhere.
      std::string first = condition.value.substr(condition.value.starts_with("{ ") ? 2 : 0);
      first = first.substr(0, first.find(' '));
      if (!IsVariable(first)) continue;
      std::vector<std::string> path = from->second;
      path.push_back(condition.attribute);
      grows |= paths.try_emplace(first, std::move(path)).second;
    }
  }
  return paths;
}

}  // namespace

RuleText TextOf(const mind::RuleFacts& facts) {
  RuleText rule;
  rule.name = facts.name;
  rule.acts = facts.acts;
  rule.is_template = facts.is_template;
  using Support = mind::RuleFacts::Support;
  if (facts.support == Support::kOSupport) rule.support = RuleSupport::kOSupport;
  if (facts.support == Support::kISupport) rule.support = RuleSupport::kISupport;
  for (const mind::RuleConditionFact& fact : facts.conditions) rule.conditions.push_back(AttributeOf(fact));
  for (const mind::RuleActionFact& fact : facts.actions) rule.actions.push_back(AttributeOf(fact));
  for (const mind::RuleCallFact& fact : facts.calls) {
    rule.all_calls.push_back({fact.function, fact.arguments});
    rule.calls.insert(fact.function);
    // A function that is not built in is parsed as the first argument of exec.
    if (fact.function == "exec" && !fact.arguments.empty()) rule.calls.insert("exec " + fact.arguments.front());
  }
  Classify(rule);
  rule.paths = VariablePaths(rule);
  return rule;
}

std::vector<RuleText> ReadRules(std::string_view text) {
  std::vector<RuleText> rules;
  for (const mind::RuleFacts& facts : rule_reading::ReadPrintedRules(text)) rules.push_back(TextOf(facts));
  return rules;
}

bool ProposesWithoutName(const RuleText& rule) {
  return std::ranges::any_of(rule.actions, [&](const RuleAttribute& proposal) {
    const std::string id = FirstWord(proposal.value);
    return proposal.attribute == "operator" && proposal.value.find('+') != std::string::npos && IsVariable(id) &&
           std::ranges::none_of(rule.conditions,
                                [&](const RuleAttribute& condition) { return FirstWord(condition.value) == id; }) &&
           std::ranges::none_of(rule.actions, [&](const RuleAttribute& action) {
             return action.id == id && (action.attribute == "name" || !IsConstantAttribute(action.attribute));
           });
  });
}

}  // namespace soarbox::explain
