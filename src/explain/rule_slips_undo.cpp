// SPDX-License-Identifier: BSD-2-Clause
// Slips of rules that take back what they or other rules of the same operator have just made.
#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "explain/rule_makers.h"
#include "explain/rule_slips.h"
#include "explain/slip_words.h"

namespace soarbox::explain {
namespace {

using Path = std::vector<std::string>;

/// The path from the state to the values of an attribute of an object; empty if it is not known.
Path PlaceOf(const PathMap& paths, const RuleAttribute& part) {
  const auto at = paths.find(part.id);
  if (at == paths.end() || !IsConstantAttribute(part.attribute)) return {};
  Path place = at->second;
  place.push_back(part.attribute);
  return place;
}

/// Whether two rules apply a common operator.
bool ApplyTheSame(const RuleText& one, const RuleText& other) {
  if (one.applies.empty() || other.applies.empty()) return false;
  if (one.applies.contains("") || other.applies.contains("")) return true;
  return std::ranges::any_of(one.applies, [&](const std::string& name) { return other.applies.contains(name); });
}

/// The attributes and constants of its operator that a rule tests: "switch on". Of the name, only tests such as <>
/// wait, because RuleText::applies contains its constants.
std::set<std::string> OperatorTests(const RuleText& rule) {
  std::set<std::string> operators, tests;
  for (const RuleAttribute& condition : rule.conditions)
    if (condition.attribute == "operator" && condition.on_state) operators.insert(FirstWord(condition.value));
  for (const RuleAttribute& condition : rule.conditions) {
    if (!operators.contains(condition.id) || IsVariable(condition.value)) continue;
    const bool is_words = condition.value.starts_with("<<") || condition.value.find(' ') == std::string::npos;
    if (condition.attribute == "name" && is_words) continue;
    tests.insert(condition.attribute + " " + condition.value);
  }
  return tests;
}

/// Whether a rule removes any value at the place of `removal` as soon as its operator is selected: it only tests the
/// operator, the objects on the way to the value, and that there is a value.
bool RemovesAnyValue(const RuleText& rule, const RuleAttribute& removal) {
  const std::string gone = FirstWord(removal.value);
  if (!IsVariable(gone)) return false;
  std::set<std::string> needed = {removal.id};  // The objects on the way, and the operator.
  for (bool grows = true; grows;) {
    grows = false;
    for (const RuleAttribute& condition : rule.conditions)
      if (IsVariable(condition.value) && needed.contains(condition.value)) grows |= needed.insert(condition.id).second;
  }
  std::set<std::string> operators;
  for (const RuleAttribute& condition : rule.conditions)
    if (condition.attribute == "operator" && condition.on_state && IsVariable(condition.value))
      operators.insert(condition.value);
  bool is_tested = false;
  for (const RuleAttribute& condition : rule.conditions) {
    const bool is_value = condition.id == removal.id && condition.attribute == removal.attribute;
    if (condition.negated || condition.in_group || condition.id == gone) return false;
    if (is_value && condition.value == gone) {
      is_tested = true;
      continue;
    }
    // The kernel may move a comparison of the value to the condition that binds the other side.
    const std::vector<std::string> compared = VariablesIn(condition.value + " " + condition.attribute);
    if (std::ranges::find(compared, gone) != compared.end()) return false;
    const bool is_way = IsVariable(condition.value) && needed.contains(condition.value);
    const bool is_always = condition.on_state && (condition.value == "nil" || condition.attribute == "type");
    const bool is_operator = operators.contains(condition.id) || operators.contains(condition.value);
    if (!is_way && !is_always && !is_operator) return false;
  }
  return is_tested;
}

/// "(<out> ^<name> <command> -)": whether a rule removes any command, whatever its name is.
bool RemovesAnyCommand(const RuleText& rule, const RuleAttribute& removal) {
  const auto at = rule.paths.find(removal.id);
  if (!IsVariable(removal.attribute) || at == rule.paths.end() || at->second != Path{"io", "output-link"}) return false;
  // A second condition with this variable restricts the names.
  std::size_t uses = 0;
  for (const RuleAttribute& condition : rule.conditions) {
    const std::vector<std::string> used = VariablesIn(condition.attribute + " " + condition.value);
    uses += static_cast<std::size_t>(std::ranges::count(used, removal.attribute));
  }
  return uses == 1;
}

/// "^last <new>" and "^last <old> -" when the same operator applies both: the second removes what the first has added.
void FindRemovedAdditions(const RuleText& rule, const std::vector<RuleText>& rules, std::vector<Slip>& slips) {
  if (rule.applies.empty() || IsElaboration(rule)) return;
  for (const RuleAttribute& removal : rule.actions) {
    if (!removal.removes || removal.attribute == "operator") continue;
    const Path place = PlaceOf(rule.paths, removal);
    const bool is_any = place.empty() && RemovesAnyCommand(rule, removal);
    if ((place.empty() && !is_any) || !RemovesAnyValue(rule, removal)) continue;
    const auto is_there = [&](const Path& made) {
      return is_any ? made.size() == 3 && made[0] == "io" && made[1] == "output-link" : made == place;
    };
    // A rule that also adds a value replaces the old one, for example by one that is greater by 1.
    const PathMap own = MadePaths(rule);
    const bool replaces = std::ranges::any_of(
        rule.actions, [&](const RuleAttribute& action) { return !action.removes && is_there(PlaceOf(own, action)); });
    if (replaces) continue;
    for (const RuleText& other : rules) {
      if (other.name == rule.name || IsElaboration(other) || !ApplyTheSame(rule, other)) continue;
      // The two rules may apply operators of the same name with different parameters.
      if (!std::ranges::includes(OperatorTests(other), OperatorTests(rule))) continue;
      const PathMap made = MadePaths(other);
      const auto adds = std::ranges::find_if(other.actions, [&](const RuleAttribute& action) {
        return !action.removes && is_there(PlaceOf(made, action));
      });
      if (adds == other.actions.end()) continue;
      const bool is_command = is_any || (place.size() == 3 && place[0] == "io" && place[1] == "output-link");
      const std::string gone = FirstWord(removal.value), value = FirstWord(adds->value);
      slips.push_back({rule.name, removal.attribute, true,
                       "rule " + rule.name + " removes every " + (is_any ? "command" : "^" + removal.attribute) +
                           " while its operator is selected, also the " + (is_any ? "^" + adds->attribute : "one") +
                           " that rule " + other.name + " has just added",
                       is_command
                           ? "wait until the command is answered: (" + gone + " ^status)"
                           : "remove only the old one: ^" + removal.attribute + " { " + gone + " <> " +
                                 (IsVariable(value) && value != gone ? value : "<new>") +
                                 " }, with the new value bound by the operator; or test what must have happened before",
                       true});
      slips.back().undone = other.name;
      return;
    }
  }
}

/// "^next <n> - ^next <n> + 1": two values, and the old one is added again.
void FindSumsWithoutBrackets(const RuleText& rule, std::vector<Slip>& slips) {
  for (const RuleAttribute& removal : rule.actions) {
    const std::string gone = FirstWord(removal.value);
    if (!removal.removes || removal.attribute == "operator" || !IsVariable(gone)) continue;
    const auto is_same = [&](const RuleAttribute& action) {
      return !action.removes && action.id == removal.id && action.attribute == removal.attribute;
    };
    std::string number;
    bool is_added_again = false;
    for (const RuleAttribute& action : rule.actions) {
      if (!is_same(action)) continue;
      is_added_again |= FirstWord(action.value) == gone;
      if (IsNumber(action.value)) number = action.value;
    }
    if (!is_added_again || number.empty()) continue;
    slips.push_back({rule.name, removal.attribute, true,
                     "rule " + rule.name + " removes ^" + removal.attribute + " " + gone + " and adds it again, with " +
                         number + " as a second value",
                     "write a sum in brackets, with the sign first: ^" + removal.attribute + " " + gone + " - (+ " +
                         gone + " " + number + ")",
                     true});
    return;
  }
}

}  // namespace

std::vector<Slip> FindSlipsOfUndoing(const std::vector<RuleText>& rules) {
  std::vector<Slip> slips;
  for (const RuleText& rule : rules) {
    FindSumsWithoutBrackets(rule, slips);
    FindRemovedAdditions(rule, rules, slips);
  }
  return slips;
}

}  // namespace soarbox::explain
