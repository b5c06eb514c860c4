// SPDX-License-Identifier: BSD-2-Clause
// Slips in how rules work together: values that are repeatedly added and removed, paths to different objects, values
// that no rule makes, applications that cannot fire.
#include <algorithm>
#include <cctype>
#include <cstdint>
#include <map>
#include <utility>

#include "diagnostics/diagnostic.h"
#include "explain/mind_view.h"
#include "explain/rule_makers.h"
#include "explain/rule_slips.h"
#include "explain/slip_words.h"

namespace soarbox::explain {
namespace {

using Path = std::vector<std::string>;

/// A constant of a rule without bars; empty for anything else.
std::string ConstantIn(const std::string& value) {
  if (value.size() > 2 && value.front() == '|' && value.find('|', 1) == value.size() - 1)
    return value.substr(1, value.size() - 2);
  if (value.empty() || value.find_first_of(" <>{}()|") != std::string::npos) return {};
  return value;
}

bool IsBoundPositively(const RuleText& rule, const std::string& variable) {
  return std::ranges::any_of(rule.conditions, [&](const RuleAttribute& condition) {
    if (condition.negated) return false;
    if (condition.id == variable) return true;
    const std::vector<std::string> bound = VariablesIn(condition.value), named = VariablesIn(condition.attribute);
    return std::ranges::find(bound, variable) != bound.end() || std::ranges::find(named, variable) != named.end();
  });
}

/// The value of an action, without preference signs; empty for calls of functions.
std::string MadeValue(const RuleAttribute& action) {
  if (action.value.starts_with('(')) return {};
  if (action.value.starts_with('|')) return action.value.substr(0, action.value.find('|', 1) + 1);
  return FirstWord(action.value);
}

/// Whether adding a value makes this negated condition false for the match that added it.
bool Contradicts(const RuleText& rule, const RuleAttribute& absent, const RuleAttribute& made) {
  const std::string value = MadeValue(made), tested = absent.value;
  if (tested.empty()) return true;
  if (IsVariable(tested)) return value == tested || !IsBoundPositively(rule, tested);
  if (tested.starts_with("<> ")) {
    const std::string not_this = tested.substr(3);
    return !value.empty() && !IsVariable(value) && !IsVariable(not_this) && value != not_this;
  }
  return !value.empty() && value == tested;
}

/// "-^danger --> ^danger no": without an operator, the rule removes the reason for its own match.
void FindBlinking(const RuleText& rule, std::vector<Slip>& slips) {
  if (!IsElaboration(rule)) return;
  for (const RuleAttribute& absent : rule.conditions) {
    if (!absent.negated || absent.in_group || absent.attribute == "operator") continue;
    if (!IsConstantAttribute(absent.attribute) || !IsBoundPositively(rule, absent.id)) continue;
    for (const RuleAttribute& made : rule.actions) {
      if (made.id != absent.id || made.attribute != absent.attribute || made.removes) continue;
      if (!Contradicts(rule, absent, made)) continue;
      slips.push_back(
          {rule.name, absent.attribute, true,
           "rule " + rule.name + " makes the ^" + absent.attribute +
               " that it tests as absent: it no longer matches, ^" + absent.attribute +
               " goes, it matches again, without end",
           "let an operator make it, which stays: test the selected operator, ^operator.name ...; or test as absent "
           "what leads to ^" +
               absent.attribute + ", not ^" + absent.attribute + " itself"});
      return;
    }
  }
}

/// "^next <n> --> ^next <n> - (+ <n> 1)" without an operator: the removed value comes back when the rule is retracted.
void FindCounting(const RuleText& rule, std::vector<Slip>& slips) {
  if (!IsElaboration(rule)) return;
  for (const RuleAttribute& removal : rule.actions) {
    if (!removal.removes || removal.attribute == "operator") continue;
    const std::string gone = MadeValue(removal);
    for (const RuleAttribute& tested : rule.conditions) {
      if (tested.negated || tested.id != removal.id || tested.attribute != removal.attribute) continue;
      const std::vector<std::string> bound = VariablesIn(tested.value);
      if (tested.value != gone && std::ranges::find(bound, gone) == bound.end()) continue;
      const std::string name = IsConstantAttribute(tested.attribute) ? "^" + tested.attribute : tested.attribute;
      slips.push_back({rule.name, tested.attribute, true,
                       "rule " + rule.name + " removes the " + name +
                           " that it tests, and tests no selected operator: it no longer matches, the value comes "
                           "back, it matches again, without end",
                       "let an operator do it: propose one, and test it here, ^operator.name ...", true});
      return;
    }
  }
}

/// Percepts that an agent can have several times.
bool IsPerceptOfMany(const Path& path) {
  constexpr std::string_view kMany[] = {"agent", "object", "waypoint", "region", "message"};
  return path.size() == 3 && path[0] == "io" && path[1] == "input-link" &&
         std::ranges::find(kMany, path[2]) != std::end(kMany);
}

/// Whether a rule may match for each of several percepts, and uses a value of the percept in an action.
bool FiresForEach(const RuleText& rule) {
  std::set<std::string> used;
  for (const RuleAttribute& action : rule.actions)
    for (std::string& variable : VariablesIn(action.value)) used.insert(std::move(variable));
  return std::ranges::any_of(rule.conditions, [&](const RuleAttribute& condition) {
    const auto path = rule.paths.find(condition.id);
    return !condition.negated && path != rule.paths.end() && IsPerceptOfMany(path->second) &&
           used.contains(condition.value);
  });
}

/// The paths from the state at which rules create several objects with the same attribute.
std::set<Path> PlacesOfMany(const std::vector<RuleText>& rules) {
  std::set<Path> many;
  for (const RuleText& rule : rules) {
    const PathMap paths = MadePaths(rule);
    std::map<std::pair<std::string, std::string>, std::string> made;
    for (const RuleAttribute& action : rule.actions) {
      const std::string value = MadeValue(action);
      const auto at = paths.find(action.id);
      if (at == paths.end() || action.removes || action.attribute == "operator" || !IsVariable(value)) continue;
      if (!IsConstantAttribute(action.attribute) || IsBoundByConditions(rule, value)) continue;
      Path place = FromTop(at->second);
      place.push_back(action.attribute);
      const auto [first, is_new] = made.try_emplace({action.id, action.attribute}, value);
      const bool several = !is_new && first->second != value;
      if (several || (IsBoundPositively(rule, action.id) && FiresForEach(rule))) many.insert(std::move(place));
    }
  }
  return many;
}

/// "^plan.cart <cart> ^plan.place <place>" with several ^plan: the two paths may lead to different plans.
void FindPartedOwnPaths(const RuleText& rule, const std::set<Path>& many, std::vector<Slip>& slips) {
  struct Branch {
    std::string variable, next;
  };
  std::map<Path, std::vector<Branch>> branches;
  for (const RuleAttribute& condition : rule.conditions) {
    const auto path = rule.paths.find(condition.id);
    if (path == rule.paths.end() || path->second.empty() || condition.negated) continue;
    if (!IsMadeUpVariable(condition.id) || !many.contains(FromTop(path->second))) continue;
    std::vector<Branch>& here = branches[path->second];
    if (std::ranges::none_of(here, [&](const Branch& one) { return one.variable == condition.id; }))
      here.push_back({condition.id, condition.attribute});
  }
  for (const auto& [path, parted] : branches) {
    if (parted.size() < 2 || parted[0].next == parted[1].next) continue;
    const std::string& last = path.back();
    const std::string variable = "<" + last.substr(0, 1) + ">";
    slips.push_back({rule.name, last, true,
                     "rule " + rule.name + " tests ^" + parted[0].next + " and ^" + parted[1].next + " of " +
                         Dotted(path) + " on two paths: there are several ^" + last +
                         ", and each path may lead to another one",
                     "bind one: ^" + last + " " + variable + ") (" + variable + " ^" + parted[0].next + " ... ^" +
                         parted[1].next + " ...)"});
  }
}

/// The values that rules make for an attribute: numbers, and words in bars.
struct MadeKinds {
  bool numbers = false, others = false;
};

/// "^next |3|" when rules make ^next 1 and (+ <n> 1): the word 3 is not the number.
void FindNumbersInBars(const std::vector<RuleText>& rules, std::vector<Slip>& slips) {
  std::map<std::string, MadeKinds> made;
  constexpr std::string_view kArithmetic[] = {"+", "-", "*", "/", "div", "mod", "int", "float", "abs", "rand-int"};
  for (const RuleText& rule : rules) {
    for (const RuleAttribute& action : rule.actions) {
      if (action.removes) continue;
      MadeKinds& kinds = made[action.attribute];
      const std::string value = MadeValue(action);
      if (IsNumber(value)) {
        kinds.numbers = true;
      } else if (value.empty()) {
        const std::size_t name = action.value.find_first_not_of(" (");
        const std::string function = name == std::string::npos ? std::string() : FirstWord(action.value.substr(name));
        (std::ranges::find(kArithmetic, function) != std::end(kArithmetic) ? kinds.numbers : kinds.others) = true;
      } else if (value.starts_with('|') || !IsBoundByConditions(rule, value)) {
        kinds.others = true;
      }
    }
  }
  for (const RuleText& rule : rules) {
    for (const RuleAttribute& condition : rule.conditions) {
      const std::string& value = condition.value;
      if (!value.starts_with('|') || !IsNumber(ConstantIn(value))) continue;
      const auto kinds = made.find(condition.attribute);
      if (kinds == made.end() || !kinds->second.numbers || kinds->second.others) continue;
      slips.push_back({rule.name, value, false,
                       "rule " + rule.name + " tests that ^" + condition.attribute + " is " + value +
                           ", which is a word: the rules give numbers to ^" + condition.attribute +
                           ", so that this never matches",
                       "write the number without bars: " + ConstantIn(value)});
    }
  }
}

/// "(<out> ^move.direction <direction>)" with an unbound <direction>: an object without attributes.
void FindEmptyParameters(const RuleText& rule, const std::vector<RuleText>& rules, std::vector<Slip>& slips) {
  const PathMap paths = MadePaths(rule);
  std::set<std::string> operators;
  for (const RuleAttribute& action : rule.actions)
    if (action.attribute == "operator" && !action.removes) operators.insert(MadeValue(action));
  for (const RuleAttribute& action : rule.actions) {
    const std::string variable = MadeValue(action);
    if (!IsVariable(variable) || IsMadeUpVariable(variable) || paths.find(action.id) == paths.end()) continue;
    if (action.removes || !IsConstantAttribute(action.attribute) || IsBoundPositively(rule, variable)) continue;
    // If only a negated condition binds it, that is reported instead.
    const bool is_negated = std::ranges::any_of(rule.conditions, [&](const RuleAttribute& condition) {
      const std::vector<std::string> used = VariablesIn(condition.value);
      return std::ranges::find(used, variable) != used.end();
    });
    if (is_negated) continue;
    const Path& at = paths.at(action.id);
    const bool is_command = at.size() > 2 && at[at.size() - 2] == "output-link";
    if (!is_command && !operators.contains(action.id)) continue;
    // Another rule may add attributes.
    const bool has_content =
        std::ranges::any_of(rule.actions, [&](const RuleAttribute& other) { return other.id == variable; }) ||
        std::ranges::any_of(rules, [&](const RuleText& other) {
          return std::ranges::any_of(other.conditions, [&](const RuleAttribute& condition) {
            return condition.attribute == action.attribute && IsVariable(condition.value) &&
                   std::ranges::any_of(other.actions,
                                       [&](const RuleAttribute& made) { return made.id == condition.value; });
          });
        });
    const bool is_told =
        std::ranges::any_of(slips, [&](const Slip& slip) { return slip.rule == rule.name && slip.word == variable; });
    if (has_content || is_told) continue;
    slips.push_back({rule.name, variable, false,
                     "no condition of rule " + rule.name + " binds " + variable + ": ^" + action.attribute +
                         " of its " + (is_command ? "command" : "operator") + " becomes a new, empty object",
                     is_command ? "bind it in a condition, as a value of what you know: (<o> ^" + action.attribute +
                                      " " + variable + ")"
                                : "bind it in a condition that has its value",
                     true});
  }
}

/// An index of the variables of a rule, for finding similar ones without comparing all.
class SimilarVariables {
 public:
  explicit SimilarVariables(const std::map<std::string, int>& count) : count_(count) {
    for (const auto& [variable, number] : count)
      if (!IsMadeUpVariable(variable))
        for (std::string& shorter : WithoutOneLetter(variable)) longer_[std::move(shorter)].push_back(variable);
  }

  /// Similar variables: "<plac>" and "<place>", where one letter is missing in one of them. Variables that differ in
  /// digits or have one letter are considered intentional.
  std::set<std::string> ByOneLetter(const std::string& variable) const {
    std::set<std::string> found;
    if (const auto longer = longer_.find(variable); longer != longer_.end() && variable.size() >= kLeastSize)
      found.insert(longer->second.begin(), longer->second.end());
    for (const std::string& shorter : WithoutOneLetter(variable))
      if (shorter.size() >= kLeastSize && count_.contains(shorter) && !IsMadeUpVariable(shorter)) found.insert(shorter);
    return found;
  }

  /// Longer variables with this prefix: "<kind>" for "<k>".
  std::vector<std::string> ThatBeginWith(const std::string& variable) const {
    const std::string begin = variable.substr(0, variable.size() - 1);
    std::vector<std::string> found;
    for (auto at = count_.lower_bound(begin); at != count_.end() && at->first.starts_with(begin); ++at)
      if (at->first.size() > variable.size() && !IsMadeUpVariable(at->first)) found.push_back(at->first);
    return found;
  }

 private:
  static constexpr std::size_t kLeastSize = 4;  ///< Including the brackets.

  static std::vector<std::string> WithoutOneLetter(const std::string& variable) {
    std::vector<std::string> all;
    for (std::size_t i = 1; i + 1 < variable.size(); ++i)
      if (std::isalpha(static_cast<unsigned char>(variable[i])) != 0)
        all.push_back(variable.substr(0, i) + variable.substr(i + 1));
    return all;
  }

  const std::map<std::string, int>& count_;
  std::map<std::string, std::vector<std::string>> longer_;  ///< By the name without one letter.
};

/// Finds variables that occur once and are probably another variable of the rule: "<plac>" and <place>, or ^kind <k>
/// and ^kind <kind>.
void FindSingleVariables(const RuleText& rule, std::vector<Slip>& slips) {
  std::map<std::string, int> count;
  std::map<std::string, std::string> attribute_of;
  const auto add = [&](const std::string& text) {
    for (const std::string& variable : VariablesIn(text)) ++count[variable];
  };
  for (const auto* side : {&rule.conditions, &rule.actions}) {
    std::set<std::string> ids;
    for (const RuleAttribute& one : *side) {
      // The identifier of a clause counts once, even if the clause has several attributes.
      if (ids.insert(one.id).second) add(one.id);
      add(one.attribute);
      add(one.value);
      if (side == &rule.conditions && !one.negated && IsVariable(one.value)) attribute_of[one.value] = one.attribute;
    }
  }
  for (const RuleCall& call : rule.all_calls)
    for (const std::string& argument : call.arguments) add(argument);
  const SimilarVariables similar(count);
  for (const auto& [variable, number] : count) {
    const auto at = attribute_of.find(variable);
    if (number != 1 || at == attribute_of.end() || IsMadeUpVariable(variable)) continue;
    const std::string& attribute = at->second;
    std::set<std::string> meant = similar.ByOneLetter(variable);
    // <k> for <kind>, if both occur once and are values of the same attribute.
    for (const std::string& other : similar.ThatBeginWith(variable)) {
      const auto its = attribute_of.find(other);
      if (count.at(other) == 1 && its != attribute_of.end() && its->second == attribute) meant.insert(other);
    }
    if (meant.empty()) continue;
    const std::string& other = *meant.begin();
    slips.push_back({rule.name, variable, false,
                     "rule " + rule.name + " uses " + variable + " once, as ^" + attribute + ", and " + other +
                         " beside it: two variables need not be the same value",
                     "did you mean " + other + "? The same variable twice is the same value"});
  }
}

/// The kind of state in which a rule's own operator is.
enum class OperatorLevel : std::uint8_t { kAny, kTop, kSub };

/// "(state <s> ^superstate nil)" for the state itself.
bool IsForTheTop(const RuleText& rule) {
  return std::ranges::any_of(rule.conditions, [](const RuleAttribute& condition) {
    return condition.on_state && condition.attribute == "superstate" && !condition.negated && condition.value == "nil";
  });
}

/// Returns the kind of state that a rule is about. Callers check that the rule's operators belong to its own state.
OperatorLevel LevelOf(const RuleText& rule) {
  if (IsForTheTop(rule)) return OperatorLevel::kTop;
  const bool is_below = std::ranges::any_of(rule.conditions, [](const RuleAttribute& condition) {
    return condition.on_state && !condition.negated &&
           ((condition.attribute == "superstate" && IsVariable(condition.value)) || condition.attribute == "impasse");
  });
  return is_below ? OperatorLevel::kSub : OperatorLevel::kAny;
}

/// Whether all operators that a rule proposes or tests as selected belong to its own state.
bool IsOwnOperator(const RuleText& rule, const std::vector<RuleAttribute>& side) {
  return std::ranges::all_of(side, [&](const RuleAttribute& one) {
    if (one.attribute != "operator" || one.negated) return true;
    const auto path = rule.paths.find(one.id);
    return path != rule.paths.end() && path->second.empty();
  });
}

/// Finds operators that are proposed only at the top and applied only in a substate, or the reverse, so that the
/// application never fires.
void FindAppliedElsewhere(const std::vector<RuleText>& rules, std::vector<Slip>& slips) {
  for (const RuleText& rule : rules) {
    const OperatorLevel applied = LevelOf(rule);
    if (rule.applies.size() != 1 || rule.applies.contains("") || applied == OperatorLevel::kAny) continue;
    if (!rule.proposes.empty() || !IsOwnOperator(rule, rule.conditions)) continue;
    const std::string& name = *rule.applies.begin();
    OperatorLevel proposed = OperatorLevel::kAny;
    bool is_known = true;
    for (const RuleText& other : rules) {
      is_known &= !other.proposes.contains("");
      if (!other.proposes.contains(name)) continue;
      const OperatorLevel level = IsOwnOperator(other, other.actions) ? LevelOf(other) : OperatorLevel::kAny;
      is_known &= level != OperatorLevel::kAny && (proposed == OperatorLevel::kAny || proposed == level);
      proposed = level;
    }
    if (!is_known || proposed == OperatorLevel::kAny || proposed == applied) continue;
    const bool is_top = proposed == OperatorLevel::kTop;
    slips.push_back({rule.name, "operator", true,
                     "rule " + rule.name + " never matches: " + name + " is proposed " +
                         (is_top ? "at the top state alone, and the rule tests the operator of a substate"
                                 : "in substates alone, and the rule tests the operator of the top state"),
                     is_top ? "test the operator of the state above: ^superstate.operator.name " + name
                            : "leave ^superstate nil out, and reach the state above by ^superstate"});
  }
}

/// "^operator <o> +" in a rule that gives a command: the command is given while the operator is only proposed.
void FindActingProposals(const RuleText& rule, const std::vector<RuleText>& rules, std::vector<Slip>& slips) {
  if (rule.says.empty() || !rule.applies.empty() || !rule.works_on.empty()) return;
  for (const RuleAttribute& tested : rule.conditions) {
    if (tested.attribute != "operator" || tested.negated || !tested.value.ends_with('+')) continue;
    const std::string id = FirstWord(tested.value);
    std::string name;
    for (const RuleAttribute& condition : rule.conditions)
      if (condition.id == id && condition.attribute == "name" && !condition.negated) name = ConstantIn(condition.value);
    // If no rule applies it, that is reported at its proposal.
    const bool is_applied = std::ranges::any_of(
        rules, [&](const RuleText& other) { return other.applies.contains(name) || other.applies.contains(""); });
    if (name.empty() || !is_applied) continue;
    slips.push_back({rule.name, "operator", true,
                     "rule " + rule.name + " gives a command for " + name + " while it is only proposed: ^operator " +
                         id + " + tests a proposal",
                     "without the + it tests the operator that is selected: ^operator " + id});
    return;
  }
}

/// "(<s> ^superstate.holds soup)" and "^superstate <above>": a path in an action creates a new object.
void FindPathsInActions(const RuleText& rule, std::vector<Slip>& slips) {
  for (const RuleAttribute& action : rule.actions) {
    const std::string made = MadeValue(action);
    if (!IsMadeUpVariable(made) || IsBoundPositively(rule, made) || action.removes) continue;
    if (action.attribute == "io" || action.attribute == "reward-link" || action.attribute == "smem" ||
        action.attribute == "epmem" || action.attribute == "operator")
      continue;  // Reported together with its consequences.
    const auto at = rule.paths.find(action.id);
    const bool is_state = at != rule.paths.end() && at->second.empty();
    if (at != rule.paths.end() && std::ranges::find(at->second, "output-link") != at->second.end()) continue;
    std::string bound;
    for (const RuleAttribute& condition : rule.conditions)
      if (condition.id == action.id && condition.attribute == action.attribute && !condition.negated)
        bound = FirstWord(condition.value);
    const bool removes_old = std::ranges::any_of(rule.actions, [&](const RuleAttribute& other) {
      return other.removes && other.id == action.id && other.attribute == action.attribute;
    });
    const bool is_above = action.attribute == "superstate" && is_state;
    if ((bound.empty() && !is_above) || removes_old) continue;
    std::string next = "...";
    for (const RuleAttribute& other : rule.actions)
      if (other.id == made) next = other.attribute + " ...";
    const std::string variable =
        IsVariable(bound) && !IsMadeUpVariable(bound) ? bound : "<" + action.attribute.substr(0, 1) + ">";
    slips.push_back({rule.name, action.attribute, true,
                     "rule " + rule.name + " makes another ^" + action.attribute +
                         ": a path in an action makes a new object, and does not follow the existing one",
                     "bind it in a condition, (" + action.id + " ^" + action.attribute + " " + variable +
                         "), and write (" + variable + " ^" + next + ")",
                     true});
    return;
  }
}

/// Whether a rule makes an attribute at a path from the state.
bool MakesAt(const RuleText& rule, const Path& place) {
  const PathMap paths = MadePaths(rule);
  return std::ranges::any_of(rule.actions, [&](const RuleAttribute& action) {
    const auto at = paths.find(action.id);
    if (action.removes || at == paths.end() || action.attribute != place.back()) return false;
    Path made = FromTop(at->second);
    made.push_back(action.attribute);
    return made == place;
  });
}

/// Finds operators that remove what an elaboration concludes: the element comes back, or is never removed.
void FindRemovedConclusions(const RuleText& rule, const std::vector<RuleText>& rules, std::vector<Slip>& slips) {
  if (IsElaboration(rule)) return;
  for (const RuleAttribute& removal : rule.actions) {
    const auto at = rule.paths.find(removal.id);
    if (!removal.removes || removal.attribute == "operator" || at == rule.paths.end()) continue;
    if (!IsConstantAttribute(removal.attribute)) continue;
    Path place = FromTop(at->second);
    place.push_back(removal.attribute);
    const RuleText* elaborates = nullptr;
    bool is_made_otherwise = false;
    for (const RuleText& other : rules) {
      is_made_otherwise |= MakesAnyAttribute(other);
      if (!MakesAt(other, place)) continue;
      if (!IsElaboration(other)) is_made_otherwise = true;
      elaborates = &other;
    }
    if (elaborates == nullptr || is_made_otherwise) continue;
    slips.push_back({rule.name, removal.attribute, true,
                     "rule " + rule.name + " removes ^" + removal.attribute + ", which rule " + elaborates->name +
                         " concludes: it is there as long as the conditions of that rule match",
                     "change what rule " + elaborates->name + " tests, or let an operator make ^" + removal.attribute,
                     true});
    return;
  }
}

/// A rule's tests of each object, as texts without names of variables, so that they are comparable between rules.
std::map<std::string, std::set<std::string>> TestsByObject(const RuleText& rule) {
  std::map<std::string, std::set<std::string>> tests;
  for (const RuleAttribute& condition : rule.conditions)
    if (!condition.negated)
      tests[condition.id].insert(condition.attribute + " " +
                                 (IsVariable(condition.value) ? std::string() : condition.value));
  return tests;
}

/// Whether a rule matches whenever another rule does. True only if that is certain.
bool FollowsFrom(const RuleText& rule, const RuleText& other) {
  std::set<std::string> values;
  for (const RuleAttribute& condition : rule.conditions) {
    if (condition.negated || !IsConstantAttribute(condition.attribute)) return false;
    if (condition.value.find_first_of("{(") != std::string::npos || condition.value.ends_with('+')) return false;
    // A variable that occurs twice joins two conditions.
    if (IsVariable(condition.value) && !values.insert(condition.value).second) return false;
  }
  const auto tests = TestsByObject(rule), given = TestsByObject(other);
  return !tests.empty() && std::ranges::all_of(tests, [&](const auto& object) {
    const auto at = rule.paths.find(object.first);
    return at != rule.paths.end() && std::ranges::any_of(given, [&](const auto& candidate) {
             const auto there = other.paths.find(candidate.first);
             return there != other.paths.end() && there->second == at->second &&
                    std::ranges::includes(candidate.second, object.second);
           });
  });
}

/// "-^fire ^message.about fire" when an elaboration makes ^fire from ^message.about fire: the conditions exclude each
/// other.
void FindExcluded(const RuleText& rule, const std::vector<RuleText>& rules, std::vector<Slip>& slips) {
  for (const RuleAttribute& absent : rule.conditions) {
    const auto at = rule.paths.find(absent.id);
    if (!absent.negated || absent.in_group || at == rule.paths.end() || !at->second.empty()) continue;
    if (absent.attribute == "operator" || !IsConstantAttribute(absent.attribute)) continue;
    const bool any_value = absent.value.empty() || (IsVariable(absent.value) && !IsBoundPositively(rule, absent.value));
    if (!any_value) continue;
    for (const RuleText& other : rules) {
      if (&other == &rule || !IsElaboration(other) || other.conditions.empty()) continue;
      const bool makes = std::ranges::any_of(other.actions, [&](const RuleAttribute& action) {
        const auto made_at = other.paths.find(action.id);
        return !action.removes && action.attribute == absent.attribute && made_at != other.paths.end() &&
               made_at->second.empty();
      });
      if (!makes || !FollowsFrom(other, rule)) continue;
      slips.push_back({rule.name, absent.attribute, true,
                       "rule " + rule.name + " tests -^" + absent.attribute +
                           ", but whenever its other conditions "
                           "match, rule " +
                           other.name + " concludes ^" + absent.attribute,
                       "only one of the two rules may make ^" + absent.attribute + ": leave rule " + other.name +
                           " out, or do not test -^" + absent.attribute});
      return;
    }
  }
}

/// Whether a rule may make this value at any path. An object may be a state that another attribute leads to.
bool MayMakeAnywhere(const RuleText& rule, const std::string& attribute, const std::string& value) {
  return std::ranges::any_of(rule.actions, [&](const RuleAttribute& action) {
    if (action.attribute != attribute || action.removes) return false;
    const std::string made = ConstantIn(MadeValue(action));
    return made.empty() || made == value;
  });
}

/// "^name ferry" for a state when rules make ^name ferri: a value that no rule makes.
void FindUnmadeValues(const std::vector<RuleText>& rules, const KnownWords& known, std::vector<Slip>& slips) {
  if (!known.complete || std::ranges::any_of(rules, MakesAnyAttribute)) return;
  std::set<std::string> told;
  for (const RuleText& rule : rules) {
    for (const RuleAttribute& condition : rule.conditions) {
      const auto at = rule.paths.find(condition.id);
      const std::string value = ConstantIn(condition.value);
      if (at == rule.paths.end() || condition.negated || value.empty() || !FromTop(at->second).empty()) continue;
      if (!IsConstantAttribute(condition.attribute) || condition.attribute == "operator") continue;
      // The architecture, other files of the folder and scripts may make other values.
      if (condition.attribute != "name" && IsArchitectureAttribute(condition.attribute)) continue;
      if (known.made_values.contains(condition.attribute + " " + value)) continue;
      if (condition.value.starts_with('|') && IsNumber(value)) continue;  // Reported as a number in bars.
      ConditionText asked;
      asked.path = at->second;
      asked.path.push_back(condition.attribute);
      asked.value = condition.value;
      const RuleText* other = nullptr;
      bool may_be_made = false;
      for (const RuleText& maker : rules) {
        may_be_made |= WhetherMakes(maker, rule, asked) != Makes::kNo;
        // Operators also have names.
        may_be_made |= condition.attribute != "name" && MayMakeAnywhere(maker, condition.attribute, value);
        if (other == nullptr && !OtherValueBy(maker, rule, asked).empty()) other = &maker;
      }
      if (may_be_made || other == nullptr || !told.insert(condition.attribute + " " + value).second) continue;
      const std::string made = OtherValueBy(*other, rule, asked);
      const bool is_near = !Suggest(value, {made}).empty();
      slips.push_back(
          {rule.name, value, false,
           "rule " + rule.name + " tests ^" + condition.attribute + " " + value + " of a state, which no rule makes",
           is_near ? "did you mean " + made + "? Rule " + other->name + " makes that"
                   : "rule " + other->name + " makes ^" + condition.attribute + " " + made});
    }
  }
}

/// The object whose ^name a rule binds to this variable; empty if the variable is anything else in the rule.
std::string ObjectOfName(const RuleText& rule, const std::string& variable) {
  std::string object;
  for (const RuleAttribute& condition : rule.conditions) {
    if (condition.id == variable) return {};
    if (condition.value != variable) continue;
    if (condition.negated || condition.attribute != "name" || condition.id == variable) return {};
    object = condition.id;
  }
  const bool is_object =
      std::ranges::any_of(rule.actions, [&](const RuleAttribute& action) { return action.id == variable; });
  return is_object ? std::string() : object;
}

/// Whether a rule has conditions or actions on a variable as an object.
bool IsTestedOn(const RuleText& rule, const std::string& variable) {
  const auto is_on = [&](const RuleAttribute& each) { return each.id == variable; };
  return std::ranges::any_of(rule.conditions, is_on) || std::ranges::any_of(rule.actions, is_on);
}

/// "(<o> ^thing <name>)" with the name of a thing, when other rules test ^operator.thing.color: a name is a word, which
/// has no attributes.
void FindNamesForObjects(const std::vector<RuleText>& rules, std::vector<Slip>& slips) {
  struct Given {
    const RuleText* rule;
    std::string id, value, object;  ///< `object` is empty if the value is not a name.
  };
  std::map<std::string, std::vector<Given>> given;  // By attribute: what rules give operators.
  for (const RuleText& rule : rules) {
    std::set<std::string> operators;
    for (const auto* side : {&rule.conditions, &rule.actions})
      for (const RuleAttribute& one : *side)
        if (one.attribute == "operator") operators.insert(FirstWord(one.value));
    for (const RuleAttribute& action : rule.actions) {
      if (!operators.contains(action.id) || action.removes) continue;
      const std::string value = MadeValue(action);
      given[action.attribute].push_back({&rule, action.id, value, ObjectOfName(rule, value)});
    }
  }
  if (std::ranges::any_of(given, [](const auto& each) { return !IsConstantAttribute(each.first); })) return;
  // Here some names are objects.
  for (const RuleText& rule : rules)
    for (const auto& [variable, path] : rule.paths)
      if (!path.empty() && path.back() == "name" && IsTestedOn(rule, variable)) return;
  std::set<const RuleText*> told;
  std::set<std::string> proposed;
  for (const RuleText& rule : rules) proposed.insert(rule.proposes.begin(), rule.proposes.end());
  for (const RuleText& rule : rules) {
    for (const RuleAttribute& condition : rule.conditions) {
      const auto at = rule.paths.find(condition.id);
      if (at == rule.paths.end() || condition.negated || condition.in_group) continue;
      const Path path = FromTop(at->second);
      if (path.size() != 2 || path[0] != "operator") continue;
      const auto found = given.find(path[1]);
      if (found == given.end()) continue;
      // What rules give to operators that the condition may be about. A rule that proposes none may give it to any.
      std::set<std::string> names = rule.works_on.empty() ? rule.applies : rule.works_on;
      // A substate is often called after the operator above.
      if (at->second.front() == "superstate")
        for (const RuleAttribute& name : rule.conditions)
          if (name.on_state && name.attribute == "name" && !name.negated && proposed.contains(name.value))
            names = {name.value};
      std::vector<const Given*> its;
      for (const Given& one : found->second) {
        const bool is_its =
            one.rule->proposes.empty() || one.rule->proposes.contains("") || names.empty() || names.contains("") ||
            std::ranges::any_of(one.rule->proposes, [&](const std::string& name) { return names.contains(name); });
        if (is_its) its.push_back(&one);
      }
      if (std::ranges::any_of(its, [](const Given* one) { return one->object.empty(); })) continue;
      for (const Given* each : its) {
        const Given& one = *each;
        if (!told.insert(one.rule).second) continue;
        slips.push_back({one.rule->name, path[1], true,
                         "rule " + one.rule->name + " gives its operator ^" + path[1] + " " + one.value +
                             ", a name, and rule " + rule.name + " tests ^" + condition.attribute +
                             " below it: a name has no attributes",
                         "give the object itself: (" + one.id + " ^" + path[1] + " " +
                             (IsMadeUpVariable(one.object) ? "<object>" : one.object) + ")",
                         true});
      }
    }
  }
}

}  // namespace

std::vector<Slip> FindSlipsOfLogic(const std::vector<RuleText>& rules, const KnownWords& known) {
  const std::set<Path> many = PlacesOfMany(rules);
  std::vector<Slip> slips;
  for (const RuleText& rule : rules) {
    FindBlinking(rule, slips);
    FindCounting(rule, slips);
    FindPartedOwnPaths(rule, many, slips);
    FindSingleVariables(rule, slips);
    FindEmptyParameters(rule, rules, slips);
    FindActingProposals(rule, rules, slips);
    FindPathsInActions(rule, slips);
    FindRemovedConclusions(rule, rules, slips);
    FindExcluded(rule, rules, slips);
  }
  FindNumbersInBars(rules, slips);
  FindAppliedElsewhere(rules, slips);
  FindUnmadeValues(rules, known, slips);
  FindNamesForObjects(rules, slips);
  return slips;
}

}  // namespace soarbox::explain
