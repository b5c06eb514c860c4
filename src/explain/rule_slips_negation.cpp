// SPDX-License-Identifier: BSD-2-Clause
// Slips in conditions that are about an absent element or an absent value, and do not say what they are meant to say.
#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "explain/rule_makers.h"
#include "explain/rule_slips.h"
#include "explain/slip_words.h"

namespace soarbox::explain {
namespace {

/// The variables that a rule binds to operators, or makes as operators.
std::set<std::string> OperatorsOf(const RuleText& rule) {
  std::set<std::string> operators;
  for (const auto* parts : {&rule.conditions, &rule.actions})
    for (const RuleAttribute& part : *parts)
      if (part.attribute == "operator")
        for (std::string& variable : VariablesIn(part.value)) operators.insert(std::move(variable));
  return operators;
}

/// Whether a rule tests or makes an attribute of something other than an operator.
bool HasElsewhere(const RuleText& rule, const std::string& attribute) {
  const std::set<std::string> operators = OperatorsOf(rule);
  const auto is_elsewhere = [&](const RuleAttribute& part) {
    return part.attribute == attribute && !part.negated && !operators.contains(part.id);
  };
  return std::ranges::any_of(rule.conditions, is_elsewhere) || std::ranges::any_of(rule.actions, is_elsewhere);
}

/// "(<o> ^name look-up ^letter <l> -^urgent yes)" when no rule gives an operator ^urgent: it always holds.
void FindAlwaysAbsent(const std::vector<RuleText>& rules, std::vector<Slip>& slips) {
  std::set<std::string> made;  // Attributes of operators.
  for (const RuleText& rule : rules) {
    const std::set<std::string> operators = OperatorsOf(rule);
    for (const RuleAttribute& action : rule.actions) {
      if (action.removes) continue;
      if (IsVariable(action.attribute)) return;
      if (operators.contains(action.id)) made.insert(action.attribute);
    }
    // An operator may also be the value of another attribute, for example of ^item.
    for (const RuleAttribute& condition : rule.conditions)
      if (condition.attribute != "operator" && operators.contains(condition.value)) return;
  }
  for (const RuleText& rule : rules) {
    const std::set<std::string> operators = OperatorsOf(rule);
    for (const RuleAttribute& condition : rule.conditions) {
      const std::string& attribute = condition.attribute;
      if (!condition.negated || condition.in_group || !operators.contains(condition.id)) continue;
      if (!IsConstantAttribute(attribute) || made.contains(attribute)) continue;
      const auto other = std::ranges::find_if(rules, [&](const RuleText& one) { return HasElsewhere(one, attribute); });
      if (other == rules.end()) continue;
      slips.push_back({rule.name, attribute, true,
                       "rule " + rule.name + " tests -^" + attribute +
                           " of its operator, and no rule gives an operator ^" + attribute +
                           ": the condition always holds",
                       "rule " + other->name + " has ^" + attribute + " of another object: test that object"});
    }
  }
}

/// Whether a part of a rule is about a state.
bool IsOfState(const RuleText& rule, const RuleAttribute& part) {
  const auto at = rule.paths.find(part.id);
  return at != rule.paths.end() && at->second.empty();
}

/// Whether all rules that make an attribute of a state give it a name that they perceive or know: "^danger <name>" with
/// "(<a> ^name <name>)". `example`: one of them.
bool IsAlwaysName(const std::vector<RuleText>& rules, const std::string& attribute, const RuleText*& example) {
  for (const RuleText& rule : rules) {
    for (const RuleAttribute& action : rule.actions) {
      if (action.removes) continue;
      if (IsVariable(action.attribute)) return false;
      if (action.attribute != attribute || !IsOfState(rule, action)) continue;
      const bool is_name =
          IsVariable(action.value) && std::ranges::any_of(rule.conditions, [&](const RuleAttribute& condition) {
            return condition.attribute == "name" && !condition.negated && condition.value == action.value;
          });
      if (!is_name) return false;
      example = &rule;
    }
  }
  return example != nullptr;
}

/// "^danger yes" and "-^danger yes" when rules make ^danger the name of something.
void FindYesForNames(const std::vector<RuleText>& rules, std::vector<Slip>& slips) {
  for (const RuleText& rule : rules) {
    for (const RuleAttribute& condition : rule.conditions) {
      const bool is_yes = condition.value == "yes" || condition.value == "no";
      if (!is_yes || condition.in_group || !IsOfState(rule, condition)) continue;
      const RuleText* maker = nullptr;
      if (IsArchitectureAttribute(condition.attribute) || !IsAlwaysName(rules, condition.attribute, maker)) continue;
      const std::string tested = "^" + condition.attribute + " " + condition.value;
      slips.push_back({rule.name, condition.attribute, true,
                       "rule " + rule.name + " tests " + (condition.negated ? "-" : "") + tested + ", but rule " +
                           maker->name + " makes ^" + condition.attribute + " a name, never " + condition.value +
                           ": the condition " + (condition.negated ? "always holds" : "never holds"),
                       condition.negated ? "to test that there is none, leave the value out: -^" + condition.attribute
                                         : "to test that there is one, leave the value out: ^" + condition.attribute});
    }
  }
}

}  // namespace

std::vector<Slip> FindSlipsOfNegation(const std::vector<RuleText>& rules) {
  std::vector<Slip> slips;
  FindAlwaysAbsent(rules, slips);
  FindYesForNames(rules, slips);
  return slips;
}

}  // namespace soarbox::explain
